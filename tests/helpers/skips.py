"""Which tests .ci/run may skip: a run with WRCONTACT_SKIPS=listed fails if it skips another one."""

import os
from importlib.util import find_spec

#: Part of the reason that a skipped test gives, and why its test need not run there.
PERMITTED = {
    "wine is not installed": "wine has half a gigabyte; libraries for Windows are read by lief, and run by the nightly tests",
    "fmpy builds by CMake": "the same sources are compiled by gcc from what the archive says, in the test beside it",
    "exudyn is not installed": "the README's commands do without it; the full tests, where it is installed, run the vehicle",
    "drake is not installed": "as exudyn; each week the full tests install it, where Drake has a package for the machine",
    "mujoco is not installed": "as exudyn; each week the full tests install it",
    "linked statically and has no libpython": "another Python is there, which runs the same test",
    "with whose values others are compared": "a machine that is no x86_64 Linux has no reference of its own",
}


#: Packages that the README's command does not install.  .ci/run does, before the full tests.
LATER = ("zarr", "xarray", "pandas")


def permitted(reason, keywords):
    """Whether a test with these keywords may be skipped for this reason."""
    later = "platforms" in keywords and not find_spec("ziglang")  # .ci/run installs it and runs them then
    if os.environ.get("WRCONTACT_IMPORTERS") != "all":
        later = later or any(f"No module named '{name}'" in reason for name in LATER)
    return later or any(part in reason for part in PERMITTED)


def unlisted(reports):
    """A line for each of pytest's reports of skipped tests that may not be skipped."""
    lines = set()
    for report in reports:
        *place, reason = report.longrepr if isinstance(report.longrepr, tuple) else (str(report.longrepr),)
        if not permitted(reason, getattr(report, "keywords", ())):  # a file has none
            lines.add(f"{report.nodeid}: {reason}")
    return sorted(lines)
