"""``wrcontact profiles``: the standard profiles, where their numbers come from, and a picture of them."""

from pathlib import Path
from typing import Annotated

import typer
from rich import box
from rich.table import Table

from ..interface.index import KINDS
from ..methods.words import did_you_mean
from ..profiles.catalogue import every_profile, standard_name, standard_profile, words_on_missing
from ..profiles.standards import PATTERNS, names, standards
from .errors import Refused, check_file, sentences
from .pictures import PICTURES
from .report import console


def profiles(
    chosen: Annotated[
        list[str] | None, typer.Argument(metavar="[NAME]...", help="Profiles (default: all)")
    ] = None,
    plot: Annotated[bool, typer.Option("--plot", help="Draw them, each small, into one picture")] = False,
    output: Annotated[
        Path, typer.Option(metavar="FILE", help="File of the picture: .png, .svg or .pdf")
    ] = Path("profiles.png"),
    save_as: Annotated[
        Path | None,
        typer.Option(
            "--save",
            metavar="FILE",
            show_default=False,
            help="Write the one profile that is named to a file: .json, .csv, .txt, .prw, .prr, .whl, .ban, .wheel or .rail",
        ),
    ] = None,
):
    """List the standard profiles: rails and wheels by name, with the standard, and how many sources agree.

    With names, each is described in full. A wheel of EN 13715 is named by its designation: tread, height and
    thickness of the flange in mm, outer slope.

    Example: wrcontact profiles R65 --save r65.prr
    """
    with sentences():
        found = [_profile(name) for name in chosen or ()]
    if save_as:
        _save(found, save_as)
    if plot:
        _draw(found, output)
    if found:
        for profile in found:
            print(_described(profile))
    else:
        _list()
    if plot:
        print(f"picture written to {output}")


def _profile(name):
    """The profile of this name, a rail or a wheel."""
    known = standard_name(name)
    if known is None:
        lost = next(filter(None, (words_on_missing(name, kind) for kind in KINDS[::-1])), None)
        if lost:
            raise Refused(f"NAME is {name!r}{lost}")
        every = (*names("rail"), *names("wheel"), *PATTERNS)
        raise Refused(
            f"{name!r} is no standard profile; `wrcontact profiles` lists them{did_you_mean(name, every)}"
        )
    return standard_profile(known)


def _described(profile):
    start, stop = (1e3 * end for end in (profile.start, profile.stop))
    return f"{profile.name}: {profile.kind}, y = {start:.4g} ... {stop:.4g} mm; {profile.source}"


def _list():
    table = Table(box=box.SIMPLE, pad_edge=False)
    for heading in ("name", "kind", "also called", "standard", "sources", "remark"):
        table.add_column(heading, no_wrap=heading in ("name", "kind"))
    for kind in KINDS[::-1]:
        for name in names(kind):
            table.add_row(name, kind, *_row(standards()[kind + "s"][name]))
    for name in PATTERNS:
        sizes = "any h 28 ... 32 mm, e 28.5 ... 32.5 mm, outer slope 6.7 ... 15 %"
        row = _row(standards()["en13715"])
        table.add_row(name, "wheel", *row[:-1], sizes)
    out = console()
    out.print(table)
    lost = ", ".join(name for kind in KINDS[::-1] for name in standards()["missing"][kind])
    out.print(f"No public source with enough numbers was found of {lost}.", soft_wrap=True)


def _row(entry):
    """Other names, standard, number of sources, and remark."""
    year = f":{entry['year']}" if entry["year"] else ""
    return (
        ", ".join(entry.get("also", ())),
        entry["standard"] + year,
        str(entry["sources"]),
        entry.get("note", ""),
    )


def _save(found, path):
    if len(found) != 1:
        raise Refused(f"--save is given with {len(found)} profiles; permitted is one NAME")
    check_file(path)
    with sentences():
        found[0].save(path)
    print(f"profile written to {path}")


def _draw(found, output):
    if output.suffix.lower() not in PICTURES:
        raise Refused(f"--output is {str(output)!r}; permitted are files that end in {', '.join(PICTURES)}")
    check_file(output)
    from ..plots.profiles import draw_profiles
    from ..plots.style import save

    save(draw_profiles(found or every_profile()), output)
