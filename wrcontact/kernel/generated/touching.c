/* Generated from contact/touching.py by tools/transpile_kernel.py; change that one.
 *
 * Pairs of points of wheel and rail with a common normal, found in two ways for two purposes.
 *
 * touching_pair   by Newton's method for both abscissae at once, from a good estimate: where a wheel that
 *                 overlaps its rail a little, or is above it, would touch. Wheel and rail have to be bent
 *                 towards each other.
 * turning_point   by a bracket on the rail, with Newton's method inside it: where the overlap of a pressed wheel
 *                 is largest, or smallest between two largest ones. It finds one also where curvatures jump.
 *
 * An elastic contact is a rigid one that has been pressed: the wheel is ``depth`` deeper than where it just
 * touches. In a pair the outline and the rail have one slope m and the line between both points is normal to
 * them,
 *
 *     m_wheel(y) = m_rail(x),   X - x + (Z - z_rail(x)) m = 0,
 *     depth = (Z - z_rail - m (X - x)) / sqrt(1 + m^2)
 *
 * with (X, Z) the wheel's point at abscissa y in its present pose. Without overlap it is the point of the
 * smallest vertical gap.
 */

#include "touching.h"

/* ``step``, no longer than ``limit`` either way. */
static OUT_OF_LINE double touching__limited(double step, double limit)
{
    if (step > limit)
    {
        step = limit;
    }
    if (step < -limit)
    {
        step = -limit;
    }
    return step;
}

/* Wheel and rail abscissa [m] of the pair near ``y`` and ``abscissa`` for the wheel placed at ``place``
 * and moved down by ``shift`` [m]; its depth [m], negative where they are apart; the lateral and vertical
 * shift [m] that let it touch; and 1 if there is such a pair, else 0.
 */
static OUT_OF_LINE int64_t touching__touching_pair(double* result_0_0001, double* result_1_0001, double* result_2, double* result_3_0001, double* result_4_0001, int64_t* result_5_0001, array_double_1d work, array_double_1d tables, int64_t place, double y, double abscissa, double shift)
{
    int64_t rail;
    int64_t wheel;
    double start_y;
    double start_x;
    int64_t i;
    double z;
    double slope;
    double bend;
    double y_track;
    double z_track;
    double outline_slope;
    double stretch;
    double rate;
    double height;
    double m;
    double rail_bend;
    double across;
    double down;
    double mismatch;
    double apart;
    double along;
    double back;
    double determinant;
    double move_y;
    double move_x;
    double depth;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    wheel = (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL)));
    start_y = y;
    start_x = abscissa;
    for (i = INT64_C(0); i < touching__PAIR_ITERATIONS; i += INT64_C(1))
    {
        profile_table__height_slope_bend(&z, &slope, &bend, tables, wheel, y);
        locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &rate, work, place, y, z, slope, bend);
        profile_table__height_slope_bend(&height, &m, &rail_bend, tables, rail, abscissa);
        across = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa;
        down = z_track + shift - height;
        mismatch = outline_slope - m;
        apart = across + down * m;
        along = stretch * (1.0 + outline_slope * m);
        back = down * rail_bend - 1.0 - m * m;
        determinant = rate * back + rail_bend * along;
        if (!(determinant > touching__PAIR_BEND * (fabs(rate * back) + fabs(rail_bend * along))))
        {
            (*result_0_0001) = y;
            (*result_1_0001) = abscissa;
            (*result_2) = 0.0;
            (*result_3_0001) = 0.0;
            (*result_4_0001) = 0.0;
            (*result_5_0001) = INT64_C(0);
            return 0;
        }
        move_y = (-(mismatch * back + rail_bend * apart)) / determinant;
        move_x = (-(rate * apart - along * mismatch)) / determinant;
        if ((fabs(move_y) < touching__PAIR_SHARP) && (fabs(move_x) < touching__PAIR_SHARP))
        {
            depth = (down - m * across) / sqrt(1.0 + m * m);
            (*result_0_0001) = y;
            (*result_1_0001) = abscissa;
            (*result_2) = depth;
            (*result_3_0001) = -across;
            (*result_4_0001) = shift - down;
            (*result_5_0001) = INT64_C(1);
            return 0;
        }
        y += touching__limited(move_y, touching__PAIR_STEP);
        abscissa += touching__limited(move_x, touching__PAIR_STEP);
        if ((fabs(y - start_y) > touching__PAIR_REACH) || (fabs(abscissa - start_x) > touching__PAIR_REACH))
        {
            (*result_0_0001) = y;
            (*result_1_0001) = abscissa;
            (*result_2) = 0.0;
            (*result_3_0001) = 0.0;
            (*result_4_0001) = 0.0;
            (*result_5_0001) = INT64_C(0);
            return 0;
        }
        if (!((y > (*cspan_at(&tables, wheel + layout__PROFILE_START))) && (y < (*cspan_at(&tables, wheel + layout__PROFILE_STOP)))))
        {
            (*result_0_0001) = y;
            (*result_1_0001) = abscissa;
            (*result_2) = 0.0;
            (*result_3_0001) = 0.0;
            (*result_4_0001) = 0.0;
            (*result_5_0001) = INT64_C(0);
            return 0;
        }
        if (!((abscissa > (*cspan_at(&tables, rail + layout__PROFILE_START))) && (abscissa < (*cspan_at(&tables, rail + layout__PROFILE_STOP)))))
        {
            (*result_0_0001) = y;
            (*result_1_0001) = abscissa;
            (*result_2) = 0.0;
            (*result_3_0001) = 0.0;
            (*result_4_0001) = 0.0;
            (*result_5_0001) = INT64_C(0);
            return 0;
        }
    }
    (*result_0_0001) = y;
    (*result_1_0001) = abscissa;
    (*result_2) = 0.0;
    (*result_3_0001) = 0.0;
    (*result_4_0001) = 0.0;
    (*result_5_0001) = INT64_C(0);
    return 0;
}

