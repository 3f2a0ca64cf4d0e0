"""The tables of creep forces."""

from .peers import SOURCE
from .table import figure, grid
from .tangential import EQUIVALENT, MODELS, NEW_ELLIPSES, NEW_PATCHES, QUOTED, SETS, WITHOUT_MOMENT
from .tangential_times import ELEMENTS, FMU, WITHOUT
from .tangential_times import MODELS as TIMED

NOTE = ("Errors: mean / 95 of 100 / worst of |ΔF|/(μN) or |ΔM|/(μN √(ab)) [%] on patches and ellipses on "
        "which no constant of a model was chosen. Units: of one patch.")
#: What the README says of the models: description, and what to use it for.
WORDS = {
    "none": ("no friction", "normal contact alone"),
    "strips": ("coupled strips on the patch as it is, corrected by exact solutions of ellipses",
               "simulations"),
    "fastrip": ("strip theory joined with FASTSIM", "comparison with other programs"),
    "fastsim": ("Kalker's simplified theory", "comparison with other programs"),
    "polach": ("Polach's formula for one ellipse", "rough studies with little spin"),
    "halfspace": ("complete theory of steady rolling", "reference; Python only, 0.1 s a patch"),
}


def force_table(parts):
    """Errors of the force, model by model."""
    return error_table(parts, "force", [*MODELS, EQUIVALENT, *QUOTED])


def moment_table(parts):
    """Errors of the moment of the models that have one."""
    return error_table(parts, "moment", [*(name for name in MODELS if name not in WITHOUT_MOMENT),
                                         EQUIVALENT])


def error_table(parts, kind, names):
    found = parts["tangential_errors"]["rows"]
    return grid([f"{kind}: mean / 95 of 100 / worst [%]",
                 *(f"{label} ({found['cases'][label]})" for label in SETS)],
                [[f"{name} ({SOURCE.split(', other')[0]})" if name in QUOTED else name,
                  *(precise(found[name][label][kind]) if label in found[name] else "" for label in SETS)]
                 for name in names])


def precise(values):
    """Numbers as "0.12 / 3.4 / 5.6"."""
    return " / ".join(f"{value:.2f}" if value < 0.995 else figure(value) for value in values)


def time_table(parts):
    """Models alone, then the element with each of them."""
    found = parts["tangential_times"]["rows"]
    whole = found["whole"]
    models = (WITHOUT, *TIMED)
    rows = [["one patch", "", *(figure(found[model]["units"]) for model in TIMED)],
            ["one patch [µs]", "", *(figure(found[model]["µs"]) for model in TIMED)],
            ["one patch, by itself", "", *(figure(found["by itself"][model]) for model in TIMED)],
            *([f"wheelset, {element}", *(figure(found[element][model]) for model in models)]
              for element in (*ELEMENTS, FMU))]
    return (f"{grid(['units', *models], rows)}\n\nA step has {whole['patches']:.2f} patches in the mean. A "
            f"row of all outputs has {whole['row']:,.0f} bytes, the memory of a wheelset "
            f"{whole['wheelset'] / 1e3:,.0f} kB, whatever the model.")


def short_table(parts):
    """Errors on the cases that are held out, and what a patch costs."""
    errors, times = (parts[name]["rows"] for name in ("tangential_errors", "tangential_times"))
    rows = []
    for name, (model, _) in MODELS.items():
        kinds = ("force",) if name in WITHOUT_MOMENT else ("force", "moment")
        cells = [precise(errors[name][label][kind]) for kind in kinds
                 for label in (NEW_PATCHES, NEW_ELLIPSES)]
        rows.append([name, *cells, *[""] * (4 - len(cells)), figure(times["by itself"][model]),
                     figure(times[model]["units"])])
    return grid(["model", "force: patches", "ellipses", "moment: patches", "ellipses", "units by itself",
                 "in a step"], rows)


def model_table(parts):
    """The models as the README has them."""
    errors, times = (parts[name]["rows"] for name in ("tangential_errors", "tangential_times"))
    rows = []
    for name, (description, use) in WORDS.items():
        cells = ["", "", ""]
        if name in errors:
            cells = [*(precise(errors[name][label]["force"]) for label in (NEW_PATCHES, NEW_ELLIPSES)),
                     figure(times[name]["units"])]
        elif name == "halfspace":
            cells = ["0 by definition", "0 by definition", ""]
        default = " (default)" if name == WITHOUT else ""
        rows.append([f'`"{name}"`{default}', description, use, *cells])
    return grid(["`tangential_model`", "description", "use it for", "error on patches", "on ellipses",
                 "units"], rows, words=3)
