"""Which profiles a fleet has, and how they are read."""

import glob
import os
import re
import warnings
from dataclasses import replace
from pathlib import Path

from ..profiles import Profile, ProfileFile
from ..profiles.catalogue import NAMES, find_profile, is_standard
from ..storage.atomic import sentence_of
from ..storage.hashes import content_hash


def named_sources(profiles, kind):
    """The profiles of one ``kind`` by names that differ: {name: source}.

    Parameters
    ----------
    profiles : a folder, of which every file counts that is not hidden; a pattern such as ``worn/*.whl``; the
        path of a file; the name of a built-in profile; a ProfileFile whose path is one of these; a Profile;
        or a list of these.

    Raises
    ------
    ValueError
        if nothing is there.
    """
    given = profiles if isinstance(profiles, (list, tuple)) else [profiles]
    found = [source for one in given for source in _sources(one, kind)]
    if not found:
        raise ValueError(f"{kind}s is an empty list; permitted are one or more {kind} profiles")
    return dict(zip(_names(found), found))


def _sources(given, kind):
    """The sources that one entry stands for."""
    if isinstance(given, Profile) or (
        isinstance(given, str) and is_standard(given, kind) and not os.path.exists(given)
    ):
        return [given]
    path = given.path if isinstance(given, ProfileFile) else given
    if not isinstance(path, (str, os.PathLike)):
        raise ValueError(f"{kind}s has {path!r}; permitted are paths, names, ProfileFiles and Profiles")
    path = os.fspath(path)
    if os.path.isdir(path):
        paths = [file for file in Path(path).iterdir() if file.is_file() and not file.name.startswith(".")]
    else:
        paths = [Path(path)] if os.path.exists(path) else [*map(Path, glob.glob(path, recursive=True))]
    paths = sorted(filter(Path.is_file, paths))
    if not paths:
        raise ValueError(
            f"{kind}s is {path!r}, where there is no file; permitted are a folder with files, a "
            f"pattern such as '{kind}s/*.txt', paths of files, and {', '.join(NAMES[kind])}"
        )
    return [replace(given, path=one) if isinstance(given, ProfileFile) else one for one in paths]


def path_of(source):
    """The path of a source as text; "" for one that is no file."""
    if isinstance(source, Profile):
        return ""
    path = source.path if isinstance(source, ProfileFile) else source
    return os.fspath(path) if os.path.exists(path) else ""


def _names(sources):
    """A name for each source: its stem, or the whole name of its file where stems are equal, and a number
    where these are."""
    words = [
        source.name
        if isinstance(source, Profile)
        else Path(source.path if isinstance(source, ProfileFile) else source).name
        for source in sources
    ]
    stems = [
        word if isinstance(source, Profile) or not path_of(source) else Path(word).stem
        for word, source in zip(words, sources)
    ]
    names, taken = [], set()
    for stem, word in zip(stems, words):
        base = stem if [slug(other) for other in stems].count(slug(stem)) == 1 else word
        name, number = base, 2
        while slug(name) in taken:
            name, number = f"{base}_{number}", number + 1
        taken.add(slug(name))
        names.append(name)
    return names


def slug(name):
    """A ``name`` as part of the name of a file, also where files do not differ by case; without two underscores
    side by side, nor one at an end, which part a wheel from a rail."""
    return re.sub(r"(?:[^\w.+-]|_)+", "_", name).strip("_").lower() or "_"


def read(source, kind, smoothing, track):
    """The profile of a source for a ``track`` with this inclination [1], or a sentence on why there is none;
    what a reader repairs stands in the profile."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return find_profile(source, kind, smoothing, track=track)
        except ValueError as wrong:
            return str(wrong)
        except OSError as wrong:
            return f"{kind} profile {sentence_of(wrong)}"


def mark(*values):
    """A text that differs where one of these values or profiles does."""
    words = [
        repr((value.name, value.kind, value.zones, value.reading))
        if isinstance(value, Profile)
        else repr(value)
        for value in values
    ]
    return content_hash("\n".join(words))[:32]
