"""Numbers in the text of the pages that are no generated table: each is computed again."""

import math
import re

import pytest

import wrcontact
from tests.helpers.paths import ROOT
from wrcontact import ContactSystem
from wrcontact.fmu.description3 import variable_blocks
from wrcontact.interface.variables import FIRST_OUTPUT, OUTPUT, REAL, STATUS, VARIABLES
from wrcontact.kernel import layout

PAGES = sorted(["README.md", *(path.relative_to(ROOT).as_posix() for path in ROOT.glob("docs/**/*.md"))])
MM = 1e-3


def texts(page):
    """The page without line ends, so that sentences can be found."""
    return re.sub(r"\s+", " ", (ROOT / page).read_text(encoding="utf-8").replace("−", "-"))


def numbers(page, pattern):
    """The groups of a pattern that stands once in a page, as numbers."""
    found = re.findall(pattern, texts(page))
    assert len(found) == 1, (page, pattern, found)
    groups = found[0] if isinstance(found[0], tuple) else found
    return [float(group) for group in groups]


@pytest.mark.parametrize("page", PAGES)
def test_numbers_of_outputs(page):
    """Wherever a page counts the outputs: all numbers, those of type Real, and the continuous ones."""
    outputs = [variable for variable in VARIABLES if variable.causality == OUTPUT]
    row = STATUS - FIRST_OUTPUT
    assert len(outputs) == row + 3  # and the equilibrium and the status
    real = sum(variable.type == REAL for variable in outputs)
    counts = {"": row + 2, "Real ": real, "continuous ": real}
    for count, kind in re.findall(r"\b(\d{3}) (Real |continuous |)outputs", texts(page)):
        assert int(count) == counts[kind], f"{count} {kind}outputs"


def test_version():
    """In one place, and none of a release while there are changes since: FMUs carry it."""
    texts = {
        name: (ROOT / name).read_text(encoding="utf-8")
        for name in ("pyproject.toml", "CITATION.cff", "wrcontact/version.py", "tools/release.py")
    }
    holders = [name for name, text in texts.items() if wrcontact.__version__ in text]
    assert holders == ["wrcontact/version.py"]
    assert 'version = {attr = "wrcontact.version.__version__"}' in texts["pyproject.toml"]
    parts = re.findall(r"^## (.*)$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert (parts[0] == "Unreleased") == (wrcontact.__version__ not in parts)


def test_bytes_of_a_row():
    """The arrays that a table holds, and what grows with a store's states."""
    all_of_it, one, wear = numbers(
        "docs/guides/usage.md",
        r"([\d.]+) kB for all outputs and one such input, (\d+) bytes for one output.*?stations add ([\d.]+) kB",
    )
    system, shifts = ContactSystem(), [0.0, 1e-3]
    assert all_of_it == pytest.approx(row_size(system.evaluate_many(shifts)) / 1e3, abs=0.05)
    assert one == row_size(system.evaluate_many(shifts, outputs=["roll"]))
    with_wear = row_size(ContactSystem(wear_outputs=True).evaluate_many(shifts)) / 1e3
    assert wear == pytest.approx(with_wear - all_of_it, abs=0.06)
    a_state, six = numbers(
        "docs/guides/tables.md",
        r"all of them are ([\d.]+) kB a state, and a million states with six outputs are (\d+) MB",
    )
    assert a_state == pytest.approx(8e-3 * layout.OUTPUT_COUNT, abs=0.05) and six == 6 * 8


def row_size(table):
    """Bytes of a row of a table, without what all rows share."""
    return (table.values.nbytes + table.status.nbytes + table.rows_of_inputs.columns.nbytes) / len(table)


def test_value_references_of_fmi_3():
    names = {block.name: block.reference for block in variable_blocks()}
    shown = numbers("docs/guides/fmu_hosts.md", r"fmi3ValueReference stations = (\d+), pressure = (\d+);")
    assert shown == [names["stations"], names["left.pressure"]]
    shown = numbers(
        "docs/guides/fmu.md", r"In FMI 3.0 `time` is (\d+), `stations` (\d+), `lateral_shift` (\d+)"
    )
    assert shown == [names[name] for name in ("time", "stations", "lateral_shift")]


def test_where_the_contact_jumps():
    """Those of usage.md; data/README.md has more digits, of another search."""
    jumps = wrcontact.check(ContactSystem()).jumps
    found = [jump.lateral_shift / MM for jump in jumps if jump.side == "right"]
    first, second, third = numbers(
        "docs/guides/usage.md", r"at a lateral shift of ([\d.]+), ([\d.]+) and ([\d.]+) mm"
    )
    assert found[:2] == pytest.approx([first, second], abs=0.005)
    assert found[2:] and found[2:] == pytest.approx([third] * len(found[2:]), abs=0.005)


def test_conformal_zones():
    """Of S1002 on 60E1, on the right."""
    wide, jump, root = numbers(
        "docs/guides/check.md",
        r"centred position \((\d+) mm\), at the jump to the flange root "
        r"\((\d+)°\) and in the root before the flange \((\d+)°\)",
    )
    zones = [zone for zone in wrcontact.check(ContactSystem(rail="60E1")).conformal if zone.side == "right"]
    assert len(zones) == 3
    assert zones[0].width / MM == pytest.approx(wide, abs=0.5)
    assert [math.degrees(zone.turn) for zone in zones[1:]] == pytest.approx([jump, root], abs=0.5)


def test_a_rail_that_is_inclined_twice():
    """The peak pressure [MPa] in the centred position; three digits."""
    twice, once = numbers("docs/guides/profiles.md", r"UIC60 has (\d+) instead of (\d+) MPa under S1002")
    for value, inclination in ((once, 1 / 40), (twice, 2 / 40)):
        found = ContactSystem(rail_inclination=inclination).evaluate().right.max_pressure
        assert found / 1e6 == pytest.approx(value, rel=2e-3)


def test_forces_and_contact_angles_at_1_mm():
    """The example in conventions.md: what the loads would give along the contact points' normals, and force.y
    [N]; how far the right patch's centre of load lies from its contact point [mm]."""
    sides, force = numbers(
        "docs/reference/conventions.md", r"over the wheels is (-\d+) N, and `force\.y` is (-\d+) N"
    )
    (away,) = numbers("docs/reference/conventions.md", r"load lies ([\d.]+) mm to the field side")
    state = ContactSystem().evaluate(1e-3)
    total = sum(
        sign * side.normal_force * math.sin(side.contact_angle)
        for sign, side in ((1, state.left), (-1, state.right))
    )
    assert (total, state.force.y) == pytest.approx((sides, force), abs=1.0)
    assert state.right.patches[0].centroid == pytest.approx(away * MM, abs=0.05 * MM)
