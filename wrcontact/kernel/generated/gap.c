/* Generated from surface/gap.py by tools/transpile_kernel.py; change that one.
 *
 * The vertical gap between a placed right wheel and its rail, along the contact locus.
 *
 * gap(y) = z_rail(Y(y)) - Z(y), with the outline (Y, Z) of :mod:`locus`; positive where the wheel is above the
 * rail.  The wheelset stands at vertical shift zero, so contact lies at the smallest gap and the vertical shift
 * is that gap.
 */

#include "gap.h"

/* 1 if the rail profile has a height at ``abscissa`` [m], else 0. */
static inline int64_t gap__above_rail(array_double_1d tables, double abscissa)
{
    int64_t rail;
    int64_t inside;
    rail = (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL)));
    inside = INT64_C(0);
    if ((abscissa >= (*cspan_at(&tables, rail + layout__PROFILE_START))) && (abscissa <= (*cspan_at(&tables, rail + layout__PROFILE_STOP))))
    {
        inside = INT64_C(1);
    }
    return inside;
}

/* Gap [m], slope difference rail - outline [-] and its derivative along the wheel profile [1/m] at ``y``
 * [m].
 *
 * Where a strongly yawed flange root folds the outline back, a point is on the wheel but no place of
 * contact: its slope difference reads FOLDED.
 */
static inline int64_t gap__vertical_gap(double* result_0, double* mismatch, double* result_2, array_double_1d work, array_double_1d tables, int64_t place, double y)
{
    double z;
    double slope;
    double bend;
    double y_track;
    double z_track;
    double outline_slope;
    double stretch;
    double outline_rate;
    double z_rail;
    double rail_slope;
    double rail_bend;
    profile_table__height_slope_bend(&z, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &outline_rate, work, place, y, z, slope, bend);
    profile_table__height_slope_bend(&z_rail, &rail_slope, &rail_bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)));
    (*mismatch) = rail_slope - outline_slope;
    if (!(stretch > 0.0))
    {
        (*mismatch) = gap__FOLDED;
    }
    (*result_0) = z_rail - z_track;
    (*result_2) = rail_bend * stretch - outline_rate;
    return 0;
}

/* Derivative of the smallest gap with respect to roll [m], at its place ``y`` [m].
 *
 * At a minimum the place does not count (envelope theorem): it is the partial derivative at a fixed wheel
 * point, z'_rail dY/droll - dZ/droll, with dY/droll = -cos(yaw) (arm sin(roll) + r cos(phi) cos(roll)) and
 * dZ/droll = arm cos(roll) - r cos(phi) sin(roll).
 */
static inline double gap__gap_per_roll(array_double_1d work, array_double_1d tables, int64_t place, double y)
{
    double z;
    double slope;
    double y_track;
    double z_track;
    double outline_slope;
    double z_rail;
    double rail_slope;
    double sin_phi;
    double cos_phi;
    double arm;
    double height;
    double sin_roll;
    double cos_roll;
    double lateral;
    double vertical;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_point(&y_track, &z_track, &outline_slope, work, place, y, z, slope);
    profile_table__height_slope(&z_rail, &rail_slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)));
    locus__around_wheel(&sin_phi, &cos_phi, work, place, slope);
    arm = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    height = ((*cspan_at(&work, place + layout__PLACE_RADIUS)) + z) * cos_phi;
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    lateral = (-(*cspan_at(&work, place + layout__PLACE_COS_YAW))) * (arm * sin_roll + height * cos_roll);
    vertical = arm * cos_roll - height * sin_roll;
    return rail_slope * lateral - vertical;
}

/* ``vertical_gap``, its and the slope difference's derivatives with respect to roll [m, 1] at a fixed
 * wheel point, and the rail abscissa [m].
 *
 * The derivative of the outline's slope is the one without yaw: it sets how fast a Newton method converges,
 * not where.
 */
static inline int64_t gap__gap_jet(double* result_0, double* mismatch, double* result_2, double* result_3, double* result_4, double* abscissa, array_double_1d work, array_double_1d tables, int64_t place, double y)
{
    double z;
    double slope;
    double bend;
    double y_track;
    double z_track;
    double outline_slope;
    double stretch;
    double outline_rate;
    double z_rail;
    double rail_slope;
    double rail_bend;
    double lateral;
    double vertical;
    double sin_phi;
    double cos_phi;
    profile_table__height_slope_bend(&z, &slope, &bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__outline_jet(&y_track, &z_track, &outline_slope, &stretch, &outline_rate, work, place, y, z, slope, bend);
    (*abscissa) = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y));
    profile_table__height_slope_bend(&z_rail, &rail_slope, &rail_bend, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), (*abscissa));
    (*mismatch) = rail_slope - outline_slope;
    if (!(stretch > 0.0))
    {
        (*mismatch) = gap__FOLDED;
    }
    lateral = (-(*cspan_at(&work, place + layout__PLACE_COS_YAW))) * (z_track + (*cspan_at(&work, place + layout__PLACE_HEIGHT)));
    vertical = y_track - (*cspan_at(&work, place + layout__PLACE_SHIFT));
    if ((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0)
    {
        locus__around_wheel(&sin_phi, &cos_phi, work, place, slope);
        vertical = ((*cspan_at(&work, place + layout__PLACE_ARM)) + y) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) - ((*cspan_at(&work, place + layout__PLACE_RADIUS)) + z) * cos_phi * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    }
    (*result_0) = z_rail - z_track;
    (*result_2) = rail_bend * stretch - outline_rate;
    (*result_3) = rail_slope * lateral - vertical;
    (*result_4) = rail_bend * lateral - 1.0 - outline_slope * outline_slope;
    return 0;
}
