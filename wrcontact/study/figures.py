"""The content of the source's figures, computed anew: what the source says, what we find, and the numbers.

    curves and patches  ->  columns (the CSV)  ->  numbers, one sentence        figures_*.py
    columns  ->  picture                                                        pictures.py

The command ``wrcontact figures`` writes them.

>>> from wrcontact.study.figures import Study, compute
>>> figure = compute("7.10", Study())
>>> round(figure.numbers["length, basic / effective"], 2)
0.68
"""

import re

from rich import box
from rich.table import Table

from ..progress import tracked
from ..storage.atomic import write_atomically
from . import figures_curvature, figures_search, figures_separation
from .figure import FAILS, HOLDS, PARTLY, Study

INDEX = "figures.md"
VERDICTS = {HOLDS: "It holds.", PARTLY: "It holds in part.", FAILS: "It does not hold."}
#: The functions that make the figures, by number, in the source's order.
MAKERS = {**figures_search.FIGURES, **figures_separation.FIGURES, **figures_curvature.FIGURES}


def known():
    """Numbers of all figures, in the source's order."""
    return tuple(MAKERS)


def chosen(words):
    """Numbers of the figures that ``words`` name ("7.2", "fig_7_2", "7.2,7.4"), in the
    source's order; all for none.

    Raises
    ------
    ValueError
        in one sentence with the known numbers.
    """
    asked = [part for word in words for part in re.split(r"[,\s]+", word) if part]
    plain = [re.sub(r"^fig[._]?", "", part.lower()).replace("_", ".") for part in asked]
    for part, number in zip(asked, plain):
        if number not in known():
            raise ValueError(f"figure {part!r} is not known; known are {', '.join(known())}")
    return tuple(number for number in known() if not plain or number in plain)


def compute(number, study):
    """The :class:`SourceFigure` with this number."""
    return MAKERS[number](study)


# ---------------------------------------------------------------------------------------- the command's files


def write_figures(folder, words):
    """Write the figures named by ``words`` (all if empty), each as picture and table, and an index into a
    folder, a :class:`~pathlib.Path`; they are returned."""
    from ..plots import save
    from .pictures import source_figure

    numbers = chosen(words)
    folder.mkdir(parents=True, exist_ok=True)
    study, figures = Study(), []
    for number in tracked(numbers, "figures"):
        figure = compute(number, study)
        figure.write(folder / f"{figure.stem}.csv")
        save(source_figure(figure), folder / f"{figure.stem}.png")
        figures.append(figure)
    write_atomically(folder / INDEX, index(figures).encode())
    return figures


def summary(figures):
    """A table with one row per figure: number, what it shows, main result, whether the source's claim
    holds."""
    table = Table(
        "fig.", "what", "main result", "claim", box=box.SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0)
    )
    for column in table.columns:
        column.no_wrap = True
    for figure in figures:
        table.add_row(
            figure.number,
            figure.short,
            figure.key,
            figure.verdict,
            style={PARTLY: "yellow", FAILS: "red"}.get(figure.verdict),
        )
    return table


def index(figures):
    """A page in Markdown: a table of all figures, then each picture with the source's claim and the
    finding."""
    parts = [
        "# The source's figures, recomputed\n\nS1002 on UIC60 1:40, gauge 1435 mm, nominal radius 460 "
        "mm, 78.5 kN "
        "per wheel. Each picture is drawn from the table with the same name.\n",
        "| figure | what it shows | main result | the source's claim |\n|---|---|---|---|",
    ]
    parts[-1] += (
        "".join(
            f"\n| [{figure.number}]({figure.stem}.png) | {figure.title} | {figure.key} | {figure.verdict} |"
            for figure in figures
        )
        + "\n"
    )
    parts += [
        f"## {figure.number} {figure.title}\n\n![{figure.title}]({figure.stem}.png)\n\n*The source:* "
        f"{figure.claim} "
        f"**{VERDICTS[figure.verdict]}** {figure.finding} ([table]({figure.stem}.csv))\n"
        for figure in figures
    ]
    return "\n".join(parts)
