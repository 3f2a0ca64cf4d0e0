/* Generated from normal/hertz_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Hertz's contact of one side in closed form: one elliptic patch with the curvatures at the contact point.
 */

#include "hertz_contact.h"

/* Fill the solved patches with Hertz's ellipse under ``force`` [N], or at the ``prescribed`` penetration [m] if that is a
 * number; the penetration [m].
 *
 * point : the outputs of the side, which describe its contact point.
 * region : the region at this point.
 *
 * A lateral curvature below FLOOR A (concave or flat pairs, which Hertz does not cover) counts as FLOOR A.
 */
static inline double hertz_contact__solve_hertz(array_double_1d work, array_double_1d tables, int64_t point, int64_t region, double force, double prescribed)
{
    int64_t base;
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
    int64_t index;
    int64_t patch;
    double penetration;
    base = (int64_t)((*cspan_at(&tables, layout__TABLES_HERTZ)));
    A = 0.5 * (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CURVATURE_X));
    B = 0.5 * (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CURVATURE_Y));
    if (!(B > nodes__FLOOR * A))
    {
        B = nodes__FLOOR * A;
    }
    stiffness = hertz__hertz_stiffness(tables, base, A, B, (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)));
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
    (*cspan_at(&work, region + layout__REGION_LEVEL)) = penetration;
    hertz__hertz_coefficients(&one_alpha, &one_beta, &nr, tables, base, A, B);
    half_length = sqrt(penetration / (one_alpha * A));
    half_width = sqrt(penetration / (one_beta * B));
    area = M_PI * half_length * half_width;
    filling__clear_patches(work);
    index = filling__begin_patch(work, region, -half_width, INT64_C(0), layout__RULE_ELLIPSE, (*cspan_at(&work, point + layout__SIDE_OUTPUTS_CONTACT_ANGLE)));
    patch = layout__WORK_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_LOAD)) = load;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_AREA)) = area;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_PRESSURE)) = 1.5 * load / area;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_MAX_HALF_LENGTH)) = half_length;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_STOP)) = half_width;
    (*cspan_at(&work, patch + layout__SOLVED_PATCH_RANK)) = 1.0;
    return penetration;
}
