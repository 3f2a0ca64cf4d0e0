"""Lists of slices of profiles that vary along the rail or around the wheel, as CONTACT has them: refused by what they
are."""

from functools import partial

from ..remarks import Refusal
from .base import Format, register


def refuse(extension, where, text, kind, select):
    """Raise the Refusal."""
    raise Refusal(
        f"ends in {extension}, a list of slices of a profile that varies {where}; permitted are files with one "
        "cross-section, such as those that it lists"
    )


for turn, extension, where in ((1, ".slcs", "along the rail"), (2, ".slcw", "around the wheel")):
    register(
        Format(f"slices {where}", turn, {extension: ""}, partial(refuse, extension, where), several=True)
    )
