"""Which reader reads a file: by its ending, or by what is in it."""

import re

from .formats import GAUGE_AT_LARGER_Y, plain_points, simpack_points
from .miniprof import SECTION, miniprof_points, several_points
from .remarks import Refusal
from .vampire import FIRST, vampire_points

#: Endings that say whether a file contains a wheel or a rail.
KINDS = {".prw": "wheel", ".prr": "rail", ".whl": "wheel", ".ban": "rail", ".whe": "wheel", ".rai": "rail",
         ".wheel": "wheel", ".rail": "rail", ".slcs": "rail", ".slcw": "wheel"}
#: Profiles that vary along the rail or around the wheel, as lists of files.
SLICES = {".slcs": "along the rail", ".slcw": "around the wheel"}


def read_points(text, extension, kind, select=None):
    """The :class:`~wrcontact.profiles.formats.Points` in ``text``; a Refusal if there are none.

    Parameters
    ----------
    text : the text of the file.
    extension : ending of its name in small letters, such as ".prw".
    kind : "wheel" or "rail".
    select : which profile of a file with several, or None.
    """
    named = KINDS.get(extension)
    if extension in SLICES:
        raise Refusal(f"ends in {extension}, a list of slices of a profile that varies {SLICES[extension]}; "
                      f"permitted are files with one cross-section, such as those that it lists")
    if named and named != kind:
        raise Refusal(f"ends in {extension}, which is a {named} profile; permitted are {kind} profiles")
    if extension == ".mpt" or any(map(SECTION.match, text.splitlines()[:100])):
        return several_points(text, select)
    if extension in (".whe", ".rai") or text.lstrip()[:12].strip().lower() in FIRST.values():
        return vampire_points(text.lstrip(), kind, select)
    if select is not None:
        raise Refusal(f"contains one profile; select is {select!r}; permitted is None")
    if extension in (".prw", ".prr") or re.search(r"^[ \t]*point\.begin", text, re.MULTILINE | re.IGNORECASE):
        return simpack_points(text, kind)
    if extension in (".whl", ".ban"):
        return miniprof_points(text)
    points = plain_points(text)
    if extension in GAUGE_AT_LARGER_Y:
        points.y = -points.y
    return points
