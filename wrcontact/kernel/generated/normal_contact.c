/* Generated from normal/normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The normal contact of one side: estimate, regions, nodes, levels, patches.
 *
 * 1. estimate the penetration from the force and the width of the interpenetration,
 * 2. find the regions that it reaches, and the half-width of each one's interpenetration, which sets
 * 3. spacing and window of the nodes, on which
 * 4. the force is met.
 *
 * The estimate depends on pose and force alone and moves smoothly with them, and so does the result.
 */

#include "normal_contact.h"

/* ((3 N / 4 E*)^2 (A + B))^(1/3) [m], Hertz's eq. (2.8) with r = 1 and a typical B. */
static inline double normal_contact__guess_penetration(double force, double A, double contact_modulus)
{
    double share;
    share = 0.75 * force / contact_modulus;
    return pow((share * share * (1.0 + normal_contact__TYPICAL_RATIO) * A), (1.0 / 3.0));
}

/* Half-widths of the region's interpenetration at ``level`` [m], the lateral curvatures on both sides that follow from
 * them, and the station its load is thought to act at.
 */
static inline int64_t normal_contact__measure_widths(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t region, double level)
{
    int64_t block;
    double bend;
    double low;
    double high;
    double grown;
    double high_reached;
    double slant;
    double start;
    int64_t yawed;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    /* the first guess: the gap's own second derivative, as far as it is a usual one */
    bend = (*cspan_at(&work, block + layout__REGION_BEND));
    if (bend < normal_contact__LEAST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE)))
    {
        bend = normal_contact__LEAST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE));
    }
    if (bend > normal_contact__MOST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE)))
    {
        bend = normal_contact__MOST_BEND * (*cspan_at(&work, block + layout__REGION_CURVATURE));
    }
    low = sqrt(2.0 * level / bend);
    high = low;
    if ((*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)) > 0.0)
    {
        grown = sqrt(level / (*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)));
        low = (*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) * grown;
        high = (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)) * grown;
    }
    high = regions__zone_width(tables, work, state, block, 1.0, level, high);
    high_reached = (*cspan_at(&work, block + layout__REGION_REACHED));
    slant = 0.0;
    start = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION));
    yawed = contact_plane__is_yawed(work);
    if (yawed == INT64_C(1))
    {
        slant = contact_plane__ridge_place(tables, work, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
    }
    if (!((*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)) > 0.0))
    {
        low = high;
    }
    low = regions__zone_width(tables, work, state, block, -1.0, level, low);
    if (yawed == INT64_C(1))
    {
        slant -= contact_plane__ridge_place(tables, work, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_WHEEL)));
        if (start > (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)))
        {
            (*cspan_at(&work, block + layout__REGION_SLANT)) = slant / (start - (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_TRACER_STATION)));
        }
    }
    (*cspan_at(&work, block + layout__REGION_SIDE_HIGH)) = normal_contact__side_curvature(high_reached, high, 0.5 * (low + high));
    (*cspan_at(&work, block + layout__REGION_SIDE_LOW)) = normal_contact__side_curvature((*cspan_at(&work, block + layout__REGION_REACHED)), low, 0.5 * (low + high));
    (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)) = high;
    (*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) = low;
    (*cspan_at(&work, block + layout__REGION_WIDTH_LEVEL)) = level;
    (*cspan_at(&work, block + layout__REGION_MIDDLE)) = (*cspan_at(&work, block + layout__REGION_STATION)) + 0.5 * (high - low);
    return INT64_C(0);
}

/* g / w^2 [1/m] where the gap has risen to g = ``reached`` at the half-width w = ``own``, enlarged where that side is
 * the narrower, up to NARROWER times.
 */
static inline double normal_contact__side_curvature(double reached, double own, double mean)
{
    double ratio;
    double curvature;
    curvature = 0.0;
    if (own > 0.0)
    {
        ratio = mean / own;
        if (ratio > normal_contact__NARROWER)
        {
            ratio = normal_contact__NARROWER;
        }
        curvature = reached / (own * own) * ratio * ratio;
    }
    return curvature;
}

/* Share of the level up to which the gap is laid with nodes on a side with lateral curvature ``side`` [1/m]: strips
 * are loaded while (1 + beta) g is below the level.  With prepared curvatures 1 + beta may fall to 1.
 */
