"""The array that the kernel reads, from definitions of the profiles and the parameters: what ContactSystem
and the native FMU do at the start, outside the hot unit.

The recipe (``prepare``): settings, tables that do not depend on the profiles, then of each side the wheel,
the rail and the raster over both (``write_wheel``, ``write_rail``, ``write_scan``); a left wheel or rail that
equals the right one shares its tables. Then the kernel itself fills the table of starts (``start_shift`` and
``note_start``), and last come the methods (``write_methods``).

Tables that do not depend on the profiles come from the array ``fixed`` (binding/fixed_tables.py).  It begins
with the sizes of its tables: Hertz's, that of influences, and that of rolling for all Poisson's ratios
(tools/tables/rolling_table.py).  The tables follow one after the other.
"""

from typing import Final

from ..elementary.circle import atan
from ..layout import (
    CORRECTION_RADII,
    CORRECTION_SCALES,
    CORRECTION_SIZE,
    CORRECTION_SLOPES,
    DEPTH_ALL,
    LATERAL_LIMIT,
    MODEL_ANALYN_STRIP,
    MODEL_AUTO,
    POINT_LIMIT,
    REACH_CELLS,
    REACH_COLUMNS,
    REACH_ROW,
    ROLLING_TABLE_SIZE,
    SETTING_COUNT,
    SHAPE_CELLS,
    SHAPE_ROW,
    SIDES_BOTH,
    STARTS_SIZE,
    START_COUNT,
    STATION_COUNT,
    TANGENTIAL_NONE,
    UNLOADED,
    WAVES_SIZE,
    YAW_LIMIT,
    CubicTable,
    CurvatureTable,
    Outputs,
    Pair,
    Profile,
    RollingTable,
    Setup,
    Tables,
    clear,
    copy,
    offset,
)
from ..surface.rails import is_sprung
from .curvatures import write_abscissae, write_arcs, write_curvatures
from .pieces import FULL, MM, write_profile
from .scan import write_scan
from .scan_bends import write_scan_bends
from .waves import write_waves
from .zones import (
    DEFINITION_COUNT,
    DEFINITION_ROW,
    DEFINITION_WORN,
    DEFINITION_ZONES,
    highest_point,
    inner_face,
    keep_around_top,
    turn_zones,
)

FIXED_HERTZ: Final[int] = 0
FIXED_INFLUENCE: Final[int] = 1
FIXED_ROLLING: Final[int] = 2
FIXED_COUNT: Final[int] = 3

#: Poisson's ratios of Kalker's table (wrcontact/creep/kalker_table.py).
LOW_RATIO: Final[float] = 0.0
MIDDLE_RATIO: Final[float] = 0.25
HIGH_RATIO: Final[float] = 0.5
#: Poisson's ratios of the corrections; below and above they are those of the ends.
FIRST_CORRECTION: Final[float] = 0.25
SECOND_CORRECTION: Final[float] = 0.28
THIRD_CORRECTION: Final[float] = 0.30
# in place of an offset, beside FULL (pieces.py) and TOO_WIDE (scan.py)
GAUGE_TOO_DEEP: Final[int] = -3  # the rail's inner side ends before the gauge depth
WITHOUT_HEAD: Final[int] = -4  # a profile has nothing readable at its origin

START_STEP: Final[float] = 0.5e-3  # [m] of the lateral shifts for which a start of the roll search is kept
STARTS_EACH_METRE: Final[float] = 2000.0


def fixed_table(fixed: "float[:]", index: int):
    """Where table ``index`` begins."""
    at = FIXED_COUNT
    for i in range(index):
        at += int(fixed[i])
    return at


def append_fixed(tables: "float[:]", at: int, fixed: "float[:]", index: int):
    """Copy table ``index`` to ``at``; the offset after it, or FULL."""
    size = int(fixed[index])
    if at + size > tables.shape[0]:
        return FULL
    first = fixed_table(fixed, index)
    for i in range(size):
        tables[at + i] = fixed[first + i]
    return at + size


