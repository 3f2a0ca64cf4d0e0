"""Rails that change along the track as those of a wheelset: where they lie, and what cannot be had with them yet."""

import os
from dataclasses import dataclass

import numpy as np

from ..interface.parameters import LEFT, PARAMETERS, RAIL_SPRINGS, on_the_left
from ..interface.section_places import ROLLER, SECTION_PLACES
from ..kernel import layout
from ..kernel.binding.setup import prepare_sides
from ..methods.own import functions_in
from ..profiles.catalogue import find_profiles, standard_profile
from ..profiles.changing import is_sections, round_wheel, shown
from ..profiles.options import ProfileFile
from ..profiles.placement import place_rail
from .kernel_table import with_changing_rails, with_deviation
from .rail import RailSections
from .roller import roller_surface
from .surface import Surface
from .wheel import WheelSections

#: What may be chosen beside a rail that changes.
PERMITTED = {
    "contact_mode": ("rigid", "elastic", "compliant"),
    "normal_model": ("hertz", "analyn", "analyn_strip", "auto"),
    "tangential_model": ("none", "strips", "fastsim", "fastrip", "polach"),
    "longitudinal_curvature": ("effective",),
    "lateral_curvature": ("adaptive",),
}
#: What has to be zero, or False.
WITHOUT = tuple(side + name for side in ("", LEFT) for name in RAIL_SPRINGS)
#: The constant rail in whose place the kernel puts one that changes, and how it lies; neither changes a result. The wheel stands
#: for one that is not round while profiles are found.
CARRIER, CARRIED_WHEEL = "UIC60", "S1002"
CARRIED = {"rail_inclination": 0.0, "left_rail_inclination": None, "gauge_depth": 0.014}
#: What places a rail on its side.
ALIKE = ("rail_inclination", "nominal_radius", *SECTION_PLACES)
#: Points of a section among which its highest place is sought, and steps of Newton's method and of halving.
POINTS, STEPS, HALVINGS = 4001, 8, 60


def found_sections(source, argument, kind=RailSections):
    """The sections, a ``kind`` of them, that the argument ``source`` of a system is, or None if it is a profile.

    Raises
    ------
    ValueError
        in one sentence, if the sections cannot be used.
    """
    if isinstance(source, kind):
        return source
    if not is_sections(source) or hasattr(source, "kind"):
        return None
    if isinstance(source, ProfileFile):
        raise ValueError(
            f"{argument} is a ProfileFile of {os.fspath(source.path)!r}; permitted with sections are their path, or "
            f"{kind.__name__}"
        )
    if not os.path.isfile(source):
        raise ValueError(
            f"{argument} is {os.fspath(source)!r}, and there is no such file; permitted is the path of a file of sections"
        )
    return kind.from_file(source)


def found_rails(parameters):
    """Those of the right and of the left side, each a :class:`RailSections` or None, by a system's ``parameters``."""
    right = found_sections(parameters["rail"], "rail")
    left = parameters["left_rail"]
    return right, right if left is None else found_sections(left, "left_rail")


def found_wheels(parameters):
    """The wheel of the right and of the left side, each :class:`WheelSections` or None, by a system's ``parameters``."""
    right = found_sections(parameters["wheel"], "wheel", WheelSections)
    left = parameters["left_wheel"]
    return right, right if left is None else found_sections(left, "left_wheel", WheelSections)


def find_all_profiles(parameters):
    """As :func:`wrcontact.profiles.catalogue.find_profiles`, with :class:`RailSections` for rails that change, and
    :class:`WheelSections` for wheels that are not round."""
    wheels, rails = found_wheels(parameters), found_rails(parameters)
    constant = {
        side + kind: carrier
        for kind, carrier, found in (("wheel", CARRIED_WHEEL, wheels), ("rail", CARRIER, rails))
        for side, one in zip(("", LEFT), found)
        if one is not None and parameters[side + kind] is not None
    }
    wheel, rail, left_wheel, left_rail = find_profiles(parameters | constant)
    return wheels[0] or wheel, rails[0] or rail, wheels[1] or left_wheel, rails[1] or left_rail


def check_rails(profiles, parameters):
    """ValueError, in one sentence, where ``parameters`` of a system do not go with its rails among the ``profiles``: wheel and
    rail of the right side, wheel and rail of the left side."""
    changing = [isinstance(rail, RailSections) for rail in profiles[1::2]]
    beside = "a rail that changes along the track"
    if not any(changing):
        beside = "a wheel that is not round" if any(map(is_sections, profiles[::2])) else "a roller"
    for name in functions_in(parameters):
        raise ValueError(f"{name} is a function; permitted with {beside} is a name")
    for name, permitted in PERMITTED.items():
        if parameters[name] not in permitted:
            verb = "are" if len(permitted) > 1 else "is"
            raise ValueError(
                f"{name} is {parameters[name]!r}; permitted with {beside} {verb} "
                f"{', '.join(map(repr, permitted))}"
            )
    if parameters["contact_mode"] == "elastic" and any(changing) and _has_roller(parameters):
        raise ValueError(
            "contact_mode is 'elastic' on a roller beside a rail that changes along the track; permitted are 'rigid', 'compliant'"
        )
    if parameters["independent_wheels"] and all(map(is_sections, profiles[::2])):
        raise ValueError(
            "independent_wheels is True; permitted with two wheels that are not round is False, since both turn by one "
            "wheel_rotation"
        )
    for name in WITHOUT:
        if parameters[name]:
            raise ValueError(
                f"{name} is {shown(name, parameters)}; permitted with {beside} is "
                f"{PARAMETERS[name.removeprefix(LEFT)].default!r}"
            )
    for side, one in zip(("", LEFT), changing):
        if one:
            _check_placed(side, parameters)


