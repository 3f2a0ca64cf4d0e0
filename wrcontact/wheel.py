"""One wheel on one rail: an independently rotating wheel, one of a tram, a flexible axle or a roller rig.

>>> import wrcontact
>>> wheel = wrcontact.WheelContact(wheel="S1002", rail="UIC60", tangential_model="strips")
>>> state = wheel.evaluate(lateral_shift=1e-3, vertical_shift_input=1.4e-4, speed=20.0, wheel_rate=43.6)
>>> state.status, state.patch_count, state.force.x > 0.0 > state.driving_torque
(<Status.VALID: 0>, 1, True)
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Any, Generic, Literal, overload

from numpy.typing import ArrayLike, NDArray

from .interface.calls import describe_wheel_inputs
from .interface.one_wheel import checked_wheel, unknown_wheel_input, unknown_wheel_output, wheel_inputs
from .kernel import layout
from .methods.numbers import check_choice
from .profiles.changing import refuse_changing
from .results.columns import DEPTH_SIZES
from .results.layout import SIDE_STARTS
from .results.names import listed
from .results.views import N
from .state import K, S, Side, WheelsetState
from .stepper import Stepper
from .system import ContactSystem

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .keywords import Depth, OneProfile, Wanted, WheelInputs, WheelKeywords


class WheelState(Side[N, K], Generic[N, K, S]):
    """Result of one wheel: what a wheelset's state has of this side, ``state.right``, and the status.

    Attributes
    ----------
    side : "right" or "left".
    status : a :class:`~wrcontact.Status`; (n,) of a table.
    inputs : those of the wheel by name.
    names : of the outputs; ``state["patch[1].area"]`` is the value of one, ``state["speed"]`` that of an
        input, ``table[3]`` the state of a row.
    """

    __slots__ = ("side", "_state")

    def __init__(self, state: WheelsetState[N, K, S], side: Literal["left", "right"]) -> None:
        """The wheel of this ``side`` of a wheelset's ``state``."""
        super().__init__(state._values, SIDE_STARTS[side], state.layout)
        self._state, self.side = state, side

    @property
    def status(self) -> S:
        """Status of the evaluation."""
        return self._state.status

    @property
    def inputs(self) -> dict[str, N]:
        """Inputs by name."""
        return {own: self._state[row.name] for own, row in wheel_inputs(self.side).items()}

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the outputs that are there: ``patch_count``, ..., ``patch[1].area``, ..."""
        return tuple(name.partition(".")[2] for name in self._state.names if name.startswith(f"{self.side}."))

    @overload
    def __getitem__(self, key: str) -> N: ...
    @overload
    def __getitem__(self, key: int) -> WheelState: ...
    @overload
    def __getitem__(
        self, key: slice | NDArray[Any]
    ) -> WheelState[NDArray[Any], NDArray[Any], NDArray[Any]]: ...
    def __getitem__(self, key):
        """An output or input by its name, ``state["patch[1].area"]``; of a table also a row or rows."""
        if not isinstance(key, str):
            return WheelState(self._state[key], self.side)
        if key == "status":
            return self.status
        row = wheel_inputs(self.side).get(key)
        return self._state[row.name if row else f"{self.side}.{key}"]

    def _as_table(self):
        """This table; of one pose a table of one row."""
        return WheelState(self._state._as_table(), self.side)

    def to_dict(self) -> dict[str, Any]:
        """Status, inputs and all outputs by name, dicts in dicts."""
        single = self._values.ndim == 1
        status = int(self.status) if single else self.status
        return {"status": status, "inputs": self.inputs, **super().to_dict()}


class WheelSystem(ContactSystem):
    """A system whose wheels belong to no wheelset: none turns with another one."""

    def _set_up(self, *given):
        super()._set_up(*given)
        refuse_changing(self, "a WheelContact")
        layout.Tables.at(self._tables).alone = True


class WheelContact:
    """One wheel on one rail, with six degrees of freedom and its own rotation.

    Its pose is that of the wheelset of which it would be a wheel: height and yaw, roll and lateral shift are
    inputs, as in the ``contact_mode`` "compliant", and force and moment follow.  The reference point, C, is
    on the wheel's axis, half the ``running_circle_distance`` inside of the running circle: the wheelset's
    centre in the nominal position.  Moments are about it.

    Parameters
    ----------
    wheel, rail : as for :class:`~wrcontact.ContactSystem`; one each.
    side : "right", or "left" for a wheel on the left rail.
    parameters : other keywords of :class:`~wrcontact.ContactSystem`, without those of the left side and
        without ``load``.

    Attributes
    ----------
    side : "right" or "left".
    system : the :class:`~wrcontact.ContactSystem` whose side this is.

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and permitted range or choices.
    """

    side: Literal["left", "right"]
    system: ContactSystem

    def __init__(
        self,
        wheel: OneProfile = "S1002",
        rail: OneProfile = "UIC60",
        *,
        side: Literal["left", "right"] = "right",
        **parameters: Unpack[WheelKeywords],
    ) -> None:
        check_choice("side", side, SIDE_STARTS)
        self.side = side
        self.system = WheelSystem(**checked_wheel({"wheel": wheel, "rail": rail, **parameters}))

    def __repr__(self) -> str:
        inside = repr(self.system).partition("(")[2]
        return f"WheelContact(side={self.side!r}, {inside}"

    @cached_property
    def _rows(self):
        """Rows of the inputs by the wheel's names."""
        return wheel_inputs(self.side)

    def evaluate(self, *, outputs: Wanted = "all", **inputs: Unpack[WheelInputs]) -> WheelState:
        """The contact at one pose: a :class:`WheelState`, NaN where its status is 2, 3 or 4.

        Parameters
        ----------
        {inputs}
        outputs : "all", "patches" (no outline), "geometry", or names of outputs; the rest is NaN.
        """
        return WheelState(
            self.system.evaluate(side=self.side, outputs=self._outputs(outputs), **self._inputs(inputs)),
            self.side,
        )

    def evaluate_many(
        self,
        *,
        outputs: Wanted = "all",
        processes: int = 1,
        threads: int | None = None,
        **inputs: ArrayLike,
    ) -> WheelState[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """As :meth:`evaluate` for arrays (n,) that broadcast against each other; the same names hold arrays
        (n, ...).

        ``processes`` and ``threads`` as for :meth:`wrcontact.ContactSystem.evaluate_many`.
        """
        return WheelState(
            self.system.evaluate_many(
                side=self.side,
                outputs=self._outputs(outputs),
                processes=processes,
                threads=threads,
                **self._inputs(inputs),
            ),
            self.side,
        )

    def stepper(self, outputs: Depth = "all") -> Stepper:
        """A :class:`~wrcontact.Stepper` that computes this wheel alone.

        Its inputs and outputs have the names of a wheelset, ``right.friction`` and ``right.force.x``; what
        belongs to the wheelset or the other wheel is NaN.
        """
        return self.system.stepper(self.side, outputs)

    def derivatives(
        self, of: Iterable[str], by: Iterable[str], **inputs: Unpack[WheelInputs]
    ) -> NDArray[Any]:
        """How outputs follow inputs at one pose, an array (len(of), len(by)); as
        :meth:`wrcontact.ContactSystem.derivatives`, with the wheel's names: ``of=["force.y"]``,
        ``by=["rail_lateral"]``."""
        stepper = self.stepper()
        for name in listed("of", of):
            if f"{self.side}.{name}" not in stepper.output_names:
                raise unknown_wheel_output(name, self.side, stepper.output_names)
        for name, value in inputs.items():
            stepper.inputs[stepper.place(self._row(name).name)] = value
        return stepper.derivatives(
            self._prefixed(listed("of", of)), [self._row(name).name for name in listed("by", by)]
        )

    def _row(self, name):
        """The row of an input by the wheel's name."""
        if name not in self._rows:
            raise unknown_wheel_input(name)
        return self._rows[name]

    def _inputs(self, given):
        """The wheelset's keywords for those of the wheel."""
        return {self._row(name).keyword: value for name, value in given.items()}

    def _outputs(self, outputs):
        """What is wanted in the wheelset's names."""
        if isinstance(outputs, str):
            return outputs if outputs in DEPTH_SIZES else self._prefixed([outputs])
        return self._prefixed(outputs)

    def _prefixed(self, names):
        return [name if name == "status" else f"{self.side}.{name}" for name in names]


describe_wheel_inputs(WheelContact.evaluate, wheel_inputs("right"))
