"""The array that the kernel reads, from definitions of the profiles and the parameters: what ContactSystem and the native FMU
do at the start, outside the hot unit.

The recipe: place the rail, cut the wheel, compile both, and lay the tables one after the other; then the kernel itself fills
the table of starts (``start_shift`` and ``keep_start``), and last come the methods (``write_methods``).
"""

from math import atan
from typing import Final

from ..layout import (
    DEPTH_ALL,
    OUT_LEFT,
    OUT_RIGHT,
    OUT_ROLL,
    SET_HERTZ,
    SET_INFLUENCE,
    SETTING_COUNT,
    SIDE_Y_WHEEL,
    SIDES_BOTH,
    STATION_COUNT,
    UNLOADED,
    Profile,
    Tables,
)
from ..search.starts import (
    START_COUNT,
    START_FIRST,
    START_KNOWN,
    START_LEFT,
    START_PER_METRE,
    START_RIGHT,
    START_ROLL,
    START_ROW,
    START_ROWS,
)
from .curvatures import write_curvatures
from .pieces import FULL, MM, write_profile
from .placement import highest_point, inner_face, keep_around_top, turn_zones
from .scan import TOO_WIDE, write_scan
from .zones import DEFINITION_COUNT, DEFINITION_ROW, DEFINITION_ZONES

# the setup: parameters as numbers, SI
SETUP_INCLINATION: Final[int] = 0
SETUP_GAUGE: Final[int] = 1
SETUP_GAUGE_DEPTH: Final[int] = 2
SETUP_CIRCLE_DISTANCE: Final[int] = 3
SETUP_RADIUS: Final[int] = 4
SETUP_YOUNGS_MODULUS: Final[int] = 5
SETUP_POISSON_RATIO: Final[int] = 6
SETUP_CURVATURE_STEP: Final[int] = 7
SETUP_CURVATURE_REACH: Final[int] = 8
SETUP_NODES: Final[int] = 9
SETUP_STRIDE: Final[int] = 10
SETUP_STRIPS: Final[int] = 11
SETUP_SWEEPS: Final[int] = 12
SETUP_MODE: Final[int] = 13
SETUP_LOAD: Final[int] = 14
SETUP_NORMAL_MODEL: Final[int] = 15
SETUP_SEPARATION: Final[int] = 16
SETUP_LONGITUDINAL: Final[int] = 17
SETUP_LATERAL: Final[int] = 18
SETUP_NAN: Final[int] = 19           # not a number
SETUP_SIZE: Final[int] = 20

# what became of it
PREPARED: Final[int] = 0
TABLES_FULL: Final[int] = 1          # more room is needed
GAUGE_TOO_DEEP: Final[int] = 2       # the rail's inner side ends before the gauge depth
WITHOUT_HEAD: Final[int] = 3         # a profile has nothing readable at its origin
WHEEL_TOO_WIDE: Final[int] = 4

# the report
REPORT_SIZE: Final[int] = 0          # how much of the tables is used
REPORT_DEEPEST: Final[int] = 1       # where the rail's inner side ends [m]
REPORT_WIDTH: Final[int] = 2         # of the wheel [m]
REPORT_DEPTH: Final[int] = 3         # how deep the gauge is measured, in the same frame [m]
REPORT_COUNT: Final[int] = 4

#: Range of the inputs; beyond it the contact leaves the profiles' running surfaces.
LATERAL_LIMIT: Final[float] = 0.015  # [m]
YAW_LIMIT: Final[float] = 0.12       # [rad]
START_STEP: Final[float] = 0.5e-3    # [m] of the lateral shifts for which a start of the roll search is kept
START_ROW_COUNT: Final[int] = 61
STARTS_EACH_METRE: Final[float] = 2000.0


def copy_definition(definition: 'float[:]', work: 'float[:]', at: int):
    """Copy a definition into the workspace; the offset after it."""
    size = DEFINITION_ZONES + int(definition[DEFINITION_COUNT]) * int(definition[DEFINITION_ROW])
    for i in range(size):
        work[at + i] = definition[i]
    return at + size


def place_zones(setup: 'float[:]', work: 'float[:]', wheel: int, rail: int, tables: Tables, report: 'float[:]'):
    """Cut the wheel's and place the rail's definition in the workspace, and note where the rail stands; the outcome."""
    angle = -atan(setup[SETUP_INCLINATION])
    y_top, z_top = highest_point(work, rail, angle)
    depth = z_top + setup[SETUP_GAUGE_DEPTH] / MM
    y_gauge, reached = inner_face(work, rail, angle, depth)
    if reached < depth:
        report[REPORT_DEEPEST] = reached * MM
        report[REPORT_DEPTH] = depth * MM
        return GAUGE_TOO_DEEP
    tables.rail_y = setup[SETUP_GAUGE] / 2.0 + (y_top - y_gauge) * MM
    turn_zones(work, rail, angle, -y_top, -z_top)
    turn_zones(work, wheel, 0.0, 0.0, 0.0)
    if keep_around_top(work, rail) == 0 or keep_around_top(work, wheel) == 0:
        return WITHOUT_HEAD
    return PREPARED


