"""The kernel as Python calls it: compiled where it can be, the Python source otherwise, with
the same bits either way.

A :class:`~wrcontact.stepper.Stepper` binds its arrays once and then steps:

>>> import wrcontact
>>> stepper = wrcontact.ContactSystem().stepper()
>>> stepper.inputs[:4] = 1e-3, 0.0, 0.0, 78.5e3         # lateral shift, yaw, roll guess, normal force
>>> stepper.step()                                      # writes outputs and state
0

The compiled library is called through ctypes with one handle that is filled at ``bind``: 0.2 us a call,
during which other threads run. The environment variable ``WRCONTACT_KERNEL`` chooses: ``auto`` (default: the
library, or a warning and the source), ``compiled`` (the library or an error), ``python`` (the source: for a
debugger, and as the library's witness).
"""

import ctypes
import os
from functools import lru_cache, partial
from importlib import import_module
from pathlib import Path

import numpy as np

from . import files
from .files import HERE, LIBRARY_NAME
from .. import layout
from ..layout import (
    INPUT_COUNT,
    OUTPUT_COUNT,
    SETTING_COUNT,
    SETUP_SIZE,
    START_COUNT,
    STATE_SIZE,
    WORK_SIZE,
    Inputs,
    Setup,
    State,
    Tables,
    Work,
)
from ..patch.outline import row_size
from ..prepare.pieces import FULL
from ...methods.caller import warn_caller

#: How many numbers the tables get room for at first, and at most.
TABLE_ROOM, MOST_ROOM = 100_000, 10_000_000

CHOICES = ("auto", "compiled", "python")


class LibraryUnusable(Exception):
    """There is no compiled library to use; the message says why."""


@lru_cache(maxsize=None)
def default_kernel():
    """The kernel of this process, as ``WRCONTACT_KERNEL`` chooses; warns once where the library
    should be and is not."""
    choice = os.environ.get("WRCONTACT_KERNEL") or "auto"
    if choice not in CHOICES:
        raise ValueError(f"WRCONTACT_KERNEL is {choice!r}; it may be {', '.join(CHOICES)}")
    if choice == "python":
        return Kernel()
    try:
        return Kernel(open_library())
    except LibraryUnusable as reason:
        if choice == "compiled":
            raise
        warn_caller(f"The contact kernel runs uncompiled, about 100 times slower: {reason}.", RuntimeWarning)
        return Kernel()


def changing_kernel():
    """That of this process for rails whose section changes along the track."""
    return ChangingKernel(default_kernel().library)


def bind_changing(tables, state, workspace, inputs, outputs):
    """:meth:`ChangingKernel.bind` of this process, as a function that can be pickled."""
    return changing_kernel().bind(tables, state, workspace, inputs, outputs)


