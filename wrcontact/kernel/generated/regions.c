/* Generated from contact/regions.py by tools/transpile_kernel.py; change that one.
 *
 * Where a wheel may carry load: the contact point's own region and others whose gap is small enough.
 *
 * A region is the neighbourhood of a local minimum of the normal gap.  Between two minima lies a saddle, where
 * the gap is largest.  Both belong to one region while the saddle stays below MERGE of the penetration;
 * otherwise it bounds both.
 */

#include "regions.h"

/* Start a region at the gap's local minimum near ``station``; its gap [m] (BEYOND if there is none). */
static inline double regions__open_region(array_double_1d work, array_double_1d tables, int64_t region, array_double_1d state, double station)
{
    double start;
    double gap;
    double bend;
    double curvature;
    double low;
    double high;
    int64_t i;
    double rate;
    double move;
    double height;
    double slope;
    double found;
    start = station;
    gap = regions__BEYOND;
    found = regions__BEYOND;
    bend = 0.0;
    curvature = 0.0;
    low = start - regions__WANDER;
    high = start + regions__WANDER;
    for (i = INT64_C(0); i < regions__MINIMUM_ITERATIONS; i += INT64_C(1))
    {
        contact_plane__normal_gap(&gap, &rate, &bend, &curvature, work, tables, state, station, regions__PLACE_TRACE);
        /* downhill, until the gap bends upwards */
        move = -regions__DOWNHILL;
        if (rate < 0.0)
        {
            move = regions__DOWNHILL;
            low = station;
        }
        else
        {
            high = station;
        }
        if (bend > 0.0)
        {
            move = (-rate) / bend;
            if (fabs(move) < regions__PLACE_SHARP)
            {
                found = gap;
            }
        }
        if (((station + move > high) && (high < start + regions__WANDER)) || ((station + move < low) && (low > start - regions__WANDER)))
        {
            /* the curvature jumps in between */
            move = 0.5 * (low + high) - station;
        }
        if (station + move > start + regions__WANDER)
        {
            move = start + regions__WANDER - station;
        }
        if (station + move < start - regions__WANDER)
        {
            move = start - regions__WANDER - station;
        }
        if (fabs(move) < regions__PLACE_SHARP)
        {
            break;
        }
        station += move;
    }
    (*cspan_at(&work, region + layout__REGION_STATION)) = station;
    (*cspan_at(&work, region + layout__REGION_GAP)) = gap;
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    (*cspan_at(&work, region + layout__REGION_BEND)) = bend;
    (*cspan_at(&work, region + layout__REGION_CURVATURE)) = curvature;
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    regions__incline_region(work, tables, region, slope);
    return found;
}

/* Give a region in the contact point's plane its inclination, the rail's ``slope`` there, and what
 * follows from it.
 */
static inline int64_t regions__incline_region(array_double_1d work, array_double_1d tables, int64_t region, double slope)
{
    double cosine;
    cosine = 1.0 / sqrt(1.0 + slope * slope);
    (*cspan_at(&work, region + layout__REGION_INCLINATION)) = slope;
    (*cspan_at(&work, region + layout__REGION_OWN)) = (double)(0);
    (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) = 1.0;
    (*cspan_at(&work, region + layout__REGION_OFFSET)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_COS)) = cosine;
    (*cspan_at(&work, region + layout__REGION_SIN)) = slope * cosine;
    (*cspan_at(&work, region + layout__REGION_SHARE)) = 1.0;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
    {
        (*cspan_at(&work, region + layout__REGION_SHARE)) = cosine;
    }
    return INT64_C(0);
}

/* Note in the open frame how the gap bends at the contact point, and the wheel's 1/R_x. */
static inline int64_t regions__measure_contact(array_double_1d work, array_double_1d tables, array_double_1d state)
{
    double gap;
    double rate;
    double bend;
    double curvature;
    contact_plane__normal_gap(&gap, &rate, &bend, &curvature, work, tables, state, 0.0, regions__PLACE_TRACE);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND)) = bend;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE)) = curvature;
    return INT64_C(0);
}

/* The region of the rigid contact point itself, station and gap zero. */
static inline int64_t regions__open_contact_region(array_double_1d work, array_double_1d tables, int64_t region)
{
    (*cspan_at(&work, region + layout__REGION_STATION)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_GAP)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_RAIL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_WHEEL + layout__POINT_Y));
    (*cspan_at(&work, region + layout__REGION_BEND)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BEND));
    (*cspan_at(&work, region + layout__REGION_CURVATURE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_CURVATURE));
    (*cspan_at(&work, region + layout__REGION_LOW)) = -regions__BEYOND;
    (*cspan_at(&work, region + layout__REGION_HIGH)) = regions__BEYOND;
    regions__incline_region(work, tables, region, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN)) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)));
    return INT64_C(0);
}

/* Open the regions whose smallest gap is below ``level`` [m]; their count, region 0 included.
 *
 * They are sought at the local minima of the vertical gap.
 */
static inline int64_t regions__find_regions(array_double_1d work, array_double_1d tables, int64_t side, array_double_1d state, double level)
{
    double reach;
    int64_t i_end;
    int64_t i;
    double y;
    double abscissa;
    double height;
    double slope;
    double station;
    int64_t count;
    count = INT64_C(1);
    reach = (*cspan_at(&work, side + layout__SIDE_SEARCH_BEST)) + 2.0 * level / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
    smallest_gap__list_minima(work, tables, side, state, reach, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y)));
    i_end = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_LAST))) + INT64_C(1);
    for (i = (int64_t)((*cspan_at(&work, side + layout__SIDE_SEARCH_FIRST))); i < i_end; i += INT64_C(1))
    {
        if (count < layout__REGION_LIMIT)
        {
            y = (*cspan_at(&work, side + layout__SIDE_SEARCH_CANDIDATES + layout__CANDIDATE_SIZE * i + layout__CANDIDATE_Y));
            abscissa = (*cspan_at(&work, side + layout__SIDE_SEARCH_CANDIDATES + layout__CANDIDATE_SIZE * i + layout__CANDIDATE_RAIL));
            profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
            station = (abscissa - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Y))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS)) + (height - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAIL + layout__POINT_Z))) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_SIN));
            traces__start_traces(work, station, abscissa, y);
            if (regions__open_region(work, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * count, state, station) < level)
            {
                if (regions__is_new(work, count) == INT64_C(1))
                {
                    count += INT64_C(1);
                }
            }
        }
    }
    return count;
}

