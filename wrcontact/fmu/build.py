"""Pack an FMU with PythonFMU's runtime: one archive from the sources, the same bytes for the same sources.

Two FMUs in one process share Python's modules, and a module that is already there wins over the one in an FMU.  So the
package goes in under a name that holds a hash of everything packed: an FMU runs its own code, never a neighbour's and
never the one that the host has installed.
"""

import argparse
import hashlib
import io
import sys
import zipfile
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

import pythonfmu

from .. import ContactSystem, __version__
from ..interface.variables import VARIABLES
from ..kernel.binding.platforms import PLATFORMS
from ..profiles.catalogue import BUILDERS
from ..profiles.files import prepared_text
from ..profiles.remarks import remarks_in_lines
from ..storage.atomic import sentence_of, write_atomically
from . import SOURCES
from .compilers import has_zig
from .description import MODEL, model_description
from .documentation import about_python, documentation_page
from .online import PACKAGE, kernel_libraries, online_files
from .terminals import terminals_and_icons

SLAVE = "wheelset_contact"
RUNTIME = Path(pythonfmu.__file__).parent
#: The package's ``__init__`` in an FMU.
LOADER = b'''"""wrcontact as packed in an FMU, loaded whole: the folder may be gone when the next instance is made."""

from .interface import session
from .kernel.binding import library
from .kernel.wheelset import step

library.default_kernel()
'''
#: What FMI 2.0 wants to be told about that.
DEPENDENCIES = b"A Python of 3.10 or newer with numpy, found by the library of PythonFMU in this FMU.\n"
#: Every entry of the archive carries this time, so that the hour of the build does not show.
TIMESTAMP = (1980, 1, 1, 0, 0, 0)


def build_fmu(output="dist", wheel=None, rail=None, smoothing=None):
    """Pack ``WheelsetContact.fmu`` into the folder ``output`` and return its path.

    Parameters
    ----------
    output : folder of the FMU; made if it is not there.
    wheel, rail : file of a profile that is packed and becomes the default, or a built-in name.
    smoothing : of measured points [m], as for :meth:`wrcontact.Profile.from_file`.

    Raises
    ------
    ValueError
        when a profile cannot be used; the sentence says why.
    """
    starts, profiles = chosen_profiles(smoothing, wheel_profile=wheel, rail_profile=rail)
    files = {f"resources/{name}": prepared_text(profile).encode() for name, profile in profiles.items()}
    contents = {**runtime(), **documentation(starts), **files, **package(starts)}
    data = archive(sealed(contents, starts))
    problems = problems_of(data)
    if problems:
        raise ValueError("the FMU would not be valid: " + " ".join(problems))
    target = Path(output, f"{MODEL}.fmu")
    target.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(target, data)
    return target


def chosen_profiles(smoothing=None, **chosen):
    """Start values of the profile parameters, and the profiles of the files among them, each read once, by file name.

    Files go in prepared, under their own names: reading points takes scipy, which an FMU must do without.
    """
    starts = {parameter: str(name) for parameter, name in chosen.items() if name is not None}
    given = {parameter.removesuffix("_profile"): name for parameter, name in starts.items()}
    system = ContactSystem(**given, smoothing=smoothing)
    profiles = {"wheel_profile": system.wheel, "rail_profile": system.rail}
    files = {parameter: Path(name).name for parameter, name in starts.items() if name not in BUILDERS}
    if len(set(files.values())) < len(files):
        raise ValueError(f"wheel and rail profile have one file name, {files['wheel_profile']}; rename one")
    return {**starts, **files}, {file: profiles[parameter] for parameter, file in files.items()}


def runtime():
    """PythonFMU: its Python side, and the libraries that an importer loads."""
    entries = {f"resources/pythonfmu/{file.name}": file.read_bytes() for file in RUNTIME.glob("*.py")}
    for library in RUNTIME.glob("resources/binaries/*/*"):
        entries[f"binaries/{library.parent.name}/{MODEL}{library.suffix}"] = library.read_bytes()
    return entries


def runtime_platforms():
    """Names of the platforms that PythonFMU has libraries for."""
    return [name for name, place in PLATFORMS.items() if RUNTIME.joinpath("resources", "binaries", place.fmi2).is_dir()]


def package(starts):
    """What wrcontact needs online, with the start values of this FMU."""
    made = {"__init__.py": LOADER, "interface/starts.py": f"STARTS = {starts!r}\n".encode()}
    files = {**online_files(), **kernel_libraries(runtime_platforms()), **made}
    return {f"resources/wrcontact/{name}": content for name, content in files.items()}


