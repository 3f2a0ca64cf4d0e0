"""What is inside a release, with its licences: a bill of materials in CycloneDX, and the same as text."""

import json
import re
import tarfile
import zipfile
from dataclasses import dataclass
from functools import cache
from importlib.metadata import PackageNotFoundError, distribution, version
from pathlib import Path

from packaging.requirements import Requirement

import wrcontact
from wrcontact.fmu.native import HEADERS
from wrcontact.kernel.binding.files import PLATFORMS

from .packages import ROOT, ReleaseProblem

#: Folders and endings of libraries, as they stand in archives.
BINARIES = r"binaries/[\w-]+/[\w-]+\.(so|dll|dylib)"
KERNELS = r"(resources/wrcontact_\w+|wrcontact)/kernel/_wrcontact_kernel-[\w-]+\.(so|dll|dylib)"
LOADERS = r"wrcontact/fmu/_wrcontact_loader-[\w-]+\.so"
#: What the builds make: descriptions, pages, texts of licences, tables of a model, metadata, libraries.
MADE = re.compile(
    "|".join(
        (
            r"modelDescription\.xml",
            r"documentation/(index\.html|externalDependencies\.txt|licenses/[\w-]+\.txt)",
            r"terminalsAndIcons/(terminalsAndIcons\.xml|icon\.(png|svg))",
            r"(icon|model)\.(png|svg)",
            r"sources/(model\.c|model_sizes\.h|buildDescription\.xml)",
            r"resources/slavemodule\.txt",
            r"resources/wheelset_contact_\w+\.py",
            r"resources/wrcontact_\w+/(__init__|interface/starts)\.py",
            r"wrcontact-[\w.]+\.dist-info/.*",
            r"(PKG-INFO|setup\.cfg)",
            r"wrcontact\.egg-info/.*",
            BINARIES,
            KERNELS,
            LOADERS,
        )
    )
)
#: Words of licences' texts, of packages that state none in their metadata.
WORDS = (
    ("2-clause bsd", "BSD-2-Clause"),
    ("3-clause bsd", "BSD-3-Clause"),
    ("mit license", "MIT"),
    ("apache license, version 2", "Apache-2.0"),
)


@dataclass(frozen=True)
class Part:
    """Something of others: name, version or "", licence by SPDX, what of it is there, and ``places``: which
    entries of which archives have it, pairs of regular expressions for whole names."""

    name: str
    version: str
    licence: str
    what: str
    places: tuple
    kind: str = "library"

    def entries(self, archive, names):
        """Those of the ``names`` in an ``archive`` that have it."""
        chosen = [entry for pattern, entry in self.places if re.fullmatch(pattern, archive)]
        return [name for name in names if any(re.fullmatch(entry, name) for entry in chosen)]


def parts():
    """Every :class:`Part` that may be in a release."""
    native, python, source = r"Wheel\w+_native_\w+\.fmu", r"WheelsetContact\.fmu", r".*\.tar\.gz"
    compiled = ((native, BINARIES), (python, KERNELS), (r".*\.whl", rf"({KERNELS}|{LOADERS})"))
    return (
        *(
            Part(
                f"FMI {number}.0 headers",
                f"{number}.0",
                "BSD-2-Clause",
                "declarations of FMI's functions",
                ((native, "sources/(" + "|".join(map(re.escape, names)) + ")"),),
            )
            for number, names in HEADERS.items()
        ),
        Part(
            "PythonFMU",
            version("pythonfmu"),
            "MIT",
            "the part of an FMU that starts Python",
            ((python, rf"resources/pythonfmu/\w+\.py|{BINARIES}"),),
        ),
        Part(
            "mingw-w64",
            "",
            "ZPL-2.1",
            "start-up code in libraries for Windows",
            tuple((archive, rf"(?=.*(win64|windows)){entry}") for archive, entry in compiled),
        ),
        Part("compiler-rt", "", "MIT", "helpers of the compiler in libraries that zig links", compiled),
        Part(
            "benchmark of EN 15302",
            "2021",
            "MIT",
            "tables of the standard, transcribed by B_ECC",
            ((source, r"data/en15302/\w+\.csv"),),
            "data",
        ),
        Part(
            "reference output of CONTACT",
            "25.2",
            "Apache-2.0",
            "case A-2.2 of the Manchester benchmark",
            ((source, r"data/manchester_a22_\w+\.csv"),),
            "data",
        ),
    )


def entries_of(archive):
    """{name: content} of the files in a wheel, an FMU or a source archive, without its outer folder."""
    if archive.name.endswith(".tar.gz"):
        with tarfile.open(archive) as packed:
            return {
                member.name.partition("/")[2]: packed.extractfile(member).read()
                for member in packed.getmembers()
                if member.isfile()
            }
    with zipfile.ZipFile(archive) as packed:
        return {name: packed.read(name) for name in packed.namelist() if not name.endswith("/")}


