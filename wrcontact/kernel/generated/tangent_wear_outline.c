/* Generated from tangent_wear_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of wear_outline.py.
 */

#include "tangent_wear_outline.h"

/* Tangent of ``write_wear``. */
static inline int64_t tangent_wear_outline__write_wear_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t rolling)
{
    int64_t j;
    double station_t;
    double station;
    int64_t number_end;
    int64_t number;
    int64_t patch;
    double shear;
    double shear_t;
    double slip;
    double slip_t;
    for (j = INT64_C(1); j < stations - INT64_C(1); j += INT64_C(1))
    {
        station_t = (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + j));
        station = (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j));
        number_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)));
        for (number = INT64_C(0); number < number_end; number += INT64_C(1))
        {
            patch = rolling + layout__ROLLING_SIDE_PATCHES + layout__ROLLING_PATCH_SIZE * number;
            if (wear_outline__reaches(work, patch, station) == INT64_C(1))
            {
                tangent_wear_outline__wear_at_t(&shear, &shear_t, &slip, &slip_t, work, work_t, patch, station, station_t);
                (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(3) * stations + j))) = shear_t;
                (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(3) * stations + j))) = shear;
                (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(4) * stations + j))) = slip_t;
                (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(4) * stations + j))) = slip;
            }
        }
    }
    return INT64_C(0);
}

/* Tangent of ``wear_at``. */
static inline int64_t tangent_wear_outline__wear_at_t(double* shear, double* shear_t, double* slip, double* slip_t, array_double_1d work, array_double_1d work_t, int64_t patch, double station, double station_t)
{
    int64_t index;
    int64_t high;
    double v1;
    double v1_t;
    double v2;
    double v2_t;
    int64_t low;
    double v3;
    double v4;
    double v5;
    double share_t;
    double share;
    double v6;
    double v6_t;
    double v7;
    double v8;
    double v8_t;
    double v9;
    index = INT64_C(0);
    while((index < (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT))) - INT64_C(1)) && ((*cspan_at(&work, patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index + layout__ROLLING_STRIP_STATION)) < station))
    {
        index = index + INT64_C(1);
    }
    high = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
    tangent_wear_outline__strip_shear_t(&v1, &v1_t, work, work_t, high);
    (*shear_t) = v1_t;
    (*shear) = v1;
    tangent_wear_outline__strip_slip_t(&v2, &v2_t, work, work_t, patch, high);
    (*slip_t) = v2_t;
    (*slip) = v2;
    if ((index > INT64_C(0)) && (station < (*cspan_at(&work, high + layout__ROLLING_STRIP_STATION))))
    {
        low = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * (index - INT64_C(1));
        v3 = (*cspan_at(&work, high + layout__ROLLING_STRIP_STATION)) - station;
        v4 = (*cspan_at(&work, high + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work, low + layout__ROLLING_STRIP_STATION));
        v5 = v3 / v4;
        share_t = ((*cspan_at(&work_t, high + layout__ROLLING_STRIP_STATION)) - station_t - v5 * ((*cspan_at(&work_t, high + layout__ROLLING_STRIP_STATION)) - (*cspan_at(&work_t, low + layout__ROLLING_STRIP_STATION)))) / v4;
        share = v5;
        tangent_wear_outline__strip_shear_t(&v6, &v6_t, work, work_t, low);
        v7 = v6 - (*shear);
        (*shear_t) = (*shear_t) + (share_t * v7 + share * (v6_t - (*shear_t)));
        (*shear) = (*shear) + share * v7;
        tangent_wear_outline__strip_slip_t(&v8, &v8_t, work, work_t, patch, low);
        v9 = v8 - (*slip);
        (*slip_t) = (*slip_t) + (share_t * v9 + share * (v8_t - (*slip_t)));
        (*slip) = (*slip) + share * v9;
    }
    return 0;
}

/* Tangent of ``strip_shear``. */
static inline int64_t tangent_wear_outline__strip_shear_t(double* shear, double* shear_t, array_double_1d work, array_double_1d work_t, int64_t strip)
{
    double v1;
    double v2;
    double force_t;
    double force;
    double v3;
    double v4;
    (*shear_t) = 0.0;
    (*shear) = 0.0;
    if ((*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) > 0.0)
    {
        v1 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y));
        v2 = sqrt(v1);
        force_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) + ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y))));
        force = v2;
        v3 = 2.0 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH));
        v4 = force / v3;
        (*shear_t) = (force_t - v4 * (2.0 * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_HALF_LENGTH)))) / v3;
        (*shear) = v4;
    }
    return 0;
}

/* Tangent of ``strip_slip``. */
static inline int64_t tangent_wear_outline__strip_slip_t(double* slip, double* slip_t, array_double_1d work, array_double_1d work_t, int64_t patch, int64_t strip)
{
    double v1;
    double v2;
    double force_t;
    double force;
    double power_t;
    double power;
    double v3;
    double v4;
    v1 = (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y));
    v2 = sqrt(v1);
    force_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) + ((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y))));
    force = v2;
    (*slip_t) = 0.0;
    (*slip) = 0.0;
    if (force > 0.0)
    {
        power_t = -((*cspan_at(&work_t, strip + layout__ROLLING_STRIP_SLIP)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_X)) + ((*cspan_at(&work_t, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_FORCE_Y))) + ((*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_MOMENT))));
        power = -((*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)));
        if (power > 0.0)
        {
            v3 = (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPEED)) * power;
            v4 = v3 / force;
            (*slip_t) = ((*cspan_at(&work_t, patch + layout__ROLLING_PATCH_SPEED)) * power + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPEED)) * power_t - v4 * force_t) / force;
            (*slip) = v4;
        }
    }
    return 0;
}
