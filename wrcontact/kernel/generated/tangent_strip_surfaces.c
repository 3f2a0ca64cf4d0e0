/* Generated from tangent_strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_surfaces.py.
 */

#include "tangent_strip_surfaces.h"

/* Tangent of ``trace_strips``. */
static inline int64_t tangent_strip_surfaces__trace_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count)
{
    int64_t index;
    int64_t region;
    int64_t started;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        tangent_planes__enter_plane_t(work, work_t, region, index);
        started = INT64_C(0);
        i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
        for (i = INT64_C(0); i < i_end; i += INT64_C(1))
        {
            strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
            if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) == index)
            {
                if (started == INT64_C(0))
                {
                    tangent_traces__start_traces_t(work, work_t, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work_t, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work_t, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)), (*cspan_at(&work_t, region + layout__REGION_WHEEL)));
                    tangent_curves__open_origin_t(work, work_t, tables, region, 0.0, 0.0);
                    started = INT64_C(1);
                }
                tangent_strip_surfaces__trace_strip_t(work, work_t, tables, state, region, strip);
            }
        }
        tangent_planes__leave_plane_t(work, work_t, region);
    }
    return INT64_C(0);
}

/* Tangent of ``trace_strip``. */
static inline int64_t tangent_strip_surfaces__trace_strip_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t region, int64_t strip)
{
    double gap;
    double gap_t;
    double rate;
    double rate_t;
    double bend;
    double bend_t;
    double curvature;
    double curvature_t;
    double height;
    double height_t;
    double slope;
    double slope_t;
    double v1;
    double v2;
    double v3;
    double v4;
    double v4_t;
    tangent_separation__separation_t(&gap, &gap_t, &rate, &rate_t, &bend, &bend_t, &curvature, &curvature_t, work, work_t, tables, state, (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)), (*cspan_at(&work_t, strip + layout__STRIP_STATION)) - (*cspan_at(&work_t, region + layout__REGION_OFFSET)), strip_surfaces__STRIP_TRACE, 0.0);
    (*cspan_at(&work_t, strip + layout__STRIP_RISE)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_RISE)) = 0.0;
    (*cspan_at(&work_t, strip + layout__STRIP_OVERLAP)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_OVERLAP)) = -contact_plane__NO_GAP;
    if (gap < contact_plane__NO_GAP)
    {
        (*cspan_at(&work_t, strip + layout__STRIP_OVERLAP)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) - gap_t;
        (*cspan_at(&work, strip + layout__STRIP_OVERLAP)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) - gap;
        (*cspan_at(&work_t, strip + layout__STRIP_RISE)) = -rate_t;
        (*cspan_at(&work, strip + layout__STRIP_RISE)) = -rate;
    }
    tangent_profile_table__height_slope_t(&height, &height_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    v1 = 1.0 + slope * slope;
    v2 = sqrt(v1);
    v3 = 1.0 / v2;
    (*cspan_at(&work_t, strip + layout__STRIP_COS)) = (-v3) * tangent_rates__root_rate(v2, slope_t * slope + slope * slope_t) / v2;
    (*cspan_at(&work, strip + layout__STRIP_COS)) = v3;
    (*cspan_at(&work_t, strip + layout__STRIP_SIN)) = slope_t * (*cspan_at(&work, strip + layout__STRIP_COS)) + slope * (*cspan_at(&work_t, strip + layout__STRIP_COS));
    (*cspan_at(&work, strip + layout__STRIP_SIN)) = slope * (*cspan_at(&work, strip + layout__STRIP_COS));
    (*cspan_at(&work_t, strip + layout__STRIP_X)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_X)) = 0.0;
    (*cspan_at(&work_t, strip + layout__STRIP_A)) = 0.5 * curvature_t;
    (*cspan_at(&work, strip + layout__STRIP_A)) = 0.5 * curvature;
    (*cspan_at(&work_t, strip + layout__STRIP_SKEW)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_SKEW)) = 0.0;
    (*cspan_at(&work_t, strip + layout__STRIP_WHEEL)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    (*cspan_at(&work, strip + layout__STRIP_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    if (contact_plane__is_yawed(work) == INT64_C(1))
    {
        tangent_locus__outline_x_t(&v4, &v4_t, work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, strip + layout__STRIP_WHEEL)), (*cspan_at(&work_t, strip + layout__STRIP_WHEEL)));
        (*cspan_at(&work_t, strip + layout__STRIP_X)) = v4_t;
        (*cspan_at(&work, strip + layout__STRIP_X)) = v4;
    }
    return INT64_C(0);
}

