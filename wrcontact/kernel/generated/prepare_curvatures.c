/* Generated from prepare/curvatures.py by tools/transpile_kernel.py; change that one.
 *
 * Lateral curvature of a profile all along it, as the source takes it.
 *
 * Curvatures here are d(angle)/d(arc length) with z down, positive where the profile is hollow upwards; the
 * table has them positive where the profile bulges towards the other body, which is this sign on a rail and the
 * other one on a wheel. The table is the record CurvatureTable.
 */

#include "prepare_curvatures.h"

/* Curvature of the circle c (u^2 + v^2) + b u + a = v from its normal equations, by
 * symmetric elimination.
 *
 * Many arguments because these are the nine different numbers of three symmetric equations.
 */
static inline double prepare_curvatures__circle_curvature(double n00, double n01, double n02, double n11, double n12, double n22, double r0, double r1, double r2)
{
    double l01;
    double l02;
    double m11;
    double m12;
    double s1;
    double l12;
    double c;
    double b;
    double a;
    l01 = n01 / n00;
    l02 = n02 / n00;
    m11 = n11 - l01 * n01;
    m12 = n12 - l01 * n02;
    s1 = r1 - l01 * r0;
    l12 = m12 / m11;
    c = (r2 - l02 * r0 - l12 * s1) / (n22 - l02 * n02 - l12 * m12);
    b = (s1 - m12 * c) / m11;
    a = (r0 - n01 * b - n02 * c) / n00;
    return 2.0 * c / sqrt(1.0 + b * b - 4.0 * a * c);
}

/* Curvature [1/m] of the circle fitted to the profile over y - reach ... y + reach, at ``y`` [m]. */
static inline double prepare_curvatures__fitted_curvature(array_double_1d tables, int64_t profile, double y, double reach)
{
    double low;
    double high;
    double z_0;
    double slope;
    double cosine;
    double sine;
    double n00;
    double n01;
    double n02;
    double n11;
    double n12;
    double n22;
    double r0;
    double r1;
    double r2;
    int64_t k;
    double at;
    double z;
    double across;
    double down;
    double u;
    double v;
    double w;
    low = double_max(2, y - reach, (*cspan_at(&tables, profile + layout__PROFILE_START)));
    high = double_min(2, y + reach, (*cspan_at(&tables, profile + layout__PROFILE_STOP)));
    profile_table__height_slope(&z_0, &slope, tables, profile, y);
    cosine = 1.0 / sqrt(1.0 + slope * slope);
    sine = slope * cosine;
    n00 = 0.0;
    n01 = 0.0;
    n02 = 0.0;
    n11 = 0.0;
    n12 = 0.0;
    n22 = 0.0;
    r0 = 0.0;
    r1 = 0.0;
    r2 = 0.0;
    for (k = INT64_C(0); k < prepare_curvatures__SAMPLES; k += INT64_C(1))
    {
        at = low + (high - low) * ((double)(k) / (double)(prepare_curvatures__SAMPLES - INT64_C(1)));
        profile_table__height_slope(&z, &slope, tables, profile, at);
        across = at - y;
        down = z - z_0;
        u = (across * cosine + down * sine) / reach;
        v = (down * cosine - across * sine) / reach;
        w = u * u + v * v;
        n00 += 1.0;
        n01 += u;
        n02 += w;
        n11 += u * u;
        n12 += u * w;
        n22 += w * w;
        r0 += v;
        r1 += u * v;
        r2 += w * v;
    }
    return prepare_curvatures__circle_curvature(n00, n01, n02, n11, n12, n22, r0, r1, r2) / reach;
}

/* Nodes and weights of Gauss's formula into scratch. */
static inline int64_t prepare_curvatures__write_gauss(array_double_1d work, int64_t scratch)
{
    (*cspan_at(&work, scratch + INT64_C(0))) = -0.9739065285171717;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(0))) = 0.06667134430868814;
    (*cspan_at(&work, scratch + INT64_C(1))) = -0.8650633666889845;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(1))) = 0.1494513491505804;
    (*cspan_at(&work, scratch + INT64_C(2))) = -0.6794095682990244;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(2))) = 0.219086362515982;
    (*cspan_at(&work, scratch + INT64_C(3))) = -0.4333953941292472;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(3))) = 0.2692667193099965;
    (*cspan_at(&work, scratch + INT64_C(4))) = -0.14887433898163122;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(4))) = 0.2955242247147528;
    (*cspan_at(&work, scratch + INT64_C(5))) = 0.14887433898163122;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(5))) = 0.2955242247147528;
    (*cspan_at(&work, scratch + INT64_C(6))) = 0.4333953941292472;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(6))) = 0.2692667193099965;
    (*cspan_at(&work, scratch + INT64_C(7))) = 0.6794095682990244;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(7))) = 0.219086362515982;
    (*cspan_at(&work, scratch + INT64_C(8))) = 0.8650633666889845;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(8))) = 0.1494513491505804;
    (*cspan_at(&work, scratch + INT64_C(9))) = 0.9739065285171717;
    (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + INT64_C(9))) = 0.06667134430868814;
    return INT64_C(0);
}

