"""Files of tables: CSV, JSON, Parquet and NetCDF, written part by part, so that memory does not grow with the
number of rows.

A column has the name of an FMU's variable and is in SI.  In a NetCDF file wheels, patches, stations and axes
are dimensions, as in :meth:`wrcontact.WheelsetState.to_xarray`.
"""

import json
import math
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from ..interface.variables import INTEGER, VARIABLES
from ..results.convert import columns_of, data_variables, labels_of, name_of_input, needed
from ..storage.atomic import open_atomically
from .adding import adding, option
from .errors import Refused

INTEGERS = {v.name for v in VARIABLES if v.type == INTEGER}
#: Rows of a group in a Parquet file, at least.
GROUP = 16384
#: Format by ending.
ENDINGS = {".csv": "csv", ".json": "json", ".parquet": "parquet", ".nc": "netcdf"}
TEXT = {"mode": "w", "newline": "", "encoding": "utf-8"}


def write_table(path, columns):
    """Write ``columns`` (n,) by name to a CSV file with all digits; a cell without a value is empty."""
    with open_atomically(path, **TEXT) as file:
        file.write(",".join(columns) + "\n")
        file.writelines(_csv_lines(columns))


def _csv_lines(columns):
    for cells in zip(*(_cells(name, values) for name, values in columns.items())):
        yield ",".join("" if cell is None else repr(cell) for cell in cells) + "\n"


def _cells(name, values):
    """A column as a list of ints or floats, None where there is no value."""
    values, there = np.asarray(values), np.isfinite(values)
    if np.all(there):
        return (values.astype(int) if name in INTEGERS else values.astype(float)).tolist()
    kind = int if name in INTEGERS else float
    return [kind(value) if math.isfinite(value) else None for value in values.tolist()]


# --- one writer for each format: a context that yields a function for the next part of the table -----------


@contextmanager
def _csv(path, count):
    with open_atomically(path, **TEXT) as file:

        def write(table):
            columns = columns_of(table)
            if file.tell() == 0:
                file.write(",".join(columns) + "\n")
            file.writelines(_csv_lines(columns))

        yield write


@contextmanager
def _json(path, count):
    with open_atomically(path, **TEXT) as file:
        before = "[\n"

        def write(table):
            nonlocal before
            columns = columns_of(table)
            for cells in zip(*(_cells(name, values) for name, values in columns.items())):
                file.write(before + json.dumps(dict(zip(columns, cells))))
                before = ",\n"

        yield write
        file.write("\n]\n" if before != "[\n" else "[]\n")


@contextmanager
def _parquet(path, count):
    arrow = needed("pyarrow", "a .parquet file")
    parquet, writer, waiting = needed("pyarrow.parquet", "a .parquet file"), None, []

    def flush():
        nonlocal writer, waiting
        if waiting:
            batch = arrow.concat_tables(waiting).combine_chunks()
            writer = writer or parquet.ParquetWriter(file, batch.schema)
            writer.write_table(batch)
            waiting = []

    def write(table):
        columns = {name: np.ascontiguousarray(values) for name, values in columns_of(table).items()}
        waiting.append(
            arrow.table(
                {
                    name: arrow.array(_cells(name, values), arrow.int64())
                    if name in INTEGERS
                    else arrow.array(values, from_pandas=True)
                    for name, values in columns.items()
                }
            )
        )
        if sum(map(len, waiting)) >= GROUP:
            flush()

    with open_atomically(path) as file:
        yield write
        flush()
        if writer:
            writer.close()


@contextmanager
def _netcdf(path, count):
    netcdf, done = needed("netCDF4", "a .nc file"), 0
    with open_atomically(path) as file, netcdf.Dataset(file.name, "w") as data:

        def write(table):
            nonlocal done
            found = data_variables(table)
            if not done:
                _declare(data, found, count)
                data.setncattr("coordinates", " ".join(map(name_of_input, table.rows_of_inputs.varying)))
            for name, (_, values, _) in found.items():
                data[name][done : done + len(table)] = values
            done += len(table)

        yield write


def _declare(data, found, count):
    """Dimensions, labels and variables of a NetCDF file for ``count`` poses."""
    data.createDimension("pose", count)
    for name, labels in labels_of(found).items():
        data.createDimension(name, len(labels))
        data.createVariable(name, str if isinstance(labels[0], str) else "i4", (name,))
        for place, label in enumerate(labels):
            data[name][place] = label
    for name, (dimensions, values, words) in found.items():
        variable = data.createVariable(name, "f8" if values.dtype.kind == "f" else "i4", dimensions)
        variable.setncatts(words)


WRITERS = {"csv": _csv, "json": _json, "parquet": _parquet, "netcdf": _netcdf}


#: About what a row takes in each format [bytes], with creep forces; and the size that is announced before [bytes].
ROW_SIZES = {"csv": 8.5e3, "json": 22e3, "parquet": 3.7e3, "netcdf": 4.6e3}
LARGE = 500e6


class TableFile:
    """A file ``path`` for a table in one ``format``, a key of WRITERS."""

    def __init__(self, path, format):
        self.path, self.format = path, format

    def size_words(self, count):
        """A sentence on the size of a table of ``count`` rows, if that is large; else ""."""
        sizes = {format: count * size for format, size in ROW_SIZES.items()}
        if sizes[self.format] <= LARGE:
            return ""
        smallest = min(sizes.values())
        other = f"; a .parquet file has about {smallest / 1e9:.2g} GB" if self.format != "parquet" else ""
        return f"{self.path} will have about {sizes[self.format] / 1e9:.2g} GB, for {count} rows{other}"

    def open(self, count):
        """A context in which a table of ``count`` rows is written; yields a function for its next part."""
        return WRITERS[self.format](self.path, count)


# --- options ----------------------------------------------------------------------------------------------

WORDS = {
    "output": f"Write all outputs to this file, in SI units and with the names of the FMU, instead of "
    f"printing a few of them; its ending says the format: {', '.join(ENDINGS)}",
    **{
        format: f"The same as --output, for a file that ends in {ending}"
        for ending, format in ENDINGS.items()
    },
}


def writes_tables(command):
    """Decorator that adds the options for a file; the command receives ``file``, a :class:`TableFile` or
    None."""

    def fold(given):
        chosen = {name: given.pop(name) for name in WORDS}
        chosen = {name: path for name, path in chosen.items() if path is not None}
        if len(chosen) > 1:
            names = " and ".join(f"--{name}" for name in chosen)
            raise Refused(f"{names} are given; permitted is one of them")
        return given | {"file": next((_file(name, path) for name, path in chosen.items()), None)}

    options = [
        option(name, Path, None, f"--{name}", metavar="FILE", hidden=name != "output", help=words)
        for name, words in WORDS.items()
    ]
    return adding(command, options, fold, ("file",))


def _file(name, path):
    """The :class:`TableFile` of an option; Refused if the file's ending is not the format's."""
    found = ENDINGS.get(path.suffix.lower())
    if name == "output" and found:
        return TableFile(path, found)
    permitted = [ending for ending, format in ENDINGS.items() if name in ("output", format)]
    if name == "output" or (found != name and path.suffix):
        verb = "are files that end in" if len(permitted) > 1 else "is a file that ends in"
        raise Refused(f"--{name} is {str(path)!r}; permitted {verb} {', '.join(permitted)}")
    return TableFile(path, name)  # without an ending, such as /dev/stdout
