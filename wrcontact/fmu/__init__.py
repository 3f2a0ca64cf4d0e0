"""Packs wrcontact into FMUs.

The sources of the FMUs are in ``fmu_src``: beside this package when wrcontact is installed, otherwise at the top of the checkout.
Its modules are imported as ``wrcontact.fmu.description`` and so on.
"""

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent.parent

#: Folder with the sources of the FMU.
SOURCES = next((folder for folder in (_PACKAGE / "fmu_src", _PACKAGE.parent / "fmu_src") if folder.is_dir()), None)
if SOURCES is None:
    raise ImportError(f"the sources of the FMU are missing: no fmu_src in {_PACKAGE} or {_PACKAGE.parent}")
__path__.append(str(SOURCES))

from .build import build_fmu  # noqa: E402

__all__ = ["SOURCES", "build_fmu"]
