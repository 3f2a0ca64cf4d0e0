"""Pages with generated tables: each stands between two comments,

    <!-- python -m benchmarks --write: NAME -->
    <!-- end: NAME -->

and is written anew from benchmarks/measured; what is between them by hand is lost.  Below a table of
docs/evidence/benchmarks.md stands of which commit its numbers are and how they were measured.

Beside the tables stand pictures of time against error: of the models, with quoted programs as bars from
shortest to longest time; and of the models of creep forces, on the cases that are held out, with quoted
methods, whose times are not known, as marks at the right edge.
"""

import re
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from wrcontact.plots import style
from wrcontact.plots.style import INK, QUIET

from . import record, studies, tables, validation
from .creep import EQUIVALENT, GRIDS, HERTZ, MODELS, NEW_ELLIPSES, NEW_PATCHES, QUOTED, TIMED
from .record import UNIT
from .rows import DEFAULT_ROW, FMU_ROW, FULL, HALFSPACE_FORM, NATIVE_ROW, STRIP_ROW, SWEEPS, all_rows
from .sweeps import error_table, rate_table, value_table
from .tables import PEERS

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
        said.append(
            f"Times are those of commit {code(part['commit'])} on {part['machine']}: {part['time']}, "
            f"the smallest of several rounds, in turn with other rows. The unit is the time of "
            f"{UNIT} between them, {part['noise']}."
        )
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
    native = tables.figure(times[NATIVE_ROW.format(2)]["µs"])
    name, _, time, *errors = tables.peer_cells(tables.COMPLETE_THEORY)[:5]
    return tables.grid(
        ["one wheelset", "µs", "units", "mean error [%]", "worst [%]"],
        [
            row("Hertz", "Hertz"),
            row(DEFAULT_ROW, "ANALYN, the default"),
            row(STRIP_ROW, "strips, `analyn_strip`"),
            row(FMU_ROW, "ANALYN, step of the Python FMU", f" (native FMU: {native})"),
            tables.readme_row(parts),
            row(HALFSPACE_FORM.format(0.01), "half-space, Python only"),
            [name, time, "", *errors],
        ],
    )


README, BENCHMARKS = "README.md", "docs/evidence/benchmarks.md"
CURVATURE, ELASTIC = "docs/theory/curvature.md", "docs/theory/elastic.md"
CHECK, FMU, STUDY = "docs/guides/check.md", "docs/guides/fmu.md", "docs/evidence/source_study.md"
REAL_TIME = "docs/guides/real_time.md"
CONFORMAL, TABLES_PAGE = "docs/theory/conformal.md", "docs/guides/tables.md"
MODEL_PARTS = ("model_errors", "halfspace", "model_times")
ERRORS = f"Errors in {tables.TRIPLE}."
MACHINE = f"The unit is the time of {UNIT}; `benchmarks/measured` has commit, machine and noise."

