"""Rails whose section changes along the track, as far as others have to know of them (wrcontact/sections has them)."""

import os

from ..interface.parameters import LEFT, PARAMETERS
from ..interface.section_places import SECTION_PLACES
from ..methods.numbers import unit_behind
from .options import ProfileFile

KIND, ENDINGS = "rail sections", (".slcs", ".toml")


def is_sections(source):
    """Whether what is given as a rail is :class:`~wrcontact.RailSections`, or the path of a file of sections."""
    if isinstance(source, ProfileFile):
        source = source.path
    if isinstance(source, (str, os.PathLike)):
        return os.path.splitext(os.fspath(source))[1].lower() in ENDINGS
    return getattr(source, "kind", None) == KIND


def named(source):
    """How messages call sections: as they are given."""
    return (
        f"RailSections {source.name!r}"
        if hasattr(source, "kind")
        else repr(str(getattr(source, "path", source)))
    )


def has_changing(parameters):
    """Whether a rail of a system with these ``parameters`` changes along the track."""
    return is_sections(parameters["rail"]) or is_sections(parameters[LEFT + "rail"])


def check_unplaced(profiles, parameters):
    """ValueError, in one sentence, where ``parameters`` of a system have the place of sections for a rail, among ``profiles``, that
    is the same all along the track."""
    for side, rail in (("", profiles[1]), (LEFT, profiles[3])):
        for name in () if is_sections(rail) else SECTION_PLACES:
            if parameters[side + name]:
                raise ValueError(
                    f"{side}{name} is {shown(side + name, parameters)}; permitted with a rail that is the same all along the "
                    f"track is {PARAMETERS[name].default!r}"
                )


def shown(name, parameters):
    """The value of a parameter with its unit."""
    return f"{parameters[name]!r}{unit_behind(PARAMETERS[name.removeprefix(LEFT)].number.unit)}"


def refuse_changing(system, what):
    """ValueError, in one sentence, if a rail of ``system`` changes along the track, which ``what`` cannot have."""
    if system.changing:
        name = next(one.name for one in (system.rail, system.left_rail) if is_sections(one))
        raise ValueError(
            f"rail {name!r} changes along the track; permitted for {what} are rails that are the same all along it"
        )
