"""Cells: short stretches of rubbing across the profiles, of one side of many rows.

A table of states has them as the strips of each patch, sixteen of Gauss's quadrature, whose widths are laid
end to end.  A file of an FMU has them as the stations of the outline, each from the middle to its neighbours.
"""

from dataclasses import dataclass, fields

import numpy as np

from ..kernel.layout import PATCH_LIMIT

#: Points of the table of slip shares.
POINTS = 400


@dataclass(frozen=True)
class Cells:
    """Arrays (m,) of the cells of one side.

    row : of the table; wheel_start, wheel_stop, rail_start, rail_stop : arc lengths [m].
    width : by which ``power`` and ``line_load`` are sums [m]; length : in rolling direction [m].
    power : friction power per width [W/m]; line_load [N/m]; slip : power over creep force [m/s].
    friction : of the patch; speed [m/s]; wear_number [N], patch_power [W] : of the patch.
    """

    row: np.ndarray
    wheel_start: np.ndarray
    wheel_stop: np.ndarray
    rail_start: np.ndarray
    rail_stop: np.ndarray
    width: np.ndarray
    length: np.ndarray
    power: np.ndarray
    line_load: np.ndarray
    slip: np.ndarray
    friction: np.ndarray
    speed: np.ndarray
    wear_number: np.ndarray
    patch_power: np.ndarray

    def stretches(self, part):
        """Arc lengths (start, stop), each (m,), on the ``part``, "wheel" or "rail"."""
        return getattr(self, f"{part}_start"), getattr(self, f"{part}_stop")

    def read(self):
        """What a law reads, see :data:`wrcontact.wear.laws.READ`."""
        return {
            "power_density": self.power / self.length,
            "pressure": self.line_load / self.length,
            "slip": sliding(self.power, self.line_load, self.slip, self.friction),
            "friction": self.friction,
            "speed": self.speed,
            "wear_number": self.wear_number,
            "patch_power": self.patch_power,
        }

    def rubbing(self):
        """The cells that have power."""
        there = (self.power > 0.0) & (self.length > 0.0) & (self.width > 0.0)
        return Cells(*(getattr(self, one.name)[there] for one in fields(self)))


def slip_shares():
    """Saturation of a strip and the share of its load where it slides, (POINTS,) each, both from 0 to 1.

    By simplified theory under an elliptic pressure: traction rises evenly from the leading edge, x = 1, and
    is friction times pressure behind the place where it reaches that.
    """
    x = np.linspace(-1.0, 1.0, POINTS)
    pressure = np.sqrt(np.maximum(1.0 - x * x, 0.0))
    slides = 0.5 * (x * pressure + np.arcsin(x)) + 0.25 * np.pi
    return (slides + 0.5 * (1.0 - x) * pressure) / (0.5 * np.pi), slides / (0.5 * np.pi)


