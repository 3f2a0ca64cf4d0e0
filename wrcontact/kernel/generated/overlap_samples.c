/* Generated from contact/overlap_samples.py by tools/transpile_kernel.py; change that one.
 *
 * Samples of the overlap of a pressed wheel at the scan nodes where the wheel is below the rail.
 *
 * The overlap is taken straight down there and converted to the rail's normal.
 */

#include "overlap_samples.h"

/* Write scan node ``node`` to sample ``entry``; its vertical gap [m], slope difference [-] and rail
 * abscissa [m].
 */
static OUT_OF_LINE int64_t overlap_samples__sample_overlap(double* gap, double* result_1, double* abscissa, array_double_1d work, array_double_1d tables, int64_t place, int64_t node, double height, int64_t entry)
{
    int64_t point;
    double y;
    double y_track;
    double z_track;
    double outline_slope;
    double z_rail;
    double m;
    double bend;
    double square;
    double turn;
    point = (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_NODES + layout__SCAN_NODE_SIZE * node;
    y = (*cspan_at(&tables, point + layout__SCAN_NODE_Y));
    locus__outline_point(&y_track, &z_track, &outline_slope, work, place, y, (*cspan_at(&tables, point + layout__SCAN_NODE_HEIGHT)), (*cspan_at(&tables, point + layout__SCAN_NODE_SLOPE)));
    (*abscissa) = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    profile_table__height_slope_bend(&z_rail, &m, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*abscissa));
    (*gap) = z_rail - z_track;
    square = 1.0 / (1.0 + m * m);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)) = (*abscissa);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_WHEEL + entry)) = y;
    /* the slope of (height - gap) cos, divided by cos; where wheel and rail are apart, and the rail's normals */
    /* mean little, that of height - gap */
    turn = 0.0;
    if (height > (*gap))
    {
        turn = (height - (*gap)) * m * bend * square;
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_TURN + entry)) = turn;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + entry)) = outline_slope - m - turn;
    (*result_1) = m - outline_slope;
    return 0;
}

/* Let sample ``entry``, beyond the rail, stand for its end, with a slope that lets the last stretch be
 * searched.
 *
 * It keeps its own wheel abscissa, less than a cell away: it may be the first one, whose neighbour is not
 * sampled yet.
 */
static OUT_OF_LINE int64_t overlap_samples__sample_end(array_double_1d work, array_double_1d tables, int64_t direction, int64_t entry)
{
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)) = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_START));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + entry)) = 1.0;
    if (direction > INT64_C(0))
    {
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RAIL + entry)) = (*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))) + layout__PROFILE_STOP));
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_RISE + entry)) = -1.0;
    }
    return INT64_C(0);
}

/* Sample from scan node ``node`` on in ``direction`` (1 or -1), leaving out stretches where the wheel is
 * above the rail; the entry after the last one.  Entries begin with ``first`` and run in ``direction``.
 */
static OUT_OF_LINE int64_t overlap_samples__walk_overlap(array_double_1d work, array_double_1d tables, int64_t place, array_double_1d state, int64_t node, int64_t direction, double height, int64_t first)
{
    int64_t count;
    int64_t exponent;
    double adjacent;
    double gap;
    double mismatch;
    double abscissa;
    int64_t on_rail;
    int64_t step;
    int64_t entry;
    count = (int64_t)((*cspan_at(&tables, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))) + layout__SCAN_COUNT)));
    entry = first;
    exponent = layout__EXPONENTS - INT64_C(1);
    adjacent = 1.0;
    while((node >= INT64_C(0)) && (node < count) && (entry > INT64_C(0)) && (entry < INT64_C(2) * layout__OVERLAP_LIMIT - INT64_C(1)))
    {
        overlap_samples__sample_overlap(&gap, &mismatch, &abscissa, work, tables, place, node, height, entry);
        (*cspan_at(&state, layout__STATE_GAP_COUNT)) += 1.0;
        on_rail = gap__above_rail(tables, abscissa);
        if (on_rail == INT64_C(0))
        {
            overlap_samples__sample_end(work, tables, direction, entry);
        }
        if (direction > INT64_C(0))
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_ADJACENT + entry)) = adjacent;
        }
        else
        {
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_OVERLAP + layout__OVERLAP_SAMPLES + layout__SAMPLES_ADJACENT + (entry + INT64_C(1)))) = adjacent;
        }
        entry += direction;
        if (on_rail == INT64_C(0))
        {
            return entry;
        }
        adjacent = 1.0;
        step = INT64_C(1);
        if (gap > height)
        {
            exponent = bounds__clear_exponent(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_SCAN))), place, node, direction, abscissa, gap - height, (double)(direction) * mismatch, exponent);
            if (exponent < INT64_C(0))
            {
                exponent = INT64_C(0);
            }
            else if (exponent > INT64_C(0))
            {
                step = INT64_C(1) << exponent;
                adjacent = 0.0;
            }
            if (exponent < layout__EXPONENTS - INT64_C(1))
            {
                exponent += INT64_C(1);
            }
        }
        node += direction * step;
    }
    return entry;
}