def documentation(starts):
    """The page about the model, the icon and the terminals, what the FMU needs, and the licences."""
    page = documentation_page(__version__, model_description("", "", __version__, starts), about_python())
    entries = {"documentation/index.html": page.encode(), "documentation/externalDependencies.txt": DEPENDENCIES,
               **terminals_and_icons(2, [variable.name for variable in VARIABLES])}
    texts = {"license": licence("wrcontact"), "pythonfmu": licence("pythonfmu")}
    return entries | {f"documentation/licenses/{name}.txt": text for name, text in texts.items() if text}


def licence(name):
    """Licence text of an installed distribution, or of the checkout; None where there is none."""
    try:
        files = [Path(str(file.locate())) for file in distribution(name).files or () if file.name.startswith("LICENSE")]
    except PackageNotFoundError:
        files = []
    if name == "wrcontact":
        files.append(PACKAGE.parent / "LICENSE")
    return next((file.read_bytes() for file in files if file.is_file()), None)


def sealed(contents, starts):
    """The entries under names that no other contents have, with the slave and the model description."""
    slave = (SOURCES / f"{SLAVE}.py").read_text(encoding="utf-8")
    tool = f"wrcontact {__version__} with PythonFMU {pythonfmu.__version__}"
    seal = fingerprint({**contents, "slave": slave.encode(), "description": model_description("", tool, __version__, starts)})
    unique, module = f"wrcontact_{seal[:12]}", f"{SLAVE}_{seal[:12]}"
    entries = {name.replace("resources/wrcontact/", f"resources/{unique}/"): content for name, content in contents.items()}
    entries[f"resources/{module}.py"] = slave.replace("from wrcontact.", f"from {unique}.").encode()
    entries["resources/slavemodule.txt"] = module.encode()
    entries["modelDescription.xml"] = model_description(f"{{{seal[:32]}}}", tool, __version__, starts)
    return entries


def fingerprint(entries):
    """SHA-256 over all names and contents, as hexadecimal digits."""
    digest = hashlib.sha256()
    for name, content in sorted(entries.items()):
        digest.update(f"{name}\0{len(content)}\0".encode() + content)
    return digest.hexdigest()


def archive(entries):
    """The zip archive of the entries as bytes: the same for the same entries."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as file:
        for name, content in sorted(entries.items()):
            entry = zipfile.ZipInfo(name, TIMESTAMP)
            entry.compress_type, entry.create_system, entry.external_attr = zipfile.ZIP_DEFLATED, 3, 0o100644 << 16
            file.writestr(entry, content)
    return stream.getvalue()


def problems_of(data):
    """What fmpy finds wrong with the archive ``data``; an empty list is a valid FMU."""
    from fmpy.validation import validate_fmu

    return validate_fmu(io.BytesIO(data))


def main(arguments=None):
    """The command line of build_fmu.py; returns the exit code."""
    parser = argparse.ArgumentParser(prog="build_fmu.py", description="Pack the FMU of a wheelset on track and print its path.")
    parser.add_argument("--output", metavar="DIR", default="dist", help="folder of the FMU (default: dist)")
    for kind in ("wheel", "rail"):
        meaning = f"{kind} profile to pack and use by default: a file of points in mm, or a built-in name"
        parser.add_argument(f"--{kind}", metavar="FILE", help=meaning)
    parser.add_argument("--smoothing-um", metavar="NUMBER", type=float, help="how far the curve may keep from measured "
                        "points, in the mean of squares (default: as far as their noise; 0: through every point)")
    parser.add_argument("--native", action="store_true",
                        help="pack two FMUs that need no Python instead, for FMI 2.0 and FMI 3.0")
    names = ", ".join(PLATFORMS)
    parser.add_argument("--platforms", metavar="NAME[,NAME]", help="whose libraries go into the native FMUs: this machine's "
                        f"by default, or any of {names}, or all; others than this machine's take ziglang")
    chosen = vars(parser.parse_args(arguments))
    native, platforms = chosen.pop("native"), chosen.pop("platforms")
    if platforms and not native:
        parser.error("--platforms belongs to --native")
    smoothing = chosen.pop("smoothing_um")
    chosen["smoothing"] = None if smoothing is None else 1e-6 * smoothing
    if has_zig():
        print("compiling with ziglang; the first time for a platform takes up to two minutes", file=sys.stderr)
    try:
        with remarks_in_lines("build_fmu.py"):
            print(*_built(native, platforms, chosen), sep="\n")
    except (ValueError, OSError) as problem:
        print(f"build_fmu.py: {sentence_of(problem) if isinstance(problem, OSError) else problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("build_fmu.py: interrupted; an FMU is whole, or as it was before", file=sys.stderr)
        return 130
    return 0


def _built(native, platforms, chosen):
    """Paths of the FMUs that were asked for."""
    if not native:
        return [build_fmu(**chosen)]
    from .native import build_native_fmus

    names = list(PLATFORMS) if platforms == "all" else platforms and platforms.split(",")
    return build_native_fmus(**chosen, platforms=names)