/* Tangent of ``place_on_middle``. */
static inline int64_t tangent_strip_surfaces__place_on_middle_t(array_double_1d work, array_double_1d work_t, int64_t count)
{
    double stretch_t;
    double stretch;
    int64_t i;
    int64_t strip;
    int64_t before;
    int64_t after;
    double turned_t;
    double turned;
    double reach_t;
    double reach;
    double last_t;
    double last;
    double v1;
    double v2;
    double v3;
    double way_t;
    double way;
    double v4;
    double v5;
    stretch_t = 0.0;
    stretch = 1.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        before = i;
        after = i;
        if ((i > INT64_C(0)) && ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_JOINED)) == 1.0))
        {
            before = i - INT64_C(1);
        }
        if ((i < count - INT64_C(1)) && ((*cspan_at(&work, strip + layout__STRIP_JOINED)) == 1.0))
        {
            after = i + INT64_C(1);
        }
        turned_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_COS)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_SIN)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_COS)) - ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_SIN)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_COS)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_SIN)));
        turned = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_COS)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_SIN));
        reach_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_STATION));
        reach = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_STATION));
        last_t = stretch_t;
        last = stretch;
        stretch_t = 0.0;
        stretch = 1.0;
        if ((reach > 0.0) && ((*cspan_at(&work, strip + layout__STRIP_OVERLAP)) > 0.0))
        {
            v1 = 0.5 * (*cspan_at(&work, strip + layout__STRIP_OVERLAP));
            v2 = v1 * turned;
            v3 = v2 / reach;
            stretch_t = -((0.5 * (*cspan_at(&work_t, strip + layout__STRIP_OVERLAP)) * turned + v1 * turned_t - v3 * reach_t) / reach);
            stretch = 1.0 - v3;
        }
        (*cspan_at(&work_t, strip + layout__STRIP_BREADTH)) = (*cspan_at(&work_t, strip + layout__STRIP_WIDTH)) * stretch + (*cspan_at(&work, strip + layout__STRIP_WIDTH)) * stretch_t;
        (*cspan_at(&work, strip + layout__STRIP_BREADTH)) = (*cspan_at(&work, strip + layout__STRIP_WIDTH)) * stretch;
        (*cspan_at(&work_t, strip + layout__STRIP_PLACE)) = (*cspan_at(&work_t, strip + layout__STRIP_STATION));
        (*cspan_at(&work, strip + layout__STRIP_PLACE)) = (*cspan_at(&work, strip + layout__STRIP_STATION));
        if (i > INT64_C(0))
        {
            way_t = (*cspan_at(&work_t, strip + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
            way = (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
            v4 = last + stretch;
            v5 = 0.5 * v4;
            (*cspan_at(&work_t, strip + layout__STRIP_PLACE)) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PLACE)) + (0.5 * (last_t + stretch_t) * way + v5 * way_t);
            (*cspan_at(&work, strip + layout__STRIP_PLACE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PLACE)) + v5 * way;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``incline_strips``. */
static inline int64_t tangent_strip_surfaces__incline_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double half_t;
    double half;
    double v1;
    double v2;
    double v3;
    double scale_t;
    double scale;
    double v4;
    double v5;
    double cosine_t;
    double cosine;
    double v6;
    double v7;
    double v7_t;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        half_t = 0.5 * (*cspan_at(&work_t, strip + layout__STRIP_RISE));
        half = 0.5 * (*cspan_at(&work, strip + layout__STRIP_RISE));
        v1 = 1.0 + half * half;
        v2 = sqrt(v1);
        v3 = 1.0 / v2;
        scale_t = (-v3) * tangent_rates__root_rate(v2, half_t * half + half * half_t) / v2;
        scale = v3;
        v4 = (*cspan_at(&work, strip + layout__STRIP_COS)) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        (*cspan_at(&work_t, strip + layout__STRIP_SHARE)) = ((*cspan_at(&work_t, strip + layout__STRIP_COS)) - v4 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        (*cspan_at(&work, strip + layout__STRIP_SHARE)) = v4;
        v5 = (*cspan_at(&work, strip + layout__STRIP_COS)) - half * (*cspan_at(&work, strip + layout__STRIP_SIN));
        cosine_t = ((*cspan_at(&work_t, strip + layout__STRIP_COS)) - (half_t * (*cspan_at(&work, strip + layout__STRIP_SIN)) + half * (*cspan_at(&work_t, strip + layout__STRIP_SIN)))) * scale + v5 * scale_t;
        cosine = v5 * scale;
        v6 = (*cspan_at(&work, strip + layout__STRIP_SIN)) + half * (*cspan_at(&work, strip + layout__STRIP_COS));
        (*cspan_at(&work_t, strip + layout__STRIP_SIN)) = ((*cspan_at(&work_t, strip + layout__STRIP_SIN)) + (half_t * (*cspan_at(&work, strip + layout__STRIP_COS)) + half * (*cspan_at(&work_t, strip + layout__STRIP_COS)))) * scale + v6 * scale_t;
        (*cspan_at(&work, strip + layout__STRIP_SIN)) = v6 * scale;
        (*cspan_at(&work_t, strip + layout__STRIP_COS)) = cosine_t;
        (*cspan_at(&work, strip + layout__STRIP_COS)) = cosine;
        (*cspan_at(&work_t, strip + layout__STRIP_COUNTED)) = 0.0;
        (*cspan_at(&work, strip + layout__STRIP_COUNTED)) = 1.0;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            tangent_rails__upright_share_t(&v7, &v7_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), cosine, cosine_t, (*cspan_at(&work, strip + layout__STRIP_SIN)), (*cspan_at(&work_t, strip + layout__STRIP_SIN)));
            (*cspan_at(&work_t, strip + layout__STRIP_COUNTED)) = v7_t;
            (*cspan_at(&work, strip + layout__STRIP_COUNTED)) = v7;
        }
    }
    return INT64_C(0);
}

