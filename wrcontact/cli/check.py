"""``wrcontact check``: the report on a pair of profiles, as text, and that on a fleet."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import typer
from rich import box
from rich.table import Table

from ..conditioning import check
from ..conditioning.conformal import NEAR
from ..conditioning.curves import merged_jumps
from ..conditioning.table import table_text
from ..conditioning.text import check_text, headline
from ..profiles.remarks import Grave
from ..progress import working
from ..results.words import fixed
from ..storage.atomic import write_atomically
from .door import Refused, check_folder, sentences
from .report import console
from .typed import typed

#: Lateral shifts of the printed table [mm].
PRINTED = (0, 1, 2, 3, 4, 5, 6, 7, 8)
#: Columns of that table: heading, reader of the curves, factor to the printed unit, digits.
MOVES = (
    ("roll\nmrad/mm", lambda curves: curves.roll_rate, 1.0, 3),
    ("on wheel\nmm/mm", lambda curves: curves.right.wheel_rate, 1.0, 2),
    ("on rail\nmm/mm", lambda curves: curves.right.rail_rate, 1.0, 2),
    ("next jump\nmm", lambda curves: curves.jump_distance, 1e3, 2),
    ("angle\ndeg", lambda curves: curves.right.contact_angle, math.degrees(1), 1),
    ("curvature\n1/m", lambda curves: curves.right.curvature, 1.0, 1),
    ("close\nmm", lambda curves: curves.right.near_width, 1e3, 1),
)
#: Rows of the table of profiles: name, unit, factor to that unit, digits, reader of a Quality; READINGS read
#: its Reading.
QUALITIES = (
    ("profile from", "mm", 1e3, 2, lambda quality: quality.start),
    ("to", "mm", 1e3, 2, lambda quality: quality.stop),
    ("contacts within 8 mm of shift from", "mm", 1e3, 2, lambda quality: quality.visited[0]),
    ("to", "mm", 1e3, 2, lambda quality: quality.visited[1]),
    ("pieces", "", 1.0, 0, lambda quality: quality.pieces),
    ("kinks there", "", 1.0, 0, lambda quality: len(quality.kinks)),
    ("largest curvature step there", "1/m", 1.0, 1, lambda quality: quality.curvature_step),
    ("roughness of the curvature there", "1/m", 1.0, 2, lambda quality: quality.roughness),
)
READINGS = (
    ("points", "", 1.0, 0, lambda reading: reading.points),
    ("spacing, median", "mm", 1e3, 3, lambda reading: reading.spacing),
    ("spacing, largest", "mm", 1e3, 3, lambda reading: reading.widest),
    ("noise", "um", 1e6, 2, lambda reading: reading.noise),
    ("smoothing", "um", 1e6, 2, lambda reading: reading.smoothing),
)


def check_one(system, output, file, table):
    """Check the pair of a ``system``, print the report, and write its picture to ``output``, its JSON to
    ``file`` and its curves to ``table``, where these are not None."""
    from ..plots import check_figure, save

    with working("checking the pair", 2) as advance:
        report = check(system)
        advance(words="drawing the picture")
        pictures = {output: check_figure(report)}
        if not system.equal_sides:
            pictures[output.with_stem(output.stem + "_left")] = check_figure(report, side="left")
    print_check(report)
    with sentences():
        if file:
            write_atomically(file, check_text(report).encode())
        if table:
            write_atomically(table, table_text(report).encode())
        for target, figure in pictures.items():
            save(figure, target)
    print(f"\npicture written to {' and '.join(map(str, pictures))}")
    if table:
        print(f"table written to {table}")
    if not report.usable:
        raise typer.Exit(1)


def check_many(geometry, batch, output, chosen):
    """Check every wheel on every rail and write the report to the folder ``output``; ``batch`` are both,
    which ``geometry`` may have as ProfileFiles, and ``chosen`` other arguments of check_fleet."""
    from ..fleet import check_fleet
    from ..fleet.page import summary

    check_folder(output)
    wheels, rails = (geometry.pop(kind, given) for kind, given in zip(("wheel", "rail"), batch))
    if chosen["smoothing"] is not None:
        chosen["smoothing"] /= 1e6
    with sentences(typed):
        try:
            fleet = check_fleet(wheels, rails, output, **chosen, **geometry)
        except RuntimeError as wrong:
            raise Refused(str(wrong), code=1) from None
    print(summary(fleet), *(row["error"] for row in fleet.broken), sep="\n")
    print(f"report written to {Path(fleet.report)}")
    if not all(row["usable"] for row in fleet):
        raise typer.Exit(1)


def print_check(report):
    """Print all tables and remarks of a :class:`~wrcontact.conditioning.Conditioning`."""
    out = console()
    out.print(headline(report), soft_wrap=True)
    for remark in filter(lambda one: isinstance(one, Grave), report.remarks):
        out.print(f" * {typed(remark)}", soft_wrap=True)
    out.print(_range_words(report), soft_wrap=True)
    mirrored = " (the left one's are the mirror image)" if report.system.equal_sides else ""
    parts = [
        ("Profiles", profile_table(report)),
        (f"Jumps of the right contact{mirrored}", jump_table(report)),
        ("Right contact over the lateral shift", move_table(report.curves)),
        ("Equivalent conicity", conicity_table(report.conicity)),
        ("Conformal zones of the right contact", zone_table(report)),
    ]
    if not report.system.equal_sides:
        parts[1:1] = [("Profiles of the left side", profile_table(report, "left"))]
        parts += [
            ("Jumps of the left contact", jump_table(report, "left")),
            ("Left contact over the lateral shift", move_table(report.curves, "left")),
            ("Conformal zones of the left contact", zone_table(report, "left")),
        ]
    for title, table in parts:
        out.print(f"\n{title}{'' if table.row_count else ': none'}", soft_wrap=True)
        if table.row_count:
            out.print(table)
    others = [remark for remark in report.remarks if not isinstance(remark, Grave)]
    more = "Other remarks" if len(others) < len(report.remarks) else "Remarks"
    out.print(f"\n{more}{'' if others else ': none'}", soft_wrap=True)
    for remark in others:
        out.print(f" * {typed(remark)}", soft_wrap=True)


def _mm(value):
    return f"{value * 1e3:.6g}"


def _shown(value, factor, digits, significant=1):
    """``value`` times ``factor`` as text, see :func:`~wrcontact.results.words.fixed`."""
    return fixed(float(value) * factor, digits, significant)


def _range_words(report):
    first, last = report.usable_shifts
    if not math.isfinite(first):
        return "no contact in the centred position"
    flange = f"{report.flange_shift * 1e3:.2f} mm" if math.isfinite(report.flange_shift) else "nowhere"
    return (
        f"contact at lateral shifts from {first * 1e3:.2f} to {last * 1e3:.2f} mm; on the flange "
        f"(steeper than 45 deg) from: {flange}"
    )


def _table(*headings):
    table = Table(box=box.SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0))
    for heading in headings:
        table.add_column(heading, justify="right", vertical="bottom", no_wrap=True)
    return table


def profile_table(report, side="right"):
    """Ends of each profile of a side, the part in contact, its roughness there, and its points if it comes
    from a file."""
    both = (report.wheel, report.rail) if side == "right" else (report.left_wheel, report.left_rail)
    table = Table("", "", box=box.SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0))
    for quality in both:
        table.add_column(f"{quality.kind} {quality.name}", justify="right")
    for words, unit, factor, digits, read in QUALITIES:
        table.add_row(words, unit, *(_shown(read(quality), factor, digits) for quality in both))
    for words, unit, factor, digits, read in READINGS if any(quality.reading for quality in both) else ():
        table.add_row(
            words,
            unit,
            *(_shown(read(quality.reading), factor, digits) if quality.reading else "-" for quality in both),
        )
    return table


def jump_table(report, side="right"):
    """Lateral shift of each jump of a side, and the positions on wheel and rail before and
    after it, for rising shift."""
    table = _table("shift\nmm", "on wheel\nbefore", "after\nmm", "on rail\nbefore", "after\nmm")
    for jump in merged_jumps(report.jumps, side):
        places = (jump.before, jump.after, jump.rail_before, jump.rail_after)
        table.add_row(_shown(jump.lateral_shift, 1e3, 4), *(_shown(y, 1e3, 2) for y in places))
    return table


def move_table(curves, side="right"):
    """Rates of roll and contact position, and the contact's geometry, of a side at the shifts PRINTED."""
    if side == "left":
        curves = replace(curves, right=curves.left)
    table = _table("shift\nmm", *(heading for heading, *_ in MOVES))
    for shift in PRINTED:
        at = int(np.argmin(np.abs(curves.lateral_shift - shift * 1e-3)))
        if np.isfinite(curves.roll[at]):
            table.add_row(
                str(shift), *(_shown(read(curves)[at], factor, digits) for _, read, factor, digits in MOVES)
            )
    return table


def conicity_table(conicity):
    """Amplitude, equivalent conicity without and with roll, and wavelength without roll."""
    table = _table("amplitude\nmm", "without\nroll", "with\nroll", "wavelength\nm")
    columns = (
        (conicity.amplitude, 1e3, 0),
        (conicity.level, 1.0, 3),
        (conicity.rolled, 1.0, 3),
        (conicity.wavelength, 1.0, 1),
    )
    for row in range(len(conicity.amplitude)):
        table.add_row(*(_shown(values[row], factor, digits, 3) for values, factor, digits in columns))
    return table


def zone_table(report, side="right"):
    """Ranges of lateral shift over which the contact of a side is conformal."""
    table = _table(
        "from\nmm", "to\nmm", "on wheel\nfrom", "to\nmm", f"within\n{_mm(NEAR)} mm over", "turns by\ndeg"
    )
    for zone in report.conformal:
        if zone.side == side:
            table.add_row(
                *(_shown(y, 1e3, 2) for y in (zone.start, zone.stop)),
                *(_shown(y, 1e3, 1) for y in (zone.y_low, zone.y_high, zone.width)),
                _shown(zone.turn, math.degrees(1), 1),
            )
    return table
