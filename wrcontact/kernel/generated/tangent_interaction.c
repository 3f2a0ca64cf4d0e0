/* Generated from tangent_interaction.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of interaction.py.
 */

#include "tangent_interaction.h"

/* Tangent of ``region_influence``. */
static inline int64_t tangent_interaction__region_influence_t(double* result, double* result_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t one, int64_t other)
{
    double distance_t;
    double distance;
    double v1;
    double v1_t;
    double lead_t;
    double lead;
    double squares_t;
    double squares;
    double v2;
    double v3;
    double apart_t;
    double apart;
    double v4;
    double v5;
    double v6;
    double v7;
    double v7_t;
    distance_t = (*cspan_at(&work_t, one + layout__REGION_OFFSET)) + (*cspan_at(&work_t, one + layout__REGION_MIDDLE)) - (*cspan_at(&work_t, other + layout__REGION_OFFSET)) - (*cspan_at(&work_t, other + layout__REGION_MIDDLE));
    distance = (*cspan_at(&work, one + layout__REGION_OFFSET)) + (*cspan_at(&work, one + layout__REGION_MIDDLE)) - (*cspan_at(&work, other + layout__REGION_OFFSET)) - (*cspan_at(&work, other + layout__REGION_MIDDLE));
    tangent_interaction__region_lead_t(&v1, &v1_t, work, work_t, one, other);
    lead_t = v1_t;
    lead = v1;
    squares_t = (*cspan_at(&work_t, one + layout__REGION_SQUARE)) + (*cspan_at(&work_t, other + layout__REGION_SQUARE));
    squares = (*cspan_at(&work, one + layout__REGION_SQUARE)) + (*cspan_at(&work, other + layout__REGION_SQUARE));
    v2 = distance * distance + lead * lead + interaction__ELONGATED * squares;
    v3 = sqrt(v2);
    apart_t = tangent_rates__root_rate(v3, distance_t * distance + distance * distance_t + (lead_t * lead + lead * lead_t) + interaction__ELONGATED * squares_t);
    apart = v3;
    v4 = M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    v5 = v4 * apart;
    v6 = 1.0 / v5;
    (*result_t) = (-v6) * (v4 * apart_t) / v5;
    (*result) = v6;
    tangent_interaction__planes_cosine_t(&v7, &v7_t, work, work_t, one, other);
    (*result_t) = (*result_t) * v7 + (*result) * v7_t;
    (*result) = (*result) * v7;
    return 0;
}

/* Tangent of ``region_lead``. */
static inline int64_t tangent_interaction__region_lead_t(double* lead, double* lead_t, array_double_1d work, array_double_1d work_t, int64_t one, int64_t other)
{
    (*lead_t) = 0.0;
    (*lead) = 0.0;
    if (interaction__planes_cosine(work, one, other) < interaction__INCLINED)
    {
        (*lead_t) = (*cspan_at(&work_t, one + layout__REGION_X_TRACK)) - (*cspan_at(&work_t, other + layout__REGION_X_TRACK));
        (*lead) = (*cspan_at(&work, one + layout__REGION_X_TRACK)) - (*cspan_at(&work, other + layout__REGION_X_TRACK));
    }
    return 0;
}

/* Tangent of ``planes_cosine``. */
static inline int64_t tangent_interaction__planes_cosine_t(double* cosine, double* cosine_t, array_double_1d work, array_double_1d work_t, int64_t one, int64_t other)
{
    (*cosine_t) = 0.0;
    (*cosine) = 1.0;
    if (((*cspan_at(&work, one + layout__REGION_OWN)) == 1.0) || ((*cspan_at(&work, other + layout__REGION_OWN)) == 1.0))
    {
        (*cosine_t) = (*cspan_at(&work_t, one + layout__REGION_COS)) * (*cspan_at(&work, other + layout__REGION_COS)) + (*cspan_at(&work, one + layout__REGION_COS)) * (*cspan_at(&work_t, other + layout__REGION_COS)) + ((*cspan_at(&work_t, one + layout__REGION_SIN)) * (*cspan_at(&work, other + layout__REGION_SIN)) + (*cspan_at(&work, one + layout__REGION_SIN)) * (*cspan_at(&work_t, other + layout__REGION_SIN)));
        (*cosine) = (*cspan_at(&work, one + layout__REGION_COS)) * (*cspan_at(&work, other + layout__REGION_COS)) + (*cspan_at(&work, one + layout__REGION_SIN)) * (*cspan_at(&work, other + layout__REGION_SIN));
        if ((*cosine) < 0.0)
        {
            (*cosine_t) = 0.0;
            (*cosine) = 0.0;
        }
    }
    return 0;
}