def _has_roller(parameters):
    """Whether a side runs on a roller."""
    return bool(parameters[ROLLER] or parameters[LEFT + ROLLER])


def _check_placed(side, parameters):
    """Refuse an inclination, which sections have already, and a height of the origin without its lateral place."""
    inclination = parameters[side + "rail_inclination"]
    if inclination not in (None, 0.0, PARAMETERS["rail_inclination"].default):
        raise ValueError(
            f"{side}rail_inclination is {inclination!r}; permitted with a {side}rail that changes along the track is 0, "
            "since its sections are as they lie in the track"
        )
    own = on_the_left(parameters) if side else parameters
    if own["rail_origin_z"] and not own["rail_origin_y"]:
        raise ValueError(
            f"{side}rail_origin_z is {own['rail_origin_z']!r} m without {side}rail_origin_y; permitted is 0, or a "
            f"{side}rail_origin_y beside it"
        )


@dataclass(frozen=True)
class PlacedSections:
    """A rail that changes, as it lies in the track: as one of a right side.

    Attributes
    ----------
    surface : its :class:`~wrcontact.sections.surface.Surface`, with positions and heights of the track.
    lateral : track coordinate of its origin [m].
    """

    surface: Surface
    lateral: float

    def height(self, u, y):
        """Height z [m], down, at track positions ``u`` and track coordinates ``y`` [m] as of a right side; NaN beside the
        rail."""
        u, y = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(y, dtype=float) - self.lateral)
        first, last = self.surface.edges(u)
        return np.where((y >= first) & (y <= last), self.surface.jet(u, y)[0], np.nan)


def place_sections(rail, parameters):
    """A :class:`PlacedSections` of ``rail``, a :class:`RailSections`, or a Profile that is the same all along the track, by the
    ``parameters`` of its side."""
    given = {name: parameters[name] for name in ("gauge", "gauge_depth")}
    if not isinstance(rail, RailSections):
        placed = place_rail(rail, inclination=parameters["rail_inclination"], **given)
        if parameters[ROLLER]:
            surface = roller_surface(placed.profile, parameters[ROLLER], parameters["nominal_radius"])
            return PlacedSections(surface, placed.y_track)
        return PlacedSections(
            RailSections([0.0, 1.0], [placed.profile] * 2, name=rail.name).surface, placed.y_track
        )
    lateral, down = parameters["rail_origin_y"], parameters["rail_origin_z"]
    if not lateral:
        lateral, down = _by_gauge(rail, **given)
    return PlacedSections(
        rail.surface.placed(parameters["rail_position"], parameters["rail_reversed"], down), lateral
    )


def _by_gauge(rail, gauge, gauge_depth):
    """Track coordinate and height [m] of the origin of ``rail``, so that the section at its position 0 has its highest place
    at the height 0 and its inner face at the gauge."""
    first, last = (float(edge) for edge in rail.edges(0.0))
    y = np.linspace(first, last, POINTS)
    jet = rail.surface.jet(0.0, y)
    top = int(np.argmin(jet[0]))
    place = y[top]
    for _ in range(STEPS):
        _, _, slope, _, _, bend, _, _ = rail.surface.jet(0.0, place)
        if not bend > 0.0:
            break
        place = float(np.clip(place - slope / bend, y[max(top - 1, 0)], y[min(top + 1, POINTS - 1)]))
    highest = min(float(rail.surface.jet(0.0, place)[0]), float(jet[0, top]))
    deep = np.flatnonzero(jet[0, : top + 1] >= highest + gauge_depth)
    if not len(deep):
        raise ValueError(
            f"gauge_depth is {gauge_depth:.6g} m, but the inner side of the section of {rail.name} at position 0 ends "
            f"{jet[0, 0] - highest:.6g} m below its highest place; permitted are smaller depths, or a rail_origin_y"
        )
    outside, inside = y[deep[-1]], y[deep[-1] + 1]
    for _ in range(HALVINGS):
        middle = 0.5 * (outside + inside)
        if rail.surface.jet(0.0, middle)[0] >= highest + gauge_depth:
            outside = middle
        else:
            inside = middle
    return 0.5 * gauge - inside, -highest


def place_rails(profiles, parameters):
    """A :class:`PlacedSections` of the left and of the right rail, of which one changes or both.

    ``profiles`` are wheel and rail of the right side, wheel and rail of the left side.
    """
    left = on_the_left(parameters)
    right = place_sections(profiles[1], parameters)
    if profiles[3] is profiles[1] and all(left[name] == parameters[name] for name in ALIKE):
        return right, right
    return place_sections(profiles[3], left), right


def prepare_changing(profiles, parameters, methods):
    """Settings and tables (n,) of a wheelset on rails of which one changes or both, and its placed rails, those of
    :func:`place_rails`; ValueError, in one sentence, where something does not go with them."""
    check_rails(profiles, parameters)
    placed, rail = place_rails(profiles, parameters), standard_profile(CARRIER)
    wheels = profiles[2], profiles[0]
    round_left, round_right = map(round_wheel, wheels)
    tables = prepare_sides(
        (round_right, rail), (round_left, rail), parameters=parameters | CARRIED, methods=methods
    )
    tables = with_changing_rails(tables, [(one.surface, one.lateral) for one in placed])
    for pair, own in zip(layout.Tables.at(tables).pairs, (on_the_left(parameters), parameters)):
        pair.roller = own[ROLLER]
    for index, (wheel, own) in enumerate(zip(wheels, (on_the_left(parameters), parameters))):
        if isinstance(wheel, WheelSections):
            tables = with_deviation(tables, index, wheel.surface(own["nominal_radius"]))
    return tables, placed
