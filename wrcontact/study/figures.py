"""The content of the source's figures, computed anew: what the source says, what we find, and the numbers.

    python -m wrcontact.study.figures       prints the table of docs/source_study.md, chapter 2

::

    curves and patches  ->  columns (the CSV)  ->  numbers, one sentence        figures_*.py
    columns -> picture wrcontact/plots/source_figures.py

>>> from wrcontact.study.figures import Study, compute
>>> figure = compute("7.10", Study())
>>> round(figure.numbers["length, basic / effective"], 2)
0.69
"""

import re

from ..progress import tracked
from . import figures_lateral, figures_longitudinal, figures_search, figures_separation, figures_yaw
from .figure import Study

#: The figures by what they are about, in the source's order.
CHAPTERS = (figures_search, figures_separation, figures_longitudinal, figures_lateral, figures_yaw)


def makers():
    """The functions that make the figures, by number, in the source's order."""
    return {number: make for chapter in CHAPTERS for number, make in chapter.FIGURES.items()}


def known():
    """Numbers of all figures, in the source's order."""
    return tuple(makers())


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
    return makers()[number](study)


def table(figures):
    """Chapter 2 of docs/source_study.md: a row in Markdown for each figure."""
    rows = [f"| {figure.number} | {figure.claim} | {figure.verdict} | {figure.finding} | {figure.key} |"
            for figure in figures]
    return "\n".join(["| figure | the source says | | we find | the number |", "|---|---|---|---|---|",
                      *rows])


if __name__ == "__main__":
    context = Study()
    print(table([compute(number, context) for number in tracked(known(), "figures")]))