static inline double normal_contact__zone_share(array_double_1d tables, double A, double side)
{
    double spread;
    double share;
    if (side < nodes__FLOOR * A)
    {
        side = nodes__FLOOR * A;
    }
    spread = normal_contact__SPREAD;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_ANALYN_STRIP)
    {
        spread = normal_contact__STRIP_SPREAD;
    }
    share = spread / hertz__table_value(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), INT64_C(0), log(A / side));
    if ((share > normal_contact__COVER) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE))
    {
        share = normal_contact__COVER;
    }
    return share;
}

/* Every so many of the nodes are traced on the profiles.
 *
 * All of them are where curvatures are read there, where chords lead to them, and for vertical distances: on a steep side
 * these rise too fast for a cubic over several nodes, which falls below zero before.
 */
static inline int64_t normal_contact__node_stride(array_double_1d tables)
{
    int64_t kind;
    int64_t stride;
    stride = (int64_t)((*cspan_at(&tables, layout__TABLES_STRIDE)));
    kind = (int64_t)((*cspan_at(&tables, layout__TABLES_SEPARATION)));
    if (((int64_t)((*cspan_at(&tables, layout__TABLES_LATERAL))) != layout__LATERAL_ADAPTIVE) || (kind == layout__SEPARATION_CHORD) || (kind == layout__SEPARATION_VERTICAL))
    {
        stride = INT64_C(1);
    }
    return stride;
}

/* Widths, nodes and coefficients of all regions at their levels times ``enlarge``. */
static inline int64_t normal_contact__prepare_regions(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double enlarge)
{
    int64_t window;
    int64_t stride;
    int64_t i;
    int64_t block;
    double level;
    double mean;
    double widest;
    double least;
    double spacing;
    double A;
    double low_reach;
    double high_reach;
    window = (int64_t)((*cspan_at(&tables, layout__TABLES_NODES)) * normal_contact__WINDOW + 0.5);
    stride = normal_contact__node_stride(tables);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * i;
        level = (*cspan_at(&work, block + layout__REGION_LEVEL));
        planes__enter_plane(work, i);
        normal_contact__measure_widths(tables, work, state, i, normal_contact__MEASURED * level);
        mean = 0.5 * ((*cspan_at(&work, block + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)));
        widest = (*cspan_at(&work, block + layout__REGION_WIDTH_LOW));
        if ((*cspan_at(&work, block + layout__REGION_WIDTH_HIGH)) > widest)
        {
            widest = (*cspan_at(&work, block + layout__REGION_WIDTH_HIGH));
        }
        least = normal_contact__NARROWEST * sqrt(level / (*cspan_at(&work, block + layout__REGION_CURVATURE)));
        if (mean < least)
        {
            mean = least;
        }
        spacing = mean / (*cspan_at(&tables, layout__TABLES_NODES));
        if (widest * enlarge > normal_contact__WIDEST * spacing)
        {
            spacing = widest * enlarge / normal_contact__WIDEST;
        }
        A = 0.5 * (*cspan_at(&work, block + layout__REGION_CURVATURE));
        low_reach = level * enlarge * normal_contact__zone_share(tables, A, (*cspan_at(&work, block + layout__REGION_SIDE_LOW)));
        high_reach = level * enlarge * normal_contact__zone_share(tables, A, (*cspan_at(&work, block + layout__REGION_SIDE_HIGH)));
        if (((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0) && (contact_plane__is_yawed(work) == INT64_C(1)))
        {
            (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_BLUR)) = spacing * (double)(stride) * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_WHEEL_COS));
        }
        nodes__lay_nodes(tables, work, state, i, low_reach, high_reach, spacing, window, stride);
        nodes__weigh_nodes(tables, work, i, window);
        if (((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0) || ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL))
        {
            normal_contact__mean_normal(tables, work, i, level);
        }
        planes__leave_plane(work, i);
        (*cspan_at(&work, block + layout__REGION_SQUARE)) = level / (*cspan_at(&work, nodes__node_field(i, nodes__NODE_LENGTH)));
    }
    return INT64_C(0);
}

