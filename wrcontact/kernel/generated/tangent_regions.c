/* Generated from tangent_regions.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of regions.py.
 */

#include "tangent_regions.h"

/* Tangent of ``open_region``. */
static inline int64_t tangent_regions__open_region_t(double* found, double* found_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double station, double station_t)
{
    double start_t;
    double start;
    double gap_t;
    double gap;
    double bend_t;
    double bend;
    double curvature_t;
    double curvature;
    double low_t;
    double low;
    double high_t;
    double high;
    int64_t i;
    double rate;
    double rate_t;
    double move_t;
    double move;
    double v1;
    double v2;
    double v3;
    double height;
    double height_t;
    double slope;
    double slope_t;
    start_t = station_t;
    start = station;
    gap_t = 0.0;
    gap = regions__BEYOND;
    (*found_t) = 0.0;
    (*found) = regions__BEYOND;
    bend_t = 0.0;
    bend = 0.0;
    curvature_t = 0.0;
    curvature = 0.0;
    low_t = start_t;
    low = start - regions__WANDER;
    high_t = start_t;
    high = start + regions__WANDER;
    for (i = INT64_C(0); i < regions__MINIMUM_ITERATIONS; i += INT64_C(1))
    {
        tangent_contact_plane__normal_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, station, station_t, regions__PLACE_TRACE, 0.0);
        move_t = 0.0;
        move = -regions__DOWNHILL;
        if (rate < 0.0)
        {
            move_t = 0.0;
            move = regions__DOWNHILL;
            low_t = station_t;
            low = station;
        }
        else
        {
            high_t = station_t;
            high = station;
        }
        if (bend > 0.0)
        {
            v1 = -rate;
            v2 = v1 / bend;
            move_t = ((-rate_t) - v2 * bend_t) / bend;
            move = v2;
            if (fabs(move) < regions__PLACE_SHARP)
            {
                (*found_t) = gap_t;
                (*found) = gap;
            }
        }
        if (((station + move > high) && (high < start + regions__WANDER)) || ((station + move < low) && (low > start - regions__WANDER)))
        {
            v3 = low + high;
            move_t = 0.5 * (low_t + high_t) - station_t;
            move = 0.5 * v3 - station;
        }
        if (station + move > start + regions__WANDER)
        {
            move_t = start_t - station_t;
            move = start + regions__WANDER - station;
        }
        if (station + move < start - regions__WANDER)
        {
            move_t = start_t - station_t;
            move = start - regions__WANDER - station;
        }
        if (fabs(move) < regions__PLACE_SHARP)
        {
            break;
        }
        station_t = station_t + move_t;
        station = station + move;
    }
    (*cspan_at(&work_t, region + layout__REGION_STATION)) = station_t;
    (*cspan_at(&work, region + layout__REGION_STATION)) = station;
    (*cspan_at(&work_t, region + layout__REGION_GAP)) = gap_t;
    (*cspan_at(&work, region + layout__REGION_GAP)) = gap;
    (*cspan_at(&work_t, region + layout__REGION_RAIL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
    (*cspan_at(&work_t, region + layout__REGION_WHEEL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    (*cspan_at(&work_t, region + layout__REGION_BEND)) = bend_t;
    (*cspan_at(&work, region + layout__REGION_BEND)) = bend;
    (*cspan_at(&work_t, region + layout__REGION_CURVATURE)) = curvature_t;
    (*cspan_at(&work, region + layout__REGION_CURVATURE)) = curvature;
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    tangent_regions__incline_region_t(work, work_t, tables, region, slope, slope_t);
    return 0;
}

/* Tangent of ``incline_region``. */
static inline int64_t tangent_regions__incline_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, double slope, double slope_t)
{
    double v1;
    double v2;
    double v3;
    double cosine_t;
    double cosine;
    v1 = 1.0 + slope * slope;
    v2 = sqrt(v1);
    v3 = 1.0 / v2;
    cosine_t = (-v3) * tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t) / v2;
    cosine = v3;
    (*cspan_at(&work_t, region + layout__REGION_INCLINATION)) = slope_t;
    (*cspan_at(&work, region + layout__REGION_INCLINATION)) = slope;
    (*cspan_at(&work_t, region + layout__REGION_OWN)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(0);
    (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = 1.0;
    (*cspan_at(&work_t, region + layout__REGION_OFFSET)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_OFFSET)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_COS)) = cosine_t;
    (*cspan_at(&work, region + layout__REGION_COS)) = cosine;
    (*cspan_at(&work_t, region + layout__REGION_SIN)) = slope_t * cosine + slope * cosine_t;
    (*cspan_at(&work, region + layout__REGION_SIN)) = slope * cosine;
    (*cspan_at(&work_t, region + layout__REGION_SHARE)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_SHARE)) = 1.0;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
    {
        (*cspan_at(&work_t, region + layout__REGION_SHARE)) = cosine_t;
        (*cspan_at(&work, region + layout__REGION_SHARE)) = cosine;
    }
    return INT64_C(0);
}

