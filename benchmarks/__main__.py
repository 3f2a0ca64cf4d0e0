"""Run time and error of everything that is measured, as the tables of README and docs.

    python -m benchmarks [KIND or PART ...]             measure and print
    python -m benchmarks --write [KIND or PART ...]     measure, keep in benchmarks/measured, write the pages

Kinds are errors (quick, the same in every run), times and studies (long); without any, all is measured.
docs/evidence/benchmarks.md explains what is measured.  The unit of times is that of ``np.sqrt`` of 2000
doubles, so that results of two machines can be compared.  A time is the smallest of several rounds, since
disturbances only add time.
"""

import argparse
import sys
import tempfile
from pathlib import Path

from wrcontact.plots import style
from wrcontact.progress import tracked

from . import pages, parts, random_poses, record, rows
from .pages import TABLES, written
from .tables import random_table

QUICK_RANDOM = 4


def main(arguments=None):
    options = parsed(arguments)
    if options.random is not None:
        print(random_part(options.random, options.quick))
        return
    names = [name for name in parts.named(options.what) if name not in options.without]
    if options.write:
        parts.write([] if options.render else names, rows.FULL)
        style.save(pages.figure(pages.stored_points()), record.ROOT / pages.PATH)
        style.save(pages.creep_figure(*pages.stored_creep()), record.ROOT / pages.CREEP_PATH)
        for page in pages.write():
            print(page, file=sys.stderr)
        return
    effort = rows.QUICK if options.quick else rows.FULL
    measured = {name: record.headed(*parts.measured(name, effort)) for name in tracked(names, "measurements")}
    for name, table in TABLES.items():
        if set(table.parts) <= set(measured):
            print(f"### {name}\n\n{written(table, measured)}\n", flush=True)
    if options.quick and not options.what:
        print(random_part(QUICK_RANDOM, quick=True))


def parsed(arguments):
    parser = argparse.ArgumentParser(
        "python -m benchmarks", description="Run time and error; see docs/evidence/benchmarks.md."
    )
    parser.add_argument(
        "what",
        nargs="*",
        metavar="KIND or PART",
        help=f"{', '.join(parts.KINDS)}, or: {', '.join(parts.PARTS)}",
    )
    parser.add_argument(
        "--without", nargs="+", default=[], metavar="KIND or PART", help="measure all others of these"
    )
    parser.add_argument(
        "--write",
        action="store_true",
        help="keep what is measured in benchmarks/measured, and write the tables of all "
        "pages and the pictures from what is kept",
    )
    parser.add_argument("--render", action="store_true", help="with --write: without measuring anything")
    parser.add_argument(
        "--quick",
        action="store_true",
        help="few poses and rounds, to test that everything runs; nothing is kept",
    )
    parser.add_argument(
        "--random",
        metavar="N",
        type=int,
        default=None,
        help="compare N random poses with the half-space, about 0.1 s each on two free "
        f"cores; results are kept in {random_poses.STORE}, so that an interrupted run can be "
        "continued",
    )
    options = parser.parse_args(arguments)
    if options.write and options.quick:
        parser.error("a quick run is not written")
    try:
        parts.named(options.what)
        options.without = parts.named(options.without) if options.without else []
    except ValueError as refusal:
        parser.error(str(refusal))
    return options


def random_part(count, quick):
    """The table of ``count`` random poses; a quick one solves them all."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "random_poses.csv") if quick else random_poses.STORE
        return random_table(
            {"random_poses": {"rows": random_poses.compared(random_poses.references(count, path))}}
        )


if __name__ == "__main__":
    main()
