"""Contacts over lateral shift and yaw as a CSV file that says its frames and units."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from os import PathLike, fspath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..profiles.changing import refuse_changing
from ..storage.atomic import open_atomically

#: Column by its name in the file, and the factor to its unit.
MM, DEG = 1e3, 180.0 / np.pi
OF_WHEELSET = {
    "lateral_shift [mm]": ("lateral_shift", MM),
    "yaw [deg]": ("yaw", DEG),
    "status": ("status", 1.0),
    "roll [deg]": ("roll", DEG),
    "vertical_shift [mm]": ("vertical_shift", MM),
}
OF_WHEEL = {
    "contact.x_wheel [mm]": ("contact.x_wheel", MM),
    "contact.y_wheel [mm]": ("contact.y_wheel", MM),
    "contact.z_wheel [mm]": ("contact.z_wheel", MM),
    "contact.y_rail [mm]": ("contact.y_rail", MM),
    "contact.z_rail [mm]": ("contact.z_rail", MM),
    "contact.x_track [mm]": ("contact.x_track", MM),
    "contact.y_track [mm]": ("contact.y_track", MM),
    "contact.z_track [mm]": ("contact.z_track", MM),
    "contact_angle [deg]": ("contact_angle", DEG),
    "rolling_radius [mm]": ("rolling_radius", MM),
    "curvature_x [1/m]": ("curvature_x", 1.0),
    "curvature_y [1/m]": ("curvature_y", 1.0),
}
COLUMNS = OF_WHEELSET | {
    f"{side}.{name}": (f"{side}.{output}", factor)
    for side in ("left", "right")
    for name, (output, factor) in OF_WHEEL.items()
}
HEADER = """\
# wrcontact, contacts over lateral shift and yaw: {title}
# track frame: x forward, y to the right, z down; origin on the middle of the track at the height of the rails' heads
# lateral_shift: wheelset to the right; yaw: clockwise from above; roll: right wheel down; vertical_shift: wheelset down
# y_wheel: from the running circle to the field side; z_wheel: down from it; y_rail, z_rail: from the highest point of the
# inclined head to the field side and down; contact_angle: positive towards the flange; the left wheel is mirrored
# status: 0 valid, otherwise nan ({pages})
"""
PAGES = "wrcontact, docs/reference/statuses.md"


def contact_table(
    system: Any, lateral_shift: ArrayLike, yaw: ArrayLike = 0.0, **inputs: float
) -> dict[str, Any]:
    """Contacts of every yaw at every lateral shift: arrays (n,) in SI by the names of outputs, yaw by yaw, and "title".

    Parameters
    ----------
    system : a :class:`~wrcontact.ContactSystem`.
    lateral_shift, yaw : of the wheelset (k,), (m,) [m], [rad].
    inputs : others of ``evaluate``, one value each.
    """
    refuse_changing(system, "contact_table")
    shifts, yaws = np.atleast_1d(lateral_shift), np.atleast_1d(yaw)
    across, turned = (part.ravel() for part in np.meshgrid(shifts, yaws))
    found = system.evaluate_many(lateral_shift=across, yaw=turned, outputs="geometry", **inputs)
    given = {"lateral_shift": across, "yaw": turned, "status": found.status}
    table = {
        name: np.asarray(given.get(name) if name in given else found[name], float)
        for name, _ in COLUMNS.values()
    }
    return {"title": system.title, **table}


def write_contact_table(path: str | PathLike[str], table: Mapping[str, Any]) -> None:
    """Write a table of :func:`contact_table` as CSV, in mm and deg, below a header with its frames."""
    with open_atomically(path, "w", newline="", encoding="utf-8") as file:
        file.write(HEADER.format(title=table["title"], pages=PAGES))
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        columns = [factor * np.asarray(table[name], float) for name, factor in COLUMNS.values()]
        writer.writerows([repr(float(value)) for value in row] for row in zip(*columns))


def read_contact_table(path: str | PathLike[str]) -> dict[str, NDArray[np.float64]]:
    """A file of :func:`write_contact_table`: arrays (n,) in SI by the names of outputs.

    Raises
    ------
    ValueError
        if the file has other columns.
    """
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    if not rows or rows[0] != list(COLUMNS):
        raise ValueError(
            f"{fspath(path)} is no table of contacts; permitted are those of write_contact_table"
        )
    values = np.array([[float(value) for value in row] for row in rows[1:]]).reshape(-1, len(COLUMNS))
    return {name: values[:, k] / factor for k, (name, factor) in enumerate(COLUMNS.values())}