def sliding(power, line_load, slip, friction):
    """Sliding velocity [m/s] where a strip slides: P' / (friction times the load that slides).

    ``slip`` is P' over the creep force, part of which sticks.  Where it is not known (0), all of the load
    counts.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        whole = power / (friction * line_load)
        saturation = np.where(slip > 0.0, np.clip(whole / slip, 0.0, 1.0), 1.0)
    share = np.interp(np.nan_to_num(saturation, nan=1.0), *slip_shares())
    found = whole / np.where(share > 0.0, share, 1.0)
    return np.where((share > 0.0) & np.isfinite(found), found, slip)


def patch_numbers(rows, prefix, k):
    """Of patch k (1 ...) of a side, each (n,): friction, T gamma [N], friction power [W], length [m] and
    largest pressure [Pa]."""

    def get(name):
        return rows.get(f"{prefix}patch[{k}].{name}")

    along, across, limit = get("tangential.x"), get("tangential.y"), get("saturation") * get("normal_force")
    given = rows.get(f"{prefix}friction")
    with np.errstate(divide="ignore", invalid="ignore"):
        used = np.hypot(along, across) / limit
    friction = np.where(np.isfinite(used) & (limit > 0.0), used, given)
    number = np.abs(along * get("creepage.x")) + np.abs(across * get("creepage.y"))
    return friction, number, get("friction_power"), get("length"), get("max_pressure")


def strip_cells(rows, prefix, wheel, rail):
    """The :class:`Cells` of a table of states, with the :class:`~wrcontact.wear.bins.Arc` of both parts."""
    speed = np.abs(rows["speed"])
    parts = [
        _strips_of_patch(strips, wheel, rail, speed, patch_numbers(rows, prefix, k + 1))
        for k, strips in enumerate(rows.strips(prefix))
    ]
    return _joined(parts)


def _strips_of_patch(strips, wheel, rail, speed, numbers):
    width = np.asarray(strips.width)
    count = width.shape[1]
    there = np.flatnonzero(width[:, 0] > 0.0)
    width, on_rail, on_wheel = (
        width[there],
        rail.at(strips.rail_place[there]),
        wheel.at(strips.wheel_place[there]),
    )
    ends = np.concatenate([np.zeros((len(there), 1)), np.cumsum(width, axis=1)], axis=1)
    # nodes of Gauss's quadrature lie symmetrically in the whole width, one in each strip
    node = (ends[:, -1:] - (on_rail[:, -1:] - on_rail[:, :1])) / 2 + on_rail - on_rail[:, :1]
    rail_ends, wheel_ends = _between(ends, node, on_rail), _between(ends, node, on_wheel)

    def each(values):
        return np.repeat(values[there], count)

    friction, number, power, _, _ = numbers
    return Cells(
        np.repeat(there, count),
        wheel_ends[:, :-1].ravel(),
        wheel_ends[:, 1:].ravel(),
        rail_ends[:, :-1].ravel(),
        rail_ends[:, 1:].ravel(),
        width.ravel(),
        2.0 * strips.half_length[there].ravel(),
        strips.power[there].ravel(),
        strips.line_load[there].ravel(),
        strips.slip[there].ravel(),
        each(friction),
        each(speed),
        each(number),
        each(power),
    )


def _between(ends, node, values):
    """Values (n, 17) at the ``ends`` of strips, linear between those (n, 16) at their nodes and beyond."""
    step = np.diff(node, axis=1)
    slope = np.diff(values, axis=1) / np.where(step > 0.0, step, 1.0)
    left = np.concatenate([[0], np.arange(node.shape[1] - 1), [node.shape[1] - 1]])  # node before an end
    by = np.concatenate([[0], np.arange(node.shape[1] - 1), [node.shape[1] - 2]])
    found = values[:, left] + slope[:, by] * (ends - node[:, left])
    return np.maximum.accumulate(found, axis=1)


def station_cells(rows, prefix, wheel, rail):
    """The :class:`Cells` of a file of an FMU, with the arcs of both parts."""
    stations = rows.stations
    place, half, pressure, power, slip = (
        rows.runs(prefix, name, stations) for name in ("station", "half_length", "pressure", "power", "slip")
    )
    on_wheel, on_rail = (
        arc.at(rows.runs(prefix, f"{part}_place", stations))
        for part, arc in (("wheel", wheel), ("rail", rail))
    )
    of = np.clip(rows.runs(prefix, "patch_of", stations).astype(int), 1, PATCH_LIMIT) - 1
    numbers = [
        np.stack(list(found), axis=1)
        for found in zip(*(patch_numbers(rows, prefix, k + 1) for k in range(PATCH_LIMIT)))
    ]
    friction, number, patch_power, longest, highest = (
        np.take_along_axis(found, of, axis=1) for found in numbers
    )
    width = np.diff(_middles(place), axis=1)
    ends = [np.sort(_middles(values), axis=1) for values in (on_wheel, on_rail)]
    length, load = 2.0 * _hats(half), 0.5 * np.pi * _hats(half * pressure)
    narrow = (length <= 0.0) & (power > 0.0)  # a patch between two stations
    length = np.where(narrow, longest, length)
    load = np.where(narrow, 0.25 * np.pi * highest * length, load)
    each = np.broadcast_to(np.abs(rows["speed"])[:, None], width.shape)
    row = np.broadcast_to(np.arange(len(width))[:, None], width.shape)
    return Cells(
        *(
            np.ravel(found)
            for found in (
                row,
                ends[0][:, :-1],
                ends[0][:, 1:],
                ends[1][:, :-1],
                ends[1][:, 1:],
                width,
                length,
                power,
                load,
                slip,
                friction,
                each,
                number,
                patch_power,
            )
        )
    )


def _middles(values):
    """The first value, the middles between neighbours, and the last value, (n, m + 1)."""
    return np.concatenate([values[:, :1], 0.5 * (values[:, 1:] + values[:, :-1]), values[:, -1:]], axis=1)


def _hats(values):
    """Means (n, m) around each station of what is linear in between, as ``power`` is one."""
    before = np.concatenate([values[:, 1:2], values[:, :-1]], axis=1)
    after = np.concatenate([values[:, 1:], values[:, -2:-1]], axis=1)
    inner = (before + 4.0 * values + after) / 6.0
    inner[:, 0] = (2.0 * values[:, 0] + values[:, 1]) / 3.0
    inner[:, -1] = (2.0 * values[:, -1] + values[:, -2]) / 3.0
    return inner


def _joined(parts):
    return Cells(*(np.concatenate([getattr(part, one.name) for part in parts]) for one in fields(Cells)))