/* Change of the rail's abscissa per station of the open frame [-]. */
static inline double normal_contact__rail_per_station(array_double_1d tables, array_double_1d work, double abscissa)
{
    double height;
    double slope;
    double along;
    profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa);
    along = sqrt(1.0 + slope * slope);
    if (!((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0))
    {
        along = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_COS)) + slope * (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_SIN));
    }
    return 1.0 / along;
}

/* Let the force of a region act along the mean of the rail's normals, weighted by the line load at ``level`` [m].
 *
 * The rail is followed from node to node by the midpoint rule; nodes of a pressed wheel lie along it, others in the plane.
 */
static inline int64_t normal_contact__mean_normal(array_double_1d tables, array_double_1d work, int64_t region, double level)
{
    int64_t block;
    int64_t rises;
    int64_t lines;
    double total;
    double cosines;
    double sines;
    int64_t direction;
    double x;
    double step;
    int64_t last;
    int64_t k;
    double height;
    double slope;
    double cosine;
    double weight;
    block = layout__WORK_REGIONS + layout__REGION_SIZE * region;
    rises = nodes__node_field(region, nodes__NODE_RISE);
    lines = nodes__node_field(region, nodes__NODE_LINE);
    total = 0.0;
    cosines = 0.0;
    sines = 0.0;
    for (direction = -INT64_C(1); direction < INT64_C(2); direction += INT64_C(2))
    {
        x = (*cspan_at(&work, block + layout__REGION_RAIL));
        step = (double)(direction) * (*cspan_at(&work, block + layout__REGION_SPACING));
        last = (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)));
        if (direction < INT64_C(0))
        {
            last = -(int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)));
        }
        for (k = INT64_C(0); k < last + INT64_C(1); k += INT64_C(1))
        {
            profile_table__height_slope(&height, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x);
            cosine = 1.0 / sqrt(1.0 + slope * slope);
            weight = (*cspan_at(&work, lines + direction * k)) * (level - (*cspan_at(&work, rises + direction * k)));
            if (weight <= 0.0)
            {
                break;
            }
            if (k == INT64_C(0))
            {
                weight *= 0.5;
            }
            total += weight;
            cosines += weight * cosine;
            sines += weight * slope * cosine;
            x += step * normal_contact__rail_per_station(tables, work, x + 0.5 * step * normal_contact__rail_per_station(tables, work, x));
        }
    }
    if (total > 0.0)
    {
        (*cspan_at(&work, block + layout__REGION_COS)) = cosines / total;
        (*cspan_at(&work, block + layout__REGION_SIN)) = sines / total;
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_LOAD))) == layout__LOAD_VERTICAL)
        {
            (*cspan_at(&work, block + layout__REGION_SHARE)) = (*cspan_at(&work, block + layout__REGION_COS));
        }
    }
    return INT64_C(0);
}

/* Levels before any interaction is known; a region that is hardly reached still gets nodes for a tenth of it. */
static inline int64_t normal_contact__start_levels(array_double_1d work, int64_t count, double penetration)
{
    int64_t i;
    int64_t block;
    double level;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * i;
        level = (*cspan_at(&work, block + layout__REGION_TURN)) * penetration - (*cspan_at(&work, block + layout__REGION_GAP));
        if (level < 0.1 * penetration)
        {
            level = 0.1 * penetration;
        }
        (*cspan_at(&work, block + layout__REGION_LEVEL)) = level;
    }
    return INT64_C(0);
}

/* 1 if no region is loaded at an end of its nodes other than its bound, else 0. */
static inline int64_t normal_contact__covered(array_double_1d work, int64_t count)
{
    int64_t i;
    int64_t block;
    int64_t rises;
    double level;
    double low;
    double high;
    int64_t result;
    result = INT64_C(1);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        block = layout__WORK_REGIONS + layout__REGION_SIZE * i;
        rises = nodes__node_field(i, nodes__NODE_RISE);
        level = (*cspan_at(&work, block + layout__REGION_LEVEL));
        low = (*cspan_at(&work, block + layout__REGION_LOW));
        high = (*cspan_at(&work, block + layout__REGION_HIGH));
        if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
        {
            /* its bounds may be the rail's ends, far away */
            if (low < (*cspan_at(&work, block + layout__REGION_STATION)) + (*cspan_at(&work, block + layout__REGION_SPACING)) * (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST))))
            {
                low = -regions__FAR;
            }
            if (high > (*cspan_at(&work, block + layout__REGION_STATION)) + (*cspan_at(&work, block + layout__REGION_SPACING)) * (int64_t)((*cspan_at(&work, block + layout__REGION_LAST))))
            {
                high = regions__FAR;
            }
        }
        if ((level > (*cspan_at(&work, rises + (int64_t)((*cspan_at(&work, block + layout__REGION_LAST)))))) && (high >= regions__FAR))
        {
            result = INT64_C(0);
        }
        if ((level > (*cspan_at(&work, rises + (int64_t)((*cspan_at(&work, block + layout__REGION_FIRST)))))) && (low <= -regions__FAR))
        {
            result = INT64_C(0);
        }
    }
    return result;
}

