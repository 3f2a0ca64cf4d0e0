"""``wrcontact export``: results for other programs."""

import math
from pathlib import Path
from typing import Annotated

import typer

from ..interface.inputs import INPUTS
from ..methods.numbers import check_choice
from ..results.runs import read_run
from ..status import Status
from ..system import ContactSystem
from .errors import Refused, check_file, check_folder, sentences
from .grids import shifts_of
from .profile_files import Smoothing
from .typed import typed

TARGETS = ("contact", "table")


def export(
    pose,
    system,
    to: Annotated[
        str,
        typer.Option(
            "--to",
            metavar="contact|table",
            help="contact: input files of CONTACT for one pose, or for --run; table: contacts over lateral shift "
            "and yaw as CSV",
        ),
    ] = "table",
    output: Annotated[
        Path | None,
        typer.Option(
            metavar="PATH",
            show_default=False,
            help="File of the table, folder of the files for CONTACT (default: contacts.csv, contact)",
        ),
    ] = None,
    run: Annotated[
        Path | None,
        typer.Option(
            "--run",
            metavar="FILE",
            show_default=False,
            help="With --to contact: CSV file of poses, in SI with the names of the FMU's inputs",
        ),
    ] = None,
    shifts: Annotated[
        str | None,
        typer.Option(
            "--shifts-mm",
            metavar="FROM:TO:STEP",
            show_default=False,
            help="Lateral shifts of the table, in mm (default: -8:8:0.5)",
        ),
    ] = None,
    yaws: Annotated[
        str | None,
        typer.Option(
            "--yaws-deg",
            metavar="NUMBER[,NUMBER]",
            show_default=False,
            help="Yaws of the table, in deg (default: that of --yaw-deg)",
        ),
    ] = None,
    smoothing: Smoothing = None,
):
    """Write contacts or poses as files for other programs.

    The table has contact points, contact angles, rolling radii and curvatures of both wheels, and a header with
    frames and units. The files for CONTACT have the profiles beside them, and a case for each pose.

    Example: wrcontact export --to contact --lateral-shift-mm 1
    """
    with sentences():
        check_choice("--to", to, TARGETS)
    if to == "contact":
        for option, value in (("--shifts-mm", shifts), ("--yaws-deg", yaws)):
            if value is not None:
                raise Refused(f"{option} is given; it is permitted only with --to table")
        _for_contact(_system(system, smoothing), pose, run, output or Path("contact"))
        return
    if run is not None:
        raise Refused("--run is given; it is permitted only with --to contact")
    if "lateral_shift" in pose:
        raise Refused("--lateral-shift-mm is given; permitted with --to table is --shifts-mm")
    if yaws is not None and "yaw" in pose:
        raise Refused("--yaw-deg and --yaws-deg are given; permitted is one of them")
    _table(_system(system, smoothing), pose, _shifts(shifts), yaws, output or Path("contacts.csv"))


def _shifts(text):
    """Lateral shifts [m] of FROM:TO:STEP in mm."""
    if text is None:
        return shifts_of(None, None, None, to_file=True)[0]
    parts = text.split(":")
    if len(parts) != 3:
        raise Refused(f"--shifts-mm is {text!r}; permitted is FROM:TO:STEP, in mm, such as -8:8:0.5")
    try:
        start, stop, step = (float(part) for part in parts)
    except ValueError:
        raise Refused(f"--shifts-mm is {text!r}; permitted are three numbers, in mm") from None
    return shifts_of(start, stop, step, to_file=True)[0]


def _system(parameters, smoothing):
    with sentences(typed):
        return ContactSystem(**parameters, smoothing=None if smoothing is None else smoothing / 1e6)


def _table(system, pose, shifts, yaws, output):
    """Write the table of contacts."""
    from ..export import contact_table, write_contact_table

    if output.suffix.lower() == ".kpfr":
        raise Refused(
            f"--output is {str(output)!r}, a file of GENSYS, whose columns were not found in a public text; permitted is a file that "
            "ends in .csv"
        )
    if output.suffix.lower() != ".csv":
        raise Refused(f"--output is {str(output)!r}; permitted is a file that ends in .csv")
    check_file(output)
    turned = pose.pop("yaw", 0.0)
    if yaws is not None:
        try:
            turned = [math.radians(float(value)) for value in yaws.split(",")]
        except ValueError:
            raise Refused(
                f"--yaws-deg is {yaws!r}; permitted are numbers with commas between, in deg"
            ) from None
    with sentences(typed):
        table = contact_table(system, shifts, turned, **pose)
    if not (table["status"] == Status.VALID).any():
        raise Refused("no lateral shift of the table has a contact")
    write_contact_table(output, table)
    print(f"{len(table['status'])} rows written to {output}")


def _for_contact(system, pose, run, output):
    """Write input of CONTACT."""
    from ..export import to_contact

    check_folder(output)
    with sentences(typed):
        if run is None:
            found = system.evaluate(**pose)
        else:
            if pose:
                raise Refused("--run and inputs of a pose are given; permitted is one of them")
            columns = read_run(run)
            given = {row.keyword: columns[row.name] for row in INPUTS if row.name in columns}
            if not given:
                raise Refused(
                    f"--run is {str(run)!r}, which has no column of an input, such as lateral_shift"
                )
            found = system.evaluate_many(**given)
        paths = to_contact(system, found, output)
    print(*paths, sep="\n")