/* Rail and wheel abscissa [m] of the largest overlap (``sign`` = 1) or the smallest (-1) between two rail
 * abscissae, and the overlap [m]: Newton's method on its slope, bracketed, from the middle on.  Fourth
 * value: 1 if the slope changes its sign there, else 0.
 *
 * The bend leaves out a factor (:mod:`pressed`); between nearly conformal profiles under a deep overlap
 * Newton's method can then alternate between two places.  Where a step has not halved the slope, the bracket
 * is halved.
 */
static OUT_OF_LINE int64_t touching__turning_point(double* result_0, double* result_1_0001, double* result_2, int64_t* result_3, array_double_1d work, array_double_1d tables, int64_t place, double low, double high, double y, double height, double sign)
{
    double x;
    double overlap;
    double rise;
    double before;
    int64_t i;
    double bend;
    double curvature;
    int64_t found;
    double following;
    double z_rail;
    double slope;
    double newton;
    int64_t turned;
    x = 0.5 * (low + high);
    overlap = 0.0;
    rise = 1.0;
    before = 0.0;
    for (i = INT64_C(0); i < touching__DEEP_ITERATIONS; i += INT64_C(1))
    {
        pressed__normal_line(&y, &overlap, &rise, &bend, &curvature, &found, work, tables, place, x, y, height, pressed__LINE_SHARP);
        if (found == INT64_C(0))
        {
            (*result_0) = x;
            (*result_1_0001) = y;
            (*result_2) = overlap;
            (*result_3) = INT64_C(0);
            return 0;
        }
        if (sign * rise > 0.0)
        {
            low = x;
        }
        else
        {
            high = x;
        }
        following = 0.5 * (low + high);
        if ((sign * bend < 0.0) && ((i == INT64_C(0)) || (fabs(rise) < 0.5 * before)))
        {
            profile_table__height_slope(&z_rail, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), x);
            newton = x - rise / (bend * sqrt(1.0 + slope * slope));
            if ((newton > low) && (newton < high))
            {
                following = newton;
            }
        }
        if (fabs(following - x) < touching__DEEP_SHARP)
        {
            break;
        }
        x = following;
        before = fabs(rise);
    }
    turned = INT64_C(0);
    if (fabs(rise) < touching__LEVEL_RISE)
    {
        turned = INT64_C(1);
    }
    (*result_0) = x;
    (*result_1_0001) = y;
    (*result_2) = overlap;
    (*result_3) = turned;
    return 0;
}