def append_waves(tables: Tables, at: int, count: int):
    """The table for runs of ``count`` strips at ``at``, which ``tables`` already point to; the offset after
    it, or FULL."""
    if at + WAVES_SIZE > tables.raw.shape[0]:
        return FULL
    write_waves(tables.waves, count)
    return at + WAVES_SIZE


def parabola_weights(low: float, middle: float, high: float, x: float):
    """Weights of the values at three nodes in the parabola through them at ``x``."""
    return (
        (x - middle) * (x - high) / ((low - middle) * (low - high)),
        (x - low) * (x - high) / ((middle - low) * (middle - high)),
        (x - low) * (x - middle) / ((high - low) * (high - middle)),
    )


def append_rolling(tables: Tables, at: int, fixed: "float[:]", poisson_ratio: float):
    """The table of rolling at ``at`` for a Poisson's ratio, which ``tables`` already point to; the offset
    after it, or FULL."""
    if at + ROLLING_TABLE_SIZE > tables.raw.shape[0]:
        return FULL
    first = fixed_table(fixed, FIXED_ROLLING)
    for i in range(POINT_LIMIT):
        tables.rolling.cosines[i] = fixed[first + i]
        tables.rolling.sines[i] = fixed[first + POINT_LIMIT + i]
    first = write_shapes(tables.rolling, fixed, first + 2 * POINT_LIMIT, poisson_ratio)
    first = write_reaches(tables.rolling, fixed, first, poisson_ratio)
    write_corrections(tables.rolling, fixed, first, poisson_ratio)
    return at + ROLLING_TABLE_SIZE


def write_shapes(table: RollingTable, fixed: "float[:]", first: int, poisson_ratio: float):
    """The shapes, parabolas of Poisson's ratio, from ``first`` on; the place behind them."""
    size = SHAPE_ROW * SHAPE_CELLS
    low, middle, high = parabola_weights(LOW_RATIO, MIDDLE_RATIO, HIGH_RATIO, poisson_ratio)
    for i in range(size):
        table.shapes[i] = (
            low * fixed[first + i] + middle * fixed[first + size + i] + high * fixed[first + 2 * size + i]
        )
    return first + 3 * size


def write_reaches(table: RollingTable, fixed: "float[:]", first: int, poisson_ratio: float):
    """The reaches, eq. (K5) of tools/tables/rolling_table.py, from ``first`` on; the place behind them."""
    size = REACH_ROW * (REACH_CELLS + 1)
    for i in range(size):
        weight = poisson_ratio
        if i // 4 % REACH_COLUMNS == 0:
            weight = poisson_ratio / (1.0 - poisson_ratio)
        table.reaches[i] = fixed[first + i] + weight * fixed[first + size + i]
    return first + 2 * size


def write_corrections(table: RollingTable, fixed: "float[:]", first: int, poisson_ratio: float):
    """The corrections, parabolas of Poisson's ratio, from ``first`` on."""
    ratio = min(max(poisson_ratio, FIRST_CORRECTION), THIRD_CORRECTION)
    for i in range(CORRECTION_RADII):
        table.radii[i] = fixed[first + i]
    low, middle, high = parabola_weights(FIRST_CORRECTION, SECOND_CORRECTION, THIRD_CORRECTION, ratio)
    at = first + CORRECTION_RADII
    for i in range(CORRECTION_SCALES):
        table.scales[i] = (
            low * fixed[at + i]
            + middle * fixed[at + CORRECTION_SCALES + i]
            + high * fixed[at + 2 * CORRECTION_SCALES + i]
        )
    at += 3 * CORRECTION_SCALES
    for i in range(CORRECTION_SIZE):
        table.corrections[i] = (
            low * fixed[at + i]
            + middle * fixed[at + CORRECTION_SIZE + i]
            + high * fixed[at + 2 * CORRECTION_SIZE + i]
        )
    at += 3 * CORRECTION_SIZE
    for i in range(CORRECTION_SLOPES):
        table.slopes[i] = (
            low * fixed[at + i]
            + middle * fixed[at + CORRECTION_SLOPES + i]
            + high * fixed[at + 2 * CORRECTION_SLOPES + i]
        )