class Kernel:
    """The kernel; ``library`` is what ``open_library`` returns, or None for the Python source."""

    def __init__(self, library=None):
        self.library = library

    @property
    def compiled(self):
        return self.library is not None

    def bind(self, tables, state, workspace, inputs, outputs):
        """The kernel with the arrays of one wheelset: C-contiguous arrays of float64, used where they are."""
        tables = checked("tables", tables, SETTING_COUNT)
        arrays = (
            tables,
            checked("state", state, STATE_SIZE, written=True),
            checked("workspace", workspace, WORK_SIZE, written=True),
            checked("inputs", inputs, INPUT_COUNT),
            checked("outputs", outputs, row_size(Tables.at(tables)), written=True),
        )
        return CompiledKernel(self.library, arrays) if self.compiled else PythonKernel(arrays)

    def prepare(self, setup, wheel, rail, left_wheel, left_rail, fixed):
        """How many numbers of the tables are used, or a negative reason (prepare/tables.py), and the tables, for these arrays: a setup, the definitions of both sides'
        profiles, the fixed tables."""
        given = [
            checked(name, array)
            for name, array in (
                ("setup", setup),
                ("wheel", wheel),
                ("rail", rail),
                ("left_wheel", left_wheel),
                ("left_rail", left_rail),
                ("fixed", fixed),
            )
        ]
        longest = max(map(len, given[1:5]))
        used, room = FULL, TABLE_ROOM
        while used == FULL and room <= MOST_ROOM:
            tables = np.zeros(room)
            work = np.zeros(max(STATE_SIZE + WORK_SIZE + INPUT_COUNT + OUTPUT_COUNT, longest + room + 1000))
            used = self._prepare([*given, tables, work])
            room *= 4
        return used, tables[: max(used, 0)].copy()

    def _prepare(self, arrays):
        """One attempt with arrays of this size; how many numbers of the tables are used, or a negative reason."""
        if self.compiled:
            return self.library.wrcontact_prepare(ctypes.byref(Preparation(*map(span, arrays))))
        source = import_module("..prepare.tables", __package__)
        setup, tables = Setup.at(arrays[0]), Tables.at(arrays[6])
        used = source.prepare(setup, *map(view, arrays[1:6]), tables, view(arrays[7]))
        if used >= 0:
            fill_starts(source, tables)
            source.write_methods(setup, tables)
        return used

    def divide_into_strips(self, workspace):
        """Cut the patch by itself in the workspace (n,) into strips along the rolling direction."""
        if self.compiled:
            self.library.wrcontact_divide_into_strips(span(workspace))
            return
        work = Work.at(workspace)
        source = import_module("..creep.rolling_strips", __package__)
        source.divide_into_strips(work.patch, work.contact.strips)

    def solve_creep_force(self, tables, workspace):
        """The creep force of the patch by itself in the workspace (n,), by the model of the tables (n,)."""
        if self.compiled:
            self.library.wrcontact_solve_creep_force(span(tables), span(workspace))
            return
        source = import_module("..creep.creep_force", __package__)
        work = Work.at(workspace)
        source.solve_creep_force(Tables.at(tables), work.rolling, work.patch)

    def search_sections(self, tables, workspace, index, pose):
        """Search the smallest gap of the wheel of side ``index`` over a rail whose section changes; the workspace (n,) then
        has the search and the place of the wheel.

        Parameters
        ----------
        tables : (m,), with the sections of this side (sections/kernel_table.py).
        pose : (4,), position along the track, lateral shift [m], yaw and roll [rad], as those of a right side.

        Returns
        -------
        bool
            whether the gap is certainly the smallest one.
        """
        if self.compiled:
            found = self.library.wrcontact_search_sections(span(tables), span(workspace), index, span(pose))
            return bool(found)
        source = import_module("..sections.section_pose", __package__)
        return source.search_at(Tables.at(tables), Work.at(workspace).section_search, index, view(pose))


def fill_starts(source, tables):
    """As fill_starts in native/wrcontact_prepare.c, with the Python source."""
    step = import_module("..wheelset.step", __package__).step
    state, workspace, inputs, outputs = (
        np.zeros(size) for size in (STATE_SIZE, WORK_SIZE, INPUT_COUNT, OUTPUT_COUNT)
    )
    for row in range(START_COUNT):
        Inputs.at(inputs).lateral_shift = source.start_shift(tables, row)
        status = step(tables, State.at(state), Work.at(workspace), view(inputs), view(outputs))
        source.note_start(tables, Work.at(workspace).outputs, row, status)
    source.open_starts(tables)


class ChangingKernel:
    """What :class:`~wrcontact.stepper.Stepper` binds for rails whose section changes along the track: ``bind`` takes tables of
    with_changing_rails (wrcontact/sections/kernel_table.py), which it writes to."""

    def __init__(self, library=None):
        self.library = library

    def bind(self, tables, state, workspace, inputs, outputs):
        """As :meth:`Kernel.bind`; what it returns has steps alone."""
        tables = checked("tables", tables, SETTING_COUNT, written=True)
        arrays = (
            tables,
            checked("state", state, STATE_SIZE, written=True),
            checked("workspace", workspace, WORK_SIZE, written=True),
            checked("inputs", inputs, INPUT_COUNT),
            checked("outputs", outputs, row_size(Tables.at(tables)), written=True),
        )
        return CompiledChanging(self.library, arrays) if self.library else PythonChanging(arrays)


class CompiledChanging:
    """The library with the arrays of a wheelset on changing rails."""

    compiled = True

    def __init__(self, library, arrays):
        self._library, self._size = library, row_size(Tables.at(arrays[0]))
        handle = Handle(*map(span, arrays))
        handle.arrays = arrays
        self._handle = ctypes.byref(handle)
        self.step = partial(library.wrcontact_step_changing, self._handle)

    def step_many(self, count, inputs, outputs, statuses):
        """As CompiledKernel.step_many."""
        blocks = checked_blocks(count, self._size, inputs, outputs, statuses)
        return self._library.wrcontact_step_changing_many(
            self._handle, count, *(block.ctypes.data for block in blocks)
        )


