"""The generated tables of README and docs: each is written from the parts that it names, and says of which
commit they are and how they were measured."""

from collections.abc import Callable
from typing import NamedTuple

from . import conformal, conicity, rows, tangential_tables
from .counts import COUNTS, FULL_RASTER
from .elastic_study import MODES, NEAR
from .machine import UNIT
from .peers import PEERS, SOURCE
from .random_poses import PERCENTILES, TOLERANCE, percentile_name
from .table import figure, grid, percent, three

MODELS = ["one wheelset, both patches", "units", "µs", "positions: mean", "worst", "hunting run: mean",
          "worst"]
TRIPLE = "% of penetration / area / peak pressure"


class Table(NamedTuple):
    """``text(parts)`` returns the table in Markdown; ``parts`` has what was measured, by name."""

    page: str
    parts: tuple
    text: Callable
    note: str = ""


def written(table, parts):
    """A table and what was measured where."""
    chosen = {name: parts[name] for name in table.parts}
    return "\n".join([table.text(chosen), "", *filter(None, [table.note, provenance(chosen)])])


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


# --------------------------------------------------------------------------------------------- model by model


def models(parts):
    """All rows, and the quoted results of other programs."""
    return grid(MODELS, [*map(model_cells(parts), model_rows(parts)), *map(peer_cells, PEERS)])


def short_models(parts):
    """The rows of the README."""
    chosen = {row.name for row in rows.all_rows(rows.FULL) if row.short} | {rows.FMU_ROW}
    return grid(MODELS, [*map(model_cells(parts), filter(chosen.__contains__, model_rows(parts))),
                         *map(peer_cells, PEERS)])


def model_rows(parts):
    """Names of the timed rows whose errors are known, or who have those of the default."""
    return parts["model_times"]["rows"]


def model_cells(parts):
    known = {**parts["model_errors"]["rows"], **parts["halfspace"]["rows"]}

    def cells(name):
        time, found = model_rows(parts)[name], known.get(name) or known[rows.DEFAULT_ROW]
        first = [name, figure(time["units"]), figure(time["µs"])]
        if "roll" in found:
            return [*first, "", "", "", f"roll {found['roll']:.0e} rad, position {found['position']:.0e} mm"]
        return [*first, *(three(found[f"{run} {what}"]) for run in ("positions", "hunting")
                          for what in ("mean", "worst"))]

    return cells


def peer_cells(peer):
    time = " … ".join(figure(time) for time in peer.microseconds) if peer.milliseconds else "not reported"
    errors = ("0 by definition", "") if not peer.mean.any() else (percent(peer.mean), percent(peer.worst))
    return [f"{peer.name} ({SOURCE})", "", time, *errors, "", ""]


def skip_table(parts):
    answers = parts["skip_errors"]["rows"]

    def answer(name, words):
        return words.format(**{key: three(values) for key, values in answers.get(name, {}).items()})

    return grid(["skipped", "units", "full cost", "share", "answer"],
                [[name, figure(row["units"]), figure(row["full"]),
                  f"{100 * row['units'] / row['full']:.0f} %", answer(name, row["answer"])]
                 for name, row in parts["skip_times"]["rows"].items()])


def count_table(parts):
    columns = [FULL_RASTER, *COUNTS]
    return grid(["per wheelset", *columns], [[name, *(figure(row[column]) for column in columns)]
                                             for name, row in parts["counts"]["rows"].items()])


def growth_table(parts):
    return grid(["wheelsets", "units each", "µs each"], [[name, figure(row["units"]), figure(row["µs"])]
                                                         for name, row in parts["growth"]["rows"].items()])


def thread_table(parts):
    return grid(["threads", "µs a wheelset", "speed-up"], [[name, figure(row["µs"]), f"{row['gain']:.2f}"]
                                                           for name, row in parts["threads"]["rows"].items()])


# ----------------------------------------------------------------------------------------------- random


def tolerance_table(parts):
    columns = list(map(percentile_name, PERCENTILES))
    return grid(["numerics", *columns, "where"],
                [[name, *(three(row[column]) for column in columns), row["where"]]
                 for name, row in parts["tolerances"]["rows"].items()])


def random_table(parts):
    """Errors by percentile, and the worst wheels."""
    found = parts["random_poses"]["rows"]
    columns = ["mean", *map(percentile_name, PERCENTILES)]
    models = [name for name in found if name != "poses"]
    lines = [grid(["model", *columns, "not solved"],
                  [[name, *(three(found[name][column]) for column in columns), found[name]["refused"]]
                   for name in models]), ""]
    lines.append(f"{found['poses']['count']} poses, twice as many wheels, in {TRIPLE}; "
                 f"{found['poses']['lost']} poses are left out, since the half-space does not converge to "
                 f"{TOLERANCE:g}. The worst wheels:\n")
    for name in models:
        lines += [f"* {name}: {three(each['errors'])} %, {each['wheel']}" for each in found[name]["wheels"]]
    return "\n".join(lines)


