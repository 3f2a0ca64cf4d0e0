/* Generated from tangent_strip_patches.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of strip_patches.py.
 */

#include "tangent_strip_patches.h"

/* Tangent of ``fill_from_strips``. */
static inline int64_t tangent_strip_patches__fill_from_strips_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count)
{
    int64_t index;
    int64_t first;
    int64_t last;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        tangent_strip_patches__load_region_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index, index);
    }
    tangent_filling__clear_patches_t(work, work_t);
    first = INT64_C(0);
    while((first < (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)))) && ((int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_COUNT))) < layout__SOLVED_PATCH_LIMIT))
    {
        last = first;
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_LINE_LOAD)) > 0.0)
        {
            last = strip_edges__run_end(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))), first);
            tangent_strip_patches__fill_run_t(work, work_t, first, last);
        }
        first = last + INT64_C(1);
    }
    tangent_filling__finish_patches_t(work, work_t);
    return INT64_C(0);
}

/* Tangent of ``fill_run``. */
static inline int64_t tangent_strip_patches__fill_run_t(array_double_1d work, array_double_1d work_t, int64_t first, int64_t last)
{
    double v1;
    double v1_t;
    double start_t;
    double start;
    double v2;
    double v2_t;
    double stop_t;
    double stop;
    int64_t region;
    int64_t n3;
    int64_t index;
    int64_t patch;
    int64_t i;
    double load_t;
    double load;
    double v4;
    double v4_t;
    double v5;
    double v5_t;
    double pressure_t;
    double pressure;
    double v6;
    double v6_t;
    if (last > first)
    {
        tangent_strip_patches__end_like_ellipse_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (first + INT64_C(1)));
        tangent_strip_patches__end_like_ellipse_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (last - INT64_C(1)));
    }
    tangent_strip_edges__run_edge_t(&v1, &v1_t, work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))), first, last, -INT64_C(1));
    start_t = v1_t;
    start = v1;
    tangent_strip_edges__run_edge_t(&v2, &v2_t, work, work_t, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))), last, first, INT64_C(1));
    stop_t = v2_t;
    stop = v2;
    region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_REGION)));
    n3 = tangent_filling__begin_patch_t(work, work_t, region, start, start_t, first, layout__RULE_STRAIGHT, -atan((*cspan_at(&work, region + layout__REGION_INCLINATION))), -((*cspan_at(&work_t, region + layout__REGION_INCLINATION)) / (1.0 + (*cspan_at(&work, region + layout__REGION_INCLINATION)) * (*cspan_at(&work, region + layout__REGION_INCLINATION)))));
    index = n3;
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    for (i = first; i < last + INT64_C(1); i += INT64_C(1))
    {
        tangent_strip_patches__add_strip_t(work, work_t, patch, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * i);
        load_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH));
        load = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_WIDTH));
        tangent_filling__add_part_t(work, work_t, index, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_REGION))), load, load_t, load * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)), load_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) + load * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)));
    }
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = stop_t;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = stop;
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_LAST)) = 0.0;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST)) = (double)(last);
    tangent_strip_patches__run_area_t(&v4, &v4_t, work, work_t, first, last, start, start_t, stop, stop_t);
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA)) = v4_t;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA)) = v4;
    tangent_strip_patches__largest_pressure_t(&v5, &v5_t, work, work_t, first, last);
    pressure_t = v5_t;
    pressure = v5;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = pressure_t * pressure + pressure * pressure_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PRESSURE_SQUARE)) = pressure * pressure;
    tangent_strip_patches__largest_square_t(&v6, &v6_t, work, work_t, first, last);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = v6_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_HALF_LENGTH_SQUARE)) = v6;
    tangent_filling__finish_patch_t(work, work_t);
    return INT64_C(0);
}

