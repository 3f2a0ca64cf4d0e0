"""Archives of the closed loop, built once: cones on UIC60, and S1002."""

import pytest

from examples.hunting_wheelset.coupling import build
from examples.hunting_wheelset.profiles import cone_wheel
from tests.helpers.fmus import has_compiler


@pytest.fixture(scope="session")
def cone_file(tmp_path_factory):
    return cone_wheel(tmp_path_factory.mktemp("cone"))


@pytest.fixture(scope="session")
def cones(tmp_path_factory, cone_file, compiled):
    """Contact of cones 1:20, and wheelset."""
    if not has_compiler():
        pytest.skip("a native FMU is built by a C compiler, and none is here")
    return build(tmp_path_factory.mktemp("cones"), wheel=cone_file, cache=compiled)


@pytest.fixture(scope="session")
def s1002(fmus, cones):
    """Contact of S1002 on UIC60, and the same wheelset."""
    return fmus[2], cones[1]
