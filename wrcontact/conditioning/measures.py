"""The numbers that a check reports: each with its unit, its digits, its words and its reader, for the command, for
pictures and for fleets."""

import math
from dataclasses import dataclass
from functools import partial
from operator import attrgetter

import numpy as np

from ..conventions import SIDES
from ..interface.index import KINDS
from ..interface.units import UNITS, by_name
from ..profiles.remarks import Grave
from ..results.words import fixed, unit_name
from .conformal import NEAR
from .conicity import AMPLITUDES
from .curves import merged_jumps
from .remarks import RUNNING

#: Units that are shown instead of the usual ones: factor from SI.
FACTORS = {"um": 1e6, "m": 1.0, "mm/mm": 1.0, "mrad/mm": 1.0}


@dataclass(frozen=True)
class Measure:
    """One number.

    Attributes
    ----------
    name : where results have it, in SI.
    unit : in SI, "1" without one.
    heading : words above its column or before its row.
    digits : after the point, in the unit that is shown.
    meaning : words for the user, where a page lists it.
    read : function of what has it; None for its attribute ``name``.
    instead : unit that is shown instead of the usual one, a key of FACTORS.
    significant : digits of a smaller value.
    """

    name: str
    unit: str
    heading: str
    digits: int
    meaning: str = ""
    read: object = None
    instead: str = ""
    significant: int = 1

    def __post_init__(self):
        if self.read is None:
            object.__setattr__(self, "read", attrgetter(self.name))

    @property
    def shown_unit(self):
        """The unit that is shown; "" for plain numbers."""
        return self.instead or unit_name(self.unit)

    @property
    def factor(self):
        """From SI to the unit that is shown."""
        return FACTORS[self.instead] if self.instead else UNITS[self.unit].display_factor

    def shown(self, *owners):
        """The number or the array of an owner in the unit that is shown."""
        return self.factor * self.read(*owners)

    def text(self, *owners):
        """The number of an owner as text, see :func:`~wrcontact.results.words.fixed`."""
        return self.said(self.read(*owners))

    def said(self, value):
        """A ``value`` in SI as text in the unit that is shown."""
        return fixed(float(value) * self.factor, self.digits, self.significant)


def _mm(length):
    return f"{length * 1e3:g} mm"


def _on_side(name):
    return lambda curves, side: getattr(getattr(curves, side), name)


def _of_both(name):
    return lambda curves, side: getattr(curves, name)


#: Of a contact over the lateral shift: read of :class:`~wrcontact.conditioning.Curves` and a side.
MOVES = by_name(
    Measure("roll_rate", "rad/m", "roll", 3, read=_of_both("roll_rate"), instead="mrad/mm"),
    Measure(
        "wheel_rate",
        "1",
        "on wheel",
        2,
        read=_on_side("wheel_rate"),
        instead="mm/mm",
    ),
    Measure("rail_rate", "1", "on rail", 2, read=_on_side("rail_rate"), instead="mm/mm"),
    Measure("jump_distance", "m", "next jump", 2, read=_of_both("jump_distance")),
    Measure("contact_angle", "rad", "angle", 1, read=_on_side("contact_angle")),
    Measure("curvature", "1/m", "curvature", 1, read=_on_side("curvature")),
    Measure("near_width", "m", "close", 1, read=_on_side("near_width")),
)
#: Of a :class:`~wrcontact.conditioning.ProfileQuality`.
QUALITIES = by_name(
    Measure("start", "m", "profile from", 2),
    Measure("stop", "m", "to", 2),
    Measure(
        "visited_from",
        "m",
        f"contacts within {_mm(RUNNING)} of shift from",
        2,
        read=lambda quality: quality.visited[0],
    ),
    Measure("visited_to", "m", "to", 2, read=lambda quality: quality.visited[1]),
    Measure("pieces", "1", "pieces", 0),
    Measure("kinks", "1", "kinks there", 0, read=lambda quality: len(quality.kinks)),
    Measure("curvature_step", "1/m", "largest curvature step there", 1),
    Measure("roughness", "1/m", "roughness of the curvature there", 2),
)
#: Of its :class:`~wrcontact.profiles.remarks.Reading`.
READINGS = by_name(
    Measure("points", "1", "points", 0),
    Measure("spacing", "m", "spacing, median", 3),
    Measure("widest", "m", "spacing, largest", 3),
    Measure("noise", "m", "noise", 2, instead="um"),
    Measure("smoothing", "m", "smoothing", 2, instead="um"),
)
#: Of a :class:`~wrcontact.conditioning.Jump`.
JUMPS = by_name(
    Measure("lateral_shift", "m", "shift", 4),
    Measure("before", "m", "on wheel\nbefore", 2),
    Measure("after", "m", "after", 2),
    Measure("rail_before", "m", "on rail\nbefore", 2),
    Measure("rail_after", "m", "after", 2),
)
#: Of a :class:`~wrcontact.conditioning.ConformalZone`.
ZONES = by_name(
    Measure("start", "m", "from", 2),
    Measure("stop", "m", "to", 2),
    Measure("y_low", "m", "on wheel\nfrom", 1),
    Measure("y_high", "m", "to", 1),
    Measure("width", "m", f"within\n{_mm(NEAR)} over", 1),
    Measure("turn", "rad", "turns by", 1),
)
#: Of a :class:`~wrcontact.conditioning.Conicity`, arrays over the amplitudes.
CONICITIES = by_name(
    Measure("amplitude", "m", "amplitude", 0, significant=3),
    Measure("level", "1", "without\nroll", 3, significant=3),
    Measure("rolled", "1", "with\nroll", 3, significant=3),
    Measure("regressed", "1", "by\nregression", 3, significant=3),
    Measure("wavelength", "m", "wavelength", 1, instead="m", significant=3),
)