/* Tangent of ``end_like_ellipse``. */
static inline int64_t tangent_strip_patches__end_like_ellipse_t(array_double_1d work, array_double_1d work_t, int64_t edge, int64_t inner)
{
    double v1;
    double v2;
    double square_t;
    double square;
    double v3;
    double v4;
    v1 = (*cspan_at(&work, inner + layout__STRIP_HALF_LENGTH_SQUARE)) * (*cspan_at(&work, edge + layout__STRIP_LINE_LOAD));
    v2 = v1 / (*cspan_at(&work, inner + layout__STRIP_LINE_LOAD));
    square_t = ((*cspan_at(&work_t, inner + layout__STRIP_HALF_LENGTH_SQUARE)) * (*cspan_at(&work, edge + layout__STRIP_LINE_LOAD)) + (*cspan_at(&work, inner + layout__STRIP_HALF_LENGTH_SQUARE)) * (*cspan_at(&work_t, edge + layout__STRIP_LINE_LOAD)) - v2 * (*cspan_at(&work_t, inner + layout__STRIP_LINE_LOAD))) / (*cspan_at(&work, inner + layout__STRIP_LINE_LOAD));
    square = v2;
    if (square < (*cspan_at(&work, edge + layout__STRIP_HALF_LENGTH_SQUARE)))
    {
        v3 = (*cspan_at(&work, edge + layout__STRIP_HALF_LENGTH_SQUARE)) / square;
        v4 = sqrt(v3);
        (*cspan_at(&work_t, edge + layout__STRIP_PRESSURE)) = (*cspan_at(&work_t, edge + layout__STRIP_PRESSURE)) * v4 + (*cspan_at(&work, edge + layout__STRIP_PRESSURE)) * tangent_rates__root_rate(v4, ((*cspan_at(&work_t, edge + layout__STRIP_HALF_LENGTH_SQUARE)) - v3 * square_t) / square);
        (*cspan_at(&work, edge + layout__STRIP_PRESSURE)) = (*cspan_at(&work, edge + layout__STRIP_PRESSURE)) * v4;
        (*cspan_at(&work_t, edge + layout__STRIP_HALF_LENGTH_SQUARE)) = square_t;
        (*cspan_at(&work, edge + layout__STRIP_HALF_LENGTH_SQUARE)) = square;
    }
    return INT64_C(0);
}