/* Arc length [m] from ``low`` to ``high`` [m], which lie in one piece. */
static inline double prepare_curvatures__arc_panel(array_double_1d tables, int64_t profile, double low, double high, array_double_1d work, int64_t scratch)
{
    double half;
    double total;
    int64_t k;
    double z;
    double slope;
    half = 0.5 * (high - low);
    total = 0.0;
    for (k = INT64_C(0); k < prepare_curvatures__GAUSS_POINTS; k += INT64_C(1))
    {
        profile_table__height_slope(&z, &slope, tables, profile, 0.5 * (low + high) + half * (*cspan_at(&work, scratch + k)));
        total += sqrt(1.0 + slope * slope) * (*cspan_at(&work, scratch + prepare_curvatures__GAUSS_POINTS + k));
    }
    return half * total;
}

/* Gauss's formula and the arc length at the start of each piece and at the end of all into
 * scratch; the end's [m].
 */
static inline double prepare_curvatures__write_lengths(array_double_1d tables, int64_t profile, array_double_1d work, int64_t scratch)
{
    int64_t first;
    int64_t lengths;
    int64_t i;
    int64_t at;
    double total;
    prepare_curvatures__write_gauss(work, scratch);
    total = 0.0;
    first = prepare_scan__first_piece(tables, profile);
    lengths = scratch + INT64_C(2) * prepare_curvatures__GAUSS_POINTS;
    (*cspan_at(&work, lengths)) = 0.0;
    for (i = INT64_C(0); i < prepare_scan__piece_count(tables, profile); i += INT64_C(1))
    {
        at = first + layout__PIECE_SIZE * i;
        total += prepare_curvatures__arc_panel(tables, profile, (*cspan_at(&tables, at)), (*cspan_at(&tables, at)) + prepare_scan__piece_width(tables, profile, at), work, scratch);
        (*cspan_at(&work, lengths + i + INT64_C(1))) = total;
    }
    return total;
}

/* Arc length [m] at ``y`` [m]. */
static inline double prepare_curvatures__arc_length(array_double_1d tables, int64_t profile, double y, array_double_1d work, int64_t scratch)
{
    int64_t first;
    int64_t low;
    int64_t high;
    int64_t middle;
    double result;
    first = prepare_scan__first_piece(tables, profile);
    low = INT64_C(0);
    high = prepare_scan__piece_count(tables, profile);
    while(high - low > INT64_C(1))
    {
        middle = py_floor_div_int64_t((low + high), INT64_C(2));
        if ((*cspan_at(&tables, first + layout__PIECE_SIZE * middle)) <= y)
        {
            low = middle;
        }
        else
        {
            high = middle;
        }
    }
    result = (*cspan_at(&work, scratch + INT64_C(2) * prepare_curvatures__GAUSS_POINTS + low)) + prepare_curvatures__arc_panel(tables, profile, (*cspan_at(&tables, first + layout__PIECE_SIZE * low)), y, work, scratch);
    return result;
}

/* Abscissa [m] at arc length ``length`` [m]: Newton's method within the piece that holds it. */
static inline double prepare_curvatures__place_at_length(array_double_1d tables, int64_t profile, double length, array_double_1d work, int64_t scratch)
{
    int64_t lengths;
    int64_t piece;
    int64_t end;
    int64_t middle;
    int64_t at;
    double low;
    double high;
    double share;
    int64_t i;
    double before;
    double missing;
    double z;
    double slope;
    double y;
    lengths = scratch + INT64_C(2) * prepare_curvatures__GAUSS_POINTS;
    piece = INT64_C(0);
    end = prepare_scan__piece_count(tables, profile);
    while(end - piece > INT64_C(1))
    {
        middle = py_floor_div_int64_t((piece + end), INT64_C(2));
        if ((*cspan_at(&work, lengths + middle)) <= length)
        {
            piece = middle;
        }
        else
        {
            end = middle;
        }
    }
    at = prepare_scan__first_piece(tables, profile) + layout__PIECE_SIZE * piece;
    low = (*cspan_at(&tables, at));
    high = low + prepare_scan__piece_width(tables, profile, at);
    share = (length - (*cspan_at(&work, lengths + piece))) / ((*cspan_at(&work, lengths + piece + INT64_C(1))) - (*cspan_at(&work, lengths + piece)));
    y = low + share * (high - low);
    i = INT64_C(0);
    while(i < prepare_curvatures__ARC_ITERATIONS)
    {
        before = y;
        missing = length - (*cspan_at(&work, lengths + piece)) - prepare_curvatures__arc_panel(tables, profile, low, y, work, scratch);
        profile_table__height_slope(&z, &slope, tables, profile, y);
        y = double_min(2, double_max(2, y + missing / sqrt(1.0 + slope * slope), low), high);
        i += INT64_C(1);
        if (fabs(y - before) <= prepare_curvatures__ARC_SHARP)
        {
            i = prepare_curvatures__ARC_ITERATIONS;
        }
    }
    return y;
}

