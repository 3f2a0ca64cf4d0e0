"""Two FMUs in a loop, by fmpy: the contact gives forces, the wheelset the motion.

A step of the loop with the wheelset's motion m_n at its beginning:

    forces F_n = contact(m_n)
    m_{n+1} = wheelset(m_n, F_n)                with the forces frozen: order 1
    m_{n+1} = wheelset(m_n, F_n, dF/dm_n)       with the contact FMU's directional derivatives: order 2

``parallel`` is what a master does that steps all FMUs at once and hands values on afterwards (libcosim's
fixed step, Jacobi's order): the wheelset then has the forces of the motion one step before.
"""

import json
import time
from ctypes import c_double, c_uint32
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave
from pythonfmu import FmuBuilder

from wrcontact.fmu.native import build_native_fmus

from .wheelset import CONTACT_INPUTS, FORCES, MOTION, STARTS

#: What goes from the wheelset to the contact, and back: (source, target).
TO_CONTACT = (*zip(MOTION, CONTACT_INPUTS), ("speed", "speed"), ("track_curvature", "track_curvature"))
TO_WHEELSET = tuple(zip(FORCES, FORCES))
#: Parameters of the contact FMU, where a run gives no others; S1002 on UIC60.
CONTACT = {"contact_mode": "compliant", "contact_damping": 1.0, "tangential_model": "strips"}
#: The same with cones of 1:20 on rails that are inclined alike.
CONES = CONTACT | {"wheel_profile": "cone20", "rail_inclination": 0.05}


def build_wheelset(folder, starts=None):
    """Archive of the wheelset in ``folder``; ``starts`` are start values of its parameters by name."""
    Path(folder).mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory() as scratch:
        file = Path(scratch, STARTS)
        file.write_text(json.dumps(starts or {}))
        script = Path(__file__).with_name("wheelset.py")
        return Path(FmuBuilder.build_FMU(str(script), dest=str(folder), project_files=[file]))


def build(folder):
    """Archives of the contact (native, FMI 2.0) and the wheelset in ``folder``."""
    return build_native_fmus(folder)[0], build_wheelset(folder)


def unpacked(archive):
    """The folder beside an archive with its contents, unpacked anew only if the archive is newer."""
    archive = Path(archive)
    folder = archive.with_suffix("")
    if not folder.is_dir() or folder.stat().st_mtime < archive.stat().st_mtime:
        fmpy.extract(str(archive), str(folder))
        folder.touch()
    return str(folder)


class Unit:
    """An instance of an FMU, which speaks in names."""

    slave_class = FMU2Slave

    def __init__(self, archive, name, /, **parameters):
        folder = unpacked(archive)
        description = fmpy.read_model_description(folder)
        self.reference = {v.name: v.valueReference for v in description.modelVariables}
        kind = description.coSimulation or description.modelExchange
        self.slave = self.slave_class(
            guid=description.guid,
            unzipDirectory=folder,
            instanceName=name,
            modelIdentifier=kind.modelIdentifier,
        )
        self.slave.instantiate()
        self.slave.setupExperiment(startTime=0.0)
        for name, value in parameters.items():
            write = self.slave.setString if isinstance(value, str) else self.slave.setReal
            write([self.reference[name]], [value])
        self.slave.enterInitializationMode()

    def ports(self, names):
        """A fixed list of Real variables, for ``read`` and ``write``."""
        return Ports(self.slave, [self.reference[name] for name in names])

    def start(self):
        self.slave.exitInitializationMode()

    def step(self, now, step):
        self.slave.doStep(now, step)

    def status(self):
        return self.slave.getInteger([self.reference["status"]])[0]

    def close(self):
        self.slave.terminate()
        self.slave.freeInstance()


class Ports:
    """Real variables of one instance, whose arrays for the calls of FMI are made once."""

    def __init__(self, slave, references):
        self.slave, self.count = slave, len(references)
        self.references = (c_uint32 * self.count)(*references)
        self.values = (c_double * self.count)()

    def read(self):
        self.slave.fmi2GetReal(self.slave.component, self.references, self.count, self.values)
        return list(self.values)

    def write(self, values):
        self.values[:] = values
        self.slave.fmi2SetReal(self.slave.component, self.references, self.count, self.values)