/* Hertz's penetration [m] for the interpenetration's own width: B = level / width^2 at a guessed level.
 *
 * Exact for constant curvatures; within 12 % for nine of ten poses of S1002 on UIC60.
 */
static inline double normal_contact__estimate_penetration(array_double_1d tables, array_double_1d work, array_double_1d state, double force)
{
    double A;
    double guess;
    double width;
    double B;
    double stiffness;
    A = 0.5 * (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_CURVATURE));
    guess = normal_contact__guess_penetration(force, A, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)));
    normal_contact__measure_widths(tables, work, state, INT64_C(0), guess);
    width = 0.5 * ((*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_WIDTH_HIGH)));
    B = nodes__FLOOR * A;
    if (guess > normal_contact__CEILING * A * width * width)
    {
        B = normal_contact__CEILING * A;
    }
    else if (guess > B * width * width)
    {
        B = guess / (width * width);
    }
    stiffness = hertz__hertz_stiffness(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, B, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)));
    return pow((force / stiffness), (2.0 / 3.0));
}

/* Open the regions that ``penetration`` [m] reaches, with their bounds and first levels; their number. */
static inline int64_t normal_contact__gather_regions(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double penetration)
{
    int64_t i;
    int64_t count;
    for (i = INT64_C(0); i < layout__REGION_LIMIT; i += INT64_C(1))
    {
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * i + layout__REGION_WIDTH_LEVEL)) = 0.0;
        (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SIZE * i + layout__REGION_SLANT)) = 0.0;
    }
    count = INT64_C(1);
    if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        count = overlaps__gather_overlaps(tables, work, state);
    }
    else
    {
        regions__open_contact_region(tables, work, state);
        count = regions__find_regions(tables, work, state, side, penetration);
        count = regions__bound_regions(tables, work, state, count, penetration);
        planes__give_planes(tables, work, state, count);
    }
    normal_contact__start_levels(work, count, penetration);
    return count;
}

/* What the penetration [m] under the prescribed ``force`` [N] is estimated to be. */
static inline double normal_contact__first_penetration(array_double_1d tables, array_double_1d work, array_double_1d state, double force)
{
    double result;
    regions__open_contact_region(tables, work, state);
    (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_WIDTH_LEVEL)) = 0.0;
    result = normal_contact__estimate_penetration(tables, work, state, force / (*cspan_at(&work, layout__WORK_REGIONS + layout__REGION_SHARE)));
    return result;
}

/* Penetration [m] and number of regions, with regions and nodes laid for the ``estimate`` of it; third value 1 when
 * met, else 0.
 */
static inline int64_t normal_contact__solve_estimated(double* penetration, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double force, double estimate, int64_t by_penetration)
{
    (*count) = normal_contact__gather_regions(tables, work, state, side, estimate);
    normal_contact__solve_fine(penetration, met, tables, work, state, (*count), force, estimate, by_penetration);
    if (((*met) == INT64_C(0)) && ((*count) > INT64_C(1)))
    {
        /* regions so close that pressing on each other has no fixed point are one region */
        (*count) = INT64_C(1);
        if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
        {
            overlaps__keep_deepest(work);
            overlaps__gather_overlaps(tables, work, state);
        }
        else
        {
            regions__open_contact_region(tables, work, state);
        }
        normal_contact__start_levels(work, (*count), estimate);
        normal_contact__solve_fine(penetration, met, tables, work, state, (*count), force, estimate, by_penetration);
    }
    return 0;
}

/* Penetration [m] and number of regions under ``force`` [N], or at ``prescribed`` penetration [m] if that is a
 * number; third value 1 when met, else 0.  A pressed wheel has its regions where it stands.
 */