/* Change of the profile's angle per arc length [1/m] from chord to chord between nodes ``step`` [m]
 * before ``y`` [m], at it and after it; ``total`` is the whole arc length [m].
 */
static inline double prepare_curvatures__turned_curvature(array_double_1d tables, int64_t profile, double y, double step, double total, array_double_1d work, int64_t scratch)
{
    double middle;
    double y_0;
    double y_1;
    double y_2;
    double z_0;
    double slope;
    double z_1;
    double z_2;
    step = double_min(2, step, 0.5 * total);
    middle = double_min(2, double_max(2, prepare_curvatures__arc_length(tables, profile, y, work, scratch), step), total - step);
    y_0 = prepare_curvatures__place_at_length(tables, profile, middle - step, work, scratch);
    y_1 = prepare_curvatures__place_at_length(tables, profile, middle, work, scratch);
    y_2 = prepare_curvatures__place_at_length(tables, profile, middle + step, work, scratch);
    profile_table__height_slope(&z_0, &slope, tables, profile, y_0);
    profile_table__height_slope(&z_1, &slope, tables, profile, y_1);
    profile_table__height_slope(&z_2, &slope, tables, profile, y_2);
    return (atan2(z_2 - z_1, y_2 - y_1) - atan2(z_1 - z_0, y_1 - y_0)) / step;
}

/* What the chosen lateral curvature reads of a profile, at ``base``; the offset after it, or FULL. */
static inline int64_t prepare_curvatures__write_curvatures(array_double_1d tables, int64_t base, int64_t profile, double sign, array_double_1d work, int64_t scratch)
{
    int64_t kind;
    double step;
    double reach;
    double scale;
    double start;
    double stop;
    int64_t count;
    int64_t table;
    int64_t first;
    double total;
    double distance;
    int64_t i;
    double y;
    double curvature;
    kind = (int64_t)((*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_LATERAL_CURVATURE)));
    step = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_CURVATURE_STEP));
    reach = (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_CURVATURE_REACH));
    if ((kind != layout__LATERAL_SMOOTH) && (kind != layout__LATERAL_ROUGH))
    {
        return base;
    }
    scale = step;
    if (kind == layout__LATERAL_SMOOTH)
    {
        scale = reach;
    }
    start = (*cspan_at(&tables, profile + layout__PROFILE_START));
    stop = (*cspan_at(&tables, profile + layout__PROFILE_STOP));
    count = (int64_t)((int64_t)ceil((stop - start) / double_min(2, double_max(2, prepare_curvatures__RASTER_SHARE * scale, prepare_curvatures__FINEST), prepare_curvatures__COARSEST))) + INT64_C(1);
    table = base;
    first = table + layout__CURVATURE_TABLE_CURVATURES;
    if (first + count > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    (*cspan_at(&tables, table + layout__CURVATURE_TABLE_COUNT)) = (double)(count);
    (*cspan_at(&tables, table + layout__CURVATURE_TABLE_START)) = start;
    (*cspan_at(&tables, table + layout__CURVATURE_TABLE_PER_METRE)) = (double)(count - INT64_C(1)) / (stop - start);
    total = 0.0;
    if (kind == layout__LATERAL_ROUGH)
    {
        total = prepare_curvatures__write_lengths(tables, profile, work, scratch);
    }
    distance = (stop - start) / (double)(count - INT64_C(1));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        y = (double)(i) * distance + start;
        if (i + INT64_C(1) == count)
        {
            y = stop;
        }
        curvature = 0.0;
        if (kind == layout__LATERAL_SMOOTH)
        {
            curvature = prepare_curvatures__fitted_curvature(tables, profile, y, reach);
        }
        else
        {
            curvature = prepare_curvatures__turned_curvature(tables, profile, y, step, total, work, scratch);
        }
        (*cspan_at(&tables, table + layout__CURVATURE_TABLE_CURVATURES + i)) = sign * curvature;
    }
    return first + count;
}
