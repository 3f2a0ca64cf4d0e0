"""Write docs/reference/nomenclature.md: ``python docs/make_nomenclature.py``.

Inputs, parameters and outputs are those of the table in wrcontact/interface; their symbols, and the table of
symbols that only the kernel has, are declared here.
"""

from pathlib import Path

from wrcontact.interface.inputs import INPUTS
from wrcontact.interface.outputs import PATCH, SIDE, STRIPS, WEAR, WHEELSET
from wrcontact.interface.parameters import PARAMETERS
from wrcontact.interface.rows import AXES, Blocks, Run, Vector
from wrcontact.interface.variables import STATUS, VARIABLES
from wrcontact.kernel import layout
from wrcontact.methods import FAMILIES

PAGE = Path(__file__).resolve().parent / "reference" / "nomenclature.md"

#: Symbols of rows of the table, as in docs/theory, by the name of the row; those of a patch begin
#: with "patch.".
SYMBOLS = {
    "lateral_shift": "y",
    "yaw": "ψ",
    "roll": "θ",
    "roll_input": "θ",
    "normal_force": "N",
    "load_transfer": "λ",
    "vertical_shift": "z",
    "vertical_shift_input": "z",
    "nominal_radius": "r₀",
    "youngs_modulus": "E",
    "poisson_ratio": "ν",
    "contact_angle": "γ",
    "rolling_radius": "r",
    "curvature_x": "1/R_x",
    "curvature_y": "1/R_y",
    "penetration": "δ",
    "max_pressure": "p₀",
    "station": "s",
    "half_length": "a",
    "pressure": "p",
    "patch.normal_force": "N",
    "patch.max_pressure": "p₀",
}

#: Symbols of the kernel: symbol, name in code (``Record.field`` where it is a field), unit, meaning, equation
#: of docs/theory.
KERNEL = (
    (
        "r(y), z(y)",
        "tables.height_slope",
        "m",
        "radius of the wheel and height of the rail along their profiles",
        "",
    ),
    ("φ", "locus.around_wheel", "rad", "angle around the wheel of a point of the contact locus", "2.2"),
    ("t, w", "Place.t, Place.w_per_slope", "1", "tan ψ sin θ; tan ψ cos θ r′ / √(1 + t²)", "2.2"),
    ("Y, Z", "locus.outline_point", "m", "outline of the wheel, seen along the track", "2.2"),
    ("gap(y)", "gap.vertical_gap", "m", "vertical distance of outline and rail", "3.1"),
    ("D(θ)", "roll.balance", "m", "smallest gap on the right minus that on the left", "4.1"),
    ("L", "Place.arm", "m", "distance of the wheel from the centre of the wheelset", "4.2"),
    (
        "g(s)",
        "Nodes.gap",
        "m",
        "how much less the overlap is than at the region's deepest point",
        "[geometry](../theory/geometry.md)",
    ),
    ("A", "Nodes.A", "1/m", "half the longitudinal curvature, 1 / (2 R_x)", "5.1"),
    ("B", "Nodes.B", "1/m", "half the lateral curvature", "8.3"),
    (
        "E*",
        "Tables.contact_modulus",
        "Pa",
        "contact modulus, E / (2 (1 − ν²)) for two bodies of one material",
        "6.2",
    ),
    ("a, b", "", "m", "semi-axes of Hertz's ellipse along and across the track", "6.2"),
    ("m, n, r", "", "1", "Hertz's coefficients of a, b and of the approach δ", "6.1"),
    ("δ", "SideOutputs.penetration", "m", "penetration: approach of wheel and rail", "6.2"),
    ("1 + α", "Nodes.length", "1/m", "correction of the half-length; kept times A", "7.1"),
    ("1 + β", "Nodes.rise", "m", "correction of the separation; kept times g", "7.1"),
    ("d(s)", "", "m", "local penetration δ − (1 + β) g", "7.2"),
    ("E* / (n r)", "Nodes.line", "Pa", "line load for each local penetration", "7.3"),
    ("c_ij", "", "m/N", "how much a load on region j pushes region i down", "8.4"),
    (
        "χ",
        "Region.slant",
        "1",
        "slope dx/ds of the line on which the gap of a yawed wheel is smallest",
        "7.5",
    ),
    ("W", "Region.width_low, Region.width_high", "m", "half-width of the interpenetration", "8.1"),
    ("κ", "", "1/m", "curvature of a profile", "8.9"),
    ("q", "SolvedStrip.line_load", "N/m", "line load: normal force for each width of a patch", "S5"),
    ("a²", "SolvedStrip.half_length_square", "m2", "square of the half-length of a strip", "S6"),
    ("p²", "SolvedStrip.pressure_square", "Pa2", "square of the pressure on the middle of a strip", "S13"),
    ("w", "SolvedStrip.width", "m", "width of a strip", "S4"),
    ("Φ", "", "1", "influence of a strip on a place beside it", "S2"),
)


