/* Generated from tangent_polach.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of polach.py.
 */

#include "tangent_polach.h"

/* Tangent of ``solve_polach``. */
static inline int64_t tangent_polach__solve_polach_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    double a_t;
    double a;
    double v1;
    double v2;
    double slip_t;
    double slip;
    double across_t;
    double across;
    double v3;
    double v4;
    double whole_t;
    double whole;
    double v5;
    double first;
    double first_t;
    double second;
    double second_t;
    double third;
    double third_t;
    double v7;
    double v7_t;
    double v6;
    double v6_t;
    double v8;
    double push_t;
    double push;
    double v9;
    double v10;
    double v11;
    double v11_t;
    double v12;
    double v12_t;
    a_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    a = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    v2 = sqrt(v1);
    slip_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y))));
    slip = v2;
    across_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) * a + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * a_t);
    across = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * a;
    if (fabs(across) < fabs((*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y))))
    {
        across_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
        across = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    }
    v3 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + across * across;
    v4 = sqrt(v3);
    whole_t = tangent_rates__root_rate(v4, (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + (across_t * across + across * across_t));
    whole = v4;
    if (whole > polach__SMALLEST)
    {
        v5 = a / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
        tangent_shapes__kalker_coefficients_t(&first, &first_t, &second, &second_t, &third, &third_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), v5, (a_t - v5 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)));
        if (slip > polach__SMALLEST)
        {
            tangent_polach__mean_coefficient_t(&v7, &v7_t, work, work_t, rolling, first, first_t, second, second_t, slip, slip_t);
            tangent_polach__creep_force_t(&v6, &v6_t, work, work_t, (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)), 0.0, rolling, v7, v7_t, whole, whole_t);
            v8 = v6 / whole;
            push_t = (v6_t - v8 * whole_t) / whole;
            push = v8;
            v9 = -push;
            (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = (-push_t) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + v9 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
            (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = v9 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
            v10 = -push;
            (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (-push_t) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + v10 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
            (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = v10 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
        }
        tangent_polach__spin_force_t(&v11, &v11_t, work, work_t, (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)), 0.0, rolling, third, third_t, whole, whole_t);
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) + v11_t;
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + v11;
        tangent_polach__cut_force_t(work, work_t, rolling);
        tangent_polach__largest_shear_t(&v12, &v12_t, work, work_t, rolling);
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = v12_t;
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = v12;
    }
    return INT64_C(0);
}

/* Tangent of ``mean_coefficient``. */
static inline int64_t tangent_polach__mean_coefficient_t(double* v4, double* result_1, array_double_1d work, array_double_1d work_t, int64_t rolling, double first, double first_t, double second, double second_t, double slip, double slip_t)
{
    double v1;
    double along_t;
    double along;
    double v2;
    double across_t;
    double across;
    double v3;
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) / slip;
    along_t = first_t * v1 + first * (((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) - v1 * slip_t) / slip);
    along = first * v1;
    v2 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) / slip;
    across_t = second_t * v2 + second * (((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) - v2 * slip_t) / slip);
    across = second * v2;
    v3 = along * along + across * across;
    (*v4) = sqrt(v3);
    (*result_1) = tangent_rates__root_rate((*v4), along_t * along + along * along_t + (across_t * across + across * across_t));
    return 0;
}

/* Tangent of ``creep_force``. */
static inline int64_t tangent_polach__creep_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double shear_modulus, double shear_modulus_t, int64_t rolling, double coefficient, double coefficient_t, double whole, double whole_t)
{
    double bound_t;
    double bound;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    double e_t;
    double e;
    double share_t;
    double share;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    double v14;
    bound_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD));
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    v1 = 0.25 * M_PI;
    v2 = v1 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    v3 = v2 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    v4 = v3 * shear_modulus;
    v5 = v4 * coefficient;
    v6 = v5 * whole;
    v7 = v6 / bound;
    e_t = ((((v1 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) + v2 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) * shear_modulus + v3 * shear_modulus_t) * coefficient + v4 * coefficient_t) * whole + v5 * whole_t - v7 * bound_t) / bound;
    e = v7;
    share_t = e_t / (1.0 + e * e);
    share = atan(e);
    if (e < 1.0)
    {
        v8 = 1.0 + e * e;
        v9 = e / v8;
        share_t = share_t + (e_t - v9 * (e_t * e + e * e_t)) / v8;
        share = share + v9;
    }
    else
    {
        v10 = 1.0 / e;
        v11 = e + v10;
        v12 = 1.0 / v11;
        share_t = share_t + (-v12) * (e_t + (-v10) * e_t / e) / v11;
        share = share + v12;
    }
    v13 = 2.0 / M_PI;
    v14 = v13 * bound;
    (*result_0) = v14 * share;
    (*result_1) = v13 * bound_t * share + v14 * share_t;
    return 0;
}

