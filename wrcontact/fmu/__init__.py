"""Packs wrcontact into FMUs.

The sources of the FMUs are in ``fmu_src``: beside this package when wrcontact is installed, otherwise at the
top of the checkout.  Its modules are imported as ``wrcontact.fmu.description`` and so on.
"""

from .sources import SOURCES

__path__.append(str(SOURCES))

from .build import build_fmu  # noqa: E402  it imports modules from there

__all__ = ["SOURCES", "build_fmu"]