static inline int64_t normal_contact__solve_analyn(double* penetration, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double force, double prescribed)
{
    int64_t by_penetration;
    int64_t repeat;
    double estimate;
    by_penetration = INT64_C(0);
    (*penetration) = prescribed;
    if (isfinite(prescribed))
    {
        by_penetration = INT64_C(1);
    }
    if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
    {
        normal_contact__solve_estimated(penetration, count, met, tables, work, state, side, force, (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH)), by_penetration);
        return 0;
    }
    if (by_penetration == INT64_C(0))
    {
        (*penetration) = normal_contact__first_penetration(tables, work, state, force);
    }
    (*count) = INT64_C(1);
    (*met) = INT64_C(0);
    for (repeat = INT64_C(0); repeat < normal_contact__ESTIMATE_REPEATS; repeat += INT64_C(1))
    {
        estimate = (*penetration);
        normal_contact__solve_estimated(penetration, count, met, tables, work, state, side, force, estimate, by_penetration);
        if (((*penetration) < normal_contact__ESTIMATE_FACTOR * estimate) && (normal_contact__ESTIMATE_FACTOR * (*penetration) > estimate))
        {
            break;
        }
    }
    return 0;
}

/* Penetration [m] on fine nodes laid over the regions' levels, laid again where the patch outgrows them; and 1 when
 * met, else 0.
 */
static inline int64_t normal_contact__solve_fine(double* result_0_0001, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double force, double penetration, int64_t by_penetration)
{
    double start;
    double enlarge;
    int64_t met;
    int64_t repeat;
    double laid;
    start = penetration;
    enlarge = 1.0;
    met = INT64_C(0);
    for (repeat = INT64_C(0); repeat < normal_contact__COVER_REPEATS; repeat += INT64_C(1))
    {
        normal_contact__prepare_regions(tables, work, state, count, enlarge);
        analyn__solve_levels(&penetration, &met, tables, work, state, count, force, start, by_penetration, analyn__FORCE_SHARP);
        if (met == INT64_C(0))
        {
            (*result_0_0001) = start;
            (*result_1) = met;
            return 0;
        }
        if (normal_contact__covered(work, count) == INT64_C(1))
        {
            break;
        }
        if (repeat < normal_contact__COVER_REPEATS - INT64_C(1))
        {
            enlarge *= 1.4;
            start = penetration;
            laid = penetration;
            if ((*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_PRESSED)) == 1.0)
            {
                /* nodes stay where the wheel stands; there are only more of them */
                laid = (*cspan_at(&work, layout__WORK_FRAME + layout__FRAME_DEPTH));
            }
            normal_contact__start_levels(work, count, laid);
        }
    }
    (*result_0_0001) = penetration;
    (*result_1) = met;
    return 0;
}

/* Solve the normal contact of the side whose frame is open, under ``force`` [N] or at ``prescribed`` penetration [m] if that
 * is a number, into the solved patches; penetration [m], number of regions, and 1 when the force is satisfied, else 0.
 */
static inline int64_t normal_contact__solve_normal(double* penetration, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, int64_t outputs, double force, double prescribed)
{
    int64_t by_penetration;
    int64_t strips;
    (*met) = INT64_C(1);
    (*count) = INT64_C(1);
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_HERTZ)
    {
        planes__line_up(tables, work, INT64_C(1));
        (*penetration) = hertz_contact__solve_hertz(work, tables, outputs, layout__WORK_REGIONS, force, prescribed);
        return 0;
    }
    normal_contact__solve_analyn(penetration, count, met, tables, work, state, side, force, prescribed);
    if ((*met) == INT64_C(1))
    {
        planes__line_up(tables, work, (*count));
        if ((int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL))) == layout__MODEL_ANALYN_STRIP)
        {
            by_penetration = INT64_C(0);
            if (isfinite(prescribed))
            {
                by_penetration = INT64_C(1);
            }
            strips__correct_strips(penetration, &strips, met, tables, work, state, (*count), force, (*penetration), by_penetration);
            if ((*met) == INT64_C(1))
            {
                strip_patches__gather_strips(work, strips);
            }
        }
        else
        {
            node_patches__fill_from_nodes(work, (*count));
        }
    }
    return 0;
}
