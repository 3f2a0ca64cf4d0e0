"""Write the tables of docs/guides/profiles_of_the_world.md: ``python docs/make_pages.py profiles``."""

import re
from pathlib import Path

from wrcontact.profiles.standards import standards

PAGE = Path(__file__).resolve().parent / "guides" / "profiles_of_the_world.md"
TABLE = re.compile(r"(<!-- table: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)


def page():
    """The page with its tables as the catalogue has them."""
    return TABLE.sub(lambda found: found[1] + table(found[2]) + found[3], PAGE.read_text(encoding="utf-8"))


def table(kind):
    """The table of "rails" or "wheels" in Markdown."""
    shape = (
        "head: radius up to half-width [mm], side"
        if kind == "rails"
        else "zones from the back of the flange to the field side"
    )
    lines = [
        f"| name | also | {shape} | standard | sources | read from | remark |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, entry in standards()[kind].items():
        year = f":{entry['year']}" if entry["year"] else ""
        cells = (
            name,
            ", ".join(entry.get("also", ())),
            head(entry) if "arcs" in entry else zones(entry),
            entry["standard"] + year,
            str(entry["sources"]),
            entry["origin"],
            entry.get("note", ""),
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def head(entry):
    """The arcs of a rail's head in words."""
    arcs = [f"R{radius:g} to {stop:g}" if stop else f"R{radius:g}" for radius, stop in entry["arcs"]]
    side = "vertical" if entry["side"] == 1000 else f"1:{entry['side']:g}"
    return f"{', '.join(arcs)}; {side}"


def zones(entry):
    """The families of an entry's zones in words."""
    words = [
        f"R{row[3]:g}" if row[0] == "arc" else {"line": "line", "series": "polynomial"}[row[0]]
        for row in entry["zones"]
    ]
    return ", ".join(words)
