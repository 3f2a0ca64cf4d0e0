"""Long tests whose cases take turns: ``.ci/run`` takes some of them, other ones each day."""

import zlib
from collections import defaultdict


def out_of_turn(items, turn):
    """Cases of tests with the mark ``turns(n)`` that belong to another of n turns.  Every turn has a case of
    every test, and n turns have all cases."""
    cases = defaultdict(list)
    for item in items:
        if item.get_closest_marker("turns"):
            cases[item.nodeid.partition("[")[0]].append(item)
    for name, found in cases.items():
        n = min(found[0].get_closest_marker("turns").args[0], len(found))
        first = zlib.crc32(found[0].path.name.encode())  # not the same version of FMI in all files
        yield from (item for k, item in enumerate(found) if (k + turn + first) % n)
