"""The tables of docs/evidence/validation.md: a line for each comparison with a reference, and all models on new
and on worn pairs."""

from .creep import NEW_PATCHES
from .errors import NEAR
from .rows import DEFAULT_ROW, STRIP_ROW
from .tables import figure, grid, precise, three
from .worn_pairs import CREEP, KINDS, NORMAL, UNDER

PARTS = ("model_errors", "random_poses", "conformal", "tangential_errors", "manchester", "en15302")
#: Words of the normal models.
HERTZ, ANALYN, STRIPS = "Hertz", "ANALYN", "strips"
CONTACT = "CONTACT v25.2"
PROGRAM = "half-space program that shares no code"


def validation_table(parts):
    """What is compared with what, and how far apart they are."""
    rows = {name: parts[name]["rows"] for name in PARTS}
    return grid(
        ["compared", "reference", "cases", "wrcontact's", "mean", "largest"],
        [
            *positions(rows["model_errors"]),
            *random(rows["random_poses"]),
            *conformal(rows["conformal"]),
            *creep(rows["tangential_errors"]),
            *rolls(rows["manchester"]),
            *conicities(rows["en15302"]),
        ],
        words=4,
    )


def positions(found):
    """Places by an independent search, patches by a half-space program of its own."""
    place = found["geometry and roll alone"]
    yield [
        "roll and contact positions",
        "brute-force search over dense points",
        "a hunting run",
        "search",
        "",
        f"{place['roll']:.0e} rad, {place['position']:.0e} mm",
    ]
    for name, row in ((HERTZ, HERTZ), (ANALYN, DEFAULT_ROW), (STRIPS, STRIP_ROW)):
        yield [
            "penetration / area / peak pressure [%]",
            PROGRAM,
            "20 positions, tread to flange",
            name,
            three(found[row]["positions mean"]),
            three(found[row]["positions worst"]),
        ]


def random(found):
    """The same on random wheels; 99 of 100 beside the worst."""
    wheels = 2 * found["poses"]["count"]
    for name, model in ((ANALYN, "analyn"), (STRIPS, "analyn_strip")):
        row = found[model]
        yield [
            "penetration / area / peak pressure [%]",
            "wrcontact's half-space",
            f"{wheels} random wheels",
            name,
            three(row["mean"]),
            f"{three(row['worst'])}; 99 of 100: {three(row['99 of 100'])}",
        ]


def conformal(found):
    """Patches that turn around the rail, at a given penetration."""
    for name, model in ((ANALYN, "analyn"), (STRIPS, "analyn_strip"), ("half-space", "halfspace")):
        row = found[model]
        cases = len(row) - 2
        yield [
            "force / area / peak pressure [%]",
            f"{CONTACT}, conformal",
            f"{cases} poses in the flange root",
            name,
            precise(row["mean"]),
            precise(row["worst"]),
        ]


def creep(found):
    """Creep forces: share of friction times load."""
    cases = found["cases"]
    for label, reference in (
        ("CONTACT's ellipses", CONTACT),
        ("CONTACT's patches", CONTACT),
        (NEW_PATCHES, "complete theory of steady rolling"),
    ):
        for model in ("strips", "fastsim"):
            mean, _, worst = found[model][label]["force"]
            yield [
                "creep force, share of μN [%]",
                reference,
                f"{cases[label]} {label.split()[-1]}",
                model,
                precise([mean]),
                precise([worst]),
            ]


def rolls(found):
    for mode in ("rigid", "elastic"):
        row = found[mode]
        yield [
            "roll [µrad]",
            "Manchester contact benchmark, case A-2.2",
            f"shifts up to {NEAR} mm; beyond",
            mode,
            "",
            f"{figure(row['near'])}; {figure(row['beyond'])}",
        ]


def conicities(found):
    amplitudes, inside = (sum(row[name] for row in found.values()) for name in ("amplitudes", "either"))
    yield [
        "equivalent conicity",
        "EN 15302, reference profiles",
        f"{amplitudes} amplitudes in {len(found)} cases",
        "`check`",
        "",
        f"{inside} of {amplitudes} inside its limits",
    ]


#: Words of the models of normal contact in the table of worn pairs.
NORMAL_WORDS = {"hertz": HERTZ, "analyn": ANALYN, "auto": "auto", "analyn_strip": STRIPS}


def worn_table(parts):
    """Errors of the models of normal contact on new and on worn pairs: mean; 95 %; worst."""
    rows = parts["worn_pairs"]["rows"]["normal"]
    return grid(
        ["normal contact, [%]", *(f"{kind} ({rows[kind]['wheels']} wheels)" for kind in KINDS)],
        [
            [NORMAL_WORDS[name], *("; ".join(map(three, rows[kind][name])) for kind in KINDS)]
            for name in NORMAL
        ]
        + [
            [
                "wheels that `auto` gives strips a part in",
                *(f"{100 * rows[kind]['strips']:.0f}" for kind in KINDS),
            ]
        ],
    )


def worn_estimate_table(parts):
    """What ANALYN's estimate of its error is worth."""
    rows = parts["worn_pairs"]["rows"]["normal"]["estimate"]
    return grid(
        [
            "`model_error` of ANALYN",
            "wheels",
            "mean estimate [%]",
            "error of the peak pressure: mean / 95 % / worst [%]",
        ],
        [[label, row["wheels"], figure(row["estimate"]), three(row["error"])] for label, row in rows.items()],
    )


def worn_creep_table(parts):
    """Errors of the models of creep forces on wheels of the same pairs, over both models of normal contact."""
    rows = parts["worn_pairs"]["rows"]["creep"]
    wheels = rows[f"{CREEP[0]}, {UNDER[0]}"]["wheels"]
    return grid(
        [
            f"creep force, {wheels} wheels [% of μN]",
            *(f"over `{under}`" for under in UNDER),
            "signed mean of the size",
        ],
        [
            [
                f"`{name}`",
                *(precise(rows[f"{name}, {under}"]["force"]) for under in UNDER),
                f"{rows[f'{name}, {UNDER[-1]}']['signed']:+.2f}",
            ]
            for name in CREEP
        ],
    )
