"""The commands ``demo``, ``build``, ``solve``, ``sweep``, ``plot``, ``check``, ``wear``, ``profiles``, ``export`` and ``figures``."""

import sys
import warnings
from pathlib import Path
from typing import Annotated

import typer

from ..interface.friction import FRICTION
from ..kernel.binding.files import PLATFORMS
from ..methods import CHOICES
from ..methods.words import did_you_mean
from ..profiles.remarks import ProfileWarning, remarks_in_lines
from ..progress import in_lines, working
from ..status import Status
from ..stepper import core_count
from ..system import ContactSystem
from ..version import __version__
from .catalogue import profiles
from .errors import CommandGroup, Refused, check_file, check_folder, sentences
from .export import export
from .grids import grid_options, refuse_beside_axes, shifts_of, sweeps_grids, write_grid
from .help import Command, with_all
from .options import GEOMETRY, LOAD, POSE, SYSTEM, name_of, number, option_of, takes
from .pictures import PICTURES, draws
from .profile_files import Smoothing, reads_files, with_left_side
from .report import (
    Remark,
    has_model,
    is_compliant,
    print_state,
    print_sweep,
    sentence,
    state_text,
    sweep_columns,
    sweep_outputs,
)
from .tables import writes_tables
from .typed import Typed, remark_lines, typed
from .wear import wear

main = typer.Typer(
    name="wrcontact",
    cls=CommandGroup,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Wheel-rail contact of a railway wheelset: where each wheel touches its rail, the roll of the "
    "wheelset, and the size, load and pressure of the contact patches. Lengths are in mm, angles in "
    "deg, forces in kN, pressures in MPa, velocities in m/s and "
    "rad/s.",
)
ROLLING_CONTACT = {row.name for row in FRICTION}
CONTACT, FMUS, STUDY = "Contacts", "FMUs", "The study that wrcontact started from"


def millimetres(option, words):
    """A typer option ``option`` for a length in mm, with its help text."""
    return typer.Option(option, help=words, parser=number, metavar="NUMBER")


def _both(batch):
    """``batch``, unless an option stands where one of its two belongs."""
    if batch and any(given.startswith("--") for given in batch):
        raise Refused(
            f"--batch has {' and '.join(map(repr, batch))}; permitted are wheels and rails, each a "
            "folder, a pattern, a file or a name"
        )
    return batch


def _print_version(wanted):
    if wanted:
        print(f"wrcontact {__version__}")
        raise typer.Exit


@main.callback(invoke_without_command=True)
def welcome(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version")
    ] = False,
):
    # no docstring: typer would show it instead of the help above
    if context.invoked_subcommand is None:
        print(context.get_help())
    context.with_resource(remarks_in_lines("wrcontact", remark_lines))
    context.with_resource(in_lines("wrcontact"))


@main.command(cls=Command, rich_help_panel=FMUS)
def demo(
    output: Annotated[
        Path, typer.Option(metavar="DIR", help="Folder for the FMU, the table and the picture")
    ] = Path("wrcontact-demo"),
    native: Annotated[
        bool,
        typer.Option(
            "--native", help="Build the native FMUs, which need no Python, and run the one for FMI 2.0"
        ),
    ] = False,
):
    """Build the FMU, run it over tread, flange root and flange, and check its results.

    The FMU steps through a stored run of a hunting wheelset. Its results are compared with independent
    references: roll and contact positions with another search, penetration, area and pressure with an elastic
    half-space. The command writes a table of all outputs and a picture. The exit code is 1 if a check fails.
    """
    from .demo import run_demo

    raise typer.Exit(0 if run_demo(output, native) else 1)


