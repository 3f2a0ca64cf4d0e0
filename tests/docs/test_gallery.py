"""The gallery's pictures are there and small, and its code makes them."""

import re
import runpy

import pytest

from tests.helpers.paths import ROOT
from wrcontact import plots

PAGE = (ROOT / "docs" / "guides" / "gallery.md").read_text(encoding="utf-8")
PICTURES = re.findall(r"!\[.+?\]\(\.\./img/(.*?)\)", PAGE)
MOST = {".png": 120_000, ".gif": 400_000}  # [byte]


@pytest.mark.parametrize("name", PICTURES)
def test_pictures_are_there_small_and_saved_by_the_page(name):
    file = ROOT / "docs" / "img" / name
    assert 4_000 < file.stat().st_size < MOST[file.suffix]
    assert PAGE.count(f'"{name}"') == 1


def test_every_function_of_one_axis_is_in_the_gallery():
    guides = ROOT / "docs" / "guides"
    own = "".join(
        (guides / name).read_text(encoding="utf-8") for name in ("wear.md", "sections.md", "wheels.md")
    )  # have pictures
    shown = set(re.findall(r"plots\.(\w+)\(", PAGE + own))
    shown |= set(re.findall(r"`(?:wrcontact\.)?(?:plots\.)?(\w+)`", PAGE + own))
    other = {"PatchTractions", "demo_figure", "find_jumps", "read_run"}  # no pictures, and that of the demo
    assert set(plots.__all__) - other <= shown


@pytest.mark.full
def test_the_page_s_code_makes_its_pictures(tmp_path):
    """Of the animation some frames, half a second each."""
    draw = runpy.run_path(str(ROOT / "docs" / "make_pictures.py"))["draw_gallery"]
    blocks = draw.__globals__["gallery_code"]()
    few = [block.replace("frames=30", "frames=4") for block in blocks]
    assert few != blocks
    draw.__globals__["gallery_code"] = lambda: few
    made = draw(tmp_path)
    assert [path.name for path in made] == PICTURES == list(dict.fromkeys(PICTURES))
    for path in made:
        assert path.read_bytes()[:4] in (b"\x89PNG", b"GIF8") and path.stat().st_size < MOST[path.suffix]