/* Tangent of ``profile_within``. */
static inline int64_t tangent_strip_surfaces__profile_within_t(double* z, double* z_t, array_double_1d tables, double y, double y_t)
{
    int64_t wheel;
    double slope;
    double slope_t;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    if (y < (*cspan_at(&tables, wheel + layout__PROFILE_START)))
    {
        y_t = 0.0;
        y = (*cspan_at(&tables, wheel + layout__PROFILE_START));
    }
    if (y > (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))
    {
        y_t = 0.0;
        y = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
    }
    tangent_profile_table__height_slope_t(z, z_t, &slope, &slope_t, tables, wheel, y, y_t);
    return 0;
}

/* Tangent of ``measure_ridge``. */
static inline int64_t tangent_strip_surfaces__measure_ridge_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, int64_t strip, double away, double away_t)
{
    double v1;
    double across_t;
    double across;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double v2;
    double v2_t;
    double before_t;
    double before;
    double v3;
    double v3_t;
    double after_t;
    double after;
    double mean_t;
    double mean;
    double square_t;
    double square;
    double v4;
    double v5;
    double v6;
    double v6_t;
    double v7;
    double odd_t;
    double odd;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LONGITUDINAL))) != layout__LONGITUDINAL_BASIC)
    {
        v1 = away * (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
        across_t = (away_t * (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) + away * (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW))) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) + v1 * (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL));
        across = v1 * (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
        tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, strip + layout__STRIP_WHEEL)), (*cspan_at(&work_t, strip + layout__STRIP_WHEEL)));
        tangent_strip_surfaces__profile_within_t(&v2, &v2_t, tables, (*cspan_at(&work, strip + layout__STRIP_WHEEL)) - across, (*cspan_at(&work_t, strip + layout__STRIP_WHEEL)) - across_t);
        before_t = v2_t;
        before = v2;
        tangent_strip_surfaces__profile_within_t(&v3, &v3_t, tables, (*cspan_at(&work, strip + layout__STRIP_WHEEL)) + across, (*cspan_at(&work_t, strip + layout__STRIP_WHEEL)) + across_t);
        after_t = v3_t;
        after = v3;
        mean_t = bend_t;
        mean = bend;
        square_t = across_t * across + across * across_t;
        square = across * across;
        if (square > 0.0)
        {
            v4 = before + after - 2.0 * z;
            v5 = v4 / square;
            mean_t = (before_t + after_t - 2.0 * z_t - v5 * square_t) / square;
            mean = v5;
        }
        tangent_longitudinal_curvature__longitudinal_curvature_t(&v6, &v6_t, work, work_t, tables, place, z, z_t, slope, slope_t, mean, mean_t);
        (*cspan_at(&work_t, strip + layout__STRIP_A)) = 0.5 * v6_t;
        (*cspan_at(&work, strip + layout__STRIP_A)) = 0.5 * v6;
        v7 = after - before;
        odd_t = 0.5 * (after_t - before_t) - (slope_t * across + slope * across_t);
        odd = 0.5 * v7 - slope * across;
        v8 = 1.0 + slope * slope;
        v9 = sqrt(v8);
        v10 = v9 * away;
        v11 = v10 * away;
        v12 = v11 * away;
        v13 = odd / v12;
        (*cspan_at(&work_t, strip + layout__STRIP_SKEW)) = (odd_t - v13 * (((tangent_rates__root_rate(v9, slope_t * slope + slope * slope_t) * away + v9 * away_t) * away + v10 * away_t) * away + v11 * away_t)) / v12;
        (*cspan_at(&work, strip + layout__STRIP_SKEW)) = v13;
    }
    return INT64_C(0);
}

