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
from numbers import Integral

import numpy as np

from .kernel import layout
from .kernel.binding.setup import prepare_tables_of
from .methods.choices import check_choice
from .methods.resolution import resolve
from .profiles.find import find_profile
from .state import WheelsetState
from .status import Status
from .stepper import Stepper

#: Permitted range and unit of every numeric parameter; ends included.
RANGES = {
    "rail_inclination": (0.0, 0.1, "1"),
    "gauge": (0.5, 2.0, "m"),
    "gauge_depth": (0.005, 0.035, "m"),
    "running_circle_distance": (0.5, 2.5, "m"),
    "nominal_radius": (0.1, 1.0, "m"),
    "youngs_modulus": (1e6, 1e13, "Pa"),
    "poisson_ratio": (0.0, 0.499, "1"),
    "curvature_step": (0.02e-3, 5e-3, "m"),
    "curvature_reach": (0.1e-3, 10e-3, "m"),
    "tolerance": (1e-4, 0.1, "1"),
}

#: Those of track and wheelset, which with the profiles say where they can touch.
GEOMETRY = ("rail_inclination", "gauge", "gauge_depth", "running_circle_distance", "nominal_radius")

#: Numeric parameters that may be None: each method then uses its own.
OPTIONAL = ("tolerance",)

#: The methods that can be chosen, by parameter; the first one is the default.
CHOICES = {
    "contact_mode": ("rigid", "elastic", "compliant"),
    "load": ("normal", "vertical"),
    "normal_model": ("analyn", "analyn_strip", "hertz"),
    "separation": ("normal", "vertical", "equidistant", "equidistant_chord"),
    "longitudinal_curvature": ("effective", "basic"),
    "lateral_curvature": ("adaptive", "smooth", "rough"),
}

#: Methods that need scipy, which an FMU does not carry: further choices in Python.
OFFLINE_CHOICES = {"normal_model": ("halfspace",)}

