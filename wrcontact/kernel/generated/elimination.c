/* Generated from normal/elimination.py by tools/transpile_kernel.py; change that one.
 *
 * Linear equations with two right-hand sides.
 */

#include "elimination.h"

/* Solve ``size`` equations in place: the two right-hand sides, in the last two columns, become the
 * solutions.
 *
 * Gauss without exchange of rows: the matrix is that of a positive kernel, largest on the diagonal.
 */
static inline int64_t elimination__eliminate(array_double_1d work, int64_t size)
{
    int64_t width;
    int64_t pair;
    int64_t k;
    int64_t first;
    int64_t second;
    double inverse;
    double factor;
    int64_t j;
    double next_inverse;
    int64_t i;
    int64_t row;
    double next_factor;
    int64_t back;
    int64_t pivot;
    double one;
    double other;
    width = size + INT64_C(2);
    for (pair = INT64_C(0); pair < py_floor_div_int64_t(size, INT64_C(2)); pair += INT64_C(1))
    {
        /* two columns at a time, so that every row is read and written once for both */
        k = INT64_C(2) * pair;
        first = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * k;
        second = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * (k + INT64_C(1));
        inverse = 1.0 / (*cspan_at(&work, first + k));
        factor = (*cspan_at(&work, second + k)) * inverse;
        for (j = k + INT64_C(1); j < width; j += INT64_C(1))
        {
            (*cspan_at(&work, second + j)) -= factor * (*cspan_at(&work, first + j));
        }
        next_inverse = 1.0 / (*cspan_at(&work, second + (k + INT64_C(1))));
        for (i = k + INT64_C(2); i < size; i += INT64_C(1))
        {
            row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * i;
            factor = (*cspan_at(&work, row + k)) * inverse;
            next_factor = ((*cspan_at(&work, row + (k + INT64_C(1)))) - factor * (*cspan_at(&work, first + (k + INT64_C(1))))) * next_inverse;
            for (j = k + INT64_C(2); j < width; j += INT64_C(1))
            {
                (*cspan_at(&work, row + j)) = (*cspan_at(&work, row + j)) - factor * (*cspan_at(&work, first + j)) - next_factor * (*cspan_at(&work, second + j));
            }
        }
    }
    for (back = INT64_C(0); back < size; back += INT64_C(1))
    {
        k = size - INT64_C(1) - back;
        pivot = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * k;
        one = (*cspan_at(&work, pivot + size));
        other = (*cspan_at(&work, pivot + (size + INT64_C(1))));
        for (j = k + INT64_C(1); j < size; j += INT64_C(1))
        {
            row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * j;
            one -= (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + size));
            other -= (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + (size + INT64_C(1))));
        }
        (*cspan_at(&work, pivot + size)) = one / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work, pivot + (size + INT64_C(1)))) = other / (*cspan_at(&work, pivot + k));
    }
    return INT64_C(0);
}
