"""Digests of what the kernel computes, which are the same on every machine: tables, and steps of every
contact mode with every normal and tangential model.

    python -m tests.helpers.digests                         this Python's kernel, against the stored digests
    python -m tests.helpers.digests --write                 stores them anew, because results were changed
    python -m tests.helpers.digests --zig                   a library that zig builds for this machine
    python -m tests.helpers.digests --on aarch64-linux      a program that zig builds, under qemu-aarch64
    python -m tests.helpers.digests --on x86_64-windows     under wine

Random poses come from Python's own generator and exact operations, so that they are the same everywhere too.
"""

import argparse
import ctypes
import hashlib
import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import wrcontact
from tests.helpers.paths import HELPERS
from wrcontact.interface.inputs import INPUT_NAMES, INPUTS
from wrcontact.kernel import layout
from wrcontact.kernel.binding.compiler import FLAGS, FMU_UNITS, ZIG, compile_library, compiler_for
from wrcontact.kernel.binding.files import HERE, PLATFORMS, host_platform
from wrcontact.kernel.binding.fixed_tables import fixed_tables
from wrcontact.kernel.binding.library import Kernel, declare, default_kernel
from wrcontact.kernel.binding.setup import setup_of
from wrcontact.kernel.patch.outline import row_size
from wrcontact.methods import family_of

STORED = HELPERS / "digests.json"
#: Poses of a case, and after how many there is a digest; of how many there are derivatives.
POSES, PARTS, DERIVATIVES = 1000, (3, 25, 100, 1000), 10
#: Targets of zig for programs that need no library of that machine, and what runs them here.
TARGETS = {
    "aarch64-linux": ("aarch64-linux-musl", "-static"),
    "x86_64-linux": ("x86_64-linux-musl", "-static"),
    "x86_64-windows": ("x86_64-windows-gnu",),
}
EMULATORS = {"aarch64-linux": "qemu-aarch64", "x86_64-windows": "wine"}
FRICTION = {
    "flange_friction_ratio": 0.5,
    "friction_fall": 0.4,
    "friction_fall_rate": 0.6,
    "slope_reduction": 0.5,
    "slope_reduction_rate": 0.5,
    "slope_reduction_floor": 0.3,
}
#: Beside the models.
OTHERS = [
    {"lateral_curvature": "smooth", "separation": "vertical"},
    {"lateral_curvature": "rough", "separation": "equidistant"},
    {"lateral_curvature": "smooth", "separation": "equidistant_chord", "rail": "54E1"},
    {"load": "vertical", "tangential_model": "strips", "contact_mode": "elastic"},
    {"contact_mode": "compliant", "contact_damping": 0.5, "tangential_model": "strips"},
    {"contact_mode": "compliant", "rail_lateral_stiffness": 3e7, "rail_vertical_stiffness": (2e8, 1e8)},
    {"tangential_model": "strips", "poisson_ratio": 0.3, **FRICTION},
    {"wheel": ("cone20", "cone40"), "rail": "60E1", "rail_inclination": (0.025, 0.05)},
    {"normal_model": "hertz", "longitudinal_curvature": "basic"},
    {"wear_outputs": True, "fatigue_outputs": True, "tangential_model": "strips", "contact_mode": "elastic"},
]


def choices(name):
    """The kernel's models of a family, by name."""
    return [method.name for method in family_of(name).methods if not method.python_only]


def cases():
    """Parameters of every case, by name."""
    models = [
        {"contact_mode": mode, "normal_model": normal, "tangential_model": tangential}
        for mode in ("rigid", "elastic", "compliant")
        for normal in choices("normal_model")
        for tangential in choices("tangential_model")
    ]
    return {"-".join(map(str, parameters.values())): parameters for parameters in [*models, *OTHERS]}


