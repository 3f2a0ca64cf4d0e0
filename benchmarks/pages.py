"""Pages with generated tables: each stands between two comments,

    <!-- python -m benchmarks --write: NAME -->
    <!-- end: NAME -->

and is written anew from benchmarks/measured; what is between them by hand is lost.  Below a table of
docs/benchmarks.md stands of which commit its numbers are and how they were measured.
"""

import re
from collections.abc import Callable
from typing import NamedTuple

from . import creep_times, profiles, rows, store, tables
from .machine import UNIT

BEGIN, END = "<!-- python -m benchmarks --write: {} -->", "<!-- end: {} -->"
PATTERN = re.compile(r"<!-- python -m benchmarks --write: (\w+) -->\n.*?<!-- end: \1 -->", re.DOTALL)


class Table(NamedTuple):
    """``text(parts)`` returns the table in Markdown; ``parts`` has what was measured, by name."""

    page: str
    parts: tuple
    text: Callable
    note: str = ""


def written(table, parts):
    """A table, its note, and what was measured where."""
    chosen = {name: parts[name] for name in table.parts}
    sources = {BENCHMARKS: provenance(chosen), README: ""}
    below = sources.get(table.page, MACHINE if any("machine" in part for part in chosen.values()) else "")
    words = "\n".join(filter(None, [table.note, below]))
    return "\n\n".join(filter(None, [table.text(chosen), words]))


def provenance(parts):
    """Sentences on commits, machine and noise of the run."""
    timed = {name: part for name, part in parts.items() if "machine" in part}
    others = sorted({part["commit"] for name, part in parts.items() if name not in timed})
    said = [f"Errors and counts are those of commit {' and '.join(map(code, others))}."] if others else []
    for part in timed.values():
        said.append(f"Times are those of commit {code(part['commit'])} on {part['machine']}: {part['time']}, "
                    f"the smallest of several rounds, in turn with other rows. The unit is the time of "
                    f"{UNIT} between them, {part['noise']}.")
    return " ".join(said)


def code(commit):
    """A commit's name in Markdown."""
    name, *others = commit.split(" ", 1)
    return " ".join([f"`{name}`", *others])


def short_table(parts):
    """What the README shows: seven rows that a user chooses between, time beside error."""
    def row(name, label, note=""):
        _, units, time, mean, worst, *_ = tables.model_cells(parts)(name)
        return [label, f"{time}{note}", units, mean, worst]

    times = tables.model_rows(parts)
    native = tables.figure(times[rows.NATIVE_ROW.format(2)]["µs"])
    name, _, time, *errors = tables.peer_cells(tables.COMPLETE_THEORY)[:5]
    return tables.grid(["one wheelset", "µs", "units", "mean error [%]", "worst [%]"],
                       [row("Hertz", "Hertz"),
                 row(rows.DEFAULT_ROW, "ANALYN, the default"),
                 row(rows.STRIP_ROW, "strips, `analyn_strip`"),
                 row(rows.FMU_ROW, "ANALYN, step of the Python FMU", f" (native FMU: {native})"),
                 creep_times.readme_row(parts),
                 row(rows.HALFSPACE_FORM.format(0.01), "half-space, Python only"),
                 [name, time, "", *errors]])


README, BENCHMARKS, METHOD = "README.md", "docs/benchmarks.md", "docs/method.md"
CHECK, FMU, STUDY = "docs/check.md", "docs/fmu.md", "docs/source_study.md"
CONFORMAL = "docs/conformal.md"
MODEL_PARTS = ("model_errors", "halfspace", "model_times")
ERRORS = f"Errors in {tables.TRIPLE}."
MACHINE = f"The unit is the time of {UNIT}; `benchmarks/measured` has commit, machine and noise."

