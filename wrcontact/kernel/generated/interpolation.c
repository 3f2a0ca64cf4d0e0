/* Generated from patch/interpolation.py by tools/transpile_kernel.py; change that one.
 *
 * Half-length and pressure of a solved patch between its strips, by the rule of the model that filled it.
 */

#include "interpolation.h"

/* Half-length [m] and pressure [Pa] at ``station`` [m] by RULE_QUADRATIC, from the strips of ``count``
 * regions; zeros where nothing is loaded.
 *
 * The quadratics of half-length and pressure do not end exactly where the load does: just outside a patch
 * they can be positive.
 */
static inline int64_t interpolation__quadratic_at(double* half_length, double* pressure, array_double_1d work, int64_t count, double station)
{
    int64_t index;
    int64_t region;
    double own;
    (*half_length) = 0.0;
    (*pressure) = 0.0;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        own = station - (*cspan_at(&work, region + layout__REGION_OFFSET));
        if ((own >= (*cspan_at(&work, region + layout__REGION_LOW))) && (own <= (*cspan_at(&work, region + layout__REGION_HIGH))) && ((*half_length) == 0.0))
        {
            interpolation__between_strips(half_length, pressure, work, region, own);
        }
    }
    return 0;
}

/* Half-length [m] and pressure [Pa] at station ``own`` [m] of the region's own ones, from the three
 * strips that the cell's quadratic goes through; zeros where the region is not loaded.
 */
static inline int64_t interpolation__between_strips(double* half_length, double* pressure, array_double_1d work, int64_t region, double own)
{
    double u;
    bool inside;
    int64_t outward;
    int64_t low;
    double x;
    int64_t inner;
    int64_t before;
    int64_t here;
    int64_t after;
    double length;
    double square;
    (*half_length) = 0.0;
    (*pressure) = 0.0;
    u = (own - (*cspan_at(&work, region + layout__REGION_STATION))) / (*cspan_at(&work, region + layout__REGION_SPACING));
    inside = (u > (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)))) && (u < (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))));
    if (((*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) > 0.0) && inside)
    {
        outward = INT64_C(1);
        if (u < 0.0)
        {
            outward = -INT64_C(1);
            u = -u;
        }
        low = (int64_t)(u);
        x = u - (double)(low);
        inner = (int64_t)((*cspan_at(&work, region + layout__REGION_STRIP))) + outward * low;
        before = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (inner - outward);
        here = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * inner;
        after = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (inner + outward);
        length = quadrature__quadratic_value((*cspan_at(&work, before + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, after + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), x);
        square = quadrature__quadratic_value((*cspan_at(&work, before + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, after + layout__SOLVED_STRIP_PRESSURE_SQUARE)), x);
        if ((length > 0.0) && (square > 0.0))
        {
            (*half_length) = sqrt(length);
            (*pressure) = sqrt(square);
        }
    }
    return 0;
}

/* Half-length [m] and pressure [Pa] of a patch at ``station`` [m] between its edges, by RULE_STRAIGHT;
 * ``after`` is its first strip beyond the station, or the one after its last.
 */
static inline int64_t interpolation__straight_at(double* half_length, double* pressure, array_double_1d work, int64_t patch, int64_t after, double station)
{
    double low;
    double low_length;
    double low_pressure;
    int64_t inner;
    double high;
    double high_length;
    double high_pressure;
    int64_t outer;
    double share;
    low = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    low_length = 0.0;
    low_pressure = 0.0;
    if (after > (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST))))
    {
        inner = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (after - INT64_C(1));
        low = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION));
        low_length = (*cspan_at(&work, inner + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
        low_pressure = (*cspan_at(&work, inner + layout__SOLVED_STRIP_PRESSURE_SQUARE));
    }
    high = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP));
    high_length = 0.0;
    high_pressure = 0.0;
    if (after <= (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST))))
    {
        outer = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * after;
        high = (*cspan_at(&work, outer + layout__SOLVED_STRIP_STATION));
        high_length = (*cspan_at(&work, outer + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
        high_pressure = (*cspan_at(&work, outer + layout__SOLVED_STRIP_PRESSURE_SQUARE));
    }
    share = (station - low) / (high - low);
    (*half_length) = sqrt(low_length + share * (high_length - low_length));
    (*pressure) = sqrt(low_pressure + share * (high_pressure - low_pressure));
    return 0;
}
