/* Generated from tangent_estimate.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of estimate.py.
 */

#include "tangent_estimate.h"

/* Tangent of ``guess_penetration``. */
static inline int64_t tangent_estimate__guess_penetration_t(double* v8, double* result_1, double force, double force_t, double A, double A_t, double contact_modulus, double contact_modulus_t)
{
    double v1;
    double v2;
    double share_t;
    double share;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    v1 = 0.75 * force;
    v2 = v1 / contact_modulus;
    share_t = (0.75 * force_t - v2 * contact_modulus_t) / contact_modulus;
    share = v2;
    v3 = share * share;
    v4 = 1.0 + estimate__TYPICAL_RATIO;
    v5 = v3 * v4;
    v6 = v5 * A;
    v7 = 1.0 / 3.0;
    (*v8) = pow(v6, v7);
    (*result_1) = tangent_rates__power_rate((*v8), v6, v7, (share_t * share + share * share_t) * v4 * A + v5 * A_t);
    return 0;
}

/* Tangent of ``estimate_penetration``. */
static inline int64_t tangent_estimate__estimate_penetration_t(double* v8, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t)
{
    double A_t;
    double A;
    double v1;
    double v1_t;
    double guess_t;
    double guess;
    double v2;
    double width_t;
    double width;
    double B_t;
    double B;
    double v3;
    double v4;
    double v5;
    double v5_t;
    double stiffness_t;
    double stiffness;
    double v6;
    double v7;
    A_t = 0.5 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_CURVATURE));
    A = 0.5 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_CURVATURE));
    tangent_estimate__guess_penetration_t(&v1, &v1_t, force, force_t, A, A_t, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)), 0.0);
    guess_t = v1_t;
    guess = v1;
    tangent_widths__measure_widths_t(work, work_t, tables, state, layout__WORK_CONTACT + layout__CONTACT_REGIONS, guess, guess_t);
    v2 = (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_HIGH));
    width_t = 0.5 * ((*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_HIGH)));
    width = 0.5 * v2;
    B_t = node_coefficients__FLOOR * A_t;
    B = node_coefficients__FLOOR * A;
    if (guess > estimate__CEILING * A * width * width)
    {
        B_t = estimate__CEILING * A_t;
        B = estimate__CEILING * A;
    }
    else if (guess > B * width * width)
    {
        v3 = width * width;
        v4 = guess / v3;
        B_t = (guess_t - v4 * (width_t * width + width * width_t)) / v3;
        B = v4;
    }
    tangent_hertz__hertz_stiffness_t(&v5, &v5_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, A_t, B, B_t, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)), 0.0);
    stiffness_t = v5_t;
    stiffness = v5;
    v6 = force / stiffness;
    v7 = 2.0 / 3.0;
    (*v8) = pow(v6, v7);
    (*result_1) = tangent_rates__power_rate((*v8), v6, v7, (force_t - v6 * stiffness_t) / stiffness);
    return 0;
}

/* Tangent of ``first_penetration``. */
static inline int64_t tangent_estimate__first_penetration_t(double* v1, double* v1_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double force, double force_t)
{
    double v2;
    tangent_regions__open_contact_region_t(work, work_t, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS);
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_PENETRATION)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_PENETRATION)) = 0.0;
    v2 = force / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SHARE));
    tangent_estimate__estimate_penetration_t(v1, v1_t, work, work_t, tables, state, v2, (force_t - v2 * (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SHARE))) / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SHARE)));
    return 0;
}

/* Tangent of ``start_penetrations``. */
static inline int64_t tangent_estimate__start_penetrations_t(array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t)
{
    int64_t i;
    int64_t region;
    double local_t;
    double local;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        local_t = (*cspan_at(&work_t, region + layout__REGION_ALIGNMENT)) * penetration + (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration_t - (*cspan_at(&work_t, region + layout__REGION_GAP));
        local = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, region + layout__REGION_GAP));
        if (local < estimate__LEAST_SHARE * penetration)
        {
            local_t = estimate__LEAST_SHARE * penetration_t;
            local = estimate__LEAST_SHARE * penetration;
        }
        (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) = local_t;
        (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) = local;
    }
    return INT64_C(0);
}
