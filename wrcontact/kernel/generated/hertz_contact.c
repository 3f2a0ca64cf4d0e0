/* Generated from normal/hertz_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Hertz's contact of one side in closed form: one elliptic patch with the curvatures at the contact point.
 */

#include "hertz_contact.h"

/* Fill the solved patches by Hertz's ellipse; penetration [m], number of regions, 1, and
 * 1: the force is satisfied.
 */
static inline int64_t hertz_contact__hertz_contact(double* penetration, int64_t* result_1, int64_t* result_2, array_double_1d work, array_double_1d tables, int64_t point, double force, double prescribed)
{
    planes__locate_along_track(work, tables, INT64_C(1));
    (*penetration) = hertz_contact__solve_hertz(work, tables, point, layout__WORK_CONTACT + layout__CONTACT_REGIONS, force, prescribed);
    (*result_1) = INT64_C(1);
    (*result_2) = INT64_C(1);
    return 0;
}

/* Fill the solved patches with Hertz's ellipse under ``force`` [N], or at the ``prescribed`` penetration
 * [m] if that is a number; the penetration [m].
 *
 * point : the outputs of the side, which describe its contact point.
 * region : the region at this point.
 *
 * A lateral curvature below FLOOR A (concave or flat pairs, which Hertz does not cover) counts as FLOOR A.
 */
static inline double hertz_contact__solve_hertz(array_double_1d work, array_double_1d tables, int64_t point, int64_t region, double force, double prescribed)
{
    int64_t table;
    double A;
    double B;
    double stiffness;
    double load;
    double one_alpha;
    double one_beta;
    double nr;
    double half_length;
    double half_width;
    double area;
    double penetration;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    A = 0.5 * (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CURVATURE_X));
    B = 0.5 * (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CURVATURE_Y));
    if (!(B > node_coefficients__FLOOR * A))
    {
        B = node_coefficients__FLOOR * A;
    }
    stiffness = hertz__hertz_stiffness(tables, table, A, B, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)));
    penetration = prescribed;
    if (!isfinite(prescribed))
    {
        penetration = pow((force / ((*cspan_at(&work, region + layout__REGION_SHARE)) * stiffness)), (2.0 / 3.0));
    }
    load = stiffness * penetration * sqrt(penetration);
    (*cspan_at(&work, region + layout__REGION_STIFFNESS)) = 1.5 * stiffness * sqrt(penetration);
    (*cspan_at(&work, region + layout__REGION_CARRIED)) = load;
    (*cspan_at(&work, region + layout__REGION_MOMENT)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_SLANT)) = 0.0;
    (*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) = penetration;
    hertz__hertz_coefficients(&one_alpha, &one_beta, &nr, tables, table, A, B);
    half_length = sqrt(penetration / (one_alpha * A));
    half_width = sqrt(penetration / (one_beta * B));
    area = M_PI * half_length * half_width;
    filling__place_patch(work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES, region, INT64_C(0), layout__RULE_ELLIPSE, (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_LOAD)) = load;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_AREA)) = area;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MOMENT)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_CENTROID)) = 0.0;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_PRESSURE)) = 1.5 * load / area;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) = half_length;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START)) = -half_width;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP)) = half_width;
    (*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_WIDTH)) = 2.0 * half_width;
    filling__fill_single(work);
    return penetration;
}