def write_settings(setup: 'float[:]', tables: Tables):
    """The settings that are known from the beginning, with each method's first choice."""
    tables.radius = setup[SETUP_RADIUS]
    tables.arm = 0.5 * setup[SETUP_CIRCLE_DISTANCE]
    nu = setup[SETUP_POISSON_RATIO]
    tables.contact_modulus = setup[SETUP_YOUNGS_MODULUS] / (2.0 * (1.0 - nu * nu))
    tables.lateral_limit = LATERAL_LIMIT
    tables.yaw_limit = YAW_LIMIT
    tables.nodes = setup[SETUP_NODES]
    tables.stride = setup[SETUP_STRIDE]
    tables.strips = setup[SETUP_STRIPS]
    tables.sweeps = setup[SETUP_SWEEPS]
    tables.penetration[0] = setup[SETUP_NAN]
    tables.penetration[1] = setup[SETUP_NAN]
    tables.sides = float(SIDES_BOTH)
    tables.depth = float(DEPTH_ALL)
    tables.absent = setup[SETUP_NAN]
    tables.stations = float(STATION_COUNT)
    return 0


def write_methods(setup: 'float[:]', tables: Tables):
    """The chosen methods."""
    tables.mode = setup[SETUP_MODE]
    tables.load = setup[SETUP_LOAD]
    tables.normal_model = setup[SETUP_NORMAL_MODEL]
    tables.separation = setup[SETUP_SEPARATION]
    tables.longitudinal = setup[SETUP_LONGITUDINAL]
    tables.lateral = setup[SETUP_LATERAL]
    return 0


def append(tables: 'float[:]', at: int, setting: int, table: 'float[:]'):
    """Copy a whole table to ``at`` and note that; the offset after it, or FULL."""
    size = table.shape[0]
    if at + size > tables.shape[0]:
        return FULL
    tables[setting] = float(at)
    for i in range(size):
        tables[at + i] = table[i]
    return at + size


def append_starts(tables: Tables, at: int):
    """A table of starts with nothing known at ``at``; the offset after it, or FULL."""
    size = START_ROWS + START_ROW * START_ROW_COUNT
    if at + size > tables.raw.shape[0]:
        return FULL
    tables.starts = float(at)
    for i in range(size):
        tables[at + i] = 0.0
    tables[at + START_COUNT] = float(START_ROW_COUNT)
    tables[at + START_FIRST] = -LATERAL_LIMIT
    tables[at + START_PER_METRE] = STARTS_EACH_METRE
    return at + size


def prepare(setup: 'float[:]', wheel_definition: 'float[:]', rail_definition: 'float[:]', hertz: 'float[:]',
            influence: 'float[:]', tables: Tables, work: 'float[:]', report: 'float[:]'):
    """Everything but starts and methods into ``tables``; the outcome.  The workspace holds both definitions and as much again
    as the tables."""
    kind = int(setup[SETUP_LATERAL])
    for i in range(SETTING_COUNT):
        tables[i] = 0.0
    rail_zones = copy_definition(wheel_definition, work, 0)
    scratch = copy_definition(rail_definition, work, rail_zones)
    outcome = place_zones(setup, work, 0, rail_zones, tables, report)
    if outcome != PREPARED:
        return outcome
    write_settings(setup, tables)
    wheel = SETTING_COUNT
    tables.wheel = wheel
    rail = write_profile(tables.raw, wheel, work, 0, setup[SETUP_NAN], work, scratch)
    if rail == FULL:
        return TABLES_FULL
    tables.rail = rail
    at = write_profile(tables.raw, rail, work, rail_zones, setup[SETUP_NAN], work, scratch)
    if at == FULL:
        return TABLES_FULL
    tables.scan = float(at)
    at = write_scan(tables, at, wheel, rail, work, scratch)
    if at == TOO_WIDE:
        report[REPORT_WIDTH] = Profile.at(tables, wheel).stop - Profile.at(tables, wheel).start
        return WHEEL_TOO_WIDE
    if at != FULL:
        at = append(tables.raw, at, SET_HERTZ, hertz)
    if at != FULL:
        at = append(tables.raw, at, SET_INFLUENCE, influence)
    if at != FULL:
        at = append_starts(tables, at)
    if at != FULL:
        tables.wheel_curvature = at
        at = write_curvatures(tables.raw, at, wheel, -1.0, kind, setup[SETUP_CURVATURE_STEP], setup[SETUP_CURVATURE_REACH],
                              work, scratch)
    if at != FULL:
        tables.rail_curvature = at
        at = write_curvatures(tables.raw, at, rail, 1.0, kind, setup[SETUP_CURVATURE_STEP], setup[SETUP_CURVATURE_REACH],
                              work, scratch)
    if at == FULL:
        return TABLES_FULL
    report[REPORT_SIZE] = float(at)
    return PREPARED


def start_shift(tables: Tables, row: int):
    """Lateral shift [m] of a row of the table of starts."""
    base = int(tables.starts)
    return tables[base + START_FIRST] + float(row) / tables[base + START_PER_METRE]


def note_start(rows: 'float[:]', row: int, status: int, outputs: 'float[:]'):
    """Note in ``rows`` where the wheelset of a row stands, if it does."""
    at = START_ROW * row
    if status <= UNLOADED:
        rows[at + START_KNOWN] = 1.0
        rows[at + START_ROLL] = outputs[OUT_ROLL]
        rows[at + START_LEFT] = outputs[OUT_LEFT + SIDE_Y_WHEEL]
        rows[at + START_RIGHT] = outputs[OUT_RIGHT + SIDE_Y_WHEEL]
    return 0


def keep_starts(tables: Tables, rows: 'float[:]'):
    """Put all rows in their place; not before the last one is known, as the kernel reads them."""
    base = int(tables.starts) + START_ROWS
    for i in range(START_ROW * START_ROW_COUNT):
        tables[base + i] = rows[i]
    return 0
