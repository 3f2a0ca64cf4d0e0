/* Generated from prepare/placement.py by tools/transpile_kernel.py; change that one.
 *
 * The rail on the track, and the part of a wheel that can be read.
 *
 * A definition (zones.py) is turned and shifted into another one, in millimetres.
 */

#include "prepare_placement.h"

/* What has the sign of the slope of a zone turned by ``angle`` [rad], at ``t`` [mm]. */
static inline double prepare_placement__turned_slope(array_double_1d zones, int64_t row, double t, double angle)
{
    double z;
    double slope;
    double bend;
    prepare_zones__upright_jet(&z, &slope, &bend, zones, row, t);
    return sin(angle) + cos(angle) * slope;
}

/* Where in a zone the turned slope rises through zero [mm], to the last bit; its
 * start if that is nowhere.
 */
static inline double prepare_placement__level_place(array_double_1d zones, int64_t row, double angle)
{
    double low;
    double high;
    double middle;
    low = (*cspan_at(&zones, row + prepare_zones__ZONE_START));
    high = (*cspan_at(&zones, row + prepare_zones__ZONE_STOP));
    if (!((prepare_placement__turned_slope(zones, row, low, angle) < 0.0) && (0.0 <= prepare_placement__turned_slope(zones, row, high, angle))))
    {
        return low;
    }
    middle = 0.5 * (low + high);
    while((low < middle) && (middle < high))
    {
        if (prepare_placement__turned_slope(zones, row, middle, angle) < 0.0)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
        middle = 0.5 * (low + high);
    }
    return middle;
}

/* Point (y, z) [mm] of the turned head where it is level and highest. */
static inline int64_t prepare_placement__highest_point(double* y_top, double* z_top, array_double_1d zones, int64_t base, double angle)
{
    double cosine;
    double sine;
    int64_t i_end;
    int64_t i;
    int64_t row;
    double y;
    double z;
    (*y_top) = 0.0;
    (*z_top) = 0.0;
    cosine = cos(angle);
    sine = sin(angle);
    i_end = (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        row = base + prepare_zones__DEFINITION_ZONES + i * (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_ROW)));
        prepare_zones__turned_point(&y, &z, zones, row, prepare_placement__level_place(zones, row, angle), cosine, sine);
        if ((i == INT64_C(0)) || (z < (*z_top)))
        {
            (*y_top) = y;
            (*z_top) = z;
        }
    }
    return 0;
}

/* Lateral coordinate [mm] at which the turned zone's inner part is ``depth`` [mm]
 * deep, to the last bit.
 */
static inline double prepare_placement__place_at_depth(array_double_1d zones, int64_t row, double cosine, double sine, double depth)
{
    double low;
    double high;
    double middle;
    double z;
    double y;
    low = (*cspan_at(&zones, row + prepare_zones__ZONE_START));
    high = double_min(2, (*cspan_at(&zones, row + prepare_zones__ZONE_STOP)), 0.0);
    middle = 0.5 * (low + high);
    while((low < middle) && (middle < high))
    {
        prepare_zones__turned_point(&y, &z, zones, row, middle, cosine, sine);
        if (depth - z < 0.0)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
        middle = 0.5 * (low + high);
    }
    prepare_zones__turned_point(&y, &z, zones, row, middle, cosine, sine);
    return y;
}

/* Lateral coordinate [mm] of the turned head's inner side at the height ``depth`` [mm], and the height
 * reached, which is less where the side ends before.
 */
static inline int64_t prepare_placement__inner_face(double* result_0_0001, double* result_1_0001, array_double_1d zones, int64_t base, double angle, double depth)
{
    double deepest;
    double cosine;
    double sine;
    int64_t i;
    int64_t row;
    double y;
    double z;
    deepest = prepare_placement__NO_FACE;
    cosine = cos(angle);
    sine = sin(angle);
    i = (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_COUNT))) - INT64_C(1);
    while(i >= INT64_C(0))
    {
        row = base + prepare_zones__DEFINITION_ZONES + i * (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_ROW)));
        if ((*cspan_at(&zones, row + prepare_zones__ZONE_START)) < 0.0)
        {
            prepare_zones__turned_point(&y, &z, zones, row, (*cspan_at(&zones, row + prepare_zones__ZONE_START)), cosine, sine);
            if (z >= depth)
            {
                (*result_0_0001) = prepare_placement__place_at_depth(zones, row, cosine, sine, depth);
                (*result_1_0001) = depth;
                return 0;
            }
            if (z > deepest)
            {
                deepest = z;
            }
        }
        i -= INT64_C(1);
    }
    (*result_0_0001) = 0.0;
    (*result_1_0001) = deepest;
    return 0;
}

