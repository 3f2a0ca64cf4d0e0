"""Tables in Markdown: each function writes one from the parts that were measured."""

import re
from typing import NamedTuple

import numpy as np

from wrcontact.methods import TangentialModel

from . import worst
from .creep import (
    ALONE,
    ELEMENTS,
    EQUIVALENT,
    FMU,
    NEW_ELLIPSES,
    NEW_PATCHES,
    QUOTED,
    SETS,
    SPEED,
    TIMED,
    WITHOUT,
    WITHOUT_MOMENT,
)
from .creep import MODELS as CREEP_MODELS
from .errors import CHOICE_SHIFTS, NEAR, TURNING_MODELS
from .random_poses import PERCENTILES, TOLERANCE, percentile_name
from .rows import DEFAULT_ROW
from .times import CONTACT_MODES, COUNTS, FULL_RASTER

TRIPLE = "% of penetration / area / peak pressure"
MODELS = [
    "one wheelset, both patches",
    "units",
    "µs",
    "positions: mean",
    "worst",
    "hunting run: mean",
    "worst",
]


def write_part(page, script, name, lines):
    """Put generated ``lines`` into a page, between the marks of the part ``name``, which ``script`` writes."""
    begin, end = f"<!-- python {script}: {name} -->", f"<!-- end: {name} -->"
    text = page.read_text(encoding="utf-8")
    pattern = re.compile(re.escape(begin) + ".*?" + re.escape(end), re.DOTALL)
    if not pattern.search(text):
        raise ValueError(f"{page.name} has no part {name}")
    page.write_text(pattern.sub(lambda _: "\n".join([begin, *lines, end]), text), encoding="utf-8")


def grid(header, rows, words=1):
    """A table; the first columns hold ``words``, the others numbers."""
    return "\n".join(
        [line(header), line(["---"] * words + ["---:"] * (len(header) - words)), *map(line, rows)]
    )


def line(cells):
    """One line of a table."""
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def listed(part, header, columns, words=1):
    """A function that writes a table of one part: the name of each row, and its ``columns``, by name with the
    form of their numbers."""

    def text(parts):
        return grid(
            header,
            [
                [name, *(form(row[column]) for column, form in columns.items())]
                for name, row in parts[part]["rows"].items()
            ],
            words,
        )

    return text


def figure(value):
    """A number with at most one decimal, without powers of ten."""
    return f"{value:,.0f}" if abs(value) >= 99.5 else f"{value:.1f}"


def decimals(count):
    """A form with so many digits after the point."""
    return lambda value: f"{value:.{count}f}"


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
        return [
            *first,
            *(
                three(found[f"{run} {what}"])
                for run in ("positions", "hunting")
                for what in ("mean", "worst")
            ),
        ]

    return cells


def peer_cells(peer):
    time = " … ".join(figure(time) for time in peer.microseconds) if peer.milliseconds else "not reported"
    errors = ("0 by definition", "") if not peer.mean.any() else (percent(peer.mean), percent(peer.worst))
    return [f"{peer.name} ({SOURCE})", "", time, *errors, "", ""]


def skip_table(parts):
    answers = parts["skip_errors"]["rows"]

    def answer(name, words):
        return words.format(**{key: three(values) for key, values in answers.get(name, {}).items()})

    return grid(
        ["skipped", "units", "full cost", "share", "answer"],
        [
            [
                name,
                figure(row["units"]),
                figure(row["full"]),
                f"{100 * row['units'] / row['full']:.0f} %",
                answer(name, row["answer"]),
            ]
            for name, row in parts["skip_times"]["rows"].items()
        ],
    )


