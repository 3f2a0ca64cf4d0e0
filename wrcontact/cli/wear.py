"""``wrcontact wear``: the worn profile after a distance, from the results of an FMU."""

import re
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich import box
from rich.table import Table

from ..methods.numbers import check_choice
from ..methods.words import did_you_mean
from ..progress import working
from ..results.words import fixed
from ..system import ContactSystem
from ..wear import Wear, wheel_shape
from ..wear.accumulate import PARTS, PARTS_OF_ONE
from ..wear.laws import LAWS
from ..wheel import WheelContact
from .adding import adding, option
from .errors import Refused, check_file, sentences
from .options import number
from .report import console
from .typed import typed

#: Words of the package and of the command.
OTHERS = (
    ("mirrored is True", "--mirrored is given"),
    ("with a WheelContact", "with --part wheel or rail"),
    ("with a ContactSystem", "with --part left.wheel, right.wheel, left.rail or right.rail"),
)
#: Rows on the shape of a wheel: words, attribute, factor to mm.
SHAPE = (
    ("flange height Sh", "flange_height"),
    ("flange thickness Sd", "flange_thickness"),
    ("qR", "flange_steepness"),
    ("hollow of the tread", "hollow"),
    ("radius lost at the running circle", "radius_loss"),
)


def law_named(law, calibration, constants):
    """The law that the options name, with its constants."""
    if law not in LAWS:
        raise Refused(f"--law is {law!r}; permitted are {', '.join(LAWS)}{did_you_mean(law, LAWS)}")
    given = {} if calibration is None else {"calibration": calibration}
    for text in constants or ():
        key, equals, value = text.partition("=")
        known = LAWS[law].numbers()
        if not equals or key not in known:
            raise Refused(
                f"--constant is {text!r}; permitted is NAME=VALUE, of {law} with the names "
                f"{', '.join(known)}{did_you_mean(key, known)}"
            )
        given[key] = number(value)
    with sentences(
        lambda words: (
            f"--law {law}: {words}; give each by --constant NAME=VALUE"
            if " needs " in words
            else f"--law {law}: {words}"
        )
    ):
        return LAWS[law](**given)


def row(name, kind, default, words, flag=None, **more):
    """A row of a group of options."""
    if kind is float:
        more = {"parser": number, "metavar": "NUMBER", **more}
    return option(name, kind, default, flag or f"--{name.replace('_', '-')}", help=words, **more)


LAW = [
    row("law", str, "usfd", "Law of wear", metavar="|".join(LAWS)),
    row("calibration", float, None, "Factor on the law, such as a share of dry running"),
    row(
        "constants",
        list[str],
        None,
        "A constant of the law, in SI; can be repeated",
        flag="--constant",
        metavar="NAME=VALUE",
    ),
]
COURSE = [
    row(
        "distance",
        float,
        1000.0,
        "Distance that a wheel runs; of a rail the passages, in thousands",
        flag="--distance-km",
    ),
    row(
        "column",
        str,
        "time*speed",
        "Column with the distance run, in m, or time*speed",
        flag="--distance-column",
        metavar="NAME",
    ),
    row(
        "part",
        str,
        "right.wheel",
        "What wears; wheel or rail with the results of the FMU of one wheel",
        metavar="|".join(PARTS + PARTS_OF_ONE),
    ),
    row("mirrored", bool, False, "Mean of both sides: the vehicle turns and runs both ways"),
    row("smoothing", float, 1.0, "Smoothing of the depth over the arc", flag="--smoothing-mm"),
]


def grouped(command):
    """Decorator that adds these options; the command receives each group as a dict."""
    groups = {"law": LAW, "course": COURSE}

    def fold(given):
        taken = {group: {one.name: given.pop(one.name) for one in rows} for group, rows in groups.items()}
        return given | taken

    return adding(command, LAW + COURSE, fold, groups)