@dataclass
class Run:
    """What a run saw at the beginning of each step, and its last values.

    ``time`` (n,) [s]; ``motion``, ``forces`` and ``seen`` hold a row for each time; ``names`` are those of
    ``seen``, outputs of the contact or the wheelset that were asked for besides.  ``worst_status`` is the
    largest status of all steps; ``seconds`` is the time that the steps took, ``processor`` that of the
    processor [s].
    """

    names: tuple
    time: np.ndarray
    motion: np.ndarray
    forces: np.ndarray
    seen: np.ndarray
    worst_status: int
    seconds: float
    processor: float

    def __getitem__(self, name):
        """The column (n,) of a name; forces as the wheelset's inputs have them."""
        for names, table in ((MOTION, self.motion), (FORCES, self.forces), (self.names, self.seen)):
            if name in names:
                return table[:, names.index(name)]
        raise KeyError(name)


class Loop:
    """The contact and the wheelset, connected; both in their initial state.

    Parameters
    ----------
    archives : contact and wheelset.
    wheelset, contact : parameters of the two FMUs by name.
    friction : coefficient of both rails.
    seen : names of outputs of the contact, or of the wheelset, that a run records.
    """

    def __init__(self, archives, wheelset=None, contact=None, friction=0.3, seen=()):
        wheelset, parameters = dict(wheelset or {}), CONTACT | (contact or {})
        self.contact = Unit(archives[0], "contact", **parameters)
        self.put(self.contact, self.loads(wheelset, friction))
        self.stand = self.contact.ports(["equilibrium.vertical_shift", "equilibrium.roll"]).read()
        given = {"start_vertical_shift": self.stand[0], "start_roll": self.stand[1]} | wheelset
        self.wheelset = Unit(archives[1], "wheelset", **given)
        self.motion, self.moved = (
            unit.ports(names) for unit, names in zip((self.wheelset, self.contact), zip(*TO_CONTACT))
        )
        self.given, self.taken = (
            unit.ports(names) for unit, names in zip((self.contact, self.wheelset), zip(*TO_WHEELSET))
        )
        self.matrix = self.wheelset.ports(
            [f"derivative[{i + 1},{j + 1}]" for i in range(len(FORCES)) for j in range(len(MOTION))]
        )
        self.seen = tuple(seen)
        self.asked = [
            (unit, unit.ports([name]))
            for name in seen
            for unit in [self.wheelset if name in self.wheelset.reference else self.contact]
        ]
        self.now = 0.0
        self.moved.write(self.motion.read())
        self.contact.start()
        self.wheelset.start()
        self.taken.write(self.given.read())

    @staticmethod
    def loads(wheelset, friction):
        """Inputs of the contact by name that its equilibrium needs, and that stay as they are."""
        return {
            "normal_force": wheelset.get("load", 157e3) / 2,
            "lateral_shift": wheelset.get("start_lateral_shift", 0.0),
            "yaw": wheelset.get("start_yaw", 0.0),
            "left.friction": friction,
            "right.friction": friction,
        }

    @staticmethod
    def put(unit, values):
        unit.ports(values).write(list(values.values()))

    def derivatives(self):
        """Of the contact's forces (6,) by the motion (9,), at its present inputs: (6, 9)."""
        forces = [self.contact.reference[name] for name in FORCES]
        return np.array(
            [
                self.contact.slave.getDirectionalDerivative(forces, [self.contact.reference[name]], [1.0])
                for name in CONTACT_INPUTS
            ]
        ).T

    def run(self, duration, step, derivatives=False, parallel=False, every=1):
        """A :class:`Run` of ``duration`` [s] in steps of ``step`` [s], from where the last one ended; every
        ``every``-th of them is recorded."""
        count = round(duration / step)
        rows, worst, begin = [], 0, (time.perf_counter(), time.process_time())
        for k in range(count):
            now = self.now + k * step
            motion = self.motion.read()
            if not parallel:
                self.moved.write(motion)
            self.contact.step(now, step)
            forces = self.given.read()
            worst = max(worst, self.contact.status())
            if k % every == 0:
                rows.append(
                    (
                        now,
                        motion[: len(MOTION)],
                        forces,
                        [value for _, port in self.asked for value in port.read()],
                    )
                )
            if not parallel:
                self.taken.write(forces)
            if derivatives:
                self.matrix.write(self.derivatives().ravel())
            self.wheelset.step(now, step)
            if parallel:
                self.taken.write(forces)
                self.moved.write(self.motion.read())
        self.now += count * step
        taken = time.perf_counter() - begin[0], time.process_time() - begin[1]
        columns = [np.array(column) for column in zip(*rows)]
        return Run(self.seen, *columns, worst, *taken)

    def close(self):
        self.contact.close()
        self.wheelset.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
