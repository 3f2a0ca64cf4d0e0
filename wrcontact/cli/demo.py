"""``wrcontact demo``: build the FMU, step it through the stored run, compare, write a table and a picture."""

import signal
import threading
import time
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.resources import as_file, files
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from rich import box
from rich.table import Table

from ..conventions import MILLIMETRE, SIDES
from ..interface.variables import (
    FIRST_WEAR,
    INPUT_VARIABLES,
    INTEGER,
    OUTPUT,
    REAL,
    REFERENCE,
    STATUS,
    VARIABLES,
    select,
)
from ..progress import working
from ..results.runs import read_run
from .errors import Refused, sentences
from .report import console
from .tables import write_table

RUN = "hunting.csv"
CSV_NAME, PICTURE_NAME = "demo.csv", "demo.png"

AXES = ("x_wheel", "y_wheel", "z_wheel", "y_rail", "z_rail", "x_track", "y_track", "z_track")
POSITIONS = tuple(f"contact.{name}" for name in AXES)
WHEELSET, WHEELS = ("",), tuple(f"{side}." for side in SIDES)
#: What is compared: quantity, owner, variables, tolerance, unit.  A tolerance in % is relative to the stored
#: value.
TOLERANCES = (
    ("roll", WHEELSET, ("roll",), 1e-9, "rad"),
    ("vertical shift", WHEELSET, ("vertical_shift",), 1e-3, "mm"),
    ("contact positions", WHEELS, POSITIONS, 1e-3, "mm"),
    ("rolling radius", WHEELS, ("rolling_radius",), 1e-3, "mm"),
    ("contact angle", WHEELS, ("contact_angle",), 1e-4, "rad"),
    ("normal force", WHEELS, ("normal_force",), 1e-4, "%"),
    ("penetration", WHEELS, ("penetration",), 5.0, "%"),
    ("area", WHEELS, ("area",), 10.0, "%"),
    ("largest pressure", WHEELS, ("max_pressure",), 15.0, "%"),
)


@dataclass(frozen=True)
class Check:
    """Comparison of one quantity of a run with its stored values: the largest deviation and its place."""

    quantity: str
    deviation: float
    tolerance: float
    unit: str
    within: int  # values within the tolerance
    count: int  # values compared
    place: str  # lateral shift [mm] and wheel

    @property
    def passed(self):
        """Whether all values are within the tolerance."""
        return self.within == self.count


def run_demo(folder, native=False):
    """Run the demo with the Python FMU or a native one, and write to ``folder``; True if every check
    passes."""
    stored = stored_run()
    with sentences(), working("building the FMU", 3) as advance:
        Path(folder).mkdir(parents=True, exist_ok=True)  # before the work
        fmu = built(folder, native)
        advance(words="running the FMU")
        answers, seconds = apart(step_through, fmu, stored)
        advance(words="drawing the picture")
        write_table(Path(folder, CSV_NAME), {"time": stored["time"], **all_inputs(stored), **answers})
        draw(Path(folder, PICTURE_NAME), answers, stored)
    return report(folder, fmu, compare(answers, stored), seconds)


def built(folder, native):
    """Path of the FMU to run, built in ``folder``; ``native`` builds both native FMUs and returns the one of
    FMI 2.0."""
    from ..fmu import build_fmu
    from ..fmu.native import build_native_fmus

    return build_native_fmus(folder)[0] if native else build_fmu(folder)


def stored_run():
    """The stored run: inputs and expected outputs, arrays (n,) in SI by FMU name."""
    with as_file(files(__package__).joinpath("data", RUN)) as file:
        return read_run(file)


def stored_inputs(stored):
    """Names of the inputs in the run; the other inputs keep their start values."""
    return [name for name in INPUT_VARIABLES if name in stored]


def all_inputs(stored):
    """Every input during the run, arrays (n,) by name."""
    rest = np.ones(len(stored["time"]))
    return {v.name: stored.get(v.name, v.start * rest) for v in INPUT_VARIABLES.values()}


def apart(function, *arguments):
    """The result of ``function(*arguments)``, computed in a process of its own.

    PythonFMU's library accesses freed memory when a process that loaded it ends, and sometimes aborts that
    process (PythonFMU issue 228).  In a separate process this happens after the result has been returned, and
    does no harm.
    """
    from ..workers import ProcessEnded, process_pool  # slow to import

    try:
        with process_pool(1) as helper:
            with undisturbed():
                answer = helper.submit(function, *arguments)
            return answer.result()
    except ProcessEnded:
        raise Refused("the process that runs the FMU ended before it returned its results", code=1) from None
    except RuntimeError as wrong:
        raise Refused(str(wrong), code=1) from None


@contextmanager
def undisturbed():
    """Processes started inside this context ignore Ctrl-C; it ends this process, which then ends them."""
    if threading.current_thread() is not threading.main_thread():  # only that receives signals
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def step_through(fmu, stored):
    """All outputs of the FMU after each row of the run, arrays (n,) by name, and the duration of each step
    (n,) [s]."""
    import fmpy

    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        slave = _started(fmpy.extract(str(fmu), unzipdir=folder))
        references, seen, seconds = _stepped(slave, stored)
        slave.terminate()
        slave.freeInstance()
    columns = dict(zip(references, np.array(seen, dtype=float).T))
    return {v.name: columns[REFERENCE[v.name]] for v in _outputs()}, np.array(seconds)


