"""Pack native FMUs: libraries from the kernel's generated C and the adapters in fmu_src/native, which need no
Python."""

import importlib.util
import os
import tempfile
from pathlib import Path

import fmpy

from ..interface.variables import PLACE, REFERENCE, VARIABLES
from ..kernel.binding.compiler import FMU_UNITS, KEPT, compile_platform
from ..kernel.binding.files import PLATFORMS, host_platform
from ..profiles.catalogue import standard_profile
from ..profiles.standards import names
from ..progress import tracked
from ..storage.atomic import write_atomically
from ..version import __version__
from . import description, description3, native_model
from .archive import SOURCES, archive, chosen_starts, fingerprint, licence, problems_of
from .documentation import about_native, documentation_page
from .online import PACKAGE
from .terminals import terminals_and_icons
from .variants import WHEELSET, single_wheel

NATIVE = SOURCES / "native"
HIDDEN = ("-DWRCONTACT_EXPORT=",)  # the kernel's own functions stay inside
HEADERS = {
    2: ("fmi2Functions.h", "fmi2FunctionTypes.h", "fmi2TypesPlatform.h"),
    3: ("fmi3Functions.h", "fmi3FunctionTypes.h", "fmi3PlatformTypes.h"),
}
DESCRIPTIONS = {2: description.model_description, 3: description3.model_description}


def build_native_fmus(
    output="dist", wheel=None, rail=None, platforms=None, cache=None, smoothing=None, settings=None, side=None
):
    """Pack ``WheelsetContact_native_fmi2.fmu`` and ``..._fmi3.fmu`` into the folder ``output`` and return
    their paths; those of one wheel are called ``WheelContact_...``.

    Parameters
    ----------
    output : folder of the FMUs; made if it is not there.
    wheel, rail : file of a profile that is packed and becomes the default, a path or a
        :class:`~wrcontact.ProfileFile`; or a built-in name; or a pair (left, right) of these.
    platforms : names of :data:`~wrcontact.kernel.platforms.PLATFORMS`; None is this machine's.
    cache : folder in which compiled sources are kept for the next FMUs; None is the one that
        WRCONTACT_COMPILED names, and keeps nothing without it.
    smoothing : of measured points [m], as for :meth:`wrcontact.Profile.from_file`.
    settings : start values of inputs and of other parameters, by their names in the FMU; a compliant
        wheelset or wheel whose ``vertical_shift_input`` is not among them starts where it carries its load.
    side : None for a wheelset; "right" or "left" for one wheel by itself, on this rail.

    Raises
    ------
    ValueError
        when a profile or a setting cannot be used or a compiler fails; the sentence says why.
    """
    variant = single_wheel(side) if side else WHEELSET
    starts, profiles = packed_profiles(
        smoothing, variant.starts(settings), variant.side, wheel_profile=wheel, rail_profile=rail
    )
    variant.check(starts)
    with tempfile.TemporaryDirectory() as folder:
        platforms = platforms or [host_platform()]
        cache = cache or os.environ.get(KEPT) or Path(folder, "cache")
        made = {
            version: native_fmu(version, starts, profiles, platforms, folder, cache, variant)
            for version in tracked(HEADERS, "packing the native FMUs")
        }
    Path(output).mkdir(parents=True, exist_ok=True)
    targets = {
        Path(output, f"{variant.model}_native_fmi{version}.fmu"): data for version, data in made.items()
    }
    for target, data in targets.items():
        write_atomically(target, data)
    return list(targets)


def packed_profiles(smoothing=None, settings=None, side="", **chosen):
    """Start values of parameters and inputs, and all profiles that can be chosen, by name: those of the
    catalogue, of EN 13715 the designations that are chosen here, and files."""
    starts, own = chosen_starts(smoothing, settings, side, **chosen)
    chosen = [name for key, name in starts.items() if key.endswith("_profile") and name and name not in own]
    known = dict.fromkeys((*names("wheel"), *names("rail"), *chosen))
    return starts, {**{name: standard_profile(name) for name in known}, **own}


def native_fmu(version, starts, profiles, platforms, folder, cache, variant):
    """The archive of one version of FMI as bytes; ``folder`` is for scratch, ``cache`` for compiled
    sources."""
    entries = uncompiled(version, starts, profiles, platforms, variant)
    contents = {
        name.removeprefix("sources/"): content
        for name, content in entries.items()
        if name.startswith("sources/")
    }
    made = libraries(contents, compiled_units(version), variant.model, platforms, folder, cache)
    for platform, library in made.items():
        place = PLATFORMS[platform]
        name = place.fmi2 if version == 2 else place.name
        entries[f"binaries/{name}/{variant.model}{place.suffix}"] = library
    data = archive(entries)
    problems = problems_of(data)
    if problems:
        raise ValueError(f"the FMU of FMI {version} would not be valid: " + " ".join(problems))
    return data