/* Tangent of ``spin_force``. */
static inline int64_t tangent_polach__spin_force_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, double shear_modulus, double shear_modulus_t, int64_t rolling, double coefficient, double coefficient_t, double whole, double whole_t)
{
    double a_t;
    double a;
    double b_t;
    double b;
    double bound_t;
    double bound;
    double v1;
    double v2;
    double v3;
    double v4;
    double wide_t;
    double wide;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    double v14;
    double e_t;
    double e;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double v19_t;
    double v20;
    double v21;
    a_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    a = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    b_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    b = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    bound_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD));
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    v1 = -a;
    v2 = v1 / b;
    v3 = exp(v2);
    v4 = 1.0 - v3;
    wide_t = 6.3 * (-(v3 * (((-a_t) - v2 * b_t) / b)));
    wide = 1.0 + 6.3 * v4;
    v5 = 8.0 / 3.0;
    v6 = v5 * shear_modulus;
    v7 = v6 * b;
    v8 = a * b;
    v9 = sqrt(v8);
    v10 = v7 * v9;
    v11 = v10 * coefficient;
    v12 = v11 * whole;
    v13 = bound * wide;
    v14 = v12 / v13;
    e_t = ((((v5 * shear_modulus_t * b + v6 * b_t) * v9 + v7 * tangent_rates__root_rate(v9, a_t * b + a * b_t)) * coefficient + v10 * coefficient_t) * whole + v11 * whole_t - v14 * (bound_t * wide + bound * wide_t)) / v13;
    e = v14;
    v15 = 9.0 / 16.0;
    v16 = v15 * a;
    v17 = v16 * bound;
    v18 = v17 * wide;
    tangent_polach__spin_share_t(&v19, &v19_t, e, e_t);
    v20 = v18 * v19;
    v21 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) / whole;
    (*result_0) = v20 * v21;
    (*result_1) = (((v15 * a_t * bound + v16 * bound_t) * wide + v17 * wide_t) * v19 + v18 * v19_t) * v21 + v20 * (((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN)) - v21 * whole_t) / whole);
    return 0;
}

/* Tangent of ``spin_share``. */
static inline int64_t tangent_polach__spin_share_t(double* result_0, double* result_1, double e, double e_t)
{
    double v1;
    double v2;
    double c_t;
    double c;
    double root_t;
    double root;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    v1 = 1.0 + e * e;
    v2 = 2.0 / v1;
    c_t = (-v2) * (e_t * e + e * e_t) / v1;
    c = v2;
    root_t = e_t * c + e * c_t;
    root = e * c;
    v3 = 0.5 * e;
    v4 = v3 * c;
    v5 = v4 * c;
    v6 = 2.0 / 3.0;
    v7 = 1.0 - v6 * c;
    v8 = root * root;
    v9 = v8 * root;
    (*result_0) = v5 * v7 - v9 / 3.0;
    (*result_1) = ((0.5 * e_t * c + v3 * c_t) * c + v4 * c_t) * v7 + v5 * (-(v6 * c_t)) - ((root_t * root + root * root_t) * root + v8 * root_t) / 3.0;
    return 0;
}

/* Tangent of ``cut_force``. */
static inline int64_t tangent_polach__cut_force_t(array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    double bound_t;
    double bound;
    double v1;
    double v2;
    double force_t;
    double force;
    double v3;
    double v4;
    bound_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD));
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y));
    v2 = sqrt(v1);
    force_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y))));
    force = v2;
    if (force > bound)
    {
        v3 = bound / force;
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) * v3 + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * ((bound_t - v3 * force_t) / force);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * v3;
        v4 = bound / force;
        (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) * v4 + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * ((bound_t - v4 * force_t) / force);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * v4;
    }
    return INT64_C(0);
}

/* Tangent of ``largest_shear``. */
static inline int64_t tangent_polach__largest_shear_t(double* v6, double* result_1, array_double_1d work, array_double_1d work_t, int64_t rolling)
{
    double v1;
    double v2;
    double force_t;
    double force;
    double v3;
    double v4;
    double v5;
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y));
    v2 = sqrt(v1);
    force_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) + ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y))));
    force = v2;
    v3 = 1.5 * force;
    v4 = M_PI * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    v5 = v4 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    (*v6) = v3 / v5;
    (*result_1) = (1.5 * force_t - (*v6) * (M_PI * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) + v4 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH)))) / v5;
    return 0;
}
