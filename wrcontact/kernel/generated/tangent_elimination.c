/* Generated from tangent_elimination.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of elimination.py.
 */

#include "tangent_elimination.h"

/* Tangent of ``eliminate``. */
static inline int64_t tangent_elimination__eliminate_t(array_double_1d work, array_double_1d work_t, int64_t size)
{
    int64_t width;
    int64_t pair;
    int64_t k;
    int64_t first;
    int64_t second;
    double v1;
    double inverse_t;
    double inverse;
    double factor_t;
    double factor;
    int64_t j;
    double v2;
    double next_inverse_t;
    double next_inverse;
    int64_t i;
    int64_t row;
    double v3;
    double next_factor_t;
    double next_factor;
    int64_t back;
    int64_t pivot;
    double one_t;
    double one;
    double other_t;
    double other;
    double v4;
    double v5;
    width = size + INT64_C(2);
    for (pair = INT64_C(0); pair < py_floor_div_int64_t(size, INT64_C(2)); pair += INT64_C(1))
    {
        k = INT64_C(2) * pair;
        first = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * k;
        second = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * (k + INT64_C(1));
        v1 = 1.0 / (*cspan_at(&work, first + k));
        inverse_t = (-v1) * (*cspan_at(&work_t, first + k)) / (*cspan_at(&work, first + k));
        inverse = v1;
        factor_t = (*cspan_at(&work_t, second + k)) * inverse + (*cspan_at(&work, second + k)) * inverse_t;
        factor = (*cspan_at(&work, second + k)) * inverse;
        for (j = k + INT64_C(1); j < width; j += INT64_C(1))
        {
            (*cspan_at(&work_t, second + j)) = (*cspan_at(&work_t, second + j)) - (factor_t * (*cspan_at(&work, first + j)) + factor * (*cspan_at(&work_t, first + j)));
            (*cspan_at(&work, second + j)) = (*cspan_at(&work, second + j)) - factor * (*cspan_at(&work, first + j));
        }
        v2 = 1.0 / (*cspan_at(&work, second + (k + INT64_C(1))));
        next_inverse_t = (-v2) * (*cspan_at(&work_t, second + (k + INT64_C(1)))) / (*cspan_at(&work, second + (k + INT64_C(1))));
        next_inverse = v2;
        for (i = k + INT64_C(2); i < size; i += INT64_C(1))
        {
            row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * i;
            factor_t = (*cspan_at(&work_t, row + k)) * inverse + (*cspan_at(&work, row + k)) * inverse_t;
            factor = (*cspan_at(&work, row + k)) * inverse;
            v3 = (*cspan_at(&work, row + (k + INT64_C(1)))) - factor * (*cspan_at(&work, first + (k + INT64_C(1))));
            next_factor_t = ((*cspan_at(&work_t, row + (k + INT64_C(1)))) - (factor_t * (*cspan_at(&work, first + (k + INT64_C(1)))) + factor * (*cspan_at(&work_t, first + (k + INT64_C(1)))))) * next_inverse + v3 * next_inverse_t;
            next_factor = v3 * next_inverse;
            for (j = k + INT64_C(2); j < width; j += INT64_C(1))
            {
                (*cspan_at(&work_t, row + j)) = (*cspan_at(&work_t, row + j)) - (factor_t * (*cspan_at(&work, first + j)) + factor * (*cspan_at(&work_t, first + j))) - (next_factor_t * (*cspan_at(&work, second + j)) + next_factor * (*cspan_at(&work_t, second + j)));
                (*cspan_at(&work, row + j)) = (*cspan_at(&work, row + j)) - factor * (*cspan_at(&work, first + j)) - next_factor * (*cspan_at(&work, second + j));
            }
        }
    }
    for (back = INT64_C(0); back < size; back += INT64_C(1))
    {
        k = size - INT64_C(1) - back;
        pivot = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * k;
        one_t = (*cspan_at(&work_t, pivot + size));
        one = (*cspan_at(&work, pivot + size));
        other_t = (*cspan_at(&work_t, pivot + (size + INT64_C(1))));
        other = (*cspan_at(&work, pivot + (size + INT64_C(1))));
        for (j = k + INT64_C(1); j < size; j += INT64_C(1))
        {
            row = layout__WORK_CONTACT + layout__CONTACT_EQUATIONS + INT64_C(106) * j;
            one_t = one_t - ((*cspan_at(&work_t, pivot + j)) * (*cspan_at(&work, row + size)) + (*cspan_at(&work, pivot + j)) * (*cspan_at(&work_t, row + size)));
            one = one - (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + size));
            other_t = other_t - ((*cspan_at(&work_t, pivot + j)) * (*cspan_at(&work, row + (size + INT64_C(1)))) + (*cspan_at(&work, pivot + j)) * (*cspan_at(&work_t, row + (size + INT64_C(1)))));
            other = other - (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, row + (size + INT64_C(1))));
        }
        v4 = one / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work_t, pivot + size)) = (one_t - v4 * (*cspan_at(&work_t, pivot + k))) / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work, pivot + size)) = v4;
        v5 = other / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work_t, pivot + (size + INT64_C(1)))) = (other_t - v5 * (*cspan_at(&work_t, pivot + k))) / (*cspan_at(&work, pivot + k));
        (*cspan_at(&work, pivot + (size + INT64_C(1)))) = v5;
    }
    return INT64_C(0);
}
