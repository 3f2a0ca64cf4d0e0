"""The folder of a fleet: what is done stands in it, line by line, so that an interrupted run continues."""

import json
import os
import zlib
from pathlib import Path

from ..results.words import plain
from ..storage.atomic import write_atomically
from .files import slug
from .page import page
from .table import empty_row

#: The rows that are done, one JSON a line; the table; the report; the folder of JSON and pictures.
ROW = empty_row().keys()
DONE, TABLE, REPORT, PAIRS = "fleet.jsonl", "fleet.csv", "report.html", "pairs"


class Folder:
    """A folder with the results of a fleet, made if it is not there."""

    def __init__(self, path):
        self.path = Path(path)
        (self.path / PAIRS).mkdir(parents=True, exist_ok=True)
        self._rows = dict(self._read())

    def _read(self):
        """(mark, row) of the pairs that earlier runs have done; a line that is damaged, or that a killed run has half
        written, is none."""
        try:
            lines = (self.path / DONE).read_text(encoding="utf-8", errors="replace").splitlines()
        except FileNotFoundError:
            return
        for line in lines:
            try:
                entry = json.loads(line)
                if entry["sum"] == _sum(entry["mark"], entry["row"]) and entry["row"].keys() == ROW:
                    yield entry["mark"], entry["row"]
            except (ValueError, LookupError, TypeError, AttributeError):
                continue

    def kept(self, mark, pictures):
        """The row of an earlier run of the same pair, whose files are there; None if it is to be done."""
        row = self._rows.get(mark)
        wanted = row and (row["json"], row["picture"] or (_is_drawn(row, pictures) and "none drawn yet"))
        return row if row and all((self.path / name).is_file() for name in wanted if name) else None

    def add(self, mark, row, text, drawn):
        """Write what one pair has given, and return its row with the names of the files."""
        stem = f"{PAIRS}/{slug(row['wheel'])}__{slug(row['rail'])}"
        for kind, name, content in (("json", "json", text and text.encode()), ("picture", "png", drawn)):
            if content:
                row[kind] = f"{stem}.{name}"
                write_atomically(self.path / row[kind], content)
        try:
            with open(self.path / DONE, "a", encoding="utf-8") as file:
                # an empty line ends one that was cut off
                file.write("\n" + _line(mark, row))
        except OSError as problem:  # of a full disk there is no name
            problem.filename = os.fspath(self.path / DONE)
            raise
        return row

    def finish(self, marks, fleet):
        """Write the report and the table of a ``fleet``, and the rows in their order; path of the report."""
        lines = (_line(mark, row) for mark, row in zip(marks, fleet.rows))
        write_atomically(self.path / DONE, "".join(lines).encode())
        write_atomically(self.path / TABLE, fleet.csv_text().encode())
        write_atomically(self.path / REPORT, page(fleet).encode())
        return os.fspath(self.path / REPORT)


def _is_drawn(row, pictures):
    """Whether a pair has a picture."""
    return pictures == "all" or pictures == "remarks" and bool(row["remarks"])


def _line(mark, row):
    row = plain(row)
    return json.dumps({"mark": mark, "row": row, "sum": _sum(mark, row)}) + "\n"


def _sum(mark, row):
    """A number by which a change of a line is seen."""
    return zlib.crc32(json.dumps([mark, row]).encode())
