/* Generated from prepare/zones.py by tools/transpile_kernel.py; change that one.
 *
 * The zones that a profile is defined with, as numbers: polynomials and circular arcs,
 * upright or turned; in millimetres.
 *
 * A definition is one array: how many zones, the length of their rows, then the rows.
 * wrcontact/profiles/zones.py has the same zones as objects, and
 * wrcontact/profiles/definition.py turns one into the other.
 */

#include "prepare_zones.h"

/* Height [mm], slope and second derivative [1/mm] of an upright polynomial at ``t`` [mm],
 * each by Horner's scheme.
 */
static inline int64_t prepare_zones__polynomial_jet(double* z, double* slope, double* bend, array_double_1d zones, int64_t row, double t)
{
    double u;
    int64_t terms;
    int64_t i;
    int64_t k;
    double c;
    u = t - (*cspan_at(&zones, row + prepare_zones__ZONE_ORIGIN));
    (*z) = 0.0;
    (*slope) = 0.0;
    (*bend) = 0.0;
    terms = (int64_t)((*cspan_at(&zones, row + prepare_zones__ZONE_TERMS)));
    for (i = INT64_C(0); i < terms; i += INT64_C(1))
    {
        k = terms - INT64_C(1) - i;
        c = (*cspan_at(&zones, row + prepare_zones__ZONE_COEFFICIENTS + k));
        (*z) = (*z) * u + c;
        if (k > INT64_C(0))
        {
            (*slope) = (*slope) * u + c * (double)(k);
        }
        if (k > INT64_C(1))
        {
            (*bend) = (*bend) * u + c * (double)(k) * (double)(k - INT64_C(1));
        }
    }
    return 0;
}

/* The same of an arc at ``y`` [mm]. */
static inline int64_t prepare_zones__arc_jet(double* z, double* result_1, double* result_2, array_double_1d zones, int64_t row, double y)
{
    double u;
    double radius;
    double side;
    double root;
    u = y - (*cspan_at(&zones, row + prepare_zones__ZONE_ORIGIN));
    radius = (*cspan_at(&zones, row + prepare_zones__ZONE_RADIUS));
    side = (*cspan_at(&zones, row + prepare_zones__ZONE_SIDE));
    root = sqrt(double_max(2, radius * radius - u * u, 0.0));
    (*z) = (*cspan_at(&zones, row + prepare_zones__ZONE_Z_CENTRE)) + side * root;
    if (root < prepare_zones__VERTICAL)
    {
        root = prepare_zones__VERTICAL;
    }
    (*result_1) = (-side) * u / root;
    (*result_2) = (-side) * (radius * radius) / (root * root * root);
    return 0;
}

/* The same of a zone before it is turned. */
static inline int64_t prepare_zones__upright_jet(double* z, double* slope, double* bend, array_double_1d zones, int64_t row, double t)
{
    (*z) = 0.0;
    (*slope) = 0.0;
    (*bend) = 0.0;
    if ((int64_t)((*cspan_at(&zones, row + prepare_zones__ZONE_FAMILY))) == prepare_zones__FAMILY_ARC)
    {
        prepare_zones__arc_jet(z, slope, bend, zones, row, t);
    }
    else
    {
        prepare_zones__polynomial_jet(z, slope, bend, zones, row, t);
    }
    return 0;
}

/* Point (y, z) [mm] at ``t`` of a zone that is turned about the origin. */
static inline int64_t prepare_zones__turned_point(double* result_0, double* result_1, array_double_1d zones, int64_t row, double t, double cosine, double sine)
{
    double z;
    double slope;
    double bend;
    prepare_zones__upright_jet(&z, &slope, &bend, zones, row, t);
    (*result_0) = cosine * t - sine * z;
    (*result_1) = sine * t + cosine * z;
    return 0;
}

/* ``x``, or the end that it lies beyond. */
static inline double prepare_zones__within(double x, double low, double high)
{
    return double_min(2, double_max(2, x, low), high);
}

/* Height, slope and second derivative of a turned polynomial at its own abscissa ``y``
 * [mm], by Newton's method.
 */
static inline int64_t prepare_zones__turned_jet(double* result_0, double* result_1, double* result_2, array_double_1d zones, int64_t row, double y)
{
    double c;
    double s;
    double first;
    double last;
    double along;
    double t;
    int64_t i;
    double z;
    double slope;
    double bend;
    double newton;
    double stretch;
    c = (*cspan_at(&zones, row + prepare_zones__ZONE_COS));
    s = (*cspan_at(&zones, row + prepare_zones__ZONE_SIN));
    first = (*cspan_at(&zones, row + prepare_zones__ZONE_FIRST));
    last = (*cspan_at(&zones, row + prepare_zones__ZONE_LAST));
    along = y - (*cspan_at(&zones, row + prepare_zones__ZONE_Y_SHIFT));
    t = prepare_zones__within(c * along, first, last);
    i = INT64_C(0);
    while(i < prepare_zones__TURNED_ITERATIONS)
    {
        prepare_zones__polynomial_jet(&z, &slope, &bend, zones, row, t);
        newton = (c * t - s * z - along) / (c - s * slope);
        t = prepare_zones__within(t - newton, first, last);
        i += INT64_C(1);
        if (fabs(newton) <= prepare_zones__TURNED_SHARP * (1.0 + fabs(along)))
        {
            i = prepare_zones__TURNED_ITERATIONS;
        }
    }
    prepare_zones__polynomial_jet(&z, &slope, &bend, zones, row, t);
    stretch = c - s * slope;
    (*result_0) = s * t + c * z + (*cspan_at(&zones, row + prepare_zones__ZONE_Z_SHIFT));
    (*result_1) = (s + c * slope) / stretch;
    (*result_2) = bend / (stretch * stretch * stretch);
    return 0;
}

/* Height [mm], slope and second derivative [1/mm] of any zone at ``y`` [mm]. */
static inline int64_t prepare_zones__zone_jet(double* z, double* slope, double* bend, array_double_1d zones, int64_t row, double y)
{
    (*z) = 0.0;
    (*slope) = 0.0;
    (*bend) = 0.0;
    if ((*cspan_at(&zones, row + prepare_zones__ZONE_TURNED)) == 1.0)
    {
        prepare_zones__turned_jet(z, slope, bend, zones, row, y);
    }
    else
    {
        prepare_zones__upright_jet(z, slope, bend, zones, row, y);
    }
    return 0;
}
