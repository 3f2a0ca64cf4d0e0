/* Generated from normal/strip_surfaces.py by tools/transpile_kernel.py; change that one.
 *
 * What wheel and rail are at each strip: overlap, inclination, ridge, and the gap beside it.
 */

#include "strip_surfaces.h"

/* Overlap, its rise, inclination and ridge of all strips, which lie in ``count`` regions. */
static inline int64_t strip_surfaces__trace_strips(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count)
{
    int64_t index;
    int64_t region;
    int64_t started;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_BLUR)) = 0.0;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        planes__enter_plane(work, region, index);
        started = INT64_C(0);
        i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
        for (i = INT64_C(0); i < i_end; i += INT64_C(1))
        {
            strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
            if ((int64_t)((*cspan_at(&work, strip + layout__STRIP_REGION))) == index)
            {
                if (started == INT64_C(0))
                {
                    traces__start_traces(work, (*cspan_at(&work, region + layout__REGION_STATION)), (*cspan_at(&work, region + layout__REGION_RAIL)), (*cspan_at(&work, region + layout__REGION_WHEEL)));
                    curves__open_origin(work, tables, region, 0.0);
                    started = INT64_C(1);
                }
                strip_surfaces__trace_strip(work, tables, state, region, strip);
            }
        }
        planes__leave_plane(work, region);
    }
    return INT64_C(0);
}

/* The surfaces at a strip of ``region``, whose frame is open. */
static inline int64_t strip_surfaces__trace_strip(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t region, int64_t strip)
{
    double gap;
    double rate;
    double bend;
    double curvature;
    double height;
    double slope;
    separation__separation(&gap, &rate, &bend, &curvature, work, tables, state, (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, region + layout__REGION_OFFSET)), strip_surfaces__STRIP_TRACE);
    (*cspan_at(&work, strip + layout__STRIP_RISE)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_OVERLAP)) = -contact_plane__NO_GAP;
    if (gap < contact_plane__NO_GAP)
    {
        (*cspan_at(&work, strip + layout__STRIP_OVERLAP)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_RAISED)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_DEPTH)) - gap;
        (*cspan_at(&work, strip + layout__STRIP_RISE)) = -rate;
    }
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__RAIL + layout__TRACE_ABSCISSA)));
    (*cspan_at(&work, strip + layout__STRIP_COS)) = 1.0 / sqrt(1.0 + slope * slope);
    (*cspan_at(&work, strip + layout__STRIP_SIN)) = slope * (*cspan_at(&work, strip + layout__STRIP_COS));
    (*cspan_at(&work, strip + layout__STRIP_X)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_A)) = 0.5 * curvature;
    (*cspan_at(&work, strip + layout__STRIP_SKEW)) = 0.0;
    (*cspan_at(&work, strip + layout__STRIP_WHEEL)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_TRACES + layout__TRACE_SIZE * layout__WHEEL + layout__TRACE_ABSCISSA));
    if (contact_plane__is_yawed(work) == INT64_C(1))
    {
        (*cspan_at(&work, strip + layout__STRIP_X)) = locus__outline_x(work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), (*cspan_at(&work, strip + layout__STRIP_WHEEL)));
    }
    return INT64_C(0);
}

/* Places and breadths of the strips on the curve between wheel and rail, in the middle of the overlap.
 *
 * Where the rail bulges, that is shorter than the rail by half the overlap times its curvature; and it is
 * inclined by half of what the overlap rises.
 */
static inline int64_t strip_surfaces__place_on_middle(array_double_1d work, int64_t count)
{
    double stretch;
    int64_t i;
    int64_t strip;
    int64_t before;
    int64_t after;
    double turned;
    double reach;
    double last;
    double way;
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
        turned = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_SIN)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_COS)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_COS)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_SIN));
        reach = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * after + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * before + layout__STRIP_STATION));
        last = stretch;
        stretch = 1.0;
        if ((reach > 0.0) && ((*cspan_at(&work, strip + layout__STRIP_OVERLAP)) > 0.0))
        {
            stretch = 1.0 - 0.5 * (*cspan_at(&work, strip + layout__STRIP_OVERLAP)) * turned / reach;
        }
        (*cspan_at(&work, strip + layout__STRIP_BREADTH)) = (*cspan_at(&work, strip + layout__STRIP_WIDTH)) * stretch;
        (*cspan_at(&work, strip + layout__STRIP_PLACE)) = (*cspan_at(&work, strip + layout__STRIP_STATION));
        if (i > INT64_C(0))
        {
            way = (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_STATION));
            (*cspan_at(&work, strip + layout__STRIP_PLACE)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * (i - INT64_C(1)) + layout__STRIP_PLACE)) + 0.5 * (last + stretch) * way;
        }
    }
    return INT64_C(0);
}

/* Turn the strips to the mean of the normals of wheel and rail; what of penetration and load counts, and
 * the gap where nothing penetrates, for strips laid at the problem's penetration.
 */
