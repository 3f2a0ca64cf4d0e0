"""The files of the kernel: which are its source, and which version they are.

Standard library only and no imports from the package, so that build tools can run this file by its path.
"""

import hashlib
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]
#: The rooms of the kernel, from upstream to downstream; a module imports from its own room
#: and from those before it.
ROOMS = ("layout", "surface", "search", "contact", "patch", "normal", "creep",
         "wheelset", "prepare", "tangent")
HANDLE_VERSION = 7      # raise when the functions or the handle in native/*.h change


def kernel_modules(folder=HERE):
    """Paths of the modules that are translated, sorted by room and name; the records of the room
    layout are one of them."""
    return [path for path in kernel_sources(folder)
            if (path.parent.name == "layout") == (path.name == "__init__.py")]


def kernel_sources(folder=HERE):
    """Paths of all that the generated C follows from."""
    return [path for room in ROOMS for path in sorted(Path(folder, room).glob("*.py"))]


def fingerprint(folder, layout):
    """One positive 60-bit integer that tells one kernel source from another.

    ``layout`` is the digest of the room layout, whose records follow from the table in wrcontact/interface.

    It is written into the generated C and answered by ``wrcontact_abi()``, so a library compiled from other
    sources than the ones beside it is recognised. Line ends do not count: a checkout may change them.
    """
    digest = hashlib.sha256(b"handle %d, layout %s" % (HANDLE_VERSION, layout.encode()))
    for path in kernel_sources(folder):
        text = path.read_bytes().replace(b"\r\n", b"\n")
        digest.update(b"\0%s\0%d\0" % (path.relative_to(folder).as_posix().encode(), len(text)))
        digest.update(text)
    return int(digest.hexdigest()[:15], 16)