def zone_table(parts):
    """Errors where the wheel touches, by model."""
    found = {zone: row for zone, row in parts["zones"]["rows"].items() if row["wheels"]}
    first = next(iter(found.values()))
    columns = [(model, kind) for model in first if model != "wheels" for kind in first[model]]
    return grid(["where", "wheels", *(f"{model}: {kind}" for model, kind in columns)],
                [[zone, row["wheels"], *(three(row[model][kind]) for model, kind in columns)]
                 for zone, row in found.items()])


# --------------------------------------------------------------------------------------------- other pages


def choice_table(parts):
    found = parts["choices"]["rows"]
    shifts = list(next(iter(found.values())))
    return grid(["ANALYN with", *shifts], [[name, *(signed(row[shift]) for shift in shifts)]
                                           for name, row in found.items()])


def signed(values):
    """Changes with their signs."""
    return " / ".join(f"{value:+.1f}".replace("-", "−") for value in values)


def station_table(parts):
    times = parts["station_times"]["rows"]
    return grid(["stations", "area: error [%]", "load: error [%]", "units a step"],
                [[name, f"{row['area']:.2f}", f"{row['load']:.2f}", figure(times[name]["units"])]
                 for name, row in parts["stations"]["rows"].items()])


def conicity_table(parts):
    found = {**parts["conicity"]["rows"], **parts["conicity_noise"]["rows"]}
    return grid(["S1002, gauge 1435 mm, r₀ 460 mm", *(f"{millimetres} mm" for millimetres in range(1, 9))],
                [[name, *(f"{value:.3f}" for value in row["conicity"])] for name, row in found.items()])


def benchmark_table(parts):
    header = ["case", "wheels", "amplitudes", "inside the limits of the value", "inside either limits",
              "conicity: mean deviation", "largest", "rolling radius difference: mean distance [mm]",
              "largest"]
    return grid(header, [[name, row["wheel"], row["amplitudes"], row["value"], row["either"],
                          *(f"{row[column]:.4f}" for column in ("mean", "worst")),
                          *(f"{row[column]:.3f}" for column in ("curve mean", "curve worst"))]
                         for name, row in parts["en15302"]["rows"].items()])


def manchester_table(parts):
    return grid(["`contact_mode`", f"up to {NEAR} mm of shift [µrad]", "beyond [µrad]"],
                [[name, figure(row["near"]), figure(row["beyond"])]
                 for name, row in parts["manchester"]["rows"].items()])


def elastic_table(parts):
    return grid(["units a step", *MODES], [[name, *(figure(row[mode]["units"]) for mode in MODES)]
                                           for name, row in parts["elastic_times"]["rows"].items()])


def trial_table(parts):
    return grid(["trials of a pose", "mean", "99 of 100", "most"],
                [[name, *(figure(row[column]) for column in ("mean", "99 %", "most"))]
                 for name, row in parts["elastic_trials"]["rows"].items()])


def trajectory_table(parts):
    return grid(["1 ms steps", "units", "asked", "µs", *COUNTS],
                [[name, *(figure(row[column]) for column in ("units", "asked", "µs", *COUNTS))]
                 for name, row in parts["trajectory"]["rows"].items()])


def roll_table(parts):
    return grid(["yaw", "largest change of the roll in 1 µm [µrad]", "at, either side [mm]"],
                [[name, figure(row["step"]), f"{row['at']:.4f}"]
                 for name, row in parts["elastic_roll"]["rows"].items()])


def derivative_table(parts):
    return grid(["step and one derivative", "units", "µs"],
                [[name, figure(row["units"]), figure(row["µs"])]
                 for name, row in parts["derivative_times"]["rows"].items()])


def curvature_table(parts):
    found = dict(parts["curvature"]["rows"])
    cases = found.pop("cases")
    text = grid(["lateral curvature", "positions: mean", "worst", "random: mean", "worst",
                 "noisy, as read: mean", "95 %", "against no noise: mean"],
                [[name, *(three(values) for kind in ("positions", "random", "noisy") for values in row[kind]),
                  three(row["clean"])] for name, row in found.items()])
    counts = "{} positions, {} random and {} noisy cases".format(*cases["count"])
    return (f"{text}\n\n{counts}. The noise itself moves the half-space's answer by "
            f"{three(cases['moved'])} % in the mean.")