def table(headings, rows):
    """Lines of a table in Markdown."""
    lines = ["| " + " | ".join(cells) + " |" for cells in (headings, ["---"] * len(headings), *rows)]
    return [line.replace("|  |", "| |") for line in lines]


def of_table(rows, prefix=""):
    """Cells of rows of inputs and outputs."""
    for row in rows:
        if isinstance(row, Blocks):
            continue
        ending = "[j]" if isinstance(row, Run) else ".x, .y, .z" if isinstance(row, Vector) else ""
        meaning = getattr(row, "words", row.meaning).format(axis=", ".join(way for _, way in AXES))
        yield (SYMBOLS.get(prefix + row.name, ""), f"`{row.name}{ending}`", row.unit, meaning)


def of_parameters():
    """Cells of the parameters, without the methods."""
    for row in PARAMETERS.values():
        if row.family is None:
            other = "" if row.fmu_name in ("", row.name) else f", in an FMU `{row.fmu_name}`"
            unit, default = (row.number.unit, row.start) if row.number else ("", row.default)
            shown = f"{default:g}" if isinstance(default, float) else str(default or "")
            yield SYMBOLS.get(row.name, ""), f"`{row.name}`{other}", unit, shown, row.meaning


def of_methods():
    """Cells of the methods."""
    for family in FAMILIES:
        for method in family.methods:
            yield f"`{family.parameter}`", f'"{method.name}"', f"`{method.__name__}`", method.words


def of_kernel():
    """Cells of the symbols of the kernel."""
    for symbol, name, unit, meaning, equation in KERNEL:
        numbered = equation[-1:].isdigit() and "." in equation or equation[:1] == "S"
        yield (
            symbol,
            ", ".join(f"`{one}`" for one in name.split(", ") if one),
            unit,
            meaning,
            f"({equation})" if numbered else equation,
        )


def page():
    """The text of the page."""
    headings = ("symbol", "name", "unit", "meaning")
    status = [f"| | `status` | | {VARIABLES[STATUS].meaning} |"]
    parts = {
        "# Nomenclature": [
            "Inputs, parameters, methods and outputs, in SI, with the names that FMUs and Python have for "
            "them. `docs/make_nomenclature.py` writes this page from `wrcontact/interface`. Frames and signs "
            "are in [frames and signs](conventions.md), equations in [theory](../theory/index.md); the "
            "page in each FMU, `documentation/index.html`, also has limits and value references."
        ],
        "## Inputs": table(headings, of_table(INPUTS)),
        "## Parameters": table((*headings[:3], "default", "meaning"), of_parameters()),
        "## Methods": table(("parameter", "string", "object", "meaning"), of_methods()),
        "## Outputs of the wheelset": [*table(headings, of_table(WHEELSET)), *status],
        "## Outputs of a wheel": [
            "In an FMU the names begin with `left.` or `right.`. The contact angle is γ in theory, where δ "
            "is the penetration, and δ in [frames and signs](conventions.md).",
            "",
            *table(headings, of_table(SIDE)),
        ],
        "## Outputs of a patch": [
            "In an FMU the names begin with `left.patch[k].` or `right.patch[k].`.",
            "",
            *table(headings, of_table(PATCH, "patch.")),
        ],
        "## Outputs of wear": [
            "They are there with the parameter `wear_outputs`. In an FMU the names begin with `left.` or "
            "`right.`, and without the parameter their values are zero.",
            "",
            *table(headings, of_table(WEAR, "wear.")),
        ],
        "## Outputs of a strip": [
            "With `wear_outputs`, in Python only: arrays (16,) of `state.right.strips[k]`.",
            "",
            *table(headings, of_table(STRIPS, "strip.")),
        ],
        "## Symbols of the kernel": [
            "What stands in a record has its name there, `Record.field` of `wrcontact/kernel/layout`.",
            "",
            *table(("symbol", "name in code", "unit", "meaning", "equation"), of_kernel()),
        ],
    }
    return "\n".join("\n".join([heading, "", *lines, ""]) for heading, lines in parts.items())


def unknown_fields():
    """Names ``Record.field`` of the kernel's table that no record has."""
    names = [one for _, name, *_ in KERNEL for one in name.split(", ") if one[:1].isupper()]
    return [
        name for name in names if not hasattr(getattr(layout, name.split(".")[0], None), name.split(".")[1])
    ]


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
