"""MiniProf's .mpt, with several profiles."""

import re

from ..options import choose
from ..remarks import Refusal
from . import miniprof
from .base import Format, register

#: Heads of the sections of one profile in a .mpt file, such as [Profile2Info] and [Profile2Points].
SECTION = re.compile(r"^[ \t]*\[[ \t]*profile[ \t]*(\d+)[ \t]*(info|points)[ \t]*\]", re.IGNORECASE)
#: Header lines that name a profile, the first that is there.
NAMES = ("name", "profilename", "filename", "mpdn")


def read(text, kind, select):
    """Points of the selected profile.

    Each profile has two sections: [Profile1Info] with the header lines and [Profile1Points] with the points,
    both as in a .ban file.  Lines of other sections are left out.
    """
    parts, line_ends, own = {}, len(text.splitlines()), None
    for line_number, line in enumerate(text.splitlines()):
        head = SECTION.match(line)
        if head or line.lstrip().startswith("["):
            own = parts.setdefault(int(head[1]), [""] * line_ends) if head else None
        elif own is not None:
            own[line_number] = line  # lines keep their numbers
    if not parts:
        raise Refusal("contains no section [Profile1Points]; permitted are MiniProf files with such sections")
    chosen = list(parts)[choose([_name(lines) for lines in parts.values()], select)]
    return miniprof.read("\n".join(parts[chosen]))


def _name(lines):
    """The name in the header lines of one profile; "" without one."""
    values = {
        key.strip().lower(): value.strip()
        for key, equals, value in (line.partition("=") for line in lines)
        if equals
    }
    return next((values[key] for key in NAMES if values.get(key)), "")


def _has_sections(text):
    return any(map(SECTION.match, text.splitlines()[:100]))


register(Format("MiniProf, several profiles", 10, {".mpt": ""}, read, _has_sections, several=True))