@main.command(cls=Command, rich_help_panel=FMUS)
@with_all
@reads_files
@with_left_side
def build(
    output: Annotated[Path, typer.Option(metavar="DIR", help="Folder of the FMU")] = Path("dist"),
    native: Annotated[
        bool,
        typer.Option(
            "--native", help="Pack the two native FMUs instead, for FMI 2.0 and FMI 3.0, which need no Python"
        ),
    ] = False,
    platforms: Annotated[
        str | None,
        typer.Option(
            metavar="NAME[,NAME]",
            help="Platforms of the native FMUs: by default this machine's; or any of "
            f"{', '.join(PLATFORMS)}; or all. Other platforms than this machine's need "
            "ziglang",
        ),
    ] = None,
    single_wheel: Annotated[
        bool,
        typer.Option(
            "--single-wheel",
            help="Native FMUs of one wheel on the right rail, WheelContact, instead of a wheelset",
        ),
    ] = False,
    wheel: Annotated[
        str | None,
        typer.Option(
            metavar="FILE",
            help="Wheel profile to pack and use as the default: a file of points, or a built-in name",
        ),
    ] = None,
    rail: Annotated[str | None, typer.Option(metavar="FILE", help="Rail profile, likewise")] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE",
            help="Start value of a parameter or an input, by its name in the FMU and in SI units, for tools "
            "that cannot set it: --set contact_mode=compliant; can be repeated",
        ),
    ] = None,
    smoothing: Smoothing = None,
):
    """Pack the FMU of a wheelset on track and print its path.

    Example: wrcontact build --native --wheel my_wheel.csv --rail 54E1 --output fmus
    """
    from ..fmu.build import built
    from ..fmu.settings import settings_of

    if platforms and not native:
        raise Refused("--platforms is given; it is permitted only with --native")
    if single_wheel and not native:
        raise Refused("--single-wheel is given; it is permitted only with --native")
    for name in platforms.split(",") if platforms and platforms != "all" else ():
        if name not in PLATFORMS:
            raise Refused(
                f"--platforms has {name!r}; permitted are {', '.join(PLATFORMS)} and all"
                f"{did_you_mean(name, PLATFORMS)}"
            )
    check_folder(output)
    with sentences(lambda sentence: f"--set: {sentence}"):
        settings = settings_of(settings or (), "right" if single_wheel else None)
    with sentences(typed), working("building the FMU"):
        paths = built(
            native,
            platforms,
            "right" if single_wheel else None,
            output=output,
            wheel=wheel,
            rail=rail,
            settings=settings,
            smoothing=None if smoothing is None else smoothing / 1e6,
        )
    print(*paths, sep="\n")


