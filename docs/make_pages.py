"""Write what is generated: numbers, names and tables of pages, types, value references.

    python docs/make_pages.py               (``make pages``) all that is exact and quick: references, types, names,
                                            options, tables from the measurements that are kept
    python docs/make_pages.py --check       write nothing; exit code 1 if a file is not what would be written
    python docs/make_pages.py NAME ...      only these, also what is measured or drawn anew, which takes minutes
                                            to an hour: errors, studies, times, digests, closed_loop, vehicle, wear,
                                            pictures

CI compares what is exact.  Times are those of a machine, and are written when they are measured.
"""

import argparse
import runpy
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT))

from benchmarks import pages  # noqa: E402
from tools import make_fields  # noqa: E402
from wrcontact.fmu.description3 import variable_blocks  # noqa: E402
from wrcontact.interface.references import LIST, STORED  # noqa: E402
from wrcontact.interface.variables import REFERENCE  # noqa: E402


def references():
    """Value references of new variables, appended to the list."""
    two = {name: number for name, number in REFERENCE.items() if name not in STORED[2]}
    three = {b.name: b.reference for b in variable_blocks() if b.name not in STORED[3]}
    missing = [f"{name},{two.get(name, '')},{three.get(name, '')}\n" for name in {**two, **three}]
    return {LIST: LIST.read_text(encoding="utf-8") + "".join(missing)}


def types():
    return make_fields.files()


def names():
    script = runpy.run_path(str(ROOT / "docs" / "make_nomenclature.py"))
    return {script["PAGE"]: script["page"]()}


def options():
    script = runpy.run_path(str(ROOT / "docs" / "make_reference.py"))
    return {script["COMMAND_LINE"]: script["command_line"](), script["STATUSES"]: script["statuses"]()}


def profiles():
    script = runpy.run_path(str(ROOT / "docs" / "make_profiles.py"))
    return {script["PAGE"]: script["page"]()}


def tables():
    return {ROOT / page: text for page, text in pages.pages().items()}


#: Functions that give {file: text}, by name.
EXACT = {each.__name__: each for each in (references, types, names, options, profiles, tables)}
#: Words after ``python`` for what is measured or drawn anew.
MEASURED = {
    **{kind: ("-m", "benchmarks", "--write", kind) for kind in ("errors", "studies", "times")},
    "digests": ("-m", "tests.helpers.digests", "--write"),
    **{name: (f"docs/make_{name}.py",) for name in ("closed_loop", "vehicle", "wear", "pictures")},
}


def changed(texts):
    """Those of {file: text} whose file has another text."""
    return {
        path: text
        for path, text in texts.items()
        if not path.exists() or path.read_text(encoding="utf-8") != text
    }


def main(arguments=None):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join([*EXACT, *MEASURED]))
    parser.add_argument("--check", action="store_true", help="write nothing")
    given = parser.parse_args(arguments)
    if unknown := set(given.names) - {*EXACT, *MEASURED}:
        parser.error(f"there is no {', '.join(sorted(unknown))}; known are {', '.join([*EXACT, *MEASURED])}")
    if given.check and (measured := set(given.names) & set(MEASURED)):
        parser.error(f"{', '.join(sorted(measured))} cannot be checked here: the tests compare what is exact")
    for name in given.names:
        if name in MEASURED:
            subprocess.run([sys.executable, *MEASURED[name]], cwd=ROOT, check=True)
    found = {}
    for name in [name for name in given.names if name in EXACT] or ([] if given.names else EXACT):
        found |= changed(EXACT[name]())
    for path, text in found.items():
        print(f"{path.relative_to(ROOT)} {'is not what is written' if given.check else 'is written anew'}")
        if not given.check:
            path.write_text(text, encoding="utf-8")
    return 1 if given.check and found else 0


if __name__ == "__main__":
    sys.exit(main())
