"""Formats of profile files: one file each, which says the endings, how a text is recognised, its reader and its writer
where there is one, and registers itself.

A reader's docstring and docs/guides/profiles.md describe what is read.  A reader returns the points of the file,
with the unit, shift and mirror that the file itself states; everything that must be guessed is left to repair.py.
"""

from ..remarks import Refusal
from . import gensys, miniprof, miniprof_several, plain, simpack, slices, universal_mechanism, vampire  # noqa: F401
from .base import FORMATS


def read_points(text, extension, kind, select=None):
    """The :class:`~wrcontact.profiles.formats.base.Points` in ``text``; a Refusal if there are none.

    Parameters
    ----------
    text : the text of the file.
    extension : ending of its name in small letters, such as ".prw".
    kind : "wheel" or "rail".
    select : which profile of a file with several, or None.
    """
    named = next((one.endings[extension] for one in FORMATS if extension in one.endings), "")
    if named and named != kind:
        raise Refusal(
            f"ends in {extension}, which is a {named} profile; permitted are {kind} profiles (did you swap wheel and rail?)"
        )
    found = next(one for one in FORMATS if one.read and one.takes(extension, text))
    if select is not None and not found.several:
        raise Refusal(f"contains one profile; select is {select!r} and cannot be given")
    return found.read(text, kind, select)
