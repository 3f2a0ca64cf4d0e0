"""The table of a fleet: a row for each pair, and one for each file that cannot be used."""

import csv
import io
import math
from dataclasses import dataclass

import numpy as np

from ..conditioning.conicity import AMPLITUDES
from ..conditioning.curves import merged_jumps
from ..conditioning.remarks import RUNNING
from ..conventions import SIDES
from ..profiles.remarks import Grave
from ..results.convert import needed
from ..results.words import plain

TOLD = ("wheel", "rail", "wheel_file", "rail_file", "error", "usable", "remarks", "json", "picture")
#: Numbers of a row: name, unit, meaning.
NUMBERS = {
    "usable_from": ("m", "first lateral shift with contact around the centred position"),
    "usable_to": ("m", "last lateral shift with contact around the centred position"),
    "flange_shift": ("m", "lateral shift from which a contact is steeper than 45 deg"),
    "nearest_jump": ("m", "distance of the nearest jump from the centred position"),
    "jump_count": ("1", "jumps of a contact within 8 mm of lateral shift, of the side with more"),
    "wheel_rate": ("1", "largest rate of a contact on its wheel within 8 mm of lateral shift"),
    **{
        f"conicity_{round(value * 1e3)}mm": (
            "1",
            f"equivalent conicity at {round(value * 1e3)} mm amplitude, without roll",
        )
        for value in AMPLITUDES
    },
    "conicity_3mm_rolled": ("1", "equivalent conicity at 3 mm amplitude, with roll"),
    "nonlinearity": ("1/m", "change of the conicity from 2 to 4 mm amplitude"),
    "conformal_count": ("1", "conformal zones within 8 mm of lateral shift, of the side with more"),
    "conformal_width": ("m", "longest close stretch in these zones"),
    "conformal_turn": ("rad", "largest change of direction in these zones"),
    "wheel_noise": ("m", "noise of the points of the wheel"),
    "rail_noise": ("m", "noise of the points of the rail"),
    "wheel_roughness": ("1/m", "roughness of the wheel's curvature in contact"),
    "rail_roughness": ("1/m", "roughness of the rail's curvature in contact"),
    "rail_file_inclination": ("1", "inclination from which the rail in the file was turned upright"),
    "grave_remarks": ("1", "remarks, the first ones, on what makes all results wrong if it is so"),
}


def numbers_of(report):
    """The NUMBERS of a :class:`~wrcontact.conditioning.Conditioning`; None where there is no value."""
    near = np.abs(report.curves.lateral_shift) <= RUNNING
    moves = np.concatenate([getattr(report.curves, side).wheel_rate[near] for side in SIDES])
    jumps = [
        sum(abs(jump.lateral_shift) <= RUNNING for jump in merged_jumps(report.jumps, side)) for side in SIDES
    ]
    zones = [zone for zone in report.conformal if zone.start <= RUNNING and zone.stop >= -RUNNING]
    counts = [sum(zone.side == side for zone in zones) for side in SIDES]
    level = report.conicity.level
    found = {
        "usable_from": report.usable_shifts[0],
        "usable_to": report.usable_shifts[1],
        "flange_shift": report.flange_shift,
        "nearest_jump": report.nearest_jump,
        "jump_count": max(jumps),
        "wheel_rate": float(np.max(np.abs(moves[np.isfinite(moves)]), initial=-math.inf)),
        **{f"conicity_{round(at * 1e3)}mm": float(value) for at, value in zip(AMPLITUDES, level)},
        "conicity_3mm_rolled": float(report.conicity.rolled[2]),
        "nonlinearity": report.conicity.nonlinearity,
        "conformal_count": max(counts),
        "conformal_width": max((zone.width for zone in zones), default=0.0),
        "conformal_turn": max((zone.turn for zone in zones), default=0.0),
    }
    for kind in ("wheel", "rail"):
        quality = getattr(report, kind)
        found[f"{kind}_noise"] = quality.reading.noise if quality.reading else math.nan
        found[f"{kind}_roughness"] = quality.roughness
    read = report.rail.reading
    found["rail_file_inclination"] = read.inclination if read else 0.0
    found["grave_remarks"] = sum(isinstance(remark, Grave) for remark in report.remarks)
    return plain({name: found[name] for name in NUMBERS})


def empty_row(wheel="", rail="", **told):
    """A row without numbers."""
    return {
        "wheel": wheel,
        "rail": rail,
        "wheel_file": "",
        "rail_file": "",
        "error": "",
        "usable": False,
        **dict.fromkeys(NUMBERS),
        "remarks": [],
        "json": "",
        "picture": "",
        **told,
    }


@dataclass(frozen=True, repr=False)
class Fleet:
    """The rows of :func:`wrcontact.check_fleet`, pairs in the order of their wheels and then of their rails,
    after them the files that cannot be used.

    ``fleet[3]`` is a row, ``fleet["conicity_3mm"]`` a column as an array.

    Attributes
    ----------
    rows : tuple of dicts: names and files of the pair, ``error`` (a sentence, or ""), ``usable``, numbers in
        SI (None where there is no value), ``remarks``, and the paths of ``json`` and ``picture`` in the
        folder.
    report : path of the report in HTML; None where no folder was given.
    """

    rows: tuple
    report: str | None = None

    def __len__(self):
        return len(self.rows)

    def __iter__(self):
        return iter(self.rows)

    def __getitem__(self, key):
        if not isinstance(key, str):
            return self.rows[key]
        if key not in (*TOLD, *NUMBERS):
            raise KeyError(f"{key!r}; there are {', '.join((*TOLD, *NUMBERS))}")
        values = [row[key] for row in self.rows]
        if key in NUMBERS:
            return np.array([math.nan if value is None else value for value in values], dtype=float)
        return np.array(values, dtype=bool if key == "usable" else object)

    def __repr__(self):
        wrong = len(self.broken)
        return (
            f"Fleet({len(self) - wrong} pairs, {int(self['usable'].sum())} of them usable"
            f"{f'; rows with an error: {wrong}' if wrong else ''})"
        )

    @property
    def broken(self):
        """The rows with an error."""
        return tuple(row for row in self.rows if row["error"])

    def to_pandas(self):
        """A pandas.DataFrame with a column for each entry of a row.

        Raises
        ------
        ImportError
            in one sentence, if pandas is not installed.
        """
        pandas = needed("pandas", "to_pandas")
        return pandas.DataFrame({name: self[name] for name in (*TOLD[:6], *NUMBERS, *TOLD[6:])})

    def csv_text(self):
        """The table as text for a spreadsheet, in SI; remarks stand in one cell."""
        out = io.StringIO()
        names = (*TOLD[:6], *NUMBERS, *TOLD[6:])
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(names)
        for row in self.rows:
            writer.writerow(["; ".join(row[name]) if name == "remarks" else row[name] for name in names])
        return out.getvalue()
