"""A wheelset on its track: what is fixed, prepared once; poses are evaluated against it.

>>> import wrcontact
>>> system = wrcontact.ContactSystem(wheel="S1002", rail="UIC60", rail_inclination=1/40)
>>> state = system.evaluate(lateral_shift=1e-3, yaw=0.0, normal_force=78.5e3)
>>> state.status, round(state.right.contact.y_wheel, 6)
(<Status.VALID: 0>, -0.009357)
"""

import math
import threading
from inspect import signature

import numpy as np

from .kernel import layout
from .kernel.library import default_kernel
from .profiles.files import find_profile
from .profiles.placement import place_rail, readable_wheel
from .state import WheelsetState
from .status import Status
from .tables import build_tables

#: Permitted range and unit of every numeric parameter; ends included.
RANGES = {
    "rail_inclination": (0.0, 0.1, "1"),
    "gauge": (0.5, 2.0, "m"),
    "gauge_depth": (0.005, 0.035, "m"),
    "running_circle_distance": (0.5, 2.5, "m"),
    "nominal_radius": (0.1, 1.0, "m"),
    "youngs_modulus": (1e6, 1e13, "Pa"),
    "poisson_ratio": (0.0, 0.499, "1"),
    "tolerance": (1e-4, 0.1, "1"),
}

#: Smallest tolerance of the half-space model [1], halfspace.TOLERANCE_RANGE.
HALFSPACE_TOLERANCE = 3e-4

#: Numeric parameters that may be None: each method then uses its own.
OPTIONAL = ("tolerance",)

#: The methods that can be chosen, by parameter; the first one is the default.
CHOICES = {
    "contact_mode": ("rigid",),
    "load": ("normal",),
    "normal_model": ("analyn", "analyn_strip", "hertz"),
    "separation": ("normal",),
    "longitudinal_curvature": ("effective", "basic"),
    "lateral_curvature": ("smooth",),
}

#: Methods that need scipy, which an FMU does not carry: further choices in Python.
OFFLINE_CHOICES = {"normal_model": ("halfspace",)}

#: The half-space model takes nothing but the rigid geometry from the kernel, whose cheapest model is Hertz's.
KERNEL_NUMBERS = {"analyn": layout.MODEL_ANALYN, "analyn_strip": layout.MODEL_ANALYN_STRIP, "hertz": layout.MODEL_HERTZ,
                  "halfspace": layout.MODEL_HERTZ,
                  "effective": layout.LONGITUDINAL_EFFECTIVE, "basic": layout.LONGITUDINAL_BASIC}


