/* Generated from prepare/tables.py by tools/transpile_kernel.py; change that one.
 *
 * The array that the kernel reads, from definitions of the profiles and the parameters: what ContactSystem
 * and the native FMU do at the start, outside the hot unit.
 *
 * The recipe, for each side: place the rail, cut the wheel, compile both, and lay the tables one after the
 * other (``prepare``); one array serves both sides where they are equal. Then the kernel itself fills the table
 * of starts of the right side (``start_shift`` and ``note_start``), and last come the methods
 * (``write_methods``).
 */

#include "prepare_tables.h"

/* Copy a definition into the workspace; the offset after it. */
static inline int64_t prepare_tables__copy_definition(array_double_1d definition, array_double_1d work, int64_t at)
{
    int64_t size;
    int64_t i;
    size = prepare_zones__DEFINITION_ZONES + (int64_t)((*cspan_at(&definition, prepare_zones__DEFINITION_COUNT))) * (int64_t)((*cspan_at(&definition, prepare_zones__DEFINITION_ROW)));
    for (i = INT64_C(0); i < size; i += INT64_C(1))
    {
        (*cspan_at(&work, at + i)) = (*cspan_at(&definition, i));
    }
    return at + size;
}

/* Cut the wheel's and place the rail's definition in the workspace, and note where the
 * rail stands; the outcome.
 */
static inline int64_t prepare_tables__place_zones(array_double_1d setup, array_double_1d work, int64_t wheel, int64_t rail, array_double_1d tables, array_double_1d report)
{
    double angle;
    double y_top;
    double z_top;
    double depth;
    double y_gauge;
    double reached;
    angle = -atan((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_RAIL_INCLINATION)));
    prepare_placement__highest_point(&y_top, &z_top, work, rail, angle);
    depth = z_top + (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_GAUGE_DEPTH)) / prepare_pieces__MM;
    prepare_placement__inner_face(&y_gauge, &reached, work, rail, angle, depth);
    if (reached < depth)
    {
        (*cspan_at(&report, prepare_tables__REPORT_DEEPEST)) = reached * prepare_pieces__MM;
        (*cspan_at(&report, prepare_tables__REPORT_DEPTH)) = depth * prepare_pieces__MM;
        return prepare_tables__GAUGE_TOO_DEEP;
    }
    (*cspan_at(&tables, layout__TABLES_RAIL_Y)) = (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_GAUGE)) / 2.0 + (y_top - y_gauge) * prepare_pieces__MM;
    prepare_placement__turn_zones(work, rail, angle, -y_top, -z_top);
    prepare_placement__turn_zones(work, wheel, 0.0, 0.0, 0.0);
    if ((prepare_placement__keep_around_top(work, rail) == INT64_C(0)) || (prepare_placement__keep_around_top(work, wheel) == INT64_C(0)))
    {
        return prepare_tables__WITHOUT_HEAD;
    }
    return prepare_tables__PREPARED;
}