def copy_definition(definition: "float[:]", work: "float[:]", at: int):
    """Copy a definition into the workspace; the offset after it."""
    size = DEFINITION_ZONES + int(definition[DEFINITION_COUNT]) * int(definition[DEFINITION_ROW])
    for i in range(size):
        work[at + i] = definition[i]
    return at + size


def write_springs(setup: Setup, tables: Tables):
    """The springs below both rails."""
    right = tables.springs[1]
    right.lateral_stiffness = setup.parameters.rail_lateral_stiffness
    right.vertical_stiffness = setup.parameters.rail_vertical_stiffness
    right.lateral_damping = setup.parameters.rail_lateral_damping
    right.vertical_damping = setup.parameters.rail_vertical_damping
    copy(setup.left_spring, tables.springs[0])
    tables.sprung = is_sprung(tables, 0) or is_sprung(tables, 1)


def write_settings(setup: Setup, tables: Tables):
    """The settings that are known from the beginning, with each method's first choice."""
    tables.height = 0.5 * (setup.parameters.nominal_radius + setup.left_radius)
    tables.arm = 0.5 * setup.parameters.running_circle_distance
    nu = setup.parameters.poisson_ratio
    write_springs(setup, tables)
    tables.contact_modulus = setup.parameters.youngs_modulus / (2.0 * (1.0 - nu * nu))
    tables.shear_modulus = setup.parameters.youngs_modulus / (2.0 * (1.0 + nu))
    tables.lateral_limit = LATERAL_LIMIT
    tables.yaw_limit = YAW_LIMIT
    tables.nodes = setup.resolution.nodes
    tables.stride = setup.resolution.stride
    tables.sweeps = setup.resolution.sweeps
    tables.penetration[0] = setup.absent
    tables.penetration[1] = setup.absent
    tables.sides = float(SIDES_BOTH)
    tables.alone = False
    tables.depth = float(DEPTH_ALL)
    tables.absent = setup.absent
    tables.stations = float(STATION_COUNT)
    copy(setup.parameters, tables.parameters)
    for index in range(2):
        tables.pairs[index].tables = tables


def write_methods(setup: Setup, tables: Tables):
    """The chosen methods."""
    tables.mode = setup.parameters.contact_mode
    tables.load = setup.parameters.load
    tables.tangential = setup.parameters.tangential_model
    tables.wear = setup.parameters.wear_outputs != 0.0
    tables.fatigue = setup.parameters.fatigue_outputs != 0.0
    tables.error = setup.parameters.error_outputs != 0.0
    tables.normal_model = setup.parameters.normal_model
    tables.separation = setup.parameters.separation
    tables.longitudinal = setup.parameters.longitudinal_curvature
    tables.lateral = setup.parameters.lateral_curvature


def append_starts(tables: Tables, at: int):
    """A table of starts at ``at``, which counts as empty until ``open_starts``; the
    offset after it, or FULL."""
    if at + STARTS_SIZE > tables.raw.shape[0]:
        return FULL
    tables.starts = at
    starts = tables.starts
    clear(starts)
    starts.first_shift = -LATERAL_LIMIT
    starts.per_metre = STARTS_EACH_METRE
    return at + STARTS_SIZE


def write_wheel(
    setup: Setup, tables: Tables, pair: Pair, radius: float, at: int, definition: "float[:]", work: "float[:]"
):
    """The tables of a wheel of this radius [m] at ``at``, and where the pair finds them; the offset after
    them, or why not."""
    scratch = copy_definition(definition, work, 0)
    turn_zones(work, 0, 0.0, 0.0, 0.0)
    if keep_around_top(work, 0) == 0:
        return WITHOUT_HEAD
    pair.radius = radius
    pair.wheel = Profile.at(tables, at)
    end = write_profile(tables.raw, at, work, 0, setup.absent, work, scratch)
    if end != FULL:
        pair.wheel_curvature = CurvatureTable.at(tables, end)
        end = write_curvatures(tables, end, at, -1.0, work, scratch)
    return end