/* Tangent of ``add_strip``. */
static inline int64_t tangent_strip_patches__add_strip_t(array_double_1d work, array_double_1d work_t, int64_t patch, int64_t strip, int64_t to)
{
    double load_t;
    double load;
    load_t = (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH)) + (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
    load = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) + load_t;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) + load;
    (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) + (load_t * (*cspan_at(&work, strip + layout__STRIP_STATION)) + load * (*cspan_at(&work_t, strip + layout__STRIP_STATION)));
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) + load * (*cspan_at(&work, strip + layout__STRIP_STATION));
    (*cspan_at(&work_t, to + layout__SOLVED_STRIP_STATION)) = (*cspan_at(&work_t, strip + layout__STRIP_STATION));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_STATION)) = (*cspan_at(&work, strip + layout__STRIP_STATION));
    (*cspan_at(&work_t, to + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_WIDTH)) = (*cspan_at(&work, strip + layout__STRIP_WIDTH));
    (*cspan_at(&work_t, to + layout__SOLVED_STRIP_X)) = (*cspan_at(&work_t, strip + layout__STRIP_X)) + (*cspan_at(&work_t, strip + layout__STRIP_NEXT_LEAD));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_X)) = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD));
    (*cspan_at(&work_t, to + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work_t, strip + layout__STRIP_A));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_CURVATURE)) = 2.0 * (*cspan_at(&work, strip + layout__STRIP_A));
    (*cspan_at(&work_t, to + layout__SOLVED_STRIP_LINE_LOAD)) = (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_LINE_LOAD)) = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD));
    (*cspan_at(&work_t, to + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH_SQUARE));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)) = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE));
    (*cspan_at(&work_t, to + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = (*cspan_at(&work_t, strip + layout__STRIP_PRESSURE)) * (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) + (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) * (*cspan_at(&work_t, strip + layout__STRIP_PRESSURE));
    (*cspan_at(&work, to + layout__SOLVED_STRIP_PRESSURE_SQUARE)) = (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) * (*cspan_at(&work, strip + layout__STRIP_PRESSURE));
    return INT64_C(0);
}

/* Tangent of ``load_region``. */
static inline int64_t tangent_strip_patches__load_region_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t region, int64_t index)
{
    double load_t;
    double load;
    double moment_t;
    double moment;
    double cosines_t;
    double cosines;
    double sines_t;
    double sines;
    double x_t;
    double x;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double own_t;
    double own;
    double v1;
    double v2;
    double v3;
    double v4;
    double v4_t;
    double v5;
    double v6;
    load_t = 0.0;
    load = 0.0;
    moment_t = 0.0;
    moment = 0.0;
    cosines_t = 0.0;
    cosines = 0.0;
    sines_t = 0.0;
    sines = 0.0;
    x_t = 0.0;
    x = 0.0;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) == index)
        {
            own_t = (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH)) + (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
            own = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            load_t = load_t + own_t;
            load = load + own;
            moment_t = moment_t + (own_t * (*cspan_at(&work, strip + layout__STRIP_STATION)) + own * (*cspan_at(&work_t, strip + layout__STRIP_STATION)));
            moment = moment + own * (*cspan_at(&work, strip + layout__STRIP_STATION));
            cosines_t = cosines_t + (own_t * (*cspan_at(&work, strip + layout__STRIP_COS)) + own * (*cspan_at(&work_t, strip + layout__STRIP_COS)));
            cosines = cosines + own * (*cspan_at(&work, strip + layout__STRIP_COS));
            sines_t = sines_t + (own_t * (*cspan_at(&work, strip + layout__STRIP_SIN)) + own * (*cspan_at(&work_t, strip + layout__STRIP_SIN)));
            sines = sines + own * (*cspan_at(&work, strip + layout__STRIP_SIN));
            v1 = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD));
            x_t = x_t + (own_t * v1 + own * ((*cspan_at(&work_t, strip + layout__STRIP_X)) + (*cspan_at(&work_t, strip + layout__STRIP_NEXT_LEAD))));
            x = x + own * v1;
        }
    }
    (*cspan_at(&work_t, region + layout__REGION_CARRIED)) = load_t;
    (*cspan_at(&work, region + layout__REGION_CARRIED)) = load;
    (*cspan_at(&work_t, region + layout__REGION_MOMENT)) = moment_t;
    (*cspan_at(&work, region + layout__REGION_MOMENT)) = moment;
    (*cspan_at(&work_t, region + layout__REGION_SLANT)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_SLANT)) = 0.0;
    if (load > 0.0)
    {
        v2 = cosines / load;
        (*cspan_at(&work_t, region + layout__REGION_COS)) = (cosines_t - v2 * load_t) / load;
        (*cspan_at(&work, region + layout__REGION_COS)) = v2;
        v3 = sines / load;
        (*cspan_at(&work_t, region + layout__REGION_SIN)) = (sines_t - v3 * load_t) / load;
        (*cspan_at(&work, region + layout__REGION_SIN)) = v3;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            tangent_rails__upright_share_t(&v4, &v4_t, work, work_t, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, region + layout__REGION_COS)), (*cspan_at(&work_t, region + layout__REGION_COS)), (*cspan_at(&work, region + layout__REGION_SIN)), (*cspan_at(&work_t, region + layout__REGION_SIN)));
            (*cspan_at(&work_t, region + layout__REGION_SHARE)) = v4_t;
            (*cspan_at(&work, region + layout__REGION_SHARE)) = v4;
        }
        v5 = moment / load;
        v6 = x / load;
        tangent_strip_patches__slant_region_t(work, work_t, region, index, v5, (moment_t - v5 * load_t) / load, v6, (x_t - v6 * load_t) / load);
    }
    return INT64_C(0);
}

