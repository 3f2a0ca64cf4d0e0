/* Generated from tangent_wear_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of wear_outline.py.
 */

#include "tangent_wear_outline.h"

/* Tangent of ``write_wear``. */
static inline int64_t tangent_wear_outline__write_wear_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t rolling)
{
    int64_t number_end;
    int64_t number;
    number_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        tangent_wear_outline__write_patch_wear_t(work, work_t, outline, stations, rolling + layout__ROLLING_SIDE_PATCHES + layout__ROLLING_PATCH_SIZE * number);
    }
    return INT64_C(0);
}

/* Tangent of ``write_patch_wear``. */
static inline int64_t tangent_wear_outline__write_patch_wear_t(array_double_1d work, array_double_1d work_t, int64_t outline, int64_t stations, int64_t patch)
{
    int64_t first;
    int64_t last;
    double start_t;
    double start;
    double stop_t;
    double stop;
    int64_t index;
    double low_station_t;
    double low_station;
    double high_station_t;
    double high_station;
    double low_shear_t;
    double low_shear;
    double low_slip_t;
    double low_slip;
    double v1;
    double v1_t;
    double high_shear_t;
    double high_shear;
    double v2;
    double v2_t;
    double high_slip_t;
    double high_slip;
    int64_t j;
    double station_t;
    double station;
    int64_t strip;
    double v3;
    double v3_t;
    double v4;
    double v4_t;
    double shear_t;
    double shear;
    double slip_t;
    double slip;
    double v5;
    double v6;
    double v7;
    double share_t;
    double share;
    double v8;
    double v9;
    first = patch + layout__ROLLING_PATCH_STRIPS;
    last = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * ((int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT))) - INT64_C(1));
    start_t = (*cspan_at(&work_t, first + layout__ROLLING_STRIP_STATION)) - 0.5 * (*cspan_at(&work_t, first + layout__ROLLING_STRIP_WIDTH));
    start = (*cspan_at(&work, first + layout__ROLLING_STRIP_STATION)) - 0.5 * (*cspan_at(&work, first + layout__ROLLING_STRIP_WIDTH));
    stop_t = (*cspan_at(&work_t, last + layout__ROLLING_STRIP_STATION)) + 0.5 * (*cspan_at(&work_t, last + layout__ROLLING_STRIP_WIDTH));
    stop = (*cspan_at(&work, last + layout__ROLLING_STRIP_STATION)) + 0.5 * (*cspan_at(&work, last + layout__ROLLING_STRIP_WIDTH));
    index = INT64_C(0);
    low_station_t = (*cspan_at(&work_t, first + layout__ROLLING_STRIP_STATION));
    low_station = (*cspan_at(&work, first + layout__ROLLING_STRIP_STATION));
    high_station_t = (*cspan_at(&work_t, first + layout__ROLLING_STRIP_STATION));
    high_station = (*cspan_at(&work, first + layout__ROLLING_STRIP_STATION));
    low_shear_t = 0.0;
    low_shear = 0.0;
    low_slip_t = 0.0;
    low_slip = 0.0;
    tangent_wear_outline__strip_shear_t(&v1, &v1_t, work, work_t, first);
    high_shear_t = v1_t;
    high_shear = v1;
    tangent_wear_outline__strip_slip_t(&v2, &v2_t, work, work_t, patch, first);
    high_slip_t = v2_t;
    high_slip = v2;
    for (j = INT64_C(1); j < stations - INT64_C(1); j += INT64_C(1))
    {
        station_t = (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + j));
        station = (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j));
        if ((station > start) && (station < stop))
        {
            while((index < (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT))) - INT64_C(1)) && (high_station < station))
            {
                index = index + INT64_C(1);
                strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
                low_station_t = high_station_t;
                low_station = high_station;
                low_shear_t = high_shear_t;
                low_shear = high_shear;
                low_slip_t = high_slip_t;
                low_slip = high_slip;
                high_station_t = (*cspan_at(&work_t, strip + layout__ROLLING_STRIP_STATION));
                high_station = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION));
                tangent_wear_outline__strip_shear_t(&v3, &v3_t, work, work_t, strip);
                high_shear_t = v3_t;
                high_shear = v3;
                tangent_wear_outline__strip_slip_t(&v4, &v4_t, work, work_t, patch, strip);
                high_slip_t = v4_t;
                high_slip = v4;
            }
            shear_t = high_shear_t;
            shear = high_shear;
            slip_t = high_slip_t;
            slip = high_slip;
            if ((index > INT64_C(0)) && (station < high_station))
            {
                v5 = high_station - station;
                v6 = high_station - low_station;
                v7 = v5 / v6;
                share_t = (high_station_t - station_t - v7 * (high_station_t - low_station_t)) / v6;
                share = v7;
                v8 = low_shear - shear;
                shear_t = shear_t + (share_t * v8 + share * (low_shear_t - shear_t));
                shear = shear + share * v8;
                v9 = low_slip - slip;
                slip_t = slip_t + (share_t * v9 + share * (low_slip_t - slip_t));
                slip = slip + share * v9;
            }
            (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(3) * stations + j))) = shear_t;
            (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(3) * stations + j))) = shear;
            (*cspan_at(&work_t, outline + layout__OUTLINE_NUMBERS + (INT64_C(4) * stations + j))) = slip_t;
            (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(4) * stations + j))) = slip;
        }
    }
    return INT64_C(0);
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
