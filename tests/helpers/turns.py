"""What ``.ci/run`` runs today: of long tests with many cases that are alike a share, another one each day, and what
depends on few files where one of these has changed, else once a week.

WRCONTACT_TURN is the day's number; without it everything runs.  WRCONTACT_CHANGED names a file with the paths that
have changed, a line each; without it everything has changed.
"""

import os
import subprocess
import zlib
from collections import defaultdict
from pathlib import Path

#: What an FMU is made of, without the kernel's numbers: other tests read those.
FMUS = ("fmu_src/", "wrcontact/fmu/", "wrcontact/interface/", "wrcontact/kernel/binding/")
#: What another machine's compiler and loader might do otherwise.
MACHINES = (
    "build_hooks/",
    "fmu_src/",
    "pyproject.toml",
    "wrcontact/kernel/binding/",
    "wrcontact/kernel/native/",
)
#: Steps of .ci/run, folders, files and single tests that run where a path that starts with one of these has changed,
#: or else once a week.  Each depends on itself, too; of two rows that name a test the longer one counts.
WEEKLY = {
    "benchmarks": ("wrcontact/study/", "wrcontact/progress/"),
    "platforms": (  # not for each change of the kernel: its C is the same for all
        *MACHINES,
        "tests/helpers/platforms.py",
        "tests/release/",
        "tools/release",
    ),
    "tests/benchmarks/": ("benchmarks/",),
    "tests/creep/test_models.py::test_the_moment_of_polach_is_small": ("wrcontact/kernel/creep/polach",),
    "tests/docs/test_gallery.py": ("docs/guides/gallery.md", "wrcontact/plots/"),
    "tests/docs/test_site.py": ("docs/site.css", "mkdocs.yml", "tools/site_"),
    "tests/docs/test_tables.py::test_errors_are_those_of_today[worn_pairs]": (
        "benchmarks/worn_pairs.py",
        "data/worn_",
    ),
    "tests/docs/test_tables.py::test_studies_are_those_of_today": ("benchmarks/", "wrcontact/study/"),
    "tests/docs/test_tables.py::test_worst_steps_are_those_of_today": ("benchmarks/worst.py",),
    "tests/docs/test_types.py": (
        "tools/make_fields.py",
        "wrcontact/__init__.py",
        "wrcontact/interface/",
        "wrcontact/keywords.py",
        "wrcontact/results/",
    ),
    "tests/elementary/test_digests.py": ("tests/helpers/digests.py", "wrcontact/kernel/elementary/"),
    "tests/faults/": ("tests/helpers/fmu_process.py", "wrcontact/fmu/", "wrcontact/storage/"),
    "tests/fmu/native/test_building.py": MACHINES,
    "tests/fmu/native/test_c_host.py": (*FMUS, "tests/fmu/native/host.c"),
    "tests/fmu/native/test_page_in_c.py": (*FMUS, "docs/guides/fmu_hosts.md"),
    "tests/fmu/test_importers.py": (*FMUS, "tests/helpers/importer_process.py"),
    "tests/fmu/test_long_runs.py": FMUS,
    "tests/fmu/test_platforms.py": (*MACHINES, "tests/helpers/platforms.py"),
    "tests/fmu/test_wheels.py": (*MACHINES, "tests/helpers/platforms.py"),
    "tests/halfspace/": ("data/creep/", "tests/helpers/creep.py", "wrcontact/halfspace/"),
    "tests/loop/": ("examples/", "wrcontact/motion/"),
    "tests/motion/test_engines.py": ("examples/engines/", "wrcontact/motion/"),
    "tests/motion/test_vehicle.py": ("examples/vehicle", "wrcontact/motion/"),
    "tests/structure/test_ci.py::test_a_run_of_ci_fails": (
        ".ci/",
        "tests/conftest.py",
        "tests/helpers/skips.py",
    ),
    "tests/structure/test_ci.py::test_cases_take_turns": (
        ".ci/",
        "tests/conftest.py",
        "tests/helpers/turns.py",
    ),
    "tests/study/": ("wrcontact/study/",),
    "tests/sweeps/test_cluster.py": ("wrcontact/sweeps/",),
}
WEEK = 7
#: Environment variable: a file with the paths that have changed, a line each.
CHANGED = "WRCONTACT_CHANGED"


def changed_paths(root):
    """Paths that differ from those of a day before the last commit, by git; None if git cannot tell, as in a copy
    without history.  What a branch has and its main branch has not counts, too, however old it is."""

    def git(*words):
        done = subprocess.run(["git", *words], cwd=root, capture_output=True, text=True)
        return done.stdout.strip() if done.returncode == 0 else ""

    head = git("show", "-s", "--format=%ct", "HEAD")
    before = head and git("rev-list", "-1", "--first-parent", f"--before={int(head) - 24 * 3600}", "HEAD")
    if not before:
        return None
    fork = git("merge-base", "HEAD", "origin/main")
    seen = [git("diff", "--name-only", "--no-renames", commit) for commit in (before, fork) if commit]
    return sorted({path for paths in seen for path in paths.splitlines()})


def changed_today():
    """The paths that WRCONTACT_CHANGED tells; None without it."""
    file = os.environ.get(CHANGED)
    return Path(file).read_text(encoding="utf-8").splitlines() if file else None


def due(name, turn, changed):
    """Whether a step, or a test by its file or its node's name, runs in this turn; ``changed`` is None if that is not
    known."""
    rows = [row for row in WEEKLY if name.startswith(row)]
    if not rows or changed is None:
        return True
    row = max(rows, key=len)
    places = (row.partition("::")[0], *WEEKLY[row])
    return (turn + zlib.crc32(row.encode())) % WEEK == 0 or any(path.startswith(places) for path in changed)


def out_of_turn(items, turn, root, changed=None):
    """Tests of another day: those of files that are not due, and cases of tests with the mark ``turns(n)`` that
    belong to another of n turns.  Every turn has a case of every such test, and n turns have all cases."""
    cases = defaultdict(list)
    for item in items:
        place = item.path.relative_to(root).as_posix() if root in item.path.parents else ""
        if not due(f"{place}::{item.name}", turn, changed):
            yield item
        elif item.get_closest_marker("turns"):
            cases[item.nodeid.partition("[")[0]].append(item)
    for name, found in cases.items():
        n = min(found[0].get_closest_marker("turns").args[0], len(found))
        first = zlib.crc32(found[0].path.name.encode())  # not the same version of FMI in all files
        yield from (item for k, item in enumerate(found) if (k + turn + first) % n)