@grouped
def wear(
    geometry,
    results: Annotated[
        Path,
        typer.Argument(
            metavar="RESULTS",
            help="Results of an FMU, also of one wheel, with tangential_model and wear_outputs: .csv or "
            ".parquet with its names",
        ),
    ],
    law,
    course,
    output: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="Write the worn profile to this file, .json, which --wheel and --rail read"
        ),
    ] = None,
    plot: Annotated[
        bool, typer.Option("--plot", help="Draw the depth over the profiles, beside --output or as wear.png")
    ] = False,
):
    """Wear a wheel or a rail over a distance, from the results of an FMU.

    Each row of the results is a pose; it counts by the distance that it stands for. The law says what each
    pose takes off, and the profile is moved along its normal. The laws are those of dry laboratories, much
    faster than service; --calibration is a factor. More than 2 mm is too much for one step: the worn profile
    then has to be simulated again.

    Example: wrcontact wear results.csv --law usfd --calibration 0.04 --distance-km 50000 --output worn.json
    --plot
    """
    if output is not None and output.suffix.lower() != ".json":
        raise Refused(f"--output is {str(output)!r}; permitted is a file that ends in .json")
    picture = output.with_suffix(".png") if output else Path("wear.png")
    for target in [output] * (output is not None) + [picture] * plot:
        check_file(target)
    chosen = law_named(**law)
    part, distance, smoothing = course["part"], course["distance"] * 1e3, course["smoothing"] / 1e3
    if not results.is_file():
        raise Refused(
            f"RESULTS is {str(results)!r}, which is no file; permitted is a file of an FMU's results"
        )
    with sentences(typed):
        check_choice("--part", part, PARTS + PARTS_OF_ONE)
        one = part in PARTS_OF_ONE and not course["mirrored"]
        system = WheelContact(**geometry) if one else ContactSystem(**geometry)
    with sentences(_in_options), working("wear"):
        found = Wear(system, chosen, mirrored=course["mirrored"])
        found.add_fmu(results, distance_column=course["column"])
        worn = found.worn(part, distance, smoothing)
        _print(found, part, distance, smoothing, worn)
        if output:
            worn.save(output)
            print(f"worn profile written to {output}")
        if plot:
            from ..plots import save, wear_depth_figure

            save(wear_depth_figure(found, distance, smoothing), picture)
            print(f"picture written to {picture}")


def _in_kilometres(found):
    return f"--distance-km is {float(found[1]) / 1e3:g}"


def _in_options(sentence):
    """A sentence of the package with options in place of arguments."""
    sentence = re.sub(r"^distance is (\S+)(?=[,;] )", _in_kilometres, sentence)
    for name, flag in (("smoothing is ", "--smoothing-mm: "),):
        if sentence.startswith(name):
            return flag + sentence.removeprefix(name)
    for words, said in OTHERS:
        sentence = sentence.replace(words, said)
    return sentence


def _print(found, part, distance, smoothing, worn):
    """Tables of what is worn after a ``distance`` [m]."""
    out, arc = console(), found.arc(part)
    depth, error = (
        values * distance
        for values in (found.smooth_depth(part, smoothing), found.error(part, smoothing=smoothing))
    )
    k, wheel = int(np.argmax(depth)), part.endswith("wheel")
    out.print(
        f"{found.law!r}: {part} of {arc.profile.name}, {found.rows} poses over "
        f"{found.distance / 1e3:.6g} km, {found.left_out} left out",
        soft_wrap=True,
    )
    table = Table("", "", "", box=box.SIMPLE_HEAD, show_edge=False, show_header=False, padding=(0, 1, 0, 0))
    over = f"in {distance / 1e3:g} {'km' if wheel else 'thousand passages'}"
    table.add_row(
        f"deepest wear {over}", f"{fixed(1e3 * depth[k], 3, 3)} ± {fixed(1e3 * error[k], 3, 2)}", "mm"
    )
    table.add_row("where", fixed(1e3 * arc.places[k], 2), "mm")
    table.add_row("worn cross-section", fixed(1e6 * float(np.sum(depth)) * arc.width, 2, 3), "mm²")
    for name, share in found.shares(part).items():
        table.add_row(f"worn in regime {name}", fixed(100 * share, 1), "%")
    if wheel:
        both = wheel_shape(arc.profile), wheel_shape(worn, arc.profile)
        for words, name in SHAPE:
            table.add_row(words, " → ".join(fixed(1e3 * getattr(shape, name), 3) for shape in both), "mm")
    out.print(table)
