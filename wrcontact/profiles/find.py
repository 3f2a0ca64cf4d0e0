"""The profile that an argument means: one of the standards, a file, or the profile itself."""

import os

from .catalogue import RAILS, WHEELS, standard_name, standard_profile
from .files import of_kind, smoothing_in_mm
from .options import ProfileFile
from .profile import Profile


def find_profile(source, kind, smoothing=None, argument=None):
    """The profile for ``source``: a :class:`Profile`, a standard name, the path of a file, or a
    :class:`ProfileFile`.

    ``kind`` is "wheel" or "rail"; ``smoothing`` [m] is that of :meth:`Profile.from_file`; ``argument`` is
    what the user calls the profile, by default its kind.  The case of a name has no effect, unless a file has
    this very name.  ValueError, in one sentence, if ``source`` is none of these.
    """
    smoothing_in_mm(smoothing)
    if isinstance(source, Profile):
        return of_kind(source, kind)
    if isinstance(source, ProfileFile) and os.path.isfile(source.path):
        return Profile.from_file(source.path, kind, smoothing, **source.reading)
    names = WHEELS if kind == "wheel" else RAILS
    if isinstance(source, str) and source in names:
        return standard_profile(source)
    if isinstance(source, (str, os.PathLike)) and os.path.isfile(source):
        return Profile.from_file(source, kind, smoothing)
    standard = standard_name(source) if isinstance(source, str) else None
    if standard in names:
        return standard_profile(standard)
    other = " (a profile of the other kind)" if standard else ""
    raise ValueError(f"{argument or kind} is {str(source)!r}{other}; permitted are {', '.join(names)}, the "
                     f"path of a "
                     "profile file, or a Profile")