/* Turn and shift an arc in place, without what is steeper than STEEPEST; 0 if nothing is left, else 1. */
static inline int64_t prepare_placement__turn_arc(array_double_1d zones, int64_t row, double angle, double y_shift, double z_shift)
{
    double tilt;
    double y_centre;
    double z_centre;
    double radius;
    double start;
    double stop;
    double c;
    double s;
    double y_start;
    double z_start;
    double y_stop;
    double z_stop;
    tilt = (-(*cspan_at(&zones, row + prepare_zones__ZONE_SIDE))) * angle;
    y_centre = (*cspan_at(&zones, row + prepare_zones__ZONE_ORIGIN));
    z_centre = (*cspan_at(&zones, row + prepare_zones__ZONE_Z_CENTRE));
    radius = (*cspan_at(&zones, row + prepare_zones__ZONE_RADIUS));
    start = double_max(2, (*cspan_at(&zones, row + prepare_zones__ZONE_START)), y_centre - radius * sin(prepare_placement__STEEPEST + tilt));
    stop = double_min(2, (*cspan_at(&zones, row + prepare_zones__ZONE_STOP)), y_centre + radius * sin(prepare_placement__STEEPEST - tilt));
    if (stop - start <= prepare_placement__SLIVER)
    {
        return INT64_C(0);
    }
    c = cos(angle);
    s = sin(angle);
    prepare_zones__turned_point(&y_start, &z_start, zones, row, start, c, s);
    prepare_zones__turned_point(&y_stop, &z_stop, zones, row, stop, c, s);
    (*cspan_at(&zones, row + prepare_zones__ZONE_START)) = y_start + y_shift;
    (*cspan_at(&zones, row + prepare_zones__ZONE_STOP)) = y_stop + y_shift;
    (*cspan_at(&zones, row + prepare_zones__ZONE_ORIGIN)) = c * y_centre - s * z_centre + y_shift;
    (*cspan_at(&zones, row + prepare_zones__ZONE_Z_CENTRE)) = s * y_centre + c * z_centre + z_shift;
    return INT64_C(1);
}

/* Turn and shift a polynomial in place; 0 if it is steeper than STEEPEST at an end, else 1. */
static inline int64_t prepare_placement__turn_polynomial(array_double_1d zones, int64_t row, double angle, double y_shift, double z_shift)
{
    double first;
    double last;
    double z;
    double at_first;
    double bend;
    double at_last;
    double c;
    double s;
    double y_first;
    double y_last;
    if ((angle == 0.0) && (y_shift == 0.0) && (z_shift == 0.0))
    {
        return INT64_C(1);
    }
    first = (*cspan_at(&zones, row + prepare_zones__ZONE_START));
    last = (*cspan_at(&zones, row + prepare_zones__ZONE_STOP));
    prepare_zones__upright_jet(&z, &at_first, &bend, zones, row, first);
    prepare_zones__upright_jet(&z, &at_last, &bend, zones, row, last);
    if ((fabs(atan(at_first) + angle) > prepare_placement__STEEPEST) || (fabs(atan(at_last) + angle) > prepare_placement__STEEPEST))
    {
        return INT64_C(0);
    }
    c = cos(angle);
    s = sin(angle);
    prepare_zones__turned_point(&y_first, &z, zones, row, first, c, s);
    prepare_zones__turned_point(&y_last, &z, zones, row, last, c, s);
    (*cspan_at(&zones, row + prepare_zones__ZONE_TURNED)) = 1.0;
    (*cspan_at(&zones, row + prepare_zones__ZONE_COS)) = c;
    (*cspan_at(&zones, row + prepare_zones__ZONE_SIN)) = s;
    (*cspan_at(&zones, row + prepare_zones__ZONE_Y_SHIFT)) = y_shift;
    (*cspan_at(&zones, row + prepare_zones__ZONE_Z_SHIFT)) = z_shift;
    (*cspan_at(&zones, row + prepare_zones__ZONE_FIRST)) = first;
    (*cspan_at(&zones, row + prepare_zones__ZONE_LAST)) = last;
    (*cspan_at(&zones, row + prepare_zones__ZONE_START)) = y_first + y_shift;
    (*cspan_at(&zones, row + prepare_zones__ZONE_STOP)) = y_last + y_shift;
    return INT64_C(1);
}

