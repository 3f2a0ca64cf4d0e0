"""Poses and laws for tests of wear."""

from functools import cache

import numpy as np

import wrcontact
from tests.helpers.paths import ROOT

#: Constants that tests give to laws without defaults; as they are quoted in the literature.
ARCHARD = {
    "hardness": 3e9,
    "slow": 5e-4,
    "middle": 35e-4,
    "fast": 5e-4,
    "pressed": 350e-4,
    "first": 0.2,
    "second": 0.7,
    "share": 0.8,
}
BRITISH_RAIL = {
    "mild": 0.25e-12,
    "plateau": 25e-12,
    "steep": 1.19e-12,
    "offset": 154e-12,
    "first": 100.0,
    "second": 200.0,
}
ZOBORY = {"mild": 7e-10, "severe": 2.1e-9, "limit": 4e6}
MODELS = {"tangential_model": "strips", "normal_model": "analyn_strip", "wear_outputs": True}


@cache
def system():
    return wrcontact.ContactSystem(**MODELS)


@cache
def poses():
    """Inputs by name, and the share of the distance (60,)."""
    found = np.genfromtxt(ROOT / "data" / "wear_poses.csv", delimiter=",", names=True)
    inputs = {name: found[name] for name in found.dtype.names if name != "distance_share"}
    return inputs, found["distance_share"]


@cache
def table():
    return system().evaluate_many(**poses()[0])


def mirrored(inputs):
    """The same poses as they look in a mirror."""
    turned = {name: -inputs[name] for name in ("lateral_shift", "yaw", "track_curvature")}
    return {
        **inputs,
        **turned,
        "left_friction": inputs["right_friction"],
        "right_friction": inputs["left_friction"],
    }


def energy(power_density):
    """A law: 1e-9 kg for each joule of friction."""
    return 1e-9 * power_density
