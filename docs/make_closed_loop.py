"""Measure the closed loop anew and write its tables and pictures into docs/guides/closed_loop.md and
docs/img.

    python docs/make_closed_loop.py [klingel] [critical] [hunting] [energy] [curve] [long] [master] [exchange]
                                    [manchester]

Without names it does all of them, which takes a quarter of an hour.  It needs libcosimpy for "master".
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))

import wrcontact  # noqa: E402
from benchmarks.tables import grid, write_part  # noqa: E402
from data import hunting_theory as theory  # noqa: E402
from data import manchester  # noqa: E402
from examples.hunting_wheelset import (  # noqa: E402
    coupling,
    curve_entry,
    energy,
    exchange,
    hunting,
    long_run,
    structure,
)
from examples.hunting_wheelset.stability import LINEAR, LINEAR_FRICTION, Linear  # noqa: E402
from wrcontact.plots.style import save  # noqa: E402

PAGE, IMAGES = ROOT / "docs" / "guides" / "closed_loop.md", ROOT / "docs" / "img"
MODELS = wrcontact.methods.TangentialModel.family.names(python=False)[1:]


def table(head, rows):
    """Lines of a Markdown table; the first column is text."""
    return grid(head, rows).splitlines()


def klingel(archives):
    rows = []
    for name, case in hunting.KLINGEL.items():
        wave, amplitude, rolled, plain, run = hunting.klingel(archives, *case)
        rows.append(
            [
                name,
                f"{amplitude * 1e3:.2f}",
                f"{wave:.3f}",
                f"{plain:.3f}",
                f"{rolled:.3f}",
                f"{100 * (wave / rolled - 1):+.2f}",
                str(run.worst_status),
            ]
        )
    return table(
        [
            "wheels",
            "amplitude [mm]",
            "measured [m]",
            "Klingel [m]",
            "with roll [m]",
            "difference [%]",
            "status",
        ],
        rows,
    )


def critical(archives):
    touched = hunting.elastic(coupling.CONES).evaluate(0.0).right.contact.y_track
    model = theory.cones(touched, hunting.SUSPENSION)
    rows = []
    with Linear(archives, hunting.SUSPENSION, LINEAR, LINEAR_FRICTION) as linear:
        for speed in (20.0, 40.0, 60.0, 80.0):
            found, wanted = linear.root(speed), theory.hunting_root(theory.state_matrix(model, speed))
            rows.append(
                [
                    f"{speed:g}",
                    f"{found.real:+.4f}",
                    f"{wanted.real:+.4f}",
                    f"{found.imag:.3f}",
                    f"{wanted.imag:.3f}",
                ]
            )
        speeds = linear.critical_speed(30.0, 100.0), theory.critical_speed(model, 30.0, 100.0)
    return [
        *table(["speed [m/s]", "growth [1/s]", "theory", "frequency [rad/s]", "theory"], rows),
        "",
        f"Critical speed: {speeds[0]:.2f} m/s, by the theory {speeds[1]:.2f} m/s, "
        f"{100 * abs(speeds[0] / speeds[1] - 1):.2f} % apart.",
    ]


def hunts(archives):
    found = hunting.cycles(archives)
    with Linear(archives, hunting.SOFT) as linear:
        speed = linear.critical_speed(20.0, 80.0)
        save(hunting.draw(linear, found), IMAGES / "hunting.png")
    rows = [
        [f"from {start * 1e3:g} mm", *(f"{amplitude * 1e3:.2f}" for _, amplitude in row)]
        for start, row in found.items()
    ]
    rows += [
        [f"status from {start * 1e3:g} mm", *(str(run.worst_status) for run, _ in row)]
        for start, row in found.items()
    ]
    return [
        *table(["amplitude [mm]", *(f"{speed:g} m/s" for speed in hunting.SPEEDS)], rows),
        "",
        f"Critical speed {speed:.1f} m/s. Statuses are the largest of all steps, 1 a wheel without load.",
    ]


def energies(archives):
    found = [energy.study(archives, derivatives) for derivatives in (False, True)]
    rows = []
    for place, step in enumerate(energy.STEPS):
        cells = [f"{step * 1e3:g}"]
        for errors, _, _ in found:
            order = f"{energy.orders(errors)[place - 1]:.2f}" if place else ""
            cells += [f"{errors[place]:+.2e}", order]
        rows.append(cells)
    return [
        *table(["step [ms]", "explicit [J]", "order", "with derivatives [J]", "order"], rows),
        "",
        f"Of {found[0][1]:.3g} J that the contact exchanges with the wheelset in {energy.DURATION:g} s. "
        f"Largest status {max(worst for _, _, worst in found)}.",
    ]


def curve(archives):
    run = curve_entry.enter(archives)
    save(curve_entry.draw(run), IMAGES / "curve_entry.png")
    still = curve_entry.equilibrium(
        wrcontact.ContactSystem(**coupling.CONTACT), curve_entry.WHEELSET, run.motion[-1]
    )
    rows = [
        [name, f"{1e3 * run.motion[-1][place]:.6f}", f"{1e3 * still[place]:.6f}"]
        for name, place in (
            ("lateral shift [mm]", 0),
            ("vertical shift [mm]", 1),
            ("roll [mrad]", 2),
            ("yaw [mrad]", 3),
        )
    ]
    ratio = abs(run["left.force.y"][-1] / run["left.force.z"][-1])
    angle = run["left.patch[1].contact_angle"][-1]
    return [
        *table(["", "end of the run", "equilibrium"], rows),
        "",
        f"The outer wheel carries at {angle:.2f} rad and has Y/Q = {ratio:.2f}; largest status "
        f"{run.worst_status}.",
    ]


def long(archives):
    return [long_run.report(long_run.hunt(archives), long_run.STEPS) + "."]


def master(archives):
    theirs, mine, worst, _ = structure.compare(archives[1].parent, archives)
    rows = [
        [f"`{name}`", f"{np.abs(column).max():.3g}", f"{np.abs(column - other).max():.1e}"]
        for name, column, other in zip(structure.MOTION, theirs.T, mine.T)
    ]
    return [
        *table(["output, SI", "largest", "libcosim against fmpy"], rows),
        "",
        f"{len(mine)} steps of {structure.STEP * 1e6:g} us; largest status {worst}.",
    ]


def exchanged(archives):
    """One solver with a variable step beside co-simulation with fixed ones."""
    found = exchange.study(archives, exchange.build_exchange(archives[1].parent))
    rows = [
        [words, str(run.steps), str(run.evaluations), f"{missed * 1e6:.2g}"] for words, run, missed in found
    ]
    return [
        *table(["", "steps", "calls of the contact", "error [um]"], rows),
        "",
        f"Largest status {max(run.worst_status for _, run, _ in found)}.",
    ]


def manchester_creep(archives):
    """Errors of all models beside CONTACT's forces, by CONTACT's CSV."""
    rows = []
    for row in manchester.rows():
        errors = [100 * manchester.error(row, manchester.wheel(row, model)) for model in MODELS]
        rows.append(
            [
                f"{row['side']}, {row['lateral_shift_mm']:g} mm",
                f"{-row['Fx_N']:.0f}",
                f"{row['Fs_N']:.0f}",
                *(f"{error:.2f}" for error in errors),
            ]
        )
    means = np.mean([[float(cell) for cell in row[3:]] for row in rows], axis=0)
    rows.append(["mean", "", "", *(f"{mean:.2f}" for mean in means)])
    return table(["wheel", "along [N]", "across [N]", *(f"`{model}` [% of μN]" for model in MODELS)], rows)


PARTS = {
    "klingel": klingel,
    "critical": critical,
    "hunting": hunts,
    "energy": energies,
    "curve": curve,
    "long": long,
    "master": master,
    "exchange": exchanged,
    "manchester": manchester_creep,
}


if __name__ == "__main__":
    with TemporaryDirectory() as folder:
        archives = coupling.build(folder)
        for name in sys.argv[1:] or PARTS:
            write_part(PAGE, "docs/make_closed_loop.py", name, PARTS[name](archives))
            print(f"{PAGE.name}: {name}", flush=True)
