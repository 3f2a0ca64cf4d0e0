"""The commands ``demo``, ``solve``, ``sweep``, ``plot``, ``check`` and ``figures``."""

import sys
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from .. import ContactSystem
from ..profiles.remarks import remarks_in_lines
from ..status import Status
from ..storage.atomic import write_atomically
from .door import Door, Refused, sentences
from .options import GEOMETRY, LOAD, POSE, SYSTEM, number, option_of, takes
from .profile_files import reads_files
from .report import (
    columns_of,
    is_compliant,
    print_state,
    print_sweep,
    sentence,
    state_text,
    sweep_remark,
    write_table,
)

main = typer.Typer(
    name="wrcontact", cls=Door, add_completion=False, pretty_exceptions_enable=False,
    rich_markup_mode="markdown",
    help="Wheel-rail contact of a railway wheelset: where each wheel touches its rail, the roll of the "
         "wheelset, and the size, load and pressure of the contact patches. Lengths are in mm, angles in "
         "deg, forces in kN, pressures in MPa.")
MOST_ROWS = 1_000_000
PICTURES = (".png", ".svg", ".pdf")


def millimetres(option, words):
    """A typer option ``option`` for a length in mm, with its help text."""
    return typer.Option(option, help=words, parser=number, metavar="NUMBER")


Smoothing = Annotated[float | None, typer.Option(
    "--smoothing-um", parser=number, metavar="NUMBER",
    help="Smoothing of profile files: root mean square distance between the curve and the points, in um; 0 "
         "goes through every point (default: the estimated noise of the points)")]


@main.callback(invoke_without_command=True)
def welcome(context: typer.Context):
    # no docstring: typer would show it instead of the help above
    if context.invoked_subcommand is None:
        print(context.get_help())


@main.command()
def demo(output: Annotated[Path, typer.Option(
             metavar="DIR", help="Folder for the FMU, the table and the picture")]
         = Path("wrcontact-demo"),
         native: Annotated[bool, typer.Option(
             "--native", help="Build the native FMUs, which need no Python, and run the one for FMI 2.0")]
         = False):
    """Build the FMU, run it over tread, flange root and flange, and check its results.

    The FMU steps through a stored run of a hunting wheelset. Its results are compared with independent
    references: roll and contact positions with another search, penetration, area and pressure with an elastic
    half-space. The command writes a table of all outputs and a picture. The exit code is 1 if a check fails.
    """
    from .demo import run_demo

    raise typer.Exit(0 if run_demo(output, native) else 1)


@main.command()
@reads_files
@takes(pose=POSE, system=SYSTEM)
def solve(pose, system,
          as_json: Annotated[bool, typer.Option(
              "--json", help="Print all results as JSON, in SI units")] = False,
          smoothing: Smoothing = None):
    """Solve one pose and print the contact of both wheels side by side.

    With --contact-mode rigid, the default, the undeformed wheels touch the rails. With elastic, the wheels
    approach the rails until each carries its load. With compliant, --vertical-shift-mm and --roll-deg
    prescribe the position, and the loads follow.

    Example: wrcontact solve --lateral-shift-mm 1 --yaw-deg 0 --normal-force-kn 78.5
    """
    system = _system(system, smoothing)
    _refuse_what_is_not_read(system, pose)
    state = system.evaluate(**pose)
    if as_json:
        print(state_text(system, state))
    _refuse_without_contact(system, state)
    if not as_json:
        print_state(system, state)


@main.command()
@reads_files
@takes(load=LOAD, system=SYSTEM)
def sweep(load, system,
          start: Annotated[float, millimetres("--from-mm", "First lateral shift, in mm")] = -8.0,
          stop: Annotated[float, millimetres("--to-mm", "Last lateral shift, in mm")] = 8.0,
          step: Annotated[float, millimetres("--step-mm", "Step of the lateral shift, in mm")] = 0.5,
          file: Annotated[Path | None, typer.Option("--csv", metavar="FILE",
                                                    help="Write all outputs to this CSV file, in SI units "
                                                         "and with the names of the FMU, instead of printing "
                                                         "a few of them")] = None,
          smoothing: Smoothing = None):
    """Move the wheelset across the track and print a table of its contacts.

    Example: wrcontact sweep --from-mm -8 --to-mm 8 --step-mm 0.1 --csv sweep.csv
    """
    shifts, system = _shifts(start, stop, step), _system(system, smoothing)
    _refuse_what_is_not_read(system, load)
    table = system.evaluate_many(lateral_shift=shifts, **load)
    if min(table.status) > Status.UNLOADED:
        raise Refused(sweep_remark(system, table))
    if file:
        with sentences():
            write_table(file, columns_of(table))
        print(f"{len(table)} rows written to {file}")
    else:
        print_sweep(table)
    remark = sweep_remark(system, table)
    if remark:
        print(f"wrcontact: {remark}", file=sys.stderr)


