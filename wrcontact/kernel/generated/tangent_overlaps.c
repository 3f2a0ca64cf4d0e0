/* Generated from tangent_overlaps.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of overlaps.py.
 */

#include "tangent_overlaps.h"

/* Tangent of ``keep_deepest``. */
static inline int64_t tangent_overlaps__keep_deepest_t(array_double_1d work, array_double_1d work_t)
{
    int64_t deepest;
    int64_t i;
    deepest = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * overlaps__deepest_entry(work);
    for (i = INT64_C(0); i < overlaps__DEEP_SIZE; i += INT64_C(1))
    {
        (*cspan_at(&work_t, overlaps__DEEP_FIRST + i)) = (*cspan_at(&work_t, deepest + i));
        (*cspan_at(&work, overlaps__DEEP_FIRST + i)) = (*cspan_at(&work, deepest + i));
    }
    (*cspan_at(&work_t, overlaps__DEEP_COUNT)) = 0.0;
    (*cspan_at(&work, overlaps__DEEP_COUNT)) = 1.0;
    return INT64_C(0);
}

/* Tangent of ``touching_shift``. */
static inline int64_t tangent_overlaps__touching_shift_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, int64_t entry, double height, double height_t)
{
    int64_t block;
    double x_t;
    double x;
    double y_t;
    double y;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double z_rail;
    double z_rail_t;
    double m;
    double m_t;
    block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
    x_t = (*cspan_at(&work_t, block + overlaps__DEEP_RAIL));
    x = (*cspan_at(&work, block + overlaps__DEEP_RAIL));
    y_t = (*cspan_at(&work_t, block + overlaps__DEEP_WHEEL));
    y = (*cspan_at(&work, block + overlaps__DEEP_WHEEL));
    tangent_profile_table__height_slope_t(&z, &z_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
    tangent_locus__outline_point_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, work, work_t, at, y, y_t, z, z_t, slope, slope_t);
    tangent_profile_table__height_slope_t(&z_rail, &z_rail_t, &m, &m_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x, x_t);
    (*result_0) = x + (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - y_track;
    (*result_1) = x_t - y_track_t;
    (*result_2) = z_rail - z_track;
    (*result_3) = z_rail_t - z_track_t;
    return 0;
}

/* Tangent of ``press_frame``. */
static inline int64_t tangent_overlaps__press_frame_t(array_double_1d work, array_double_1d work_t, double height, double height_t, double depth, double depth_t, double gap, double gap_t)
{
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_POSE)) = height_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE)) = height;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH)) = depth_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)) = depth;
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_PRESSED)) = 0.0;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) = (double)(1);
    (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_RAISED)) = gap_t;
    (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_RAISED)) = gap;
    return INT64_C(0);
}

