/* Generated from wheelset/wear_outline.py by tools/transpile_kernel.py; change that one.
 *
 * Shear and slip over the outline of a wheel, for models of wear.
 *
 * Of a strip with the creep force F_i and the power P_i per width and the half-length a_i
 *
 *     shear = |F_i| / (2 a_i),   slip = P_i / |F_i|,   P_i = -V_ref (w_x F_x + eta F_y + phi M_z)
 *
 * so that shear times slip is the friction power per area, as the strip has it from its leading to its trailing
 * edge.  Elastic deformation takes and gives back power within a strip and is no part of P_i.  Between the
 * middles of strips both follow straight lines; a strip that would gain power counts as one that sticks.
 */

#include "wear_outline.h"

/* Shear [Pa] and slip [m/s] of the patches of a wheel at the ``stations`` of its outline; zero between
 * patches.
 */
static inline int64_t wear_outline__write_wear(array_double_1d work, int64_t outline, int64_t stations, int64_t rolling)
{
    int64_t number_end;
    int64_t number;
    number_end = (int64_t)((*cspan_at(&work, rolling + layout__ROLLING_SIDE_COUNT)));
    for (number = INT64_C(0); number < number_end; number += INT64_C(1))
    {
        wear_outline__write_patch_wear(work, outline, stations, rolling + layout__ROLLING_SIDE_PATCHES + layout__ROLLING_PATCH_SIZE * number);
    }
    return INT64_C(0);
}

/* Shear and slip of a patch at the stations that lie in it, which ascend, along with the strips. */
static inline int64_t wear_outline__write_patch_wear(array_double_1d work, int64_t outline, int64_t stations, int64_t patch)
{
    int64_t first;
    int64_t last;
    double start;
    double stop;
    int64_t index;
    double low_station;
    double high_station;
    double low_shear;
    double low_slip;
    double high_shear;
    double high_slip;
    int64_t j;
    double station;
    int64_t strip;
    double shear;
    double slip;
    double share;
    first = patch + layout__ROLLING_PATCH_STRIPS;
    last = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * ((int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT))) - INT64_C(1));
    start = (*cspan_at(&work, first + layout__ROLLING_STRIP_STATION)) - 0.5 * (*cspan_at(&work, first + layout__ROLLING_STRIP_WIDTH));
    stop = (*cspan_at(&work, last + layout__ROLLING_STRIP_STATION)) + 0.5 * (*cspan_at(&work, last + layout__ROLLING_STRIP_WIDTH));
    index = INT64_C(0);
    low_station = (*cspan_at(&work, first + layout__ROLLING_STRIP_STATION));
    high_station = (*cspan_at(&work, first + layout__ROLLING_STRIP_STATION));
    low_shear = 0.0;
    low_slip = 0.0;
    high_shear = wear_outline__strip_shear(work, first);
    high_slip = wear_outline__strip_slip(work, patch, first);
    for (j = INT64_C(1); j < stations - INT64_C(1); j += INT64_C(1))
    {
        station = (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + j));
        if ((station > start) && (station < stop))
        {
            while((index < (int64_t)((*cspan_at(&work, patch + layout__ROLLING_PATCH_COUNT))) - INT64_C(1)) && (high_station < station))
            {
                index += INT64_C(1);
                strip = patch + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * index;
                low_station = high_station;
                low_shear = high_shear;
                low_slip = high_slip;
                high_station = (*cspan_at(&work, strip + layout__ROLLING_STRIP_STATION));
                high_shear = wear_outline__strip_shear(work, strip);
                high_slip = wear_outline__strip_slip(work, patch, strip);
            }
            shear = high_shear;
            slip = high_slip;
            if ((index > INT64_C(0)) && (station < high_station))
            {
                share = (high_station - station) / (high_station - low_station);
                shear += share * (low_shear - shear);
                slip += share * (low_slip - slip);
            }
            (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(3) * stations + j))) = shear;
            (*cspan_at(&work, outline + layout__OUTLINE_NUMBERS + (INT64_C(4) * stations + j))) = slip;
        }
    }
    return INT64_C(0);
}

/* Creep force per area of a strip [Pa]. */
static inline double wear_outline__strip_shear(array_double_1d work, int64_t strip)
{
    double force;
    double shear;
    shear = 0.0;
    if ((*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)) > 0.0)
    {
        force = sqrt((*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)));
        shear = force / (2.0 * (*cspan_at(&work, strip + layout__ROLLING_STRIP_HALF_LENGTH)));
    }
    return shear;
}

/* Friction power of a strip over its creep force [m/s]. */
static inline double wear_outline__strip_slip(array_double_1d work, int64_t patch, int64_t strip)
{
    double force;
    double power;
    double slip;
    force = sqrt((*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)));
    slip = 0.0;
    if (force > 0.0)
    {
        power = -((*cspan_at(&work, strip + layout__ROLLING_STRIP_SLIP)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_X)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_FORCE_Y)) + (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPIN)) * (*cspan_at(&work, strip + layout__ROLLING_STRIP_MOMENT)));
        if (power > 0.0)
        {
            slip = (*cspan_at(&work, patch + layout__ROLLING_PATCH_SPEED)) * power / force;
        }
    }
    return slip;
}
