"""Wear of wheels and rails from results: what a law takes off per metre run, over the profiles.

Per strip and pose D = rate length / (density speed) is the depth that one passage takes [m].  A point of a
wheel comes by once a turn:

    wheel: depth per metre run = 1 / (2 pi r) mean of D,      rail: depth per passage = mean of D

with the distances as weights, and the nominal radius r.
"""

from __future__ import annotations

import math
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..interface.index import KINDS
from ..methods.numbers import check_choice
from ..profiles.changing import refuse_changing
from ..profiles.profile import Profile
from ..state import WheelsetState
from ..system import ContactSystem
from ..wheel import WheelContact, WheelState
from .bins import Arc, deposit
from .cells import station_cells, strip_cells
from .law import STEEL
from .laws import law_of
from .rows import BY_TIME, distances, prefixes_of, rows_of_file, rows_of_table, whole_of
from .update import DEEPEST, smoothed, worn_profile

#: What wears of a wheelset, and of one wheel.
PARTS, PARTS_OF_ONE = (
    tuple(f"{prefix}{kind}" for kind in KINDS for prefix in prefixes_of(side)) for side in (None, "right")
)
#: Rows that are worked on at once.
CHUNK = 4096
#: Parts of a table that the bootstrap draws: single rows, or stretches of a long one.
BLOCKS = 200


class Addition:
    """Sums of one table: ``sums[part]`` (blocks, bins) of distance times volume per passage, ``distance``
    (blocks,), and ``regimes[part]`` (regimes,)."""

    def __init__(self, arcs, blocks, regimes):
        self.sums = {part: np.zeros((blocks, len(arc.edges) - 1)) for part, arc in arcs.items()}
        self.distance = np.zeros(blocks)
        self.regimes = {part: np.zeros(regimes) for part in arcs}


