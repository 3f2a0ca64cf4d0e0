"""Pack the Python FMU with PythonFMU's runtime; the same sources give the same bytes.

Two FMUs in one process share Python's modules, and a module that is already loaded is used instead of the one
in the FMU. Therefore the package in an FMU has a name that contains a hash of everything packed. So each FMU
runs its own code, not that of another FMU and not that of an installed wrcontact.
"""

import sys
from pathlib import Path

import pythonfmu

from ..interface.variables import VARIABLES
from ..kernel.binding.compiler import LOADER_NAME, LOADER_PLATFORM, CompilerProblem, compile_loader
from ..kernel.binding.files import PLATFORMS, host_platform
from ..profiles.files import prepared_text
from ..storage.atomic import write_atomically
from ..version import __version__
from .archive import SOURCES, archive, chosen_starts, fingerprint, licence, problems_of
from .description import MODEL, model_description
from .documentation import about_python, documentation_page
from .online import kernel_libraries, online_files
from .terminals import terminals_and_icons

SLAVE = "wheelset_contact"
RUNTIME = Path(pythonfmu.__file__).parent
#: The package's ``__init__`` in an FMU.
LOADER = b'''"""wrcontact in an FMU, loaded completely: the folder may be deleted before the next instance is created."""

from .simulation import session
from .kernel.binding import library
from .kernel.binding.fixed_tables import fixed_tables
from .kernel.wheelset import step

library.default_kernel()
fixed_tables(True)
'''
#: Text of documentation/externalDependencies.txt, which FMI 2.0 requires.
DEPENDENCIES = b"""A Python of 3.10 or newer with numpy.

A host that is a Python uses itself.  On Linux another host needs libpython: the loader in this FMU takes the one
in the process, else the file that the environment variable WRCONTACT_LIBPYTHON names, else that of the first python3
in PATH, else any libpython3.*.so.1.0 that the system finds.  That Python must find numpy.  On Windows
PythonFMU's library needs python3.dll in PATH.
"""


def build_fmu(output="dist", wheel=None, rail=None, smoothing=None, settings=None):
    """Pack ``WheelsetContact.fmu`` into the folder ``output`` and return its path.

    Parameters
    ----------
    output : folder of the FMU, created if necessary.
    wheel, rail : file of a profile that is packed and becomes the default, a path or a
        :class:`~wrcontact.ProfileFile`; or a built-in name; or a pair (left, right) of these.
    smoothing : of measured points [m], as for :meth:`wrcontact.Profile.from_file`.
    settings : start values of inputs and of other parameters, by their names in the FMU; a compliant
        wheelset whose ``vertical_shift_input`` is not among them starts where it carries its load.

    Raises
    ------
    ValueError
        if a profile or a setting cannot be used; the sentence says why.
    """
    starts, profiles = chosen_starts(smoothing, settings, wheel_profile=wheel, rail_profile=rail)
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


def built(native, platforms, side=None, **chosen):
    """Build the FMUs and return their paths; ``platforms`` is "all", names with commas, or None, ``side``
    that of one wheel by itself or None, ``chosen`` the arguments of :func:`~wrcontact.fmu.build_fmu`."""
    from .native import build_native_fmus

    if not native:
        return [build_fmu(**chosen)]
    names = list(PLATFORMS) if platforms == "all" else platforms and platforms.split(",")
    one = {"side": side} if side else {}
    return build_native_fmus(**chosen, **one, platforms=names)


def runtime():
    """Entries of PythonFMU: its Python modules, and the libraries that an importer loads."""
    entries = {f"resources/pythonfmu/{file.name}": file.read_bytes() for file in RUNTIME.glob("*.py")}
    for library in RUNTIME.glob("resources/binaries/*/*"):
        entries[f"binaries/{library.parent.name}/{MODEL}{library.suffix}"] = library.read_bytes()
    place = f"binaries/{PLATFORMS[LOADER_PLATFORM].fmi2}"
    if loading := loader():
        entries[f"{place}/pythonfmu-export.so"] = entries[f"{place}/{MODEL}.so"]
        entries[f"{place}/{MODEL}.so"] = loading
    return entries


def loader():
    """The library that hosts on Linux load, which loads PythonFMU's (fmu_src/python/loader.c): compiled now, or
    as the installation compiled it; None, with a warning on the platform itself, if there is none."""
    try:
        return compile_loader(SOURCES / "python")
    except CompilerProblem:
        installed = Path(__file__).with_name(LOADER_NAME)
        if installed.is_file():
            return installed.read_bytes()
    if host_platform() == LOADER_PLATFORM:
        print(
            "WARNING: the FMU gets no loader, since there is no C compiler: it must be unpacked in a folder whose "
            "path has only letters of English, digits and - _ . /",
            file=sys.stderr,
        )
    return None


def runtime_platforms():
    """Names of the platforms for which PythonFMU has a library."""
    return [
        name
        for name, place in PLATFORMS.items()
        if RUNTIME.joinpath("resources", "binaries", place.fmi2).is_dir()
    ]


def package(starts):
    """Entries of wrcontact: the files that an FMU needs, with the start values of this FMU."""
    made = {"__init__.py": LOADER, "interface/starts.py": f"STARTS = {starts!r}\n".encode()}
    files = {**online_files(), **kernel_libraries(runtime_platforms()), **made}
    return {f"resources/wrcontact/{name}": content for name, content in files.items()}


def documentation(starts):
    """Entries of the documentation page, icon, terminals, external dependencies and licences."""
    page = documentation_page(__version__, model_description("", "", __version__, starts), about_python())
    entries = {
        "documentation/index.html": page.encode(),
        "documentation/externalDependencies.txt": DEPENDENCIES,
        **terminals_and_icons(2, [variable.name for variable in VARIABLES]),
    }
    texts = {"license": licence("wrcontact"), "pythonfmu": licence("pythonfmu")}
    return entries | {f"documentation/licenses/{name}.txt": text for name, text in texts.items() if text}


def sealed(contents, starts):
    """All entries, renamed with a hash of the contents, with the slave module and the model description."""
    slave = (SOURCES / f"{SLAVE}.py").read_text(encoding="utf-8")
    tool = f"wrcontact {__version__} with PythonFMU {pythonfmu.__version__}"
    seal = fingerprint(
        {**contents, "slave": slave.encode(), "description": model_description("", tool, __version__, starts)}
    )
    unique, module = f"wrcontact_{seal[:12]}", f"{SLAVE}_{seal[:12]}"
    entries = {
        name.replace("resources/wrcontact/", f"resources/{unique}/"): content
        for name, content in contents.items()
    }
    entries[f"resources/{module}.py"] = slave.replace("from wrcontact.", f"from {unique}.").encode()
    entries["resources/slavemodule.txt"] = module.encode()
    entries["modelDescription.xml"] = model_description(f"{{{seal[:32]}}}", tool, __version__, starts)
    return entries
