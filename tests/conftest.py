"""FMUs for all tests of a run: what the native ones are compiled of is compiled once."""

import os

import pytest


@pytest.fixture(scope="session")
def compiled(tmp_path_factory):
    """Folder in which compiled sources are kept for the next FMU; all workers of a run have the same."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        return tmp_path_factory.getbasetemp().parent / "compiled"
    return tmp_path_factory.mktemp("compiled")


@pytest.fixture(scope="session")
def fmus(tmp_path_factory, compiled):
    """The native FMUs by version of FMI."""
    from wrcontact.fmu import native

    return dict(zip((2, 3), native.build_native_fmus(tmp_path_factory.mktemp("native"), cache=compiled)))