@main.command(cls=Command, rich_help_panel=CONTACT)
@with_all
@reads_files
@takes(pose=POSE, system=SYSTEM)
def solve(
    pose,
    system,
    as_json: Annotated[bool, typer.Option("--json", help="Print all results as JSON, in SI units")] = False,
    smoothing: Smoothing = None,
):
    """Solve one pose and print the contact of both wheels side by side.

    With --contact-mode rigid, the default, the undeformed wheels touch the rails. With elastic, the wheels
    approach the rails until each carries its load. With compliant, --vertical-shift-mm and --roll-deg
    prescribe the position, and the loads follow. With --tangential-model and --speed there are creep forces.

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


@main.command(cls=Command, rich_help_panel=CONTACT)
@with_all
@writes_tables
@sweeps_grids
@reads_files
@takes(load=LOAD, system=SYSTEM)
def sweep(
    load,
    system,
    start: Annotated[
        float | None, millimetres("--from-mm", "First lateral shift, in mm (default: -8)")
    ] = None,
    stop: Annotated[float | None, millimetres("--to-mm", "Last lateral shift, in mm (default: 8)")] = None,
    step: Annotated[
        float | None, millimetres("--step-mm", "Step of the lateral shift, in mm (default: 0.5)")
    ] = None,
    grid=None,
    file=None,
    smoothing: Smoothing = None,
):
    """Move the wheelset across the track and print a table of its contacts.

    With --output all outputs, or --outputs, are written to a file instead: .csv and .json with the names of
    the FMU, .parquet for pandas, .nc for xarray. With --axis and --store the table is over several inputs, of
    any size.

    Example: wrcontact sweep --from-mm -8 --to-mm 8 --step-mm 0.1 --output sweep.csv
    """
    if grid.axes:
        refuse_beside_axes({"--from-mm": start, "--to-mm": stop, "--step-mm": step, "--output": file})
        system = _system(system, smoothing)
        _refuse_what_is_not_read(system, {**load, **grid.axes})
        write_grid(grid, system, load)
        return
    shifts, step = shifts_of(start, stop, step, to_file=bool(file))
    if file:
        check_file(file.path)
    elif grid.outputs is not None:
        raise Refused("--outputs is given; it is permitted only with --output or --axis")
    system = _system(system, smoothing)
    _refuse_what_is_not_read(system, load)
    remark = Remark(system)
    if file:
        _write_sweep(file, system, shifts, {"outputs": grid.outputs or "all", **load}, remark)
        print(f"{len(shifts)} rows written to {file.path}")
    else:
        columns = sweep_columns(system, load)
        table = system.evaluate_many(
            lateral_shift=shifts, outputs=sweep_outputs(columns), processes=core_count(), **load
        )
        remark.add(table)
        if not remark.useless:
            print_sweep(table, step, columns)
    if remark.useless:
        raise Refused(remark.words())
    if remark.words():
        print(f"wrcontact: {remark.words()}", file=sys.stderr)


def _write_sweep(file, system, shifts, chosen, remark):
    """Write the sweep part by part, with the other arguments ``chosen`` of ``evaluate_parts``; no file if no
    row has a contact."""
    if chosen["outputs"] == "all" and file.size_words(len(shifts)):
        print(f"wrcontact: {file.size_words(len(shifts))}", file=sys.stderr)
    with sentences(grid_options), working("sweep", len(shifts)) as advance, file.open(len(shifts)) as write:
        for part in system.evaluate_parts(lateral_shift=shifts, processes=core_count(), **chosen):
            write(part)
            remark.add(part)
            advance(len(part))
        if remark.useless:
            raise Refused(remark.words())


@main.command(cls=Command, rich_help_panel=CONTACT)
@with_all
@reads_files
@takes(pose=POSE, system=SYSTEM)
@draws
def plot(pose, system, picture, smoothing: Smoothing = None):
    """Draw a picture of KIND; without it wheels, rails and patches of one pose.

    lines: where wheel and rail touch over the lateral shift; radii, angles, roll: rolling radius difference,
    contact angles and roll over the lateral shift; wheel: a wheel on its rail in three dimensions; patch:
    patches with pressure, shear stress, stick and slip; creep: creep force over creepage by model, of the
    patch with the largest load; along: contacts and loads along rails that change; history: columns of a CSV
    file over time; animation: its wheelset on the track.

    Example: wrcontact plot patch --lateral-shift-mm 5 --tangential-model strips --speed 20
    """
    picture.check(pose, system)
    system = _system(system, smoothing) if picture.kind.system else None
    state = None
    if picture.of_pose:
        _refuse_what_is_not_read(system, pose)
        state = system.evaluate(**pose)
        _refuse_without_contact(system, state)
    picture.write(system, pose, state)
    print(f"picture written to {picture.output}")


@main.command(cls=Command, rich_help_panel=CONTACT)
@with_all
@reads_files
@takes(geometry=GEOMETRY)
def check(
    geometry,
    output: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            show_default=False,
            help="File of the picture: .png, .svg or .pdf; with --batch a folder (default: check.png, "
            "wrcontact-fleet)",
        ),
    ] = None,
    file: Annotated[
        Path | None,
        typer.Option("--json", metavar="FILE", help="Write all results to this file as JSON, in SI units"),
    ] = None,
    table: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.csv",
            help="Write contact points, contact angles, rolling radii, their difference and the equivalent "
            "conicity over the lateral shift to this file, in mm and deg",
        ),
    ] = None,
    batch: Annotated[
        tuple[str, str] | None,
        typer.Option(
            metavar="WHEELS RAILS",
            callback=_both,
            help="Check every wheel on every rail: folders with files, patterns in quotes, or names; "
            "interrupted, the same command continues",
        ),
    ] = None,
    pictures: Annotated[
        str | None,
        typer.Option(
            metavar="remarks|all|none", help="With --batch: which pairs are drawn (default: remarks)"
        ),
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS", help="With --batch: address of a dask scheduler whose workers do the work"
        ),
    ] = None,
    smoothing: Smoothing = None,
):
    """Check a pair of profiles before a simulation relies on it.

    The command prints and draws where the contact jumps, how fast contact and roll change with the lateral
    shift, where wheel and rail are conformal, the quality of the profiles, and the equivalent conicity at 1
    to 8 mm (EN 15302). The exit code is 1 if the pair has no contact within 1 mm of the centred position.
    Where the left side differs, its picture is written beside that of the right one, as check_left.png.

    With --batch it checks all pairs of two folders and writes a report.

    Example: wrcontact check --wheel worn.whl --rail 60E1 --output worn.png
    """
    from .check import check_many, check_one

    if batch:
        for name, value in (("json", file), ("table", table)):
            if value:
                more = ", which writes one for each pair" if name == "json" else ""
                raise Refused(f"--{name} is given; it is permitted only without --batch{more}")
        check_many(
            geometry,
            batch,
            output or Path("wrcontact-fleet"),
            {"pictures": pictures or "remarks", "scheduler": scheduler, "smoothing": smoothing},
        )
        return
    for name, value in (("pictures", pictures), ("scheduler", scheduler)):
        if value is not None:
            raise Refused(f"--{name} is given; it is permitted only with --batch")
    output = output or Path("check.png")
    _refuse_no_picture(output)
    if table and table.suffix.lower() != ".csv":
        raise Refused(f"--table is {str(table)!r}; permitted is a file that ends in .csv")
    for target in filter(None, (output, file, table)):
        check_file(target)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)  # the report has all remarks
        system = _system(geometry, smoothing)
    check_one(system, output, file, table)


main.command(cls=Command, rich_help_panel=CONTACT)(with_all(reads_files(takes(geometry=GEOMETRY)(wear))))
main.command(cls=Command, rich_help_panel=CONTACT)(profiles)
main.command(cls=Command, rich_help_panel=CONTACT)(
    with_all(reads_files(takes(pose=POSE, system=SYSTEM)(export)))
)


@main.command(cls=Command, rich_help_panel=STUDY)
def figures(
    more: Annotated[
        list[str] | None, typer.Argument(metavar="NUMBER", help="Further figures after --only")
    ] = None,
    output: Annotated[
        Path, typer.Option(metavar="DIR", help="Folder for the pictures, the tables and the index")
    ] = Path("wrcontact-figures"),
    only: Annotated[
        list[str] | None, typer.Option(metavar="NUMBER", help="Draw only these figures, such as 7.2")
    ] = None,
):
    """Recompute and draw the figures of the degree project that wrcontact started from.

    Each figure is written as a picture and a CSV table, such as fig_7_2.png and fig_7_2.csv. The index
    figures.md shows all of them, with what the project states and what is found here. This takes about 15
    seconds.

    Example: wrcontact figures --only 7.2 7.4
    """
    from ..study.figures import INDEX, summary, write_figures
    from .report import console

    check_folder(output)
    with sentences():
        found = write_figures(output, (only or []) + (more or []))
        console().print(summary(found))
        console().print(f"{len(found)} figures, their tables and {INDEX} written to {output}", soft_wrap=True)


def _refuse_no_picture(output):
    if output.suffix.lower() not in PICTURES:
        raise Refused(f"--output is {str(output)!r}; permitted are files that end in {', '.join(PICTURES)}")


def _system(parameters, smoothing):
    """The contact system with these parameters."""
    with sentences(typed):
        return ContactSystem(**parameters, smoothing=None if smoothing is None else smoothing / 1e6)


def _refuse_what_is_not_read(system, given):
    """Refuse an option that the methods do not use: the result would not be what was asked for."""
    names = (
        ("normal_force", "load_transfer") if is_compliant(system) else ("vertical_shift_input", "roll_input")
    )
    for variable in POSE:
        if variable.name in names and variable.name in given:
            allowed = "rigid or elastic" if is_compliant(system) else "compliant"
            raise Refused(
                f"{option_of(variable)} is given; it is permitted only with --contact-mode "
                f"{allowed}; {system.parameters['contact_mode']!r} does not use it"
            )
        if variable.name in ROLLING_CONTACT and name_of(variable) in given and not has_model(system):
            raise Refused(
                f"{option_of(variable)} is given; it is permitted only with --tangential-model "
                f"{' or '.join(CHOICES['tangential_model'][1:])}"
            )


def _refuse_without_contact(system, state):
    """Refuse a state without contact: exit code 1 if the search did not converge, 2 if the input has no
    contact."""
    if state.status > Status.UNLOADED:
        raise Refused(
            sentence(state.status, state.inputs, is_compliant(system), Typed()),
            code=1 if state.status == Status.NOT_CONVERGED else 2,
        )
