"""What happens to files and answers when something around the program fails: processes that are killed or interrupted, full and
read-only disks, files that change, several builds at once, several FMUs in one process, other threads of the libraries beneath.

A file that wrcontact writes is whole or as it was before; whoever waits for it reads one sentence.
"""

import contextlib
import hashlib
import multiprocessing
import os
import random
import re
import resource
import shutil
import signal
import stat
import subprocess
import sys
import threading
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

from build_hooks.kernel_compiler import CompilerProblem, compile_library
from tests.helpers.damages import damages
from tests.cli.test_cli import OUTSIDE, start
from tests.fmu.test_fmu import OUTPUT_NAMES, poses, run_scenario
from tests.fmu.test_native_fmu import has_compiler
from tests.helpers.paths import ROOT
from wrcontact import Profile, ContactSystem
from wrcontact.cli import main
from wrcontact.cli.demo import apart
from wrcontact.cli.door import Refused
from wrcontact.fmu import build_fmu, native
from wrcontact.fmu.compilers import zig_cache
from wrcontact.simulation.session import Refused as StateRefused
from wrcontact.simulation.session import Session
from wrcontact.interface.variables import REFERENCE
from wrcontact.kernel.binding.library import LIBRARY_NAME, LibraryUnusable, open_library
from wrcontact.profiles import files, standard_profile
from wrcontact.storage import atomic
from wrcontact.storage.atomic import ABANDONED, write_atomically

WRITER = Path(atomic.__file__)
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="signals, limits and devices are those of Linux")
needs_compiler = pytest.mark.skipif(not has_compiler(), reason="a native FMU is built by a C compiler, and none is here")
slow, complete = pytest.mark.slow, pytest.mark.complete


def parts_in(folder):
    """What writers have left."""
    return list(Path(folder).glob(".wrcontact-*.part"))


def cli(*words, **settings):
    """The command line in a process of its own, running."""
    command = [sys.executable, "-c", "from wrcontact.cli import main; main()", *map(str, words)]
    return subprocess.Popen(command, env=OUTSIDE, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **settings)


# --- the one writer -----------------------------------------------------------------------------------------------------

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


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=[slow, complete]) for seed in range(2, 6))])
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


