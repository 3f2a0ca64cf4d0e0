"""One wheelset that is moved in time.

A stepper holds the arrays of one wheelset and a solver that works on them: the kernel, or the half-space
model of wrcontact/halfspace/stepping.py.  :meth:`wrcontact.ContactSystem.stepper` puts the two together.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from queue import SimpleQueue
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .interface.calls import START_ROW, unknown_input
from .interface.index import KEYWORDS
from .interface.inputs import INPUT_NAMES
from .kernel import layout
from .kernel.binding.library import PythonKernel, default_kernel
from .methods.numbers import check_choice
from .motion.reaction import rail_reaction
from .results.differences import differences
from .results.layout import Layout
from .results.names import differentiated_inputs, differentiated_outputs, is_computed, listed, place_of
from .results.saved import check_mark, version_mark

if TYPE_CHECKING:
    from .keywords import Depth, Sides

#: What of an evaluation can be wanted: sides and depth of the outputs, with the kernel's numbers.
SIDE_FLAGS = {"both": layout.SIDES_BOTH, "left": layout.SIDES_LEFT, "right": layout.SIDES_RIGHT}
DEPTHS = {"all": layout.DEPTH_ALL, "patches": layout.DEPTH_PATCHES, "geometry": layout.DEPTH_GEOMETRY}
#: Where the wheelset's force and moment are among the outputs.
FORCE, MOMENT = (
    slice(place, place + 3) for place in (layout.Outputs.force.offset // 8, layout.Outputs.moment.offset // 8)
)
#: Permitted penetration, where it is prescribed [m].
PENETRATION_RANGE = (0.0, 0.01)
#: Rows that a part of many has at first, and the time that a part should take [s].
FIRST_ROWS, PART_TIME = 8, 0.2
#: Rows of a table that are solved one after the other, as one thread's: the slowest model needs half a second
#: for them.  The next ones begin anew, so that no bit depends on the number of threads.
SHARED_ROWS = 512


class Stepper:
    """One wheelset moved in time: write ``inputs``, call :meth:`step`, read ``outputs``.

    Parameters
    ----------
    tables : settings and tables of the system; the stepper works on a copy.
    bind : called with tables, state, workspace, inputs and outputs; returns the solver that works on these
        arrays.  None is the kernel.

    Attributes
    ----------
    inputs : those of ``input_names``, in this order; SI.  They begin with the defaults of
        :meth:`~wrcontact.ContactSystem.evaluate`.
    outputs : in the order of an FMU's variables, SI; zero until the first valid step.  :meth:`place` says
        where one of ``output_names`` is.
    force, moment : (3,) of the wheelset [N, N m], views of the outputs: forward, to the right, down; the
        moment is about the wheelset's centre.
    state : where the next roll search starts, and counters; it never changes an answer.
    layout : where the outputs lie, a :class:`~wrcontact.results.layout.Layout`.
    compiled : whether the compiled kernel is used.
    """

    inputs: NDArray[np.float64]
    outputs: NDArray[np.float64]
    force: NDArray[np.float64]
    moment: NDArray[np.float64]
    state: NDArray[np.float64]
    compiled: bool

    def __init__(self, tables: NDArray[np.float64], bind: Callable[..., Any] | None = None) -> None:
        self._tables, self._bind = tables.copy(), bind
        self.inputs = np.array(START_ROW)
        self.numbers = memoryview(self.inputs)  # the same: single numbers go in and out in half the time
        self.layout = Layout.of(self._tables)
        self.outputs = np.zeros(self.layout.size)
        self.force, self.moment = self.outputs[FORCE], self.outputs[MOMENT]
        self.state = np.zeros(layout.STATE_SIZE)
        self._workspace = np.zeros(layout.WORK_SIZE)
        bind = bind or default_kernel().bind
        self._bound = bind(self._tables, self.state, self._workspace, self.inputs, self.outputs)
        self.compiled = self._bound.compiled
        self._penetration = None
        self._wanted = ("both", "all")

    def __reduce__(self):
        return _restored, (
            version_mark(),
            self._tables,
            self._bind,
            (self.inputs, self.outputs, self.state),
            self._penetration,
            self._wanted,
        )

    @property
    def tables(self) -> NDArray[np.float64]:
        """Settings and tables, with what is wanted and prescribed."""
        return self._tables

    @property
    def input_names(self) -> tuple[str, ...]:
        """Names of the inputs in their order, as in an FMU: ``lateral_shift``, ..., ``right.friction``."""
        return INPUT_NAMES

    @property
    def output_names(self) -> tuple[str, ...]:
        """Names of the outputs in the order of an FMU's variables: ``roll``, ``vertical_shift``, ...

        If ``stations`` is not 31, some elements are unused and have no name; :meth:`place` returns the index of
        a named output.
        """
        return self.layout.names()

    def place(self, name: str) -> int:
        """The index of an input in ``inputs``, or of an output in ``outputs``, by its name.

        Raises
        ------
        ValueError
            if there is none, with what may be meant.
        """
        return place_of(name, self.layout)

    def resultant(self, motion: Mapping[str, float]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Force (3,) [N] and moment (3,) [N m] of the rails on the wheelset at a ``motion``.

        Parameters
        ----------
        motion : dict of keyword inputs, such as :func:`wrcontact.motion_of` gives; others stay as they are.

        Returns
        -------
        force, moment : in the axes of the track, the moment about the wheelset's centre.  NaN where the step
            has status 2, 3 or 4, and where they are not wanted.
        """
        numbers = self.numbers
        try:
            for name, value in motion.items():
                numbers[KEYWORDS[name]] = value
        except KeyError:
            raise unknown_input(name) from None
        if self._bound.step() > layout.UNLOADED:
            return np.full(3, math.nan), np.full(3, math.nan)
        return self.force.copy(), self.moment.copy()

    def derivatives(self, of: Iterable[str], by: Iterable[str]) -> NDArray[np.float64]:
        """How outputs follow inputs at the present inputs, which may have been stepped or not.

        One step and one pass of the differentiated kernel for each ten inputs; nothing else changes.  With a rail that
        changes along the track, a wheel that is not round or a roller they are differences of four steps for each input, within
        1e-6, and NaN where a derivative jumps.

        Parameters
        ----------
        of : names of outputs, numbers and no counts.
        by : names of inputs.

        Returns
        -------
        array (len(of), len(by))
            SI.  NaN where the step has status 2, 3 or 4.

        Raises
        ------
        ValueError
            if there is no such output or input, or the stepper does not compute it.
        RuntimeError
            if the kernel is not compiled, or a model works outside it.
        """
        columns = differentiated_inputs(listed("by", by))
        places, least = differentiated_outputs(listed("of", of), self.layout)
        if not is_computed(least, self._wanted):
            raise ValueError(
                f"of needs side={least[0]!r} and outputs={least[1]!r}; this stepper computes "
                f"side={self._wanted[0]!r} and outputs={self._wanted[1]!r}"
            )
        if self._is_changing():
            if self.step() > layout.UNLOADED:
                return np.full((len(places), len(columns)), math.nan)
            return differences(self._stepped, self.inputs, self.outputs[places], columns, places).T
        if not hasattr(self._bound, "derivatives"):
            raise RuntimeError(
                "there are no derivatives of the half-space's models"
                if self._bind and not isinstance(self._bound, PythonKernel)
                else "there are no derivatives, since the kernel runs uncompiled; they need the compiled one"
            )
        seeds = np.zeros((len(columns), len(self.inputs)))
        seeds[np.arange(len(columns)), columns] = 1.0
        status, rates = self._bound.derivatives(seeds)
        found = rates[:, places].T
        return found if status <= layout.UNLOADED else np.full_like(found, math.nan)

    def rail_reaction(
        self, side: Literal["left", "right"]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Force (3,) [N] of the wheel on the rail of this ``side``, "left" or "right", after a step, and its
        moment (3,) [N m] about the rail's reference point, the highest point of its head as it is displaced.

        For rails that are bodies; in the axes of the track.
        """
        self._refuse_changing("rail_reaction")
        return rail_reaction(self._tables, self.inputs, self.outputs, side)

    def _stepped(self, rows):
        """Outputs (n, outputs) and status (n,) of rows of inputs."""
        outputs, status = np.full((len(rows), len(self.outputs)), math.nan), np.empty(len(rows))
        self.step_many(rows, outputs, status)
        return outputs, status

    def _is_changing(self):
        """Whether a rail changes along the track or is a roller, or a wheel is not round."""
        return any(pair.changing for pair in layout.Tables.at(self._tables).pairs)

    def _refuse_changing(self, what):
        """ValueError if a rail changes along the track, which ``what`` cannot have."""
        if self._is_changing():
            raise ValueError(
                f"a rail changes along the track; permitted for {what} are rails that are the same all along it"
            )

    def step(self) -> int:
        """Evaluate the inputs into the outputs; return the status (an int).

        Status 2, 3 and 4 leave the outputs as they are.  Inputs that equal those of the last valid step are
        not evaluated again.
        """
        return self._bound.step()

    def step_many(
        self, inputs: NDArray[np.float64], outputs: NDArray[np.float64], status: NDArray[np.float64]
    ) -> None:
        """Evaluate rows of ``inputs`` (n, inputs) into rows of ``outputs`` and ``status`` (n,), C-contiguous
        float64."""
        self._bound.step_many(len(inputs), inputs, outputs, status)

    def parts(
        self, inputs: NDArray[np.float64], places: Sequence[int] | NDArray[Any] | None = None
    ) -> Iterator[tuple[slice, NDArray[np.float64], NDArray[Any]]]:
        """Evaluate rows of ``inputs`` (n, inputs), part after part.

        Yields the rows' slice, their outputs (rows, k) at ``places`` (None: all), and their status (rows,).
        Rows with status 2, 3 or 4 are NaN.  The arrays are used again for the next part.
        """
        most = min(SHARED_ROWS, max(len(inputs), 1))
        outputs, status = np.empty((most, len(self.outputs))), np.empty(most)
        start, count = 0, FIRST_ROWS
        while start < len(inputs):
            rows = slice(start, min(start + count, len(inputs)))
            part = outputs[: rows.stop - start]
            part[:] = math.nan
            began = time.perf_counter()
            self.step_many(inputs[rows], part, status[: len(part)])
            count = count * 2 if time.perf_counter() - began < PART_TIME else max(count // 2, 1)
            count = min(count, most)
            yield rows, part if places is None else part[:, places], status[: len(part)].astype(int)
            start = rows.stop

    def prescribe(self, penetration: ArrayLike | None) -> None:
        """Prescribe the penetration [m], one value or (left, right), instead of the force; None returns to
        the force.

        Raises
        ------
        ValueError
            where the contact mode is not rigid, or the penetration is out of its range.
        """
        if penetration is None and self._penetration is None:
            return
        settings = layout.Tables.at(self._tables)
        if settings.mode != layout.MODE_RIGID:
            raise ValueError(
                "penetration can be prescribed with the contact_mode 'rigid' only: in other modes it follows from "
                "the load or from the height"
            )
        try:
            given = np.asarray(np.nan if penetration is None else penetration)
            if given.dtype.kind in "Ub":  # numpy takes texts and truth values for numbers
                raise TypeError
            left, right = np.broadcast_to(given.astype(float), 2).tolist()
        except (TypeError, ValueError):
            raise ValueError(
                f"penetration is {penetration!r}; permitted is one number or (left, right) [m]"
            ) from None
        prescribed = None if penetration is None else (left, right)
        if prescribed == self._penetration:  # by value: an array may have changed in place
            return
        low, high = PENETRATION_RANGE
        for side, value in (("left", left), ("right", right)):
            if not (math.isnan(value) or low <= value <= high):
                raise ValueError(f"penetration ({side}) is {value:g} m; permitted is {low:g} ... {high:g} m")
        settings.penetration[:] = left, right
        layout.Work.at(self._workspace).known = False
        self._penetration = prescribed

    def want(self, side: Sides = "both", outputs: Depth = "all") -> None:
        """Compute only this from now on; the arguments of :meth:`wrcontact.ContactSystem.stepper`."""
        if self._wanted == (side, outputs):
            return
        check_choice("side", side, SIDE_FLAGS)
        check_choice("outputs", outputs, DEPTHS)
        settings = layout.Tables.at(self._tables)
        settings.sides, settings.depth = SIDE_FLAGS[side], DEPTHS[outputs]
        layout.Work.at(self._workspace).known = False
        self._wanted = (side, outputs)


def _restored(mark, tables, bind, arrays, penetration, wanted):
    """A stepper that continues where another one is, if that is of this version."""
    check_mark(mark, "the stepper")
    stepper = Stepper(tables, bind)
    for own, kept in zip((stepper.inputs, stepper.outputs, stepper.state), arrays):
        own[:] = kept
    stepper._penetration, stepper._wanted = penetration, wanted
    return stepper


def core_count():
    """The number of cores that this process may use."""
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


def thread_count(threads, rows):
    """How many threads share a table of ``rows``: at most ``threads``, None for the cores that this process
    may use, and as many as have a block of rows each."""
    return min(threads or core_count(), max(1, rows // SHARED_ROWS))


def threaded_parts(steppers, rows, places=None):
    """As :meth:`Stepper.parts`, by several steppers that each have a thread; parts come as they are done."""
    free = SimpleQueue()
    for stepper in steppers:
        free.put(stepper)

    def evaluated(first):
        stepper, block = free.get(), slice(first, min(first + SHARED_ROWS, len(rows)))
        count = block.stop - first
        outputs, status = np.full((count, len(stepper.outputs)), math.nan), np.empty(count)
        stepper.step_many(rows[block], outputs, status)
        free.put(stepper)
        return block, outputs if places is None else outputs[:, places], status.astype(int)

    # blocks are handed out a few at a time, so that tables of all blocks never wait together
    starts = iter(range(0, len(rows), SHARED_ROWS))
    with ThreadPoolExecutor(len(steppers)) as pool:
        running = {pool.submit(evaluated, first) for _, first in zip(2 * steppers, starts)}
        while running:
            done = next(as_completed(running))
            running.remove(done)
            running.update(pool.submit(evaluated, first) for _, first in zip(range(1), starts))
            yield done.result()
