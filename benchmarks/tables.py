"""Tables in Markdown: each function writes one from the parts that were measured.  Those of creep forces are
in creep_times.py."""

from typing import NamedTuple

import numpy as np

from .errors import NEAR, TURNING_MODELS
from .random_poses import PERCENTILES, TOLERANCE, percentile_name
from .rows import DEFAULT_ROW
from .times import CONTACT_MODES
from .work import COUNTS, FULL_RASTER

TRIPLE = "% of penetration / area / peak pressure"
MODELS = ["one wheelset, both patches", "units", "µs", "positions: mean", "worst", "hunting run: mean",
          "worst"]


def markdown(title, header, rows):
    """A table with a title."""
    return f"### {title}\n\n{grid(header, rows)}\n"


def grid(header, rows, words=1):
    """A table; the first columns hold ``words``, the others numbers."""
    return "\n".join([line(header), line(["---"] * words + ["---:"] * (len(header) - words)),
                      *map(line, rows)])


def line(cells):
    """One line of a table."""
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def figure(value):
    """A number with at most one decimal, without powers of ten."""
    return f"{value:,.0f}" if abs(value) >= 99.5 else f"{value:.1f}"


def percent(shares):
    """Shares as "1.2 / 3.4 / 5.6" [%]."""
    return three(100 * share for share in shares)


def three(values):
    """Numbers as "1.2 / 3.4 / 5.6"."""
    return " / ".join(map(figure, values))


# --------------------------------------------------------------------------------------------- quoted results


#: CONTACT v25.2 (Vollebregt), timed on another machine.  Errors of its approximations refer to its own
#: complete theory at ten of the positions, 0 ... 6.5 mm at 78.5 kN.  Its times are for one wheel with
#: prescribed force, search included; a wheelset has two wheels.  No time was reported for Kik-Piotrowski.
SOURCE = "CONTACT v25.2, quoted, other machine"
WHEELS = 2


class Peer(NamedTuple):
    """One program: shortest and longest time of one wheel [ms], or None; errors as shares (3,)."""

    name: str
    milliseconds: tuple | None
    mean: np.ndarray
    worst: np.ndarray

    @property
    def microseconds(self):
        """Shortest and longest time of a wheelset [us], or None."""
        return self.milliseconds and tuple(1e3 * WHEELS * time for time in self.milliseconds)


PEERS = (
    Peer("CONTACT's ANALYN", (6, 32), np.array([0.019, 0.059, 0.078]), np.array([0.049, 0.18, 0.20])),
    Peer("CONTACT's Kik-Piotrowski", None, np.array([0.009, 0.067, 0.104]), np.array([0.038, 0.18, 0.28])),
    Peer("CONTACT's complete theory", (5, 85), np.zeros(3), np.zeros(3)),
)
COMPLETE_THEORY = PEERS[-1]


# --------------------------------------------------------------------------------------------- model by model


def models(parts):
    """All rows, and the quoted results of other programs."""
    return grid(MODELS, [*map(model_cells(parts), model_rows(parts)), *map(peer_cells, PEERS)])


def model_rows(parts):
    """Names of the timed rows whose errors are known, or who have those of the default."""
    return parts["model_times"]["rows"]


def model_cells(parts):
    known = {**parts["model_errors"]["rows"], **parts["halfspace"]["rows"]}

    def cells(name):
        time, found = model_rows(parts)[name], known.get(name) or known[DEFAULT_ROW]
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
    return grid(["units a step", *CONTACT_MODES],
                [[name, *(figure(row[mode]["units"]) for mode in CONTACT_MODES)]
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


# ------------------------------------------------------------------------------------------ patches that turn


def turning_table(parts):
    rows = parts["conformal"]["rows"]
    return grid(["right wheel at", "theory", "penetration, µm", "area, mm²", "peak pressure, MPa"],
                [[name, theory, *(figure(value) for value in values)]
                 for name, theories in rows.items() if name not in TURNING_MODELS
                 for theory, values in theories.items()])


def conformal_table(parts):
    rows = parts["conformal"]["rows"]
    names = rows[next(iter(TURNING_MODELS))]
    return grid(["force / area / peak pressure, %", *TURNING_MODELS.values()],
                [[name, *(" / ".join(f"{value:.2f}" if name in ("mean", "worst") else f"{value:+.2f}"
                                     for value in rows[model][name]) for model in TURNING_MODELS)]
                 for name in names])