TABLES = {
    "short": Table(
        README,
        (*MODEL_PARTS, *tables.CREEP_PARTS),
        short_table,
        "Errors of penetration / area / peak pressure at 20 positions from tread to flange at "
        "78.5 kN; of creep forces |ΔF|/(μN) and\nmoments |ΔM|/(μN √(ab)) on random patches of "
        "wheelsets, 2a long and 2b wide. A unit is the time of `np.sqrt` of 2000 doubles.",
    ),
    "models": Table(BENCHMARKS, MODEL_PARTS, tables.models, ERRORS),
    "skips": Table(BENCHMARKS, ("skip_errors", "skip_times"), tables.skip_table, ERRORS),
    "counts": Table(BENCHMARKS, ("counts",), tables.count_table),
    "worst": Table(BENCHMARKS, ("worst_steps",), tables.worst_table),
    "instructions": Table(BENCHMARKS, ("instructions",), tables.instruction_table),
    "train": Table(REAL_TIME, ("train",), tables.train_table),
    "trajectory": Table(BENCHMARKS, ("trajectory",), tables.trajectory_table),
    "growth": Table(BENCHMARKS, ("growth",), tables.growth_table),
    "threads": Table(BENCHMARKS, ("threads",), tables.thread_table),
    "sweep": Table(TABLES_PAGE, ("sweep",), rate_table),
    "values": Table(TABLES_PAGE, ("value_times",), value_table),
    "table_errors": Table(TABLES_PAGE, ("table_errors",), error_table),
    "tolerances": Table(BENCHMARKS, ("tolerances",), tables.tolerance_table, ERRORS),
    "random": Table(BENCHMARKS, ("random_poses",), tables.random_table),
    "zones": Table(BENCHMARKS, ("zones",), tables.zone_table, ERRORS),
    "creep_errors": Table(BENCHMARKS, ("tangential_errors",), tables.creep_force_table),
    "creep_moments": Table(BENCHMARKS, ("tangential_errors",), tables.creep_moment_table),
    "creep_times": Table(BENCHMARKS, ("tangential_times",), tables.creep_time_table),
    "creep_short": Table(
        "docs/theory/creep.md", tables.CREEP_PARTS, tables.creep_short_table, tables.CREEP_NOTE
    ),
    "creep_models": Table("docs/choose.md", tables.CREEP_PARTS, tables.creep_model_table, tables.CREEP_NOTE),
    "validation": Table("docs/evidence/validation.md", validation.PARTS, validation.validation_table),
    "worn": Table(
        "docs/evidence/validation.md",
        ("worn_pairs",),
        validation.worn_table,
        "Errors of penetration / area / peak pressure: means; 95 of 100; worst.",
    ),
    "worn_estimate": Table("docs/theory/analyn.md", ("worn_pairs",), validation.worn_estimate_table),
    "worn_creep": Table(
        "docs/evidence/validation.md",
        ("worn_pairs",),
        validation.worn_creep_table,
        "|ΔF| over friction times load: mean / 95 of 100 / worst. The last column is over `analyn_strip`.",
    ),
    "choices": Table(CURVATURE, ("choices",), tables.choice_table, f"Changes in {tables.TRIPLE}."),
    "manchester": Table(ELASTIC, ("manchester",), tables.manchester_table),
    "elastic": Table(ELASTIC, ("elastic_times",), tables.elastic_table),
    "trials": Table(ELASTIC, ("elastic_trials",), tables.trial_table),
    "poses": Table(CONFORMAL, ("conformal",), tables.turning_table),
    "contact": Table(CONFORMAL, ("conformal",), tables.conformal_table),
    "roll": Table(ELASTIC, ("elastic_roll",), tables.roll_table),
    "derivatives": Table("docs/theory/derivatives.md", ("derivative_times",), tables.derivative_table),
    "conicity": Table(
        CHECK,
        ("conicity", "conicity_noise"),
        tables.conicity_table,
        f"Noise: {1e3 * studies.NOISE:g} µm in y and z of points every {studies.SPACING} mm.",
    ),
    "en15302": Table(CHECK, ("en15302",), tables.benchmark_table),
    "stations": Table("docs/guides/fmu_hosts.md", ("stations", "station_times"), tables.station_table),
    "noise": Table("docs/guides/profiles.md", ("profile_noise",), tables.noise_table),
    "searches": Table(STUDY, ("source_searches",), tables.source_tables),
    "figures": Table(STUDY, ("source_figures",), tables.figure_table),
}

# ---------------------------------------------------------------------------------------------------- writing


def pages():
    """Texts of all pages with tables, by name, as they should be."""
    parts = {
        name: record.load(name)
        for name in sorted({name for table in TABLES.values() for name in table.parts})
    }
    return {
        page: filled((record.ROOT / page).read_text(encoding="utf-8"), parts)
        for page in sorted({table.page for table in TABLES.values()})
    }


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
    return PATTERN.findall((record.ROOT / page).read_text(encoding="utf-8"))


def write():
    """Write all pages; return the names of those that changed."""
    changed = []
    for page, text in pages().items():
        path = record.ROOT / page
        if path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
            changed.append(page)
    return changed


# ----------------------------------------------------------------------------------------- pictures of models


PATH = "docs/img/benchmark.png"

LADDERS = {  # kind of row: label, marker, colour (Okabe and Ito)
    "Hertz": ("Hertz", "s", "#E69F00"),
    "analyn": ("ANALYN, by tolerance", "o", "#0072B2"),
    "FMU": ("FMU step with ANALYN", "p", "#D55E00"),
    "analyn_strip": ("ANALYN with strips, by tolerance", "D", "#009E73"),
    "halfspace": ("half-space in Python, by tolerance", "^", "#CC79A7"),
}
STRIP_COLOUR, PEER_COLOUR = "#56B4E9", "#6E6E6E"
LOWEST, HIGHEST = 0.05, 30.0  # [%] of the picture
FASTEST, SLOWEST = 1.0, 3e6  # [us]


class Point(NamedTuple):
    """A row of the table of models: its kind and label, time [us] and in units, and error [%], the mean of
    penetration, area and peak pressure."""

    kind: str
    setting: str
    microseconds: float
    units: float
    error: float


