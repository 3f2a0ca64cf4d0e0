/* Generated from tangent_analyn.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of analyn.py.
 */

#include "tangent_analyn.h"

/* Tangent of ``clip_to_bound``. */
static inline int64_t tangent_analyn__clip_to_bound_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, int64_t region, int64_t k, int64_t outward, double stop, double stop_t)
{
    double v1;
    double v2;
    double reach_t;
    double reach;
    double v3;
    double v4;
    v1 = (*cspan_at(&work, region + layout__REGION_HIGH)) - (*cspan_at(&work, region + layout__REGION_STATION));
    v2 = v1 / (*cspan_at(&work, region + layout__REGION_SPACING));
    reach_t = ((*cspan_at(&work_t, region + layout__REGION_HIGH)) - (*cspan_at(&work_t, region + layout__REGION_STATION)) - v2 * (*cspan_at(&work_t, region + layout__REGION_SPACING))) / (*cspan_at(&work, region + layout__REGION_SPACING));
    reach = v2 - (double)(k);
    if (outward < INT64_C(0))
    {
        v3 = (*cspan_at(&work, region + layout__REGION_STATION)) - (*cspan_at(&work, region + layout__REGION_LOW));
        v4 = v3 / (*cspan_at(&work, region + layout__REGION_SPACING));
        reach_t = ((*cspan_at(&work_t, region + layout__REGION_STATION)) - (*cspan_at(&work_t, region + layout__REGION_LOW)) - v4 * (*cspan_at(&work_t, region + layout__REGION_SPACING))) / (*cspan_at(&work, region + layout__REGION_SPACING));
        reach = v4 + (double)(k);
    }
    if (reach < stop)
    {
        stop_t = reach_t;
        stop = reach;
    }
    if (stop < 0.0)
    {
        stop_t = 0.0;
        stop = 0.0;
    }
    (*result_0) = stop;
    (*result_1) = stop_t;
    return 0;
}