class ContactSystem:
    """Wheel and rail profiles, track, material and methods of one wheelset.

    Parameters
    ----------
    wheel, rail : name of a standard profile, path of a profile file, or :class:`~wrcontact.profiles.Profile`.
    rail_inclination : tangent of the rail's inclination towards the track centre (1/40 = 0.025).
    gauge : distance of the rails' inner faces [m], measured ``gauge_depth`` [m] below the highest point of the rail.
    running_circle_distance : distance of the two running circles [m].
    nominal_radius : wheel radius at the running circle [m].
    youngs_modulus, poisson_ratio : of wheel and rail [Pa, 1].
    contact_mode : "rigid", contact where the undeformed profiles first touch.
    load : "normal", ``normal_force`` is the total over a wheel's patches.
    normal_model : "analyn" (Sichani et al. 2014), "hertz" (curvatures at the contact point), or "halfspace" (complete theory
        on the true three-dimensional gap, wrcontact/halfspace.py; in Python only, some hundredths of a second a wheel).
    separation : "normal", the undeformed distance is measured along the contact normal.
    longitudinal_curvature : "effective" (cut along the contact normal) or "basic" (1 / rolling radius).
    lateral_curvature : "smooth" (window proportional to the patch, see wrcontact/kernel/nodes.py).
    tolerance : relative error of the numerics in penetration, area and peak pressure, 1e-4 ... 0.1; None is each model's own
        (5e-3 for "halfspace", which reaches 3e-4).

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and permitted range or choices.
    """

    def __init__(self, wheel="S1002", rail="UIC60", rail_inclination=1 / 40, gauge=1.435, gauge_depth=0.014,
                 running_circle_distance=1.5, nominal_radius=0.46, youngs_modulus=210e9, poisson_ratio=0.28,
                 contact_mode="rigid", load="normal", normal_model="analyn", separation="normal",
                 longitudinal_curvature="effective", lateral_curvature="smooth", tolerance=None):
        given = dict(locals())
        self.parameters = {name: given[name] for name in signature(type(self)).parameters}
        for name, (low, high, unit) in RANGES.items():
            if name in OPTIONAL and self.parameters[name] is None:
                continue
            self.parameters[name] = _checked_number(name, self.parameters[name], low, high, unit)
        for name, choices in CHOICES.items():
            check_choice(name, self.parameters[name], choices + OFFLINE_CHOICES.get(name, ()))
        _check_halfspace(self.parameters)
        self.wheel = find_profile(wheel, "wheel")
        self.rail = find_profile(rail, "rail")
        self._tables = self._prepare()
        self._own = threading.local()

    def _prepare(self):
        chosen = self.parameters
        placed = place_rail(self.rail, inclination=chosen["rail_inclination"], gauge=chosen["gauge"],
                            gauge_depth=chosen["gauge_depth"])
        return build_tables(readable_wheel(self.wheel), placed, nominal_radius=chosen["nominal_radius"],
                            running_circle_distance=chosen["running_circle_distance"],
                            contact_modulus=chosen["youngs_modulus"] / (2 * (1 - chosen["poisson_ratio"] ** 2)),
                            normal_model=KERNEL_NUMBERS[chosen["normal_model"]],
                            longitudinal_curvature=KERNEL_NUMBERS[chosen["longitudinal_curvature"]])

    def __reduce__(self):
        return _rebuild, (type(self), self.parameters)

    def __repr__(self):
        default = signature(type(self)).parameters
        changed = [f"{name}={value!r}" for name, value in self.parameters.items() if value != default[name].default]
        return f"ContactSystem({', '.join(changed)})"

    def stepper(self):
        """A new :class:`Stepper`: one wheelset that is moved in time, with its own memory."""
        if self.parameters["normal_model"] == "halfspace":
            from .true_gap import HalfspaceStepper  # scipy is not needed before

            return HalfspaceStepper(self._tables, self.parameters["tolerance"])
        return Stepper(self._tables)

    def evaluate(self, lateral_shift=0.0, yaw=0.0, normal_force=78.5e3, load_transfer=0.0, roll_guess=0.0,
                 penetration=None):
        """The contact of both wheels at one pose.

        Parameters
        ----------
        lateral_shift : of the wheelset against the track centre [m], positive to the right.
        yaw : [rad], positive clockwise from above.
        normal_force : per wheel [N], total over its patches.
        load_transfer : share of it moved from the left to the right wheel, -1 ... 1.
        roll_guess : where the roll search starts [rad]; changes the cost, never the answer.
        penetration : prescribe the penetration [m] instead of the force: one value, or (left, right).

        Returns
        -------
        WheelsetState
            with its :class:`~wrcontact.status.Status`.  Status 2, 3 and 4 keep the values of the last valid evaluation
            in this thread; NaN if there was none.
        """
        stepper = getattr(self._own, "stepper", None)
        if stepper is None:
            stepper = self._own.stepper = self.stepper()
            stepper.outputs[:] = math.nan
        stepper.prescribe(penetration)
        inputs = stepper.inputs
        inputs[0], inputs[1], inputs[2], inputs[3], inputs[4] = (lateral_shift, yaw, roll_guess, normal_force,
                                                                 load_transfer)
        status = stepper.step()
        return WheelsetState(stepper.outputs.copy(), Status(status), inputs.copy())

    def evaluate_many(self, lateral_shift=0.0, yaw=0.0, normal_force=78.5e3, load_transfer=0.0, roll_guess=0.0,
                      penetration=None):
        """As :meth:`evaluate` for arrays (n,) that broadcast against each other; the same names hold arrays (n, ...).

        Rows with status 2, 3 or 4 are NaN.  ``penetration`` is one value, or (left, right), for all rows.
        """
        columns = np.broadcast_arrays(*(np.atleast_1d(np.asarray(column, dtype=float)) for column in
                                        (lateral_shift, yaw, roll_guess, normal_force, load_transfer)))
        if columns[0].ndim != 1:
            raise ValueError(f"the inputs broadcast to shape {columns[0].shape}; permitted are one-dimensional arrays")
        inputs = np.ascontiguousarray(np.stack(columns, axis=1))
        outputs = np.full((len(inputs), layout.OUTPUT_COUNT), math.nan)
        status = np.zeros(len(inputs))
        stepper = self.stepper()
        stepper.prescribe(penetration)
        stepper.step_many(inputs, outputs, status)
        return WheelsetState(outputs, status.astype(int), inputs)