def poses(count=POSES):
    """Inputs (count, n): tread, flange and some beyond; half of them yawed, a third with moved rails."""
    draw = random.Random(26)
    rows = np.zeros((count, layout.INPUT_COUNT))
    for row in rows:
        # not drawn is what came later: rates of independent wheels, which are not read, and rails on springs
        values = {
            name: draw.uniform(-1.0, 1.0)
            for name in INPUT_NAMES
            if not name.endswith((".wheel_rate", "_before", "_time_step"))
        }
        yawed, moved = draw.random() < 0.5, draw.random() < 1.0 / 3.0
        for place, entry in enumerate(INPUTS):
            row[place] = start_of(entry) + values.get(entry.name, 0.0) * size_of(entry.name, yawed, moved)
    return rows


def start_of(entry):
    """Around which value an input is drawn."""
    return {"speed": 20.0, "vertical_shift_input": 4e-4}.get(entry.name, entry.start or 0.0)


def size_of(name, yawed, moved):
    """How far an input is drawn from there."""
    if ".rail_" in name and name.rpartition(".rail_")[2] in ("lateral", "vertical", "roll"):
        return (5e-3 if name.endswith("roll") else 5e-4) if moved else 0.0
    if name.endswith("_velocity") and moved:
        return 0.02
    sizes = {
        "lateral_shift": 7e-3,
        "yaw": 0.03 if yawed else 0.0,
        "normal_force": 5e4,
        "load_transfer": 0.4,
        "vertical_shift_input": 3e-4,
        "roll_input": 2e-3,
        "speed": 10.0,
        "lateral_velocity": 0.1,
        "vertical_velocity": 0.02,
        "roll_rate": 0.05,
        "yaw_rate": 0.1,
        "left.friction": 0.2,
        "right.friction": 0.2,
        "track_curvature": 1e-3,
    }
    return sizes.get(name, 0.0)


def digest(*arrays):
    """A digest of numbers, in which one that is none has always the same bits."""
    found = hashlib.sha256()
    for array in arrays:
        values = np.array(array, dtype="<f8")
        values[np.isnan(values)] = np.nan
        found.update(np.where(np.isnan(values), np.float64("nan"), values).tobytes())
    return found.hexdigest()[:16]


def digests_of(tables, outputs, statuses, rates=None):
    """The digests of a case, by their names."""
    found = {"tables": digest(tables)}
    found |= {
        str(count): digest(outputs[:count], statuses[:count]) for count in PARTS if count <= len(outputs)
    }
    return found | ({} if rates is None else {"rates": digest(rates)})


def plan_of(parameters):
    """The arrays of a preparation but for tables and workspace: setup, definitions, fixed tables."""
    system = wrcontact.ContactSystem(**parameters)
    definitions = [
        profile.definition() for profile in (system.wheel, system.rail, system.left_wheel, system.left_rail)
    ]
    rolling = system.parameters["tangential_model"] != "none"
    return [setup_of(system.parameters, system.methods), *definitions, fixed_tables(rolling)]


def stepped(kernel, parameters, rows):
    """The digests of a case by a kernel of this process."""
    _, tables = kernel.prepare(*plan_of(parameters))
    head = layout.Tables.at(tables)
    inputs, outputs, statuses = rows.copy(), np.zeros((len(rows), row_size(head))), np.zeros(len(rows))
    arrays = [
        tables,
        np.zeros(layout.STATE_SIZE),
        np.zeros(layout.WORK_SIZE),
        np.zeros(layout.INPUT_COUNT),
        np.zeros(row_size(head)),
    ]
    bound = kernel.bind(*arrays)
    bound.step_many(len(rows), inputs, outputs, statuses)
    rates = None
    if kernel.compiled:
        rates = []
        for row in rows[:DERIVATIVES]:
            arrays[3][:] = row
            rates.append(bound.derivative(np.array([entry.nominal for entry in INPUTS]))[1])
    return digests_of(tables, outputs, statuses, rates)


def run(kernel=None, count=POSES, only=None):
    """Digests of all cases, or of ``only`` these, by a kernel of this process: {case: {name: digest}}."""
    kernel, rows = kernel or default_kernel(), poses(count)
    return {
        name: stepped(kernel, parameters, rows)
        for name, parameters in cases().items()
        if only is None or name in only
    }