/* Turn [rad] and shift [mm] a whole definition in place, without its steep parts;
 * how many zones are left.
 */
static inline int64_t prepare_placement__turn_zones(array_double_1d zones, int64_t base, double angle, double y_shift, double z_shift)
{
    int64_t size;
    int64_t i_end;
    int64_t i;
    int64_t row;
    int64_t k;
    int64_t left;
    int64_t kept;
    size = (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_ROW)));
    kept = INT64_C(0);
    i_end = (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_COUNT)));
    for (i = INT64_C(0); i < i_end; i += INT64_C(1))
    {
        row = base + prepare_zones__DEFINITION_ZONES + kept * size;
        for (k = INT64_C(0); k < size; k += INT64_C(1))
        {
            (*cspan_at(&zones, row + k)) = (*cspan_at(&zones, base + prepare_zones__DEFINITION_ZONES + i * size + k));
        }
        left = INT64_C(0);
        if ((int64_t)((*cspan_at(&zones, row + prepare_zones__ZONE_FAMILY))) == prepare_zones__FAMILY_ARC)
        {
            left = prepare_placement__turn_arc(zones, row, angle, y_shift, z_shift);
        }
        else
        {
            left = prepare_placement__turn_polynomial(zones, row, angle, y_shift, z_shift);
        }
        kept += left;
    }
    (*cspan_at(&zones, base + prepare_zones__DEFINITION_COUNT)) = (double)(kept);
    return kept;
}

/* Keep the unbroken run of zones that holds y = 0; how many that are. */
static inline int64_t prepare_placement__keep_around_top(array_double_1d zones, int64_t base)
{
    int64_t size;
    int64_t count;
    int64_t first;
    int64_t found;
    int64_t row;
    int64_t last;
    int64_t k;
    int64_t kept;
    size = (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_ROW)));
    count = (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_COUNT)));
    first = INT64_C(0);
    found = INT64_C(0);
    while((found == INT64_C(0)) && (first < count))
    {
        row = base + prepare_zones__DEFINITION_ZONES + first * size;
        if (((*cspan_at(&zones, row + prepare_zones__ZONE_START)) <= 0.0) && (0.0 <= (*cspan_at(&zones, row + prepare_zones__ZONE_STOP))))
        {
            found = INT64_C(1);
        }
        else
        {
            first += INT64_C(1);
        }
    }
    last = first;
    while((found == INT64_C(1)) && (first > INT64_C(0)) && (prepare_placement__meets_next(zones, base + prepare_zones__DEFINITION_ZONES + (first - INT64_C(1)) * size, size) == INT64_C(1)))
    {
        first -= INT64_C(1);
    }
    while((found == INT64_C(1)) && (last + INT64_C(1) < count) && (prepare_placement__meets_next(zones, base + prepare_zones__DEFINITION_ZONES + last * size, size) == INT64_C(1)))
    {
        last += INT64_C(1);
    }
    kept = INT64_C(0);
    if (found == INT64_C(1))
    {
        kept = last + INT64_C(1) - first;
    }
    for (k = INT64_C(0); k < kept * size; k += INT64_C(1))
    {
        (*cspan_at(&zones, base + prepare_zones__DEFINITION_ZONES + k)) = (*cspan_at(&zones, base + prepare_zones__DEFINITION_ZONES + first * size + k));
    }
    (*cspan_at(&zones, base + prepare_zones__DEFINITION_COUNT)) = (double)(kept);
    return kept;
}

/* 1 if the zone ends where the one after it starts, else 0. */
static inline int64_t prepare_placement__meets_next(array_double_1d zones, int64_t row, int64_t size)
{
    int64_t met;
    met = INT64_C(0);
    if (fabs((*cspan_at(&zones, row + prepare_zones__ZONE_STOP)) - (*cspan_at(&zones, row + size + prepare_zones__ZONE_START))) < prepare_placement__MEETING)
    {
        met = INT64_C(1);
    }
    return met;
}
