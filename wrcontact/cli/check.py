"""``wrcontact check``: the report on a pair of profiles, as text, and that on a fleet."""

import math
from pathlib import Path

import numpy as np
import typer
from rich import box
from rich.table import Table

from ..conditioning import check
from ..conditioning.curves import merged_jumps
from ..conditioning.measures import CONICITIES, JUMPS, MOVES, PAIR, QUALITIES, READINGS, ZONES
from ..conditioning.table import table_text
from ..conditioning.text import check_text, headline
from ..profiles.remarks import Grave
from ..progress import working
from ..storage.atomic import write_atomically
from .errors import Refused, check_folder, sentences
from .report import console
from .typed import typed

#: Lateral shifts of the printed table [mm].
PRINTED = (0, 1, 2, 3, 4, 5, 6, 7, 8)


def check_one(system, output, file, table):
    """Check the pair of a ``system``, print the report, and write its picture to ``output``, its JSON to
    ``file`` and its curves to ``table``, where these are not None."""
    from ..plots import check_figure, save

    with sentences(), working("checking the pair", 2) as advance:
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


def _range_words(report):
    if not math.isfinite(report.usable_shifts[0]):
        return "no contact in the centred position"
    first, last, flange = (PAIR[name].text(report) for name in ("usable_from", "usable_to", "flange_shift"))
    return (
        f"contact at lateral shifts from {first} to {last} mm; on the flange (steeper than 45 deg) from: "
        f"{flange + ' mm' if math.isfinite(report.flange_shift) else 'nowhere'}"
    )


def _table(measures, *before):
    """An empty table with a column for each of the ``measures``, after those ``before``."""
    table = Table(box=box.SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0))
    headings = [f"{one.heading}\n{one.shown_unit}".rstrip() for one in measures.values()]
    for heading in (*before, *headings):
        table.add_column(heading, justify="right", vertical="bottom", no_wrap=True)
    return table


def profile_table(report, side="right"):
    """Ends of each profile of a side, the part in contact, its roughness there, and its points if it comes
    from a file."""
    both = (report.wheel, report.rail) if side == "right" else (report.left_wheel, report.left_rail)
    table = Table("", "", box=box.SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0))
    for quality in both:
        table.add_column(f"{quality.kind} {quality.name}", justify="right")
    for one in QUALITIES.values():
        table.add_row(one.heading, one.shown_unit, *map(one.text, both))
    for one in READINGS.values() if any(quality.reading for quality in both) else ():
        texts = (one.text(quality.reading) if quality.reading else "-" for quality in both)
        table.add_row(one.heading, one.shown_unit, *texts)
    return table


def jump_table(report, side="right"):
    """Lateral shift of each jump of a side, and the positions on wheel and rail before and
    after it, for rising shift."""
    table = _table(JUMPS)
    for jump in merged_jumps(report.jumps, side):
        table.add_row(*(one.text(jump) for one in JUMPS.values()))
    return table


def move_table(curves, side="right"):
    """Rates of roll and contact position, and the contact's geometry, of a side at the shifts PRINTED."""
    table = _table(MOVES, "shift\nmm")
    for shift in PRINTED:
        at = int(np.argmin(np.abs(curves.lateral_shift - shift * 1e-3)))
        if np.isfinite(curves.roll[at]):
            table.add_row(str(shift), *(one.said(one.read(curves, side)[at]) for one in MOVES.values()))
    return table


def conicity_table(conicity):
    """Amplitude, equivalent conicity without and with roll, and wavelength without roll."""
    table = _table(CONICITIES)
    for row in range(len(conicity.amplitude)):
        table.add_row(*(one.said(one.read(conicity)[row]) for one in CONICITIES.values()))
    return table


def zone_table(report, side="right"):
    """Ranges of lateral shift over which the contact of a side is conformal."""
    table = _table(ZONES)
    for zone in report.conformal:
        if zone.side == side:
            table.add_row(*(one.text(zone) for one in ZONES.values()))
    return table
