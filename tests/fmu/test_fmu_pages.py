"""What a user sees of the FMUs before they run: icon, terminals, documentation and licences."""

import io
import re
import runpy
from html.parser import HTMLParser
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.image import imread

from tests.helpers.cases import profile_file
from tests.helpers.paths import ROOT
from tests.helpers.platforms import needs_zig
from tests.helpers.schemas import problems_of
from wrcontact.fmu import SOURCES, build, native
from wrcontact.fmu.documentation import about_native, documentation_page
from wrcontact.interface.variables import folded
from wrcontact.kernel.binding.files import PLATFORMS

pytestmark = pytest.mark.check

KINDS = ("python", 2, 3)


@pytest.fixture(scope="module")
def archives():
    """Everything but the program, of the three kinds of FMU."""
    starts, profiles = native.packed_profiles()
    described = {"modelDescription.xml": build.model_description("", "", "1", {})}
    return {
        "python": {**build.documentation({}), **described},
        **{version: native.uncompiled(version, starts, profiles, list(PLATFORMS)) for version in (2, 3)},
    }


def described_variables(entries):
    """Every variable of the model description as it stands there."""
    return list(ElementTree.fromstring(entries["modelDescription.xml"]).find("ModelVariables"))


# --- terminals ----------------------------------------------------------------------------------------------


def terminals(entries):
    return ElementTree.fromstring(entries["terminalsAndIcons/terminalsAndIcons.xml"])


def test_terminals_are_those_of_fmi_3(archives):
    content = archives[3]["terminalsAndIcons/terminalsAndIcons.xml"]
    assert ElementTree.fromstring(content).get("fmiVersion") == "3.0"
    assert problems_of(content, "fmi3/fmi3TerminalsAndIcons.xsd") == []


@pytest.mark.parametrize("kind", ("python", 2))
def test_archives_of_fmi_2_have_no_file_of_fmi_3(archives, kind):
    """FMI Library ends its reading with a fatal error at a file whose fmiVersion is another one."""
    assert not [name for name in archives[kind] if name.startswith("terminalsAndIcons")]
    for name, content in archives[kind].items():
        if name.endswith(".xml"):
            assert ElementTree.fromstring(content).get("fmiVersion") == "2.0", name


def test_every_input_and_output_is_in_one_terminal(archives):
    variables = described_variables(archives[3])
    members = [member.get("variableName") for member in terminals(archives[3]).iter("TerminalMemberVariable")]
    assert sorted(members) == sorted(
        v.get("name") for v in variables if v.get("causality") in ("input", "output")
    )


def test_terminals_of_left_and_right_match(archives):
    groups = {}
    for terminal in terminals(archives[3]).iter("Terminal"):
        members = [member.get("memberName") for member in terminal]
        assert len(set(members)) == len(members)
        groups[terminal.get("name")] = (terminal.get("terminalKind"), members)
    assert list(groups) == ["pose", "load", "rails", "motion", "friction", "wheelset", "left", "right"]
    assert groups["left"] == groups["right"] and "pressure" in groups["left"][1]
    assert {"roll", "vertical_shift"} <= set(groups["pose"][1]) & set(groups["wheelset"][1])


# --- icon ---------------------------------------------------------------------------------------------------


def test_icon_is_in_every_fmu(archives):
    folder = "terminalsAndIcons"
    places = {"python": ["model.png"], 2: ["model.png"], 3: [f"{folder}/icon.png", f"{folder}/icon.svg"]}
    for kind, entries in archives.items():
        icons = {name: content for name, content in entries.items() if name.endswith((".png", ".svg"))}
        assert sorted(icons) == places[kind] and sum(map(len, icons.values())) < 20_000  # [bytes]
        assert icons[places[kind][0]] == archives[3][f"{folder}/icon.png"]


def test_icon_shows_wheels_rails_and_contacts_on_a_clear_ground(archives):
    icon = imread(io.BytesIO(archives[3]["terminalsAndIcons/icon.png"]))
    assert icon.shape == (200, 200, 4)
    assert np.allclose(icon[..., 3], icon[:, ::-1, 3], atol=0.02)  # left is right
    drawn = icon[..., 3] > 0.99
    assert 0.2 < drawn.mean() < 0.5 and not icon[0, 0, 3]
    colours, counts = np.unique((255 * icon[drawn][:, :3]).round().astype(int), axis=0, return_counts=True)
    assert len(colours[counts > 200]) == 4  # axle, wheels, rails, contact points


def test_icon_is_what_its_script_draws(tmp_path):
    script = runpy.run_path(str(ROOT / "tools" / "make_icon.py"))
    assert (SOURCES / "icon.svg").read_text(encoding="utf-8") == script["svg"]()
    script["png"](tmp_path / "icon.png")
    committed, drawn = imread(SOURCES / "icon.png"), imread(tmp_path / "icon.png")
    # edges are smoothed a little differently by each matplotlib
    assert np.abs(committed - drawn).mean() < 0.01