TABLES = {
    "short": Table(README, (*MODEL_PARTS, *creep_times.PARTS), short_table,
                   "Errors of penetration / area / peak pressure at 20 positions from tread to flange at "
                   "78.5 kN; of creep forces |ΔF|/(μN) on\nrandom patches of wheelsets. A unit is the time "
                   "of `np.sqrt` of 2000 doubles on the same machine."),
    "models": Table(BENCHMARKS, MODEL_PARTS, tables.models, ERRORS),
    "skips": Table(BENCHMARKS, ("skip_errors", "skip_times"), tables.skip_table, ERRORS),
    "counts": Table(BENCHMARKS, ("counts",), tables.count_table),
    "trajectory": Table(BENCHMARKS, ("trajectory",), tables.trajectory_table),
    "growth": Table(BENCHMARKS, ("growth",), tables.growth_table),
    "threads": Table(BENCHMARKS, ("threads",), tables.thread_table),
    "tolerances": Table(BENCHMARKS, ("tolerances",), tables.tolerance_table, ERRORS),
    "random": Table(BENCHMARKS, ("random_poses",), tables.random_table),
    "zones": Table(BENCHMARKS, ("zones",), tables.zone_table, ERRORS),
    "creep_errors": Table(BENCHMARKS, ("tangential_errors",), creep_times.force_table),
    "creep_moments": Table(BENCHMARKS, ("tangential_errors",), creep_times.moment_table),
    "creep_times": Table(BENCHMARKS, ("tangential_times",), creep_times.time_table),
    "creep_short": Table("docs/rolling.md", creep_times.PARTS, creep_times.short_table,
                         creep_times.NOTE),
    "creep_models": Table("docs/models.md", creep_times.PARTS, creep_times.model_table,
                          creep_times.NOTE),
    "curvature": Table(METHOD, ("curvature",), tables.curvature_table, ERRORS),
    "choices": Table(METHOD, ("choices",), tables.choice_table, f"Changes in {tables.TRIPLE}."),
    "manchester": Table(METHOD, ("manchester",), tables.manchester_table),
    "elastic": Table(METHOD, ("elastic_times",), tables.elastic_table),
    "trials": Table(METHOD, ("elastic_trials",), tables.trial_table),
    "poses": Table(CONFORMAL, ("conformal",), tables.turning_table),
    "contact": Table(CONFORMAL, ("conformal",), tables.conformal_table),
    "roll": Table(METHOD, ("elastic_roll",), tables.roll_table),
    "derivatives": Table(METHOD, ("derivative_times",), tables.derivative_table),
    "conicity": Table(CHECK, ("conicity", "conicity_noise"), tables.conicity_table,
                      f"Noise: {1e3 * profiles.NOISE:g} µm in y and z of points every "
                      f"{profiles.SPACING} mm."),
    "en15302": Table(CHECK, ("en15302",), tables.benchmark_table),
    "stations": Table(FMU, ("stations", "station_times"), tables.station_table),
    "noise": Table("docs/profiles.md", ("profile_noise",), tables.noise_table),
    "searches": Table(STUDY, ("source_searches",), tables.source_tables),
    "figures": Table(STUDY, ("source_figures",), tables.figure_table),
}

# ---------------------------------------------------------------------------------------------------- writing


def pages():
    """Texts of all pages with tables, by name, as they should be."""
    parts = {name: store.load(name) for name in sorted({name for table in TABLES.values()
                                                        for name in table.parts})}
    return {page: filled((store.ROOT / page).read_text(encoding="utf-8"), parts)
            for page in sorted({table.page for table in TABLES.values()})}


def filled(text, parts):
    """A page with its tables written from ``parts``.

    Raises
    ------
    KeyError
        if the page has a table that is not in tables.py.
    """
    return PATTERN.sub(lambda found: block(found[1], parts), text)


def block(name, parts):
    return "\n".join([BEGIN.format(name), written(TABLES[name], parts), END.format(name)])


def names(page):
    """Names of the tables that a page has, in their order."""
    return PATTERN.findall((store.ROOT / page).read_text(encoding="utf-8"))


def write():
    """Write all pages; return the names of those that changed."""
    changed = []
    for page, text in pages().items():
        path = store.ROOT / page
        if path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
            changed.append(page)
    return changed