static inline int64_t strip_surfaces__incline_strips(array_double_1d work, array_double_1d tables)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double half;
    double scale;
    double cosine;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        half = 0.5 * (*cspan_at(&work, strip + layout__STRIP_RISE));
        scale = 1.0 / sqrt(1.0 + half * half);
        (*cspan_at(&work, strip + layout__STRIP_SHARE)) = (*cspan_at(&work, strip + layout__STRIP_COS)) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLANE + layout__DIRECTION_COS));
        cosine = ((*cspan_at(&work, strip + layout__STRIP_COS)) - half * (*cspan_at(&work, strip + layout__STRIP_SIN))) * scale;
        (*cspan_at(&work, strip + layout__STRIP_SIN)) = ((*cspan_at(&work, strip + layout__STRIP_SIN)) + half * (*cspan_at(&work, strip + layout__STRIP_COS))) * scale;
        (*cspan_at(&work, strip + layout__STRIP_COS)) = cosine;
        (*cspan_at(&work, strip + layout__STRIP_COUNTED)) = 1.0;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            (*cspan_at(&work, strip + layout__STRIP_COUNTED)) = rails__upright_share(work, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), cosine, (*cspan_at(&work, strip + layout__STRIP_SIN)));
        }
    }
    return INT64_C(0);
}

/* Height [m] of the wheel's profile at ``y`` [m], or at the end that it lies beyond. */
static inline double strip_surfaces__profile_within(array_double_1d tables, double y)
{
    int64_t wheel;
    double slope;
    double z;
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    if (y < (*cspan_at(&tables, wheel + layout__PROFILE_START)))
    {
        y = (*cspan_at(&tables, wheel + layout__PROFILE_START));
    }
    if (y > (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))
    {
        y = (*cspan_at(&tables, wheel + layout__PROFILE_STOP));
    }
    profile_table__height_slope(&z, &slope, tables, wheel, y);
    return z;
}

/* A and skew of the gap beside a yawed wheel's ridge, which at a distance ``away`` along x are those of
 * the wheel there.
 *
 * Along x a yawed wheel shows other parts of its profile, to either side of the ridge's.
 */
static inline int64_t strip_surfaces__measure_ridge(array_double_1d work, array_double_1d tables, int64_t place, int64_t strip, double away)
{
    double across;
    double z;
    double slope;
    double bend;
    double before;
    double after;
    double mean;
    double square;
    double odd;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LONGITUDINAL))) != layout__LONGITUDINAL_BASIC)
    {
        across = away * (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
        profile_table__height_slope_bend(&z, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), (*cspan_at(&work, strip + layout__STRIP_WHEEL)));
        before = strip_surfaces__profile_within(tables, (*cspan_at(&work, strip + layout__STRIP_WHEEL)) - across);
        after = strip_surfaces__profile_within(tables, (*cspan_at(&work, strip + layout__STRIP_WHEEL)) + across);
        mean = bend;
        square = across * across;
        if (square > 0.0)
        {
            mean = (before + after - 2.0 * z) / square;
        }
        (*cspan_at(&work, strip + layout__STRIP_A)) = 0.5 * longitudinal_curvature__longitudinal_curvature(work, tables, place, z, slope, mean);
        odd = 0.5 * (after - before) - slope * across;
        (*cspan_at(&work, strip + layout__STRIP_SKEW)) = odd / (sqrt(1.0 + slope * slope) * away * away * away);
    }
    return INT64_C(0);
}

/* Half-lengths of the strips, which lie in ``count`` regions, from how wide their zones are:
 * those of Hertz's ellipse for gap and curvature at each strip.
 */