class PythonChanging:
    """The Python source with the same arrays and calls."""

    compiled = False

    def __init__(self, arrays):
        self._source = import_module("..changing.section_step", __package__)
        tables, state, workspace, inputs, outputs = arrays
        self._size = row_size(Tables.at(tables))
        self._records = Tables.at(tables), State.at(state), Work.at(workspace)
        self.step = partial(self._source.step_changing, *self._records, view(inputs), view(outputs))

    def step_many(self, count, inputs, outputs, statuses):
        """As CompiledKernel.step_many."""
        blocks = checked_blocks(count, self._size, inputs, outputs, statuses)
        return self._source.step_changing_many(count, *self._records, *map(view, blocks))


class CompiledKernel:
    """The library with its arrays.  ``step()`` makes one step and returns the status."""

    compiled = True

    def __init__(self, library, arrays):
        self._library, self._size = library, row_size(Tables.at(arrays[0]))
        handle = Handle(*map(span, arrays))
        # it holds bare addresses: they live as long as it, or a bare ``step``, does
        handle.arrays = arrays
        self._handle = ctypes.byref(handle)
        self._room = self._wide_room = None
        # no method: a third of the cost is the look-up
        self.step = partial(library.wrcontact_step, self._handle)

    def step_many(self, count, inputs, outputs, statuses):
        """``count`` steps in a row: rows of ``inputs`` to rows of ``outputs`` and one float
        in ``statuses`` each."""
        blocks = checked_blocks(count, self._size, inputs, outputs, statuses)
        return self._library.wrcontact_step_many(
            self._handle, count, *(block.ctypes.data for block in blocks)
        )

    def derivative(self, seed):
        """Status of the step at the inputs, and how its outputs move where the inputs move at
        the rates in ``seed``: as an FMU has it."""
        if self._room is None:
            self._room = np.empty(self._library.wrcontact_derivative_room())
        rates = np.empty(self._size)
        seed = checked("seed", seed, INPUT_COUNT)
        status = self._library.wrcontact_derivative(
            self._handle, seed.ctypes.data, rates.ctypes.data, self._room.ctypes.data
        )
        return status, rates

    def derivatives(self, seeds):
        """The same along many directions: rates (k, outputs) for the rows of ``seeds`` (k, inputs)."""
        if self._wide_room is None:
            self._wide_room = np.empty(self._library.wrcontact_jacobian_room())
        rates = np.empty((len(seeds), self._size))
        flat = checked("seeds", seeds, len(seeds) * INPUT_COUNT)
        status = self._library.wrcontact_jacobian(
            self._handle, len(seeds), flat.ctypes.data, rates.ctypes.data, self._wide_room.ctypes.data
        )
        return status, rates


class PythonKernel:
    """The Python source with the same arrays and calls."""

    compiled = False

    def __init__(self, arrays):
        self._source = import_module("..wheelset.step", __package__)  # not before it is needed
        tables, state, workspace, inputs, outputs = arrays
        self._size = row_size(Tables.at(tables))
        self._records = Tables.at(tables), State.at(state), Work.at(workspace)
        self.step = partial(self._source.step, *self._records, view(inputs), view(outputs))

    def step_many(self, count, inputs, outputs, statuses):
        """As CompiledKernel.step_many."""
        blocks = checked_blocks(count, self._size, inputs, outputs, statuses)
        return self._source.step_many(count, *self._records, *map(view, blocks))


class Span(ctypes.Structure):
    """array_double_1d in native/spans.h."""

    _fields_ = [("data", ctypes.c_void_p), ("length", ctypes.c_int64)]


class Preparation(ctypes.Structure):
    """wrcontact_preparation in native/wrcontact_prepare.h."""

    _fields_ = [
        (name, Span)
        for name in ("setup", "wheel", "rail", "left_wheel", "left_rail", "fixed", "tables", "work")
    ]


class Handle(ctypes.Structure):
    """wrcontact_handle in native/wrcontact_kernel.h."""

    _fields_ = [(name, Span) for name in ("tables", "state", "workspace", "inputs", "outputs")]


