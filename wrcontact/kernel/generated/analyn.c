/* Generated from normal/analyn.py by tools/transpile_kernel.py; change that one.
 *
 * ANALYN on the nodes of up to three regions: from local penetrations
 * to loads, and from a force to penetrations.
 *
 * Sichani, Enblom & Berg (2014).  In a region with local penetration D the strip at s is loaded where
 *
 *     d(s) = D - (1 + beta) g > 0,   half-length a = sqrt(d / ((1 + alpha) A)),   p0 = (2 E* /pi) d / (n r a)
 *
 * (the source's eq. 2.25 prints E* /(2 pi), which integrates to a quarter of the force), so the line load
 * (pi/2) a p0 = E* d / (n r) and the region's load is an integral without a root.
 *
 * Regions press on each other: the local penetration of region i is the total penetration minus its smallest gap
 * minus its displacement by the loads of the others, sum_j N_j / (pi E* distance_ij) (Boussinesq;
 * interaction.py, docs/method.md).  Where regions have planes of their own (:mod:`planes`), the penetration
 * counts by its share along each normal, and a displacement by the cosine of the angle between the two.
 */

#include "analyn.h"

/* ``stop`` of the cell outward of node ``k``, cut where the region's bound (a hump) crosses the cell. */
static inline double analyn__clip_to_bound(array_double_1d work, int64_t region, int64_t k, int64_t outward, double stop)
{
    double reach;
    reach = ((*cspan_at(&work, region + layout__REGION_HIGH)) - (*cspan_at(&work, region + layout__REGION_STATION))) / (*cspan_at(&work, region + layout__REGION_SPACING)) - (double)(k);
    if (outward < INT64_C(0))
    {
        reach = ((*cspan_at(&work, region + layout__REGION_STATION)) - (*cspan_at(&work, region + layout__REGION_LOW))) / (*cspan_at(&work, region + layout__REGION_SPACING)) + (double)(k);
    }
    if (reach < stop)
    {
        stop = reach;
    }
    if (stop < 0.0)
    {
        stop = 0.0;
    }
    return stop;
}

/* Load [N] of a region at a local penetration [m], and its derivative [N/m] to a few per mille. */
static inline int64_t analyn__region_load(double* result_0, double* result_1, array_double_1d work, int64_t region, int64_t nodes, double local_penetration)
{
    double load;
    double stiffness;
    int64_t outward;
    int64_t last;
    double d_before;
    double c_before;
    double d_low;
    double c_low;
    int64_t k;
    int64_t at;
    double d_high;
    double c_high;
    double f_low;
    double f_high;
    double start;
    double stop;
    load = 0.0;
    stiffness = 0.0;
    if (local_penetration > 0.0)
    {
        for (outward = -INT64_C(1); outward < INT64_C(2); outward += INT64_C(2))
        {
            last = (int64_t)((*cspan_at(&work, region + layout__REGION_LAST)));
            if (outward < INT64_C(0))
            {
                last = -(int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)));
            }
            d_before = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + (-outward)));
            c_before = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + (-outward)));
            d_low = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + INT64_C(0)));
            c_low = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + INT64_C(0)));
            for (k = INT64_C(0); k < last; k += INT64_C(1))
            {
                at = outward * (k + INT64_C(1));
                d_high = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + at));
                c_high = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + at));
                f_low = c_low * d_low;
                f_high = c_high * d_high;
                if ((d_low > 0.0) && (d_high > 0.0) && (k < last - INT64_C(1)))
                {
                    /* a fully loaded cell: quadratic_integral up to 1 */
                    load += 0.5 * (f_low + f_high) - quadrature__bend_of(c_before * d_before, f_low, f_high) / 6.0;
                    stiffness += 0.5 * (c_low + c_high);
                }
                else if ((d_low > 0.0) || (d_high > 0.0))
                {
                    quadrature__cell_part(&start, &stop, d_before, d_low, d_high);
                    if (k == last - INT64_C(1))
                    {
                        stop = analyn__clip_to_bound(work, region, outward * k, outward, stop);
                    }
                    if (stop > start)
                    {
                        load += quadrature__quadratic_integral(c_before * d_before, f_low, f_high, stop) - quadrature__quadratic_integral(c_before * d_before, f_low, f_high, start);
                        stiffness += (stop - start) * (c_low + 0.5 * (stop + start) * (c_high - c_low));
                    }
                }
                d_before = d_low;
                c_before = c_low;
                d_low = d_high;
                c_low = c_high;
            }
        }
    }
    (*result_0) = load * (*cspan_at(&work, region + layout__REGION_SPACING));
    (*result_1) = stiffness * (*cspan_at(&work, region + layout__REGION_SPACING));
    return 0;
}

