"""``wrcontact figures``: the figures of the degree project, each as picture and table, with an index."""

from pathlib import Path

from rich import box
from rich.table import Table

from ..progress import tracked
from ..storage.atomic import write_atomically
from ..study.figure import FAILS, HOLDS, PARTLY, Study
from ..study.figures import chosen, compute
from .report import console

INDEX = "figures.md"
VERDICTS = {HOLDS: "It holds.", PARTLY: "It holds in part.", FAILS: "It does not hold."}


def run_figures(output, words):
    """Write the figures named by ``words`` (all if empty) and an index into the folder ``output``; print a
    summary."""
    from ..plots import save
    from ..plots.source_figures import source_figure

    numbers = chosen(words)
    folder = Path(output)
    folder.mkdir(parents=True, exist_ok=True)
    study, figures, out = Study(), [], console()
    for number in tracked(numbers, "figures"):
        figure = compute(number, study)
        figure.write(folder / f"{figure.stem}.csv")
        save(source_figure(figure), folder / f"{figure.stem}.png")
        figures.append(figure)
    write_atomically(folder / INDEX, index(figures).encode())
    out.print(summary(figures))
    out.print(f"{len(figures)} figures, their tables and {INDEX} written to {folder}", soft_wrap=True)


def summary(figures):
    """A table with one row per figure: number, what it shows, main result, whether the source's claim
    holds."""
    table = Table("fig.", "what", "main result", "claim", box=box.SIMPLE_HEAD, show_edge=False,
                  padding=(0, 1, 0, 0))
    for column in table.columns:
        column.no_wrap = True
    for figure in figures:
        table.add_row(figure.number, figure.short, figure.key, figure.verdict,
                      style={PARTLY: "yellow", FAILS: "red"}.get(figure.verdict))
    return table


def index(figures):
    """A page in Markdown: a table of all figures, then each picture with the source's claim and the
    finding."""
    parts = ["# The source's figures, recomputed\n\nS1002 on UIC60 1:40, gauge 1435 mm, nominal radius 460 "
             "mm, 78.5 kN "
             "per wheel. Each picture is drawn from the table with the same name.\n",
             "| figure | what it shows | main result | the source's claim |\n|---|---|---|---|"]
    parts[-1] += "".join(f"\n| [{figure.number}]({figure.stem}.png) | {figure.title} | {figure.key} | "
                         f"{figure.verdict} |"
                         for figure in figures) + "\n"
    parts += [f"## {figure.number} {figure.title}\n\n![{figure.title}]({figure.stem}.png)\n\n*The source:* "
              f"{figure.claim} "
              f"**{VERDICTS[figure.verdict]}** {figure.finding} ([table]({figure.stem}.csv))\n"
              for figure in figures]
    return "\n".join(parts)
