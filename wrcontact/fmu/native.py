"""Pack native FMUs: libraries from the kernel's generated C and the adapters in fmu_src/native, which need no Python."""

import tempfile
from pathlib import Path

import fmpy

from .. import ContactSystem, __version__
from ..profiles.catalogue import BUILDERS, standard_profile
from . import SOURCES, description, description3, native_model
from .build import archive, chosen_profiles, fingerprint, licence, problems_of, write_whole
from .compilers import PLATFORMS, compile_platform, host_platform
from .documentation import documentation_page
from .online import PACKAGE

NATIVE = SOURCES / "native"
MODEL = description.MODEL
HEADERS = {2: ("fmi2Functions.h", "fmi2FunctionTypes.h", "fmi2TypesPlatform.h"),
           3: ("fmi3Functions.h", "fmi3FunctionTypes.h", "fmi3PlatformTypes.h")}
DESCRIPTIONS = {2: description.model_description, 3: description3.model_description}


def build_native_fmus(output="dist", wheel=None, rail=None, platforms=None, smoothing=None):
    """Pack ``WheelsetContact_native_fmi2.fmu`` and ``..._fmi3.fmu`` into the folder ``output`` and return their paths.

    Parameters
    ----------
    output : folder of the FMUs; made if it is not there.
    wheel, rail : file of a profile that is packed and becomes the default, or a built-in name.
    platforms : names of :data:`~wrcontact.fmu.compilers.PLATFORMS`; None is this machine's.
    smoothing : of measured points [m], as for :meth:`wrcontact.Profile.from_file`.

    Raises
    ------
    ValueError
        when a profile cannot be used or a compiler fails; the sentence says why.
    """
    starts, profiles = packed_profiles(smoothing, wheel_profile=wheel, rail_profile=rail)
    with tempfile.TemporaryDirectory() as folder:
        made = {version: native_fmu(version, starts, profiles, platforms or [host_platform()], folder) for version in HEADERS}
    targets = []
    for version, data in made.items():
        targets.append(Path(output, f"{MODEL}_native_fmi{version}.fmu"))
        write_whole(targets[-1], data)
    return targets


def packed_profiles(smoothing=None, **chosen):
    """Start values of the profile parameters, and all profiles that can be chosen, by name."""
    starts, _ = chosen_profiles(smoothing, **chosen)
    profiles = {name: standard_profile(name) for name in BUILDERS}
    given = {parameter.removesuffix("_profile"): name for parameter, name in chosen.items() if name is not None}
    system = ContactSystem(**given, smoothing=smoothing)
    own = {"wheel_profile": system.wheel, "rail_profile": system.rail}
    return starts, {**profiles, **{name: own[parameter] for parameter, name in starts.items()}}


def native_fmu(version, starts, profiles, platforms, folder):
    """The archive of one version of FMI as bytes; ``folder`` is for scratch."""
    tool, units = f"wrcontact {__version__}, native", compiled_units(version)
    token = f"{{{fingerprint(described('', version, tool, starts, profiles))[:32]}}}"
    entries = described(token, version, tool, starts, profiles)
    contents = {name.removeprefix("sources/"): content for name, content in entries.items() if name.startswith("sources/")}
    entries["documentation/index.html"] = documentation_page(__version__, starts).encode()
    entries["documentation/licenses/license.txt"] = licence("wrcontact")
    entries["documentation/licenses/fmi.txt"] = headers_licence(contents[HEADERS[version][0]])
    for platform, library in libraries(contents, units, platforms, folder).items():
        place = PLATFORMS[platform]
        entries[f"binaries/{place.fmi2 if version == 2 else place.name}/{MODEL}{place.suffix}"] = library
    data = archive({name: content for name, content in entries.items() if content})
    problems = problems_of(data)
    if problems:
        raise ValueError(f"the FMU of FMI {version} would not be valid: " + " ".join(problems))
    return data


def described(token, version, tool, starts, profiles):
    """The model description and the sources."""
    units = compiled_units(version)
    entries = {f"sources/{name}": content for name, content in sources(version, token, starts, profiles).items()}
    if version == 3:
        entries["sources/buildDescription.xml"] = description3.build_description(units)
    return entries | {"modelDescription.xml": DESCRIPTIONS[version](token, tool, __version__, starts, units)}


def sources(version, token, starts, profiles):
    """Everything that the library is compiled from, by path."""
    headers = Path(fmpy.__file__).parent / "c-code"
    blocks = [(first, count) for _, first, count in description3.variable_blocks()]
    kernel = [file for folder in ("native", "generated") for file in sorted((PACKAGE / "kernel" / folder).glob("*.[ch]"))]
    adapters = [NATIVE / name for name in ("model.h", "wheelset.h", "wheelset.c", f"fmi{version}.c")]
    return {
        **{f"kernel/{file.parent.name}/{file.name}": file.read_bytes() for file in kernel},
        **{file.name: file.read_bytes() for file in adapters},
        **{name: (headers / name).read_bytes() for name in HEADERS[version]},
        "model_sizes.h": native_model.sizes_header(token, profiles, blocks).encode(),
        "model.c": native_model.model_code(starts, profiles, blocks).encode(),
    }


def compiled_units(version):
    """The sources that are compiled; all others are included by them."""
    return [f"fmi{version}.c", "wheelset.c", "model.c", "kernel/native/wrcontact_kernel.c", "kernel/native/wrcontact_prepare.c"]


def libraries(contents, units, platforms, folder):
    """The library of each platform as bytes, made in a scratch folder of its own inside ``folder``."""
    place = Path(tempfile.mkdtemp(dir=folder))
    write_sources(contents, place)
    return {platform: compile_platform(platform, place, units, MODEL, cache=Path(folder, "cache")) for platform in platforms}


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
    return text[start:text.index("*/", start)].encode()
