"""The FMU of a wheelset on its primary suspension, for the other half of the closed loop.

PythonFMU executes this file for every instance, so that it needs nothing but numpy and PythonFMU.  Beside it
lie the start values of parameters that are not the usual ones, in ``starts.json``, where there are any.  The bogie
frame runs along the middle of the track with a constant speed.  The wheelset moves across the track and down,
rolls and yaws, and turns about its axle; it has the frames and signs of docs/reference/conventions.md:

    m y'' + (1 - c) (W/g) V^2 k    = F_y - K_y y - D_y y'
    m z''                      = F_z + W - K_z (z - z_0) - D_z z'
    I_x q'' + I_y w_0 (p' + V k) = M_x cos p + M_y sin p - K_x q - D_x q'
    I_z (p'' + V k')  - I_y w_0 q' = M_z - K_p (p + l k) - D_p (p' + l k')
    I_y w'                     = T

y, z, q, p are lateral shift, vertical shift, roll and yaw, w the rotation about the axle, w_0 = V / r_0, k
the track's curvature, W the load of the frame and the weight.  F, M and T are the forces, moments about the
centre and the driving torque of the contact, c is the share of the load's centrifugal force that the cant
balances, and l how far the wheelset is ahead of the middle of the frame.

A step is one of two:

* without derivatives of the contact's forces, the forces stay what they are at its beginning: Euler's
  semi-implicit method, new velocities first, places with the new velocities; order 1;
* with derivatives (input ``derivative[i,j]``, of the i-th force by the j-th motion) the trapezoidal rule,
  linearised at the beginning of the step (a Rosenbrock method); order 2, and stable for any step.
"""

import json
import math
from pathlib import Path
from xml.etree.ElementTree import Element, SubElement

import numpy as np
from pythonfmu import Fmi2Causality, Fmi2Initial, Fmi2Slave, Fmi2Variability, Real

#: Outputs that say where the wheelset is and how it moves, and the inputs of the contact FMU for them.
PLACES = ("lateral_shift", "vertical_shift", "roll", "yaw")
RATES = ("lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate", "wheel_rate")
MOTION = PLACES + RATES
CONTACT_INPUTS = ("lateral_shift", "vertical_shift_input", "roll_input", "yaw", *RATES)
#: What the contact gives.
FORCES = ("force.y", "force.z", "moment.x", "moment.y", "moment.z", "driving_torque")
OTHER_OUTPUTS = {"speed": "m/s", "track_curvature": "1/m", "distance": "m", "energy": "J", "supply": "W"}
UNITS = dict(zip(MOTION, ("m", "m", "rad", "rad", "m/s", "m/s", "rad/s", "rad/s", "rad/s"))) | OTHER_OUTPUTS
FORCE_UNITS = dict(zip(FORCES, ("N", "N", "N.m", "N.m", "N.m", "N.m")))

