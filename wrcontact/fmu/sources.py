"""Where the sources of the FMUs are."""

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent.parent

#: Folder with the sources of the FMU.
SOURCES = next((folder for folder in (_PACKAGE / "fmu_src", _PACKAGE.parent / "fmu_src") if folder.is_dir()),
               None)
if SOURCES is None:
    raise ImportError(f"the sources of the FMU are missing: no fmu_src in {_PACKAGE} or {_PACKAGE.parent}")
