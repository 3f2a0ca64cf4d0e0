"""Where the values of a sweep are kept: arrays by name, in a Zarr store or in memory.

There is one array for each axis and output, and ``status``, whose empty value says that a block has not been
computed.  Zarr does not like dots and brackets in names, so that they are underscores here.
"""

import json
import os
import secrets
import shutil
from pathlib import Path

import numpy as np

from ..results.convert import needed
from ..results.layout import variable_of
from .grid import block_shape, row_of
from .specification import differences

#: Status of a state that has not been computed.
EMPTY = -1
#: Attributes of the whole.
DESCRIBED = ("title", "asked", "profiles")
STATUS = {"units": "1", "long_name": "Outcome of the step, see wrcontact.Status; -1: not computed"}


def plain(name):
    """The name of an output's array: ``right_patch_1_area`` for ``right.patch[1].area``."""
    return name.replace(".", "_").replace("[", "_").replace("]", "")


def axis_attributes(keyword):
    """Name in an FMU, unit and words of an axis."""
    row = row_of(keyword)
    return {"fmu_name": row.name, "units": row.unit, "long_name": row.words}


def output_attributes(name):
    """Name in an FMU, unit and words of an output."""
    known = variable_of(name)
    words = known.description if known.name == name else known.meaning  # a station that no FMU has
    return {"fmu_name": name, "units": known.unit or "1", "long_name": words}


def described(specification):
    """Attributes of the whole: what was asked, as texts in JSON."""
    texts = (
        specification.system.title,
        json.dumps(specification.record()),
        json.dumps(specification.profiles()),
    )
    return dict(zip(DESCRIBED, texts))


class Memory:
    """Arrays in this process."""

    def __init__(self, specification, block):
        self.specification, self.block = specification, block_shape(specification.sizes, block)
        self._arrays = {plain(name): np.full(specification.sizes, np.nan) for name in specification.names}
        self._arrays["status"] = np.full(specification.sizes, EMPTY, dtype=np.int8)

    def arrays(self):
        """The arrays by name, for reading and writing."""
        return self._arrays

    @staticmethod
    def whole(array):
        """The array itself."""
        return array

    @staticmethod
    def lost(place, names):
        """Nothing is lost here."""
        return False

    def dataset(self):
        """What is there, as a data set of xarray."""
        xarray, axes, names = needed("xarray", "sweep"), self.specification.axes, self.specification.names
        words = {plain(name): output_attributes(name) for name in names} | {"status": STATUS}
        found = {name: (list(axes), array, words[name]) for name, array in self._arrays.items()}
        places = {name: ([name], values, axis_attributes(name)) for name, values in axes.items()}
        return xarray.Dataset(found, places, described(self.specification))


class Store:
    """A Zarr store in a folder that all workers see: its absolute ``path``, the shape of a ``block``, and an
    ``identity``, by which a worker knows that it sees the same folder."""

    def __init__(self, path, block, identity):
        self.path, self.block, self.identity = path, block, identity

    def arrays(self):
        """The arrays by name, for reading and writing.

        Raises
        ------
        RuntimeError
            if this machine does not see the folder.
        """
        zarr = needed("zarr", "a store")
        try:
            group = zarr.open_group(self.path, mode="r+")
        except FileNotFoundError:
            group = None
        if group is None or group.attrs.get("identity") != self.identity:
            raise RuntimeError(
                f"a worker does not see the store {self.path}; permitted is a folder that all workers share"
            )
        return group

    @staticmethod
    def whole(array):
        """An array of the store that writes chunks of NaN, too: one that is not there is lost."""
        return array.with_config({"write_empty_chunks": True})

    def lost(self, place, names):
        """Whether the block of this number along each axis lacks a chunk of an output, or has a damaged one:
        every block writes all, with a checksum."""
        key, group = "/".join(["c", *map(str, place)]), self.arrays()
        at = tuple(slice(k * width, (k + 1) * width) for k, width in zip(place, self.block))
        for name in map(plain, names):
            if not (Path(self.path) / name / key).is_file():
                return True
            try:
                group[name][at]
            except OSError:
                raise
            except Exception:  # a damaged chunk fails in many ways
                return True
        return False

    def dataset(self):
        """What is there, as a data set of xarray that reads values when they are used."""
        return open_dataset(self.path)


def open_dataset(path):
    """The data set of xarray in a store."""
    group = open_group(path)
    found = needed("xarray", "a store").open_zarr(str(path), consolidated=False, chunks=None)
    names = json.loads(group.attrs["asked"])["outputs"]
    found.attrs = {name: found.attrs[name] for name in DESCRIBED}
    return found[[*map(plain, names), "status"]]


def opened(path, specification, block, usual):
    """The :class:`Store` at ``path`` for a specification, made where there is none.

    ``block`` states are in a block; None is what the store has, or the ``usual`` number.

    Raises
    ------
    ValueError
        if there is something else, or the results of another specification.
    """
    needed("xarray", "a store")
    if "://" in str(path):
        raise ValueError(f"store is {str(path)!r}; permitted is the path of a folder")
    path = Path(os.path.abspath(path))
    if not path.exists() or path.is_dir() and not any(path.iterdir()):
        _make(path, specification, block or usual)
    group = open_group(path)
    kept = json.loads(group.attrs["asked"])
    clauses = differences(specification, kept, {name: group[name][:] for name in kept["axes"]})
    if block not in (None, group.attrs["block"]):
        clauses.append(f"block is {block}, there {group.attrs['block']}")
    if clauses:
        raise ValueError(
            f"the store {path} has another specification: {'; '.join(clauses)}; permitted is the "
            "same specification, or another store"
        )
    return Store(str(path), group["status"].chunks, group.attrs["identity"])


def open_group(path):
    """The Zarr group of a store, to be read; ValueError if there is none that a sweep has made."""
    zarr = needed("zarr", "a store")
    try:
        group = zarr.open_group(str(path), mode="r")
    except (OSError, ValueError, KeyError):
        group = None
    if group is None or not {"asked", "identity"} <= {*group.attrs}:
        raise ValueError(
            f"{path} is no store of wrcontact.sweep; permitted is one, or, for a new sweep, a "
            "path at which there is nothing"
        )
    return group


def _make(path, specification, block):
    """Make a store without values beside ``path``, and move it there: it is there as a whole, or not."""
    zarr, codecs = needed("zarr", "a store"), needed("zarr.codecs", "a store")
    part = path.with_name(f".wrcontact-{secrets.token_hex(8)}.part")
    try:
        part.mkdir()
    except OSError as problem:
        problem.filename = str(path)
        raise
    try:
        attributes = {**described(specification), "block": block, "identity": secrets.token_hex(16)}
        group = zarr.create_group(str(part), attributes=attributes)
        for name, values in specification.axes.items():
            group.create_array(name, data=values, dimension_names=[name], attributes=axis_attributes(name))
        form = {
            "shape": specification.sizes,
            "chunks": block_shape(specification.sizes, block),
            "dimension_names": list(specification.axes),
            # of each chunk; what has changed on the disk cannot be read
            "compressors": (codecs.ZstdCodec(), codecs.Crc32cCodec()),
        }
        for name in specification.names:
            group.create_array(
                plain(name), dtype="f8", fill_value=np.nan, attributes=output_attributes(name), **form
            )
        group.create_array("status", dtype="i1", fill_value=EMPTY, attributes=STATUS, **form)
        if path.exists():
            path.rmdir()  # it is empty
        part.rename(path)
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        if not path.is_dir():  # another process may have made it
            raise
