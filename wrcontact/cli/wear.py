"""``wrcontact wear``: the worn profile after a distance, from the results of an FMU."""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich import box
from rich.table import Table

from .. import ContactSystem
from ..methods.words import did_you_mean
from ..profiles.files import prepared_text
from ..progress import working
from ..results.words import fixed
from ..storage.atomic import write_atomically
from ..wear import Wear, wheel_shape
from ..wear.accumulate import PARTS
from ..wear.laws import LAWS
from .door import Refused, check_file, sentences
from .options import number
from .report import console
from .typed import typed

#: Rows on the shape of a wheel: words, attribute, factor to mm.
SHAPE = (("flange height Sh", "flange_height"), ("flange thickness Sd", "flange_thickness"),
         ("qR", "flange_steepness"), ("hollow of the tread", "hollow"),
         ("radius lost at the running circle", "radius_loss"))


def law_named(name, calibration, constants):
    """The law that the options name, with its constants."""
    if name not in LAWS:
        raise Refused(f"--law is {name!r}; permitted are {', '.join(LAWS)}{did_you_mean(name, LAWS)}")
    given = {} if calibration is None else {"calibration": calibration}
    for text in constants or ():
        key, equals, value = text.partition("=")
        known = LAWS[name].numbers()
        if not equals or key not in known:
            raise Refused(f"--constant is {text!r}; permitted is NAME=VALUE, of {name} with the names "
                          f"{', '.join(known)}{did_you_mean(key, known)}")
        given[key] = number(value)
    with sentences(lambda words: f"--law {name}: {words}; give each by --constant NAME=VALUE"
                   if " needs " in words else f"--law {name}: {words}"):
        return LAWS[name](**given)


def wear(geometry, results: Annotated[Path, typer.Argument(
             metavar="RESULTS", help="Results of an FMU with tangential_model and wear_outputs: .csv or "
                                     ".parquet with its names")],
         law: Annotated[str, typer.Option(metavar="|".join(LAWS), help="Law of wear")] = "usfd",
         calibration: Annotated[float | None, typer.Option(
             parser=number, metavar="NUMBER", help="Factor on the law, such as a share of dry running")] = None,
         constant: Annotated[list[str] | None, typer.Option(
             "--constant", metavar="NAME=VALUE", help="A constant of the law, in SI; can be repeated")] = None,
         distance: Annotated[float, typer.Option(
             "--distance-km", parser=number, metavar="NUMBER",
             help="Distance that a wheel runs; of a rail the passages, in thousands")] = 10000.0,
         column: Annotated[str, typer.Option(
             "--distance-column", metavar="NAME", help="Column with the distance run, in m, or "
                                                       "time*speed")] = "time*speed",
         part: Annotated[str, typer.Option(metavar="|".join(PARTS), help="What wears")] = "right.wheel",
         mirrored: Annotated[bool, typer.Option(
             "--mirrored", help="Mean of both sides: the vehicle turns and runs both ways")] = False,
         smoothing: Annotated[float, typer.Option(
             "--smoothing-mm", parser=number, metavar="NUMBER",
             help="Smoothing of the depth over the arc")] = 1.0,
         output: Annotated[Path | None, typer.Option(
             metavar="FILE", help="Write the worn profile to this file, .json, which --wheel and --rail "
                                  "read")] = None,
         plot: Annotated[bool, typer.Option(
             "--plot", help="Draw the depth over the profiles, beside --output or as wear.png")] = False):
    """Wear a wheel or a rail over a distance, from the results of an FMU.

    Each row of the results is a pose; it counts by the distance that it stands for. The law says what each
    pose takes off, and the profile is moved along its normal. More than 2 mm is too much for one step: the
    worn profile then has to be simulated again.

    Example: wrcontact wear results.csv --law usfd --distance-km 50000 --output worn.json --plot
    """
    if output is not None and output.suffix.lower() != ".json":
        raise Refused(f"--output is {str(output)!r}; permitted is a file that ends in .json")
    picture = output.with_suffix(".png") if output else Path("wear.png")
    for target in [output] * (output is not None) + [picture] * plot:
        check_file(target)
    chosen = law_named(law, calibration, constant)
    if not results.is_file():
        raise Refused(f"RESULTS is {str(results)!r}, which is no file; permitted is a file of an FMU's results")
    with sentences(typed):
        system = ContactSystem(**geometry)
    with sentences(_in_options), working("wear"):
        found = Wear(system, chosen, mirrored=mirrored)
        found.add_fmu(results, distance_column=column)
        worn = found.worn(part, distance * 1e3, smoothing / 1e3)
        _print(found, part, distance, smoothing / 1e3, worn)
        if output:
            write_atomically(output, prepared_text(worn).encode())
            print(f"worn profile written to {output}")
        if plot:
            from ..plots import save, wear_depth_figure

            save(wear_depth_figure(found, distance * 1e3, smoothing / 1e3), picture)
            print(f"picture written to {picture}")


def _in_options(sentence):
    """A sentence of the package with options in place of arguments."""
    for name, option in (("distance is ", "--distance-km is about "), ("smoothing is ", "--smoothing-mm: "),
                         ("part is ", "--part is ")):
        if sentence.startswith(name):
            return option + sentence.removeprefix(name)
    return sentence.replace("mirrored is True", "--mirrored is given")


def _print(found, part, distance, smoothing, worn):
    """Tables of what is worn."""
    out = console()
    kind = part.partition(".")[2] or part
    places, rate = found.depth(part)
    depth = found.smooth_depth(part, smoothing) * distance * 1e3
    k, error = int(np.argmax(depth)), found.error(part, smoothing=smoothing) * distance * 1e3
    out.print(f"{found.law!r}: {part} of {found.arcs[found._part(part)].profile.name}, {found.rows} poses over "
              f"{found.distance / 1e3:.6g} km, {found.left_out} left out", soft_wrap=True)
    table = Table("", "", "", box=box.SIMPLE_HEAD, show_edge=False, show_header=False, padding=(0, 1, 0, 0))
    over = f"in {distance:g} km" if kind == "wheel" else f"in {distance:g} thousand passages"
    table.add_row(f"deepest wear {over}", f"{fixed(1e3 * depth[k], 3, 3)} ± {fixed(1e3 * error[k], 3, 2)}", "mm")
    table.add_row("where", fixed(1e3 * places[k], 2), "mm")
    area = float(np.sum(depth)) * found.arcs[found._part(part)].width
    table.add_row("worn cross-section", fixed(1e6 * area, 2, 3), "mm²")
    for name, share in found.shares(part).items():
        table.add_row(f"worn in regime {name}", fixed(100 * share, 1), "%")
    if kind == "wheel":
        before = wheel_shape(found.arcs[found._part(part)].profile)
        after = wheel_shape(worn, found.arcs[found._part(part)].profile)
        for words, name in SHAPE:
            both = (fixed(1e3 * getattr(shape, name), 3) for shape in (before, after))
            table.add_row(words, " → ".join(both), "mm")
    out.print(table)
