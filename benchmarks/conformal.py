"""Planar against conformal: what the half-space's turning normals change at three poses, and how far the
models are from CONTACT's conformal answers (docs/conformal.md)."""

import csv
import math
from functools import cache

import numpy as np

import wrcontact
from wrcontact.study.planar import planar_contact

from . import runs
from .table import figure, grid

ROWS = runs.TESTS / "reference" / "conformal.csv"
FORCE = 78.5e3           # [N]
SHIFTS = (1e-3, 6e-3, 6.25e-3)  # [m]
PATCH = ("penetration", "area", "max_pressure")
UNITS = (1e-6, 1e-6, 1e6)  # µm, mm², MPa
MODELS = {"halfspace": "half-space", "analyn_strip": "strips", "analyn": "ANALYN"}


@cache
def system(**options):
    return wrcontact.ContactSystem(**options)


def measured(quick=False):
    """Rows by name: both theories at the poses, with rigid contact; errors [%] of force, area and peak
    pressure against CONTACT, with compliant contact.  A quick run takes the first pose and row alone."""
    count = 1 if quick else None
    return {**poses(SHIFTS[:count]), **{model: against_contact(model, count) for model in MODELS}}


def poses(shifts):
    """Penetration [um], area [mm2] and peak pressure [MPa] by pose and theory."""
    found = {}
    for shift in shifts:
        planar = planar_contact(system(), system().evaluate(shift, 0.0, FORCE), FORCE)
        turning = system(normal_model="halfspace").evaluate(shift, 0.0, FORCE, side="right").right
        found[f"{1e3 * shift:g} mm"] = {
            name: [getattr(each, quantity) / unit for quantity, unit in zip(PATCH, UNITS)]
            for name, each in (("planar", planar), ("conformal", turning))}
    return found


def against_contact(model, count=None):
    """Mean and worst error [%], and those of every row or of ``count``."""
    with open(ROWS, newline="", encoding="utf-8") as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)][:count]
    errors = []
    for row in rows:
        side = system(normal_model=model, contact_mode="compliant").evaluate(
            row["lateral_shift_mm"] * 1e-3, math.radians(row["yaw_deg"]), side="right",
            vertical_shift_input=row["vertical_shift_mm"] * 1e-3, roll_input=row["roll_rad"]).right
        given = row["N_f_N"], row["area_f_mm2"] * 1e-6, row["pmax_f_MPa"] * 1e6
        errors.append(100.0 * (np.array([side.normal_force, side.area, side.max_pressure]) / given - 1.0))
    names = [f"{row['lateral_shift_mm']:g} mm, {row['yaw_deg']:g}°, {row['vertical_load_kN']:g} kN"
             for row in rows]
    return {"mean": np.mean(np.abs(errors), axis=0), "worst": np.max(np.abs(errors), axis=0),
            **dict(zip(names, errors))}


def pose_table(parts):
    rows = parts["conformal"]["rows"]
    return grid(["right wheel at", "theory", "penetration, µm", "area, mm²", "peak pressure, MPa"],
                [[name, theory, *(figure(value) for value in values)]
                 for name, theories in rows.items() if name not in MODELS
                 for theory, values in theories.items()])


def contact_table(parts):
    rows = parts["conformal"]["rows"]
    names = rows[next(iter(MODELS))]
    return grid(["force / area / peak pressure, %", *MODELS.values()],
                [[name, *(" / ".join(f"{value:.2f}" if name in ("mean", "worst") else f"{value:+.2f}"
                                     for value in rows[model][name]) for model in MODELS)] for name in names])
