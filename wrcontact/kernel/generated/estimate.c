/* Generated from normal/estimate.py by tools/transpile_kernel.py; change that one.
 *
 * First estimates of penetrations, from pose and force alone; they are smooth in both, and so is the
 * result.
 */

#include "estimate.h"

/* ((3 N / 4 E*)^2 (A + B))^(1/3) [m], Hertz's eq. (2.8) with r = 1 and a typical B. */
static inline double estimate__guess_penetration(double force, double A, double contact_modulus)
{
    double share;
    share = 0.75 * force / contact_modulus;
    return pow((share * share * (1.0 + estimate__TYPICAL_RATIO) * A), (1.0 / 3.0));
}

/* Hertz's penetration [m] for the interpenetration's own width: B = penetration / width^2 at a guessed
 * penetration.
 *
 * Exact for constant curvatures; within 12 % for nine of ten poses of S1002 on UIC60.
 */
static inline double estimate__estimate_penetration(array_double_1d work, array_double_1d tables, array_double_1d state, double force)
{
    double A;
    double guess;
    double width;
    double B;
    double stiffness;
    A = 0.5 * (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_CURVATURE));
    guess = estimate__guess_penetration(force, A, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)));
    widths__measure_widths(work, tables, state, layout__WORK_CONTACT + layout__CONTACT_REGIONS, guess);
    width = 0.5 * ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_LOW)) + (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_HIGH)));
    B = node_coefficients__FLOOR * A;
    if (guess > estimate__CEILING * A * width * width)
    {
        B = estimate__CEILING * A;
    }
    else if (guess > B * width * width)
    {
        B = guess / (width * width);
    }
    stiffness = hertz__hertz_stiffness(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ))), A, B, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)));
    return pow((force / stiffness), (2.0 / 3.0));
}

/* Estimate of the penetration [m] under the prescribed ``force`` [N]. */
static inline double estimate__first_penetration(array_double_1d work, array_double_1d tables, array_double_1d state, double force)
{
    double result;
    regions__open_contact_region(work, tables, layout__WORK_CONTACT + layout__CONTACT_REGIONS);
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_WIDTH_PENETRATION)) = 0.0;
    result = estimate__estimate_penetration(work, tables, state, force / (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SHARE)));
    return result;
}

/* Local penetrations before any interaction is known; a region that is hardly reached still gets nodes
 * for LEAST_SHARE of the penetration.
 */
static inline int64_t estimate__start_penetrations(array_double_1d work, int64_t count, double penetration)
{
    int64_t i;
    int64_t region;
    double local;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * i;
        local = (*cspan_at(&work, region + layout__REGION_ALIGNMENT)) * penetration - (*cspan_at(&work, region + layout__REGION_GAP));
        if (local < estimate__LEAST_SHARE * penetration)
        {
            local = estimate__LEAST_SHARE * penetration;
        }
        (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) = local;
    }
    return INT64_C(0);
}