/* Tangent of ``first_lengths``. */
static inline int64_t tangent_strip_surfaces__first_lengths_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count)
{
    int64_t index;
    int64_t region;
    int64_t zone;
    double depth_t;
    double depth;
    double middle_t;
    double middle;
    double A_t;
    double A;
    double v1;
    double v1_t;
    double low_t;
    double low;
    double v2;
    double v2_t;
    double high_t;
    double high;
    double v3;
    double v4;
    double B_t;
    double B;
    double one_alpha;
    double one_alpha_t;
    double one_beta;
    double one_beta_t;
    double nr;
    double nr_t;
    double lean_t;
    double lean;
    double v6;
    double v5;
    double v5_t;
    double low_beta_t;
    double low_beta;
    double v8;
    double v7;
    double v7_t;
    double high_beta_t;
    double high_beta;
    double v9;
    double v9_t;
    double slant_t;
    double slant;
    double alpha;
    double alpha_t;
    double beta;
    double beta_t;
    double v10;
    double v10_t;
    double v11;
    double v12;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double overlap_t;
    double overlap;
    double v13;
    double v14;
    double farthest_t;
    double farthest;
    double v16;
    double v15;
    double v15_t;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index;
        depth_t = (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) + (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - (*cspan_at(&work_t, region + layout__REGION_GAP));
        depth = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - (*cspan_at(&work, region + layout__REGION_GAP));
        middle_t = (*cspan_at(&work_t, region + layout__REGION_OFFSET)) + (*cspan_at(&work_t, region + layout__REGION_STATION));
        middle = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
        A_t = 0.5 * (*cspan_at(&work_t, region + layout__REGION_CURVATURE));
        A = 0.5 * (*cspan_at(&work, region + layout__REGION_CURVATURE));
        tangent_strip_surfaces__zone_curvature_t(&v1, &v1_t, depth, depth_t, middle - (*cspan_at(&work, zone + layout__STRIP_ZONE_START)), middle_t - (*cspan_at(&work_t, zone + layout__STRIP_ZONE_START)), A, A_t);
        low_t = v1_t;
        low = v1;
        tangent_strip_surfaces__zone_curvature_t(&v2, &v2_t, depth, depth_t, (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - middle, (*cspan_at(&work_t, zone + layout__STRIP_ZONE_STOP)) - middle_t, A, A_t);
        high_t = v2_t;
        high = v2;
        v3 = low * high;
        v4 = sqrt(v3);
        B_t = tangent_rates__root_rate(v4, low_t * high + low * high_t);
        B = v4;
        tangent_hertz__hertz_coefficients_t(&one_alpha, &one_alpha_t, &one_beta, &one_beta_t, &nr, &nr_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, A_t, B, B_t);
        lean_t = 0.0;
        lean = 0.0;
        v6 = A / low;
        tangent_hertz__table_value_t(&v5, &v5_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(v6), (A_t - v6 * low_t) / low / v6);
        low_beta_t = v5_t;
        low_beta = v5;
        v8 = A / high;
        tangent_hertz__table_value_t(&v7, &v7_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(v8), (A_t - v8 * high_t) / high / v8);
        high_beta_t = v7_t;
        high_beta = v7;
        if (contact_plane__is_yawed(work) == INT64_C(1))
        {
            tangent_strip_surfaces__ridge_slant_t(&v9, &v9_t, work, work_t, index);
            slant_t = v9_t;
            slant = v9;
            tangent_hertz__skewed_coefficients_t(&alpha, &alpha_t, &beta, &beta_t, &nr, &nr_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, A_t, B, B_t, slant, slant_t);
            tangent_hertz__middle_slant_t(&v10, &v10_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, A_t, B, B_t, slant, slant_t);
            lean_t = v10_t - slant_t;
            lean = v10 - slant;
            v11 = beta / one_beta;
            low_beta_t = low_beta_t * v11 + low_beta * ((beta_t - v11 * one_beta_t) / one_beta);
            low_beta = low_beta * v11;
            v12 = beta / one_beta;
            high_beta_t = high_beta_t * v12 + high_beta * ((beta_t - v12 * one_beta_t) / one_beta);
            high_beta = high_beta * v12;
            one_alpha_t = alpha_t;
            one_alpha = alpha;
        }
        i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
        for (i = INT64_C(0); i < i_end; i += INT64_C(1))
        {
            strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
            if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) == index)
            {
                if (contact_plane__is_yawed(work) == INT64_C(1))
                {
                    overlap_t = (*cspan_at(&work_t, strip + layout__STRIP_OVERLAP));
                    overlap = (*cspan_at(&work, strip + layout__STRIP_OVERLAP));
                    if (overlap < strip_surfaces__LEAST_OVERLAP * depth)
                    {
                        overlap_t = strip_surfaces__LEAST_OVERLAP * depth_t;
                        overlap = strip_surfaces__LEAST_OVERLAP * depth;
                    }
                    v13 = overlap * (*cspan_at(&tables, layout__TABLES_RADIUS));
                    v14 = sqrt(v13);
                    tangent_strip_surfaces__measure_ridge_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), strip, strip_lengths__TESTED * v14, strip_lengths__TESTED * tangent_rates__root_rate(v14, overlap_t * (*cspan_at(&tables, layout__TABLES_RADIUS))));
                }
                beta_t = low_beta_t;
                beta = low_beta;
                if ((*cspan_at(&work, strip + layout__STRIP_STATION)) > middle)
                {
                    beta_t = high_beta_t;
                    beta = high_beta;
                }
                tangent_strip_surfaces__first_length_t(work, work_t, strip, depth, depth_t, one_alpha, one_alpha_t, beta, beta_t);
                farthest_t = strip_surfaces__FIRST_LEAD * (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH));
                farthest = strip_surfaces__FIRST_LEAD * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
                v16 = (*cspan_at(&work, strip + layout__STRIP_STATION)) - middle;
                tangent_touching__limited_t(&v15, &v15_t, lean * v16, lean_t * v16 + lean * ((*cspan_at(&work_t, strip + layout__STRIP_STATION)) - middle_t), farthest, farthest_t);
                (*cspan_at(&work_t, strip + layout__STRIP_LEAD)) = v15_t;
                (*cspan_at(&work, strip + layout__STRIP_LEAD)) = v15;
            }
        }
    }
    tangent_strip_lengths__limit_lengths_t(work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}

