/* Generated from normal/normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The normal contact of one side, by the model that is chosen: each one fills the solved patches.
 *
 * A further model is a file with a function like :func:`~.analyn_contact.analyn_contact`, and a line here.
 */

#include "normal_contact.h"

/* Fill the solved patches of the side whose frame is open, under ``force`` [N], or at ``prescribed``
 * penetration [m] if that is a number.  ``point`` : the outputs of the side, which describe its contact
 * point.
 *
 * Returns the penetration [m], the number of regions, and 1 when the force is satisfied, else 0.
 */
static inline int64_t normal_contact__solve_normal(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, int64_t point, double force, double prescribed)
{
    int64_t model;
    model = (int64_t)((*cspan_at(&tables, layout__TABLES_NORMAL_MODEL)));
    if (model == layout__MODEL_HERTZ)
    {
        hertz_contact__hertz_contact(penetration, count, satisfied, work, tables, point, force, prescribed);
    }
    else if (model == layout__MODEL_ANALYN)
    {
        analyn_contact__analyn_contact(penetration, count, satisfied, work, tables, state, side, force, prescribed);
    }
    else if ((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_COARSE)) == 1.0)
    {
        strip_contact__coarse_contact(penetration, count, satisfied, work, tables, state, force);
    }
    else
    {
        strip_contact__strip_contact(penetration, count, satisfied, work, tables, state, side, force, prescribed);
    }
    return 0;
}