def stored_points():
    """The points of what is kept in benchmarks/measured."""
    times, errors, halfspace = (
        record.load(part)["rows"] for part in ("model_times", "model_errors", "halfspace")
    )
    known = {**errors, **halfspace}
    labels = {row.name: (row.kind, row.setting) for row in all_rows(FULL)}
    labels[FMU_ROW] = "FMU", ""
    return [
        point(*label, times[name], known.get(name) or known[DEFAULT_ROW])
        for name, label in labels.items()
        if label[0] != "geometry"
    ]


def point(kind, setting, time, errors):
    """The :class:`Point` of a row's kept time and errors."""
    return Point(kind, setting, time["µs"], time["units"], float(np.mean(errors["positions mean"])))


@style.styled
def figure(rows):
    """The picture (a matplotlib Figure) of ``rows``, each a :class:`Point`."""
    picture = style.new_figure(8.6, 5.4)
    axes = picture.subplots()
    open_axes(axes, (FASTEST, SLOWEST), (LOWEST, HIGHEST), "one wheelset, both patches [µs]", ",.0f")
    axes.set_ylabel(
        "error on 20 positions from tread to flange [%]\nmean of penetration, area and peak pressure"
    )
    draw_units(axes, rows[0].microseconds / rows[0].units)
    draw_strips(axes, [row for row in rows if row.kind == "strips"])
    for kind in LADDERS:
        draw_ladder(
            axes,
            kind,
            [row for row in rows if row.kind == kind and (row.setting or kind in ("Hertz", "FMU"))],
        )
    draw_peers(axes)
    axes.legend(loc="center", bbox_to_anchor=(0.72, 0.47), title="measured in this run", alignment="left")
    return picture


def open_axes(axes, times, errors, words, form="g"):
    """Logarithmic axes over these ranges of times [us], whose numbers have this ``form``, and errors [%]."""
    axes.set(xscale="log", yscale="log", xlim=times, ylim=errors, xlabel=words)
    axes.grid(which="major", color="#E4E4E4", linewidth=0.7)
    axes.set_axisbelow(True)
    axes.xaxis.set_major_formatter(lambda value, _: format(value, form))
    axes.yaxis.set_major_formatter(lambda value, _: format(value, "g"))


def draw_units(axes, one):
    """A second axis on top, in units of ``one`` [us]."""
    top = axes.secondary_xaxis("top", functions=(lambda us: us / one, lambda units: units * one))
    top.set_xlabel("in units: np.sqrt of 2000 doubles, same machine")
    top.xaxis.set_major_formatter(lambda value, _: f"{value:,g}" if value < 1 else f"{value:,.0f}")
    top.spines["top"].set_visible(True)


def draw_strips(axes, rows):
    """A line for each number of sweeps, with one point per number of strips."""
    for sweeps in SWEEPS:
        chosen = [row for row in rows if row.setting == f"× {sweeps}"]
        axes.plot(
            *places(chosen),
            ".-",
            color=STRIP_COLOUR,
            linewidth=0.8,
            label="6 … 16 strips a run × sweeps" if sweeps == SWEEPS[0] else None,
        )
        annotate(axes, chosen[-1], STRIP_COLOUR, (6, -3), "left")


def draw_ladder(axes, kind, rows):
    """The rows of one kind as a line; the first and the last tolerance are printed beside it."""
    label, marker, colour = LADDERS[kind]
    axes.plot(
        *places(rows),
        marker=marker,
        linewidth=1,
        color=colour,
        label=label,
        linestyle="-" if len(rows) > 1 else "none",
    )
    if len(rows) > 1:
        annotate(axes, rows[0], colour, (-6, -9) if kind == "analyn_strip" else (-5, 5), "right")
        annotate(axes, rows[-1], colour, (6, -9), "left")


def places(rows):
    """Time [us] and error [%] of rows."""
    return np.array([(row.microseconds, row.error) for row in rows]).T


def annotate(axes, row, colour, offset, side):
    axes.annotate(
        row.setting,
        places([row]).ravel(),
        offset,
        textcoords="offset points",
        fontsize=7.5,
        color=colour,
        ha=side,
    )