def fingerprint(folder=HERE):
    """That of the kernel source in ``folder`` with this layout."""
    return files.fingerprint(folder, layout.digest())


def open_library(folder=HERE):
    """The compiled library in ``folder``, made from the kernel source in ``folder``."""
    path = Path(folder, LIBRARY_NAME)
    if not path.exists():
        raise LibraryUnusable(f"there is no {LIBRARY_NAME} in {folder}")
    try:
        library = ctypes.CDLL(str(path))
        declare(library)
    except (OSError, AttributeError) as error:
        raise LibraryUnusable(f"{path} cannot be loaded ({error})") from error
    if library.wrcontact_abi() != fingerprint(folder):
        raise LibraryUnusable(f"{path} was compiled from another version of the kernel")
    return library


def declare(library):
    """Tell ctypes the functions of native/wrcontact_kernel.h."""
    address = ctypes.c_void_p
    library.wrcontact_abi.argtypes, library.wrcontact_abi.restype = [], ctypes.c_int64
    library.wrcontact_step.argtypes, library.wrcontact_step.restype = [address], ctypes.c_int
    library.wrcontact_step_many.argtypes = [address, ctypes.c_int64, address, address, address]
    library.wrcontact_step_many.restype = ctypes.c_int
    library.wrcontact_prepare.argtypes, library.wrcontact_prepare.restype = [address], ctypes.c_int
    library.wrcontact_divide_into_strips.argtypes = [Span]
    if hasattr(library, "wrcontact_search_sections"):  # not in that of an FMU
        library.wrcontact_search_sections.argtypes = [Span, Span, ctypes.c_int64, Span]
        library.wrcontact_search_sections.restype = ctypes.c_int
    if hasattr(library, "wrcontact_step_changing"):
        library.wrcontact_step_changing.argtypes, library.wrcontact_step_changing.restype = (
            [address],
            ctypes.c_int,
        )
        library.wrcontact_step_changing_many.argtypes = [address, ctypes.c_int64, address, address, address]
        library.wrcontact_step_changing_many.restype = ctypes.c_int
    library.wrcontact_solve_creep_force.argtypes = [Span] * 2
    library.wrcontact_divide_into_strips.restype = library.wrcontact_solve_creep_force.restype = None
    if hasattr(library, "wrcontact_derivative"):  # not in that of STEP_UNITS
        library.wrcontact_derivative.argtypes = [address] * 4
        library.wrcontact_derivative.restype = ctypes.c_int
        library.wrcontact_derivative_room.argtypes = []
        library.wrcontact_derivative_room.restype = ctypes.c_int64
    if hasattr(library, "wrcontact_jacobian"):  # not in that of an FMU
        library.wrcontact_jacobian.argtypes = [address, ctypes.c_int64, address, address, address]
        library.wrcontact_jacobian.restype = ctypes.c_int
        library.wrcontact_jacobian_room.argtypes, library.wrcontact_jacobian_room.restype = [], ctypes.c_int64


def span(array):
    """Where the flat ``array`` is and how long."""
    return Span(array.ctypes.data, array.size)


def view(array):
    """The memory of the flat ``array`` as the Python source reads and writes it: faster than
    numpy, and plain floats."""
    return memoryview(array)


def checked_blocks(count, size, inputs, outputs, statuses):
    """The flat arrays of ``count`` steps that give ``size`` numbers each."""
    if count < 0:
        raise ValueError(f"count is {count}; it cannot be negative")
    return (
        checked("inputs", inputs, count * INPUT_COUNT),
        checked("outputs", outputs, count * size, written=True),
        checked("statuses", statuses, count, written=True),
    )


def checked(name, array, least=0, written=False):
    """``array`` as a flat view, if the kernel can use its memory as it is."""
    if not isinstance(array, np.ndarray) or array.dtype != np.float64:
        found = f"{array.dtype}" if isinstance(array, np.ndarray) else type(array).__name__
        raise TypeError(f"{name} must be a numpy array of float64, not {found}")
    if not (array.flags.c_contiguous and array.flags.aligned):
        raise ValueError(f"{name} must be C-contiguous and aligned; numpy.ascontiguousarray makes it so")
    if written and not array.flags.writeable:
        raise ValueError(f"{name} is read-only, and the kernel writes to it")
    if array.size < least:
        raise ValueError(f"{name} has {array.size} values and needs {least}")
    return array.reshape(-1)