count_table = listed(
    "counts", ["per wheelset", FULL_RASTER, *COUNTS], dict.fromkeys((FULL_RASTER, *COUNTS), figure)
)
WORST_COLUMNS = (*worst.SHARES, *(f"hunting: {share}" for share in worst.SHARES), "worst over median")
worst_table = listed(
    "worst_steps", ["evaluations in a step", *WORST_COLUMNS], dict.fromkeys(WORST_COLUMNS, figure)
)
instruction_table = listed(
    "instructions", ["thousand instructions in a step", *WORST_COLUMNS], dict.fromkeys(WORST_COLUMNS, figure)
)
train_table = listed(
    "train",
    ["time step of eight wheelsets [µs]", *worst.SHARES, "worst, share of 1 ms [%]"],
    dict.fromkeys((*worst.SHARES, "of 1 ms"), figure),
)
growth_table = listed("growth", ["wheelsets", "units each", "µs each"], {"units": figure, "µs": figure})
thread_table = listed(
    "threads", ["threads", "µs a wheelset", "speed-up"], {"µs": figure, "gain": decimals(2)}
)
trajectory_table = listed(
    "trajectory",
    ["1 ms steps", "units", "asked", "µs", *COUNTS],
    dict.fromkeys(("units", "asked", "µs", *COUNTS), figure),
)
derivative_table = listed(
    "derivative_times", ["step and one derivative", "units", "µs"], {"units": figure, "µs": figure}
)


# ----------------------------------------------------------------------------------------------- random


PERCENTS = dict.fromkeys(map(percentile_name, PERCENTILES), three)
tolerance_table = listed("tolerances", ["numerics", *PERCENTS, "where"], {**PERCENTS, "where": str})


def random_table(parts):
    """Errors by percentile, and the worst wheels."""
    found = parts["random_poses"]["rows"]
    columns = ["mean", *PERCENTS]
    models = [name for name in found if name != "poses"]
    lines = [
        grid(
            ["model", *columns, "not solved"],
            [
                [name, *(three(found[name][column]) for column in columns), found[name]["refused"]]
                for name in models
            ],
        ),
        "",
    ]
    lines.append(
        f"{found['poses']['count']} poses, twice as many wheels, in {TRIPLE}; "
        f"{found['poses']['lost']} poses are left out, since the half-space does not converge to "
        f"{TOLERANCE:g}. The worst wheels:\n"
    )
    for name in models:
        lines += [f"* {name}: {three(each['errors'])} %, {each['wheel']}" for each in found[name]["wheels"]]
    return "\n".join(lines)


def zone_table(parts):
    """Errors where the wheel touches, by model."""
    found = {zone: row for zone, row in parts["zones"]["rows"].items() if row["wheels"]}
    first = next(iter(found.values()))
    columns = [(model, kind) for model in first if model != "wheels" for kind in first[model]]
    return grid(
        ["where", "wheels", *(f"{model}: {kind}" for model, kind in columns)],
        [
            [zone, row["wheels"], *(three(row[model][kind]) for model, kind in columns)]
            for zone, row in found.items()
        ],
    )


# --------------------------------------------------------------------------------------------- other pages


def signed(values):
    """Changes with their signs."""
    return " / ".join(f"{value:+.1f}".replace("-", "−") for value in values)


choice_table = listed("choices", ["ANALYN with", *CHOICE_SHIFTS], dict.fromkeys(CHOICE_SHIFTS, signed))
benchmark_table = listed(
    "en15302",
    [
        "case",
        "wheels",
        "amplitudes",
        "inside the limits of the value",
        "inside either limits",
        "conicity: mean deviation",
        "largest",
        "rolling radius difference: mean distance [mm]",
        "largest",
    ],
    {
        "wheel": str,
        "amplitudes": str,
        "value": str,
        "either": str,
        "mean": decimals(4),
        "worst": decimals(4),
        "curve mean": decimals(3),
        "curve worst": decimals(3),
    },
)
manchester_table = listed(
    "manchester",
    ["`contact_mode`", f"up to {NEAR} mm of shift [µrad]", "beyond [µrad]"],
    {"near": figure, "beyond": figure},
)
trial_table = listed(
    "elastic_trials",
    ["trials of a pose", "mean", "99 of 100", "most"],
    {"mean": figure, "99 %": figure, "most": figure},
)
roll_table = listed(
    "elastic_roll",
    ["yaw", "largest change of the roll in 1 µm [µrad]", "at, either side [mm]"],
    {"step": figure, "at": decimals(4)},
)
figure_table = listed(
    "source_figures",
    ["figure", "the source says", "", "we find", "the number"],
    dict.fromkeys(("claim", "verdict", "finding", "key"), str),
    words=5,
)


