"""Records of one strip for the kernel's functions of coupled strips, with the numbers that a test gives."""

import numpy as np

from wrcontact.kernel import layout
from wrcontact.kernel.creep import traction_integration


def open_march(**numbers):
    """A record StripIntegration, zero but for ``numbers`` by name."""
    found = layout.Work.at(np.zeros(layout.WORK_SIZE)).rolling.integration
    for name, value in numbers.items():
        setattr(found, name, value)
    return found


def open_marches_of(ratio):
    """The record StripIntegrations of a patch with this a/b, in which nothing is pushed."""
    found = layout.Work.at(np.zeros(layout.WORK_SIZE)).rolling.integrations
    traction_integration.open_integrations(found, ratio)
    return found


def pushes(plane, spinning, ratio, **numbers):
    """What both marches of a strip with the ``numbers`` lose per way, (3,) each, and the lag; by name."""
    one, integrations = open_march(**numbers), open_marches_of(ratio)
    traction_integration.set_pushes(one, integrations, 0, plane, spinning, ratio)
    parts = ("x", "y", "turn")
    return {
        name: np.array([getattr(integrations, f"{name}_{part}")[0] for part in parts])
        for name in ("push", "centre")
    } | {"lag": integrations.lag[0]}