def draw_peers(axes):
    """Quoted programs as bars; one without error lies on the lower edge, one without time is a mark at the
    right edge."""
    for peer in PEERS:
        error = max(100 * float(np.mean(peer.mean)), LOWEST * 1.07)
        if peer.milliseconds is None:
            axes.plot(SLOWEST, error, "<", color=PEER_COLOUR, clip_on=False)
            axes.annotate(
                f"{peer.name}\n(time not reported)",
                (SLOWEST, error),
                (-10, 0),
                textcoords="offset points",
                fontsize=8,
                color=INK,
                ha="right",
                va="center",
            )
            continue
        axes.plot(peer.microseconds, (error, error), color=PEER_COLOUR, linewidth=5, solid_capstyle="butt")
        note = ", error 0 by definition" if not peer.mean.any() else ""
        axes.annotate(
            f"{peer.name}{note}",
            (peer.microseconds[0], error),
            (0, 6),
            textcoords="offset points",
            fontsize=8,
            color=INK,
        )
    axes.text(
        0.01,
        0.02,
        "grey: CONTACT v25.2, quoted, on another machine",
        transform=axes.transAxes,
        fontsize=8,
        color=QUIET,
    )


# ----------------------------------------------------------------------------------------------- creep forces


CREEP_PATH = "docs/img/creep_forces.png"
#: Marker and colour (Okabe and Ito) of each model.
LOOKS = dict(zip(TIMED, (("s", "#E69F00"), ("o", "#0072B2"), ("^", "#CC79A7"), ("D", "#009E73"))))
#: Each panel: the set of ours, that of the quoted methods, and its title.
PANELS = ((NEW_ELLIPSES, HERTZ, "Ellipses"), (NEW_PATCHES, GRIDS, "Patches of a wheelset"))
CREEP_LOWEST, CREEP_HIGHEST = 0.1, 100.0  # [%] of the picture
CREEP_FASTEST, CREEP_SLOWEST = 1.0, 200.0  # [us]


def stored_creep():
    """Errors and times that are kept in benchmarks/measured."""
    return tuple(record.load(part)["rows"] for part in ("tangential_errors", "tangential_times"))


@style.styled
def creep_figure(errors, times):
    """The picture (a matplotlib Figure) of both parts' rows."""
    picture = style.new_figure(9.4, 4.6)
    panels = picture.subplots(1, 2, sharey=True)
    one = times["strips"]["µs"] / times["strips"]["units"]
    for axes, (ours, theirs, title) in zip(panels, PANELS):
        open_axes(
            axes,
            (CREEP_FASTEST, CREEP_SLOWEST),
            (CREEP_LOWEST, CREEP_HIGHEST),
            "creep forces of one patch [µs]",
        )
        axes.set_title(title, pad=8)
        draw_units(axes, one)
        draw_models(axes, errors, times, ours)
        draw_quoted(axes, errors, theirs)
    panels[0].set_ylabel("error of the force on new cases [% of μN]\nmean, and bar to 95 of 100 cases")
    draw_limit(panels[1], errors)
    panels[0].legend(loc="lower left", title="measured in this run", alignment="left")
    picture.supxlabel(
        "hollow: spin as published; grey: CONTACT v25.2, quoted, on its own cases, time not reported",
        fontsize=8,
        color=QUIET,
    )
    return picture


def draw_models(axes, errors, times, chosen):
    """A point for each model, hollow where spin is as published, with a bar up to 95 of 100 cases."""
    for name, (model, published) in MODELS.items():
        marker, colour = LOOKS[model]
        mean, most, _ = errors[name][chosen]["force"]
        time = times[model]["µs"] * (1.06 if published else 1.0)  # beside each other
        axes.plot([time, time], [mean, most], color=colour, linewidth=0.8)
        axes.plot(
            time,
            mean,
            marker,
            color=colour,
            linestyle="none",
            label=None if published else model,
            markerfacecolor="white" if published else colour,
            zorder=3,
        )


def draw_quoted(axes, errors, chosen):
    """Marks at the right edge; labels keep apart from each other."""
    found = sorted((errors[name][chosen]["force"][0], name) for name in QUOTED if chosen in errors[name])
    lowest = 0.0
    for error, name in found:
        axes.plot(CREEP_SLOWEST, error, "<", color=PEER_COLOUR, clip_on=False)
        lowest = max(1.19 * lowest, error)
        axes.annotate(
            name,
            (CREEP_SLOWEST, lowest),
            (-8, 0),
            textcoords="offset points",
            fontsize=7.5,
            color=INK,
            ha="right",
            va="center",
        )


def draw_limit(axes, errors):
    """What no model that knows an ellipse only can do better."""
    error = errors[EQUIVALENT][NEW_PATCHES]["force"][0]
    axes.axhline(error, color=QUIET, linewidth=0.9, linestyle="--")
    axes.annotate(
        EQUIVALENT, (CREEP_FASTEST, error), (4, 3), textcoords="offset points", fontsize=7.5, color=QUIET
    )


def marks(axes):
    """Places (n, 2) of the models' and the quoted methods' marks, for tests."""
    return np.concatenate([line.get_xydata() for line in axes.lines if line.get_marker() != "None"])