def station_table(parts):
    times = parts["station_times"]["rows"]
    return grid(
        ["stations", "area: error [%]", "load: error [%]", "units a step"],
        [
            [name, f"{row['area']:.2f}", f"{row['load']:.2f}", figure(times[name]["units"])]
            for name, row in parts["stations"]["rows"].items()
        ],
    )


def conicity_table(parts):
    found = {**parts["conicity"]["rows"], **parts["conicity_noise"]["rows"]}
    return grid(
        ["S1002, gauge 1435 mm, r₀ 460 mm", *(f"{millimetres} mm" for millimetres in range(1, 9))],
        [[name, *(f"{value:.3f}" for value in row["conicity"])] for name, row in found.items()],
    )


def elastic_table(parts):
    return grid(
        ["units a step", *CONTACT_MODES],
        [
            [name, *(figure(row[mode]["units"]) for mode in CONTACT_MODES)]
            for name, row in parts["elastic_times"]["rows"].items()
        ],
    )


def noise_table(parts):
    found = parts["profile_noise"]["rows"]
    read = [name for name in found if "not smoothed" not in name]
    text = grid(
        [
            "noise [µm]",
            "in",
            "spacing [mm]",
            "position [mm]: median",
            "90 %",
            "area [%]: median",
            "90 %",
            "pressure [%]: median",
            "90 %",
            "not valid",
        ],
        [
            [
                *noise_cells(name),
                *(f"{value:.2f}" for value in found[name]["position"]),
                *(figure(value) for column in ("area", "pressure") for value in found[name][column]),
                found[name]["not valid"],
            ]
            for name in read
        ],
    )
    raw = "; ".join(
        f"{name.split(',')[0]} µm: {found[name]['pressure']:.0f} %" for name in found if name not in read
    )
    return (
        f"{text}\n\nNot smoothed (`smoothing=0`), noise in z every 0.2 mm, median error of the pressure: "
        f"{raw}."
    )


def noise_cells(name):
    """Noise, where it is, and spacing, of the name of a row "10, y, z, 0.2"."""
    noise, *where, spacing = name.split(", ")
    return noise, ", ".join(where), spacing


def source_tables(parts):
    """Four tables of the searches, one after the other."""
    return "\n\n".join(
        grid(table["header"], table["rows"], len(table["header"]))
        for table in parts["source_searches"]["rows"].values()
    )


# ------------------------------------------------------------------------------------------ patches that turn


def turning_table(parts):
    rows = parts["conformal"]["rows"]
    return grid(
        ["right wheel at", "theory", "penetration, µm", "area, mm²", "peak pressure, MPa"],
        [
            [name, theory, *(figure(value) for value in values)]
            for name, theories in rows.items()
            if name not in TURNING_MODELS
            for theory, values in theories.items()
        ],
    )


def conformal_table(parts):
    rows = parts["conformal"]["rows"]
    names = rows[next(iter(TURNING_MODELS))]
    return grid(
        ["force / area / peak pressure, %", *TURNING_MODELS.values()],
        [
            [
                name,
                *(
                    " / ".join(
                        f"{value:.2f}" if name in ("mean", "worst") else f"{value:+.2f}"
                        for value in rows[model][name]
                    )
                    for model in TURNING_MODELS
                ),
            ]
            for name in names
        ],
    )


# ----------------------------------------------------------------------------------------------- creep forces


CREEP_NOTE = (
    "Errors: mean / 95 of 100 / worst of |ΔF|/(μN) or |ΔM|/(μN √(ab)) [%] on patches and ellipses "
    "on which no constant of a model was chosen. Units: of one patch."
)
CREEP_PARTS = ("tangential_errors", "tangential_times")
#: What to use a model for, where not to compare with other programs.
USES = {
    "none": "normal contact alone",
    "strips": "simulations",
    "polach": "rough studies with little spin",
    "halfspace": "reference; Python only, 0.1 s a patch",
}


def creep_force_table(parts):
    """Errors of the force, model by model."""
    return error_table(parts, "force", [*CREEP_MODELS, EQUIVALENT, *QUOTED])


