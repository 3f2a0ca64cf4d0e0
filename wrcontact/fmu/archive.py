"""What every FMU has: its profiles, its licences, and the zip archive, with the same bytes
for the same entries."""

import hashlib
import io
import zipfile
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from .. import ContactSystem
from ..profiles.catalogue import BUILDERS, standard_name
from .online import PACKAGE

#: Time of every entry in the archive, so that the time of the build does not change the bytes.
TIMESTAMP = (1980, 1, 1, 0, 0, 0)


def chosen_profiles(smoothing=None, **chosen):
    """Start values of the profile parameters, and the profiles that come from files, by file
    name; each file is read once.

    Files are packed as prepared profiles with their own names: reading points needs scipy,
    which an FMU does not have.
    """
    given = {parameter: name for parameter, name in chosen.items() if name is not None}
    system = ContactSystem(**{parameter.removesuffix("_profile"): name for parameter, name in given.items()},
                           smoothing=smoothing)
    starts = {parameter: str(name) for parameter, name in given.items()}
    starts |= {parameter: standard_name(name) for parameter, name in starts.items()
               if standard_name(name) and not Path(name).is_file()}
    profiles = {"wheel_profile": system.wheel, "rail_profile": system.rail}
    files = {parameter: Path(name).name for parameter, name in starts.items() if name not in BUILDERS}
    if len(set(files.values())) < len(files):
        raise ValueError(f"wheel and rail profile have the same file name, {files['wheel_profile']}; rename "
                         "one of them")
    return {**starts, **files}, {file: profiles[parameter] for parameter, file in files.items()}


def licence(name):
    """Licence text (bytes) of an installed distribution or of the checkout; None if there is none."""
    try:
        files = [Path(str(file.locate())) for file in distribution(name).files or ()
                 if file.name.startswith("LICENSE")]
    except PackageNotFoundError:
        files = []
    if name == "wrcontact":
        files.append(PACKAGE.parent / "LICENSE")
    return next((file.read_bytes() for file in files if file.is_file()), None)


def fingerprint(entries):
    """SHA-256 over all names and contents, as hexadecimal digits."""
    digest = hashlib.sha256()
    for name, content in sorted(entries.items()):
        digest.update(f"{name}\0{len(content)}\0".encode() + content)
    return digest.hexdigest()


def archive(entries):
    """The zip archive of the entries as bytes; equal entries give equal bytes."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as file:
        for name, content in sorted(entries.items()):
            entry = zipfile.ZipInfo(name, TIMESTAMP)
            entry.compress_type, entry.create_system, entry.external_attr = (zipfile.ZIP_DEFLATED, 3,
                                                                             0o100644 << 16)
            file.writestr(entry, content)
    return stream.getvalue()


def problems_of(data):
    """Problems that fmpy finds in the archive ``data``; an empty list for a valid FMU."""
    from fmpy.validation import validate_fmu

    return validate_fmu(io.BytesIO(data))