/* The settings that are known from the beginning, with each method's first choice. */
static inline int64_t prepare_tables__write_settings(array_double_1d setup, array_double_1d tables)
{
    double nu;
    int64_t i;
    (*cspan_at(&tables, layout__TABLES_RADIUS)) = (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_NOMINAL_RADIUS));
    (*cspan_at(&tables, layout__TABLES_HEIGHT)) = (*cspan_at(&setup, layout__SETUP_HEIGHT));
    (*cspan_at(&tables, layout__TABLES_ARM)) = 0.5 * (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_RUNNING_CIRCLE_DISTANCE));
    nu = (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_POISSON_RATIO));
    (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)) = (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_YOUNGS_MODULUS)) / (2.0 * (1.0 - nu * nu));
    (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)) = (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_YOUNGS_MODULUS)) / (2.0 * (1.0 + nu));
    (*cspan_at(&tables, layout__TABLES_LATERAL_LIMIT)) = layout__LATERAL_LIMIT;
    (*cspan_at(&tables, layout__TABLES_YAW_LIMIT)) = layout__YAW_LIMIT;
    (*cspan_at(&tables, layout__TABLES_NODES)) = (double)((*cspan_at(&setup, layout__SETUP_RESOLUTION + layout__RESOLUTION_NODES)));
    (*cspan_at(&tables, layout__TABLES_STRIDE)) = (double)((*cspan_at(&setup, layout__SETUP_RESOLUTION + layout__RESOLUTION_STRIDE)));
    (*cspan_at(&tables, layout__TABLES_STRIPS)) = (double)((*cspan_at(&setup, layout__SETUP_RESOLUTION + layout__RESOLUTION_STRIPS)));
    (*cspan_at(&tables, layout__TABLES_SWEEPS)) = (double)((*cspan_at(&setup, layout__SETUP_RESOLUTION + layout__RESOLUTION_SWEEPS)));
    (*cspan_at(&tables, layout__TABLES_PENETRATION + INT64_C(0))) = (*cspan_at(&setup, layout__SETUP_ABSENT));
    (*cspan_at(&tables, layout__TABLES_PENETRATION + INT64_C(1))) = (*cspan_at(&setup, layout__SETUP_ABSENT));
    (*cspan_at(&tables, layout__TABLES_SIDES)) = (double)((double)(layout__SIDES_BOTH));
    (*cspan_at(&tables, layout__TABLES_DEPTH)) = (double)((double)(layout__DEPTH_ALL));
    (*cspan_at(&tables, layout__TABLES_ABSENT)) = (*cspan_at(&setup, layout__SETUP_ABSENT));
    (*cspan_at(&tables, layout__TABLES_STATIONS)) = (double)((double)(layout__STATION_COUNT));
    for (i = INT64_C(0); i < layout__PARAMETERS_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&tables, layout__TABLES_PARAMETERS + i)) = (*cspan_at(&setup, layout__SETUP_PARAMETERS + i));
    }
    return INT64_C(0);
}

/* The chosen methods. */
static inline int64_t prepare_tables__write_methods(array_double_1d setup, array_double_1d tables)
{
    (*cspan_at(&tables, layout__TABLES_MODE)) = (double)((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_CONTACT_MODE)));
    (*cspan_at(&tables, layout__TABLES_LOAD)) = (double)((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_LOAD)));
    (*cspan_at(&tables, layout__TABLES_TANGENTIAL)) = (double)((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_TANGENTIAL_MODEL)));
    (*cspan_at(&tables, layout__TABLES_NORMAL_MODEL)) = (double)((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_NORMAL_MODEL)));
    (*cspan_at(&tables, layout__TABLES_SEPARATION)) = (double)((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_SEPARATION)));
    (*cspan_at(&tables, layout__TABLES_LONGITUDINAL)) = (double)((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_LONGITUDINAL_CURVATURE)));
    (*cspan_at(&tables, layout__TABLES_LATERAL)) = (double)((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_LATERAL_CURVATURE)));
    return INT64_C(0);
}

/* A table of starts at ``at``, which counts as empty until ``open_starts``; the
 * offset after it, or FULL.
 */
static inline int64_t prepare_tables__append_starts(array_double_1d tables, int64_t at)
{
    int64_t i;
    int64_t starts;
    if (at + layout__STARTS_SIZE > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    for (i = INT64_C(0); i < layout__STARTS_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&tables, at + i)) = 0.0;
    }
    (*cspan_at(&tables, layout__TABLES_STARTS)) = (double)(at);
    starts = (int64_t)((*cspan_at(&tables, layout__TABLES_STARTS)));
    (*cspan_at(&tables, starts + layout__STARTS_FIRST_SHIFT)) = -layout__LATERAL_LIMIT;
    (*cspan_at(&tables, starts + layout__STARTS_PER_METRE)) = prepare_tables__STARTS_EACH_METRE;
    return at + layout__STARTS_SIZE;
}

/* Everything but starts and methods into ``tables``; the outcome. ``fixed`` are the tables that do not
 * depend on the profiles (fixed.py); the workspace holds both definitions and as much again as the
 * tables.
 */
