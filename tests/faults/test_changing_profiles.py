"""Profiles that change while they are read are refused."""

import os
import re
import threading

import pytest

from tests.helpers.faults import needs_linux, points_of
from wrcontact import Profile
from wrcontact.fmu import native
from wrcontact.profiles import files
from wrcontact.storage.atomic import write_atomically

pytestmark = needs_linux

CHANGES = {
    "cut": lambda path, text: path.write_text(text[: len(text) // 2]),
    "emptied": lambda path, text: path.write_text(""),
    "longer": lambda path, text: path.write_text(text + "80 0\n"),
    "rewritten": lambda path, text: (path.write_text(text[::-1]), os.utime(path, (1.0, 1.0))),
}


@pytest.mark.parametrize("moment", ["before", "after"])
@pytest.mark.parametrize(
    "change",
    ["emptied", "longer", *(pytest.param(name, marks=pytest.mark.check) for name in ("cut", "rewritten"))],
)
def test_a_profile_that_changes_while_it_is_read_is_refused(tmp_path, monkeypatch, change, moment):
    """Between the opening and the reading, or between the reading and the end."""
    path, text = tmp_path / "rail.txt", points_of("UIC60")
    path.write_text(text)

    class Changing:
        def __init__(self, *arguments):
            self.file = open(*arguments)  # noqa: SIM115
            self.fileno = self.file.fileno

        def __enter__(self):
            return self

        def __exit__(self, *problem):
            self.file.close()

        def read(self, size):
            content = self.file.read(size) if moment == "after" else b""
            CHANGES[change](path, text)
            return content or self.file.read(size)

    monkeypatch.setattr(files, "open", Changing, raising=False)
    with pytest.raises(
        ValueError,
        match=f"^rail profile {re.escape(str(path))} changed while it was read; permitted are files ",
    ):
        Profile.from_file(path, "rail")
    monkeypatch.undo()
    path.write_text(text)
    assert Profile.from_file(path, "rail").kind == "rail"


@pytest.mark.full
def test_a_profile_that_is_replaced_while_others_read_it(tmp_path):
    """Whole files in turn: each reading is one of them, or refused."""
    path, texts = tmp_path / "rail.txt", [points_of("UIC60"), points_of("54E1")]
    wanted = []
    for text in texts:
        path.write_text(text)
        wanted.append(Profile.from_file(path, "rail"))
    ended = threading.Event()

    def replace():
        while not ended.is_set():
            for text in texts:
                write_atomically(path, text.encode())

    writer = threading.Thread(target=replace)
    writer.start()
    try:
        found = [Profile.from_file(path, "rail") for _ in range(30)]
    finally:
        ended.set()
        writer.join()
    assert {wanted.index(profile) for profile in found} == {0, 1}


def test_a_profile_is_read_once_for_an_fmu(tmp_path, monkeypatch):
    """What is packed is what was tried, though the file has gone since."""
    path, read = tmp_path / "rail.txt", []
    path.write_text(points_of("54E1"))

    def read_and_remove(*arguments):
        read.append(arguments[0])
        path.unlink()
        return text

    text = path.read_text()
    monkeypatch.setattr(files, "_text", read_and_remove)
    starts, profiles = native.packed_profiles(rail_profile=str(path))
    assert read == [str(path)] and starts == {"rail_profile": "rail.txt"}
    assert profiles["rail.txt"].kind == "rail"
