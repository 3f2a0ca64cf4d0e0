/* Generated from tangent_hertz_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of hertz_contact.py.
 */

#include "tangent_hertz_contact.h"

/* Tangent of ``hertz_contact``. */
static inline int64_t tangent_hertz_contact__hertz_contact_t(double* penetration, double* penetration_t, int64_t* result_2, int64_t* result_3, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t point, double force, double force_t, double prescribed, double prescribed_t)
{
    double v1;
    double v1_t;
    tangent_planes__locate_along_track_t(work, work_t, tables, INT64_C(1));
    tangent_hertz_contact__solve_hertz_t(&v1, &v1_t, work, work_t, tables, point, layout__WORK_CONTACT + layout__CONTACT_REGIONS, force, force_t, prescribed, prescribed_t);
    (*penetration_t) = v1_t;
    (*penetration) = v1;
    (*result_2) = INT64_C(1);
    (*result_3) = INT64_C(1);
    return 0;
}

/* Tangent of ``solve_hertz``. */
static inline int64_t tangent_hertz_contact__solve_hertz_t(double* penetration, double* penetration_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t point, int64_t region, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t table;
    double A_t;
    double A;
    double B_t;
    double B;
    double v1;
    double v1_t;
    double stiffness_t;
    double stiffness;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    double load_t;
    double load;
    double v8;
    double v9;
    double one_alpha;
    double one_alpha_t;
    double one_beta;
    double one_beta_t;
    double nr;
    double nr_t;
    double v10;
    double v11;
    double v12;
    double half_length_t;
    double half_length;
    double v13;
    double v14;
    double v15;
    double half_width_t;
    double half_width;
    double v16;
    double area_t;
    double area;
    double v17;
    double v18;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    A_t = 0.5 * (*cspan_at(&work_t, point + layout__SIDE_OUTPUTS_CURVATURE_X));
    A = 0.5 * (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CURVATURE_X));
    B_t = 0.5 * (*cspan_at(&work_t, point + layout__SIDE_OUTPUTS_CURVATURE_Y));
    B = 0.5 * (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CURVATURE_Y));
    if (!(B > node_coefficients__FLOOR * A))
    {
        B_t = node_coefficients__FLOOR * A_t;
        B = node_coefficients__FLOOR * A;
    }
    tangent_hertz__hertz_stiffness_t(&v1, &v1_t, tables, table, A, A_t, B, B_t, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)), 0.0);
    stiffness_t = v1_t;
    stiffness = v1;
    (*penetration_t) = prescribed_t;
    (*penetration) = prescribed;
    if (!isfinite(prescribed))
    {
        v2 = (*cspan_at(&work, region + layout__REGION_SHARE)) * stiffness;
        v3 = force / v2;
        v4 = 2.0 / 3.0;
        v5 = pow(v3, v4);
        (*penetration_t) = tangent_rates__power_rate(v5, v3, v4, (force_t - v3 * ((*cspan_at(&work_t, region + layout__REGION_SHARE)) * stiffness + (*cspan_at(&work, region + layout__REGION_SHARE)) * stiffness_t)) / v2);
        (*penetration) = v5;
    }
    v6 = stiffness * (*penetration);
    v7 = sqrt((*penetration));
    load_t = (stiffness_t * (*penetration) + stiffness * (*penetration_t)) * v7 + v6 * tangent_rates__root_rate(v7, (*penetration_t));
    load = v6 * v7;
    v8 = 1.5 * stiffness;
    v9 = sqrt((*penetration));
    (*cspan_at(&work_t, region + layout__REGION_STIFFNESS)) = 1.5 * stiffness_t * v9 + v8 * tangent_rates__root_rate(v9, (*penetration_t));
    (*cspan_at(&work, region + layout__REGION_STIFFNESS)) = v8 * v9;
    (*cspan_at(&work_t, region + layout__REGION_CARRIED)) = load_t;
    (*cspan_at(&work, region + layout__REGION_CARRIED)) = load;
    (*cspan_at(&work_t, region + layout__REGION_MOMENT)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_MOMENT)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_SLANT)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_SLANT)) = 0.0;
    (*cspan_at(&work_t, region + layout__REGION_LOCAL_PENETRATION)) = (*penetration_t);
    (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) = (*penetration);
    tangent_hertz__hertz_coefficients_t(&one_alpha, &one_alpha_t, &one_beta, &one_beta_t, &nr, &nr_t, tables, table, A, A_t, B, B_t);
    v10 = one_alpha * A;
    v11 = (*penetration) / v10;
    v12 = sqrt(v11);
    half_length_t = tangent_rates__root_rate(v12, ((*penetration_t) - v11 * (one_alpha_t * A + one_alpha * A_t)) / v10);
    half_length = v12;
    v13 = one_beta * B;
    v14 = (*penetration) / v13;
    v15 = sqrt(v14);
    half_width_t = tangent_rates__root_rate(v15, ((*penetration_t) - v14 * (one_beta_t * B + one_beta * B_t)) / v13);
    half_width = v15;
    v16 = M_PI * half_length;
    area_t = M_PI * half_length_t * half_width + v16 * half_width_t;
    area = v16 * half_width;
    tangent_filling__place_patch_t(work, work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES, region, INT64_C(0), layout__RULE_ELLIPSE, (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CONTACT_ANGLE)), (*cspan_at(&work_t, point + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) = load_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) = load;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA)) = area_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA)) = area;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) = 0.0;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_CENTROID)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_CENTROID)) = 0.0;
    v17 = 1.5 * load;
    v18 = v17 / area;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = (1.5 * load_t - v18 * area_t) / area;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = v18;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = half_length_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = half_length;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START)) = -half_width_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START)) = -half_width;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = half_width_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = half_width;
    (*cspan_at(&work_t, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_WIDTH)) = 2.0 * half_width_t;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_WIDTH)) = 2.0 * half_width;
    tangent_filling__fill_single_t(work, work_t);
    return 0;
}
