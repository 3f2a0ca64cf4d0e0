"""Results of an evaluation: names for the kernel's output array, for one pose or for a table of poses.

Names, units and words of the properties are those of the rows in wrcontact/interface/outputs.py.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from .interface.index import PLACES
from .interface.inputs import INPUT_NAMES
from .kernel.layout import PATCH_LIMIT, PATCH_OUTPUTS_SIZE, SIDE_PATCH, SIDE_PATCH_COUNT, STRIP_OUTPUTS_SIZE
from .methods.words import did_you_mean
from .results.columns import Kept
from .results.fields import Outline, PatchFields, SideFields, Strips, WheelsetFields, WornOutline
from .results.inputs import Inputs, Rows
from .results.layout import SIDE_STARTS, USUAL, Layout
from .results.views import N, number
from .results.words import shown, unit_name
from .status import Status

if TYPE_CHECKING:
    from typing_extensions import TypeVar

    K = TypeVar("K", default=int)
    S = TypeVar("S", default=Status)
else:
    from typing import TypeVar

    K, S = TypeVar("K"), TypeVar("S")  # of one pose or a table: a count, and a status

#: Numbers of a wheel in the summary of one pose, and their units.
IN_SUMMARY = (("contact_angle", "rad"), ("normal_force", "N"), ("area", "m2"), ("max_pressure", "Pa"))


class Patch(PatchFields[N]):
    """One contact patch."""

    __slots__ = ()
    _shown = ("normal_force", "area", "max_pressure", "length", "width", "contact_angle", "y_track")

    def __bool__(self) -> bool:
        """Whether the patch is there, in a table whether it is in any row."""
        return bool(np.any(np.asarray(self.area) > 0.0))


class Side(SideFields[N], Generic[N, K]):
    """One wheel on its rail."""

    __slots__ = ()
    _members = (*SideFields._members, "patches", "outline")
    _shown = ("patch_count", "contact_angle", "penetration", "normal_force", "area", "max_pressure")

    @property
    def patch_count(self) -> K:
        """Number of patches, of one pose an int; ``patches`` has the three with the largest load."""
        count: Any = self._number(SIDE_PATCH_COUNT)
        return int(count) if isinstance(count, float) and count == count else count

    @property
    def patches(self) -> tuple[Patch[N], ...]:
        """Patches by decreasing load; in a table always three, with zeros for missing ones."""
        start, size = self._offset + SIDE_PATCH, PATCH_OUTPUTS_SIZE
        count: Any = self.patch_count if self._values.ndim == 1 else PATCH_LIMIT
        return tuple(
            Patch(self._values, start + size * k, self.layout) for k in range(PATCH_LIMIT) if k < count
        )

    @property
    def outline(self) -> Outline[N]:
        """Outline and pressure over the loaded width."""
        kind = WornOutline if self.layout.wear else Outline
        return kind(self._values, self.layout, self._side)

    @property
    def strips(self) -> tuple[Strips[N], ...]:
        """The :class:`Strips` of each of ``patches``; with wear_outputs only."""
        if not self.layout.wear:
            raise AttributeError("strips are not computed; they need ContactSystem(wear_outputs=True)")
        first, size = self.layout.strips(self._side)[0], STRIP_OUTPUTS_SIZE
        return tuple(Strips(self._values, first + size * k, self.layout) for k in range(len(self.patches)))

    @property
    def _side(self) -> str:
        return "right" if self._offset == SIDE_STARTS["right"] else "left"

    def to_dict(self) -> dict[str, Any]:
        """All values by name, as those of every part of a result; strips where they are computed."""
        found = super().to_dict()
        if self.layout.wear:
            found["strips"] = [strips.to_dict() for strips in self.strips]
        return found


class Equilibrium(NamedTuple):
    """Height and roll of a wheelset at which both wheels carry their loads.

    vertical_shift [m], roll [rad] : NaN where there are none; (n,) of a table.
    status : that of the elastic wheelset that stands there.
    """

    vertical_shift: float
    roll: float
    status: int


class WheelsetState(WheelsetFields[N], Generic[N, K, S]):
    """Result of an evaluation.

    Attributes
    ----------
    status : a :class:`~wrcontact.Status`; (n,) of a table, likewise the numbers that follow.
    roll [rad], vertical_shift [m], force [N], moment [N m] : of the wheelset; see their own words.
    left, right : a :class:`Side` each.
    names : of the outputs; ``state["right.area"]`` is the value of one, ``table[3]`` the state of a row.
    inputs : an array with names, ``state.inputs.yaw``; see :class:`~wrcontact.results.inputs.Inputs`.
    values : the kernel's outputs, likewise; ``layout`` says where they lie.
    """

    __slots__ = ("values", "status", "_inputs", "_places", "_system", "_equilibrium")
    _members = (*WheelsetFields._members, "left", "right")

    def __init__(
        self,
        values: NDArray[Any],
        status: S,
        inputs: Any,
        layout: Layout = USUAL,
        kept: NDArray[Any] | None = None,
        system: Any = None,
    ) -> None:
        """``layout`` says where the kernel's outputs lie; ``kept`` are the places of the columns of ``values`` among
        them, None for all.  ``system`` finds the equilibrium."""
        if values.shape[-1] != (layout.size if kept is None else len(kept)):
            raise ValueError(
                f"values has rows of {values.shape[-1]} numbers, those of the layout have {layout.size}"
            )
        self.values = values
        self.status = status
        self._inputs = inputs
        self._places = kept
        self._system, self._equilibrium = system, None
        self._values = values if kept is None else Kept(values, kept, layout.size)
        self._offset, self.layout = 0, layout

    @classmethod
    def of_pose(cls, values: NDArray[Any], status: S, inputs: bytes, layout: Layout, system: Any) -> Any:
        """The state of one pose with all outputs, ``values`` (m,) of this ``layout``; ``inputs`` are the bytes of their
        array, which is made when it is asked for."""
        state = cls.__new__(cls)
        state.values = state._values = values
        state.status, state._inputs, state.layout = status, inputs, layout
        state._offset, state._places, state._system, state._equilibrium = 0, None, system, None
        return state

    @property
    def inputs(self) -> Inputs:
        """The inputs by name and place, :class:`~wrcontact.results.inputs.Inputs`."""
        if self._inputs is None:
            return None
        if isinstance(self._inputs, bytes):
            self._inputs = np.frombuffer(self._inputs).copy()
        rows = self._inputs[:] if isinstance(self._inputs, Rows) else self._inputs
        return Inputs.of(rows, self._system is not None)

    @property
    def left(self) -> Side[N, K]:
        """The left wheel."""
        return Side(self._values, SIDE_STARTS["left"], self.layout)

    @property
    def right(self) -> Side[N, K]:
        """The right wheel."""
        return Side(self._values, SIDE_STARTS["right"], self.layout)

    @property
    def equilibrium(self) -> Equilibrium:
        """Where both wheels carry the load of the inputs, an :class:`Equilibrium`; found when it is asked for
        first.  A compliant wheelset starts at rest from there; in other modes it is where it stands."""
        if self._equilibrium is None:
            self._equilibrium = (
                Equilibrium(self.vertical_shift, self.roll, self.status)
                if self._system is None
                else self._system.find_equilibrium(self.inputs)
            )
        return self._equilibrium

    @property
    def rows_of_inputs(self) -> Any:
        """The :class:`~wrcontact.results.inputs.Rows` of a table."""
        return self._inputs

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the outputs that are there, as in an FMU: ``roll``, ..., ``right.patch[1].area``, ..."""
        return self.layout.names(self._places)

    @overload
    def __getitem__(self, key: str) -> N: ...
    @overload
    def __getitem__(self, key: int) -> WheelsetState: ...
    @overload
    def __getitem__(
        self, key: slice | NDArray[Any]
    ) -> WheelsetState[NDArray[Any], NDArray[Any], NDArray[Any]]: ...
    def __getitem__(self, key):
        """An output or input by its name, ``state["right.patch[1].area"]``: a float, (n,) of a table.

        Of a table also a row, ``table[3]``, the state of one pose; or rows, ``table[2:5]`` or
        ``table[table.status == 0]``, a table.
        """
        if isinstance(key, str):
            return self._named(key)
        if self.values.ndim == 1:
            raise TypeError(f"the state of one pose has no row {key!r}; permitted are names of outputs")
        if np.ndim(key) == 0 and not isinstance(key, slice):
            values = self.values[key] if self._places is None else self._values.row(key)
            status = Status(int(self.status[key]))
            return WheelsetState(values, status, self._inputs.part(key), self.layout, system=self._system)
        return WheelsetState(
            self.values[key],
            self.status[key],
            self._inputs.part(key),
            self.layout,
            self._places,
            self._system,
        )

    def _named(self, name):
        """The output or input of this name."""
        if name == "status":
            return self.status
        if name.startswith("equilibrium."):
            return getattr(self.equilibrium, name.partition(".")[2])
        if name in INPUT_NAMES:
            return number(self._inputs.column(PLACES[name])) if self.values.ndim > 1 else self.inputs[name]
        place = self.layout.places.get(name)
        if place is None:
            meant = did_you_mean(name, ("status", *INPUT_NAMES, *self.layout.places))
            raise KeyError(f"there is no output {name!r}{meant or '; .names lists them'}")
        return number(self._values[..., place])

    def to_dict(self) -> dict[str, Any]:
        """Status, inputs and all outputs by name, dicts in dicts: of one pose numbers and lists, of a table
        arrays (n, ...)."""
        single = self.values.ndim == 1
        status = int(self.status) if single else self.status
        inputs = {} if self.inputs is None else self.inputs.to_dict()
        return {"status": status, "inputs": inputs, **super().to_dict()}

    def to_pandas(self) -> Any:
        """A pandas.DataFrame: one row per pose, columns with the names of an FMU."""
        from .results import convert  # not part of an FMU

        return convert.to_pandas(self._as_table())

    def to_xarray(self) -> Any:
        """A xarray.Dataset with the dimensions pose, side, patch, station_number and axis."""
        from .results import convert  # not part of an FMU

        return convert.to_xarray(self._as_table())

    def _as_table(self):
        """This table; of one pose a table of one row."""
        if self.values.ndim > 1:
            return self
        return WheelsetState(
            self.values[None],
            np.array([int(self.status)]),
            self._inputs.as_table()
            if isinstance(self._inputs, Rows)
            else Rows(np.asarray(self.inputs), [], np.empty((1, 0))),
            self.layout,
            system=self._system,
        )

    @property
    def summary(self) -> str:
        """The outcome in words: how many rows a table has, and of which status they are; status, roll and the
        main numbers of both wheels of one pose."""
        if self.values.ndim == 1:
            return self._one_in_words()
        counts = {
            kind.name.lower().replace("_", " "): np.count_nonzero(self.status == kind) for kind in Status
        }
        said = ", ".join(f"{count} {words}" for words, count in counts.items() if count)
        return f"{len(self)} poses: {said}" if said else "0 poses"

    def _one_in_words(self):
        words = [Status(int(self.status)).name.lower().replace("_", " ")]
        words += [f"roll {shown(self.roll, 'rad')} deg"] * (self.roll == self.roll)
        for name in SIDE_STARTS:
            side = getattr(self, name)
            numbers = [
                f"{shown(self[f'{name}.{key}'], unit)} {unit_name(unit)}"
                for key, unit in IN_SUMMARY
                if np.isfinite(self[f"{name}.{key}"])
            ]
            count = side.patch_count
            if count == count:
                numbers.insert(0, f"{count} patch{'es' if count != 1 else ''}")
            words += [f"{name} {', '.join(numbers)}"] * bool(numbers)
        return "; ".join(words)

    def __repr__(self) -> str:
        if self.values.ndim > 1:
            return f"WheelsetState({self.summary})"
        return (
            f"WheelsetState(status={self.status!r}, roll={self.roll:.6g} rad, "
            f"vertical_shift={self.vertical_shift:.6g} m)"
        )

    def _repr_html_(self):
        from .results import pages

        return pages.page(self)