/* Tangent of ``measure_contact``. */
static inline int64_t tangent_regions__measure_contact_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state)
{
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    tangent_contact_plane__normal_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, 0.0, 0.0, regions__PLACE_TRACE, 0.0);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND)) = bend_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND)) = bend;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE)) = curvature_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE)) = curvature;
    return INT64_C(0);
}

/* Tangent of ``open_contact_region``. */
static inline int64_t tangent_regions__open_contact_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region)
{
    double v1;
    (*cspan_at(&work_t, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_RAIL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work_t, region + layout__REGION_WHEEL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y));
    (*cspan_at(&work_t, region + layout__REGION_BEND)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND));
    (*cspan_at(&work, region + layout__REGION_BEND)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND));
    (*cspan_at(&work_t, region + layout__REGION_CURVATURE)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE));
    (*cspan_at(&work, region + layout__REGION_CURVATURE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE));
    (*cspan_at(&work_t, region + layout__REGION_LOW)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_LOW)) = -regions__BEYOND;
    (*cspan_at(&work_t, region + layout__REGION_HIGH)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_HIGH)) = regions__BEYOND;
    v1 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    tangent_regions__incline_region_t(work, work_t, tables, region, v1, ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) - v1 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)));
    return INT64_C(0);
}

/* Tangent of ``find_regions``. */
static inline int64_t tangent_regions__find_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t side, array_double_1d state, double level, double level_t)
{
    double v1;
    double v2;
    double reach_t;
    double reach;
    int64_t i_end;
    int64_t i;
    double y_t;
    double y;
    double abscissa_t;
    double abscissa;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v3;
    double v4;
    double station_t;
    double station;
    double n5;
    double n5_t;
    int64_t count;
    count = INT64_C(1);
    v1 = 2.0 * level;
    v2 = v1 / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    reach_t = (*cspan_at(&work_t, side + layout__SIDE_SEARCH_BEST)) + (2.0 * level_t - v2 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    reach = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) + v2;
    smallest_gap__list_minima(work, tables, side, state, reach, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)));
    i_end = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_LAST))) + INT64_C(1);
    for (i = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST))); i < i_end; i += INT64_C(1))
    {
        if (count < layout__REGION_LIMIT)
        {
            y_t = (*cspan_at(&work_t, side + layout__SIDE_SEARCH_CANDIDATES + layout__CANDIDATE_SIZE * i + layout__CANDIDATE_Y));
            y = (*cspan_at(&work, side + layout__SIDE_SEARCH_CANDIDATES + layout__CANDIDATE_SIZE * i + layout__CANDIDATE_Y));
            abscissa_t = (*cspan_at(&work_t, side + layout__SIDE_SEARCH_CANDIDATES + layout__CANDIDATE_SIZE * i + layout__CANDIDATE_RAIL));
            abscissa = (*cspan_at(&work, side + layout__SIDE_SEARCH_CANDIDATES + layout__CANDIDATE_SIZE * i + layout__CANDIDATE_RAIL));
            tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
            v3 = abscissa - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
            v4 = height - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z));
            station_t = (abscissa_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + v3 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + ((height_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) + v4 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)));
            station = v3 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + v4 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
            tangent_traces__start_traces_t(work, work_t, station, station_t, abscissa, abscissa_t, y, y_t);
            tangent_regions__minimum_rule_t(&n5, &n5_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * count, state, station, station_t);
            if (n5 < level)
            {
                if (regions__is_new(work, count) == INT64_C(1))
                {
                    count = count + INT64_C(1);
                }
            }
        }
    }
    return count;
}