/* 1 if region ``count`` is away from all before it, else 0. */
static inline int64_t regions__is_new(array_double_1d work, int64_t count)
{
    int64_t i;
    double distance;
    int64_t new;
    new = INT64_C(1);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        distance = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i + layout__REGION_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * count + layout__REGION_STATION));
        if (fabs(distance) < regions__SEPARATE)
        {
            new = INT64_C(0);
        }
    }
    return new;
}

/* Order the regions by station, set the saddles between them as bounds, and join those with a low saddle;
 * the count.
 */
static inline int64_t regions__bound_regions(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double level)
{
    int64_t i;
    int64_t j;
    int64_t low;
    int64_t high;
    double station;
    double gap;
    double bound;
    for (i = INT64_C(0); i < count - INT64_C(1); i += INT64_C(1))
    {
        for (j = INT64_C(0); j < count - INT64_C(1) - i; j += INT64_C(1))
        {
            if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j + layout__REGION_STATION)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (j + INT64_C(1)) + layout__REGION_STATION)))
            {
                regions__swap_regions(work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (j + INT64_C(1)));
            }
        }
    }
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_LOW)) = -regions__BEYOND;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (count - INT64_C(1)) + layout__REGION_HIGH)) = regions__BEYOND;
    i = INT64_C(0);
    while(i < count - INT64_C(1))
    {
        low = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        high = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (i + INT64_C(1));
        regions__find_saddle(&station, &gap, work, tables, low, high, state);
        if (gap < regions__MERGE * level)
        {
            if ((*cspan_at(&work, high + layout__REGION_GAP)) < (*cspan_at(&work, low + layout__REGION_GAP)))
            {
                bound = (*cspan_at(&work, low + layout__REGION_LOW));
                regions__swap_regions(work, low, high);
                (*cspan_at(&work, low + layout__REGION_LOW)) = bound;
            }
            for (j = i + INT64_C(1); j < count - INT64_C(1); j += INT64_C(1))
            {
                regions__swap_regions(work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (j + INT64_C(1)));
            }
            count -= INT64_C(1);
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (count - INT64_C(1)) + layout__REGION_HIGH)) = regions__BEYOND;
        }
        else
        {
            (*cspan_at(&work, low + layout__REGION_HIGH)) = station;
            (*cspan_at(&work, high + layout__REGION_LOW)) = station;
            i += INT64_C(1);
        }
    }
    return count;
}

/* Exchange two regions. */
static inline int64_t regions__swap_regions(array_double_1d work, int64_t first, int64_t second)
{
    int64_t i;
    double kept;
    for (i = INT64_C(0); i < layout__REGION_SIZE; i += INT64_C(1))
    {
        kept = (*cspan_at(&work, first + i));
        (*cspan_at(&work, first + i)) = (*cspan_at(&work, second + i));
        (*cspan_at(&work, second + i)) = kept;
    }
    return INT64_C(0);
}

/* Station and gap [m] of the saddle between two regions: best of SADDLE_SAMPLES, then
 * Newton on the rate.
 */
static inline int64_t regions__find_saddle(double* result_0_0001, double* result_1_0001, array_double_1d work, array_double_1d tables, int64_t low, int64_t high, array_double_1d state)
{
    double left;
    double right;
    double step;
    double top;
    double largest;
    int64_t i;
    double station;
    double gap;
    double rate;
    double bend;
    double curvature;
    double move;
    left = (*cspan_at(&work, low + layout__REGION_STATION));
    right = (*cspan_at(&work, high + layout__REGION_STATION));
    traces__start_traces(work, left, (*cspan_at(&work, low + layout__REGION_RAIL)), (*cspan_at(&work, low + layout__REGION_WHEEL)));
    step = (right - left) / (double)(regions__SADDLE_SAMPLES + INT64_C(1));
    top = left;
    largest = -regions__BEYOND;
    for (i = INT64_C(1); i < regions__SADDLE_SAMPLES + INT64_C(1); i += INT64_C(1))
    {
        station = left + step * (double)(i);
        contact_plane__normal_gap(&gap, &rate, &bend, &curvature, work, tables, state, station, regions__PLACE_TRACE);
        if (gap > largest)
        {
            largest = gap;
            top = station;
        }
    }
    station = top;
    for (i = INT64_C(0); i < regions__MINIMUM_ITERATIONS; i += INT64_C(1))
    {
        contact_plane__normal_gap(&gap, &rate, &bend, &curvature, work, tables, state, station, regions__PLACE_TRACE);
        if ((!(bend < 0.0)) || (fabs(station - top) > step))
        {
            (*result_0_0001) = top;
            (*result_1_0001) = largest;
            return 0;
        }
        move = (-rate) / bend;
        if (fabs(move) < regions__PLACE_SHARP)
        {
            (*result_0_0001) = station;
            (*result_1_0001) = gap;
            return 0;
        }
        station += move;
    }
    (*result_0_0001) = top;
    (*result_1_0001) = largest;
    return 0;
}
