"""The one writer of files: a file is whole or as it was before."""

import os
import random
import stat
import subprocess
import sys
import threading
import time

import pytest

from tests.helpers.faults import WRITER, largest_file, needs_linux, parts_in
from wrcontact.storage import atomic
from wrcontact.storage.atomic import ABANDONED, write_atomically

pytestmark = needs_linux

LOOP = """
import runpy, sys
write = runpy.run_path(sys.argv[1])["write_atomically"]
for k in range(int(sys.argv[3])):
    write(sys.argv[2], bytes([65 + k % 26]) * 3_000_000)
    print(k, flush=True)
"""


def writing(target, count):
    """A process that writes a file again and again, each time of another letter."""
    command = [sys.executable, "-I", "-c", LOOP, str(WRITER), str(target), str(count)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True)


def is_whole(target):
    content = target.read_bytes()
    return len(content) == 3_000_000 and content == content[:1] * len(content)


@pytest.mark.parametrize(
    "seed", [1, *(pytest.param(seed, marks=pytest.mark.complete) for seed in range(2, 6))]
)
def test_a_killed_writer_leaves_a_whole_file(tmp_path, seed):
    chance, target = random.Random(seed), tmp_path / "file"
    for _ in range(12):
        program = writing(target, 100_000)
        program.stdout.readline()
        time.sleep(chance.uniform(0.0, 0.03))
        program.kill()
        program.communicate()
        assert is_whole(target)
    assert parts_in(tmp_path), "no writer was killed while it wrote"


def test_what_a_killed_writer_left_is_removed_by_the_next_one_when_it_is_old(tmp_path):
    old, young = (tmp_path / f".wrcontact-{name}.part" for name in ("0", "1"))
    for part, age in ((old, ABANDONED + 60.0), (young, 0.0)):
        part.write_text("half")
        os.utime(part, (time.time() - age,) * 2)
    write_atomically(tmp_path / "file", b"whole")
    assert parts_in(tmp_path) == [young] and (tmp_path / "file").read_bytes() == b"whole"


def test_writers_of_one_file_at_once(tmp_path):
    """A reader finds a whole file at any time."""
    target = tmp_path / "file"
    write_atomically(target, b"A" * 3_000_000)
    programs = [writing(target, 25) for _ in range(3)]
    reads = 0
    while any(program.poll() is None for program in programs):
        assert is_whole(target)
        reads += 1
    assert reads > 5 and [program.wait() for program in programs] == [0, 0, 0]
    assert parts_in(tmp_path) == []
    [program.stdout.close() for program in programs]


def test_a_file_that_cannot_be_written_stays_as_it_was(tmp_path):
    target = tmp_path / "file"
    write_atomically(target, b"before")
    with largest_file(1000), pytest.raises(OSError, match="File too large") as refused:
        write_atomically(target, b"x" * 2000)
    assert refused.value.filename == str(target) and target.read_bytes() == b"before"
    assert parts_in(tmp_path) == []
    with pytest.raises(FileNotFoundError) as refused:
        write_atomically(tmp_path / "nowhere" / "file", b"")
    assert atomic.sentence_of(refused.value) == f"{tmp_path / 'nowhere' / 'file'}: No such file or directory"
    with pytest.raises(IsADirectoryError):
        write_atomically(tmp_path, b"")


def test_permissions_links_and_pipes_stay(tmp_path):
    target, link, pipe = (tmp_path / name for name in ("file", "link", "pipe"))
    write_atomically(target, b"1")
    assert stat.S_IMODE(target.stat().st_mode) == 0o666 & ~_umask()
    target.chmod(0o640)
    link.symlink_to(target)
    write_atomically(link, b"2")
    assert link.is_symlink() and target.read_bytes() == b"2" and stat.S_IMODE(target.stat().st_mode) == 0o640
    os.mkfifo(pipe)
    heard = []
    reader = threading.Thread(target=lambda: heard.append(pipe.read_bytes()))
    reader.start()
    write_atomically(pipe, b"3")
    reader.join()
    assert heard == [b"3"] and pipe.is_fifo()


def _umask():
    present = os.umask(0)
    os.umask(present)
    return present