# --- of a pair --------------------------------------------------------------------------------------------


def _jump_count(report):
    counts = [
        sum(abs(jump.lateral_shift) <= RUNNING for jump in merged_jumps(report.jumps, side)) for side in SIDES
    ]
    return max(counts)


def _wheel_rate(report):
    near = np.abs(report.curves.lateral_shift) <= RUNNING
    moves = np.concatenate([getattr(report.curves, side).wheel_rate[near] for side in SIDES])
    return float(np.max(np.abs(moves[np.isfinite(moves)]), initial=-math.inf))


def _zones(report):
    """The conformal zones within RUNNING."""
    return [zone for zone in report.conformal if zone.start <= RUNNING and zone.stop >= -RUNNING]


def _conformal_count(report):
    return max(sum(zone.side == side for zone in _zones(report)) for side in SIDES)


def _largest(name, report):
    """Of the zones; 0 without any."""
    return max((getattr(zone, name) for zone in _zones(report)), default=0.0)


def _of_profile(kind, name, report):
    """A measure of a profile of the right side, or of its points; NaN without points."""
    quality = getattr(report, kind)
    if name in QUALITIES:
        return QUALITIES[name].read(quality)
    return READINGS[name].read(quality.reading) if quality.reading else math.nan


def _file_inclination(report):
    return report.rail.reading.inclination if report.rail.reading else 0.0


def _grave_remarks(report):
    return sum(isinstance(remark, Grave) for remark in report.remarks)


def _of_conicity(name, at):
    return lambda report: float(getattr(report.conicity, name)[at])


WITHIN = f"within {_mm(RUNNING)} of lateral shift"
#: Of a :class:`~wrcontact.conditioning.Conditioning`.
PAIR = by_name(
    Measure(
        "usable_from",
        "m",
        "contact from",
        2,
        "first lateral shift with contact around the centred position",
        lambda report: report.usable_shifts[0],
    ),
    Measure(
        "usable_to",
        "m",
        "contact up to",
        2,
        "last lateral shift with contact around the centred position",
        lambda report: report.usable_shifts[1],
    ),
    Measure(
        "flange_shift", "m", "flange from", 2, "lateral shift from which a contact is steeper than 45 deg"
    ),
    Measure("nearest_jump", "m", "nearest jump", 2, "distance of the nearest jump from the centred position"),
    Measure(
        "jump_count", "1", "jumps", 0, f"jumps of a contact {WITHIN}, of the side with more", _jump_count
    ),
    Measure(
        "wheel_rate",
        "1",
        "fastest on the wheel",
        1,
        f"largest rate of a contact on its wheel {WITHIN}",
        _wheel_rate,
        "mm/mm",
    ),
    *(
        Measure(
            f"conicity_{round(value * 1e3)}mm",
            "1",
            f"conicity at {_mm(value)}",
            3,
            f"equivalent conicity at {_mm(value)} amplitude, without roll",
            _of_conicity("level", at),
        )
        for at, value in enumerate(AMPLITUDES)
    ),
    Measure(
        "conicity_3mm_rolled",
        "1",
        "conicity at 3 mm, with roll",
        3,
        "equivalent conicity at 3 mm amplitude, with roll",
        _of_conicity("rolled", 2),
    ),
    Measure(
        "conicity_3mm_regressed",
        "1",
        "conicity at 3 mm, by regression",
        3,
        "equivalent conicity at 3 mm amplitude by linear regression",
        _of_conicity("regressed", 2),
    ),
    Measure(
        "nonlinearity",
        "1/m",
        "nonlinearity",
        0,
        "change of the conicity from 2 to 4 mm amplitude",
        attrgetter("conicity.nonlinearity"),
    ),
    Measure(
        "conformal_count",
        "1",
        "conformal zones",
        0,
        f"conformal zones {WITHIN}, of the side with more",
        _conformal_count,
    ),
    Measure(
        "conformal_width",
        "m",
        "close over",
        1,
        "longest close stretch in these zones",
        partial(_largest, "width"),
    ),
    Measure(
        "conformal_turn",
        "rad",
        "turns by",
        0,
        "largest change of direction in these zones",
        partial(_largest, "turn"),
    ),
    *(
        Measure(
            f"{kind}_noise",
            "m",
            f"noise of the {kind}",
            1,
            f"noise of the points of the {kind}",
            partial(_of_profile, kind, "noise"),
            "um",
        )
        for kind in KINDS
    ),
    *(
        Measure(
            f"{kind}_roughness",
            "1/m",
            f"roughness of the {kind}",
            2,
            f"roughness of the {kind}'s curvature in contact",
            partial(_of_profile, kind, "roughness"),
        )
        for kind in KINDS
    ),
    Measure(
        "rail_file_inclination",
        "1",
        "inclined in the file",
        4,
        "inclination from which the rail in the file was turned upright",
        _file_inclination,
    ),
    Measure(
        "grave_remarks",
        "1",
        "grave remarks",
        0,
        "remarks, the first ones, on what makes all results wrong if it is so",
        _grave_remarks,
    ),
)
