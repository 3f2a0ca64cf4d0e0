"""Pages with generated tables: each stands between two comments,

    <!-- python -m benchmarks --write: NAME -->
    <!-- end: NAME -->

and is written anew from benchmarks/measured; what is between them by hand is lost.
"""

import re

from . import store
from .tables import TABLES, written

BEGIN, END = "<!-- python -m benchmarks --write: {} -->", "<!-- end: {} -->"
PATTERN = re.compile(r"<!-- python -m benchmarks --write: (\w+) -->\n.*?<!-- end: \1 -->", re.DOTALL)


def pages():
    """Texts of all pages with tables, by name, as they should be."""
    parts = {name: store.load(name) for name in sorted({name for table in TABLES.values()
                                                        for name in table.parts})}
    return {page: filled((store.ROOT / page).read_text(encoding="utf-8"), parts)
            for page in sorted({table.page for table in TABLES.values()})}


def filled(text, parts):
    """A page with its tables written from ``parts``.

    Raises
    ------
    KeyError
        if the page has a table that is not in tables.py.
    """
    return PATTERN.sub(lambda found: block(found[1], parts), text)


def block(name, parts):
    return "\n".join([BEGIN.format(name), written(TABLES[name], parts), END.format(name)])


def names(page):
    """Names of the tables that a page has, in their order."""
    return PATTERN.findall((store.ROOT / page).read_text(encoding="utf-8"))


def write():
    """Write all pages; return the names of those that changed."""
    changed = []
    for page, text in pages().items():
        path = store.ROOT / page
        if path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
            changed.append(page)
    return changed