/* Tangent of ``bound_regions``. */
static inline int64_t tangent_regions__bound_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double level, double level_t)
{
    int64_t i;
    int64_t j;
    int64_t low;
    int64_t high;
    double station;
    double station_t;
    double gap;
    double gap_t;
    double bound_t;
    double bound;
    for (i = INT64_C(0); i < count - INT64_C(1); i += INT64_C(1))
    {
        for (j = INT64_C(0); j < count - INT64_C(1) - i; j += INT64_C(1))
        {
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j + layout__REGION_STATION)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (j + INT64_C(1)) + layout__REGION_STATION)))
            {
                tangent_regions__swap_regions_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (j + INT64_C(1)));
            }
        }
    }
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_LOW)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_LOW)) = -regions__BEYOND;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (count - INT64_C(1)) + layout__REGION_HIGH)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (count - INT64_C(1)) + layout__REGION_HIGH)) = regions__BEYOND;
    i = INT64_C(0);
    while(i < count - INT64_C(1))
    {
        low = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        high = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (i + INT64_C(1));
        tangent_regions__saddle_rule_t(&station, &station_t, &gap, &gap_t, work, work_t, tables, low, high, state);
        if (gap < regions__MERGE * level)
        {
            if ((*cspan_at(&work, high + layout__REGION_GAP)) < (*cspan_at(&work, low + layout__REGION_GAP)))
            {
                bound_t = (*cspan_at(&work_t, low + layout__REGION_LOW));
                bound = (*cspan_at(&work, low + layout__REGION_LOW));
                tangent_regions__swap_regions_t(work, work_t, low, high);
                (*cspan_at(&work_t, low + layout__REGION_LOW)) = bound_t;
                (*cspan_at(&work, low + layout__REGION_LOW)) = bound;
            }
            for (j = i + INT64_C(1); j < count - INT64_C(1); j += INT64_C(1))
            {
                tangent_regions__swap_regions_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (j + INT64_C(1)));
            }
            count = count - INT64_C(1);
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (count - INT64_C(1)) + layout__REGION_HIGH)) = 0.0;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (count - INT64_C(1)) + layout__REGION_HIGH)) = regions__BEYOND;
        }
        else
        {
            (*cspan_at(&work_t, low + layout__REGION_HIGH)) = station_t;
            (*cspan_at(&work, low + layout__REGION_HIGH)) = station;
            (*cspan_at(&work_t, high + layout__REGION_LOW)) = station_t;
            (*cspan_at(&work, high + layout__REGION_LOW)) = station;
            i = i + INT64_C(1);
        }
    }
    return count;
}

/* Tangent of ``swap_regions``. */
static inline int64_t tangent_regions__swap_regions_t(array_double_1d work, array_double_1d work_t, int64_t first, int64_t second)
{
    int64_t i;
    double kept_t;
    double kept;
    for (i = INT64_C(0); i < layout__REGION_SIZE; i += INT64_C(1))
    {
        kept_t = (*cspan_at(&work_t, first + i));
        kept = (*cspan_at(&work, first + i));
        (*cspan_at(&work_t, first + i)) = (*cspan_at(&work_t, second + i));
        (*cspan_at(&work, first + i)) = (*cspan_at(&work, second + i));
        (*cspan_at(&work_t, second + i)) = kept_t;
        (*cspan_at(&work, second + i)) = kept;
    }
    return INT64_C(0);
}

/* Tangent of ``minimum_rule``. */
static inline int64_t tangent_regions__minimum_rule_t(double* found, double* found_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, array_double_1d state, double station, double station_t)
{
    double n1;
    double place_t;
    double place;
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double v2;
    double v3;
    double v3_t;
    n1 = regions__open_region(work, tables, region, state, station);
    (*found_t) = 0.0;
    (*found) = n1;
    if ((*found) < regions__BEYOND)
    {
        place_t = 0.0;
        place = (*cspan_at(&work, region + layout__REGION_STATION));
        tangent_traces__start_traces_t(work, work_t, place, place_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), 0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), 0.0);
        tangent_contact_plane__normal_gap_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, place, place_t, regions__PLACE_TRACE, 0.0);
        v2 = -rate;
        place_t = (-rate_t) / bend;
        tangent_regions__open_region_t(&v3, &v3_t, work, work_t, tables, region, state, place, place_t);
        (*found_t) = v3_t;
        (*found) = v3;
    }
    return 0;
}

/* Tangent of ``saddle_rule``. */
static inline int64_t tangent_regions__saddle_rule_t(double* station, double* station_t, double* gap, double* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t low, int64_t high, array_double_1d state)
{
    double way_t;
    double way;
    double v1;
    double place_t;
    double place;
    double saddle;
    double saddle_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double v2;
    regions__find_saddle(station, gap, work, tables, low, high, state);
    (*station_t) = 0.0;
    way_t = (*cspan_at(&work_t, high + layout__REGION_STATION)) - (*cspan_at(&work_t, low + layout__REGION_STATION));
    way = (*cspan_at(&work, high + layout__REGION_STATION)) - (*cspan_at(&work, low + layout__REGION_STATION));
    v1 = ((*station) - (*cspan_at(&work, low + layout__REGION_STATION))) / way;
    place_t = (*cspan_at(&work_t, low + layout__REGION_STATION)) + way_t * v1;
    place = (*cspan_at(&work, low + layout__REGION_STATION)) + way * v1;
    if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_STATION)) == (*station))
    {
        tangent_traces__start_traces_t(work, work_t, (*station), 0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), 0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA)), 0.0);
        tangent_contact_plane__normal_gap_t(&saddle, &saddle_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, (*station), 0.0, regions__PLACE_TRACE, 0.0);
        if ((bend < 0.0) && (fabs(rate) < (-10.0) * regions__PLACE_SHARP * bend))
        {
            v2 = -rate;
            place_t = (-rate_t) / bend;
            place = v2 / bend;
        }
    }
    (*station_t) = place_t;
    (*result_3) = 0.0;
    return 0;
}
