"""Archives of the closed loop, built once."""

import pytest

from examples.hunting_wheelset.coupling import build_wheelset
from tests.helpers.fmus import has_compiler


@pytest.fixture(scope="session")
def archives(tmp_path_factory, request):
    """Contact and wheelset."""
    if not has_compiler():
        pytest.skip("a native FMU is built by a C compiler, and none is here")
    return request.getfixturevalue("fmus")[2], build_wheelset(tmp_path_factory.mktemp("wheelset"))