/* Tangent of ``ridge_slant``. */
static inline int64_t tangent_strip_surfaces__ridge_slant_t(double* slant, double* slant_t, array_double_1d work, array_double_1d work_t, int64_t index)
{
    int64_t first;
    int64_t last;
    int64_t i_end;
    int64_t i;
    double v1;
    double v2;
    double v3;
    first = -INT64_C(1);
    last = -INT64_C(1);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        if ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION))) == index)
        {
            if (first < INT64_C(0))
            {
                first = i;
            }
            last = i;
        }
    }
    (*slant_t) = 0.0;
    (*slant) = 0.0;
    if (last > first)
    {
        v1 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_X)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_X));
        v2 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_STATION));
        v3 = v1 / v2;
        (*slant_t) = ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_X)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_X)) - v3 * ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_STATION)))) / v2;
        (*slant) = v3;
    }
    return 0;
}

/* Tangent of ``zone_curvature``. */
static inline int64_t tangent_strip_surfaces__zone_curvature_t(double* B, double* B_t, double depth, double depth_t, double width, double width_t, double A, double A_t)
{
    double most_t;
    double most;
    double v1;
    double v2;
    most_t = strip_surfaces__SHARPEST_ZONE * A_t;
    most = strip_surfaces__SHARPEST_ZONE * A;
    (*B_t) = most_t;
    (*B) = most;
    if (depth < most * width * width)
    {
        v1 = width * width;
        v2 = depth / v1;
        (*B_t) = (depth_t - v2 * (width_t * width + width * width_t)) / v1;
        (*B) = v2;
    }
    if ((*B) < strip_surfaces__FLATTEST_ZONE * A)
    {
        (*B_t) = strip_surfaces__FLATTEST_ZONE * A_t;
        (*B) = strip_surfaces__FLATTEST_ZONE * A;
    }
    return 0;
}

