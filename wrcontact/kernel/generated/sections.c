/* Generated from tangential/sections.py by tools/transpile_kernel.py; change that one.
 *
 * provisional
 */

#include "sections.h"

/* provisional: an ellipse */
static inline int64_t sections__cut_patch(array_double_1d work, int64_t index, int64_t rolling)
{
    int64_t patch;
    int64_t totals;
    double ratio;
    double low;
    int64_t k;
    int64_t strip;
    double high;
    double t;
    patch = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_PATCHES + layout__SOLVED_PATCH_SIZE * index;
    totals = patch + layout__SOLVED_PATCH_TOTALS;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD));
    ratio = 2.0 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_MAX_HALF_LENGTH)) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) = sqrt((*cspan_at(&work, totals + layout__PATCH_TOTALS_AREA)) / (M_PI * ratio));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) = ratio * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_COUNT)) = 16.0;
    low = (*cspan_at(&work, totals + layout__PATCH_TOTALS_START));
    for (k = INT64_C(0); k < INT64_C(16); k += INT64_C(1))
    {
        strip = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * k;
        high = 0.5 * ((*cspan_at(&work, totals + layout__PATCH_TOTALS_START)) + (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP))) - 0.5 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)) * cos((k + INT64_C(1)) * M_PI / 16.0);
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) = 0.5 * (low + high);
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y)) = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work, totals + layout__PATCH_TOTALS_CENTROID));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_WIDTH)) = high - low;
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_X)) = (*cspan_at(&work, patch + layout__SOLVED_PATCH_SLANT)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_Y));
        t = ((*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION)) - 0.5 * ((*cspan_at(&work, totals + layout__PATCH_TOTALS_START)) + (*cspan_at(&work, totals + layout__PATCH_TOTALS_STOP)))) / (0.5 * (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH)));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * sqrt(fabs(1.0 - t * t));
        (*cspan_at(&work, strip + layout__ROLLING_STRIP_LINE_LOAD)) = (*cspan_at(&work, totals + layout__PATCH_TOTALS_LOAD)) / (*cspan_at(&work, totals + layout__PATCH_TOTALS_WIDTH));
        low = high;
    }
    return INT64_C(0);
}