def write_rail(
    setup: Setup,
    tables: Tables,
    pair: Pair,
    inclination: float,
    at: int,
    definition: "float[:]",
    work: "float[:]",
):
    """The tables of a rail at ``at``, inclined and placed in the track, and where the pair finds them; the
    offset after them, or why not."""
    scratch = copy_definition(definition, work, 0)
    angle = -atan(inclination)
    y_top, z_top = highest_point(work, 0, angle)
    depth = z_top + setup.parameters.gauge_depth / MM
    y_gauge, reached = inner_face(work, 0, angle, depth)
    if reached < depth:
        setup.reached = reached * MM
        setup.depth = depth * MM
        return GAUGE_TOO_DEEP
    turn_zones(work, 0, angle, -y_top, -z_top)
    if keep_around_top(work, 0) == 0:
        return WITHOUT_HEAD
    pair.rail_y = setup.parameters.gauge / 2.0 + work[DEFINITION_WORN] * MM + (y_top - y_gauge) * MM
    pair.rail = Profile.at(tables, at)
    end = write_profile(tables.raw, at, work, 0, setup.absent, work, scratch)
    if end != FULL:
        pair.rail_curvature = CurvatureTable.at(tables, end)
        end = write_curvatures(tables, end, at, 1.0, work, scratch)
    if end != FULL:
        pair.rail_arc = CubicTable.at(tables, end)
        end = write_arcs(tables, end, at, work, scratch)
    if end != FULL:
        pair.rail_at_arc = CubicTable.at(tables, end)
        end = write_abscissae(tables, end, at, work, scratch)
    return end


def write_common(setup: Setup, tables: Tables, fixed: "float[:]"):
    """What does not depend on the profiles, behind the settings; the offset after it, or FULL.

    ``fixed`` are the tables that are the same for all wheelsets.
    """
    tables.hertz = SETTING_COUNT
    at = append_fixed(tables.raw, SETTING_COUNT, fixed, FIXED_HERTZ)
    if at != FULL:
        tables.influence = at
        at = append_fixed(tables.raw, at, fixed, FIXED_INFLUENCE)
    model = setup.parameters.normal_model
    if at != FULL and (model == MODEL_ANALYN_STRIP or model == MODEL_AUTO):
        tables.waves = at
        at = append_waves(tables, at, int(setup.resolution.strips))
    if at != FULL and setup.parameters.tangential_model != TANGENTIAL_NONE:
        tables.rolling = at
        at = append_rolling(tables, at, fixed, setup.parameters.poisson_ratio)
    if at != FULL:
        at = append_starts(tables, at)
    return at


def write_right(setup: Setup, tables: Tables, at: int, wheel: "float[:]", rail: "float[:]", work: "float[:]"):
    """The right side's wheel, rail and raster from ``at`` on; the offset after them, or why not."""
    pair = tables.pairs[1]
    end = write_wheel(setup, tables, pair, setup.parameters.nominal_radius, at, wheel, work)
    if end >= 0:
        end = write_rail(setup, tables, pair, setup.parameters.rail_inclination, end, rail, work)
    if end >= 0:
        end = write_scan(setup, tables, pair, end, work)
        if end >= 0:
            end = write_scan_bends(tables, pair, end)
    return end


