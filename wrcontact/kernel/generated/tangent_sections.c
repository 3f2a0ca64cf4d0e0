/* Generated from tangent_sections.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of sections.py.
 */

#include "tangent_sections.h"

/* Tangent of ``cut_patch``. */
static inline int64_t tangent_sections__cut_patch_t(array_double_1d work, array_double_1d work_t, int64_t index, int64_t rolling)
{
    int64_t patch;
    int64_t totals;
    double v1;
    double v2;
    double ratio_t;
    double ratio;
    double v3;
    double v4;
    double v5;
    double low_t;
    double low;
    int64_t k;
    int64_t strip;
    double v6;
    double v7;
    double v8;
    double high_t;
    double high;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    double t_t;
    double t;
    double v14;
    double v15;
    double v16;
    double v17;
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    totals = patch + layout__SOLVED_PATCH_TOTALS;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD)) = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
    v1 = 2.0 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH));
    v2 = v1 / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
    ratio_t = (2.0 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) - v2 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_WIDTH))) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
    ratio = v2;
    v3 = M_PI * ratio;
    v4 = (*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) / v3;
    v5 = sqrt(v4);
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = tangent_rates__root_rate(v5, ((*cspan_at(&work_t, totals + layout__PATCH_TOTALS_AREA)) - v4 * (M_PI * ratio_t)) / v3);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = v5;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = ratio_t * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) + ratio * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = ratio * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_COUNT)) = 0.0;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)) = 16.0;
    low_t = (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_START));
    low = (*cspan_at(&work, totals + layout__PATCH_TOTALS_START));
    for (k = INT64_C(0); k < INT64_C(16); k += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * k;
        v6 = (*cspan_at(&work, totals + layout__PATCH_TOTALS_START)) + (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP));
        v7 = 0.5 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        v8 = cos((k + INT64_C(1)) * M_PI / 16.0);
        high_t = 0.5 * ((*cspan_at(&work_t, totals + layout__PATCH_TOTALS_START)) + (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP))) - 0.5 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_WIDTH)) * v8;
        high = 0.5 * v6 - v7 * v8;
        v9 = low + high;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION)) = 0.5 * (low_t + high_t);
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) = 0.5 * v9;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y)) = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_CENTROID));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID));
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_WIDTH)) = high_t - low_t;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) = high - low;
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_X)) = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_SLANT)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) + (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_Y));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
        v10 = (*cspan_at(&work, totals + layout__PATCH_TOTALS_START)) + (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP));
        v11 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - 0.5 * v10;
        v12 = 0.5 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        v13 = v11 / v12;
        t_t = ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION)) - 0.5 * ((*cspan_at(&work_t, totals + layout__PATCH_TOTALS_START)) + (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_STOP))) - v13 * (0.5 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_WIDTH)))) / v12;
        t = v13;
        v14 = 1.0 - t * t;
        v15 = fabs(v14);
        v16 = sqrt(v15);
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * v16 + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * tangent_rates__root_rate(v16, tangent_rates__size_rate(v14, -(t_t * t + t * t_t)));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * v16;
        v17 = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_LINE_LOAD)) = ((*cspan_at(&work_t, totals + layout__PATCH_TOTALS_LOAD)) - v17 * (*cspan_at(&work_t, totals + layout__PATCH_TOTALS_WIDTH))) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = v17;
        low_t = high_t;
        low = high;
    }
    return INT64_C(0);
}
