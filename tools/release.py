"""Build and try everything that a release consists of: ``python tools/release.py dist/release``.

Wheels for every platform, the source archive, the FMUs, a bill of materials, a list of licences, and the sums
of all of them.  docs/develop/releasing.md says how a release goes.
"""

import hashlib
import sys
import tempfile
from pathlib import Path
from typing import Annotated

import typer

sys.path.insert(0, str(Path(__file__).resolve().parent))
from releasing.bill import bill, libraries_of  # noqa: E402
from releasing.packages import (  # noqa: E402
    ROOT,
    ReleaseProblem,
    build_packages,
    try_kernels,
    try_packages,
)

import wrcontact  # noqa: E402
from wrcontact.fmu.build import built  # noqa: E402
from wrcontact.kernel.binding.files import PLATFORMS  # noqa: E402

SUMS = "SHA256SUMS"


def build_fmus(folder, platforms):
    """The FMUs of a release: a wheelset for FMI 2.0 and 3.0, one wheel likewise, and the one in Python."""
    names = ",".join(platforms)
    made = [
        *built(True, names, output=folder),
        *built(True, names, "right", output=folder),
        *built(False, None, output=folder),
    ]
    for fmu in made[:4]:
        if libraries_of(fmu) != set(platforms):
            raise ReleaseProblem(
                f"{fmu.name} has libraries for {', '.join(sorted(libraries_of(fmu)))}; "
                f"expected are {', '.join(platforms)}"
            )
    return made


def write_sums(folder):
    """Write the SHA-256 of every file in ``folder``, as ``sha256sum --check`` reads them."""
    files = sorted(file for file in folder.iterdir() if file.name != SUMS)
    lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in files]
    folder.joinpath(SUMS).write_text("".join(lines), encoding="utf-8", newline="\n")
    return files


def release(
    folder: Annotated[Path, typer.Argument(help="New or empty folder for the files of the release")],
    platforms: Annotated[str, typer.Option(help="Platforms, with commas, or all")] = "all",
    trial: Annotated[bool, typer.Option(help="Install and try what can run here")] = True,
):
    """Build and try everything that a release consists of."""
    names = list(PLATFORMS) if platforms == "all" else platforms.split(",")
    folder = folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    try:
        if any(folder.iterdir()):
            raise ReleaseProblem(f"{folder} is not empty; permitted is a new or an empty folder")
        if set(names) - set(PLATFORMS):
            raise ReleaseProblem(f"--platforms is {platforms}; permitted are {', '.join(PLATFORMS)} and all")
        if not Path(wrcontact.__file__).is_relative_to(ROOT):
            raise ReleaseProblem(
                f"wrcontact is that of {wrcontact.__file__}; permitted is an editable installation of {ROOT}"
            )
        with tempfile.TemporaryDirectory() as scratch:
            print(f"wrcontact {wrcontact.__version__} for {', '.join(names)}", flush=True)
            build_packages(folder, names, Path(scratch, "compiled"))
            build_fmus(folder, names)
            page, licences = bill(sorted(folder.iterdir()))
            folder.joinpath("wrcontact.cdx.json").write_text(page, encoding="utf-8", newline="\n")
            folder.joinpath("LICENCES.txt").write_text(licences, encoding="utf-8", newline="\n")
            if trial:
                print(*try_packages(folder, Path(scratch)), sep="\n", flush=True)
                print(try_kernels(folder, names, Path(scratch)))
        print(*(file.name for file in write_sums(folder)), SUMS, sep="\n")
    except ReleaseProblem as problem:
        print(f"release: {problem}", file=sys.stderr)
        raise typer.Exit(1) from None


if __name__ == "__main__":
    typer.run(release)
