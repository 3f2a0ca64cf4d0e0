"""For all tests of a run: their tiers, FMUs, compiled once, and the command line as a function."""

import os
import shutil
import subprocess

import pytest

from tests.helpers.kept import cache_folder, kept_fmus
from tests.helpers.paths import ROOT, TESTS
from tests.helpers.skips import unlisted
from tests.helpers.turns import changed_today, out_of_turn
from wrcontact.cli import main
from wrcontact.kernel.binding.compiler import KEPT

#: Rooms whose tests are ``full``, except those that are marked ``check``.
FULL_ROOMS = ("benchmarks", "faults", "fmu", "halfspace", "loop", "data", "study", "sweeps")

#: Rooms of which the cases of all tests take turns: those of programs that stand beside the kernel.
TURNING_ROOMS = ("halfspace", "study")


def room_of(path):
    return path.relative_to(TESTS).parts[0] if TESTS in path.parents else ""


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_collection_modifyitems(config, items):
    for item in items:
        if room_of(item.path) in FULL_ROOMS and not item.get_closest_marker("check"):
            item.add_marker(pytest.mark.full)
        if room_of(item.path) in TURNING_ROOMS and not item.get_closest_marker("turns"):
            item.add_marker(pytest.mark.turns(2))
    yield  # now the tests of other tiers are gone
    turn = os.environ.get("WRCONTACT_TURN")
    if turn:
        out = set(out_of_turn(items, int(turn), ROOT, changed_today()))
        config.hook.pytest_deselected(items=list(out))
        items[:] = [item for item in items if item not in out]


def pytest_sessionfinish(session):
    """Fail a run of .ci/run that has skipped a test which is not to be skipped."""
    writer = session.config.pluginmanager.get_plugin("terminalreporter")
    if os.environ.get("WRCONTACT_SKIPS") == "listed" and writer:  # workers have no writer
        for line in unlisted(writer.stats.get("skipped", [])):
            writer.write_line(f"\nskipped, and not on the list in tests/helpers/skips.py: {line}", red=True)
            session.exitstatus = session.exitstatus or pytest.ExitCode.TESTS_FAILED


@pytest.fixture(scope="session")
def cache(tmp_path_factory):
    """Folder of what is kept from run to run, the same for all workers."""
    run = tmp_path_factory.getbasetemp()
    return cache_folder(run.parent if "PYTEST_XDIST_WORKER" in os.environ else run)


@pytest.fixture(scope="session", autouse=True)
def compiled(cache):
    """Folder in which compiled sources are kept, by this process and by those that it starts."""
    os.environ[KEPT] = str(cache / "compiled")
    yield cache / "compiled"
    del os.environ[KEPT]


@pytest.fixture
def comma(tmp_path, monkeypatch):
    """Name of a locale whose decimals have a comma, known to processes that are started now."""
    if not shutil.which("localedef"):
        pytest.skip("localedef, which makes a locale with decimal commas, is not installed")
    source = tmp_path / "comma"
    source.write_text('LC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3;3\nEND LC_NUMERIC\n')
    subprocess.run(
        ["localedef", "-c", "-i", str(source), "-f", "ANSI_X3.4-1968", str(tmp_path / "de_DE")],
        capture_output=True,
    )
    monkeypatch.setenv("LOCPATH", str(tmp_path))
    return "de_DE"


@pytest.fixture(scope="session")
def kept(tmp_path_factory, cache, compiled):
    """FMUs of a maker with chosen profiles: ``kept("native", wheel=file)``."""
    return lambda maker, **chosen: kept_fmus(cache, tmp_path_factory.mktemp(maker), maker, **chosen)


@pytest.fixture(scope="session")
def fmus(kept):
    """The native FMUs by version of FMI."""
    return dict(zip((2, 3), kept("native")))


@pytest.fixture(scope="session")
def fmu(kept):
    """The Python FMU."""
    return kept("python")[0]


@pytest.fixture
def run(capsys):
    """Run the command line in this process: (exit code, standard output, error output)."""

    def run(*words):
        with pytest.raises(SystemExit) as ended:
            main([str(word) for word in words], prog_name="wrcontact")
        seen = capsys.readouterr()
        return ended.value.code or 0, seen.out, seen.err

    return run