class Wear:
    """What a ``law`` takes off the profiles of a ``system``, per metre run of a wheel and per passage over a
    rail.

    Parameters
    ----------
    system : :class:`~wrcontact.ContactSystem` whose profiles wear, or a :class:`~wrcontact.WheelContact`,
        whose parts are "wheel" and "rail" instead of "right.wheel" and so on.
    law : an object of :mod:`wrcontact.wear.laws`, or a function of some of its arrays by their names.
    mirrored : both wheels wear alike, and both rails: the vehicle turns and runs both ways.  They then have
        the mean of left and right; otherwise each its own.
    bin_width : of the bins of arc length [m].

    Attributes
    ----------
    distance : that was added so far [m]; rows, left_out : how many rows were, and how many were not.
    side : that of the wheel of a WheelContact; None of a wheelset.

    >>> import wrcontact
    >>> system = wrcontact.ContactSystem(tangential_model="strips", wear_outputs=True)
    >>> wear = wrcontact.Wear(system, wrcontact.Usfd())
    >>> wear.add(system.evaluate_many([-3e-3, 0.0, 3e-3], speed=20.0), distance=[1.0, 2.0, 1.0])
    >>> places, depth = wear.depth("right.wheel")
    >>> bool(5e-12 < depth.max() < 5e-10), wear.shares("right.wheel")["mild"] > 0.9
    (True, True)
    """

    def __init__(
        self,
        system: ContactSystem | WheelContact,
        law: Any,
        *,
        mirrored: bool = False,
        bin_width: float = 0.25e-3,
    ) -> None:
        system, self.side = whole_of(system)
        refuse_changing(system, "wear")
        if not 0.01e-3 <= bin_width <= 2e-3:
            raise ValueError(f"bin_width is {bin_width!r} m; permitted is 1e-05 ... 0.002 m")
        if mirrored and self.side:
            raise ValueError("mirrored is True with one wheel; permitted is that with a wheelset")
        if mirrored and not system.equal_sides:
            raise ValueError(
                "mirrored is True and the left side differs from the right one; permitted is that "
                "for equal sides"
            )
        self.system, self.law, self.mirrored = system, law_of(law), mirrored
        depth = system.parameters["gauge_depth"]
        right = {
            "wheel": Arc(system.wheel, 0.0, bin_width),
            "rail": Arc(system.rail, system.parameters["rail_inclination"], bin_width, depth),
        }
        left = (
            right
            if system.equal_sides
            else {
                "wheel": Arc(system.left_wheel, 0.0, bin_width),
                "rail": Arc(
                    system.left_rail, system.side_parameters("left")["rail_inclination"], bin_width, depth
                ),
            }
        )
        self.prefixes = prefixes_of(self.side)
        self.arcs = {
            name: (left if name.startswith("left.") else right)[name.rpartition(".")[2]]
            for name in (PARTS if self.side is None else PARTS_OF_ONE)
        }
        self.additions, self.rows, self.left_out = [], 0, 0

    # --- what has run ---------------------------------------------------------------------------------------

    def add(
        self,
        table: WheelsetState[Any, Any, Any] | WheelState[Any, Any, Any],
        distance: ArrayLike | None = None,
    ) -> None:
        """Add a table of states with creep forces and outputs of wear.

        Parameters
        ----------
        table : of evaluate_many; rows with a status other than 0 are left out and counted.
        distance : that each row stands for [m], (n,) or one number; None is 1 m each.

        Raises
        ------
        ValueError
            in one sentence, without creep forces or speed, or if more than a tenth of the rows is left out.
        """
        rows = rows_of_table(table, self.side)
        self._add(rows, distances(rows, distance, None))

    def add_fmu(
        self, results: Any, distance_column: str = BY_TIME, distance: ArrayLike | None = None
    ) -> None:
        """Add the results of an FMU with the parameters ``tangential_model`` and ``wear_outputs``; of one
        wheel those of its FMU, ``wrcontact build --native --single-wheel``.

        Parameters
        ----------
        results : path of a .csv or .parquet file with the FMU's names, what fmpy returns, a
            pandas.DataFrame, or columns by name.
        distance_column : "time*speed" integrates the speed; or the column with the distance run [m].
        distance : instead, what each row stands for [m].
        """
        rows = rows_of_file(results, self.side)
        self._add(rows, distances(rows, distance, None if distance is not None else distance_column))

    def _add(self, rows, distance):
        good = np.flatnonzero(rows.valid())
        blocks = min(BLOCKS, len(good))
        added = Addition(self.arcs, blocks, len(self.law.regimes))
        block = np.arange(len(good)) * blocks // len(good)
        added.distance = np.bincount(block, distance[good], blocks)
        for first in range(0, len(good), CHUNK):
            some = slice(first, first + CHUNK)
            self._rub(rows.picked(good[some]), distance[good[some]], block[some], added)
        if not np.sum(added.distance) > 0.0:
            raise ValueError(
                f"distance is 0 m over the valid rows of {rows.name}; permitted is more than 0 m"
            )
        self.additions.append(added)
        self.rows, self.left_out = self.rows + len(good), self.left_out + len(rows) - len(good)

    def _rub(self, rows, distance, block, added):
        """Add what some rows take off to the sums."""
        for prefix in self.prefixes:
            arcs = [self.arcs[f"{prefix}{part}"] for part in KINDS]
            cells = (station_cells if rows.table is None else strip_cells)(rows, prefix, *arcs).rubbing()
            if not len(cells.row):
                continue
            read = cells.read()
            rate = np.broadcast_to(np.asarray(self.law.rate(**read), dtype=float), cells.row.shape)
            if not np.all(rate >= 0.0):
                raise ValueError(
                    f"the law {self.law!r} returns {float(np.nanmin(rate)):g} or NaN; permitted "
                    "are rates >= 0 kg/(m2 s)"
                )
            amount = rate * cells.length / (STEEL * cells.speed) * cells.width * distance[cells.row]
            regime = self.law.regime(**read)
            for part, arc in zip(KINDS, arcs):
                name = f"{prefix}{part}"
                added.sums[name] += deposit(
                    arc, *cells.stretches(part), amount, block[cells.row], len(added.distance)
                )
                added.regimes[name] += np.bincount(regime, amount, len(self.law.regimes))

    # --- what it takes off ----------------------------------------------------------------------------------

    @property
    def distance(self) -> float:
        """Distance that was added so far [m]."""
        return float(sum(np.sum(added.distance) for added in self.additions))

    def arc(self, part: str) -> Arc:
        """The :class:`~wrcontact.wear.bins.Arc` of a part: its places, bins and profile."""
        return self.arcs[self._part(part)]

    def depth(self, part: str) -> tuple[NDArray[Any], NDArray[Any]]:
        """Places (bins,) [m], and the depth there: per metre run of a wheel [1], per passage over a rail [m].

        Parameters
        ----------
        part : "left.wheel", "right.wheel", "left.rail" or "right.rail"; of one wheel "wheel" or "rail".
            Places are those of contacts: of a rail in the frame of the inclined head.
        """
        name = self._part(part)
        total = sum(np.sum(self._sums(added, name), axis=0) for added in self.additions)
        return self.arcs[name].places, total / (self.distance * self._divisor(name))

    def mass(self, part: str) -> float:
        """Mass per metre run of a wheel [kg/m], or per passage over a metre of rail [kg/m]."""
        name = self._part(part)
        around = 2.0 * math.pi * self._radius(name) if name.endswith("wheel") else 1.0
        return float(np.sum(self.depth(part)[1]) * self.arcs[name].width * STEEL * around)

    def shares(self, part: str) -> dict[str, float]:
        """Share of the worn mass in each regime of the law, by its name."""
        name = self._part(part)
        names = [prefix + name.partition(".")[2] for prefix in self.prefixes] if self.mirrored else [name]
        total = sum(added.regimes[one] for added in self.additions for one in names)
        return dict(zip(self.law.regimes, (total / (np.sum(total) or 1.0)).tolist()))

    def error(self, part: str, *, smoothing: float = 0.0, samples: int = 200, seed: int = 0) -> NDArray[Any]:
        """Standard error (bins,) of the depth, in its unit, by the bootstrap over poses.

        Each table that was added is drawn anew from its rows, or from 200 stretches of a longer one, since
        neighbours in time are alike.  ``smoothing`` [m] as for :meth:`worn`.
        """
        name = self._part(part)
        draw, arc, found = np.random.default_rng(seed), self.arcs[name], []
        for _ in range(samples):
            total = np.zeros(len(arc.edges) - 1)
            for added in self.additions:
                count = np.bincount(
                    draw.integers(len(added.distance), size=len(added.distance)),
                    minlength=len(added.distance),
                )
                length = count @ added.distance
                if length > 0.0:
                    total += count @ self._sums(added, name) * (np.sum(added.distance) / length)
            found.append(smoothed(total, arc, smoothing))
        return np.std(found, axis=0, ddof=1) / (self.distance * self._divisor(name))

    def worn(self, part: str, distance: float, smoothing: float = 1e-3) -> Profile:
        """The worn :class:`~wrcontact.Profile` of a part.

        Parameters
        ----------
        distance : that a wheel has run [m]; of a rail the number of passages.
        smoothing : standard deviation of the bell curve over arc length by which the depth is smoothed [m],
            0 ... 5e-3; its integral stays.  Without any, a worn place draws the load to its edges, and the
            loop of wear is unstable.

        Raises
        ------
        ValueError
            in one sentence, for example if the depth is more than 2 mm in one step.
        """
        name = self._part(part)
        arc = self.arcs[name]
        if not (isinstance(distance, Real) and np.isfinite(distance) and distance > 0.0):
            raise ValueError(
                f"distance is {distance!r}; permitted is distance > 0, in m of a wheel and in "
                "passages of a rail"
            )
        depth = self.smooth_depth(part, smoothing) * distance
        if np.max(depth) > DEEPEST:
            raise ValueError(
                f"distance is {distance:g}, which takes {1e3 * np.max(depth):.3g} mm in one step; "
                f"permitted are {1e3 * DEEPEST:g} mm, in more and shorter steps"
            )
        kind = "m" if name.endswith("wheel") else "passages"
        said = (
            f"{arc.profile.name} worn by up to {1e3 * np.max(depth):.4g} mm over {distance:g} {kind}, "
            f"law {self.law!r}, smoothing {1e3 * smoothing:g} mm",
        )
        return worn_profile(arc, depth, said)

    def smooth_depth(self, part: str, smoothing: float) -> NDArray[Any]:
        """The smoothed depth (bins,) in the unit of :meth:`depth`."""
        return smoothed(self.depth(part)[1], self.arcs[self._part(part)], smoothing)

    def _part(self, part):
        if self.mirrored and part in KINDS:
            part = f"right.{part}"
        check_choice("part", part, tuple(self.arcs))
        if not self.additions:
            raise ValueError("nothing has run yet; permitted is that after add or add_fmu")
        return part

    def _sums(self, added, name):
        """Sums (blocks, bins) of a part in one table."""
        if not self.mirrored:
            return added.sums[name]
        other = name.partition(".")[2]
        return 0.5 * (added.sums[f"left.{other}"] + added.sums[f"right.{other}"])

    def _radius(self, name):
        side = "left" if name.startswith("left.") else "right"
        return self.system.side_parameters(side)["nominal_radius"]

    def _divisor(self, name):
        """From volumes per passage in a bin to depths."""
        turn = 2.0 * math.pi * self._radius(name) if name.endswith("wheel") else 1.0
        return self.arcs[name].width * turn
