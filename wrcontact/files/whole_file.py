"""Files that are whole or not there: written under another name beside their place, then moved to it.

A process that is killed, interrupted or out of disk space leaves the file from before, or none.  What it has written stays
behind as ``.wrcontact-*.part`` and is removed when the next file is written to the same folder, once it is ABANDONED.

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

#: A part that has not grown for so long is that of a process that has ended [s].
ABANDONED = 3600.0


def write_whole(target, data):
    """Write the bytes ``data`` to the file ``target``."""
    with whole_file(target) as file:
        file.write(data)


@contextlib.contextmanager
def whole_file(target, mode="wb", **options):
    """An open file that becomes ``target`` where the ``with`` block ends well; ``mode`` and ``options`` are those of open().

    A link stays a link, and an existing file keeps its permissions.  What is no ordinary file, such as a pipe, is written to
    where it is.  An OSError names ``target``.
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
    if before and not os.access(target, os.W_OK):       # moving would not mind
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), os.fspath(target))
    place = Path(os.path.realpath(target))
    part = place.with_name(f".wrcontact-{secrets.token_hex(8)}.part")
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
    _remove_abandoned(place.parent)


def _remove_abandoned(folder):
    """Remove what killed processes have left in ``folder``."""
    for part in folder.glob(".wrcontact-*.part"):
        with contextlib.suppress(OSError):
            if time.time() - part.stat().st_mtime > ABANDONED:
                part.unlink()


def sentence_of(problem):
    """What an OSError says, in one sentence with the name of the file; only scratch files have none."""
    where = os.fsdecode(problem.filename or tempfile.tempdir or "the folder for temporary files")
    return f"{where}: {problem.strerror or problem}"
