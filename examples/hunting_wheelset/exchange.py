"""Both FMUs for model exchange, coupled in one solver with a variable step: CVode, as fmpy has it.

    python -m examples.hunting_wheelset.exchange [FOLDER]

The wheelset has the states; its motion goes to the contact, whose forces go back, at every point that the
solver tries.  ``wheelset_exchange.c`` has the equations of wheelset.py, whose tables become its model
description.
"""

import sys
import tempfile
from ctypes import byref, c_long, c_void_p
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element, SubElement, tostring

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Model
from fmpy.sundials import CVodeSolver
from fmpy.sundials.cvode import CVodeSetMaxNumSteps, sundials_cvode

from wrcontact.fmu.archive import archive, fingerprint
from wrcontact.kernel.binding.compiler import compile_platform
from wrcontact.kernel.binding.files import PLATFORMS, host_platform

from .coupling import CONTACT, TO_CONTACT, TO_WHEELSET, Loop, Unit, build
from .hunting import LARGE, SOFT
from .wheelset import BASE, FORCE_UNITS, FORCES, MOTION, PARAMETERS, UNITS

MODEL = "WheelsetExchange"
SOURCE = Path(__file__).with_name("wheelset_exchange.c")
STATES = (*MOTION, "distance")
OUTPUTS = (*STATES, "speed", "track_curvature")
#: Sizes of the states, by which the solver weighs their errors: m, rad, m/s, rad/s.
NOMINAL = (1e-3, 1e-3, 1e-3, 1e-3, 1e-1, 1e-1, 1e-1, 1e-1, 1e2, 1.0)
#: Beyond the critical speed, over the limit cycle between the flanges.
HUNTS = SOFT | {"frame_speed": 45.0, "start_lateral_shift": LARGE}
DURATION, GRID = 0.5, 2e-3  # [s] of three swings, and between rows of a run
#: Of the table: relative tolerances of CVode, the last for comparison, and steps [s] without and with
#: derivatives.
TOLERANCES, FINEST = (1e-3, 1e-4, 1e-5, 1e-6), 1e-9
STEPS = {False: (4e-4, 2e-4, 1e-4, 5e-5, 2e-5), True: (4e-4, 2e-4, 1e-4)}


# --- the second FMU -----------------------------------------------------------------------------------------


def variables():
    """(name, unit, start, causality) of every variable; its place is its value reference."""
    rows = [(name, unit, start, "parameter") for name, (start, unit, _) in PARAMETERS.items()]
    rows += [(name, FORCE_UNITS[name], 0.0, "input") for name in FORCES]
    rows += [(name, UNITS[name], None, "output") for name in OUTPUTS]
    return rows + [(f"der({name})", None, None, "local") for name in STATES]


def header(guid):
    """The text of variables.h."""
    rows = variables()
    names = [name.replace(".", "_") for name, *_ in rows if not name.startswith("der(")]
    starts = [repr(start) for *_, start, causality in rows if causality == "parameter"]
    return "\n".join(
        [
            f'#define GUID "{guid}"',
            f"enum {{ {', '.join(names)}, VARIABLES = {len(rows)} }};",
            f"static const double START[] = {{{', '.join(starts)}}};",
            f"static const double NOMINAL[] = {{{', '.join(map(repr, NOMINAL))}}};",
            "",
        ]
    )


