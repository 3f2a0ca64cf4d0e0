"""Packs the simulated wheelset into an FMU.

The sources of the FMU are in ``fmu_src``: inside this package's parent when wrcontact is installed, at the top of the
checkout otherwise.  Their modules are found as ``wrcontact.fmu.description`` and so on.
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