static inline int64_t prepare_tables__prepare(array_double_1d setup, array_double_1d wheel_definition, array_double_1d rail_definition, array_double_1d fixed, array_double_1d tables, array_double_1d work, array_double_1d report)
{
    int64_t i;
    int64_t rail_zones;
    int64_t scratch;
    int64_t outcome;
    int64_t wheel;
    int64_t rail;
    int64_t at;
    for (i = INT64_C(0); i < layout__SETTING_COUNT; i += INT64_C(1))
    {
        (*cspan_at(&tables, i)) = 0.0;
    }
    rail_zones = prepare_tables__copy_definition(wheel_definition, work, INT64_C(0));
    scratch = prepare_tables__copy_definition(rail_definition, work, rail_zones);
    outcome = prepare_tables__place_zones(setup, work, INT64_C(0), rail_zones, tables, report);
    if (outcome != prepare_tables__PREPARED)
    {
        return outcome;
    }
    prepare_tables__write_settings(setup, tables);
    wheel = layout__SETTING_COUNT;
    (*cspan_at(&tables, layout__TABLES_WHEEL)) = (double)(wheel);
    rail = prepare_pieces__write_profile(tables, wheel, work, INT64_C(0), (*cspan_at(&setup, layout__SETUP_ABSENT)), work, scratch);
    if (rail == prepare_pieces__FULL)
    {
        return prepare_tables__TABLES_FULL;
    }
    (*cspan_at(&tables, layout__TABLES_RAIL)) = (double)(rail);
    at = prepare_pieces__write_profile(tables, rail, work, rail_zones, (*cspan_at(&setup, layout__SETUP_ABSENT)), work, scratch);
    if (at == prepare_pieces__FULL)
    {
        return prepare_tables__TABLES_FULL;
    }
    (*cspan_at(&tables, layout__TABLES_SCAN)) = (double)(at);
    at = prepare_scan__write_scan(tables, work, scratch);
    if (at == prepare_scan__TOO_WIDE)
    {
        (*cspan_at(&report, prepare_tables__REPORT_WIDTH)) = (*cspan_at(&tables, wheel + layout__PROFILE_STOP)) - (*cspan_at(&tables, wheel + layout__PROFILE_START));
        return prepare_tables__WHEEL_TOO_WIDE;
    }
    if (at != prepare_pieces__FULL)
    {
        (*cspan_at(&tables, layout__TABLES_HERTZ)) = (double)(at);
        at = prepare_fixed__append_fixed(tables, at, fixed, prepare_fixed__FIXED_HERTZ);
    }
    if (at != prepare_pieces__FULL)
    {
        (*cspan_at(&tables, layout__TABLES_INFLUENCE)) = (double)(at);
        at = prepare_fixed__append_fixed(tables, at, fixed, prepare_fixed__FIXED_INFLUENCE);
    }
    if ((at != prepare_pieces__FULL) && ((*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_TANGENTIAL_MODEL)) != layout__TANGENTIAL_NONE))
    {
        (*cspan_at(&tables, layout__TABLES_ROLLING)) = (double)(at);
        at = prepare_fixed__append_rolling(tables, at, fixed, (*cspan_at(&setup, layout__SETUP_PARAMETERS + layout__PARAMETERS_POISSON_RATIO)));
    }
    if (at != prepare_pieces__FULL)
    {
        at = prepare_tables__append_starts(tables, at);
    }
    if (at != prepare_pieces__FULL)
    {
        (*cspan_at(&tables, layout__TABLES_WHEEL_CURVATURE)) = (double)(at);
        at = prepare_curvatures__write_curvatures(tables, at, wheel, -1.0, work, scratch);
    }
    if (at != prepare_pieces__FULL)
    {
        (*cspan_at(&tables, layout__TABLES_RAIL_CURVATURE)) = (double)(at);
        at = prepare_curvatures__write_curvatures(tables, at, rail, 1.0, work, scratch);
    }
    if (at != prepare_pieces__FULL)
    {
        (*cspan_at(&tables, layout__TABLES_RAIL_ARC)) = (double)(at);
        at = prepare_arcs__write_arcs(tables, at, rail, work, scratch);
    }
    if (at != prepare_pieces__FULL)
    {
        (*cspan_at(&tables, layout__TABLES_RAIL_AT_ARC)) = (double)(at);
        at = prepare_arcs__write_abscissae(tables, at, rail, work, scratch);
    }
    if (at == prepare_pieces__FULL)
    {
        return prepare_tables__TABLES_FULL;
    }
    (*cspan_at(&report, prepare_tables__REPORT_SIZE)) = (double)(at);
    return prepare_tables__PREPARED;
}