def built_kernel(compiler, flags=()):
    """A kernel of this process from a library by a compiler's command."""
    with tempfile.TemporaryDirectory() as folder:
        file = compile_library(folder, compiler=compiler, extra_flags=flags, units=FMU_UNITS)
        library = ctypes.CDLL(str(file))
    declare(library)
    return Kernel(library)


def emulated(name, count=POSES, only=None):
    """Digests of all cases, or of ``only`` these, by a program that zig builds for the platform ``name``."""
    rows, chosen = (
        poses(count),
        {name: case for name, case in cases().items() if only is None or name in only},
    )
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "digest_host.exe")
        sources = [str(HELPERS / "digest_host.c"), *(str(HERE.parent / unit) for unit in FMU_UNITS)]
        target, *flags = TARGETS[name]
        subprocess.run(
            [
                *ZIG,
                "-target",
                target,
                *flags,
                *(flag for flag in FLAGS if flag != "-fPIC"),
                "-O1",  # a third of the time; tools/release.py runs kernels as they are given away
                "-I",
                str(HERE.parent),
                *sources,
                "-o",
                str(program),
            ],
            check=True,
        )
        plan, answer = Path(folder, "plan"), Path(folder, "answer")
        sizes = [write_plan(plan, parameters, rows) for parameters in chosen.values()]
        emulator = [] if name == host_platform() else [EMULATORS[name]]
        subprocess.run(
            [*emulator, str(program), "plan", "answer"],
            cwd=folder,
            check=True,
            env={**os.environ, "WINEDEBUG": "-all", "WINEPREFIX": str(Path(folder, "wine"))},
        )
        return dict(zip(chosen, read_answers(answer, sizes, count)))


def write_plan(file, parameters, rows):
    """Add a case to the plan; the numbers of its tables and of a row of its outputs."""
    arrays = plan_of(parameters)
    _, tables = default_kernel().prepare(*(array.copy() for array in arrays))
    row = row_size(layout.Tables.at(tables))
    # the preparation has to have more room than its tables need in the end
    head = [*map(len, arrays), 4 * len(tables), len(rows), row, min(DERIVATIVES, len(rows))]
    with file.open("ab") as written:
        for array in (head, *arrays, rows):
            np.array(array, dtype=float).tofile(written)
    return len(tables), row


def read_answers(file, sizes, count):
    """The digests of each case in the answer."""
    with file.open("rb") as read:
        for length, row in sizes:
            (used,) = np.fromfile(read, count=1)
            if used != length:
                raise ValueError(f"the preparation gives {used:.0f}, here {length}")
            tables, outputs = np.fromfile(read, count=length), np.fromfile(read, count=count * row)
            statuses = np.fromfile(read, count=count)
            rates = np.fromfile(read, count=min(DERIVATIVES, count) * row)
            yield digests_of(tables, outputs.reshape(count, row), statuses, rates)


def stored():
    """The stored digests, {case: {name: digest}}."""
    return json.loads(STORED.read_text(encoding="utf-8"))


def differences(found):
    """Which of the found digests are not the stored ones, as words."""
    known = stored()
    return [
        f"{case}: {name}"
        for case, parts in found.items()
        for name, value in parts.items()
        if known[case][name] != value
    ]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--zig", action="store_true")
    parser.add_argument("--on", choices=TARGETS)
    parser.add_argument("--count", type=int, default=POSES)
    options = parser.parse_args()
    if options.on:
        found = emulated(options.on, options.count)
    elif options.zig:
        found = run(built_kernel(compiler_for(PLATFORMS[host_platform()])), options.count)
    else:
        found = run(count=options.count)
    if options.write:
        STORED.write_text(json.dumps(found, indent=0) + "\n", encoding="utf-8")
    apart = differences(found)
    print(*apart, sep="\n")
    print(
        f"{sum(map(len, found.values()))} digests of {len(found)} cases, {len(apart)} of them are not the "
        "stored ones"
    )
    return bool(apart)


if __name__ == "__main__":
    sys.exit(main())
