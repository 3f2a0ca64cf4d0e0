"""What every FMU has: its profiles, its licences, and the zip archive, with the same bytes
for the same entries."""

import io
import zipfile
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from ..conventions import MILLIMETRE
from ..profiles.catalogue import standard_name
from ..profiles.changing import refuse_changing
from ..profiles.options import ProfileFile
from ..storage.hashes import content_hash
from ..system import ContactSystem
from .online import PACKAGE
from .rest import at_rest
from .settings import checked, keywords_of

#: The folder of the files that are packed as they are: inside an installed package, beside it in a checkout.
SOURCES = next(
    (folder for folder in (PACKAGE / "fmu_src", PACKAGE.parent / "fmu_src") if folder.is_dir()),
    PACKAGE / "fmu_src",
)
#: Time of every entry in the archive, so that the time of the build does not change the bytes.
TIMESTAMP = (1980, 1, 1, 0, 0, 0)


def chosen_starts(smoothing=None, settings=None, side="", **chosen):
    """Start values of parameters and inputs, and the profiles that come from files, by file name; each file
    is read once.

    ``settings`` are values of inputs and of other parameters than profiles, by their names in the FMU of a
    wheelset; ``side`` is that of one wheel by itself, or ""; ``chosen`` are ``wheel_profile`` and ``rail_profile``, each a name, a file, or a pair (left, right).
    Files are packed as prepared profiles with their own names: reading points needs scipy,
    which an FMU does not have.
    """
    settings = checked(settings or {})
    given = {parameter: name for parameter, name in _split(chosen).items() if name is not None}
    system = ContactSystem(
        **{parameter.removesuffix("_profile"): name for parameter, name in given.items()},
        **keywords_of(settings),
        smoothing=smoothing,
    )
    refuse_changing(system, "an FMU")
    starts = {parameter: _called(name) for parameter, name in given.items()}
    starts |= {
        parameter: standard_name(name)
        for parameter, name in starts.items()
        if standard_name(name) and not Path(name).is_file()
    }
    profiles = {
        f"{argument}_profile": getattr(system, argument)
        for argument in ("wheel", "rail", "left_wheel", "left_rail")
    }
    files = {parameter: Path(name).name for parameter, name in starts.items() if standard_name(name) != name}
    for file in files.values():
        sharing = [parameter for parameter in files if files[parameter] == file]
        if len({("wheel" in parameter, starts[parameter]) for parameter in sharing}) > 1:
            words = [parameter.removesuffix("_profile").replace("_", " ") for parameter in sharing]
            raise ValueError(
                f"{' and '.join(words)} profile have the same file name, {file}; rename one of them"
            )
    resting = at_rest(system, settings, side)
    return {**settings, **resting, **starts, **files}, {
        file: profiles[parameter] for parameter, file in files.items()
    }


def _called(source):
    """What a profile is called in the FMU: its path or name; one with its corners rounded is no longer the standard
    profile, and has a name of its own."""
    if (
        isinstance(source, ProfileFile)
        and source.corner_radius is not None
        and not Path(source.path).is_file()
    ):
        radius = source.corner_radius / MILLIMETRE
        return f"{str(source).replace('/', '-')}-corners-{radius:g}mm.json"
    return str(source)


def _split(chosen):
    """A pair (left, right) as two parameters."""
    found = {}
    for parameter, value in chosen.items():
        if isinstance(value, (tuple, list)):
            found[f"left_{parameter}"], found[parameter] = value
        else:
            found[parameter] = value
    return found


def licence(name):
    """Licence text (bytes) of an installed distribution or of the checkout; None if there is none."""
    try:
        files = [
            Path(str(file.locate()))
            for file in distribution(name).files or ()
            if file.name.startswith("LICENSE")
        ]
    except PackageNotFoundError:
        files = []
    if name == "wrcontact":
        files.append(PACKAGE.parent / "LICENSE")
    return next((file.read_bytes() for file in files if file.is_file()), None)


def fingerprint(entries):
    """SHA-256 over all names and contents, as hexadecimal digits."""
    return content_hash(
        *(f"{name}\0{len(content)}\0".encode() + content for name, content in sorted(entries.items()))
    )


def archive(entries):
    """The zip archive of the entries as bytes; equal entries give equal bytes."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as file:
        for name, content in sorted(entries.items()):
            entry = zipfile.ZipInfo(name, TIMESTAMP)
            entry.compress_type, entry.create_system, entry.external_attr = (
                zipfile.ZIP_DEFLATED,
                3,
                0o100644 << 16,
            )
            file.writestr(entry, content)
    return stream.getvalue()


def problems_of(data):
    """Problems that fmpy finds in the archive ``data``; an empty list for a valid FMU.  How names are spelt
    is the same in all FMUs and takes fmpy seconds: the tests ask for it."""
    from fmpy import read_model_description
    from fmpy.model_description import ValidationError

    try:
        read_model_description(io.BytesIO(data), validate_variable_names=False, validate_model_structure=True)
    except ValidationError as found:
        return found.problems
    return []
