"""Measured numbers as they are kept in benchmarks/measured, one file per part, and the commit they are of."""

import json
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[1]
FOLDER = Path(__file__).with_name("measured")
DIGITS = 4  # significant digits that are kept
#: What decides about the numbers; changes elsewhere do not count as changes.
SOURCES = ("wrcontact", "fmu_src", "benchmarks/*.py", "data")


def commit():
    """Short name of the commit that is checked out, with "and changes" if the sources differ from it."""
    try:
        name = git("rev-parse", "--short=7", "HEAD").strip()
        changed = git("status", "--porcelain", "--", *SOURCES).strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return f"{name} and changes" if changed else name


def git(*words):
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def path(part):
    return FOLDER / f"{part.replace(' ', '_')}.json"


def headed(rows, conditions):
    """What is kept of a part: its ``rows`` (a dict of dicts), their commit, and the ``conditions`` in
    words."""
    return {"commit": commit(), **conditions, "rows": short(rows)}


def save(part, rows, conditions):
    """Write what is kept of a part."""
    head = headed(rows, conditions)
    rows = head.pop("rows")
    lines = [f"{json.dumps(name)}: {json.dumps(value, ensure_ascii=False)}" for name, value in head.items()]
    body = ",\n".join(f"  {json.dumps(name, ensure_ascii=False)}: {json.dumps(row, ensure_ascii=False)}"
                      for name, row in rows.items())
    FOLDER.mkdir(exist_ok=True)
    text = "{" + ",\n".join([*lines, '"rows": {\n' + body + "\n}"]) + "}\n"
    path(part).write_text(text, encoding="utf-8")


def load(part):
    """What :func:`save` wrote: a dict with "commit", the conditions, and "rows"."""
    return json.loads(path(part).read_text(encoding="utf-8"))


def short(value, digits=DIGITS):
    """Numbers with so many significant digits, also within lists and dicts; numpy's become Python's."""
    if isinstance(value, dict):
        return {name: short(each, digits) for name, each in value.items()}
    if isinstance(value, str | bool | int):
        return value
    if hasattr(value, "__iter__"):
        return [short(each, digits) for each in value]
    return float(f"{float(value):.{digits}g}")
