"""A table of states as a table of pandas or a data set of xarray."""

import importlib
import re

import numpy as np

from ..interface.variables import INPUT_VARIABLES
from .layout import OUTPUTS, is_run, variable_of

#: Dimensions of a data set, and what follows their names in those of outputs.
AXES = ("x", "y", "z")


class NeedsPackage(ImportError):
    """A package is not installed; the message says which one, and for what."""


def needed(package, purpose, extra="tables"):
    """The optional ``package``, imported; ``extra`` is the one of wrcontact that has it.

    Raises
    ------
    NeedsPackage
        in one sentence, if it is not installed.
    """
    try:
        return importlib.import_module(package)
    except ImportError:
        raise NeedsPackage(
            f"{purpose} needs {package}, which is not installed; pip install {package}, or "
            f"pip install 'wrcontact[{extra}]'"
        ) from None


def columns_of(table):
    """Columns (n,) of a table of states in SI by FMU name: inputs, the outputs that it has, status.  Of outputs
    that were asked for by name the inputs are those that vary."""
    columns = {name: table[name] for name in table.rows_of_inputs.names}
    columns |= {name: table[name] for name in table.names}
    return {**columns, "status": np.asarray(table.status)}


def to_pandas(table):
    """A pandas.DataFrame with the columns of :func:`columns_of`."""
    return needed("pandas", "to_pandas").DataFrame(columns_of(table))


def to_xarray(table):
    """A xarray.Dataset: ``pose`` is its first dimension; wheels, patches, stations and axes are dimensions.

    ``right.patch[2].area`` is ``data["patch.area"].sel(side="right", patch=2)``.  The input ``normal_force``
    is ``normal_force_input``: the wheels have outputs of its name.  Inputs that vary are coordinates with an
    index: ``data.sel(lateral_shift=2e-3, method="nearest")``.
    """
    xarray = needed("xarray", "to_xarray")
    variables = data_variables(table)
    data = xarray.Dataset(variables, labels_of(variables))
    for name in map(name_of_input, table.rows_of_inputs.varying):
        data = data.set_coords(name).set_xindex(name)
    return data


def data_variables(table):
    """Variables of the data set of :func:`to_xarray`: {name: (dimensions, values, attributes)}."""
    found = {
        name_of_input(name): (("pose",), table[name], _words(INPUT_VARIABLES[name]))
        for name in table.rows_of_inputs.names
    }
    for name, parts in _grouped(table.names).items():
        found[name] = (*_stacked(table, parts), _words(variable_of(next(iter(parts.values())))))
    status = {"long_name": "Outcome of the step, see wrcontact.Status"}
    return {**found, "status": (("pose",), np.asarray(table.status), status)}


def labels_of(variables):
    """{dimension: labels} of these variables, except for the poses."""
    sizes = {}
    for dimensions, values, _ in variables.values():
        sizes |= dict(zip(dimensions, np.shape(values)))
    names = {"side": ["left", "right"], "axis": list(AXES)}
    return {
        name: names.get(name) or list(range(1, size + 1)) for name, size in sizes.items() if name != "pose"
    }


def name_of_input(name):
    """The name of an input in a data set, where outputs have lost their side."""
    return f"{name}_input" if f"right.{name}" in OUTPUTS else name


def _words(variable):
    return {"units": variable.unit or "1", "long_name": variable.meaning}


def _grouped(names):
    """Names of outputs by the variable of a data set that holds them: {variable: {place in it: name}}, the
    place as (dimension, index) pairs."""
    groups = {}
    for name in names:
        place, stem = [], name
        side = re.match(r"(left|right)\.", stem)
        if side:
            place.append(("side", ("left", "right").index(side[1])))
            stem = stem[side.end() :]
            if stem in OUTPUTS:
                # the wheelset has one of this name
                stem = f"wheel_{stem}"
        patch = re.search(r"\[(\d+)\]", stem)
        if patch:
            place.append(("station_number" if is_run(name) else "patch", int(patch[1]) - 1))
            stem = stem.replace(patch[0], "")
        elif not side and stem.endswith(tuple(f".{axis}" for axis in AXES)):
            place.append(("axis", AXES.index(stem[-1])))
            stem = stem[:-2]
        groups.setdefault(stem, {})[tuple(place)] = name
    return groups


def _stacked(table, parts):
    """Dimensions of one variable of a data set and its values; NaN where the table has no column."""
    dimensions = [name for name, _ in next(iter(parts))]
    limits = {"side": 2, "axis": len(AXES)}
    sizes = [limits.get(name) or 1 + max(place[k][1] for place in parts) for k, name in enumerate(dimensions)]
    values = np.full((len(table), *sizes), np.nan)
    for place, name in parts.items():
        values[(slice(None), *(index for _, index in place))] = table[name]
    return ("pose", *dimensions), values