@cache
def own_contents():
    """Contents of the checkout's own files."""
    folders = (
        "wrcontact",
        "fmu_src",
        "build_hooks",
        "tools",
        "tests",
        "docs",
        "examples",
        "benchmarks",
        "data",
    )
    files = [path for folder in folders for path in (ROOT / folder).rglob("*") if path.is_file()]
    return {path.read_bytes() for path in (*files, *(path for path in ROOT.iterdir() if path.is_file()))}


def parts_in(archive):
    """{part: [entries]} of an archive.

    Raises
    ------
    ReleaseProblem
        if an entry is neither a file of the checkout, nor made by the build, nor named by a part.
    """
    contents = entries_of(archive)
    found = {part: names for part in parts() if (names := part.entries(archive.name, contents))}
    theirs = {name for names in found.values() for name in names}
    unknown = [
        name
        for name, content in contents.items()
        if name not in theirs and not MADE.fullmatch(name) and content not in own_contents()
    ]
    if unknown:
        raise ReleaseProblem(f"{archive.name} has entries of unknown origin: {', '.join(unknown[:10])}")
    return found


def needed_packages(name="wrcontact"):
    """{name: distribution} of the packages that an installation needs, without extras."""
    found, waiting = {}, [name]
    while waiting:
        for text in distribution(waiting.pop()).requires or ():
            needs = Requirement(text)
            if needs.marker and not needs.marker.evaluate({"extra": ""}):
                continue
            try:
                package = distribution(needs.name)
            except PackageNotFoundError:
                raise ReleaseProblem(f"{needs.name} is not installed, so its licence is not known") from None
            if package.metadata["Name"] not in found:
                found[package.metadata["Name"]] = package
                waiting.append(needs.name)
    return dict(sorted(found.items(), key=lambda pair: pair[0].lower()))


def licence_of(package):
    """The licence that an installed package states, in its own words."""
    told = package.metadata.get("License-Expression") or package.metadata.get("License") or ""
    if told and len(told.splitlines()) == 1 and told.upper() != "UNKNOWN":
        return told
    classes = [
        line.rpartition(" :: ")[2]
        for line in package.metadata.get_all("Classifier") or ()
        if line.startswith("License :: ") and not line.endswith("OSI Approved")
    ]
    texts = [
        told,
        *(file.read_text(encoding="utf-8") for file in package.files or () if "licens" in file.name.lower()),
    ]
    found = classes or [licence for words, licence in WORDS if words in " ".join(texts).lower()][:1]
    if not found:
        raise ReleaseProblem(f"{package.metadata['Name']} states no licence")
    return ", ".join(found)


def bill(archives):
    """The bill of materials as JSON (CycloneDX 1.6), and the list of licences as text, of some archives."""
    where = {}
    for archive in archives:
        for part, entries in parts_in(archive).items():
            where.setdefault(part, {})[archive.name] = entries
    components = [
        _component(
            part.name,
            part.version,
            {"license": {"id": part.licence}},
            part.kind,
            properties=[
                {"name": f"in {name}", "value": ", ".join(entries)} for name, entries in places.items()
            ],
        )
        for part, places in where.items()
    ]
    lines = [
        f"{part.name} {part.version}".strip() + f" ({part.licence}): {part.what}; in {', '.join(places)}"
        for part, places in where.items()
    ]
    packages = needed_packages()
    stated = {name: licence_of(package) for name, package in packages.items()}
    components += [
        _component(
            name,
            package.version,
            {"license": {"name": stated[name]}},
            "library",
            purl=f"pkg:pypi/{name.lower()}@{package.version}",
            scope="required",
        )
        for name, package in packages.items()
    ]
    own = _component("wrcontact", wrcontact.__version__, {"license": {"id": "MIT"}}, "library")
    page = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {"component": own},
        "components": components,
        "dependencies": [
            {"ref": own["bom-ref"], "dependsOn": [component["bom-ref"] for component in components]}
        ],
    }
    text = [
        f"wrcontact {wrcontact.__version__} (MIT): everything that is not listed here",
        "",
        "Inside the archives, of others:",
        *sorted(lines),
        "",
        "Needed by the Python package, not inside (versions of the build; licences as stated by them):",
        *(f"{name} {package.version} ({stated[name]})" for name, package in packages.items()),
    ]
    return json.dumps(page, indent=1) + "\n", "\n".join(text) + "\n"


def _component(name, number, licence, kind, **more):
    found = {"type": kind, "bom-ref": "-".join(filter(None, (name.replace(" ", "-"), number))), "name": name}
    return {**found, **({"version": number} if number else {}), "licenses": [licence], **more}


def libraries_of(archive):
    """Names of the platforms whose libraries an archive has."""
    places = {name: name_of for name_of, place in PLATFORMS.items() for name in (place.fmi2, place.name)}
    found = set()
    for name in entries_of(Path(archive)):
        if re.fullmatch(BINARIES, name):
            found.add(places[name.split("/")[1]])
        elif re.fullmatch(KERNELS, name):
            found.add(re.search(r"_wrcontact_kernel-([\w-]+)\.", name)[1])
    return found
