"""Errors of the models of creep forces against the complete theory of steady rolling, patch by patch
(docs/rolling.md), and quoted errors of CONTACT's fast methods.

    python -m benchmarks tangential_errors

An error is the length of the difference of the force vectors over mu N, or that of the moments over
mu N sqrt(ab).
"""

import json

import numpy as np

from tests.helpers.creep_cases import CREEP, Model, cases, read, summary

from . import held_out

#: Name of the row: the model, and whether spin is as published.
MODELS = {
    "polach": ("polach", False),
    "fastsim, published_spin=1": ("fastsim", True),
    "fastsim": ("fastsim", False),
    "fastrip, published_spin=1": ("fastrip", True),
    "fastrip": ("fastrip", False),
    "strips": ("strips", False),
}
WITHOUT_MOMENT = ("polach",)
#: Name of the set in the tables: its cases.
SETS = {
    "CONTACT's ellipses": lambda: cases("hertz"),
    "ellipses, a/b 0.2 … 4": lambda: cases("ellipses"),
    "longer and shorter ellipses": lambda: cases("long_and_short"),
    "patches of a wheelset": lambda: cases("patches"),
    "CONTACT's patches": lambda: cases("contact_patches"),
    "held out: ellipses": held_out.ellipses,
    "held out: patches": held_out.real_patches,
}
HERTZ, GRIDS, NEW_ELLIPSES, NEW_PATCHES = (list(SETS)[k] for k in (0, 4, 5, 6))
EQUIVALENT = "complete theory on the equivalent ellipse"
#: CONTACT's own fast methods, as in the files.
QUOTED = {"CONTACT's FASTSIM": "fastsim", "CONTACT's FaStrip": "fastrip",
          "CONTACT's Kik-Piotrowski with FASTSIM": "kpec_fastsim",
          "CONTACT's ANALYN with FASTSIM": "analyn_fastsim"}


def errors():
    """Rows by model: in each set [mean, 95 %, worst] of the errors of force and of moment [%]; the number of
    cases of each set."""
    sets = {name: tuple(chosen()) for name, chosen in SETS.items()}
    rows = {"cases": {name: len(chosen) for name, chosen in sets.items()}}
    for name, (model, published) in MODELS.items():
        solver = Model(model, published)
        rows[name] = {label: compared([solver.forces(case) for case in chosen], chosen)
                      for label, chosen in sets.items()}
    rows[EQUIVALENT] = {NEW_PATCHES: compared(held_out.equivalent_ellipses(), sets[NEW_PATCHES])}
    return rows | quoted()


def compared(found, chosen):
    """Summaries of the errors [%] of forces and moments (n, 3); cases without a known moment do not count."""
    truth = np.array([[*case.force, case.moment] for case in chosen])
    bound, size = np.array([(case.bound, case.size) for case in chosen]).T
    apart = np.array(found) - truth
    force = 100.0 * np.hypot(apart[:, 0], apart[:, 1]) / bound
    moment = 100.0 * np.abs(apart[:, 2]) / (bound * size)
    return {"force": summary(force), "moment": summary(moment[np.isfinite(moment)])}


def quoted():
    """Rows of CONTACT's own fast methods, on its own cases; ANALYN's and Kik-Piotrowski's are those of
    their own approximate patches."""
    ellipses = [{name: (row[name]["fx"], row[name]["fy"]) for name in ("contact", *QUOTED.values())
                 if name in row} for row in read("hertz")["cases"]]
    file = json.loads((CREEP / "contact_fast_methods.json").read_text(encoding="utf-8"))
    patches = [row for patch in file["patches"] for row in patch["cases"]]
    found = {}
    for label, name in QUOTED.items():
        here = {each: rows for each, rows in ((HERTZ, ellipses), (GRIDS, patches)) if name in rows[0]}
        found[label] = {each: {"force": summary([100.0 * np.hypot(*np.subtract(row[name], row["contact"]))
                                                 for row in rows])} for each, rows in here.items()}
    return found