/* Tangent of ``gather_overlaps``. */
static inline int64_t tangent_overlaps__gather_overlaps_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state)
{
    int64_t contact;
    double cosine_t;
    double cosine;
    double abscissa_t;
    double abscissa;
    double height_t;
    double height;
    double depth_t;
    double depth;
    int64_t at;
    int64_t rail;
    int64_t region;
    int64_t block;
    int64_t deep;
    double z_rail;
    double z_rail_t;
    double m;
    double m_t;
    double aside;
    double aside_t;
    double shift;
    double shift_t;
    double n1;
    double n1_t;
    double n2;
    double n2_t;
    double n3;
    double n3_t;
    double n4;
    double n4_t;
    double n5;
    double n5_t;
    double v6;
    double v7;
    double v7_t;
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double low_t;
    double low;
    double high_t;
    double high;
    double v8;
    double v8_t;
    double v9;
    double v9_t;
    int64_t count;
    count = (int64_t)((*cspan_at(&work, overlaps__DEEP_COUNT)));
    contact = overlaps__deepest_entry(work);
    cosine_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_COS));
    cosine = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS));
    abscissa_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_ABSCISSA));
    abscissa = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_ABSCISSA));
    height_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_POSE));
    height = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_POSE));
    depth_t = (*cspan_at(&work_t, layout__WORK_FRAME + layout__FRAME_DEPTH));
    depth = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH));
    at = (int64_t)((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PLACE)));
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    tangent_planes__keep_frame_t(work, work_t, layout__REGION_LIMIT);
    for (region = INT64_C(0); region < count; region += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
        deep = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * region;
        (*cspan_at(&work_t, block + layout__REGION_STATION)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_STATION)) = 0.0;
        (*cspan_at(&work_t, block + layout__REGION_GAP)) = 0.0;
        (*cspan_at(&work, block + layout__REGION_GAP)) = 0.0;
        (*cspan_at(&work_t, block + layout__REGION_RAIL)) = (*cspan_at(&work_t, deep + overlaps__DEEP_RAIL));
        (*cspan_at(&work, block + layout__REGION_RAIL)) = (*cspan_at(&work, deep + overlaps__DEEP_RAIL));
        (*cspan_at(&work_t, block + layout__REGION_WHEEL)) = (*cspan_at(&work_t, deep + overlaps__DEEP_WHEEL));
        (*cspan_at(&work, block + layout__REGION_WHEEL)) = (*cspan_at(&work, deep + overlaps__DEEP_WHEEL));
        tangent_profile_table__height_slope_t(&z_rail, &z_rail_t, &m, &m_t, tables, rail, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), (*cspan_at(&work_t, deep + overlaps__DEEP_RAIL)));
        tangent_regions__lean_region_t(tables, work, work_t, block, m, m_t);
        if (region != contact)
        {
            tangent_overlaps__touching_shift_t(&aside, &aside_t, &shift, &shift_t, tables, work, work_t, at, region, height, height_t);
            tangent_contact_plane__open_frame_t(&n1, &n1_t, &n2, &n2_t, &n3, &n3_t, &n4, &n4_t, &n5, &n5_t, tables, work, work_t, at, (*cspan_at(&work, deep + overlaps__DEEP_WHEEL)), (*cspan_at(&work_t, deep + overlaps__DEEP_WHEEL)), aside, aside_t, shift, shift_t);
            (*cspan_at(&work_t, block + layout__REGION_OWN)) = 0.0;
            (*cspan_at(&work, block + layout__REGION_OWN)) = (double)(1);
            v6 = (*cspan_at(&work, block + layout__REGION_COS)) / cosine;
            (*cspan_at(&work_t, block + layout__REGION_TURN)) = ((*cspan_at(&work_t, block + layout__REGION_COS)) - v6 * cosine_t) / cosine;
            (*cspan_at(&work, block + layout__REGION_TURN)) = v6;
            (*cspan_at(&work_t, block + layout__REGION_GAP)) = (*cspan_at(&work_t, block + layout__REGION_TURN)) * depth + (*cspan_at(&work, block + layout__REGION_TURN)) * depth_t - (*cspan_at(&work_t, deep + overlaps__DEEP_DEPTH));
            (*cspan_at(&work, block + layout__REGION_GAP)) = (*cspan_at(&work, block + layout__REGION_TURN)) * depth - (*cspan_at(&work, deep + overlaps__DEEP_DEPTH));
            tangent_pressed__rail_length_t(&v7, &v7_t, tables, abscissa, abscissa_t, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), (*cspan_at(&work_t, deep + overlaps__DEEP_RAIL)));
            (*cspan_at(&work_t, block + layout__REGION_OFFSET)) = v7_t;
            (*cspan_at(&work, block + layout__REGION_OFFSET)) = v7;
            tangent_overlaps__press_frame_t(work, work_t, height, height_t, (*cspan_at(&work, deep + overlaps__DEEP_DEPTH)), (*cspan_at(&work_t, deep + overlaps__DEEP_DEPTH)), (*cspan_at(&work, block + layout__REGION_GAP)), (*cspan_at(&work_t, block + layout__REGION_GAP)));
        }
        tangent_contact_plane__start_tracer_t(work, work_t, 0.0, 0.0, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), (*cspan_at(&work_t, deep + overlaps__DEEP_RAIL)), (*cspan_at(&work, deep + overlaps__DEEP_WHEEL)), (*cspan_at(&work_t, deep + overlaps__DEEP_WHEEL)));
        tangent_pressed__pressed_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, tables, work, work_t, state, 0.0, 0.0);
        (*cspan_at(&work_t, block + layout__REGION_BEND)) = bend_t;
        (*cspan_at(&work, block + layout__REGION_BEND)) = bend;
        (*cspan_at(&work_t, block + layout__REGION_CURVATURE)) = curvature_t;
        (*cspan_at(&work, block + layout__REGION_CURVATURE)) = curvature;
        low_t = 0.0;
        low = (*cspan_at(&tables, rail + layout__PROFILE_START));
        high_t = 0.0;
        high = (*cspan_at(&tables, rail + layout__PROFILE_STOP));
        if (region > INT64_C(0))
        {
            low_t = (*cspan_at(&work_t, deep - overlaps__DEEP_SIZE + overlaps__DEEP_HUMP));
            low = (*cspan_at(&work, deep - overlaps__DEEP_SIZE + overlaps__DEEP_HUMP));
        }
        if (region < count - INT64_C(1))
        {
            high_t = (*cspan_at(&work_t, deep + overlaps__DEEP_HUMP));
            high = (*cspan_at(&work, deep + overlaps__DEEP_HUMP));
        }
        tangent_pressed__rail_length_t(&v8, &v8_t, tables, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), (*cspan_at(&work_t, deep + overlaps__DEEP_RAIL)), low, low_t);
        (*cspan_at(&work_t, block + layout__REGION_LOW)) = v8_t;
        (*cspan_at(&work, block + layout__REGION_LOW)) = v8;
        tangent_pressed__rail_length_t(&v9, &v9_t, tables, (*cspan_at(&work, deep + overlaps__DEEP_RAIL)), (*cspan_at(&work_t, deep + overlaps__DEEP_RAIL)), high, high_t);
        (*cspan_at(&work_t, block + layout__REGION_HIGH)) = v9_t;
        (*cspan_at(&work, block + layout__REGION_HIGH)) = v9;
        tangent_planes__keep_frame_t(work, work_t, region);
        tangent_planes__use_frame_t(work, work_t, layout__REGION_LIMIT);
    }
    if (count > INT64_C(1))
    {
        tangent_planes__line_up_t(tables, work, work_t, count);
    }
    return count;
}