#: Units by their SI exponents.
BASE = {
    "m": {"m": 1},
    "rad": {"rad": 1},
    "m/s": {"m": 1, "s": -1},
    "rad/s": {"rad": 1, "s": -1},
    "1/m": {"m": -1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "N/m": {"kg": 1, "s": -2},
    "N.s/m": {"kg": 1, "s": -1},
    "N.m": {"kg": 1, "m": 2, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "kg": {"kg": 1},
    "kg.m2": {"kg": 1, "m": 2},
}

#: File in the resources with the start values of an FMU that has its own.
STARTS = "starts.json"

GRAVITY = 9.81  # [m/s2]
#: Start value, unit and meaning of each parameter.
PARAMETERS = {
    "mass": (1500.0, "kg", "mass"),
    "inertia_roll": (900.0, "kg.m2", "moment of inertia about the x axis"),
    "inertia_pitch": (120.0, "kg.m2", "moment of inertia about the axle"),
    "inertia_yaw": (900.0, "kg.m2", "moment of inertia about the z axis"),
    "nominal_radius": (0.46, "m", "radius of the wheels at the running circle"),
    "load": (157e3, "N", "load on both rails: the weight and what the frame carries"),
    "frame_speed": (20.0, "m/s", "speed of the bogie frame"),
    "longitudinal_stiffness": (0.0, "N/m", "primary suspension of one axle box, along the track"),
    "lateral_stiffness": (0.0, "N/m", "primary suspension of one axle box, across the track"),
    "vertical_stiffness": (0.0, "N/m", "primary suspension of one axle box, vertical"),
    "longitudinal_damping": (0.0, "N.s/m", "primary suspension of one axle box, along the track"),
    "lateral_damping": (0.0, "N.s/m", "primary suspension of one axle box, across the track"),
    "vertical_damping": (0.0, "N.s/m", "primary suspension of one axle box, vertical"),
    "box_distance": (1.0, "m", "distance of an axle box from the middle"),
    "start_lateral_shift": (0.0, "m", "lateral shift at the start"),
    "start_vertical_shift": (
        0.0,
        "m",
        "vertical shift at the start, at which the frame's springs have only the load to carry",
    ),
    "start_roll": (0.0, "rad", "roll at the start"),
    "start_yaw": (0.0, "rad", "yaw at the start"),
    "start_lateral_velocity": (0.0, "m/s", "lateral velocity at the start"),
    "start_wheel_rate": (
        0.0,
        "rad/s",
        "rotation about the axle at the start; 0 means frame_speed / nominal_radius",
    ),
    "curve_curvature": (0.0, "1/m", "curvature of the track in the curve, positive to the right"),
    "curve_start": (0.0, "m", "distance at which the transition to the curve begins"),
    "canted": (1.0, None, "share of the load's centrifugal force that the cant balances"),
    "half_wheelbase": (
        0.0,
        "m",
        "how far the wheelset is ahead of the middle of the frame, which is a chord of the curve",
    ),
    "transition_length": (1.0, "m", "length of the transition, in which the curvature grows evenly"),
}


class Wheelset(Fmi2Slave):
    """A wheelset on its primary suspension as an FMI 2.0 co-simulation slave."""

    author = "wrcontact"
    description = "Wheelset on its primary suspension, which runs on the forces of a contact FMU"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.parameters = {name: row[0] for name, row in PARAMETERS.items()} | self._starts()
        self.forces = dict.fromkeys(FORCES, 0.0)
        self.derivatives = np.zeros((len(FORCES), len(MOTION)))
        self.linear = False  # whether a derivative was ever given
        self.distance = 0.0
        self.units = {}
        self._register()
        self.prepare()

    def _starts(self):
        """Start values that this FMU was built with, by name."""
        file = self.resources and Path(self.resources, STARTS)
        return json.loads(file.read_text()) if file and file.is_file() else {}

    # --- variables ------------------------------------------------------------------------------------------

    def _register(self):
        for name, (_, unit, meaning) in PARAMETERS.items():
            self._add(
                name,
                Fmi2Causality.parameter,
                unit,
                meaning,
                self.parameters[name],
                *self._parameter(name),
                variability=Fmi2Variability.fixed,
            )
        for name in FORCES:
            self._add(
                name,
                Fmi2Causality.input,
                FORCE_UNITS[name],
                "of the contact on the wheelset",
                0.0,
                *self._force(name),
            )
        for i in range(len(FORCES)):
            for j in range(len(MOTION)):
                self._add(
                    f"derivative[{i + 1},{j + 1}]",
                    Fmi2Causality.input,
                    None,
                    f"of {FORCES[i]} by {MOTION[j]}",
                    0.0,
                    *self._derivative(i, j),
                )
        for name, unit in UNITS.items():
            self._add(
                name, Fmi2Causality.output, unit, name.replace("_", " "), None, self._output(name), None
            )
        self.getters = [variable.getter for variable in self.vars.values()]
        self.setters = [variable.setter for variable in self.vars.values()]

    def _add(self, name, causality, unit, meaning, start, getter, setter, **more):
        """Many arguments because this is a row of the model description."""
        if causality == Fmi2Causality.output:
            more["initial"] = Fmi2Initial.calculated
        variable = Real(
            name, causality=causality, start=start, description=meaning, getter=getter, setter=setter, **more
        )
        self.units[name] = unit
        self.register_variable(variable, nested=False)

    def _force(self, name):
        return (lambda: self.forces[name]), (lambda value: self.forces.__setitem__(name, value))

    def _parameter(self, name):
        def give(value):
            """A master may read the state at the start before the initialisation ends."""
            self.parameters[name] = value
            self.prepare()

        return (lambda: self.parameters[name]), give

    def _derivative(self, i, j):
        def give(value):
            self.derivatives[i, j] = value
            self.linear = self.linear or value != 0.0

        return (lambda: self.derivatives[i, j]), give

    def _output(self, name):
        if name in PLACES:
            place = PLACES.index(name)
            return lambda: self.place[place]
        if name in RATES:
            place = RATES.index(name)
            return lambda: self.rate[place]
        return {
            "speed": lambda: self.parameters["frame_speed"],
            "track_curvature": lambda: self.curvature(self.distance)[0],
            "distance": lambda: self.distance,
            "energy": self.energy,
            "supply": self.supply,
        }[name]

    def get_real(self, vrs):
        """As the base class does it, in a fifth of its time."""
        getters = self.getters
        return [float(getters[vr]()) for vr in vrs]

    def set_real(self, vrs, values):
        setters = self.setters
        for vr, value in zip(vrs, values):
            setters[vr](value)

    def to_xml(self, model_options=None):
        """The model description, with what PythonFMU leaves out: units, the unknowns at the start, and
        dependencies: outputs follow from the state, which no input changes before the end of a step, and at
        the start from parameters alone."""
        root = super().to_xml(model_options or {})
        definitions = Element("UnitDefinitions")
        root.insert(list(root).index(root.find("CoSimulation")) + 1, definitions)
        for unit in dict.fromkeys(filter(None, self.units.values())):
            SubElement(
                SubElement(definitions, "Unit", name=unit),
                "BaseUnit",
                {base: str(exponent) for base, exponent in BASE[unit].items()},
            )
        for variable in root.iter("ScalarVariable"):
            if self.units[variable.get("name")]:
                variable.find("Real").set("unit", self.units[variable.get("name")])
        structure = root.find("ModelStructure")
        unknowns = SubElement(structure, "InitialUnknowns")
        given = " ".join(
            str(place + 1)
            for place, variable in enumerate(root.iter("ScalarVariable"))
            if variable.get("causality") == "parameter"
        )
        for output in structure.find("Outputs"):
            SubElement(unknowns, "Unknown", index=output.get("index"), dependencies=given)
            output.set("dependencies", "")
        return root

    # --- the model ------------------------------------------------------------------------------------------

    def prepare(self):
        """Inertia and suspension, and the state at the start; all of it in lists, whose few numbers Python
        handles faster than numpy does."""
        p = self.parameters
        boxes, arm = 2.0, p["box_distance"]

        def springs(kind):
            across, down = boxes * p[f"lateral_{kind}"], boxes * p[f"vertical_{kind}"]
            return [across, down, down * arm**2, boxes * p[f"longitudinal_{kind}"] * arm**2]

        self.stiffness, self.damping = springs("stiffness"), springs("damping")
        self.inertia = [p["mass"], p["mass"], p["inertia_roll"], p["inertia_yaw"], p["inertia_pitch"]]
        self.thrown = (1.0 - p["canted"]) * p["load"] / GRAVITY * p["frame_speed"] ** 2
        self.rolling = p["start_wheel_rate"] or p["frame_speed"] / p["nominal_radius"]
        self.gyroscopic = p["inertia_pitch"] * p["frame_speed"] / p["nominal_radius"]
        self.place = [p["start_lateral_shift"], p["start_vertical_shift"], p["start_roll"], p["start_yaw"]]
        self.rate = [p["start_lateral_velocity"], 0.0, 0.0, 0.0, self.rolling]
        self.distance = 0.0

    def curvature(self, distance):
        """Curvature of the track [1/m], and by how much it grows per metre [1/m2]."""
        p = self.parameters
        share = (distance - p["curve_start"]) / p["transition_length"]
        grows = p["curve_curvature"] / p["transition_length"] if 0.0 <= share < 1.0 else 0.0
        return p["curve_curvature"] * min(max(share, 0.0), 1.0), grows

    def suspension(self, bend, grows):
        """How far the springs are stretched (4,), and how fast the frame's end of them moves (4,), where the
        curvature is ``bend`` and grows by ``grows``."""
        p, (y, z, roll, yaw) = self.parameters, self.place
        ahead = p["half_wheelbase"]
        return (
            [y, z - p["start_vertical_shift"], roll, yaw + ahead * bend],
            [0.0, 0.0, 0.0, -ahead * grows * p["frame_speed"]],
        )

    def accelerations(self, distance):
        """Accelerations (5,) in the present state, with the contact's forces as they are."""
        f, rate, v = self.forces, self.rate, self.parameters["frame_speed"]
        turn = self.place[3]
        bend, grows = self.curvature(distance)
        stretched, moving = self.suspension(bend, grows)
        force = [
            f["force.y"] - self.thrown * bend,
            f["force.z"] + self.parameters["load"],
            f["moment.x"] * math.cos(turn)
            + f["moment.y"] * math.sin(turn)
            - self.gyroscopic * (rate[3] + v * bend),
            f["moment.z"] + self.gyroscopic * rate[2] - self.inertia[3] * v * v * grows,
        ]
        springs = [
            push - stiffness * way - damping * (speed - end)
            for push, stiffness, way, damping, speed, end in zip(
                force, self.stiffness, stretched, self.damping, rate, moving
            )
        ]
        return [push / inertia for push, inertia in zip([*springs, f["driving_torque"]], self.inertia)]

    def jacobian(self):
        """Derivatives (5, 9) of the accelerations by the motion, with those of the contact's forces."""
        turn, by = self.place[3], self.derivatives
        about_x = by[2] * math.cos(turn) + by[3] * math.sin(turn)
        about_x[3] += self.forces["moment.y"] * math.cos(turn) - self.forces["moment.x"] * math.sin(turn)
        matrix = np.vstack([by[0], by[1], about_x, by[4], by[5]])
        k = np.arange(4)
        matrix[k, k] -= self.stiffness
        matrix[k, 4 + k] -= self.damping
        matrix[2, 7] -= self.gyroscopic
        matrix[3, 6] += self.gyroscopic
        return matrix / np.array(self.inertia)[:, None]

    def do_step(self, current_time, step_size):
        way = self.parameters["frame_speed"] * step_size
        if self.linear:
            acceleration = self.accelerations(self.distance + way / 2)
            system = np.eye(9)
            system[:4, 4:8] = -step_size / 2 * np.eye(4)
            system[4:] -= step_size / 2 * self.jacobian()
            change = np.linalg.solve(system, step_size * np.array([*self.rate[:4], *acceleration])).tolist()
            self.place = [value + more for value, more in zip(self.place, change)]
            self.rate = [value + more for value, more in zip(self.rate, change[4:])]
        else:
            self.rate = [
                value + step_size * more for value, more in zip(self.rate, self.accelerations(self.distance))
            ]
            self.place = [value + step_size * more for value, more in zip(self.place, self.rate)]
        self.distance += way
        return all(map(math.isfinite, self.rate))

    def energy(self):
        """Kinetic energy and that of the springs [J]."""
        stretched, _ = self.suspension(*self.curvature(self.distance))
        return 0.5 * (
            sum(inertia * value**2 for inertia, value in zip(self.inertia, self.rate))
            + sum(stiffness * way**2 for stiffness, way in zip(self.stiffness, stretched))
        )

    def supply(self):
        """Power of all that is neither the contact's nor stored: load, dampers, and the frame that turns in a
        curve [W]."""
        rate, v = self.rate, self.parameters["frame_speed"]
        bend, grows = self.curvature(self.distance)
        stretched, moving = self.suspension(bend, grows)
        frame = sum(
            damping * (speed - end) * speed + stiffness * way * end
            for damping, speed, end, stiffness, way in zip(
                self.damping, rate, moving, self.stiffness, stretched
            )
        )
        return (
            self.parameters["load"] * rate[1]
            - frame
            - self.thrown * bend * rate[0]
            - self.gyroscopic * v * bend * rate[2]
            - self.inertia[3] * v * v * grows * rate[3]
        )
