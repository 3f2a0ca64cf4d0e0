"""Rails whose section changes along the track, as far as others have to know of them (wrcontact/sections has them)."""

import os

from ..interface.parameters import LEFT, PARAMETERS
from ..interface.section_places import ROLLER, SECTION_PLACES
from ..methods.numbers import unit_behind
from .options import ProfileFile

KINDS, ENDINGS = ("rail sections", "wheel sections"), (".slcs", ".slcw", ".toml")


def is_sections(source):
    """Whether what is given as a profile is :class:`~wrcontact.RailSections`, :class:`~wrcontact.WheelSections`, or the path of a
    file of sections."""
    if isinstance(source, ProfileFile):
        source = source.path
    if isinstance(source, (str, os.PathLike)):
        return os.path.splitext(os.fspath(source))[1].lower() in ENDINGS
    return getattr(source, "kind", None) in KINDS


def named(source):
    """How messages call sections: as they are given."""
    return (
        f"{type(source).__name__} {source.name!r}"
        if hasattr(source, "kind")
        else repr(str(getattr(source, "path", source)))
    )


def where_it_changes(source):
    """How messages say along what sections change."""
    path = os.fspath(getattr(source, "path", "" if hasattr(source, "kind") else source))
    round_it = getattr(source, "kind", None) == KINDS[1] or path.lower().endswith(".slcw")
    return "around the wheel" if round_it else "along the track"


def round_wheel(wheel):
    """The round wheel of :class:`~wrcontact.WheelSections`; a Profile is one."""
    return wheel.profile if is_sections(wheel) else wheel


def has_changing(parameters):
    """Whether a rail of a system with these ``parameters`` changes along the track or is a roller, or a wheel is not round."""
    return any(
        is_sections(parameters[side + "rail"])
        or is_sections(parameters[side + "wheel"])
        or parameters[side + ROLLER]
        for side in ("", LEFT)
    )


def check_unplaced(profiles, parameters):
    """ValueError, in one sentence, where ``parameters`` of a system have the place of sections for a rail, among ``profiles``, that
    is the same all along the track, or make a roller of one that is not."""
    for side, rail in (("", profiles[1]), (LEFT, profiles[3])):
        changing = is_sections(rail)
        for name in SECTION_PLACES:
            if parameters[side + name] and changing == (name == ROLLER):
                raise ValueError(
                    f"{side}{name} is {shown(side + name, parameters)}; permitted with a rail that "
                    f"{'changes' if changing else 'is the same all'} along the track is {PARAMETERS[name].default!r}"
                )


def shown(name, parameters):
    """The value of a parameter with its unit."""
    return f"{parameters[name]!r}{unit_behind(PARAMETERS[name.removeprefix(LEFT)].number.unit)}"


def refuse_changing(system, what):
    """ValueError, in one sentence, if a rail of ``system`` changes along the track or is a roller, or a wheel is not round, which
    ``what`` cannot have."""
    if system.changing:
        for wheel in (system.wheel, system.left_wheel):
            if is_sections(wheel):
                raise ValueError(f"wheel {wheel.name!r} is not round; permitted for {what} are round wheels")
        names = [one.name for one in (system.rail, system.left_rail) if is_sections(one)]
        if not names:
            side = "" if system.parameters[ROLLER] else LEFT
            raise ValueError(
                f"{side}{ROLLER} is {shown(side + ROLLER, system.parameters)}; permitted for {what} is 0, a rail"
            )
        name = names[0]
        raise ValueError(
            f"rail {name!r} changes along the track; permitted for {what} are rails that are the same all along it"
        )
