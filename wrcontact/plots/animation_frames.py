"""Frames of an animation: the states of a run at the times of an animation's frames."""

from dataclasses import dataclass

import numpy as np

from ..conventions import SIDES
from ..interface.inputs import INPUTS
from ..results.runs import Run
from ..status import Status
from .geometry import rail_lengths
from .patch import missing, patch_ends, patch_places, pressure_scale
from .style import MM

SPARE = 2e-3  # [m] around the patches
#: Places of a compliant wheelset by the names that a model of its motion has for them.
FOLLOWING = {"vertical_shift_input": "vertical_shift", "roll_input": "roll"}


@dataclass(frozen=True)
class AnimationFrames:
    """States of the frames, their times [s] and distances [m], and the window that holds all patches."""

    system: object
    rows: list
    time: np.ndarray
    distance: np.ndarray
    scale: object
    window: tuple


def frames_of(system, run, frames):
    """Evaluate the poses that are drawn."""
    if not (isinstance(frames, int) and frames > 0):
        raise ValueError(f"frames is {frames!r}; permitted are whole numbers from 1 on")
    run = Run.of(run)
    names = run.names
    given = {row.keyword: row.name for row in INPUTS if row.name in names and not row.hint}
    if system.parameters["contact_mode"] == "compliant":
        given = {place: name for place, name in FOLLOWING.items() if name in names} | given
    else:
        given = {keyword: name for keyword, name in given.items() if keyword not in FOLLOWING}
    if "lateral_shift" not in given:
        raise ValueError("the run has no 'lateral_shift'; permitted is a run that has it")
    count = len(run["lateral_shift"])
    pick = np.unique(np.linspace(0, count - 1, min(frames, count)).round().astype(int))
    table = system.evaluate_many(**{keyword: run[name][pick] for keyword, name in given.items()})
    time = run["time"][pick] if "time" in names else np.full(len(pick), np.nan)
    valid = np.flatnonzero(np.asarray(table.status) <= Status.UNLOADED)
    if not len(valid):
        raise ValueError(f"none of the {len(pick)} poses of the run has a contact")
    rows = [table[int(k)] for k in valid]
    outlines = [
        getattr(row, side).outline for row in rows for side in SIDES if not missing(getattr(row, side))
    ]
    return AnimationFrames(
        system,
        rows,
        time[valid],
        _distance(run, pick)[valid],
        pressure_scale(outlines) if outlines else None,
        _window(system, rows),
    )


def _distance(run, pick):
    """How far the wheelset has come at the frames [m]; zero where the run does not say it."""
    if "distance" in run:
        return run["distance"][pick]
    if "time" in run and "speed" in run:
        time, speed = run["time"], run["speed"]
        way = np.concatenate([[0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(time))])
        return way[pick]
    return np.zeros(len(pick))


def _window(system, rows):
    """Limits across, low and high, and along that hold the patches of all rows and both sides [mm]."""
    places = [
        (shifted(system, row, side), patch_places(system, row, side))
        for row in rows
        for side in SIDES
        if not missing(getattr(row, side))
    ]
    across = [end for outline, _ in places for end in outline.station[[0, -1]]] or [-SPARE, SPARE]
    along = max((max(map(abs, patch_ends(*one))) for one in places), default=SPARE)
    return (min(across) - SPARE) / MM, (max(across) + SPARE) / MM, (along + SPARE) / MM


@dataclass(frozen=True)
class OnRail:
    """An outline whose stations are arc lengths on the rail from its highest point [m]."""

    station: np.ndarray
    half_length: np.ndarray
    pressure: np.ndarray


def shifted(system, row, side):
    """The outline of one side on its rail."""
    _, z, length = rail_lengths(system, side, row)
    outline = getattr(row, side).outline
    return OnRail(outline.station - length[np.argmin(z)], outline.half_length, outline.pressure)