class Stepper:
    """One wheelset moved in time: write ``inputs``, call :meth:`step`, read ``outputs``.

    Attributes
    ----------
    inputs : (5,) lateral_shift [m], yaw [rad], roll_guess [rad], normal_force [N], load_transfer [1].
    outputs : (270,) in the order of wrcontact/kernel/layout.py; SI.  Zero until the first valid step.
    state : (10,) where the next roll search starts, and counters; it never changes an answer.
    compiled : whether the compiled kernel is at work.
    """

    def __init__(self, tables):
        self._tables = tables.copy()
        self.inputs = np.zeros(layout.INPUT_COUNT)
        self.outputs = np.zeros(layout.OUTPUT_COUNT)
        self.state = np.zeros(layout.STATE_SIZE)
        self._bound = default_kernel().bind(self._tables, self.state, np.zeros(layout.WORK_SIZE), self.inputs,
                                            self.outputs)
        self.compiled = self._bound.compiled
        self.step = self._bound.step
        self._penetration = None

    def step(self):
        """Evaluate the inputs into the outputs; the status (an int).  Status 2, 3 and 4 leave the outputs as they are."""

    def step_many(self, inputs, outputs, status):
        """Evaluate rows of ``inputs`` (n, 5) into ``outputs`` (n, 270) and ``status`` (n,), C-contiguous float64."""
        self._bound.step_many(len(inputs), inputs, outputs, status)

    def prescribe(self, penetration):
        """Prescribe the penetration [m], one value or (left, right), instead of the force; None returns to the force."""
        if penetration is self._penetration:
            return
        left, right = np.broadcast_to(np.nan if penetration is None else np.asarray(penetration, dtype=float), 2)
        for side, value in (("left", left), ("right", right)):
            if not (math.isnan(value) or 0.0 <= value <= 0.01):
                raise ValueError(f"penetration ({side}) is {value:g} m; permitted is 0 ... 0.01 m")
        self._tables[layout.SET_PENETRATION_LEFT] = left
        self._tables[layout.SET_PENETRATION_RIGHT] = right
        self._penetration = penetration


def _checked_number(name, value, low, high, unit):
    """``value`` as a float within its range; ValueError otherwise."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not low <= number <= high:
        raise ValueError(f"{name} is {value!r}; permitted is {low:g} ... {high:g} {unit}")
    return number


def _check_halfspace(chosen):
    """ValueError, in a sentence, for what the half-space model cannot be combined with."""
    if chosen["normal_model"] != "halfspace":
        return
    if chosen["longitudinal_curvature"] != "effective":
        raise ValueError(f"longitudinal_curvature is {chosen['longitudinal_curvature']!r}; permitted with the normal_model "
                         "'halfspace', which knows the whole surface, is 'effective'")
    if chosen["tolerance"] is not None and chosen["tolerance"] < HALFSPACE_TOLERANCE:
        raise ValueError(f"tolerance is {chosen['tolerance']:g}; permitted with the normal_model 'halfspace' is "
                         f"{HALFSPACE_TOLERANCE:g} ... {RANGES['tolerance'][1]:g} 1")


def check_choice(name, value, choices):
    """ValueError, in a sentence that lists them, unless ``value`` is one of ``choices``."""
    if value not in choices:
        permitted = ", ".join(repr(choice) for choice in choices)
        raise ValueError(f"{name} is {value!r}; permitted are {permitted}" if len(choices) > 1 else
                         f"{name} is {value!r}; permitted is {permitted}")


def _rebuild(kind, parameters):
    return kind(**parameters)