def description(guid):
    """The modelDescription.xml as bytes."""
    root = Element(
        "fmiModelDescription",
        fmiVersion="2.0",
        modelName=MODEL,
        guid=guid,
        numberOfEventIndicators="0",
        description="Wheelset on its primary suspension, for model exchange",
    )
    SubElement(root, "ModelExchange", modelIdentifier=MODEL, completedIntegratorStepNotNeeded="true")
    rows = variables()
    units = SubElement(root, "UnitDefinitions")
    for unit in dict.fromkeys(unit for _, unit, *_ in rows if unit):
        SubElement(
            SubElement(units, "Unit", name=unit),
            "BaseUnit",
            {base: str(exponent) for base, exponent in BASE[unit].items()},
        )
    table, states = SubElement(root, "ModelVariables"), len(PARAMETERS) + len(FORCES)
    for place, (name, unit, start, causality) in enumerate(rows):
        variable = SubElement(
            table,
            "ScalarVariable",
            name=name,
            valueReference=str(place),
            causality=causality,
            variability="fixed" if causality == "parameter" else "continuous",
        )
        real = SubElement(variable, "Real", {"unit": unit} if unit else {})
        if start is not None:
            real.set("start", repr(start))
        else:
            variable.set("initial", "calculated")
        if causality == "local":
            real.set("derivative", str(states + STATES.index(name[4:-1]) + 1))
    structure, first = SubElement(root, "ModelStructure"), len(rows) - len(STATES)
    outputs, derivatives = range(states, states + len(OUTPUTS)), range(first, len(rows))
    known = " ".join(str(place + 1) for place in range(states, states + len(STATES)))
    for section, places, follows in (
        ("Outputs", outputs, known),
        ("Derivatives", derivatives, None),
        ("InitialUnknowns", (*outputs, *derivatives), None),
    ):
        parent = SubElement(structure, section)
        for place in places:
            unknown = SubElement(parent, "Unknown", index=str(place + 1))
            if follows:
                unknown.set("dependencies", follows)
    return tostring(root, encoding="UTF-8", xml_declaration=True)


def build_exchange(folder):
    """Archive of the wheelset for model exchange in ``folder``, for this machine."""
    source, place = SOURCE.read_bytes(), PLATFORMS[host_platform()]
    guid = fingerprint({"source": source, "header": header("").encode(), "description": description("")})[:32]
    files = {SOURCE.name: source, "variables.h": header(guid).encode()}
    files |= {file.name: file.read_bytes() for file in Path(fmpy.__file__).parent.glob("c-code/fmi2*.h")}
    with tempfile.TemporaryDirectory() as scratch:
        for name, content in files.items():
            Path(scratch, name).write_bytes(content)
        library = compile_platform(host_platform(), scratch, [SOURCE.name], MODEL)
    target = Path(folder, f"{MODEL}.fmu")
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(
        archive(
            {
                "modelDescription.xml": description(guid),
                f"binaries/{place.fmi2}/{MODEL}{place.suffix}": library,
            }
        )
    )
    return target


# --- both in one solver -------------------------------------------------------------------------------------


class Model(Unit):
    """An instance for model exchange, which speaks in names."""

    slave_class = FMU2Model

    def start(self):
        super().start()
        self.slave.newDiscreteStates()
        self.slave.enterContinuousTimeMode()


@dataclass
class Travel:
    """What a run saw: ``time`` (n,) [s], ``motion`` (n, 10), the states; ``evaluations`` of the contact,
    ``steps`` of the solver, and the largest status at the end of a row."""

    time: np.ndarray
    motion: np.ndarray
    evaluations: int
    steps: int
    worst_status: int