@main.command()
@reads_files
@takes(pose=POSE, system=SYSTEM)
def plot(pose, system,
         output: Annotated[Path, typer.Option(metavar="FILE", help="File of the picture: .png, .svg or .pdf")]
         = Path("pose.png"), smoothing: Smoothing = None):
    """Draw one pose: both wheels on their rails, and the contact patches with their pressure.

    Example: wrcontact plot --lateral-shift-mm 5 --output pose.png
    """
    from ..plots import pose_figure, save

    _refuse_no_picture(output)
    system = _system(system, smoothing)
    _refuse_what_is_not_read(system, pose)
    state = system.evaluate(**pose)
    _refuse_without_contact(system, state)
    figure = pose_figure(system, state)
    with sentences():
        save(figure, output)
    print(f"picture written to {output}")


@main.command()
@reads_files
@takes(geometry=GEOMETRY)
def check(geometry,
          output: Annotated[Path, typer.Option(
              metavar="FILE", help="File of the picture: .png, .svg or .pdf")]
          = Path("check.png"),
          file: Annotated[Path | None, typer.Option(
              "--json", metavar="FILE", help="Write all results to this file as JSON, in SI units")] = None,
          smoothing: Smoothing = None):
    """Check a pair of profiles before a simulation relies on it.

    The command prints and draws where the contact jumps, how fast contact and roll change with the lateral
    shift, where wheel and rail are conformal, the quality of the profiles, and the equivalent conicity at 1
    to 8 mm (EN 15302). The exit code is 1 if the pair has no contact within 1 mm of the centred position.

    Example: wrcontact check --wheel worn.whl --rail 60E1 --output worn.png
    """
    from .. import conditioning
    from ..plots import check_figure, save
    from .check import check_text, print_check

    _refuse_no_picture(output)
    report = conditioning.check(_system(geometry, smoothing))
    print_check(report)
    with sentences():
        if file:
            write_atomically(file, check_text(report).encode())
        save(check_figure(report), output)
    print(f"\npicture written to {output}")
    if not report.usable:
        raise typer.Exit(1)


@main.command()
def figures(more: Annotated[list[str] | None,
                            typer.Argument(metavar="NUMBER", help="Further figures after --only")] = None,
            output: Annotated[Path, typer.Option(metavar="DIR",
                                                 help="Folder for the pictures, the tables and the index")]
            = Path("wrcontact-figures"),
            only: Annotated[list[str] | None, typer.Option(
                metavar="NUMBER", help="Draw only these figures, such as 7.2")] = None):
    """Recompute and draw the figures of the degree project that wrcontact started from.

    Each figure is written as a picture and a CSV table, such as fig_7_2.png and fig_7_2.csv. The index
    figures.md shows all of them, with what the project states and what is found here. This takes about 15
    seconds.

    Example: wrcontact figures --only 7.2 7.4
    """
    from .figures import run_figures

    with sentences():
        run_figures(output, (only or []) + (more or []))


def _refuse_no_picture(output):
    if output.suffix.lower() not in PICTURES:
        raise Refused(f"--output is {str(output)!r}; permitted are files that end in {', '.join(PICTURES)}")


def _system(parameters, smoothing):
    """The contact system with these parameters; repairs of profile files are reported in one line per
    file."""
    with sentences(), remarks_in_lines("wrcontact"):
        return ContactSystem(**parameters, smoothing=None if smoothing is None else smoothing / 1e6)


def _refuse_what_is_not_read(system, given):
    """Refuse an option that the contact mode does not use: the result would not be what was asked for."""
    names = ("normal_force", "load_transfer") if is_compliant(system) else ("vertical_shift_input",
                                                                            "roll_input")
    for variable in POSE:
        if variable.name in names and variable.name in given:
            allowed = "rigid or elastic" if is_compliant(system) else "compliant"
            raise Refused(f"{option_of(variable)} is given; it is permitted only with --contact-mode "
                          f"{allowed}; {system.parameters['contact_mode']!r} does not use it")


def _refuse_without_contact(system, state):
    """Refuse a state without contact: exit code 1 if the search did not converge, 2 if the input has no
    contact."""
    if state.status > Status.UNLOADED:
        raise Refused(sentence(state.status, state.inputs, is_compliant(system)),
                      code=1 if state.status == Status.NOT_CONVERGED else 2)


def _shifts(start, stop, step):
    """Lateral shifts [m] from ``start`` to ``stop`` [mm], both included where ``step`` [mm] fits."""
    if not all(map(np.isfinite, (start, stop, step))) or not step > 0 or stop < start:
        raise Refused(f"--from-mm {start:g}, --to-mm {stop:g}, --step-mm {step:g} do not define a sweep; "
                      "permitted are finite numbers with --step-mm > 0 and --to-mm >= --from-mm")
    count = int((stop - start) / step + 1e-9) + 1
    if count > MOST_ROWS:
        raise Refused(f"--step-mm {step:g} gives {count} rows; permitted are at most {MOST_ROWS}")
    return np.round(start + step * np.arange(count), 9) / 1e3
