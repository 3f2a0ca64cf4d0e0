"""Full and read-only disks: one sentence, and no half files."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from matplotlib.image import imread

from tests.helpers.command_line import OUTSIDE
from tests.helpers.faults import assert_files_are_whole, largest_file, needs_linux
from tests.helpers.fmus import needs_compiler
from wrcontact import ContactSystem
from wrcontact.fmu import build_fmu, native
from wrcontact.kernel.binding.compiler import zig_cache
from wrcontact.storage import atomic

pytestmark = needs_linux


@pytest.fixture
def refused(run):
    """The one sentence in which the command line refuses."""

    def refused(*words):
        code, out, err = run(*words)
        assert code in (1, 2) and out == "" and err.count("\n") == 1, (out, err)
        return err

    return refused


def test_a_full_disk_is_reported_in_one_sentence(tmp_path, refused):
    """A device that is always full, and a limit to the size of files."""
    picture = tmp_path / "picture.png"
    picture.symlink_to("/dev/full")
    assert refused("sweep", "--csv", "/dev/full") == "wrcontact: /dev/full: No space left on device\n"
    assert refused("plot", "--output", picture) == f"wrcontact: {picture}: No space left on device\n"
    picture.unlink()
    with largest_file(20_000):
        assert (
            refused("sweep", "--csv", tmp_path / "a.csv")
            == f"wrcontact: {tmp_path / 'a.csv'}: File too large\n"
        )
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def small_disk(tmp_path):
    """A disk of 300 kB."""
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=300k", "tmpfs", str(disk)], capture_output=True
    ).returncode:
        pytest.skip("this user may not mount a small disk")
    yield disk
    subprocess.run(["umount", "-l", str(disk)], check=True)


@pytest.mark.complete
@needs_compiler
def test_a_disk_that_is_too_small(tmp_path, small_disk, compiled):
    """For tables and FMUs, and for what a build and a demo unpack and compile meanwhile."""
    run = {"text": True, "capture_output": True, "env": OUTSIDE, "timeout": 300}
    command = [sys.executable, "-c", "from wrcontact.cli import main; main()"]
    for words, file in (
        (("sweep", "--step-mm", "0.01", "--csv", f"{small_disk}/a.csv"), f"{small_disk}/a.csv"),
        (("demo", "--output", small_disk), f"{small_disk}/WheelsetContact.fmu"),
    ):
        done = subprocess.run([*command, *map(str, words)], **run)
        assert done.returncode == 1 and done.stderr.endswith(
            f"wrcontact: {file}: No space left on device\n"
        ), done.stderr
        assert list(small_disk.iterdir()) == []
    with pytest.raises(OSError, match="No space left on device") as full:
        native.build_native_fmus(small_disk, cache=compiled)
    assert full.value.filename == f"{small_disk}/WheelsetContact_native_fmi2.fmu"
    assert list(small_disk.iterdir()) == []
    (small_disk / "fill").write_bytes(bytes(250_000))
    words = ["demo", "--output", str(tmp_path / "out")]
    done = subprocess.run([*command, *words], **{**run, "env": {**OUTSIDE, "TMPDIR": str(small_disk)}})
    last = done.stderr.splitlines()[-1]
    assert done.returncode == 1 and re.fullmatch(
        f"wrcontact: {small_disk}.*: No space left on device", last
    ), done.stderr
    assert "Traceback" not in done.stderr


#: For an administrator, who may write anywhere, without that right.
UNPRIVILEGED = () if os.geteuid() else ("setpriv", "--bounding-set", "-dac_override,-dac_read_search")


def is_bound(folder):
    """Whether a read-only folder is one for processes after UNPRIVILEGED."""
    folder.chmod(0o555)
    if UNPRIVILEGED and not shutil.which(UNPRIVILEGED[0]):
        return False
    return (
        subprocess.run([*UNPRIVILEGED, "touch", str(folder / "probe")], capture_output=True).returncode != 0
    )


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


@pytest.mark.complete
@needs_compiler
@pytest.mark.parametrize("what", ["native", "all"])
def test_read_only_installation_home_and_folder(tmp_path, read_only, compiled, what):
    """The package evaluates, draws and builds its FMUs; where it may not write, one sentence says so."""
    installed, home, closed = (tmp_path / name for name in ("installed", "home", "closed"))
    package = Path(atomic.__file__).parents[1]
    shutil.copytree(package, installed / "wrcontact", ignore=shutil.ignore_patterns("__pycache__"))
    if not (package / "fmu_src").is_dir():
        shutil.copytree(
            package.parent / "fmu_src", installed / "fmu_src", ignore=shutil.ignore_patterns("__pycache__")
        )
    home.mkdir(), closed.mkdir()
    [read_only(folder) for folder in (installed, home, closed)]
    environment = {
        **OUTSIDE,
        "PYTHONPATH": os.pathsep.join([str(installed), *sys.path[1:]]),
        "HOME": str(home),
    }
    for name in ("XDG_CACHE_HOME", "ZIG_GLOBAL_CACHE_DIR", "MPLCONFIGDIR"):
        environment.pop(name, None)

    def run(script):
        done = subprocess.run(
            [*UNPRIVILEGED, sys.executable, "-c", script],
            cwd=tmp_path,
            env=environment,
            text=True,
            capture_output=True,
            timeout=600,
        )
        assert "Traceback" not in done.stderr, done.stderr
        return done

    answer = run(
        "import wrcontact; print(wrcontact.__file__); print(wrcontact.ContactSystem().evaluate(1e-3).roll)"
    )
    file, roll = answer.stdout.split()
    assert Path(file).is_relative_to(installed) and float(roll) == ContactSystem().evaluate(1e-3).roll
    cache = None if what == "all" else str(compiled)
    run(f"from wrcontact.fmu.native import build_native_fmus; build_native_fmus('out', cache={cache!r})")
    if what == "all":  # zig compiles libraries of Windows into its new cache
        assert "no compiled kernel" not in run("from wrcontact.fmu import build_fmu; build_fmu('out')").stderr
    assert assert_files_are_whole(tmp_path / "out") == (3 if what == "all" else 2)
    command = "from wrcontact.cli import main; main({!r}.split(), prog_name='wrcontact')"
    assert run(command.format("plot --output plot.png")).returncode == 0
    assert imread(tmp_path / "plot.png").size
    for words, wanted in (
        ("sweep --csv closed/a.csv", "closed/a.csv"),
        ("plot --output closed/a.png", "closed/a.png"),
        ("figures --only 7.2 --output closed", "closed"),
    ):
        done = run(command.format(words))
        assert (
            done.returncode == 2 and done.stderr.splitlines()[-1] == f"wrcontact: {wanted}: Permission denied"
        ), done.stderr


def test_zig_has_a_cache_where_the_home_is_read_only(tmp_path, monkeypatch):
    """One that it shares with all that this process compiles; elsewhere its usual one."""
    for name in ("XDG_CACHE_HOME", "ZIG_GLOBAL_CACHE_DIR"):
        monkeypatch.delenv(name, raising=False)
    find = zig_cache.__wrapped__
    monkeypatch.setenv("HOME", str(tmp_path))
    assert find() == {}
    monkeypatch.setenv("HOME", "/dev/null")
    (folder,) = set(find().values())
    assert Path(folder).is_dir() and os.access(folder, os.W_OK)
    monkeypatch.setenv("ZIG_GLOBAL_CACHE_DIR", "/mine")
    assert find() == {}


@pytest.mark.full
@pytest.mark.parametrize("kind", ["python", pytest.param("native", marks=needs_compiler)])
def test_an_fmu_in_a_read_only_folder(tmp_path, request, read_only, kind):
    """Unpacked by somebody else, with no home and no folder for temporary files that can be written to."""
    import fmpy

    fmu = build_fmu(tmp_path / "fmu") if kind == "python" else request.getfixturevalue("fmus")[2]
    folder, home = tmp_path / "unpacked", tmp_path / "home"
    home.mkdir()
    fmpy.extract(str(fmu), unzipdir=str(folder))
    read_only(folder), read_only(home)
    script = (
        "import fmpy, sys; print(repr(fmpy.simulate_fmu(sys.argv[1], stop_time=1e-2, step_size=1e-3, "
        "start_values={'lateral_shift': 1e-3}, output=['roll', 'status'])[-1].tolist()), flush=True); "
        "import os; os._exit(0)"
    )
    environment = {**OUTSIDE, "HOME": str(home), "TMPDIR": str(home)}
    done = subprocess.run(
        [*UNPRIVILEGED, sys.executable, "-c", script, str(folder)],
        cwd=home,
        text=True,
        capture_output=True,
        env=environment,
    )
    assert done.returncode == 0, done.stderr
    _, roll, status = eval(done.stdout)
    assert status == 0 and roll == pytest.approx(ContactSystem().evaluate(1e-3).roll, abs=1e-12)
