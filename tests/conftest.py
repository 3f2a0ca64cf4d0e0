"""For all tests of a run: FMUs, compiled once, and the command line as a function."""

import os
import shutil
import subprocess

import pytest

from wrcontact.cli import main


@pytest.fixture(scope="session")
def compiled(tmp_path_factory):
    """Folder in which compiled sources are kept for the next FMU; all workers of a run have the same."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        return tmp_path_factory.getbasetemp().parent / "compiled"
    return tmp_path_factory.mktemp("compiled")


@pytest.fixture
def comma(tmp_path, monkeypatch):
    """Name of a locale whose decimals have a comma, known to processes that are started now."""
    if not shutil.which("localedef"):
        pytest.skip("localedef, which makes a locale with decimal commas, is not installed")
    source = tmp_path / "comma"
    source.write_text('LC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3;3\nEND LC_NUMERIC\n')
    subprocess.run(["localedef", "-c", "-i", str(source), "-f", "ANSI_X3.4-1968", str(tmp_path / "de_DE")],
                   capture_output=True)
    monkeypatch.setenv("LOCPATH", str(tmp_path))
    return "de_DE"


@pytest.fixture(scope="session")
def fmus(tmp_path_factory, compiled):
    """The native FMUs by version of FMI."""
    from wrcontact.fmu import native

    return dict(zip((2, 3), native.build_native_fmus(tmp_path_factory.mktemp("native"), cache=compiled)))


@pytest.fixture
def run(capsys):
    """Run the command line in this process: (exit code, standard output, error output)."""

    def run(*words):
        with pytest.raises(SystemExit) as ended:
            main([str(word) for word in words], prog_name="wrcontact")
        seen = capsys.readouterr()
        return ended.value.code or 0, seen.out, seen.err

    return run