/* Tangent of ``first_length``. */
static inline int64_t tangent_strip_surfaces__first_length_t(array_double_1d work, array_double_1d work_t, int64_t strip, double depth, double depth_t, double one_alpha, double one_alpha_t, double one_beta, double one_beta_t)
{
    double v1;
    double level_t;
    double level;
    double least_t;
    double least;
    double v2;
    double v3;
    double v4;
    v1 = depth - (*cspan_at(&work, strip + layout__STRIP_OVERLAP));
    level_t = depth_t - (one_beta_t * v1 + one_beta * (depth_t - (*cspan_at(&work_t, strip + layout__STRIP_OVERLAP))));
    level = depth - one_beta * v1;
    (*cspan_at(&work_t, strip + layout__STRIP_LOADED)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(level > 0.0);
    least_t = strip_surfaces__INSIDE * (*cspan_at(&work_t, strip + layout__STRIP_OVERLAP));
    least = strip_surfaces__INSIDE * (*cspan_at(&work, strip + layout__STRIP_OVERLAP));
    if (least < strip_surfaces__LEAST_OVERLAP * depth)
    {
        least_t = strip_surfaces__LEAST_OVERLAP * depth_t;
        least = strip_surfaces__LEAST_OVERLAP * depth;
    }
    if (level < least)
    {
        level_t = least_t;
        level = least;
    }
    v2 = one_alpha * (*cspan_at(&work, strip + layout__STRIP_A));
    v3 = level / v2;
    v4 = sqrt(v3);
    (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) = tangent_rates__root_rate(v4, (level_t - v3 * (one_alpha_t * (*cspan_at(&work, strip + layout__STRIP_A)) + one_alpha * (*cspan_at(&work_t, strip + layout__STRIP_A)))) / v2);
    (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = v4;
    return INT64_C(0);
}

/* Tangent of ``lengths_before``. */
static inline int64_t tangent_strip_surfaces__lengths_before_t(array_double_1d work, array_double_1d work_t, array_double_1d tables)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    tangent_strip_layout__length_before_t(work, work_t);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if (contact_plane__is_yawed(work) == INT64_C(1))
        {
            tangent_strip_surfaces__measure_ridge_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), strip, strip_lengths__TESTED * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)), strip_lengths__TESTED * (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)));
        }
    }
    tangent_strip_lengths__limit_lengths_t(work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}

/* Tangent of ``set_gaps``. */
static inline int64_t tangent_strip_surfaces__set_gaps_t(array_double_1d work, array_double_1d work_t)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double v1;
    double v1_t;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        tangent_strip_lengths__gap_beside_t(&v1, &v1_t, work, work_t, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)), (*cspan_at(&work_t, strip + layout__STRIP_LEAD)));
        (*cspan_at(&work_t, strip + layout__STRIP_GAP)) = (*cspan_at(&work_t, strip + layout__STRIP_SHARE)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) + (*cspan_at(&work, strip + layout__STRIP_SHARE)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - (*cspan_at(&work_t, strip + layout__STRIP_OVERLAP)) + v1_t;
        (*cspan_at(&work, strip + layout__STRIP_GAP)) = (*cspan_at(&work, strip + layout__STRIP_SHARE)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - (*cspan_at(&work, strip + layout__STRIP_OVERLAP)) + v1;
    }
    return INT64_C(0);
}
