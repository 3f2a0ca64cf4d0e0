"""The system with the half-space solver, and the independent program's track."""

import pytest

import wrcontact
from data import brute_force


@pytest.fixture(scope="module")
def system():
    return wrcontact.ContactSystem(normal_model="halfspace")


@pytest.fixture(scope="module")
def track():
    return brute_force.track()
