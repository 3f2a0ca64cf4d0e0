"""A fleet: every pair as by itself, files that cannot be used, interrupted runs, and the report."""

import csv
import errno
import json
import os
import re
import shutil
import subprocess
import sys
from html import unescape
from html.parser import HTMLParser

import numpy as np
import pytest

import wrcontact
from tests.helpers.fleet_files import write_fleet
from tests.helpers.foreign_files import inclined_rail
from tests.helpers.paths import ROOT
from tests.helpers.profile_points import Y, Z, columns, simpack
from wrcontact.conditioning.curves import merged_jumps
from wrcontact.conditioning.measures import PAIR
from wrcontact.fleet import run as fleet_run
from wrcontact.fleet import table, workers
from wrcontact.fleet.files import named_sources, slug
from wrcontact.fleet.folder import Folder
from wrcontact.fleet.page import COLUMNS, summary
from wrcontact.fleet.pair import examine
from wrcontact.fleet.table import empty_row
from wrcontact.profiles import standard_profile
from wrcontact.workers import results

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Folders of two wheels and of two rails, and a file among the wheels that is no profile."""
    wheels, rails = write_fleet(tmp_path_factory.mktemp("fleet"), 2, 2)
    (wheels / "damaged.txt").write_text("the batteries were empty\n")
    return wheels, rails


@pytest.fixture(scope="module")
def folder(files, tmp_path_factory):
    return tmp_path_factory.mktemp("checked")


@pytest.fixture(scope="module")
def fleet(files, folder):
    return wrcontact.check_fleet(*files, folder, processes=1, pictures="none", gauge=1.436)


@pytest.fixture
def examined(monkeypatch):
    """The pairs that are examined from now on, by their names."""
    pairs = []

    def counted(wheel, rail, *settings):
        pairs.append((wheel.name, rail.name))
        return examine(wheel, rail, *settings)

    monkeypatch.setattr(fleet_run, "examine", counted)
    return pairs


def pairs_of(fleet):
    return [(row["wheel"], row["rail"]) for row in fleet if not row["error"]]


ALL = [(f"wheel0{wheel}", f"rail0{rail}") for wheel in (0, 1) for rail in (0, 1)]


# --- rows -----------------------------------------------------------------------------------------


def test_every_pair_has_a_row_and_every_broken_file_one(fleet, files):
    assert pairs_of(fleet) == ALL and len(fleet) == 5 and len(fleet.broken) == 1
    row = fleet[-1]
    with pytest.raises(ValueError) as alone:
        wrcontact.ContactSystem(wheel=files[0] / "damaged.txt")
    assert row["error"] == str(alone.value) and (row["wheel"], row["rail"]) == ("damaged", "")
    assert not row["usable"] and all(row[name] is None for name in PAIR)
    assert repr(fleet) == "Fleet(4 pairs, 4 of them usable; rows with an error: 1)"


def test_rails_that_lean_are_decided_file_by_file_and_counted(tmp_path):
    """The conicity of S1002 on UIC60 1:20 is that on the same rail inclined in its file, and a rail at 1:40 is an
    error; a wheel whose origin is 10 mm off is counted, too."""
    (tmp_path / "rails").mkdir()
    for name, lean in (("upright", 0.0), ("leaning", 1 / 20), ("other", 1 / 40)):
        text = simpack(*inclined_rail(lean), "rail")
        (tmp_path / "rails" / f"{name}.prr").write_text(text)
    (tmp_path / "aside.txt").write_text(columns(Y + 10.0, Z))
    fleet = wrcontact.check_fleet(
        ["S1002", tmp_path / "aside.txt"],
        tmp_path / "rails",
        tmp_path / "out",
        rail_inclination=1 / 20,
        processes=1,
        pictures="none",
    )
    rows = {(row["wheel"], row["rail"]): row for row in fleet}
    exact = rows["S1002", "upright"]["conicity_3mm"]
    assert rows["S1002", "leaning"]["conicity_3mm"] == pytest.approx(exact, rel=1e-3)
    assert rows["S1002", "leaning"]["rail_file_inclination"] == 1 / 20
    assert "other" not in {row["rail"] for row in fleet if not row["error"]}
    assert [row["grave_remarks"] for row in fleet.rows[:4]] == [0, 0, 1, 1]
    html = unescape((tmp_path / "out" / "report.html").read_text(encoding="utf-8"))
    head, rest = html.split("<table>")
    assert "2 pairs with a rail that its file has inclined, turned upright." in head
    assert "2 pairs with a remark on what makes all results wrong if it is so." in head
    assert "inclined by 1:40 towards the track centre in the file, and its track inclines it by 1:20" in head
    assert re.search(r"<p><b>wheel profile aside: the back of its flange is at y = -60 mm", rest)


@pytest.mark.full
def test_json_is_that_of_the_pair_alone(fleet, folder, files, run, tmp_path):
    row = fleet[1]
    code, _, _ = run(
        "check",
        "--wheel",
        files[0] / "wheel00.txt",
        "--rail",
        files[1] / "rail01.txt",
        "--gauge-mm",
        "1436",
        "--output",
        tmp_path / "alone.png",
        "--json",
        tmp_path / "alone.json",
    )
    assert code == 0
    assert (folder / row["json"]).read_bytes() == (tmp_path / "alone.json").read_bytes()


def test_numbers_are_those_of_the_report(fleet, folder):
    for row in fleet.rows[:4]:
        report = json.loads((folder / row["json"]).read_text(encoding="utf-8"))
        assert row["remarks"] == report["remarks"] and row["usable"] is report["usable"] is True
        assert [row[f"conicity_{k}mm"] for k in range(1, 9)] == report["conicity"]["level"]
        assert row["conicity_3mm_rolled"] == report["conicity"]["rolled"][2]
        assert row["nonlinearity"] == report["conicity"]["nonlinearity"]
        assert [row["usable_from"], row["usable_to"]] == report["usable_shifts"]
        for name in ("nearest_jump", "flange_shift"):
            assert row[name] == report[name]
        for kind in ("wheel", "rail"):
            assert row[f"{kind}_noise"] == report[kind]["reading"]["noise"]
        within = [zone for zone in report["conformal"] if zone["start"] <= 8e-3 and zone["stop"] >= -8e-3]
        assert row["conformal_count"] == sum(zone["side"] == "right" for zone in within) > 0
        assert row["conformal_width"] == max(zone["width"] for zone in within)
        shift = np.array(report["curves"]["lateral_shift"])
        rates = np.array(report["curves"]["right"]["wheel_rate"], dtype=float)[np.abs(shift) <= 8e-3]
        assert row["wheel_rate"] == pytest.approx(np.nanmax(np.abs(rates)), rel=0.05)  # and the left one's
    assert len({row["conicity_3mm"] for row in fleet.rows[:4]}) == 4


def test_columns_and_other_forms(fleet, folder):
    level = fleet["conicity_3mm"]
    assert level.dtype == float and np.isnan(level[-1]) and np.all(level[:4] > 0.0)
    assert fleet["usable"].tolist() == [True] * 4 + [False] and fleet["wheel"][0] == "wheel00"
    with pytest.raises(KeyError, match="conicity_3mm"):
        fleet["conicity"]
    with open(folder / "fleet.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["wheel"] for row in rows] == fleet["wheel"].tolist()
    assert float(rows[2]["nearest_jump"]) == fleet[2]["nearest_jump"]


@pytest.mark.full
def test_a_table_of_pandas_has_the_columns_of_the_file(fleet, folder):
    pandas = pytest.importorskip("pandas")
    frame = fleet.to_pandas()
    written = pandas.read_csv(folder / "fleet.csv")
    assert list(frame.columns) == list(written.columns) and len(frame) == len(written) == len(fleet)
    np.testing.assert_array_equal(frame["conicity_3mm"], fleet["conicity_3mm"])
    np.testing.assert_array_equal(written["conicity_3mm"], fleet["conicity_3mm"])


# --- interrupted runs -----------------------------------------------------------------------------


def test_nothing_is_done_twice(fleet, files, folder, examined):
    again = wrcontact.check_fleet(*files, folder, processes=1, pictures="none", gauge=1.436)
    assert examined == [] and again == fleet


@pytest.mark.full
def test_an_interrupted_run_continues(files, tmp_path, examined, monkeypatch, fleet, folder):
    count = fleet_run.examine

    def until(*task):
        if len(examined) == 2:
            raise KeyboardInterrupt
        return count(*task)

    monkeypatch.setattr(fleet_run, "examine", until)
    chosen = {"processes": 1, "pictures": "none", "gauge": 1.436}
    with pytest.raises(KeyboardInterrupt):
        wrcontact.check_fleet(*files, tmp_path, **chosen)
    assert examined == ALL[:2] and not (tmp_path / "report.html").exists()
    with open(tmp_path / "fleet.jsonl", "a", encoding="utf-8") as file:  # killed in the middle of a line
        file.write('{"mark": "00')
    monkeypatch.setattr(fleet_run, "examine", count)
    whole = wrcontact.check_fleet(*files, tmp_path, **chosen)
    assert examined == ALL and whole.rows == fleet.rows
    for name in ("fleet.jsonl", "fleet.csv", "report.html", fleet[3]["json"]):
        assert (tmp_path / name).read_bytes() == (folder / name).read_bytes(), name


def test_what_has_changed_is_done_again(files, tmp_path, examined, fleet, folder):
    chosen = {"processes": 1, "pictures": "none"}
    wheels = [files[0] / "wheel00.txt", "cone40"]
    wrcontact.check_fleet(wheels, "60E1", tmp_path, **chosen)
    os.unlink(tmp_path / "pairs" / "cone40__60e1.json")
    wrcontact.check_fleet(wheels, "60E1", tmp_path, **chosen)
    assert examined == [("wheel00", "60E1"), ("cone40", "60E1"), ("cone40", "60E1")]
    wrcontact.check_fleet(wheels, "60E1", tmp_path, **chosen, smoothing=8e-6)  # only that of the file
    assert examined[3:] == [("wheel00", "60E1")]
    wrcontact.check_fleet(wheels, "60E1", tmp_path, **chosen, smoothing=8e-6, gauge=1.44)
    assert len(examined) == 6


# --- the report -----------------------------------------------------------------------------------


class Rows(HTMLParser):
    """The cells (data-v, text) of each row of a table's body, its links, and all tags with an address."""

    def __init__(self):
        super().__init__()
        self.rows, self.links, self.addresses, self.heads = [], [], [], 0

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.addresses += [value for name, value in attributes if name in ("href", "src")]
        if tag == "tr":
            self.rows.append([])
        elif tag == "td":
            self.rows[-1].append([given.get("data-v"), ""])
        self.heads += tag == "th"

    def handle_data(self, data):
        if self.rows and self.rows[-1]:
            self.rows[-1][-1][1] += data