@contextlib.contextmanager
def largest_file(size):
    """No file may grow beyond ``size`` bytes here, as on a disk that is full."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def test_a_file_that_cannot_be_written_stays_as_it_was(tmp_path):
    target = tmp_path / "file"
    write_atomically(target, b"before")
    with largest_file(1000), pytest.raises(OSError, match="File too large") as refused:
        write_atomically(target, b"x" * 2000)
    assert refused.value.filename == str(target) and target.read_bytes() == b"before" and parts_in(tmp_path) == []
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


# --- killed, interrupted --------------------------------------------------------------------------------------------------


def wait_for_part(program, folder):
    """Until a process is writing to a folder."""
    while not parts_in(folder):
        assert program.poll() is None, program.communicate()
        time.sleep(0.002)


@pytest.mark.parametrize("blow, code", [(signal.SIGINT, 130), (signal.SIGKILL, -9)], ids=["interrupted", "killed"])
def test_a_sweep_that_is_ended_while_it_writes(tmp_path, blow, code):
    target = tmp_path / "sweep.csv"
    target.write_text("before\n")
    program = cli("sweep", "--step-mm", "0.002", "--csv", target)
    wait_for_part(program, tmp_path)
    program.send_signal(blow)
    out, errors = program.communicate(timeout=60)
    assert (program.returncode, out, target.read_text()) == (code, "", "before\n")
    if blow == signal.SIGINT:
        assert errors == "wrcontact: interrupted; no file is half written\n" and parts_in(tmp_path) == []


@slow
@pytest.mark.parametrize("words, rounds", [
    (("demo", "--output", "{}"), 1),
    *(pytest.param(words, 4, marks=complete) for words in (
        ("sweep", "--step-mm", "0.0005", "--csv", "{}/a.csv"), ("figures", "--output", "{}"), ("demo", "--output", "{}")))])
def test_ctrl_c_ends_a_command_in_one_line(tmp_path, words, rounds):
    """Of the group of processes, as a terminal sends it; the helper of the demo is in it too."""
    chance = random.Random(rounds)
    for _ in range(rounds):
        program = cli(*(word.format(tmp_path) for word in words), start_new_session=True)
        time.sleep(chance.uniform(1.5, 4.0))      # not before it has been loaded
        os.killpg(program.pid, signal.SIGINT)
        _, errors = program.communicate(timeout=120)
        lines = [line for line in errors.splitlines() if "WARNING" not in line]
        if program.returncode == 0:
            assert lines == []      # it had ended
        else:
            assert program.returncode == 130 and lines == ["wrcontact: interrupted; no file is half written"]
        assert_files_are_whole(tmp_path)


@slow
@complete
def test_a_demo_that_is_killed(tmp_path):
    """At random times: each of its files is whole or not there, and the next run is undisturbed by what was left."""
    chance = random.Random(12)
    for _ in range(12):
        program = cli("demo", "--output", tmp_path, start_new_session=True)
        time.sleep(chance.uniform(1.0, 12.0))
        with contextlib.suppress(ProcessLookupError):
            os.killpg(program.pid, signal.SIGKILL)
        program.communicate()
        assert_files_are_whole(tmp_path)
    done = start("-c", "from wrcontact.cli import main; main()", "demo", "--output", str(tmp_path), folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert assert_files_are_whole(tmp_path) == 3


def assert_files_are_whole(folder):
    """Every table, picture, page and FMU; how many there are."""
    found = [file for file in Path(folder).rglob("*") if file.is_file() and file.suffix != ".part"]
    for file in found:
        content = file.read_bytes()
        if file.suffix == ".csv":
            rows = content.decode().splitlines()
            assert content.endswith(b"\n") and len({row.count(",") for row in rows if '"' not in row}) == 1, file
        elif file.suffix == ".png":
            assert content.endswith(b"IEND\xaeB`\x82"), file
        elif file.suffix == ".fmu":
            assert fmpy_finds_nothing(file), file
        else:
            assert file.name == "figures.md" and content.endswith(b"\n"), file
    return len(found)


def fmpy_finds_nothing(file):
    from fmpy.validation import validate_fmu

    return validate_fmu(str(file)) == []


BUILD = "import sys; from wrcontact.fmu.native import build_native_fmus as build; print(*build(sys.argv[1], cache=sys.argv[2]))"


def building(folder, cache, **settings):
    """A process that builds the native FMUs."""
    command = [sys.executable, "-c", BUILD, str(folder), str(cache)]
    return subprocess.Popen(command, env=OUTSIDE, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **settings)


@slow
@needs_compiler
@pytest.mark.parametrize("rounds", [2, pytest.param(25, marks=complete)])
def test_a_build_that_is_killed(tmp_path, fmus, compiled, rounds):
    """At random times while it compiles, packs and writes; what it kept for the next build is whole too."""
    chance, cache = random.Random(rounds), tmp_path / "cache" if rounds > 4 else compiled
    for _ in range(rounds):
        program = building(tmp_path / "out", cache, start_new_session=True)
        time.sleep(chance.uniform(0.2, 8.0 if rounds > 4 else 2.5))
        with contextlib.suppress(ProcessLookupError):
            os.killpg(program.pid, signal.SIGKILL)
        program.communicate()
        for file in (tmp_path / "out").glob("*.fmu"):
            assert file.read_bytes() == fmus[int(file.stem[-1])].read_bytes()
    again = native.build_native_fmus(tmp_path / "out", cache=cache)
    assert [file.read_bytes() for file in again] == [file.read_bytes() for file in fmus.values()]


def test_a_helper_that_is_killed_is_told_in_a_sentence():
    with pytest.raises(Refused, match="the process that runs the FMU ended before it had answered"):
        apart(os._exit, 9)


# --- full and read-only -----------------------------------------------------------------------------------------------------


@pytest.fixture
def refused(capsys):
    """The one sentence in which the command line refuses."""

    def refused(*words):
        with pytest.raises(SystemExit) as ended:
            main(list(map(str, words)), prog_name="wrcontact")
        said = capsys.readouterr()
        assert ended.value.code in (1, 2) and said.out == "" and said.err.count("\n") == 1, said
        return said.err

    return refused


def test_a_full_disk_is_told_in_one_sentence(tmp_path, refused):
    """A device that is always full, and a limit to the size of files."""
    picture = tmp_path / "picture.png"
    picture.symlink_to("/dev/full")
    assert refused("sweep", "--csv", "/dev/full") == "wrcontact: /dev/full: No space left on device\n"
    assert refused("plot", "--output", picture) == f"wrcontact: {picture}: No space left on device\n"
    picture.unlink()
    with largest_file(20_000):
        assert refused("sweep", "--csv", tmp_path / "a.csv") == f"wrcontact: {tmp_path / 'a.csv'}: File too large\n"
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def small_disk(tmp_path):
    """A disk of 300 kB."""
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=300k", "tmpfs", str(disk)], capture_output=True).returncode:
        pytest.skip("this user may not mount a small disk")
    yield disk
    subprocess.run(["umount", "-l", str(disk)], check=True)


@slow
@complete
@needs_compiler
def test_a_disk_that_is_too_small(tmp_path, small_disk, compiled):
    """For tables and FMUs, and for what a build and a demo unpack and compile meanwhile."""
    run = {"text": True, "capture_output": True, "env": OUTSIDE, "timeout": 300}
    command = [sys.executable, "-c", "from wrcontact.cli import main; main()"]
    for words, file in ((("sweep", "--step-mm", "0.01", "--csv", f"{small_disk}/a.csv"), f"{small_disk}/a.csv"),
                        (("demo", "--output", small_disk), f"{small_disk}/WheelsetContact.fmu")):
        done = subprocess.run([*command, *map(str, words)], **run)
        assert done.returncode == 2 and done.stderr.endswith(f"wrcontact: {file}: No space left on device\n"), done.stderr
        assert list(small_disk.iterdir()) == []
    with pytest.raises(OSError, match="No space left on device") as full:
        native.build_native_fmus(small_disk, cache=compiled)
    assert full.value.filename == f"{small_disk}/WheelsetContact_native_fmi2.fmu" and list(small_disk.iterdir()) == []
    (small_disk / "fill").write_bytes(bytes(250_000))
    words = ["demo", "--output", str(tmp_path / "out")]
    done = subprocess.run([*command, *words], **{**run, "env": {**OUTSIDE, "TMPDIR": str(small_disk)}})
    last = done.stderr.splitlines()[-1]
    assert done.returncode == 2 and re.fullmatch(f"wrcontact: {small_disk}.*: No space left on device", last), done.stderr
    assert "Traceback" not in done.stderr


#: For an administrator, who may write anywhere, without that right.
UNPRIVILEGED = () if os.geteuid() else ("setpriv", "--bounding-set", "-dac_override,-dac_read_search")


def is_bound(folder):
    """Whether a read-only folder is one for processes after UNPRIVILEGED."""
    folder.chmod(0o555)
    if UNPRIVILEGED and not shutil.which(UNPRIVILEGED[0]):
        return False
    return subprocess.run([*UNPRIVILEGED, "touch", str(folder / "probe")], capture_output=True).returncode != 0


@pytest.fixture
def read_only(tmp_path):
    """A function that makes a folder and all in it read-only, until the test ends."""
    made = []

    def read_only(folder):
        made.append(folder)
        if not is_bound(folder):
            pytest.skip("this user may write to read-only folders, and there is no setpriv to give that up")
        for inner in sorted(folder.rglob("*"), reverse=True):
            if not inner.is_symlink():
                inner.chmod(inner.stat().st_mode & ~0o222)
        return folder

    yield read_only
    for folder in made:
        for inner in (folder, *folder.rglob("*")):
            if not inner.is_symlink():
                inner.chmod(inner.stat().st_mode | 0o700)


@slow
@needs_compiler
@pytest.mark.parametrize("what", ["native", pytest.param("all", marks=complete)])
def test_read_only_installation_home_and_folder(tmp_path, read_only, compiled, what):
    """The package evaluates, draws and builds its FMUs; where it may not write, one sentence says so."""
    installed, home, closed = (tmp_path / name for name in ("installed", "home", "closed"))
    package = Path(atomic.__file__).parents[1]
    shutil.copytree(package, installed / "wrcontact", ignore=shutil.ignore_patterns("__pycache__"))
    if not (package / "fmu_src").is_dir():
        shutil.copytree(package.parent / "fmu_src", installed / "fmu_src", ignore=shutil.ignore_patterns("__pycache__"))
    home.mkdir(), closed.mkdir()
    [read_only(folder) for folder in (installed, home, closed)]
    environment = {**OUTSIDE, "PYTHONPATH": os.pathsep.join([str(installed), *sys.path[1:]]), "HOME": str(home)}
    for name in ("XDG_CACHE_HOME", "ZIG_GLOBAL_CACHE_DIR", "MPLCONFIGDIR"):
        environment.pop(name, None)

    def run(script):
        done = subprocess.run([*UNPRIVILEGED, sys.executable, "-c", script], cwd=tmp_path, env=environment, text=True,
                              capture_output=True, timeout=600)
        assert "Traceback" not in done.stderr, done.stderr
        return done

    answer = run("import wrcontact; print(wrcontact.__file__); print(wrcontact.ContactSystem().evaluate(1e-3).roll)")
    file, roll = answer.stdout.split()
    assert Path(file).is_relative_to(installed) and float(roll) == ContactSystem().evaluate(1e-3).roll
    cache = None if what == "all" else str(compiled)
    run(f"from wrcontact.fmu.native import build_native_fmus; build_native_fmus('out', cache={cache!r})")
    if what == "all":       # zig compiles libraries of Windows into its new cache
        assert "no compiled kernel" not in run("from wrcontact.fmu import build_fmu; build_fmu('out')").stderr
    assert assert_files_are_whole(tmp_path / "out") == (3 if what == "all" else 2)
    command = "from wrcontact.cli import main; main({!r}.split(), prog_name='wrcontact')"
    assert run(command.format("plot --output plot.png")).returncode == 0 and imread(tmp_path / "plot.png").size
    for words, wanted in (("sweep --csv closed/a.csv", "closed/a.csv"), ("plot --output closed/a.png", "closed/a.png"),
                          ("figures --only 7.2 --output closed", "closed/fig_7_2.csv")):
        done = run(command.format(words))
        assert done.returncode == 2 and done.stderr.splitlines()[-1] == f"wrcontact: {wanted}: Permission denied", done.stderr


def test_zig_has_a_cache_where_the_home_is_read_only(tmp_path, monkeypatch):
    """One that it shares with all that this process compiles; elsewhere its usual one."""
    for name in ("XDG_CACHE_HOME", "ZIG_GLOBAL_CACHE_DIR"):
        monkeypatch.delenv(name, raising=False)
    find = zig_cache.__wrapped__
    monkeypatch.setenv("HOME", str(tmp_path))
    assert find() == {}
    monkeypatch.setenv("HOME", "/dev/null")
    folder, = set(find().values())
    assert Path(folder).is_dir() and os.access(folder, os.W_OK)
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", "/mine")
    assert find() == {}


@slow
@pytest.mark.parametrize("kind", ["python", pytest.param("native", marks=needs_compiler)])
def test_an_fmu_in_a_read_only_folder(tmp_path, request, read_only, kind):
    """Unpacked by somebody else, with no home and no folder for temporary files that can be written to."""
    import fmpy

    fmu = build_fmu(tmp_path / "fmu") if kind == "python" else request.getfixturevalue("fmus")[2]
    folder, home = tmp_path / "unpacked", tmp_path / "home"
    home.mkdir()
    fmpy.extract(str(fmu), unzipdir=str(folder))
    read_only(folder), read_only(home)
    script = ("import fmpy, sys; print(repr(fmpy.simulate_fmu(sys.argv[1], stop_time=1e-2, step_size=1e-3, "
              "start_values={'lateral_shift': 1e-3}, output=['roll', 'status'])[-1].tolist()), flush=True); "
              "import os; os._exit(0)")
    environment = {**OUTSIDE, "HOME": str(home), "TMPDIR": str(home)}
    done = subprocess.run([*UNPRIVILEGED, sys.executable, "-c", script, str(folder)], cwd=home, text=True, capture_output=True,
                          env=environment)
    assert done.returncode == 0, done.stderr
    _, roll, status = eval(done.stdout)
    assert status == 0 and roll == pytest.approx(ContactSystem().evaluate(1e-3).roll, abs=1e-12)


# --- several at once ----------------------------------------------------------------------------------------------------------


@slow
@needs_compiler
@pytest.mark.parametrize("cold", [False, pytest.param(True, marks=complete)], ids=["warm", "cold"])
def test_builds_at_once(tmp_path, fmus, compiled, cold):
    """Of the same FMUs into one folder, with one cache of compiled sources; empty and full."""
    programs = [building(tmp_path / "out", tmp_path / "cache" if cold else compiled) for _ in range(3)]
    answers = [program.communicate(timeout=600) for program in programs]
    assert [program.returncode for program in programs] == [0] * 3, answers
    assert [file.read_bytes() for file in sorted((tmp_path / "out").iterdir())] == [file.read_bytes() for file in fmus.values()]
    assert not cold or not parts_in(tmp_path / "cache")


@slow
@complete
def test_kernels_compiled_at_once_while_others_load_them(tmp_path):
    """Into one folder: there is a whole library at any time."""
    folder = tmp_path / "kernel"
    shutil.copytree(Path(atomic.__file__).parents[1] / "kernel", folder)
    script = (f"import sys; sys.path.insert(0, {str(ROOT / 'build_hooks')!r}); "
              f"from kernel_compiler import compile_library; print(compile_library(sys.argv[1]))")
    programs = [subprocess.Popen([sys.executable, "-c", script, str(folder)], stdout=subprocess.PIPE, text=True)
                for _ in range(3)]
    loads = 0
    while any(program.poll() is None for program in programs):
        try:
            open_library(folder)
        except LibraryUnusable as reason:
            assert "there is no" in str(reason)
        loads += 1
        time.sleep(0.05)
    assert [program.communicate()[0].strip() for program in programs] == [str(folder / LIBRARY_NAME)] * 3
    assert loads > 5 and open_library(folder) and parts_in(folder) == []


def test_a_compiler_that_fails_leaves_the_kernel_as_it_was(tmp_path):
    (tmp_path / LIBRARY_NAME).write_bytes(b"before")
    with pytest.raises(CompilerProblem):
        compile_library(tmp_path, compiler=["false"])
    assert [file.name for file in tmp_path.iterdir()] == [LIBRARY_NAME] and (tmp_path / LIBRARY_NAME).read_bytes() == b"before"


VARIANTS = {"one": ("0.1.0", None), "two": ("0.2.0", "54E1")}      #: version and rail


@slow
@needs_compiler
@pytest.mark.parametrize("shared", [pytest.param(False, marks=complete), True], ids=["names of their own", "names shared"])
def test_two_versions_of_all_fmus_in_one_process(tmp_path, compiled, monkeypatch, shared):
    """Native ones and Python ones, of other version numbers and start values; the values of each are those that it has alone,
    also where the host shares the names of all libraries that it loads (RTLD_GLOBAL)."""
    built = {}
    for name, (version, rail) in VARIANTS.items():
        monkeypatch.setattr("wrcontact.fmu.build.__version__", version)
        monkeypatch.setattr("wrcontact.fmu.native.__version__", version)
        built[f"python {name}"] = build_fmu(tmp_path / name, rail=rail)
        built[f"native {name}"] = native.build_native_fmus(tmp_path / name, rail=rail, cache=compiled)[0]
    rows = poses(6)
    names = list(built)
    given = {"others": {name: [str(built[name]), str(tmp_path / f"beside {name}")] for name in names[1:]}, "rows": rows,
             "shared": shared}
    seen = run_scenario("several", built[names[0]], tmp_path / "unpacked", given)
    alone = {name: run_scenario("trajectory", built[name], tmp_path / f"alone {name}", {"rows": rows, "names": OUTPUT_NAMES})
             for name in names}
    for name, answer in seen.items():
        assert answer["seen"] == alone[name if name in alone else names[0]]["seen"], name
        assert answer["rail"] == ("54E1" if name.endswith("two") else "UIC60")
    assert alone["native one"]["seen"] == alone["python one"]["seen"] != alone["python two"]["seen"]


# --- files that change ----------------------------------------------------------------------------------------------------------


def points_of(name):
    """A standard profile as lines of points [mm]."""
    profile = standard_profile(name)
    y = np.arange(profile.start + 1e-4, profile.stop - 1e-4, 1e-4)
    return "".join(f"{1e3 * a:.6f} {1e3 * b:.6f}\n" for a, b in zip(y, profile.height(y)))


CHANGES = {
    "cut": lambda path, text: path.write_text(text[:len(text) // 2]),
    "emptied": lambda path, text: path.write_text(""),
    "longer": lambda path, text: path.write_text(text + "80 0\n"),
    "rewritten": lambda path, text: (path.write_text(text[::-1]), os.utime(path, (1.0, 1.0))),
}


@pytest.mark.parametrize("moment", ["before", "after"])
@pytest.mark.parametrize("change", CHANGES)
def test_a_profile_that_changes_while_it_is_read_is_refused(tmp_path, monkeypatch, change, moment):
    """Between the opening and the reading, or between the reading and the end."""
    path, text = tmp_path / "rail.txt", points_of("UIC60")
    path.write_text(text)

    class Changing:
        def __init__(self, *arguments):
            self.file = open(*arguments)
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
    with pytest.raises(ValueError, match=f"^rail profile {re.escape(str(path))} changed while it was read; permitted are files "):
        Profile.from_file(path, "rail")
    monkeypatch.undo()
    path.write_text(text)
    assert Profile.from_file(path, "rail").kind == "rail"


@slow
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
    assert read == [str(path)] and starts == {"rail_profile": "rail.txt"} and profiles["rail.txt"].kind == "rail"


# --- states of the session ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("count", [500, pytest.param(20_000, marks=slow)])
def test_damaged_states_of_a_session_are_refused(count):
    """Those of the FMUs are in test_fmu.py and test_native_fmu.py."""
    one, other = (Session(tell=lambda sentence: None) for _ in range(2))
    for session in (one, other):
        session.start()
        session.set_reals([0, 1], [3e-3, 1e-3])
        session.step()
    for name, bad in damages(one.snapshot(), 3, count):
        with pytest.raises(StateRefused, match="the saved state .*; the present state is kept"):
            one.restore(bad)
            pytest.fail(name)
    for session in (one, other):
        session.set_reals([0], [6e-3])
    assert one.get_reals([REFERENCE["roll"]]) == other.get_reals([REFERENCE["roll"]]) and one.status == 0


# --- processes and threads beneath ------------------------------------------------------------------------------------------------


def contact_of(system, rows):
    """All outputs of rows that are evaluated one after the other, as a few bytes."""
    return hashlib.sha256(b"".join(system.evaluate(**row).values.tobytes() for row in rows)).digest()


@slow
@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_a_system_goes_on_in_other_processes(method):
    """One that has been used before: after a fork with all that it keeps, after a spawn made anew from its parameters."""
    system, rows = ContactSystem(rail="54E1"), poses(8)
    system.evaluate(2e-3)
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(method)) as pool:
        found = list(pool.map(contact_of, [system] * 4, [rows] * 4))
    assert set(found) == {contact_of(ContactSystem(rail="54E1"), rows)}


def test_a_system_goes_on_after_a_bare_fork():
    """In both processes, each with its own memory."""
    system, rows = ContactSystem(), poses(8)
    contact_of(system, rows[:4])
    inlet, outlet = os.pipe()
    if (child := os.fork()) == 0:
        os.write(outlet, contact_of(system, rows[4:]))
        os._exit(0)
    here, there = contact_of(system, rows[4:]), os.read(inlet, 100)
    os.close(inlet), os.close(outlet), os.waitpid(child, 0)
    assert here == there


ANSWERS = """
import hashlib, sys, warnings
import numpy as np
import wrcontact
warnings.simplefilter("ignore")
found = hashlib.sha256()
shifts = np.linspace(-7e-3, 7e-3, 41)
for options in ({}, {"contact_mode": "elastic", "normal_model": "analyn_strip"}, {"wheel": sys.argv[1]},
                {"wheel": sys.argv[1], "smoothing": 2e-5, "lateral_curvature": "smooth"}):
    found.update(wrcontact.ContactSystem(**options).evaluate_many(lateral_shift=shifts, yaw=2e-3).values.tobytes())
for shift in (0.0, 5.5e-3):
    found.update(wrcontact.ContactSystem(normal_model="halfspace", tolerance=0.02).evaluate(shift).values.tobytes())
print(found.hexdigest())
"""


@slow
def test_bits_do_not_depend_on_the_threads_of_blas(tmp_path):
    """Of measured profiles that are mended and smoothed, and of the half-space, which use scipy."""
    wheel, chance = tmp_path / "wheel.txt", np.random.default_rng(5)
    points = np.array([list(map(float, line.split())) for line in points_of("S1002").splitlines()])
    np.savetxt(wheel, points + [0.0, 5e-3] * chance.standard_normal(points.shape), fmt="%.6f")
    answers = set()
    for threads in ("1", "7"):
        limits = dict.fromkeys(("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"), threads)
        done = subprocess.run([sys.executable, "-c", ANSWERS, str(wheel)], env={**OUTSIDE, **limits}, text=True,
                              capture_output=True, timeout=300)
        assert done.returncode == 0, done.stderr
        answers.add(done.stdout)
    assert len(answers) == 1
