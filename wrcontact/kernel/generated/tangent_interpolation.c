/* Generated from tangent_interpolation.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of interpolation.py.
 */

#include "tangent_interpolation.h"

/* Tangent of ``quadratic_at``. */
static inline int64_t tangent_interpolation__quadratic_at_t(double* half_length, double* half_length_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t count, double station, double station_t)
{
    int64_t index;
    int64_t region;
    double own_t;
    double own;
    (*half_length_t) = 0.0;
    (*half_length) = 0.0;
    (*pressure_t) = 0.0;
    (*pressure) = 0.0;
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        region = layout__WORK_CONTACT + layout__CONTACT_REGIONS + layout__REGION_SIZE * index;
        own_t = station_t - (*cspan_at(&work_t, region + layout__REGION_OFFSET));
        own = station - (*cspan_at(&work, region + layout__REGION_OFFSET));
        if ((own >= (*cspan_at(&work, region + layout__REGION_LOW))) && (own <= (*cspan_at(&work, region + layout__REGION_HIGH))) && ((*half_length) == 0.0))
        {
            tangent_interpolation__between_strips_t(half_length, half_length_t, pressure, pressure_t, work, work_t, region, own, own_t);
        }
    }
    return 0;
}

/* Tangent of ``between_strips``. */
static inline int64_t tangent_interpolation__between_strips_t(double* half_length, double* half_length_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t region, double own, double own_t)
{
    double v1;
    double v2;
    double u_t;
    double u;
    bool inside;
    int64_t outward;
    int64_t low;
    double x_t;
    double x;
    int64_t inner;
    int64_t before;
    int64_t here;
    int64_t after;
    double v3;
    double v3_t;
    double length_t;
    double length;
    double v4;
    double v4_t;
    double square_t;
    double square;
    double v5;
    double v6;
    (*half_length_t) = 0.0;
    (*half_length) = 0.0;
    (*pressure_t) = 0.0;
    (*pressure) = 0.0;
    v1 = own - (*cspan_at(&work, region + layout__REGION_STATION));
    v2 = v1 / (*cspan_at(&work, region + layout__REGION_SPACING));
    u_t = (own_t - (*cspan_at(&work_t, region + layout__REGION_STATION)) - v2 * (*cspan_at(&work_t, region + layout__REGION_SPACING))) / (*cspan_at(&work, region + layout__REGION_SPACING));
    u = v2;
    inside = (u > (int64_t)((*cspan_at(&work, region + layout__REGION_FIRST)))) && (u < (int64_t)((*cspan_at(&work, region + layout__REGION_LAST))));
    if (((*cspan_at(&work, region + layout__REGION_LOCAL_PENETRATION)) > 0.0) && inside)
    {
        outward = INT64_C(1);
        if (u < 0.0)
        {
            outward = -INT64_C(1);
            u_t = -u_t;
            u = -u;
        }
        low = (int64_t)(u);
        x_t = u_t;
        x = u - (double)(low);
        inner = (int64_t)((*cspan_at(&work, region + layout__REGION_STRIP))) + outward * low;
        before = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (inner - outward);
        here = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * inner;
        after = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (inner + outward);
        tangent_quadrature__quadratic_value_t(&v3, &v3_t, (*cspan_at(&work, before + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, before + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, here + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work, after + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), (*cspan_at(&work_t, after + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE)), x, x_t);
        length_t = v3_t;
        length = v3;
        tangent_quadrature__quadratic_value_t(&v4, &v4_t, (*cspan_at(&work, before + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work_t, before + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work_t, here + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work, after + layout__SOLVED_STRIP_PRESSURE_SQUARE)), (*cspan_at(&work_t, after + layout__SOLVED_STRIP_PRESSURE_SQUARE)), x, x_t);
        square_t = v4_t;
        square = v4;
        if ((length > 0.0) && (square > 0.0))
        {
            v5 = sqrt(length);
            (*half_length_t) = tangent_rates__root_rate(v5, length_t);
            (*half_length) = v5;
            v6 = sqrt(square);
            (*pressure_t) = tangent_rates__root_rate(v6, square_t);
            (*pressure) = v6;
        }
    }
    return 0;
}

/* Tangent of ``straight_at``. */
static inline int64_t tangent_interpolation__straight_at_t(double* half_length, double* half_length_t, double* pressure, double* pressure_t, array_double_1d work, array_double_1d work_t, int64_t patch, int64_t after, double station, double station_t)
{
    double low_t;
    double low;
    double low_length_t;
    double low_length;
    double low_pressure_t;
    double low_pressure;
    int64_t inner;
    double high_t;
    double high;
    double high_length_t;
    double high_length;
    double high_pressure_t;
    double high_pressure;
    int64_t outer;
    double v1;
    double v2;
    double v3;
    double share_t;
    double share;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    low_t = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    low = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_START));
    low_length_t = 0.0;
    low_length = 0.0;
    low_pressure_t = 0.0;
    low_pressure = 0.0;
    if (after > (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_FIRST))))
    {
        inner = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * (after - INT64_C(1));
        low_t = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_STATION));
        low = (*cspan_at(&work, inner + layout__SOLVED_STRIP_STATION));
        low_length_t = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
        low_length = (*cspan_at(&work, inner + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
        low_pressure_t = (*cspan_at(&work_t, inner + layout__SOLVED_STRIP_PRESSURE_SQUARE));
        low_pressure = (*cspan_at(&work, inner + layout__SOLVED_STRIP_PRESSURE_SQUARE));
    }
    high_t = (*cspan_at(&work_t, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP));
    high = (*cspan_at(&work, patch + layout__SOLVED_PATCH_TOTALS + layout__PATCH_TOTALS_STOP));
    high_length_t = 0.0;
    high_length = 0.0;
    high_pressure_t = 0.0;
    high_pressure = 0.0;
    if (after <= (int64_t)((*cspan_at(&work, patch + layout__SOLVED_PATCH_LAST))))
    {
        outer = layout__WORK_CONTACT + layout__CONTACT_SOLVED + layout__SOLVED_PATCHES_STRIPS + layout__SOLVED_STRIP_SIZE * after;
        high_t = (*cspan_at(&work_t, outer + layout__SOLVED_STRIP_STATION));
        high = (*cspan_at(&work, outer + layout__SOLVED_STRIP_STATION));
        high_length_t = (*cspan_at(&work_t, outer + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
        high_length = (*cspan_at(&work, outer + layout__SOLVED_STRIP_HALF_LENGTH_SQUARE));
        high_pressure_t = (*cspan_at(&work_t, outer + layout__SOLVED_STRIP_PRESSURE_SQUARE));
        high_pressure = (*cspan_at(&work, outer + layout__SOLVED_STRIP_PRESSURE_SQUARE));
    }
    v1 = station - low;
    v2 = high - low;
    v3 = v1 / v2;
    share_t = (station_t - low_t - v3 * (high_t - low_t)) / v2;
    share = v3;
    v4 = high_length - low_length;
    v5 = low_length + share * v4;
    v6 = sqrt(v5);
    (*half_length_t) = tangent_rates__root_rate(v6, low_length_t + (share_t * v4 + share * (high_length_t - low_length_t)));
    (*half_length) = v6;
    v7 = high_pressure - low_pressure;
    v8 = low_pressure + share * v7;
    v9 = sqrt(v8);
    (*pressure_t) = tangent_rates__root_rate(v9, low_pressure_t + (share_t * v7 + share * (high_pressure_t - low_pressure_t)));
    (*pressure) = v9;
    return 0;
}
