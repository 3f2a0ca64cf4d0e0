"""The check of the standard's pair, made once for a worker."""

import pytest

import wrcontact
from wrcontact import ContactSystem


@pytest.fixture(scope="module")
def standard():
    """The check of the pair and set-up that EN 15302 has a reference value for."""
    return wrcontact.check(ContactSystem(rail="60E1"))
