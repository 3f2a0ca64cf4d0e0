"""Packs wrcontact into FMUs: the Python FMU in build.py, the native ones in native.py.

What is packed as it is (the slave, the native FMUs' C, the icon) lies in the folder ``fmu_src``, whose files
are read and never imported.
"""

from .archive import SOURCES
from .build import build_fmu

__all__ = ["SOURCES", "build_fmu"]