static inline int64_t strip_surfaces__first_lengths(array_double_1d work, array_double_1d tables, int64_t count)
{
    int64_t index;
    int64_t region;
    int64_t zone;
    double depth;
    double middle;
    double A;
    double low;
    double high;
    double B;
    double one_alpha;
    double one_beta;
    double nr;
    double lean;
    double low_beta;
    double high_beta;
    double slant;
    double alpha;
    double beta;
    int64_t i_end;
    int64_t i;
    int64_t strip;
    double overlap;
    double farthest;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        zone = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_ZONES + layout__STRIP_ZONE_SIZE * index;
        depth = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - (*cspan_at(&work, region + layout__REGION_GAP));
        middle = (*cspan_at(&work, region + layout__REGION_OFFSET)) + (*cspan_at(&work, region + layout__REGION_STATION));
        A = 0.5 * (*cspan_at(&work, region + layout__REGION_CURVATURE));
        low = strip_surfaces__zone_curvature(depth, middle - (*cspan_at(&work, zone + layout__STRIP_ZONE_START)), A);
        high = strip_surfaces__zone_curvature(depth, (*cspan_at(&work, zone + layout__STRIP_ZONE_STOP)) - middle, A);
        B = sqrt(low * high);
        hertz__hertz_coefficients(&one_alpha, &one_beta, &nr, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, B);
        lean = 0.0;
        low_beta = hertz__table_value(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(A / low));
        high_beta = hertz__table_value(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(A / high));
        if (contact_plane__is_yawed(work) == INT64_C(1))
        {
            slant = strip_surfaces__ridge_slant(work, index);
            hertz__skewed_coefficients(&alpha, &beta, &nr, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, B, slant);
            lean = hertz__middle_slant(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, B, slant) - slant;
            low_beta *= beta / one_beta;
            high_beta *= beta / one_beta;
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
                    overlap = (*cspan_at(&work, strip + layout__STRIP_OVERLAP));
                    if (overlap < strip_surfaces__LEAST_OVERLAP * depth)
                    {
                        overlap = strip_surfaces__LEAST_OVERLAP * depth;
                    }
                    strip_surfaces__measure_ridge(work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), strip, strip_lengths__TESTED * sqrt(overlap * (*cspan_at(&tables, layout__TABLES_RADIUS))));
                }
                beta = low_beta;
                if ((*cspan_at(&work, strip + layout__STRIP_STATION)) > middle)
                {
                    beta = high_beta;
                }
                strip_surfaces__first_length(work, strip, depth, one_alpha, beta);
                farthest = strip_surfaces__FIRST_LEAD * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
                (*cspan_at(&work, strip + layout__STRIP_LEAD)) = touching__limited(lean * ((*cspan_at(&work, strip + layout__STRIP_STATION)) - middle), farthest);
            }
        }
    }
    strip_lengths__limit_lengths(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}

/* Mean slope dx/ds of the ridge over the strips of the region with number ``index`` [-]; 0 where it has
 * fewer than two.
 */
static inline double strip_surfaces__ridge_slant(array_double_1d work, int64_t index)
{
    int64_t first;
    int64_t last;
    int64_t i_end;
    int64_t i;
    double slant;
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
    slant = 0.0;
    if (last > first)
    {
        slant = ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_X)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_X))) / ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * last + layout__STRIP_STATION)) - (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * first + layout__STRIP_STATION)));
    }
    return slant;
}

/* Lateral curvature [1/m] with which the gap rises by most of the ``depth`` [m] over the ``width`` of a
 * zone to one side [m]; between FLATTEST_ZONE A and SHARPEST_ZONE A.
 */
static inline double strip_surfaces__zone_curvature(double depth, double width, double A)
{
    double most;
    double B;
    most = strip_surfaces__SHARPEST_ZONE * A;
    B = most;
    if (depth < most * width * width)
    {
        B = depth / (width * width);
    }
    if (B < strip_surfaces__FLATTEST_ZONE * A)
    {
        B = strip_surfaces__FLATTEST_ZONE * A;
    }
    return B;
}

/* Half-length of a strip in a region of this ``depth`` [m], by ANALYN's coefficients of its zone. */
static inline int64_t strip_surfaces__first_length(array_double_1d work, int64_t strip, double depth, double one_alpha, double one_beta)
{
    double level;
    double least;
    level = depth - one_beta * (depth - (*cspan_at(&work, strip + layout__STRIP_OVERLAP)));
    (*cspan_at(&work, strip + layout__STRIP_LOADED)) = (double)(level > 0.0);
    least = strip_surfaces__INSIDE * (*cspan_at(&work, strip + layout__STRIP_OVERLAP));
    if (least < strip_surfaces__LEAST_OVERLAP * depth)
    {
        least = strip_surfaces__LEAST_OVERLAP * depth;
    }
    if (level < least)
    {
        level = least;
    }
    (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = sqrt(level / (one_alpha * (*cspan_at(&work, strip + layout__STRIP_A))));
    return INT64_C(0);
}

/* Half-lengths and leads of the strips from the layout before. */
static inline int64_t strip_surfaces__lengths_before(array_double_1d work, array_double_1d tables)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    strip_layout__length_before(work);
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if (contact_plane__is_yawed(work) == INT64_C(1))
        {
            strip_surfaces__measure_ridge(work, tables, layout__WORK_CONTACT + layout__CONTACT_FRAME + (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_FRAME + layout__FRAME_PLACE))), strip, strip_lengths__TESTED * (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)));
        }
    }
    strip_lengths__limit_lengths(work, (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT))));
    return INT64_C(0);
}

/* The gap in the middle of every strip where nothing penetrates. */
static inline int64_t strip_surfaces__set_gaps(array_double_1d work)
{
    int64_t i_end;
    int64_t i;
    int64_t strip;
    i_end = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        (*cspan_at(&work, strip + layout__STRIP_GAP)) = (*cspan_at(&work, strip + layout__STRIP_SHARE)) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_PENETRATION)) - (*cspan_at(&work, strip + layout__STRIP_OVERLAP)) + strip_lengths__gap_beside(work, strip, (*cspan_at(&work, strip + layout__STRIP_LEAD)));
    }
    return INT64_C(0);
}