class Coupled:
    """The contact and the wheelset, both for model exchange; ``archives`` are those of the two FMUs, the rest
    is as in :class:`~.coupling.Loop`."""

    def __init__(self, archives, wheelset=None, contact=None, friction=0.3):
        wheelset = dict(wheelset or {})
        self.contact = Model(archives[0], "contact", **CONTACT | (contact or {}))
        Loop.put(self.contact, Loop.loads(wheelset, friction))
        stand = self.contact.ports(["equilibrium.vertical_shift", "equilibrium.roll"]).read()
        given = {"start_vertical_shift": stand[0], "start_roll": stand[1]} | wheelset
        self.wheelset = Model(archives[1], "wheelset", **given)
        self.motion, self.moved = (
            unit.ports(names) for unit, names in zip((self.wheelset, self.contact), zip(*TO_CONTACT))
        )
        self.given, self.taken = (
            unit.ports(names) for unit, names in zip((self.contact, self.wheelset), zip(*TO_WHEELSET))
        )
        self.evaluations = 0
        self.connect()
        self.contact.start()
        self.wheelset.start()

    def connect(self):
        """Hand the motion to the contact, and its forces to the wheelset."""
        self.moved.write(self.motion.read())
        self.taken.write(self.given.read())
        self.evaluations += 1

    # --- what a solver asks for ---

    def set_time(self, time):
        self.contact.slave.setTime(time)
        self.wheelset.slave.setTime(time)

    def get_derivatives(self, rates, count):
        self.connect()
        self.wheelset.slave.getDerivatives(rates, count)

    def run(self, duration=DURATION, tolerance=1e-6, grid=GRID):
        """A :class:`Travel` with a row every ``grid`` [s], by CVode with this relative tolerance."""
        slave, self.evaluations = self.wheelset.slave, 0
        solver = CVodeSolver(
            len(STATES),
            0,
            slave.getContinuousStates,
            slave.setContinuousStates,
            self.get_derivatives,
            None,
            slave.getNominalsOfContinuousStates,
            self.set_time,
            None,
            0.0,
            relativeTolerance=tolerance,
        )
        CVodeSetMaxNumSteps(solver.cvode_mem, 100_000)
        motion, worst, now = [], 0, 0.0
        times, states = np.arange(round(duration / grid) + 1) * grid, self.wheelset.ports(STATES)
        for time in times:
            if time > now:
                _, _, now = solver.step(now, time)
            self.set_time(time)
            self.connect()
            self.evaluations -= 1  # for the row, not for the solver
            self.contact.slave.completedIntegratorStep()
            motion.append(states.read())
            worst = max(worst, self.contact.status())
        steps = c_long()
        sundials_cvode.CVodeGetNumSteps(c_void_p(solver.cvode_mem), byref(steps))
        return Travel(times, np.array(motion), self.evaluations, steps.value, worst)

    close, __enter__, __exit__ = Loop.close, Loop.__enter__, Loop.__exit__


def stepped(archives, step, duration=DURATION, derivatives=False, wheelset=HUNTS, grid=GRID):
    """The same by co-simulation with a fixed ``step`` [s]: a :class:`Travel`; each directional derivative
    counts as an evaluation."""
    with Loop(archives, wheelset, seen=("distance",)) as loop:
        run = loop.run(duration + grid, step, derivatives=derivatives, every=round(grid / step))
    count = round(duration / grid) + 1
    steps = round(duration / step)
    return Travel(
        run.time[:count],
        np.column_stack((run.motion, run["distance"]))[:count],
        steps * (1 + derivatives * len(MOTION)),
        steps,
        run.worst_status,
    )


def error(travel, wanted):
    """The largest difference of the lateral shift from that of a finer run [m], over all rows."""
    return float(np.abs(travel.motion[:, 0] - wanted.motion[:, 0]).max())


def solved(archives, tolerance, duration=DURATION, wheelset=HUNTS):
    """A :class:`Travel` by CVode; ``archives`` are the contact and the wheelset for model exchange."""
    with Coupled(archives, wheelset) as coupled:
        return coupled.run(duration, tolerance)


def study(archives, exchange):
    """(words, :class:`Travel`, error [m]) of every row of the table; ``archives`` are those of co-simulation,
    ``exchange`` the wheelset for model exchange."""
    pair = archives[0], exchange
    finest = solved(pair, FINEST)
    runs = [(f"CVode, tolerance {tolerance:.0e}", solved(pair, tolerance)) for tolerance in TOLERANCES]
    runs += [
        (
            f"{'with derivatives' if derivatives else 'explicit'}, {step * 1e3:g} ms",
            stepped(archives, step, derivatives=derivatives),
        )
        for derivatives, steps in STEPS.items()
        for step in steps
    ]
    return [(words, run, error(run, finest)) for words, run in runs]


if __name__ == "__main__":
    folder = Path((sys.argv[1:] or ["out"])[0])
    for words, run, missed in study(build(folder), build_exchange(folder)):
        print(
            f"{words}: {run.steps} steps, {run.evaluations} calls of the contact, {missed * 1e6:.3g} um, "
            f"status {run.worst_status}"
        )