/* Tangent of ``region_load``. */
static inline int64_t tangent_analyn__region_load_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t region, int64_t nodes, double local_penetration, double local_penetration_t)
{
    double load_t;
    double load;
    double stiffness_t;
    double stiffness;
    int64_t outward;
    int64_t last;
    double d_before_t;
    double d_before;
    double c_before_t;
    double c_before;
    double d_low_t;
    double d_low;
    double c_low_t;
    double c_low;
    int64_t k;
    int64_t at;
    double d_high_t;
    double d_high;
    double c_high_t;
    double c_high;
    double f_low_t;
    double f_low;
    double f_high_t;
    double f_high;
    double v1;
    double v2;
    double v2_t;
    double v3;
    double start;
    double start_t;
    double stop;
    double stop_t;
    double v4;
    double v4_t;
    double v5;
    double v5_t;
    double v6;
    double v6_t;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    load_t = 0.0;
    load = 0.0;
    stiffness_t = 0.0;
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
            d_before_t = local_penetration_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + (-outward)));
            d_before = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + (-outward)));
            c_before_t = (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + (-outward)));
            c_before = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + (-outward)));
            d_low_t = local_penetration_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + INT64_C(0)));
            d_low = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + INT64_C(0)));
            c_low_t = (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + INT64_C(0)));
            c_low = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + INT64_C(0)));
            for (k = INT64_C(0); k < last; k += INT64_C(1))
            {
                at = outward * (k + INT64_C(1));
                d_high_t = local_penetration_t - (*cspan_at(&work_t, nodes + layout__NODES_RISE + INT64_C(128) + at));
                d_high = local_penetration - (*cspan_at(&work, nodes + layout__NODES_RISE + INT64_C(128) + at));
                c_high_t = (*cspan_at(&work_t, nodes + layout__NODES_LINE + INT64_C(128) + at));
                c_high = (*cspan_at(&work, nodes + layout__NODES_LINE + INT64_C(128) + at));
                f_low_t = c_low_t * d_low + c_low * d_low_t;
                f_low = c_low * d_low;
                f_high_t = c_high_t * d_high + c_high * d_high_t;
                f_high = c_high * d_high;
                if ((d_low > 0.0) && (d_high > 0.0) && (k < last - INT64_C(1)))
                {
                    v1 = f_low + f_high;
                    tangent_quadrature__bend_of_t(&v2, &v2_t, c_before * d_before, c_before_t * d_before + c_before * d_before_t, f_low, f_low_t, f_high, f_high_t);
                    load_t = load_t + (0.5 * (f_low_t + f_high_t) - v2_t / 6.0);
                    load = load + (0.5 * v1 - v2 / 6.0);
                    v3 = c_low + c_high;
                    stiffness_t = stiffness_t + 0.5 * (c_low_t + c_high_t);
                    stiffness = stiffness + 0.5 * v3;
                }
                else if ((d_low > 0.0) || (d_high > 0.0))
                {
                    tangent_quadrature__cell_part_t(&start, &start_t, &stop, &stop_t, d_before, d_before_t, d_low, d_low_t, d_high, d_high_t);
                    if (k == last - INT64_C(1))
                    {
                        tangent_analyn__clip_to_bound_t(&v4, &v4_t, work, work_t, region, outward * k, outward, stop, stop_t);
                        stop_t = v4_t;
                        stop = v4;
                    }
                    if (stop > start)
                    {
                        tangent_quadrature__quadratic_integral_t(&v5, &v5_t, c_before * d_before, c_before_t * d_before + c_before * d_before_t, f_low, f_low_t, f_high, f_high_t, stop, stop_t);
                        tangent_quadrature__quadratic_integral_t(&v6, &v6_t, c_before * d_before, c_before_t * d_before + c_before * d_before_t, f_low, f_low_t, f_high, f_high_t, start, start_t);
                        load_t = load_t + (v5_t - v6_t);
                        load = load + (v5 - v6);
                        v7 = stop - start;
                        v8 = stop + start;
                        v9 = 0.5 * v8;
                        v10 = c_high - c_low;
                        v11 = c_low + v9 * v10;
                        stiffness_t = stiffness_t + ((stop_t - start_t) * v11 + v7 * (c_low_t + (0.5 * (stop_t + start_t) * v10 + v9 * (c_high_t - c_low_t))));
                        stiffness = stiffness + v7 * v11;
                    }
                }
                d_before_t = d_low_t;
                d_before = d_low;
                c_before_t = c_low_t;
                c_before = c_low;
                d_low_t = d_high_t;
                d_low = d_high;
                c_low_t = c_high_t;
                c_low = c_high;
            }
        }
    }
    (*result_0) = load * (*cspan_at(&work, region + layout__REGION_SPACING));
    (*result_1) = load_t * (*cspan_at(&work, region + layout__REGION_SPACING)) + load * (*cspan_at(&work_t, region + layout__REGION_SPACING));
    (*result_2) = stiffness * (*cspan_at(&work, region + layout__REGION_SPACING));
    (*result_3) = stiffness_t * (*cspan_at(&work, region + layout__REGION_SPACING)) + stiffness * (*cspan_at(&work_t, region + layout__REGION_SPACING));
    return 0;
}

/* Tangent of ``load_regions``. */
static inline int64_t tangent_analyn__load_regions_t(double* total, double* total_t, array_double_1d work, array_double_1d work_t, int64_t count)
{
    int64_t i;
    int64_t region;
    double load;
    double load_t;
    double stiffness;
    double stiffness_t;
    (*total_t) = 0.0;
    (*total) = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        tangent_analyn__region_load_t(&load, &load_t, &stiffness, &stiffness_t, work, work_t, region, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * i, (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)), (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)));
        (*cspan_at(&work_t, region + layout__REGION_LOAD)) = load_t;
        (*cspan_at(&work, region + layout__REGION_LOAD)) = load;
        (*cspan_at(&work_t, region + layout__REGION_STIFFNESS)) = stiffness_t;
        (*cspan_at(&work, region + layout__REGION_STIFFNESS)) = stiffness;
        (*total_t) = (*total_t) + ((*cspan_at(&work_t, region + layout__REGION_SHARE)) * load + (*cspan_at(&work, region + layout__REGION_SHARE)) * load_t);
        (*total) = (*total) + (*cspan_at(&work, region + layout__REGION_SHARE)) * load;
    }
    return 0;
}