/* Tangent of ``slant_region``. */
static inline int64_t tangent_strip_patches__slant_region_t(array_double_1d work, array_double_1d work_t, int64_t region, int64_t index, double station, double station_t, double x, double x_t)
{
    double along_t;
    double along;
    double spread_t;
    double spread;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double own_t;
    double own;
    double away_t;
    double away;
    double v1;
    double v2;
    double v3;
    double v4;
    along_t = 0.0;
    along = 0.0;
    spread_t = 0.0;
    spread = 0.0;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) == index)
        {
            own_t = (*cspan_at(&work_t, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH)) + (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work_t, strip + layout__STRIP_WIDTH));
            own = (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) * (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            away_t = (*cspan_at(&work_t, strip + layout__STRIP_STATION)) - station_t;
            away = (*cspan_at(&work, strip + layout__STRIP_STATION)) - station;
            v1 = own * away;
            v2 = (*cspan_at(&work, strip + layout__STRIP_X)) + (*cspan_at(&work, strip + layout__STRIP_NEXT_LEAD)) - x;
            along_t = along_t + ((own_t * away + own * away_t) * v2 + v1 * ((*cspan_at(&work_t, strip + layout__STRIP_X)) + (*cspan_at(&work_t, strip + layout__STRIP_NEXT_LEAD)) - x_t));
            along = along + v1 * v2;
            v3 = own * away;
            spread_t = spread_t + ((own_t * away + own * away_t) * away + v3 * away_t);
            spread = spread + v3 * away;
        }
    }
    if (spread > strip_patches__CLOSE * strip_patches__CLOSE * (*cspan_at(&work, region + layout__REGION_CARRIED)))
    {
        v4 = along / spread;
        (*cspan_at(&work_t, region + layout__REGION_SLANT)) = (along_t - v4 * spread_t) / spread;
        (*cspan_at(&work, region + layout__REGION_SLANT)) = v4;
    }
    return INT64_C(0);
}

/* Tangent of ``add_stiffness``. */
static inline int64_t tangent_strip_patches__add_stiffness_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t count)
{
    int64_t index;
    double scale;
    int64_t size;
    int64_t i_end;
    int64_t i;
    int64_t rank;
    int64_t row;
    int64_t strip;
    int64_t region;
    double v1;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index + layout__REGION_STIFFNESS)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index + layout__REGION_STIFFNESS)) = 0.0;
    }
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    size = INT64_C(0);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_LOADED)) == 1.0)
        {
            size = size + INT64_C(1);
        }
    }
    for (rank = INT64_C(0); rank < size; rank += INT64_C(1))
    {
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * rank;
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_LOADED + rank)));
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * (int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION)));
        v1 = scale * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
        (*cspan_at(&work_t, region + layout__REGION_STIFFNESS)) = (*cspan_at(&work_t, region + layout__REGION_STIFFNESS)) + (scale * (*cspan_at(&work_t, strip + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, row + size)) + v1 * (*cspan_at(&work_t, row + size)));
        (*cspan_at(&work, region + layout__REGION_STIFFNESS)) = (*cspan_at(&work, region + layout__REGION_STIFFNESS)) + v1 * (*cspan_at(&work, row + size));
    }
    return INT64_C(0);
}

/* Tangent of ``divided_bend``. */
static inline int64_t tangent_strip_patches__divided_bend_t(double* v7, double* result_1, array_double_1d work, array_double_1d work_t, int64_t i, double before, double before_t, double value, double value_t, double after, double after_t)
{
    double left_t;
    double left;
    double right_t;
    double right;
    double v1;
    double v2;
    double upper_t;
    double upper;
    double v3;
    double v4;
    double lower_t;
    double lower;
    double v5;
    double v6;
    left_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
    left = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
    right_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION));
    right = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION));
    v1 = after - value;
    v2 = v1 / right;
    upper_t = (after_t - value_t - v2 * right_t) / right;
    upper = v2;
    v3 = value - before;
    v4 = v3 / left;
    lower_t = (value_t - before_t - v4 * left_t) / left;
    lower = v4;
    v5 = upper - lower;
    v6 = left + right;
    (*v7) = v5 / v6;
    (*result_1) = (upper_t - lower_t - (*v7) * (left_t + right_t)) / v6;
    return 0;
}