#: The kernel's number of each choice.  The half-space model takes nothing but the rigid geometry from the kernel, whose
#: cheapest model is Hertz's.
METHOD_NUMBERS = {
    "contact_mode": {"rigid": layout.MODE_RIGID, "elastic": layout.MODE_ELASTIC, "compliant": layout.MODE_COMPLIANT},
    "load": {"normal": layout.LOAD_NORMAL, "vertical": layout.LOAD_VERTICAL},
    "normal_model": {"analyn": layout.MODEL_ANALYN, "analyn_strip": layout.MODEL_ANALYN_STRIP, "hertz": layout.MODEL_HERTZ,
                     "halfspace": layout.MODEL_HERTZ},
    "separation": {"normal": layout.SEPARATION_NORMAL, "vertical": layout.SEPARATION_VERTICAL,
                   "equidistant": layout.SEPARATION_EQUIDISTANT, "equidistant_chord": layout.SEPARATION_CHORD},
    "longitudinal_curvature": {"effective": layout.LONGITUDINAL_EFFECTIVE, "basic": layout.LONGITUDINAL_BASIC},
    "lateral_curvature": {"adaptive": layout.LATERAL_ADAPTIVE, "smooth": layout.LATERAL_SMOOTH,
                          "rough": layout.LATERAL_ROUGH},
}


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
    contact_mode : "rigid", contact where the undeformed profiles first touch; "elastic", the wheels sink in until each
        carries its load, and height and roll follow from that (wrcontact/kernel/wheelset/elastic.py); or "compliant", height and
        roll are inputs, and the loads follow.
    load : what ``normal_force`` is: "normal", the total over a wheel's patches, or "vertical", the vertical component of
        their resultant.
    normal_model : "analyn" (Sichani et al. 2014), "analyn_strip" (the same, put right by strips on one half-space), "hertz"
        (curvatures at the contact point), or "halfspace" (complete theory on the true three-dimensional gap,
        wrcontact/reference/halfspace.py; in Python only, some hundredths of a second a wheel,
        seconds where narrow patches lie far apart).
    separation : how the undeformed distance is measured that ANALYN starts from: "normal" (along the normal of the contact
        plane), "vertical" (at common lateral coordinate), "equidistant" (between points at equal arc length from the contact
        on wheel and rail, along the mean of their normals), or "equidistant_chord" (the same with nodes stepped off by a
        circle, as in the degree project); see wrcontact/kernel/contact/separation.py.
    longitudinal_curvature : "effective" (cut along the contact normal) or "basic" (1 / rolling radius).
    lateral_curvature : "adaptive" (window in proportion to the patch, see wrcontact/kernel/normal/nodes.py), or as in the degree
        project "smooth" (of a circle fitted to each profile over +- ``curvature_reach``) or "rough" (change of each
        profile's angle over ``curvature_step``).
    curvature_step : arc length from node to node of the "rough" lateral curvature [m].
    curvature_reach : half the width over which the "smooth" one fits its circle [m].
    tolerance : relative error of the numerics in penetration, area and peak pressure, as told in wrcontact/methods/resolution.py;
        None is each model's own, 0.01, and 0.005 for "halfspace".  "analyn" reaches 0.0015, "analyn_strip" 0.004,
        "halfspace" 0.0003.
    stations : of a patch's outline, 3 ... 201.
    nodes : per half-width of the interpenetration, 4 ... 38, and
    strips, sweeps : of the strip correction, 16 ... 64 and 1 ... 4, instead of what the tolerance asks for.
    smoothing : how far the curve may keep from the points of a profile file [m], in the mean of squares: 0 ... 0.5e-3, 0 is not
        at all; None is as far as their noise (docs/profiles.md).

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and permitted range or choices.
    """

    def __init__(self, wheel="S1002", rail="UIC60", rail_inclination=1 / 40, gauge=1.435, gauge_depth=0.014,
                 running_circle_distance=1.5, nominal_radius=0.46, youngs_modulus=210e9, poisson_ratio=0.28,
                 contact_mode="rigid", load="normal", normal_model="analyn", separation="normal",
                 longitudinal_curvature="effective", lateral_curvature="adaptive", curvature_step=0.2e-3,
                 curvature_reach=3e-3, tolerance=None, stations=31, nodes=None, strips=None, sweeps=None,
                 smoothing=None):
        given = dict(locals())
        self.parameters = {name: given[name] for name in signature(type(self)).parameters}
        for name, (low, high, unit) in RANGES.items():
            if name in OPTIONAL and self.parameters[name] is None:
                continue
            self.parameters[name] = _checked_number(name, self.parameters[name], low, high, unit)
        for name, choices in CHOICES.items():
            check_choice(name, self.parameters[name], choices + OFFLINE_CHOICES.get(name, ()))
        self.parameters["stations"] = _checked_stations(stations)
        _check_halfspace(self.parameters)
        self.resolution = resolve(self.parameters["normal_model"], self.parameters["tolerance"], nodes, strips, sweeps)
        self.wheel = find_profile(wheel, "wheel", smoothing)
        self.rail = find_profile(rail, "rail", smoothing)
        self._tables = self._prepare()
        self._own = threading.local()

    def _prepare(self):
        chosen = self.parameters
        methods = {name: numbers[chosen[name]] for name, numbers in METHOD_NUMBERS.items()}
        tables = prepare_tables_of(self.wheel, self.rail, parameters=chosen, methods=methods, resolution=self.resolution)
        tables[layout.SET_STATIONS] = chosen["stations"]
        return tables

    def profile_tables(self):
        """The profiles as the kernel reads them, for ``wrcontact.profiles.compiled.evaluate_table``: the wheel's table, that of
        the right rail as it leans, and the track coordinate of the rail's highest point [m]."""
        wheel, rail, scan = (int(self._tables[at]) for at in (layout.SET_WHEEL, layout.SET_RAIL, layout.SET_SCAN))
        return self._tables[wheel:rail], self._tables[rail:scan], float(self._tables[layout.SET_RAIL_Y])

    def __reduce__(self):
        return _rebuild, (type(self), self.parameters)

    def __repr__(self):
        default = signature(type(self)).parameters
        changed = [f"{name}={value!r}" for name, value in self.parameters.items() if value != default[name].default]
        return f"ContactSystem({', '.join(changed)})"

    def stepper(self, side="both", outputs="all"):
        """A new :class:`Stepper`: one wheelset that is moved in time, with its own memory.

        What is not wanted is not computed, and is NaN in its outputs.

        Parameters
        ----------
        side : "both", "left" or "right"; roll and vertical shift are there in any case.
        outputs : "all", "patches" (no outline), or "geometry" (contact point, angle, rolling radius, curvatures).
        """
        stepper = self._new_stepper()
        stepper.want(side, outputs)
        return stepper

    def _new_stepper(self):
        if self.parameters["normal_model"] == "halfspace":
            from .reference.stepping import halfspace_solver  # scipy is not needed before

            return Stepper(self._tables, halfspace_solver(self.parameters["tolerance"]))
        return Stepper(self._tables)

    def evaluate(self, lateral_shift=0.0, yaw=0.0, normal_force=78.5e3, load_transfer=0.0, roll_guess=0.0,
                 penetration=None, side="both", outputs="all", vertical_shift_input=0.0, roll_input=0.0):
        """The contact of both wheels at one pose.

        Parameters
        ----------
        lateral_shift : of the wheelset against the track centre [m], positive to the right.
        yaw : [rad], positive clockwise from above.
        normal_force : per wheel [N], total over its patches.
        load_transfer : share of it moved from the left to the right wheel, -1 ... 1.
        roll_guess : where the roll search starts [rad]; changes the cost, never the answer.
        penetration : prescribe the penetration [m] instead of the force: one value, or (left, right); rigid contact only.
        vertical_shift_input, roll_input : height [m], positive down, and roll [rad] of the compliant form, which the other
            contact modes do not read; a wheel above its rail is lifted and carries nothing.
        side, outputs : what is wanted, as for :meth:`stepper`; the rest is NaN.

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
        stepper.want(side, outputs)
        inputs = stepper.inputs
        inputs[0], inputs[1], inputs[2], inputs[3], inputs[4], inputs[5], inputs[6] = (
            lateral_shift, yaw, roll_guess, normal_force, load_transfer, vertical_shift_input, roll_input)
        status = stepper.step()
        return WheelsetState(stepper.outputs.copy(), Status(status), inputs.copy())

    def evaluate_many(self, lateral_shift=0.0, yaw=0.0, normal_force=78.5e3, load_transfer=0.0, roll_guess=0.0,
                      penetration=None, side="both", outputs="all", vertical_shift_input=0.0, roll_input=0.0):
        """As :meth:`evaluate` for arrays (n,) that broadcast against each other; the same names hold arrays (n, ...).

        Rows with status 2, 3 or 4 are NaN.  ``penetration`` is one value, or (left, right), for all rows.
        """
        columns = np.broadcast_arrays(*(np.atleast_1d(np.asarray(column, dtype=float)) for column in
                                        (lateral_shift, yaw, roll_guess, normal_force, load_transfer,
                                         vertical_shift_input, roll_input)))
        if columns[0].ndim != 1:
            raise ValueError(f"the inputs broadcast to shape {columns[0].shape}; permitted are one-dimensional arrays")
        inputs = np.ascontiguousarray(np.stack(columns, axis=1))
        stepper = self.stepper(side, outputs)
        values = np.full((len(inputs), len(stepper.outputs)), math.nan)
        status = np.zeros(len(inputs))
        stepper.prescribe(penetration)
        stepper.step_many(inputs, values, status)
        return WheelsetState(values, status.astype(int), inputs)


def _checked_number(name, value, low, high, unit):
    """``value`` as a float within its range; ValueError otherwise."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not low <= number <= high:
        raise ValueError(f"{name} is {value!r}; permitted is {low:g} ... {high:g} {unit}")
    return number


def _checked_stations(stations):
    """``stations`` as an int within its range; ValueError otherwise."""
    low, high = layout.STATION_LEAST, layout.STATION_LIMIT
    if isinstance(stations, bool) or not isinstance(stations, Integral) or not low <= stations <= high:
        raise ValueError(f"stations is {stations!r}; permitted are whole numbers, {low} ... {high}")
    return int(stations)


def _check_halfspace(chosen):
    """ValueError, in a sentence, for what the half-space model cannot be combined with."""
    if chosen["normal_model"] != "halfspace":
        return
    for name in ("contact_mode", "load"):
        if chosen[name] != CHOICES[name][0]:
            raise ValueError(f"{name} is {chosen[name]!r}; permitted with the normal_model 'halfspace', which solves one wheel "
                             f"at its rigid contact, is {CHOICES[name][0]!r}")
    for name in ("longitudinal_curvature", "separation", "lateral_curvature"):
        if chosen[name] != CHOICES[name][0]:
            raise ValueError(f"{name} is {chosen[name]!r}; permitted with the normal_model 'halfspace', which knows the whole "
                             f"surface, is {CHOICES[name][0]!r}")


def _rebuild(kind, parameters):
    return kind(**parameters)