/* Tangent of ``penetrations_rule``. */
static inline int64_t tangent_analyn__penetrations_rule_t(double* result_0, double* result_1, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, double penetration, double penetration_t, int64_t prescribed)
{
    double given_t;
    double given;
    int64_t size;
    int64_t i;
    int64_t region;
    double v1;
    double v1_t;
    double total_t;
    double total;
    int64_t last;
    int64_t block;
    int64_t row;
    double pushed_t;
    double pushed;
    int64_t j;
    double share_t;
    double share;
    double v2;
    double v2_t;
    double rest_t;
    double rest;
    double load;
    double load_t;
    double stiffness;
    double stiffness_t;
    double per_level;
    double n3;
    double n4;
    given_t = penetration_t;
    given = penetration;
    analyn__solve_penetrations(&penetration, satisfied, work, tables, state, count, force, penetration, prescribed);
    penetration_t = 0.0;
    if ((*satisfied) == INT64_C(0))
    {
        (*result_0) = penetration;
        (*result_1) = penetration_t;
        return 0;
    }
    size = count + INT64_C(1);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) = 0.0;
    }
    tangent_analyn__load_regions_t(&v1, &v1_t, work, work_t, count);
    total_t = v1_t;
    total = v1;
    last = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * count;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        block = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * i;
        pushed_t = 0.0;
        pushed = 0.0;
        for (j = INT64_C(0); j < count; j += INT64_C(1))
        {
            share_t = 0.0;
            share = 0.0;
            if (j != i)
            {
                tangent_interaction__region_influence_t(&v2, &v2_t, work, work_t, tables, block, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j);
                share_t = v2_t;
                share = v2;
            }
            pushed_t = pushed_t + (share_t * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j + layout__REGION_LOAD)) + share * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j + layout__REGION_LOAD)));
            pushed = pushed + share * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j + layout__REGION_LOAD));
            (*cspan_at(&work_t, row + j)) = 0.0;
            (*cspan_at(&work, row + j)) = share;
        }
        rest_t = (*cspan_at(&work_t, block + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work_t, block + layout__REGION_GAP)) - pushed_t;
        rest = (*cspan_at(&work, block + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, block + layout__REGION_GAP)) - pushed;
        (*cspan_at(&work_t, row + count)) = 0.0;
        (*cspan_at(&work, row + count)) = -(*cspan_at(&work, block + layout__REGION_ALIGNMENT));
        (*cspan_at(&work_t, row + size)) = 0.0;
        (*cspan_at(&work, row + size)) = rest_t;
        (*cspan_at(&work_t, row + (size + INT64_C(1)))) = 0.0;
        (*cspan_at(&work, row + (size + INT64_C(1)))) = 0.0;
    }
    for (j = INT64_C(0); j < count; j += INT64_C(1))
    {
        block = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * j;
        tangent_analyn__region_load_t(&load, &load_t, &stiffness, &stiffness_t, work, work_t, block, layout__WORK_CONTACT + layout__CONTACT_NODES + layout__NODES_SIZE * j, (*cspan_at(&work, block + layout__REGION_LOCAL_PENETRATION)), 1.0);
        per_level = load_t - (*cspan_at(&work_t, block + layout__REGION_LOAD));
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * i + j)) = 0.0;
            (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * i + j)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * i + j)) * per_level;
        }
        (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * j + j)) = 0.0;
        (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * j + j)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * j + j)) + 1.0;
        (*cspan_at(&work_t, last + j)) = 0.0;
        (*cspan_at(&work, last + j)) = 0.0;
        if (prescribed == INT64_C(0))
        {
            (*cspan_at(&work_t, last + j)) = 0.0;
            (*cspan_at(&work, last + j)) = (*cspan_at(&work, block + layout__REGION_SHARE)) * per_level;
        }
    }
    (*cspan_at(&work_t, last + count)) = 0.0;
    (*cspan_at(&work, last + count)) = 0.0;
    (*cspan_at(&work_t, last + size)) = 0.0;
    (*cspan_at(&work, last + size)) = force_t - total_t;
    (*cspan_at(&work_t, last + (size + INT64_C(1)))) = 0.0;
    (*cspan_at(&work, last + (size + INT64_C(1)))) = 0.0;
    if (prescribed == INT64_C(1))
    {
        (*cspan_at(&work_t, last + count)) = 0.0;
        (*cspan_at(&work, last + count)) = 1.0;
        (*cspan_at(&work_t, last + size)) = 0.0;
        (*cspan_at(&work, last + size)) = given_t;
    }
    elimination__eliminate(work, size);
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * i + size));
    }
    tangent_analyn__load_regions_t(&n3, &n4, work, work_t, count);
    penetration_t = (*cspan_at(&work, last + size));
    (*result_0) = penetration;
    (*result_1) = penetration_t;
    return 0;
}