/* Tangent of ``square_bend``. */
static inline int64_t tangent_strip_patches__square_bend_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, int64_t i)
{
    double before_t;
    double before;
    before_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE));
    before = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE));
    tangent_strip_patches__divided_bend_t(v1, v1_t, work, work_t, i, before, before_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)));
    return 0;
}

/* Tangent of ``cell_bend``. */
static inline int64_t tangent_strip_patches__cell_bend_t(double* bend, double* bend_t, array_double_1d work, array_double_1d work_t, int64_t i, int64_t first, int64_t last)
{
    double found;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    (*bend_t) = 0.0;
    (*bend) = 0.0;
    found = 0.0;
    if ((i > first) && (i < last))
    {
        tangent_strip_patches__square_bend_t(&v1, &v1_t, work, work_t, i);
        (*bend_t) = (*bend_t) + v1_t;
        (*bend) = (*bend) + v1;
        found = found + 1.0;
    }
    if ((i + INT64_C(1) < last) && (i + INT64_C(1) > first))
    {
        tangent_strip_patches__square_bend_t(&v2, &v2_t, work, work_t, i + INT64_C(1));
        (*bend_t) = (*bend_t) + v2_t;
        (*bend) = (*bend) + v2;
        found = found + 1.0;
    }
    if (found > 0.0)
    {
        (*bend_t) = (*bend_t) / found;
        (*bend) = (*bend) / found;
    }
    return 0;
}

/* Tangent of ``cell_area``. */
static inline int64_t tangent_strip_patches__cell_area_t(double* result_0, double* result_1, double low, double low_t, double high, double high_t, double bend, double bend_t, double width, double width_t)
{
    double v2;
    double v3;
    double v1;
    double v1_t;
    v2 = 2.0 * bend;
    v3 = v2 * width;
    tangent_quadrature__root_integral_t(&v1, &v1_t, 2.0 * low - high + v3 * width, 2.0 * low_t - high_t + ((2.0 * bend_t * width + v2 * width_t) * width + v3 * width_t), low, low_t, high, high_t, 0.0, 0.0, 1.0, 0.0);
    (*result_0) = width * v1;
    (*result_1) = width_t * v1 + width * v1_t;
    return 0;
}

/* Tangent of ``run_area``. */
static inline int64_t tangent_strip_patches__run_area_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last, double start, double start_t, double stop, double stop_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double v2;
    double v2_t;
    double half_t;
    double half;
    int64_t i;
    double v3;
    double v3_t;
    double v4;
    double v4_t;
    double v5;
    double v5_t;
    double v6;
    double v6_t;
    tangent_strip_patches__cell_bend_t(&v1, &v1_t, work, work_t, first, first, last);
    bend_t = v1_t;
    bend = v1;
    tangent_strip_patches__cell_area_t(&v2, &v2_t, 0.0, 0.0, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_HALF_LENGTH_SQUARE)), bend, bend_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_STATION)) - start, (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_STATION)) - start_t);
    half_t = v2_t;
    half = v2;
    for (i = first; i < last; i += INT64_C(1))
    {
        tangent_strip_patches__cell_bend_t(&v3, &v3_t, work, work_t, i, first, last);
        bend_t = v3_t;
        bend = v3;
        tangent_strip_patches__cell_area_t(&v4, &v4_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)), bend, bend_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i + INT64_C(1)) + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)));
        half_t = half_t + v4_t;
        half = half + v4;
    }
    tangent_strip_patches__cell_bend_t(&v5, &v5_t, work, work_t, last - INT64_C(1), first, last);
    bend_t = v5_t;
    bend = v5;
    tangent_strip_patches__cell_area_t(&v6, &v6_t, (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_HALF_LENGTH_SQUARE)), 0.0, 0.0, bend, bend_t, stop - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)), stop_t - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)));
    half_t = half_t + v6_t;
    half = half + v6;
    (*result_0) = 2.0 * half;
    (*result_1) = 2.0 * half_t;
    return 0;
}

