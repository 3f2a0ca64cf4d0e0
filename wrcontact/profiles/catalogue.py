"""Standard profiles by their names, and the profile that an argument means.

The numbers of standard profiles are in standards.json (standards.py).
"""

import os
from functools import cache

from ..interface.parameters import on_the_left
from ..methods.words import did_you_mean
from .changing import is_sections, named, where_it_changes
from .files import of_kind, read_profile, smoothing_in_mm
from .options import ProfileFile
from .profile import Profile
from .standards import DESIGNATED, PATTERNS, build, known_name, missing_name, names

#: The profiles that help texts and refusals name; all others are in ``wrcontact profiles``.
WHEELS = ("S1002", "cone20", "cone40")
RAILS = ("UIC60", "60E1", "54E1")
NAMES = {"wheel": WHEELS, "rail": RAILS}
USUAL = (*WHEELS, *RAILS)


#: What may have happened where a wheel's profile is a rail's.
SWAPPED = "; did you swap wheel and rail?"


@cache
def standard_profile(name):
    """The standard profile with this very ``name``; KeyError if there is none."""
    return build(name)


def standard_name(name):
    """The name of the standard profile that is called ``name``, in any case, or that has this other name; None
    if there is none."""
    return next((known for known in USUAL if known.lower() == name.lower()), None) or known_name(name)


def is_standard(name, kind):
    """Whether a standard profile of this ``kind`` is called ``name``, in any case."""
    known = standard_name(name)
    return known is not None and standard_profile(known).kind == kind


def every_profile():
    """All standard profiles, rails first, without those of EN 13715 by designation."""
    return [standard_profile(name) for kind in ("rail", "wheel") for name in names(kind)]


def find_profile(source, kind, smoothing=None, argument=None, track=None):
    """The profile for ``source``: a :class:`Profile`, a standard name, the path of a file, or a
    :class:`ProfileFile`.

    ``kind`` is "wheel" or "rail"; ``smoothing`` [m] is that of :meth:`Profile.from_file`; ``argument`` is
    what the user calls the profile, by default its kind; ``track`` is the inclination of its rails [1], None
    where it is not known.  The case of a name has no effect, unless a file has
    this very name.  ValueError, in one sentence, if ``source`` is none of these.
    """
    smoothing_in_mm(smoothing)
    if isinstance(source, Profile):
        return of_kind(source, kind)
    if is_sections(source):
        raise ValueError(
            f"{argument or kind} is {named(source)}, which changes {where_it_changes(source)}; permitted are profiles that do not"
        )
    if isinstance(source, ProfileFile) and os.path.isfile(source.path):
        return read_profile(source, kind, smoothing, Profile, track)
    if isinstance(source, str) and source in NAMES[kind]:
        return standard_profile(source)
    if isinstance(source, (str, os.PathLike)) and os.path.isfile(source):
        return read_profile(ProfileFile(source), kind, smoothing, Profile, track)
    if isinstance(source, ProfileFile) and source.given == ["corner_radius"]:
        return find_profile(os.fspath(source.path), kind, argument=argument).rounded(source.corner_radius)
    missing = ", and there is no such file" if _looks_like_a_path(source) else ""
    others = ", the path of a profile file, or a Profile"
    return named_profile(source, kind, argument or kind, others, missing, SWAPPED)


def find_profiles(parameters):
    """Wheel and rail of the right side, wheel and rail of the left side, by the keywords of a
    system."""
    smoothing, track = parameters["smoothing"], parameters["rail_inclination"]
    left_track = on_the_left(parameters)["rail_inclination"]
    right = [find_profile(parameters[kind], kind, smoothing, track=track) for kind in ("wheel", "rail")]
    left = [
        profile
        if parameters[f"left_{kind}"] is None
        else find_profile(parameters[f"left_{kind}"], kind, smoothing, f"left_{kind}", left_track)
        for kind, profile in zip(("wheel", "rail"), right)
    ]
    return *right, *left


def named_profile(source, kind, argument, others, missing="", swapped=""):
    """The standard profile called ``source``, in any case; otherwise a ValueError, which names the
    ``argument``, what is ``missing`` and what is permitted: the names, and ``others``, words that continue
    their list; ``swapped`` continues that the profile is of the other kind."""
    standard = standard_name(source) if isinstance(source, str) else None
    if standard and standard_profile(standard).kind == kind:
        return standard_profile(standard)
    other = f" (a profile of the other kind{swapped})" if standard else ""
    lost = None if other else words_on_missing(source, kind)
    if lost:
        raise ValueError(f"{argument} is {source!r}{lost}")
    known = (*names(kind), *(PATTERNS if kind == "wheel" else ()))
    meant = "" if missing or other else did_you_mean(source, known)
    if isinstance(source, str) and kind == "wheel" and DESIGNATED.fullmatch(source):
        missing, meant = "", f"; a wheel of EN 13715 is written {' or '.join(PATTERNS)}"
    raise ValueError(
        f"{argument} is {str(source)!r}{other}{missing}; permitted are "
        f"{', '.join(NAMES[kind])}, the other names of `wrcontact profiles`{others}{meant}"
    )


def words_on_missing(source, kind):
    """What continues a sentence on a name that means a profile of which no source was found; None where it means
    none."""
    if not isinstance(source, str) or _looks_like_a_path(source) and not DESIGNATED.fullmatch(source):
        return None
    name = missing_name(source, kind)
    return name and (
        f": no public source with enough numbers was found of {name}; permitted is a file of its points, or a name of "
        "`wrcontact profiles`"
    )


def _looks_like_a_path(source):
    """Whether a name that is no profile's is rather that of a file: it has an ending or a folder."""
    return (
        isinstance(source, (ProfileFile, os.PathLike))
        or isinstance(source, str)
        and (bool(os.path.splitext(source)[1]) or os.path.basename(source) != source)
    )