def _outputs(type=None):
    """The outputs that are read: all but those of wear, which are not computed."""
    return [v for v in select(OUTPUT, type) if v not in VARIABLES[FIRST_WEAR:STATUS]]


def _stepped(slave, stored):
    """Value references of the outputs, their values after each row, and the duration of each step [s].

    As in a simulation, a step sets the inputs, steps, and reads every output.
    """
    names = stored_inputs(stored)
    inputs = [REFERENCE[name] for name in names]
    reals, integers = ([REFERENCE[v.name] for v in _outputs(type)] for type in (REAL, INTEGER))
    rows = np.column_stack([stored[name] for name in names]).tolist()
    instants, seen, seconds = stored["time"].tolist(), [], []
    step_size = instants[1] - instants[0]
    for now, row in zip(instants, rows):
        start = time.perf_counter()
        slave.setReal(inputs, row)
        slave.doStep(now, step_size)
        seen.append(slave.getReal(reals) + slave.getInteger(integers))
        seconds.append(time.perf_counter() - start)
    return reals + integers, seen, seconds


def _started(folder):
    """An initialised instance of the unpacked FMU."""
    from fmpy import read_model_description
    from fmpy.fmi2 import FMU2Slave

    description = read_model_description(folder)
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        instanceName="demo",
        modelIdentifier=description.coSimulation.modelIdentifier,
    )
    slave.instantiate()
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    return slave


# --- checks --------------------------------------------------------------------------------------


def compare(answers, stored):
    """A list of :class:`Check`: the status, then each quantity against its stored values."""
    wrong = np.flatnonzero(answers["status"])
    count, place = (
        len(stored["time"]),
        f"{stored['lateral_shift'][wrong[0]] / MILLIMETRE:.2f}" if len(wrong) else "",
    )
    status = Check("steps not valid", float(len(wrong)), 0.0, "", count - len(wrong), count, place)
    return [status, *(check_quantity(answers, stored, *row) for row in TOLERANCES)]


def check_quantity(answers, stored, quantity, owners, names, tolerance, unit):
    """:class:`Check` of the variables ``names`` of all ``owners``, in ``unit``."""
    variables = [owner + name for owner in owners for name in names]
    deviations = np.array([deviation(answers[name], stored[name], unit) for name in variables])
    which, row = np.unravel_index(
        np.argmax(np.where(np.isnan(deviations), np.inf, deviations)), deviations.shape
    )
    wheel = f" {variables[which].split('.')[0]}" if owners == WHEELS else ""
    place = f"{stored['lateral_shift'][row] / MILLIMETRE:.2f}{wheel}"
    within = int(np.sum(deviations <= tolerance))
    largest = float(np.where(np.isnan(deviations), np.inf, deviations)[which, row])
    return Check(quantity, largest, tolerance, unit, within, deviations.size, place)


def deviation(found, wanted, unit):
    """Deviation of ``found`` from ``wanted`` (n,), both in SI, in ``unit``: mm, rad, or % of the wanted
    value."""
    difference = np.abs(found - wanted)
    if unit == "%":
        return 100 * difference / np.abs(wanted)
    return difference / MILLIMETRE if unit == "mm" else difference


# --- output --------------------------------------------------------------------------------------


def draw(path, answers, stored):
    """Draw the run into the file ``path``."""
    from ..plots import demo_figure, save
    from ..system import ContactSystem

    save(demo_figure(ContactSystem(), answers, stored), path)


def report(folder, fmu, checks, seconds):
    """Print the summary; True if every check passed."""
    failed = [check.quantity for check in checks if not check.passed]
    cost = (
        f"{len(seconds)} steps, median {1e3 * np.median(seconds):.3f} ms (set inputs, step, read all outputs)"
    )
    lines = [
        cost,
        f"{fmu}: the FMU",
        f"{Path(folder, CSV_NAME)}: all outputs of the run, in SI units",
        f"{Path(folder, PICTURE_NAME)}: the picture",
        f"FAILED: {', '.join(failed)}" if failed else "PASSED: every output is within its tolerance",
    ]
    out = console()
    out.print(
        "Results of the FMU compared with the stored run: a hunting wheelset over tread, flange root "
        "and flange",
        soft_wrap=True,
    )
    out.print(check_table(checks))
    out.print("penetration, area and pressure are compared with complete half-space theory", soft_wrap=True)
    for line in lines:
        out.print(line, soft_wrap=True)
    return not failed


def check_table(checks):
    """A table with one row per :class:`Check`."""
    table = Table("quantity", "unit", box=box.SIMPLE_HEAD, show_edge=False, padding=(0, 0, 0, 1))
    for heading in ("largest\ndeviation", "at shift\nmm, wheel", "tolerance", "values\nwithin"):
        table.add_column(heading, justify="right")
    table.add_column("verdict")
    for column in table.columns:
        column.no_wrap, column.vertical = True, "bottom"
    for check in checks:
        verdict, look = ("ok", None) if check.passed else ("FAILED", "bold red")
        table.add_row(
            check.quantity,
            check.unit,
            f"{check.deviation:.2g}",
            check.place,
            f"{check.tolerance:g}",
            f"{check.within}/{check.count}",
            verdict,
            style=look,
        )
    return table