def write_left(
    setup: Setup,
    tables: Tables,
    at: int,
    wheel: "float[:]",
    rail: "float[:]",
    work: "float[:]",
    equal_wheels: bool,
    equal_rails: bool,
):
    """The left side's wheel, rail and raster from ``at`` on, as far as they are not the right side's; the
    offset after them, or why not."""
    pair = tables.pairs[0]
    right = tables.pairs[1]
    end = at
    if equal_wheels:
        pair.radius = right.radius
        pair.wheel = right.wheel
        pair.wheel_curvature = right.wheel_curvature
    else:
        end = write_wheel(setup, tables, pair, setup.left_radius, end, wheel, work)
    if equal_rails:
        pair.rail_y = right.rail_y
        pair.rail = right.rail
        pair.rail_curvature = right.rail_curvature
        pair.rail_arc = right.rail_arc
        pair.rail_at_arc = right.rail_at_arc
    elif end >= 0:
        end = write_rail(setup, tables, pair, setup.left_inclination, end, rail, work)
    if equal_wheels and equal_rails:
        pair.scan = right.scan
    elif end >= 0:
        end = write_scan(setup, tables, pair, end, work)
        if end >= 0:
            end = write_scan_bends(tables, pair, end)
    return end


def prepare(
    setup: Setup,
    wheel: "float[:]",
    rail: "float[:]",
    left_wheel: "float[:]",
    left_rail: "float[:]",
    fixed: "float[:]",
    tables: Tables,
    work: "float[:]",
):
    """Everything but starts and methods into ``tables``; how many numbers of it are used, or why not.

    The definitions are those of both sides; the workspace holds one of them and as much again as the tables.
    """
    for i in range(SETTING_COUNT):
        tables[i] = 0.0
    write_settings(setup, tables)
    at = write_common(setup, tables, fixed)
    setup.side = 1
    if at >= 0:
        at = write_right(setup, tables, at, wheel, rail, work)
    if at >= 0:
        setup.side = 0
        equal_wheels = setup.left_radius == setup.parameters.nominal_radius and same_numbers(
            left_wheel, wheel
        )
        equal_rails = setup.left_inclination == setup.parameters.rail_inclination and same_numbers(
            left_rail, rail
        )
        at = write_left(setup, tables, at, left_wheel, left_rail, work, equal_wheels, equal_rails)
    return at


def same_numbers(one: "float[:]", other: "float[:]") -> bool:
    """Whether two definitions are equal; a number that is none equals itself."""
    if one.shape[0] != other.shape[0]:
        return False
    for i in range(one.shape[0]):
        if one[i] != other[i] and not (one[i] != one[i] and other[i] != other[i]):
            return False
    return True


def equal_sides(tables: Tables) -> bool:
    """Whether both sides have the same wheel and rail."""
    left = tables.pairs[0]
    right = tables.pairs[1]
    return offset(left.wheel, tables) == offset(right.wheel, tables) and offset(left.rail, tables) == offset(
        right.rail, tables
    )


def start_shift(tables: Tables, row: int):
    """Lateral shift [m] of a row of the table of starts."""
    return tables.starts.first_shift + float(row) / tables.starts.per_metre


def note_start(tables: Tables, outputs: Outputs, row: int, status: int):
    """Note in a row of the table of starts where the wheelset touches, from the step at its shift."""
    start = tables.starts.rows[row]
    if status <= UNLOADED:
        start.known = True
        start.roll = outputs.roll
        start.left = outputs.left[0].y_wheel
        start.right = outputs.left[1].y_wheel


def open_starts(tables: Tables):
    """Let the search use the table of starts, once its last row is known.

    Where both sides are equal, rows of opposite shifts are made mirror images of each other to
    the last bit: a wheelset and its mirror image start alike.
    """
    if equal_sides(tables):
        mirror_starts(tables)
    tables.starts.count = float(START_COUNT)


def mirror_starts(tables: Tables):
    """Rows of negative shifts from those of positive ones."""
    rows = tables.starts.rows
    for row in range(START_COUNT // 2):
        rows[row].roll = -rows[START_COUNT - 1 - row].roll
        rows[row].left = rows[START_COUNT - 1 - row].right
        rows[row].right = rows[START_COUNT - 1 - row].left
    rows[START_COUNT // 2].roll = 0.0
    rows[START_COUNT // 2].left = rows[START_COUNT // 2].right
