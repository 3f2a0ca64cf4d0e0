"""Run time beside error, as Markdown tables and a picture.

    python -m benchmarks [--quick] [--readme] [--picture PATH] [--random N]

docs/benchmarks.md explains what is measured and has the results.  The unit is the time of ``np.sqrt`` of 2000
doubles, timed alternately with each row, so that results of two machines can be compared.  A row is the
fastest of several rounds, since disturbances only add time.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from wrcontact.plots import style
from wrcontact.progress import tracked
from wrcontact.study.compare import search_rows

from . import counts, growth, machine, picture, random_poses, rows, skips, trajectory
from .peers import PEERS, SOURCE
from .table import figure, line, markdown, percent, rule

HEADER = ["one wheelset, both patches", "units", "µs", "positions: mean", "worst", "hunting run: mean",
          "worst"]
RANDOM = 2000  # poses of a full run
QUICK_RANDOM = 4


def main(arguments=None):
    options = parsed(arguments)
    effort = rows.QUICK if options.quick else rows.FULL
    if options.readme:
        print(readme(effort))
        return
    print(machine.description() + "\n", flush=True)
    measured = measure(rows.all_rows(effort), effort)
    print(full_table(measured, effort), flush=True)
    if options.picture:
        print(style.save(picture.figure(measured), options.picture), file=sys.stderr)
    for part in tracked((trajectory_table, search_table, skip_table, count_table, growth_table,
                          thread_table), "tables"):
        print(part(effort), flush=True)
    print(random_poses.numerics(effort.count), flush=True)
    print(random_part(options), flush=True)
    print(machine.description())


def parsed(arguments):
    parser = argparse.ArgumentParser("python -m benchmarks",
                                     description="Run time beside error; see docs/benchmarks.md.")
    parser.add_argument("--quick", action="store_true",
                        help="few poses and rounds, to test that everything runs (half a minute)")
    parser.add_argument("--readme", action="store_true", help="print only the README's table")
    parser.add_argument("--picture", metavar="PATH", help="draw run time against error")
    parser.add_argument("--random", metavar="N", type=int, default=None,
                        help="compare N random poses with the half-space, "
                        f"about 0.1 s each on two free cores (default {RANDOM}); results are kept in "
                        f"{random_poses.STORE}, so "
                        "that an interrupted run can be continued")
    return parser.parse_args(arguments)


def measure(chosen, effort, short=False):
    """The chosen rows, measured, and the FMU's row at the end; with ``short`` only those of the README."""
    measured = [row for row in chosen if row.short or not short]
    for row in tracked(measured * effort.passes, "rows of the table of models"):
        row.measure()
    with tempfile.TemporaryDirectory() as folder:
        return [*measured, rows.fmu_row(folder, effort)]


# ----------------------------------------------------------------------------------------------------- tables


def full_table(measured, effort):
    """All rows, and the quoted results of other programs."""
    text = markdown("Run time and error", HEADER,
                    [cells(row) for row in measured] + [peer_cells(peer) for peer in PEERS])
    notes = ["Errors in % of penetration / area / peak pressure, mean and worst."]
    if effort.every > 1:
        notes.append(f"Quick run: the half-space solves every {effort.every}th row of the hunting run.")
    return text + "\n" + " ".join(notes) + "\n"


def trajectory_table(effort):
    """Cost and work of a step on the trajectory that the speed is judged by."""
    return trajectory.table(10 * effort.count, effort.passes * effort.rounds)


def search_table(effort):
    """The contact searches of the degree project that wrcontact started from, geometry only
    (docs/source_study.md)."""
    found = []
    for name, work, calls, error in search_rows(quick=effort is rows.QUICK):
        took = machine.cost(work, calls, 1)
        found.append([name, figure(took.units), figure(took.microseconds), error])
    header = ["one wheelset", "units", "µs", "worst error where it does not fail"]
    return markdown("Other searches: roll and rigid contacts only", header, found) + "\n"


def cells(row):
    figures = [row.name, figure(row.cost.units), figure(row.cost.microseconds)]
    if row.rigid:
        return [*figures, "", "", "", row.rigid]
    return [*figures,
            *(percent(part) for found in (row.positions, row.hunting) for part in (found.mean, found.worst))]


def peer_cells(peer):
    time = " … ".join(figure(time) for time in peer.microseconds) if peer.milliseconds else "not reported"
    errors = ("0 by definition", "") if not peer.mean.any() else (percent(peer.mean), percent(peer.worst))
    return [f"{peer.name} ({SOURCE})", "", time, *errors, "", ""]


def readme(effort):
    """The table of the README, and a line on the machine."""
    measured = measure(rows.all_rows(effort), effort, short=True)
    lines = [line(HEADER), rule(HEADER), *map(line, map(cells, measured)), *map(line, map(peer_cells, PEERS))]
    return "\n".join([*lines, "", machine.description()])


def skip_table(effort):
    found = list(skips.all_skips(effort))
    for skip in found * effort.passes:
        skip.measure(effort.rounds)
    return markdown("What is not requested is not computed",
                    ["skipped", "units", "full cost", "share", "answer"],
                    [[skip.name, figure(skip.less.units), figure(skip.more.units),
                      f"{100 * skip.less.units / skip.more.units:.0f} %", skip.answer] for skip in found])


def count_table(effort):
    return markdown("Work per pose", *counts.table(effort.count))


def growth_table(effort):
    numbers = growth.NUMBERS[:4] if effort.passes == 1 else growth.NUMBERS
    return markdown("Growth with the number of wheelsets, evaluate_many, random poses with yaw",
                    ["wheelsets", "units each", "µs each"],
                    [[f"{number:,}", figure(cost.units), figure(cost.microseconds)]
                     for number, cost in growth.wheelsets(numbers, effort.passes * effort.rounds)])


def thread_table(effort):
    found = growth.threads(10 * effort.count, effort.passes * effort.rounds)
    return markdown(f"Growth with threads, each with its own stepper; load average "
                    f"{machine.load_average():.1f}",
                    ["threads", "µs a wheelset", "speed-up"],
                    [[count, figure(1e6 * seconds), f"{gain:.2f}"] for count, seconds, gain in found])


def random_part(options):
    if not options.quick:
        return random_poses.compared(RANDOM if options.random is None else options.random)
    with tempfile.TemporaryDirectory() as folder:
        return random_poses.compared(options.random or QUICK_RANDOM, store=Path(folder) / "random_poses.csv")


if __name__ == "__main__":
    main()