/* Loads and stiffnesses of all regions at their local penetrations; the total of what counts for the
 * prescribed force [N].
 */
static inline double analyn__load_regions(array_double_1d work, int64_t count)
{
    int64_t i;
    int64_t region;
    double load;
    double stiffness;
    double total;
    total = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        analyn__region_load(&load, &stiffness, work, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)));
        (*cspan_at(&work, region + layout__REGION_LOAD)) = load;
        (*cspan_at(&work, region + layout__REGION_STIFFNESS)) = stiffness;
        total += (*cspan_at(&work, region + layout__REGION_SHARE)) * load;
    }
    return total;
}

/* Penetration [m] at which the regions carry ``force`` [N] (or the given one where ``prescribed``), by
 * Newton's method on all local penetrations together; these and the loads stay in the regions.  Second
 * value: 1 when the force is satisfied, else 0.
 */
static inline int64_t analyn__solve_penetrations(double* result_0_0001, int64_t* result_1_0001, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, double penetration, int64_t prescribed)
{
    int64_t i;
    int64_t region;
    double low;
    double high;
    double total_before;
    double slope_before;
    double move;
    int64_t iteration;
    double total;
    double residual;
    double slope;
    double rest;
    double share;
    double missed;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, region + layout__REGION_GAP));
    }
    low = 0.0;
    high = analyn__HIGHEST * penetration;
    total_before = 0.0;
    slope_before = 0.0;
    move = 0.0;
    for (iteration = INT64_C(0); iteration < analyn__FORCE_ITERATIONS; iteration += INT64_C(1))
    {
        (*cspan_at(&state, layout__STATE_SOLVE_COUNT)) += 1.0;
        total = analyn__load_regions(work, count);
        analyn__penetration_residuals(&residual, &slope, &rest, work, tables, count, penetration);
        if ((count == INT64_C(1)) && (iteration > INT64_C(0)) && (fabs(total - total_before) > analyn__ROUNDING * force))
        {
            /* the change of the load that the slopes of both ends predict for the last move, against the real */
            /* one */
            share = (total - total_before) / (0.5 * (slope_before + slope) * move);
            if (fabs(share - 1.0) < analyn__SLOPE_ERROR)
            {
                slope *= share;
            }
        }
        total_before = total;
        slope_before = slope;
        move = 0.0;
        missed = 0.0;
        if (prescribed == INT64_C(0))
        {
            missed = fabs(force - total);
            if ((residual <= analyn__CLOSED * penetration) && (missed > 10.0 * analyn__CLOSED * force))
            {
                if (total < force)
                {
                    low = penetration;
                }
                else
                {
                    high = penetration;
                }
            }
            move = analyn__penetration_move(force, total, slope, rest, penetration, low, high);
        }
        if ((missed <= analyn__FORCE_SHARP * force) && (residual <= analyn__FORCE_SHARP * penetration))
        {
            (*result_0_0001) = penetration;
            (*result_1_0001) = INT64_C(1);
            return 0;
        }
        penetration += move;
        analyn__apply_moves(work, count, move);
        if ((missed <= analyn__NEARLY_SHARP * force) && (residual <= analyn__NEARLY_SHARP * penetration))
        {
            (*result_0_0001) = penetration;
            (*result_1_0001) = INT64_C(1);
            return 0;
        }
    }
    (*result_0_0001) = penetration;
    (*result_1_0001) = INT64_C(0);
    return 0;
}

/* Move of the penetration [m] towards the ``force`` [N], from the ``total`` load that the regions carry
 * now [N].
 *
 * slope : rate of the total load [N/m], once the local penetrations have closed their residuals.
 * rest : load that closing them adds [N].
 * low, high : bracket of the penetration [m], halved where Newton's method leaves it.
 *
 * The power 2/3 of the load is nearly linear in the penetration.
 */
