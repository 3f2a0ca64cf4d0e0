/* Generated from surface/locus.py by tools/transpile_kernel.py; change that one.
 *
 * The contact locus: where a yawed wheel can touch a rail that is the same all along the track.
 *
 * The wheel is a surface of revolution, the rail a cylinder along x, so their common normal has no x component.
 * That leaves one angle around the wheel for every profile point (Wang 1984; closed form in docs/method.md):
 *
 *     phi(y) = -atan t - asin w,   t = tan(yaw) sin(roll),   w = tan(yaw) cos(roll) r'(y) / sqrt(1 + t^2)
 *
 * Seen along the track the locus is the wheel's outline, and wheel against rail becomes a problem in the (y, z)
 * plane. Everything here is for a right wheel; the left one comes in mirrored (conventions.MIRROR).
 */

#include "locus.h"

/* Write the pose of a right wheel of this nominal ``radius`` to ``place``; the wheelset's centre has the
 * ``height`` over the running circles, and ``arm`` is half their distance [m].
 */
static inline int64_t locus__place_wheelset(array_double_1d work, int64_t place, double lateral_shift, double yaw, double roll, double radius, double height, double arm)
{
    (*cspan_at(&work, place + layout__PLACE_SHIFT)) = lateral_shift;
    (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = 1.0;
    (*cspan_at(&work, place + layout__PLACE_YAWED)) = (double)(0);
    if (yaw != 0.0)
    {
        (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = sin(yaw);
        (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = cos(yaw);
        (*cspan_at(&work, place + layout__PLACE_YAWED)) = (double)(1);
    }
    (*cspan_at(&work, place + layout__PLACE_RADIUS)) = radius;
    (*cspan_at(&work, place + layout__PLACE_HEIGHT)) = height;
    (*cspan_at(&work, place + layout__PLACE_ARM)) = arm;
    (*cspan_at(&work, place + layout__PLACE_RAIL_LATERAL)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_RAIL_VERTICAL)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_LEANING)) = (double)(0);
    (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) = 0.0;
    locus__turn_wheelset(work, place, roll);
    return INT64_C(0);
}

/* Give a placed wheelset another roll [rad]. */
static inline int64_t locus__turn_wheelset(array_double_1d work, int64_t place, double roll)
{
    locus__set_roll(work, place, sin(roll), cos(roll));
    return INT64_C(0);
}

/* Give a placed wheelset the roll with this sine and cosine, and what (2.2) needs of it. */
static inline int64_t locus__set_roll(array_double_1d work, int64_t place, double sin_roll, double cos_roll)
{
    double t;
    double cos_t;
    double w_per_slope;
    double tan_yaw;
    t = 0.0;
    cos_t = 1.0;
    w_per_slope = 0.0;
    if ((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0)
    {
        tan_yaw = (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) / (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        t = tan_yaw * sin_roll;
        cos_t = 1.0 / sqrt(1.0 + t * t);
        w_per_slope = tan_yaw * cos_roll * cos_t;
    }
    (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) = sin_roll;
    (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) = cos_roll;
    (*cspan_at(&work, place + layout__PLACE_T)) = t;
    (*cspan_at(&work, place + layout__PLACE_COS_T)) = cos_t;
    (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) = w_per_slope;
    return INT64_C(0);
}

/* The left wheel of the wheelset at ``place``, with its nominal ``radius`` [m], as a right wheel at
 * ``mirrored``: shift, yaw and roll change sign.
 */
static inline int64_t locus__mirror_place(array_double_1d work, int64_t place, int64_t mirrored, double radius)
{
    (*cspan_at(&work, mirrored + layout__PLACE_SHIFT)) = -(*cspan_at(&work, place + layout__PLACE_SHIFT));
    (*cspan_at(&work, mirrored + layout__PLACE_SIN_YAW)) = -(*cspan_at(&work, place + layout__PLACE_SIN_YAW));
    (*cspan_at(&work, mirrored + layout__PLACE_COS_YAW)) = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
    (*cspan_at(&work, mirrored + layout__PLACE_RADIUS)) = radius;
    (*cspan_at(&work, mirrored + layout__PLACE_HEIGHT)) = (*cspan_at(&work, place + layout__PLACE_HEIGHT));
    (*cspan_at(&work, mirrored + layout__PLACE_ARM)) = (*cspan_at(&work, place + layout__PLACE_ARM));
    (*cspan_at(&work, mirrored + layout__PLACE_YAWED)) = (double)((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0);
    (*cspan_at(&work, mirrored + layout__PLACE_LEANING)) = (double)(0);
    (*cspan_at(&work, mirrored + layout__PLACE_RAIL_SIN)) = 0.0;
    locus__mirror_roll(work, place, mirrored);
    return INT64_C(0);
}

/* What ``turn_wheelset`` has changed, mirrored. */
static inline int64_t locus__mirror_roll(array_double_1d work, int64_t place, int64_t mirrored)
{
    (*cspan_at(&work, mirrored + layout__PLACE_SIN_ROLL)) = -(*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    (*cspan_at(&work, mirrored + layout__PLACE_COS_ROLL)) = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    (*cspan_at(&work, mirrored + layout__PLACE_T)) = (*cspan_at(&work, place + layout__PLACE_T));
    (*cspan_at(&work, mirrored + layout__PLACE_COS_T)) = (*cspan_at(&work, place + layout__PLACE_COS_T));
    (*cspan_at(&work, mirrored + layout__PLACE_W_PER_SLOPE)) = -(*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE));
    return INT64_C(0);
}

/* sin and cos of the angle around the wheel where the normal of a profile point with ``slope`` has no x
 * component.
 *
 * Where the yaw is too large for that (|w| > 1) the nearest angle, w = +-1, is taken.
 */
static ALWAYS_INLINE int64_t locus__around_wheel(double* result_0, double* result_1, array_double_1d work, int64_t place, double slope)
{
    double w;
    double root;
    double t;
    double cos_t;
    w = (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) * slope;
    if (w > 1.0)
    {
        w = 1.0;
    }
    if (w < -1.0)
    {
        w = -1.0;
    }
    root = sqrt(1.0 - w * w);
    t = (*cspan_at(&work, place + layout__PLACE_T));
    cos_t = (*cspan_at(&work, place + layout__PLACE_COS_T));
    (*result_0) = (-(t * root + w)) * cos_t;
    (*result_1) = (root - t * w) * cos_t;
    return 0;
}

/* Lateral and vertical track coordinate [m] and slope dz/dy [-] of the outline at the wheel's profile
 * point (y, z).
 *
 * They are those of a rail that is not moved. The vertical shift of the wheelset is not included: its centre
 * is at minus ``place.height``.
 */
static inline int64_t locus__outline_point(double* y_track, double* z_track, double* outline_slope, array_double_1d work, int64_t place, double y, double z, double slope)
{
    double sin_roll;
    double cos_roll;
    double arm;
    double r;
    double sin_yaw;
    double cos_yaw;
    double sin_phi;
    double cos_phi;
    double normal_y;
    double normal_z;
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    arm = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + arm * cos_roll - r * sin_roll;
        (*z_track) = arm * sin_roll + r * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        (*outline_slope) = (slope * cos_roll + sin_roll) / (cos_roll - slope * sin_roll);
    }
    else
    {
        sin_yaw = (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
        cos_yaw = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        locus__around_wheel(&sin_phi, &cos_phi, work, place, slope);
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + sin_yaw * r * sin_phi + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll);
        (*z_track) = arm * sin_roll + r * cos_phi * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll);
        normal_z = cos_phi * cos_roll - slope * sin_roll;
        (*outline_slope) = (-normal_y) / normal_z;
    }
    return 0;
}

/* ``outline_point``, and along the wheel's profile the derivatives of the lateral coordinate [-] and
 * slope [1/m]. (Both are written out: a search calls the shorter one most.)
 */
static inline int64_t locus__outline_jet(double* y_track, double* z_track, double* outline_slope, double* stretch, double* slope_rate, array_double_1d work, int64_t place, double y, double z, double slope, double bend)
{
    double sin_roll;
    double cos_roll;
    double arm;
    double r;
    double sin_yaw;
    double cos_yaw;
    double sin_phi;
    double cos_phi;
    double w;
    double phi_rate;
    double normal_y;
    double normal_z;
    double normal_y_rate;
    double normal_z_rate;
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    arm = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + arm * cos_roll - r * sin_roll;
        (*z_track) = arm * sin_roll + r * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        (*stretch) = cos_roll - slope * sin_roll;
        (*outline_slope) = (slope * cos_roll + sin_roll) / (*stretch);
        (*slope_rate) = bend / ((*stretch) * (*stretch));
    }
    else
    {
        sin_yaw = (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
        cos_yaw = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        locus__around_wheel(&sin_phi, &cos_phi, work, place, slope);
        w = (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) * slope;
        phi_rate = 0.0;
        if (w * w < 1.0)
        {
            phi_rate = (-(*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE))) * bend / sqrt(1.0 - w * w);
        }
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + sin_yaw * r * sin_phi + cos_yaw * (arm * cos_roll - r * cos_phi * sin_roll);
        (*z_track) = arm * sin_roll + r * cos_phi * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        (*stretch) = sin_yaw * (slope * sin_phi + r * cos_phi * phi_rate) + cos_yaw * (cos_roll - sin_roll * (slope * cos_phi - r * sin_phi * phi_rate));
        normal_y = sin_yaw * sin_phi - cos_yaw * (slope * cos_roll + cos_phi * sin_roll);
        normal_z = cos_phi * cos_roll - slope * sin_roll;
        normal_y_rate = sin_yaw * cos_phi * phi_rate - cos_yaw * (bend * cos_roll - sin_phi * phi_rate * sin_roll);
        normal_z_rate = (-sin_phi) * phi_rate * cos_roll - bend * sin_roll;
        (*outline_slope) = (-normal_y) / normal_z;
        (*slope_rate) = (-(normal_y_rate * normal_z - normal_y * normal_z_rate)) / (normal_z * normal_z);
    }
    return 0;
}

/* Track coordinate x [m] of the outline at wheel abscissa ``y`` [m], from the middle of the wheelset. */
static inline double locus__outline_x(array_double_1d work, array_double_1d tables, int64_t place, double y)
{
    double z;
    double slope;
    double sin_phi;
    double cos_phi;
    double r;
    double lateral;
    double result;
    profile_table__height_slope(&z, &slope, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y);
    locus__around_wheel(&sin_phi, &cos_phi, work, place, slope);
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    lateral = ((*cspan_at(&work, place + layout__PLACE_ARM)) + y) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) - r * cos_phi * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    result = (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r * sin_phi - (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral;
    return result;
}