# --- documentation ------------------------------------------------------------------------------------------


class Page(HTMLParser):
    """The tables of a page as lists of cells, what it links to, and its open tags."""

    def __init__(self, text):
        super().__init__()
        self.rows, self.links, self.open = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.links += [value for name, value in attributes if name in ("href", "src")]
        if tag != "meta":
            self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_startendtag(self, tag, attributes):
        pass

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if {"td", "th"} & set(self.open):
            self.rows[-1][-1] += data


def references(cell):
    """The numbers that a cell like "left 28 … 58; right 162" stands for."""
    found = set()
    for first, last in re.findall(r"(\d+)(?: … (\d+))?", cell):
        found |= set(range(int(first), int(last or first) + 1))
    return found


def without_size(name):
    """side.station for side.station[j] and side.station[31]."""
    return re.sub(r"\[\w+\]$", "", name)


@pytest.mark.parametrize("kind", KINDS)
def test_page_has_every_variable_with_its_reference(archives, kind):
    page = Page(archives[kind]["documentation/index.html"].decode())
    assert page.open == [] and page.links == ["licenses/"]
    rows = {without_size(row[0]): row for row in page.rows}
    wanted = {}
    for variable in described_variables(archives[kind]):
        wanted.setdefault(without_size(folded(variable.get("name"))), set()).add(
            int(variable.get("valueReference"))
        )
    for name, numbers in wanted.items():
        assert references(rows[name][1]) == numbers, name


@pytest.mark.parametrize("kind", KINDS)
def test_page_shows_what_the_model_description_declares(archives, kind):
    text = archives[kind]["documentation/index.html"].decode()
    root = ElementTree.fromstring(archives[kind]["modelDescription.xml"])
    rows = Page(text).rows
    kinds = {"ModelExchange": "model exchange", "CoSimulation": "co-simulation"}
    assert [element.tag for element in root if element.tag in kinds] == list(kinds)[kind == "python" :]
    for element in (element for element in root if element.tag in kinds):
        for ability, value in element.attrib.items():
            assert ability == "modelIdentifier" or [kinds[element.tag], ability, value] in rows
    for category in root.iter("Category"):
        assert [category.get("name"), category.get("description")] in rows
    assert "url(" not in text and "@import" not in text and f"FMI {root.get('fmiVersion')}" in text


def test_page_of_fmi_3_shows_arrays(archives):
    text = archives[3]["documentation/index.html"].decode()
    assert "<code>side.pressure[" in text and "<code>side.pressure[j]" not in text
    assert "<code>side.pressure[j]</code>" in archives[2]["documentation/index.html"].decode()


def test_array_sizes_are_named():
    """A dimension is a number, or the parameter that holds it."""
    description = """<fmiModelDescription fmiVersion="3.0"><CoSimulation modelIdentifier="m"/><ModelVariables>
        <UInt32 name="stations" valueReference="7" causality="structuralParameter" description="d"
                start="31"/>
        <Float64 name="left.station" valueReference="8" causality="output" description="Left wheel: d">
        <Dimension valueReference="7"/></Float64></ModelVariables></fmiModelDescription>"""
    rows = Page(documentation_page("1", description, "")).rows
    assert ["stations", "7", "31", "d"] in rows and ["side.station[stations]", "left 8", "d"] in rows


def test_page_names_platforms_and_packed_profiles(archives, tmp_path):
    wheel = profile_file(tmp_path, "wheel")
    _, profiles = native.packed_profiles(wheel_profile=wheel)
    text = about_native(2, ["x86_64-linux", "aarch64-darwin"], profiles)
    assert "x86_64-linux, aarch64-darwin" in text and "x86_64-windows" not in text
    assert wheel.name in text and all(name in text for name in ("S1002", "UIC60", "60E1", "54E1"))
    assert "x86_64-windows" in archives[2]["documentation/index.html"].decode()


# --- licences -----------------------------------------------------------------------------------------------


def test_licences_of_all_that_is_packed(archives):
    for kind, entries in archives.items():
        assert b"MIT" in entries["documentation/licenses/license.txt"]
        if kind != "python":
            assert (
                b"Redistribution and use in source and binary forms"
                in entries["documentation/licenses/fmi.txt"]
            )
    assert b"numpy" in archives["python"]["documentation/externalDependencies.txt"]


@needs_zig
def test_the_licence_of_mingw_goes_with_a_library_for_windows(archives):
    assert b"mingw-w64" in archives[3]["documentation/licenses/mingw-w64.txt"]
    alone = native.uncompiled(3, *native.packed_profiles(), ["x86_64-linux"])
    assert "documentation/licenses/mingw-w64.txt" not in alone
