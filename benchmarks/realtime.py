"""Steps for real time, from C: how long a train's time step takes, and the instructions of the costliest steps.

    python -m benchmarks train instructions

A C program (realtime_host.c) owns the memory of all wheelsets and steps them through the compiled kernel.
Times are the least of several rounds for each time step, since disturbances only add time: what is left is the
cost of the step itself, to which a target for real time adds its own jitter.  Instructions are counted by
valgrind's callgrind; the steps with most evaluations of the profiles are counted, and each two hundredth one.
"""

import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import wrcontact
from wrcontact.kernel.binding.library import default_kernel

from . import worst
from .times import motion

HOST = Path(__file__).with_name("realtime_host.c")
WHEELSETS, ROUNDS, SPEED, TIME_STEP = 8, 3, 20.0, 1e-3
TRAIN_STEPS = 2000
#: Of so many steps, the instructions of each EVERY-th one and of the COSTLIEST are counted.
STEPS, EVERY, COSTLIEST = 10_000, 200, 20
#: Outputs that are inputs of the next time step.
DEFLECTIONS = [
    f"{side}.rail_deflection_{way}" for side in ("left", "right") for way in ("lateral", "vertical")
]
#: Systems of the page for real time by name.
SPRUNG = {"contact_mode": "compliant", **worst.SPRINGS}
TRAINS = {
    "Hertz, rigid": {"normal_model": "hertz"},
    "ANALYN, rigid": {},
    "ANALYN, compliant": {"contact_mode": "compliant"},
    "ANALYN, compliant, creep forces": {"contact_mode": "compliant", "tangential_model": "strips"},
    "strips, compliant, creep forces": {
        "contact_mode": "compliant",
        "normal_model": "analyn_strip",
        "tangential_model": "strips",
    },
    "ANALYN, elastic": {"contact_mode": "elastic"},
    "ANALYN, compliant, rails on springs": SPRUNG,
    "ANALYN, compliant, rails on springs over a time step, creep forces": {
        **SPRUNG,
        "tangential_model": "strips",
        "rail_lateral_damping": 2e5,
        "rail_vertical_damping": 1e5,
    },
}


def is_missing(*programs):
    """Whether one of the ``programs`` is not here, or the kernel is not compiled."""
    return not default_kernel().compiled or not all(map(shutil.which, programs))


def compile_host(folder):
    """The program, linked with the compiled kernel."""
    library = Path(default_kernel().library._name).resolve()
    program = Path(folder, "realtime_host")
    subprocess.run(
        [
            "cc",
            "-std=c11",
            "-O2",
            "-Wall",
            "-Werror",
            HOST,
            library,
            f"-Wl,-rpath,{library.parent}",
            "-o",
            program,
        ],
        check=True,
    )
    return program


def write_rows(file, options, rows):
    """Write tables and inputs of ``rows`` (n, 3), as :func:`worst.inputs_of_rows` takes them, for the
    program."""
    stepper = wrcontact.ContactSystem(**options).stepper()
    names = worst.inputs_of_rows(rows, options)
    if "tangential_model" in options:
        names |= {"speed": SPEED}
        if "rail_vertical_damping" in options:
            names |= {"rail_time_step": TIME_STEP}
    inputs = np.tile(stepper.inputs, (len(rows), 1))
    for name, values in names.items():
        inputs[:, stepper.place(name)] = values
    sizes = stepper.tables, stepper.state, stepper._workspace, stepper.inputs, stepper.outputs
    fed = [
        (stepper.place(f"{name}_before"), stepper.place(name))
        for name in DEFLECTIONS
        if "rail_time_step" in names
    ]
    head = [*map(len, sizes), len(fed), len(rows)]
    np.concatenate([head, np.ravel(fed), stepper.tables, inputs.ravel()]).tofile(file)


# ------------------------------------------------------------------------------------------------- times


def train_times(quick=False):
    """Rows by name: microseconds of a time step of WHEELSETS wheelsets over the hunting run, and the share of
    the worst one in a time step of 1 ms [%].

    Raises
    ------
    RuntimeError
        without a compiler; ``quick`` then finds nothing.
    """
    if is_missing("cc"):
        if quick:
            return {}
        raise RuntimeError(
            "a train is stepped by a C program, and there is no compiler or no compiled kernel"
        )
    steps, rounds = (20, 1) if quick else (TRAIN_STEPS, ROUNDS)
    rows = np.transpose(motion(steps))
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        program = compile_host(folder)
        for name, options in TRAINS.items():
            file = Path(folder, "rows")
            write_rows(file, options, rows)
            command = [program, "train", str(WHEELSETS), str(rounds), file]
            done = subprocess.run(command, text=True, capture_output=True, check=True)
            times = np.array(done.stdout.split(), float)
            shares = {share: np.quantile(times, at) for share, at in worst.SHARES.items()}
            found[name] = {**shares, "of 1 ms": 100.0 * shares["worst"] / 1e3}
    return found


# ------------------------------------------------------------------------------------------ instructions


def costly_rows(rows, options, count):
    """Indices of the rows whose instructions are counted: those with most evaluations of the profiles, and
    then some at equal distances."""
    counted = worst.evaluations(rows, **options)
    return np.argsort(-counted)[:count], np.arange(EVERY // 2, len(rows), EVERY)


def count_instructions(program, options, rows, chosen):
    """Instructions [thousands] of the steps of the ``chosen`` rows, each after the one before it."""
    pairs = np.column_stack([np.maximum(chosen - 1, 0), chosen]).ravel()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "rows")
        write_rows(file, options, rows[pairs])
        counts = Path(folder, "counts")
        command = [
            "valgrind",
            "--tool=callgrind",
            "--zero-before=wrcontact_step",
            "--dump-after=wrcontact_step",
            "--combine-dumps=yes",
            "--dump-line=no",
            f"--callgrind-out-file={counts}",
            program,
            "once",
            file,
        ]
        subprocess.run(command, capture_output=True, check=True)
        totals = re.findall(r"^summary: (\d+)", counts.read_text(), re.M)
    return np.array(totals[: len(pairs)], float)[1::2] / 1e3


def instructions(quick=False):
    """Rows by system: thousands of instructions of a step in the median of random poses and of the hunting run,
    in 99.9 of 100 and at worst, and the worst of both over the median of the random poses.

    Raises
    ------
    RuntimeError
        without valgrind or a compiler; ``quick`` then finds nothing.
    """
    if is_missing("valgrind", "cc"):
        if quick:
            return {}
        raise RuntimeError("instructions are counted by valgrind in a C program, and one of both is not here")
    steps, costliest = (2 * EVERY, 2) if quick else (STEPS, COSTLIEST)
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        program = compile_host(folder)
        for name, options in worst.systems():
            row, most = {}, []
            for where, rows in (("", worst.random_rows(steps)), ("hunting: ", np.transpose(motion(steps)))):
                costly, usual = costly_rows(rows, options, costliest)
                counts = count_instructions(program, options, rows, np.concatenate([costly, usual]))
                largest = np.sort(counts[:costliest])[::-1]
                row |= {
                    f"{where}median": np.median(counts[costliest:]),
                    f"{where}99.9 of 100": largest[min(steps // 1000, costliest - 1)],
                    f"{where}worst": counts.max(),
                }
                most.append(counts.max())
            found[name] = {**row, "worst over median": max(most) / row["median"]}
    return found
