/* Generated from tangent_normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of normal_contact.py.
 */

#include "tangent_normal_contact.h"

/* Tangent of ``solve_normal``. */
static inline int64_t tangent_normal_contact__solve_normal_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, int64_t point, double force, double force_t, double prescribed, double prescribed_t)
{
    int64_t model;
    model = (int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL)));
    if (model == layout__MODEL_HERTZ)
    {
        tangent_hertz_contact__hertz_contact_t(penetration, penetration_t, count, satisfied, work, work_t, tables, point, force, force_t, prescribed, prescribed_t);
    }
    else if (model == layout__MODEL_ANALYN)
    {
        tangent_analyn_contact__analyn_contact_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, side, force, force_t, prescribed, prescribed_t);
    }
    else if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) == 1.0)
    {
        tangent_strip_contact__coarse_contact_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, force, force_t);
    }
    else
    {
        tangent_strip_contact__strip_contact_t(penetration, penetration_t, count, satisfied, work, work_t, tables, state, side, force, force_t, prescribed, prescribed_t);
    }
    return 0;
}