def test_names_with_underscores_share_no_file(tmp_path):
    """`w` on `1__r` and `w__1` on `r`, of which one conicity is another one's half."""
    for name, profiles in (
        ("wheels", {"w": "cone20", "w__1": "cone40"}),
        ("rails", {"r": "UIC60", "1__r": "54E1"}),
    ):
        (tmp_path / name).mkdir()
        for stem, known in profiles.items():
            standard_profile(known).save(tmp_path / name / f"{stem}.json")
    fleet = wrcontact.check_fleet(
        tmp_path / "wheels", tmp_path / "rails", tmp_path / "out", processes=1, pictures="none"
    )
    files = [row["json"] for row in fleet]
    assert len(set(files)) == 4 == len(list((tmp_path / "out" / "pairs").iterdir()))
    for row in fleet:
        report = json.loads((tmp_path / "out" / row["json"]).read_text(encoding="utf-8"))
        assert report["conicity"]["level"][2] == row["conicity_3mm"]
    assert not {slug(name) for name in ("w__1", "_w", "w_", "a  b")} & {"w__1", "_w", "w_", "a__b"}


@pytest.mark.full
@pytest.mark.parametrize(
    "damage",
    [
        lambda text: text.replace(b'"usable": true', b'"usable": false'),
        lambda text: text[: len(text) // 2],
        lambda text: b"\xff\xfe" + text[2:],
        lambda text: b"[]\n{}\n3\n" + text.replace(b'"flange_shift"', b'"flange_lift"'),
    ],
)
def test_damaged_lines_are_done_again(files, tmp_path, examined, fleet, folder, damage):
    shutil.copytree(folder, tmp_path / "out")
    path = tmp_path / "out" / "fleet.jsonl"
    path.write_bytes(damage(path.read_bytes()))
    again = wrcontact.check_fleet(*files, tmp_path / "out", processes=1, pictures="none", gauge=1.436)
    assert 1 <= len(examined) <= 4 and [row["usable"] for row in again] == [row["usable"] for row in fleet]
    assert [row["conicity_3mm"] for row in again] == [row["conicity_3mm"] for row in fleet]


@pytest.mark.parametrize("lost", ["json", "picture"])
def test_a_pair_is_kept_with_all_of_its_files_only(tmp_path, lost):
    row = Folder(tmp_path).add("mark", {**empty_row(), "wheel": "a", "rail": "b"}, "{}", b"drawn")
    assert Folder(tmp_path).kept("mark", "all") == row
    (tmp_path / row[lost]).unlink()
    assert Folder(tmp_path).kept("mark", "all") is None


@pytest.mark.full
def test_a_pair_that_lacks_its_picture_is_done_again(tmp_path, examined):
    """Its JSON alone is not all of it; and other parameters make other pairs."""
    given = ("S1002", "UIC60", tmp_path / "out")
    (row,) = wrcontact.check_fleet(*given, processes=1, pictures="all")
    assert len(examined) == 1
    (tmp_path / "out" / row["picture"]).unlink()
    wrcontact.check_fleet(*given, processes=1, pictures="all")
    assert len(examined) == 2 and (tmp_path / "out" / row["picture"]).is_file()
    (other,) = wrcontact.check_fleet(*given, processes=1, pictures="all", rail_inclination=1 / 20)
    assert len(examined) == 3 and other["conicity_3mm"] != row["conicity_3mm"]


def test_a_full_disk_is_reported_with_the_file(files, tmp_path, monkeypatch):
    class Full:
        def __enter__(self):
            return self

        def __exit__(self, *_):
            return False

        def write(self, text):
            raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("wrcontact.fleet.folder.open", lambda *_, **__: Full(), raising=False)
    with pytest.raises(OSError, match="No space left") as told:
        wrcontact.check_fleet("S1002", "UIC60", tmp_path / "out", processes=1, pictures="none")
    assert told.value.filename == str(tmp_path / "out" / "fleet.jsonl")


def test_jumps_are_those_of_the_side_with_more(monkeypatch):
    """A left wheel of its own has another number of jumps; the row has the larger one."""
    report = wrcontact.check(wrcontact.ContactSystem(wheel=("S1002", "cone20")))
    near = [jump for jump in report.jumps if abs(jump.lateral_shift) <= 8e-3]
    counts = {side: len(merged_jumps(near, side)) for side in ("left", "right")}
    assert counts["left"] != counts["right"]
    assert table.numbers_of(report)["jump_count"] == max(counts.values())


def test_the_summary_counts_near_jumps_and_has_the_middle_conicity():
    numbers = ((0.5e-3, 0.4), (5e-3, 0.1), (None, 0.2))
    rows = [
        {
            **empty_row(),
            "wheel": f"w{k}",
            "rail": "r",
            "usable": True,
            "nearest_jump": jump,
            "conicity_3mm": level,
        }
        for k, (jump, level) in enumerate(numbers)
    ]
    assert summary(table.Fleet(tuple(rows))) == (
        "3 pairs of 3 wheels and 1 rail: 3 usable, 1 with a jump within 1 mm of the centred position. "
        "Equivalent conicity at 3 mm: 0.100 to 0.400, median 0.200."
    )


def test_the_report_has_every_row_with_what_it_sorts_by(fleet, folder):
    text = (folder / "report.html").read_text(encoding="utf-8")
    read = Rows()
    read.feed(text)
    head, *rows = read.rows
    assert head == [] and len(rows) == len(fleet) and {len(row) for row in rows} == {read.heads}
    for row, cells in zip(fleet, rows):
        assert [cells[0][1], cells[1][1]] == [row["wheel"], row["rail"]]
        for name, (value, shown) in zip(COLUMNS, cells[4:]):
            if row[name] is None:
                assert value is None and shown == ""
            else:
                assert float(value) == pytest.approx(row[name], rel=1e-8), name
                assert shown == f"{row[name] * PAIR[name].factor:.{PAIR[name].digits}f}", name
        assert all(words in cells[2][1] for words in (row["error"], *row["remarks"]))
        assert unescape(text).count(row["error"]) >= 2  # it stands above the table, too
    assert set(read.addresses) == {row["json"] for row in fleet if row["json"]}  # and nothing from the net
    assert all((folder / address).is_file() for address in read.addresses)
    assert "4 pairs of 2 wheels and 2 rails: 4 usable" in unescape(text)
    assert not re.search(r"https?:", text)


@pytest.mark.full
def test_a_click_on_a_heading_sorts(fleet, folder):
    """In a browser: empty cells last, a second click the other way round; and the text that is sought."""
    playwright = pytest.importorskip("playwright.sync_api")
    if CHROMIUM is None:
        pytest.skip("chromium is not installed")
    with playwright.sync_playwright() as running:
        browser = running.chromium.launch(
            executable_path=CHROMIUM,
            args=["--no-sandbox", "--disable-gpu", "--disable-background-networking"],
        )
        page, wrong = browser.new_page(), []
        page.on("pageerror", lambda error: wrong.append(str(error)))
        page.on("request", lambda request: request.url.startswith("file:") or wrong.append(request.url))
        page.goto((folder / "report.html").as_uri())
        heads = page.query_selector_all("th")
        for k, name in [(0, "wheel"), *((k + 4, name) for k, name in enumerate(COLUMNS))]:
            for back in (False, True):
                heads[k].click()
                shown = page.eval_on_selector_all(
                    "tbody tr",
                    f"rows => rows.map(row => row.cells[{k}].dataset.v ?? row.cells[{k}].textContent)",
                )
                values = [row[name] for row in fleet if row[name] not in (None, "")]
                there = [type(values[0])(text) for text in shown if text]
                wanted = sorted(values, reverse=back)
                assert there == (pytest.approx(wanted) if k else wanted), name
                assert shown[len(values) :] == [""] * (len(fleet) - len(values)), name
        page.fill("input", "wheel01")
        assert page.eval_on_selector_all("tbody tr", "rows => rows.filter(row => !row.hidden).length") == 2
        browser.close()
    assert not wrong


def test_the_page_names_every_column():
    page = (ROOT / "docs" / "guides" / "fleets.md").read_text(encoding="utf-8")
    rows = [f"| `{name}` | {one.unit} | {one.meaning} |" for name, one in PAIR.items()]
    assert "\n".join(rows) in page and all(f"`{name}`" in page for name in table.OTHERS)


# --- files ----------------------------------------------------------------------------------------


def test_names_differ(tmp_path):
    for name in ("a/x.whl", "b/x.whl", "b/x.txt", "b/Y.txt", "b/.hidden"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("")
    found = named_sources([tmp_path / "a", f"{tmp_path}/b/*.*", "S1002"], "wheel")
    assert list(found) == ["x.whl", "Y", "x.txt", "x.whl_2", "S1002"]
    turned = named_sources(wrcontact.ProfileFile(tmp_path / "b", mirror_y=True), "wheel")
    assert [source.mirror_y for source in turned.values()] == [True] * 3


@pytest.mark.parametrize(
    "wheels, told",
    [
        ([], "wheels is an empty list"),
        ([3], "wheels has 3; permitted are paths"),
        ("nowhere/*.whl", "wheels is 'nowhere/*.whl', where there is no file"),
        ("60E1", "wheels is '60E1'"),
    ],
)
def test_nothing_to_check_is_refused(wheels, told):
    with pytest.raises(ValueError, match=re.escape(told)):
        wrcontact.check_fleet(wheels, "60E1")


def test_arguments_are_refused_in_a_sentence():
    for chosen, told in (
        ({"pictures": "some"}, "pictures is 'some'"),
        ({"processes": 0}, "processes is 0"),
        ({"left_wheel": "S1002"}, "left_wheel is 'S1002'"),
        ({"gauge": 3.0}, "gauge is 3.0"),
    ):
        with pytest.raises(ValueError, match=told):
            wrcontact.check_fleet("S1002", "60E1", **chosen)


def test_dask_is_asked_for_in_a_sentence(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ImportError, match=r"a scheduler needs distributed.*wrcontact\[cluster\]"):
        wrcontact.check_fleet("S1002", "60E1", scheduler="tcp://127.0.0.1:9")


# --- the command and the workers ------------------------------------------------------------------


@pytest.mark.full
def test_command(run, files, tmp_path):
    out = tmp_path / "out"
    code, told, err = run(
        "check",
        "--batch",
        f"{files[0]}/*[0d].txt",
        files[1] / "rail01.txt",
        "--output",
        out,
        "--wheel-rotate-deg",
        "0.1",
        "--smoothing-um",
        "8",
    )
    assert code == 1 and "damaged.txt" in told and f"report written to {out / 'report.html'}" in told
    assert "1 pair of 1 wheel and 1 rail: 1 usable" in told
    assert "profile" not in err  # remarks stand in the report
    drawn = (out / "pairs" / "wheel00__rail01.png").read_bytes()
    assert drawn.startswith(b"\x89PNG") and len(drawn) > 100_000
    row = json.loads((out / "fleet.jsonl").read_text(encoding="utf-8"))["row"]
    assert row["picture"] == "pairs/wheel00__rail01.png"
    report = json.loads((out / row["json"]).read_text(encoding="utf-8"))
    assert report["wheel"]["reading"]["smoothing"] == pytest.approx(8e-6)
    turned = wrcontact.ProfileFile(files[0] / "wheel00.txt", rotate=np.radians(0.1))
    alone = wrcontact.check(wrcontact.ContactSystem(turned, files[1] / "rail01.txt", smoothing=8e-6))
    assert report["conicity"]["level"] == alone.conicity.level.tolist()


def test_command_refuses_in_a_sentence(run, tmp_path):
    for words, told in (
        (("--pictures", "all"), "--pictures"),
        (("--scheduler", "tcp://a:1"), "--scheduler"),
        (("--batch", "S1002", "60E1", "--wheel", "S1002"), "--batch"),
        (("--batch", "S1002", "60E1", "--json", tmp_path / "a.json"), "--json"),
        (("--batch", "S1002", "--output", tmp_path / "o"), "permitted are wheels and rails"),
        (("--wheel", "S1002", "60E1"), "check takes no '60E1'"),
        (("--batch", tmp_path / "none", "60E1", "--output", tmp_path / "o"), "none"),
    ):
        code, _, err = run("check", *words)
        assert code == 2 and err.startswith("wrcontact: ") and err.count("\n") == 1 and told in err


@pytest.mark.full
def test_processes_give_the_same_files(fleet, files, folder, tmp_path):
    shared = wrcontact.check_fleet(*files, tmp_path, processes=2, pictures="none", gauge=1.436)
    assert shared.rows == fleet.rows
    for row in fleet.rows[:4]:
        assert (tmp_path / row["json"]).read_bytes() == (folder / row["json"]).read_bytes()


@pytest.mark.full
def test_a_script_without_the_question_for_its_name_is_reported(files, tmp_path):
    """Its processes run it again as they start.  The second is late here, and must leave no pool behind."""
    script = tmp_path / "fleet.py"
    script.write_text(
        "import multiprocessing, time\n"
        "from concurrent.futures import ProcessPoolExecutor\n"
        "import wrcontact\n"
        "if multiprocessing.current_process().name == 'SpawnProcess-2':\n"
        "    ProcessPoolExecutor.submit = lambda *arguments: time.sleep(3600)\n"
        f"wrcontact.check_fleet({str(files[0])!r}, {str(files[1])!r}, processes=2)\n"
    )
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 1 and "a process of 2 has ended early" in done.stderr.splitlines()[-1]
    assert "leaked" not in done.stderr


@pytest.mark.full
def test_a_scheduler_gives_the_same_rows(fleet, files):
    distributed = pytest.importorskip("distributed")
    with distributed.Client(
        processes=False, n_workers=1, threads_per_worker=1, dashboard_address=None
    ) as client:
        shared = wrcontact.check_fleet(*files, scheduler=client, gauge=1.436)
        assert client.status == "running"  # it is the caller's
    assert [{**row, "json": ""} for row in fleet] == list(shared)


@pytest.mark.full
def test_a_scheduler_that_does_not_answer_is_reported(monkeypatch):
    pytest.importorskip("distributed")
    monkeypatch.setattr("wrcontact.workers.PATIENCE", 0.5)
    with pytest.raises(ValueError, match="scheduler is 'tcp://127.0.0.1:9', where no dask scheduler answers"):
        wrcontact.check_fleet("S1002", "60E1", scheduler="tcp://127.0.0.1:9")


def test_few_tasks_are_under_way_at_a_time():
    """Each holds its profiles."""
    seen, under_way = [], set()

    class Executor(workers.Here):
        def submit(self, function, *arguments):
            under_way.add(arguments)
            seen.append(len(under_way))
            return super().submit(function, *arguments)

    for key, result in results(Executor(), 9, lambda k: k * k, {k: (k,) for k in range(1000)}):
        under_way.discard((key,))
        assert result == key * key
    assert len(seen) == 1000 and max(seen) == 9