def noise_table(parts):
    found = parts["profile_noise"]["rows"]
    read = [name for name in found if "not smoothed" not in name]
    text = grid(["noise [µm]", "in", "spacing [mm]", "position [mm]: median", "90 %", "area [%]: median",
                 "90 %", "pressure [%]: median", "90 %", "not valid"],
                [[*noise_cells(name), *(f"{value:.2f}" for value in found[name]["position"]),
                  *(figure(value) for column in ("area", "pressure") for value in found[name][column]),
                  found[name]["not valid"]] for name in read])
    raw = "; ".join(f"{name.split(',')[0]} µm: {found[name]['pressure']:.0f} %" for name in found
                    if name not in read)
    return (f"{text}\n\nNot smoothed (`smoothing=0`), noise in z every 0.2 mm, median error of the pressure: "
            f"{raw}.")


def noise_cells(name):
    """Noise, where it is, and spacing, of the name of a row "10, y, z, 0.2"."""
    noise, *where, spacing = name.split(", ")
    return noise, ", ".join(where), spacing


def source_tables(parts):
    """Four tables of the searches, one after the other."""
    return "\n\n".join(grid(table["header"], table["rows"], len(table["header"]))
                       for table in parts["source_searches"]["rows"].values())


def figure_table(parts):
    return grid(["figure", "the source says", "", "we find", "the number"],
                [[number, row["claim"], row["verdict"], row["finding"], row["key"]]
                 for number, row in parts["source_figures"]["rows"].items()], words=5)


README, BENCHMARKS, METHOD = "README.md", "docs/benchmarks.md", "docs/method.md"
CHECK, FMU, STUDY = "docs/check.md", "docs/fmu.md", "docs/source_study.md"
CONFORMAL = "docs/conformal.md"
MODEL_PARTS = ("model_errors", "halfspace", "model_times")
ERRORS = f"Errors in {TRIPLE}."

TABLES = {
    "short": Table(README, MODEL_PARTS, short_models, ERRORS),
    "models": Table(BENCHMARKS, MODEL_PARTS, models, ERRORS),
    "skips": Table(BENCHMARKS, ("skip_errors", "skip_times"), skip_table, ERRORS),
    "counts": Table(BENCHMARKS, ("counts",), count_table),
    "trajectory": Table(BENCHMARKS, ("trajectory",), trajectory_table),
    "growth": Table(BENCHMARKS, ("growth",), growth_table),
    "threads": Table(BENCHMARKS, ("threads",), thread_table),
    "tolerances": Table(BENCHMARKS, ("tolerances",), tolerance_table, ERRORS),
    "random": Table(BENCHMARKS, ("random_poses",), random_table),
    "zones": Table(BENCHMARKS, ("zones",), zone_table, ERRORS),
    "creep_errors": Table(BENCHMARKS, ("tangential_errors",), tangential_tables.force_table),
    "creep_moments": Table(BENCHMARKS, ("tangential_errors",), tangential_tables.moment_table),
    "creep_times": Table(BENCHMARKS, ("tangential_times",), tangential_tables.time_table),
    "creep_short": Table("docs/rolling.md", ("tangential_errors", "tangential_times"),
                         tangential_tables.short_table, tangential_tables.NOTE),
    "creep_models": Table(README, ("tangential_errors", "tangential_times"), tangential_tables.model_table,
                          tangential_tables.NOTE),
    "curvature": Table(METHOD, ("curvature",), curvature_table, ERRORS),
    "choices": Table(METHOD, ("choices",), choice_table, f"Changes in {TRIPLE}."),
    "manchester": Table(METHOD, ("manchester",), manchester_table),
    "elastic": Table(METHOD, ("elastic_times",), elastic_table),
    "trials": Table(METHOD, ("elastic_trials",), trial_table),
    "poses": Table(CONFORMAL, ("conformal",), conformal.pose_table),
    "contact": Table(CONFORMAL, ("conformal",), conformal.contact_table),
    "roll": Table(METHOD, ("elastic_roll",), roll_table),
    "derivatives": Table(METHOD, ("derivative_times",), derivative_table),
    "conicity": Table(CHECK, ("conicity", "conicity_noise"), conicity_table,
                      f"Noise: {1e3 * conicity.NOISE:g} µm in y and z of points every "
                      f"{conicity.SPACING} mm."),
    "en15302": Table(CHECK, ("en15302",), benchmark_table),
    "stations": Table(FMU, ("stations", "station_times"), station_table),
    "noise": Table("docs/profiles.md", ("profile_noise",), noise_table),
    "searches": Table(STUDY, ("source_searches",), source_tables),
    "figures": Table(STUDY, ("source_figures",), figure_table),
}
