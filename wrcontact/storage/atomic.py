"""Files are written atomically: under another name in the same folder, then moved to their place.

A process that is killed, interrupted or out of disk space leaves the previous file, or none. The part that a
killed one has written stays behind as ``.wrcontact-*.part``; a write to the same folder removes it once it is
ABANDONED.

Standard library only and no imports from the package, so that build tools can run this file by its path.
"""

import contextlib
import errno
import os
import secrets
import stat
import tempfile
import time
from pathlib import Path

#: Time without growth after which a part belongs to a process that has ended [s].
ABANDONED = 3600.0


def write_atomically(target, data):
    """Write the bytes ``data`` to the file ``target``."""
    with open_atomically(target) as file:
        file.write(data)


@contextlib.contextmanager
def open_atomically(target, mode="wb", **options):
    """An open file that becomes ``target`` when the ``with`` block ends without an error; ``mode`` and
    ``options`` as for open().

    A link stays a link, and an existing file keeps its permissions. A target that is not an ordinary file,
    such as a pipe, is written in place. An OSError names ``target``.
    """
    try:
        with _part_of(target, mode, options) as file:
            yield file
    except OSError as problem:
        if problem.filename is None or Path(problem.filename).suffix == ".part":
            problem.filename, problem.filename2 = os.fspath(target), None
        raise


@contextlib.contextmanager
def _part_of(target, mode, options):
    before = os.stat(target) if os.path.exists(target) else None
    if before and not stat.S_ISREG(before.st_mode):
        with open(target, mode, **options) as file:
            yield file
        return
    if before and not os.access(target, os.W_OK):  # os.replace does not check this
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), os.fspath(target))
    place = Path(os.path.realpath(target))
    part = place.with_name(f".wrcontact-{secrets.token_hex(8)}.part")
    _remove_abandoned(place.parent)
    try:
        with open(part, mode.replace("w", "x"), **options) as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        if before:
            os.chmod(part, stat.S_IMODE(before.st_mode))
        os.replace(part, place)
    except BaseException:
        with contextlib.suppress(OSError):
            part.unlink()
        raise


def _remove_abandoned(folder):
    """Remove the parts that killed processes have left in ``folder``."""
    for part in folder.glob(".wrcontact-*.part"):
        with contextlib.suppress(OSError):
            if time.time() - part.stat().st_mtime > ABANDONED:
                part.unlink()


def sentence_of(problem):
    """The message of an OSError, in one sentence with the name of the file; only
    scratch files have no name."""
    where = os.fsdecode(problem.filename or tempfile.tempdir or "the folder for temporary files")
    return f"{where}: {problem.strerror or problem}"