/* Tangent of ``summit``. */
static inline int64_t tangent_strip_patches__summit_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t i, double before, double before_t, double value, double value_t, double after, double after_t)
{
    double v1;
    double v1_t;
    double bend_t;
    double bend;
    double left_t;
    double left;
    double v2;
    double v3;
    double slope_t;
    double slope;
    double v4;
    double v5;
    double v6;
    tangent_strip_patches__divided_bend_t(&v1, &v1_t, work, work_t, i, before, before_t, value, value_t, after, after_t);
    bend_t = v1_t;
    bend = v1;
    if (bend < 0.0)
    {
        left_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
        left = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
        v2 = value - before;
        v3 = v2 / left;
        slope_t = (value_t - before_t - v3 * left_t) / left + (bend_t * left + bend * left_t);
        slope = v3 + bend * left;
        v4 = slope * slope;
        v5 = 4.0 * bend;
        v6 = v4 / v5;
        value_t = value_t - (slope_t * slope + slope * slope_t - v6 * (4.0 * bend_t)) / v5;
        value = value - v6;
    }
    (*result_0) = value;
    (*result_1) = value_t;
    return 0;
}

/* Tangent of ``largest_pressure``. */
static inline int64_t tangent_strip_patches__largest_pressure_t(double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last)
{
    int64_t best;
    int64_t i;
    double before_t;
    double before;
    double v1;
    double v1_t;
    best = first;
    for (i = first; i < last + INT64_C(1); i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_PRESSURE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_PRESSURE)))
        {
            best = i;
        }
    }
    (*pressure_t) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_PRESSURE));
    (*pressure) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_PRESSURE));
    if ((best > first) && (best < last))
    {
        before_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best - INT64_C(1)) + layout__STRIP_PRESSURE));
        before = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best - INT64_C(1)) + layout__STRIP_PRESSURE));
        tangent_strip_patches__summit_t(&v1, &v1_t, work, work_t, best, before, before_t, (*pressure), (*pressure_t), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best + INT64_C(1)) + layout__STRIP_PRESSURE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best + INT64_C(1)) + layout__STRIP_PRESSURE)));
        (*pressure_t) = v1_t;
        (*pressure) = v1;
    }
    return 0;
}

/* Tangent of ``largest_square``. */
static inline int64_t tangent_strip_patches__largest_square_t(double* square, double* square_t, array_double_1d work, array_double_1d work_t, int64_t first, int64_t last)
{
    int64_t best;
    int64_t i;
    double before_t;
    double before;
    double v1;
    double v1_t;
    best = first;
    for (i = first; i < last + INT64_C(1); i += INT64_C(1))
    {
        if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i + layout__STRIP_HALF_LENGTH_SQUARE)) > (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_HALF_LENGTH_SQUARE)))
        {
            best = i;
        }
    }
    (*square_t) = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_HALF_LENGTH_SQUARE));
    (*square) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * best + layout__STRIP_HALF_LENGTH_SQUARE));
    if ((best > first) && (best < last))
    {
        before_t = (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best - INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE));
        before = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best - INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE));
        tangent_strip_patches__summit_t(&v1, &v1_t, work, work_t, best, before, before_t, (*square), (*square_t), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (best + INT64_C(1)) + layout__STRIP_HALF_LENGTH_SQUARE)));
        (*square_t) = v1_t;
        (*square) = v1;
    }
    return 0;
}