static inline double analyn__penetration_move(double force, double total, double slope, double rest, double penetration, double low, double high)
{
    double following;
    double newton;
    following = 0.5 * (low + high);
    if (slope > 0.0)
    {
        newton = penetration + (force - total - rest) / slope;
        if ((fabs(force - total) > analyn__NEARLY * force) && (total > 0.0))
        {
            newton = penetration + (1.5 * total * (pow((force / total), (2.0 / 3.0)) - 1.0) - rest) / slope;
        }
        if ((newton > low) && (newton < high))
        {
            following = newton;
        }
    }
    return following - penetration;
}

/* Linearise the local penetrations D_i: for each region its change per unit of penetration (region.slope)
 * and the change that closes D_i = turn_i penetration - gap_i - sum_j c_ij N_j (region.move).
 *
 * Returns the largest residual [m], d(total load)/d(penetration) [N/m], and the load that the closing moves
 * add [N]. Solved by Gauss-Seidel: the coupling of the regions is weak (c N / D < 0.2), three of them at
 * most.
 */
static inline int64_t analyn__penetration_residuals(double* largest, double* slope, double* rest, array_double_1d work, array_double_1d tables, int64_t count, double penetration)
{
    int64_t i;
    int64_t region;
    double pushed;
    int64_t j;
    double turn;
    double residual;
    int64_t sweeps;
    int64_t sweep;
    double move;
    int64_t other;
    double coupling;
    double counted;
    (*largest) = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        pushed = 0.0;
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            if (j != i)
            {
                pushed += interaction__region_influence(work, tables, region, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j) * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j + layout__REGION_LOAD));
            }
        }
        turn = (*cspan_at(&work, region + layout__REGION_ALIGNMENT));
        residual = turn * penetration - (*cspan_at(&work, region + layout__REGION_GAP)) - pushed - (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION));
        (*cspan_at(&work, region + layout__REGION_RESIDUAL)) = residual;
        (*cspan_at(&work, region + layout__REGION_SLOPE)) = turn;
        (*cspan_at(&work, region + layout__REGION_MOVE)) = residual;
        if (fabs(residual) > (*largest))
        {
            (*largest) = fabs(residual);
        }
    }
    sweeps = INT64_C(12);
    if (count == INT64_C(1))
    {
        sweeps = INT64_C(0);
    }
    for (sweep = INT64_C(0); sweep < sweeps; sweep += INT64_C(1))
    {
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
            (*slope) = (*cspan_at(&work, region + layout__REGION_ALIGNMENT));
            move = (*cspan_at(&work, region + layout__REGION_RESIDUAL));
            for (j = INT64_C(0); j < count; j += INT64_C(1))
            {
                if (j != i)
                {
                    other = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j;
                    coupling = interaction__region_influence(work, tables, region, other) * (*cspan_at(&work, other + layout__REGION_STIFFNESS));
                    (*slope) -= coupling * (*cspan_at(&work, other + layout__REGION_SLOPE));
                    move -= coupling * (*cspan_at(&work, other + layout__REGION_MOVE));
                }
            }
            (*cspan_at(&work, region + layout__REGION_SLOPE)) = (*slope);
            (*cspan_at(&work, region + layout__REGION_MOVE)) = move;
        }
    }
    (*slope) = 0.0;
    (*rest) = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        counted = (*cspan_at(&work, region + layout__REGION_SHARE)) * (*cspan_at(&work, region + layout__REGION_STIFFNESS));
        (*slope) += counted * (*cspan_at(&work, region + layout__REGION_SLOPE));
        (*rest) += counted * (*cspan_at(&work, region + layout__REGION_MOVE));
    }
    return 0;
}

/* Move the local penetrations with the penetration, by ``move`` [m], and close their residuals. */
static inline int64_t analyn__apply_moves(array_double_1d work, int64_t count, double move)
{
    int64_t i;
    int64_t region;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) += (*cspan_at(&work, region + layout__REGION_MOVE)) + (*cspan_at(&work, region + layout__REGION_SLOPE)) * move;
    }
    return INT64_C(0);
}