def uncompiled(version, starts, profiles, platforms, variant=WHEELSET):
    """Every entry of the archive but the libraries for ``platforms``."""
    tool = f"wrcontact {__version__}, native"
    token = f"{{{fingerprint(described('', version, tool, starts, profiles, variant))[:32]}}}"
    entries = described(token, version, tool, starts, profiles, variant)
    about = about_native(version, platforms, profiles)
    entries["documentation/index.html"] = documentation_page(
        __version__, entries["modelDescription.xml"], about
    ).encode()
    licences = {
        "license": licence("wrcontact"),
        "fmi": headers_licence(entries[f"sources/{HEADERS[version][0]}"]),
        "mingw-w64": windows_licence(platforms),
    }
    entries |= {f"documentation/licenses/{name}.txt": text for name, text in licences.items() if text}
    return entries | terminals_and_icons(version, variable_names(version), variant)


def described(token, version, tool, starts, profiles, variant):
    """The model description and the sources."""
    units = compiled_units(version)
    entries = {
        f"sources/{name}": content
        for name, content in sources(version, token, starts, profiles, variant).items()
    }
    if version == 3:
        entries["sources/buildDescription.xml"] = description3.build_description(units, variant)
    page = DESCRIPTIONS[version](token, tool, __version__, starts, units, variant)
    return entries | {"modelDescription.xml": page}


def sources(version, token, starts, profiles, variant=WHEELSET):
    """Everything that the library is compiled from, by path."""
    headers = Path(fmpy.__file__).parent / "c-code"
    blocks = blocks_of(version, variant)
    kernel = [
        file
        for folder in ("native", "generated")
        for file in sorted((PACKAGE / "kernel" / folder).glob("*.[ch]"))
        if "jacobian" not in file.name
    ]
    adapters = [file for file in sorted(NATIVE.glob("*.[ch]")) if serves(file, version)]
    return {
        **{f"kernel/{file.parent.name}/{file.name}": file.read_bytes() for file in kernel},
        **{file.name: file.read_bytes() for file in adapters},
        **{name: (headers / name).read_bytes() for name in HEADERS[version]},
        "model_sizes.h": native_model.sizes_header(blocks, variant).encode(),
        "model.c": native_model.model_code(token, starts, profiles, blocks, variant).encode(),
    }


def blocks_of(version, variant=WHEELSET):
    """(first, run) of every value reference from 0 on, as in model.h: RETIRED where there is no variable."""
    found = {block.reference: (block.first, block.run) for block in description3.variable_blocks(variant)}
    if version == 2:
        found = {
            REFERENCE[name]: (place, description3.SINGLE)
            for name, place in PLACE.items()
            if variant.name(name)
        }
    nothing = description3.RETIRED, description3.SINGLE
    return [found.get(reference, nothing) for reference in range(max(found) + 1)]


def variable_names(version):
    """Names of the variables in one version of FMI."""
    if version == 2:
        return [variable.name for variable in VARIABLES]
    return [name for name, *_ in description3.variable_blocks()]


def serves(file, version):
    """Whether a hand-written C file belongs to one version of FMI: all do but the other version's own."""
    return not file.name.startswith(f"fmi{5 - version}")


def compiled_units(version):
    """The sources that are compiled; all others are included by them."""
    adapters = [file.name for file in sorted(NATIVE.glob("*.c")) if serves(file, version)]
    return [*adapters, "model.c", *FMU_UNITS]


def libraries(contents, units, name, platforms, folder, cache):
    """The library ``name`` of each platform as bytes, made in a scratch folder of its own inside
    ``folder``."""
    place = Path(tempfile.mkdtemp(dir=folder))
    write_sources(contents, place)

    def compiled(platform):
        return compile_platform(
            platform,
            place,
            units,
            name,
            HIDDEN,
            cache,
            lambda made, total: tracked(made, f"compiling for {platform}", total),
        )

    return {platform: compiled(platform) for platform in tracked(platforms, "platforms")}


def write_sources(contents, folder):
    """Write ``contents`` by their paths into a folder."""
    for name, content in contents.items():
        file = Path(folder, name)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)


def headers_licence(header):
    """The licence of the FMI headers, which stands in each of them."""
    text = header.decode()
    start = text.index("Copyright")
    return text[start : text.index("*/", start)].encode()


def windows_licence(platforms):
    """The licence of mingw-w64, whose start-up code ziglang links into libraries for Windows; None where
    there is none."""
    compiler = importlib.util.find_spec("ziglang")
    if "x86_64-windows" not in platforms or not compiler:
        return None
    return (Path(compiler.origin).parent / "lib" / "libc" / "mingw" / "COPYING").read_bytes()