/* Lateral shift [m] of a row of the table of starts. */
static inline double prepare_tables__start_shift(array_double_1d tables, int64_t row)
{
    double result;
    result = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_STARTS))) + layout__STARTS_FIRST_SHIFT)) + (double)(row) / (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_STARTS))) + layout__STARTS_PER_METRE));
    return result;
}

/* Note in a row of the table of starts where the wheelset touches, from the step at its shift. */
static inline int64_t prepare_tables__note_start(array_double_1d work, array_double_1d tables, int64_t row, int64_t status)
{
    int64_t start;
    start = (int64_t)((*cspan_at(&tables, layout__TABLES_STARTS))) + layout__STARTS_ROWS + layout__START_SIZE * row;
    if (status <= layout__UNLOADED)
    {
        (*cspan_at(&tables, start + layout__START_KNOWN)) = (double)(1);
        (*cspan_at(&tables, start + layout__START_ROLL)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_ROLL));
        (*cspan_at(&tables, start + layout__START_LEFT)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_Y_WHEEL));
        (*cspan_at(&tables, start + layout__START_RIGHT)) = (*cspan_at(&work, layout__WORK_OUTPUTS + layout__OUTPUTS_LEFT + layout__SIDE_OUTPUTS_SIZE * INT64_C(1) + layout__SIDE_OUTPUTS_Y_WHEEL));
    }
    return INT64_C(0);
}

/* Let the search use the table of starts, once its last row is known.
 *
 * Where both sides are equal, ``equal`` = 1, rows of opposite shifts are made mirror images of each other to
 * the last bit: a wheelset and its mirror image start alike.
 */
static inline int64_t prepare_tables__open_starts(array_double_1d tables, int64_t equal)
{
    if (equal == INT64_C(1))
    {
        prepare_tables__mirror_starts(tables);
    }
    (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_STARTS))) + layout__STARTS_COUNT)) = (double)(layout__START_COUNT);
    return INT64_C(0);
}

/* Rows of negative shifts from those of positive ones. */
static inline int64_t prepare_tables__mirror_starts(array_double_1d tables)
{
    int64_t rows;
    int64_t row;
    rows = (int64_t)((*cspan_at(&tables, layout__TABLES_STARTS))) + layout__STARTS_ROWS;
    for (row = INT64_C(0); row < py_floor_div_int64_t(layout__START_COUNT, INT64_C(2)); row += INT64_C(1))
    {
        (*cspan_at(&tables, rows + layout__START_SIZE * row + layout__START_ROLL)) = -(*cspan_at(&tables, rows + layout__START_SIZE * (layout__START_COUNT - INT64_C(1) - row) + layout__START_ROLL));
        (*cspan_at(&tables, rows + layout__START_SIZE * row + layout__START_LEFT)) = (*cspan_at(&tables, rows + layout__START_SIZE * (layout__START_COUNT - INT64_C(1) - row) + layout__START_RIGHT));
        (*cspan_at(&tables, rows + layout__START_SIZE * row + layout__START_RIGHT)) = (*cspan_at(&tables, rows + layout__START_SIZE * (layout__START_COUNT - INT64_C(1) - row) + layout__START_LEFT));
    }
    (*cspan_at(&tables, rows + layout__START_SIZE * (py_floor_div_int64_t(layout__START_COUNT, INT64_C(2))) + layout__START_ROLL)) = 0.0;
    (*cspan_at(&tables, rows + layout__START_SIZE * (py_floor_div_int64_t(layout__START_COUNT, INT64_C(2))) + layout__START_LEFT)) = (*cspan_at(&tables, rows + layout__START_SIZE * (py_floor_div_int64_t(layout__START_COUNT, INT64_C(2))) + layout__START_RIGHT));
    return INT64_C(0);
}