def creep_moment_table(parts):
    """Errors of the moment of the models that have one."""
    return error_table(
        parts, "moment", [*(name for name in CREEP_MODELS if name not in WITHOUT_MOMENT), EQUIVALENT]
    )


def error_table(parts, kind, names):
    found = parts["tangential_errors"]["rows"]
    return grid(
        [f"{kind}: mean / 95 of 100 / worst [%]", *(f"{label} ({found['cases'][label]})" for label in SETS)],
        [
            [
                f"{name} ({SOURCE.split(', other')[0]})" if name in QUOTED else name,
                *(precise(found[name][label][kind]) if label in found[name] else "" for label in SETS),
            ]
            for name in names
        ],
    )


def precise(values):
    """Numbers as "0.12 / 3.4 / 5.6"."""
    return " / ".join(f"{value:.2f}" if value < 0.995 else figure(value) for value in values)


def creep_time_table(parts):
    """Models alone, then the element with each of them."""
    found = parts["tangential_times"]["rows"]
    whole = found["whole"]
    models = (WITHOUT, *TIMED)
    rows = [
        ["one patch", "", *(figure(found[model]["units"]) for model in TIMED)],
        ["one patch [µs]", "", *(figure(found[model]["µs"]) for model in TIMED)],
        ["one patch, by itself", "", *(figure(found["by itself"][model]) for model in TIMED)],
        *(
            [f"wheelset, {element}", *(figure(found[element][model]) for model in models)]
            for element in (*ELEMENTS, FMU)
        ),
    ]
    return (
        f"{grid(['units', *models], rows)}\n\nA step has {whole['patches']:.2f} patches in the mean. A "
        f"row of all outputs has {whole['row']:,.0f} bytes, the memory of a wheelset "
        f"{whole['wheelset'] / 1e3:,.0f} kB, whatever the model."
    )


def creep_short_table(parts):
    """Errors on the cases that are held out, and what a patch costs."""
    errors, times = (parts[name]["rows"] for name in CREEP_PARTS)
    rows = []
    for name, (model, _) in CREEP_MODELS.items():
        kinds = ("force",) if name in WITHOUT_MOMENT else ("force", "moment")
        cells = [
            precise(errors[name][label][kind]) for kind in kinds for label in (NEW_PATCHES, NEW_ELLIPSES)
        ]
        rows.append(
            [
                name,
                *cells,
                *[""] * (4 - len(cells)),
                figure(times["by itself"][model]),
                figure(times[model]["units"]),
            ]
        )
    return grid(
        [
            "model",
            "force: patches",
            "ellipses",
            "moment: patches",
            "ellipses",
            "units by itself",
            "in a step",
        ],
        rows,
    )


def creep_model_table(parts):
    """The models as docs/choose.md has them."""
    errors, times = (parts[name]["rows"] for name in CREEP_PARTS)
    rows = []
    for model in TangentialModel.family.methods:
        name, cells = model.name, ["", "", ""]
        if name in errors:
            cells = [
                *(precise(errors[name][label]["force"]) for label in (NEW_PATCHES, NEW_ELLIPSES)),
                figure(times[name]["units"]),
            ]
        elif name == "halfspace":
            cells = ["0 by definition", "0 by definition", ""]
        default = " (default)" if name == WITHOUT else ""
        use = USES.get(name, "comparison with other programs")
        rows.append([f'`"{name}"`{default}', model.words, use, *cells])
    return grid(
        ["`tangential_model`", "description", "use it for", "error on patches", "on ellipses", "units"],
        rows,
        words=3,
    )


def readme_row(parts):
    """The README's row of creep forces: time of a whole step with ANALYN, errors of forces and moments on the
    patches that are held out."""
    errors, times = (parts[name]["rows"] for name in CREEP_PARTS)
    mean, _, worst = zip(*(errors["strips"][NEW_PATCHES][kind] for kind in ("force", "moment")))
    units = times[ALONE]["strips"]
    one = times["strips"]["µs"] / times["strips"]["units"]
    return [
        f"ANALYN and creep forces by strips, at {SPEED:g} m/s",
        figure(units * one),
        figure(units),
        f"force, moment: {precise(mean)}",
        precise(worst),
    ]