/* Tangent of ``turning_rule``. */
static inline int64_t tangent_overlaps__turning_rule_t(double* place, double* place_t, double* result_2, double* result_3, double* overlap, double* overlap_t, int64_t* found, array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t at, double x, double x_t, double y, double y_t, double height, double height_t)
{
    double rise;
    double rise_t;
    double turn;
    double turn_t;
    double curvature;
    double curvature_t;
    double more;
    double more_t;
    double bend;
    double v1;
    x_t = 0.0;
    (*place_t) = x_t;
    (*place) = x;
    tangent_pressed__line_rule_t(&y, &y_t, overlap, overlap_t, &rise, &rise_t, &turn, &turn_t, &curvature, &curvature_t, found, tables, work, work_t, at, x, x_t, y, 0.0, height, height_t);
    if ((*found) == INT64_C(1))
    {
        tangent_pressed__line_rule_t(&y, &y_t, overlap, overlap_t, &more, &more_t, &turn, &turn_t, &curvature, &curvature_t, found, tables, work, work_t, at, x, 1.0, y, 0.0, height, height_t);
        bend = more_t - rise_t;
        if (bend != 0.0)
        {
            v1 = -rise;
            (*place_t) = (-rise_t) / bend;
            (*place) = x;
        }
        tangent_pressed__line_rule_t(&y, &y_t, overlap, overlap_t, &more, &more_t, &turn, &turn_t, &curvature, &curvature_t, found, tables, work, work_t, at, (*place), (*place_t), y, 0.0, height, height_t);
    }
    (*result_2) = y;
    (*result_3) = y_t;
    return 0;
}

/* Tangent of ``overlaps_rule``. */
static inline int64_t tangent_overlaps__overlaps_rule_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, int64_t at, double height, double height_t)
{
    int64_t n1;
    int64_t entry;
    int64_t block;
    double x;
    double x_t;
    double y;
    double y_t;
    double overlap;
    double overlap_t;
    int64_t found;
    double v2;
    int64_t count;
    n1 = overlaps__find_overlaps(tables, work, state, side, at, height);
    count = n1;
    for (entry = INT64_C(0); entry < count; entry += INT64_C(1))
    {
        block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
        tangent_overlaps__turning_rule_t(&x, &x_t, &y, &y_t, &overlap, &overlap_t, &found, tables, work, work_t, at, (*cspan_at(&work, block + overlaps__DEEP_RAIL)), (*cspan_at(&work_t, block + overlaps__DEEP_RAIL)), (*cspan_at(&work, block + overlaps__DEEP_WHEEL)), (*cspan_at(&work_t, block + overlaps__DEEP_WHEEL)), height, height_t);
        (*cspan_at(&work_t, block + overlaps__DEEP_RAIL)) = x_t;
        (*cspan_at(&work_t, block + overlaps__DEEP_WHEEL)) = y_t;
        (*cspan_at(&work_t, block + overlaps__DEEP_DEPTH)) = overlap_t;
    }
    for (entry = INT64_C(0); entry < count - INT64_C(1); entry += INT64_C(1))
    {
        block = overlaps__DEEP_FIRST + overlaps__DEEP_SIZE * entry;
        v2 = (*cspan_at(&work, block + overlaps__DEEP_WHEEL)) + (*cspan_at(&work, block + overlaps__DEEP_SIZE + overlaps__DEEP_WHEEL));
        tangent_overlaps__turning_rule_t(&x, &x_t, &y, &y_t, &overlap, &overlap_t, &found, tables, work, work_t, at, (*cspan_at(&work, block + overlaps__DEEP_HUMP)), (*cspan_at(&work_t, block + overlaps__DEEP_HUMP)), 0.5 * v2, 0.5 * ((*cspan_at(&work_t, block + overlaps__DEEP_WHEEL)) + (*cspan_at(&work_t, block + overlaps__DEEP_SIZE + overlaps__DEEP_WHEEL))), height, height_t);
        (*cspan_at(&work_t, block + overlaps__DEEP_HUMP)) = x_t;
        (*cspan_at(&work_t, block + overlaps__DEEP_BETWEEN)) = overlap_t;
    }
    return count;
}
