/* Generated from patch/quadrature.py by tools/transpile_kernel.py; change that one.
 *
 * Integrals over the cells between the strips of a patch.
 *
 * A cell has a value at its inner end, one at its outer end, and the value one cell further in.  Between its
 * ends the quadratic through the three is taken, with a limited bend (:func:`bend_of`), so that an ellipse is
 * integrated exactly.  A place in a cell is its share of the cell, counted from the inner end.
 */

#include "quadrature.h"

/* Second coefficient of the quadratic through (-1, before), (0, low), (1, high), limited to half of |low|
 * + |high|.
 *
 * Unlimited it is exact for a parabola; the limit keeps it positive between positive values where the data
 * has kinks.
 */
static inline double quadrature__bend_of(double before, double low, double high)
{
    double limit;
    double bend;
    bend = 0.5 * (before - 2.0 * low + high);
    limit = 0.5 * (fabs(low) + fabs(high));
    if (bend > limit)
    {
        bend = limit;
    }
    if (bend < -limit)
    {
        bend = -limit;
    }
    return bend;
}

/* The quadratic of ``bend_of`` at x. */
static inline double quadrature__quadratic_value(double before, double low, double high, double x)
{
    double bend;
    bend = quadrature__bend_of(before, low, high);
    return low + x * (high - low - bend + x * bend);
}

/* The loaded part [from, to] of a cell, as shares of it counted from its inner node. */
static inline int64_t quadrature__cell_part(double* start, double* stop, double d_before, double d_low, double d_high)
{
    double bend;
    double slope;
    double spread;
    double root;
    (*start) = 0.0;
    (*stop) = 1.0;
    if ((d_low <= 0.0) && (d_high <= 0.0))
    {
        (*stop) = 0.0;
    }
    else if ((d_low <= 0.0) || (d_high <= 0.0))
    {
        bend = quadrature__bend_of(d_before, d_low, d_high);
        slope = d_high - d_low - bend;
        /* the root between two values of opposite sign, in the form that does not cancel */
        spread = slope * slope - 4.0 * bend * d_low;
        if (spread < 0.0)
        {
            spread = 0.0;
        }
        spread = sqrt(spread);
        root = 0.0;
        if (d_low > 0.0)
        {
            root = 2.0 * d_low / (spread - slope);
            (*stop) = root;
        }
        else
        {
            root = (-2.0) * d_low / (spread + slope);
            (*start) = root;
        }
    }
    return 0;
}

/* Integral over [0, stop] of the quadratic of ``bend_of``. */
static inline double quadrature__quadratic_integral(double before, double low, double high, double stop)
{
    double bend;
    double slope;
    bend = quadrature__bend_of(before, low, high);
    slope = high - low - bend;
    return stop * (low + stop * (slope / 2.0 + stop * bend / 3.0));
}

/* Integral over [0, stop] of x times the quadratic of ``bend_of``. */
static inline double quadrature__quadratic_moment(double before, double low, double high, double stop)
{
    double bend;
    double slope;
    bend = quadrature__bend_of(before, low, high);
    slope = high - low - bend;
    return stop * stop * (low / 2.0 + stop * (slope / 3.0 + stop * bend / 4.0));
}

/* Integral over [start, stop] of the square root of the quadratic of ``bend_of``, which is not negative
 * there.
 *
 * In closed form where the quadratic bends down noticeably.  Otherwise with the roots p, q of the end values
 * and the width w, expanded about the chord: w [2/3 (p^2 + p q + q^2)/(p + q) - 2/15 bend w^2 (p^2 + 3 p q +
 * q^2)/(p + q)^3].
 */
static inline double quadrature__root_integral(double before, double low, double high, double start, double stop)
{
    double bend;
    double slope;
    double first;
    double last;
    double p;
    double q;
    double total;
    double width;
    double chord;
    double cube;
    bend = quadrature__bend_of(before, low, high);
    slope = high - low - bend;
    if (bend < (-quadrature__STRAIGHT) * (fabs(low) + fabs(high)))
    {
        return quadrature__bent_integral(low, slope, bend, start, stop);
    }
    first = quadrature__quadratic_at(low, slope, bend, start);
    last = quadrature__quadratic_at(low, slope, bend, stop);
    p = sqrt(first);
    q = sqrt(last);
    total = p + q;
    if (!(total > 0.0))
    {
        return 0.0;
    }
    width = stop - start;
    chord = 2.0 / 3.0 * (first + p * q + last) / total;
    cube = total * total * total;
    return width * (chord - 2.0 / 15.0 * bend * width * width * (first + 3.0 * p * q + last) / cube);
}

/* low + slope x + bend x^2, and 0 where rounding makes it negative. */
static inline double quadrature__quadratic_at(double low, double slope, double bend, double x)
{
    double value;
    value = low + x * (slope + x * bend);
    if (value < 0.0)
    {
        value = 0.0;
    }
    return value;
}

/* Integral over [start, stop] of sqrt(low + slope x + bend x^2) for bend < 0, in closed form.
 *
 * The angle between both ends is taken from the roots themselves, not from how far x has come: at the end of
 * a loaded stretch the rounding of root and angle then cancels.
 */
static inline double quadrature__bent_integral(double low, double slope, double bend, double start, double stop)
{
    double first;
    double last;
    double spread;
    double first_root;
    double last_root;
    double first_rate;
    double last_rate;
    double across;
    double height;
    double height_before;
    double angle;
    first = quadrature__quadratic_at(low, slope, bend, start);
    last = quadrature__quadratic_at(low, slope, bend, stop);
    spread = slope * slope - 4.0 * bend * low;
    if (!(spread > 0.0))
    {
        return 0.0;
    }
    first_root = sqrt(first);
    last_root = sqrt(last);
    first_rate = 2.0 * bend * start + slope;
    last_rate = 2.0 * bend * stop + slope;
    across = sqrt(-bend);
    height = 2.0 * across * last_root;
    height_before = 2.0 * across * first_root;
    angle = atan2(height * first_rate - height_before * last_rate, height * height_before + last_rate * first_rate);
    return (last_rate * last_root - first_rate * first_root) / (4.0 * bend) + spread / (8.0 * (-bend) * across) * angle;
}
