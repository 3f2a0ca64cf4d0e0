"""Profile files that lie in an FMU."""

import os
from pathlib import Path

from ..interface.parameters import LEFT
from ..profiles.catalogue import named_profile


def packed_profile(resources, keyword, name):
    """The path of the file called ``name`` in the folder ``resources``, or the name of a standard profile;
    ``keyword`` is the argument of a system, such as left_wheel.

    No other file is read: a path that leads out of the resources, by ``..``, from the root or by a link, is
    refused as a name that nothing has, with a ValueError.
    """
    if resources:
        folder, file = (os.path.realpath(path) for path in (resources, Path(resources, name)))
        if os.path.isfile(file) and Path(folder) in Path(file).parents:
            return file
    return named_profile(
        name,
        keyword.removeprefix(LEFT),
        f"{keyword}_profile",
        ", or the name of a profile file in the FMU's resources",
    ).name
