/* Generated from tangent_locus.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of locus.py.
 */

#include "tangent_locus.h"

/* Tangent of ``place_wheelset``. */
static inline int64_t tangent_locus__place_wheelset_t(array_double_1d work, array_double_1d work_t, int64_t place, double lateral_shift, double lateral_shift_t, double yaw, double yaw_t, double roll, double roll_t, double radius, double radius_t, double height, double height_t, double arm, double arm_t)
{
    (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) = lateral_shift_t;
    (*cspan_at(&work, place + layout__PLACE_SHIFT)) = lateral_shift;
    (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = 0.0;
    (*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = 1.0;
    (*cspan_at(&work_t, place + layout__PLACE_YAWED)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_YAWED)) = (double)(0);
    if (yaw != 0.0)
    {
        (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) = cos(yaw) * yaw_t;
        (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = sin(yaw);
        (*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) = (-sin(yaw)) * yaw_t;
        (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = cos(yaw);
        (*cspan_at(&work_t, place + layout__PLACE_YAWED)) = 0.0;
        (*cspan_at(&work, place + layout__PLACE_YAWED)) = (double)(1);
    }
    (*cspan_at(&work_t, place + layout__PLACE_RADIUS)) = radius_t;
    (*cspan_at(&work, place + layout__PLACE_RADIUS)) = radius;
    (*cspan_at(&work_t, place + layout__PLACE_HEIGHT)) = height_t;
    (*cspan_at(&work, place + layout__PLACE_HEIGHT)) = height;
    (*cspan_at(&work_t, place + layout__PLACE_ARM)) = arm_t;
    (*cspan_at(&work, place + layout__PLACE_ARM)) = arm;
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_LATERAL)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_RAIL_LATERAL)) = 0.0;
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_VERTICAL)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_RAIL_VERTICAL)) = 0.0;
    (*cspan_at(&work_t, place + layout__PLACE_LEANING)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_LEANING)) = (double)(0);
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) = 0.0;
    tangent_locus__turn_wheelset_t(work, work_t, place, roll, roll_t);
    return INT64_C(0);
}

/* Tangent of ``turn_wheelset``. */
static inline int64_t tangent_locus__turn_wheelset_t(array_double_1d work, array_double_1d work_t, int64_t place, double roll, double roll_t)
{
    tangent_locus__set_roll_t(work, work_t, place, sin(roll), cos(roll) * roll_t, cos(roll), (-sin(roll)) * roll_t);
    return INT64_C(0);
}

/* Tangent of ``set_roll``. */
static inline int64_t tangent_locus__set_roll_t(array_double_1d work, array_double_1d work_t, int64_t place, double sin_roll, double sin_roll_t, double cos_roll, double cos_roll_t)
{
    double t_t;
    double t;
    double cos_t_t;
    double cos_t;
    double w_per_slope_t;
    double w_per_slope;
    double v1;
    double tan_yaw_t;
    double tan_yaw;
    double v2;
    double v3;
    double v4;
    double v5;
    t_t = 0.0;
    t = 0.0;
    cos_t_t = 0.0;
    cos_t = 1.0;
    w_per_slope_t = 0.0;
    w_per_slope = 0.0;
    if ((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0)
    {
        v1 = (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) / (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        tan_yaw_t = ((*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) - v1 * (*cspan_at(&work_t, place + layout__PLACE_COS_YAW))) / (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        tan_yaw = v1;
        t_t = tan_yaw_t * sin_roll + tan_yaw * sin_roll_t;
        t = tan_yaw * sin_roll;
        v2 = 1.0 + t * t;
        v3 = sqrt(v2);
        v4 = 1.0 / v3;
        cos_t_t = (-v4) * tangent_rates__root_rate(v3, t_t * t + t * t_t) / v3;
        cos_t = v4;
        v5 = tan_yaw * cos_roll;
        w_per_slope_t = (tan_yaw_t * cos_roll + tan_yaw * cos_roll_t) * cos_t + v5 * cos_t_t;
        w_per_slope = v5 * cos_t;
    }
    (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)) = sin_roll_t;
    (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) = sin_roll;
    (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL)) = cos_roll_t;
    (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) = cos_roll;
    (*cspan_at(&work_t, place + layout__PLACE_T)) = t_t;
    (*cspan_at(&work, place + layout__PLACE_T)) = t;
    (*cspan_at(&work_t, place + layout__PLACE_COS_T)) = cos_t_t;
    (*cspan_at(&work, place + layout__PLACE_COS_T)) = cos_t;
    (*cspan_at(&work_t, place + layout__PLACE_W_PER_SLOPE)) = w_per_slope_t;
    (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) = w_per_slope;
    return INT64_C(0);
}

/* Tangent of ``mirror_place``. */
static inline int64_t tangent_locus__mirror_place_t(array_double_1d work, array_double_1d work_t, int64_t place, int64_t mirrored, double radius, double radius_t)
{
    (*cspan_at(&work_t, mirrored + layout__PLACE_SHIFT)) = -(*cspan_at(&work_t, place + layout__PLACE_SHIFT));
    (*cspan_at(&work, mirrored + layout__PLACE_SHIFT)) = -(*cspan_at(&work, place + layout__PLACE_SHIFT));
    (*cspan_at(&work_t, mirrored + layout__PLACE_SIN_YAW)) = -(*cspan_at(&work_t, place + layout__PLACE_SIN_YAW));
    (*cspan_at(&work, mirrored + layout__PLACE_SIN_YAW)) = -(*cspan_at(&work, place + layout__PLACE_SIN_YAW));
    (*cspan_at(&work_t, mirrored + layout__PLACE_COS_YAW)) = (*cspan_at(&work_t, place + layout__PLACE_COS_YAW));
    (*cspan_at(&work, mirrored + layout__PLACE_COS_YAW)) = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
    (*cspan_at(&work_t, mirrored + layout__PLACE_RADIUS)) = radius_t;
    (*cspan_at(&work, mirrored + layout__PLACE_RADIUS)) = radius;
    (*cspan_at(&work_t, mirrored + layout__PLACE_HEIGHT)) = (*cspan_at(&work_t, place + layout__PLACE_HEIGHT));
    (*cspan_at(&work, mirrored + layout__PLACE_HEIGHT)) = (*cspan_at(&work, place + layout__PLACE_HEIGHT));
    (*cspan_at(&work_t, mirrored + layout__PLACE_ARM)) = (*cspan_at(&work_t, place + layout__PLACE_ARM));
    (*cspan_at(&work, mirrored + layout__PLACE_ARM)) = (*cspan_at(&work, place + layout__PLACE_ARM));
    (*cspan_at(&work_t, mirrored + layout__PLACE_YAWED)) = 0.0;
    (*cspan_at(&work, mirrored + layout__PLACE_YAWED)) = (double)((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0);
    (*cspan_at(&work_t, mirrored + layout__PLACE_LEANING)) = 0.0;
    (*cspan_at(&work, mirrored + layout__PLACE_LEANING)) = (double)(0);
    (*cspan_at(&work_t, mirrored + layout__PLACE_RAIL_SIN)) = 0.0;
    (*cspan_at(&work, mirrored + layout__PLACE_RAIL_SIN)) = 0.0;
    tangent_locus__mirror_roll_t(work, work_t, place, mirrored);
    return INT64_C(0);
}

/* Tangent of ``mirror_roll``. */
static inline int64_t tangent_locus__mirror_roll_t(array_double_1d work, array_double_1d work_t, int64_t place, int64_t mirrored)
{
    (*cspan_at(&work_t, mirrored + layout__PLACE_SIN_ROLL)) = -(*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL));
    (*cspan_at(&work, mirrored + layout__PLACE_SIN_ROLL)) = -(*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    (*cspan_at(&work_t, mirrored + layout__PLACE_COS_ROLL)) = (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL));
    (*cspan_at(&work, mirrored + layout__PLACE_COS_ROLL)) = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    (*cspan_at(&work_t, mirrored + layout__PLACE_T)) = (*cspan_at(&work_t, place + layout__PLACE_T));
    (*cspan_at(&work, mirrored + layout__PLACE_T)) = (*cspan_at(&work, place + layout__PLACE_T));
    (*cspan_at(&work_t, mirrored + layout__PLACE_COS_T)) = (*cspan_at(&work_t, place + layout__PLACE_COS_T));
    (*cspan_at(&work, mirrored + layout__PLACE_COS_T)) = (*cspan_at(&work, place + layout__PLACE_COS_T));
    (*cspan_at(&work_t, mirrored + layout__PLACE_W_PER_SLOPE)) = -(*cspan_at(&work_t, place + layout__PLACE_W_PER_SLOPE));
    (*cspan_at(&work, mirrored + layout__PLACE_W_PER_SLOPE)) = -(*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE));
    return INT64_C(0);
}

/* Tangent of ``around_wheel``. */
static inline int64_t tangent_locus__around_wheel_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t place, double slope, double slope_t)
{
    double w_t;
    double w;
    double v1;
    double v2;
    double root_t;
    double root;
    double t_t;
    double t;
    double cos_t_t;
    double cos_t;
    double v3;
    double v4;
    w_t = (*cspan_at(&work_t, place + layout__PLACE_W_PER_SLOPE)) * slope + (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) * slope_t;
    w = (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) * slope;
    if (w > 1.0)
    {
        w_t = 0.0;
        w = 1.0;
    }
    if (w < -1.0)
    {
        w_t = 0.0;
        w = -1.0;
    }
    v1 = 1.0 - w * w;
    v2 = sqrt(v1);
    root_t = tangent_rates__root_rate(v2, -(w_t * w + w * w_t));
    root = v2;
    t_t = (*cspan_at(&work_t, place + layout__PLACE_T));
    t = (*cspan_at(&work, place + layout__PLACE_T));
    cos_t_t = (*cspan_at(&work_t, place + layout__PLACE_COS_T));
    cos_t = (*cspan_at(&work, place + layout__PLACE_COS_T));
    v3 = -(t * root + w);
    v4 = root - t * w;
    (*result_0) = v3 * cos_t;
    (*result_1) = (-(t_t * root + t * root_t + w_t)) * cos_t + v3 * cos_t_t;
    (*result_2) = v4 * cos_t;
    (*result_3) = (root_t - (t_t * w + t * w_t)) * cos_t + v4 * cos_t_t;
    return 0;
}

/* Tangent of ``outline_point``. */
static inline int64_t tangent_locus__outline_point_t(double* y_track, double* y_track_t, double* z_track, double* z_track_t, double* outline_slope, double* outline_slope_t, array_double_1d work, array_double_1d work_t, int64_t place, double y, double y_t, double z, double z_t, double slope, double slope_t)
{
    double sin_roll_t;
    double sin_roll;
    double cos_roll_t;
    double cos_roll;
    double arm_t;
    double arm;
    double r_t;
    double r;
    double v1;
    double v2;
    double v3;
    double sin_yaw_t;
    double sin_yaw;
    double cos_yaw_t;
    double cos_yaw;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double v4;
    double v5;
    double v6;
    double v7;
    double v8;
    double normal_y_t;
    double normal_y;
    double normal_z_t;
    double normal_z;
    double v9;
    double v10;
    sin_roll_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL));
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll_t = (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    arm_t = (*cspan_at(&work_t, place + layout__PLACE_ARM)) + y_t;
    arm = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    r_t = (*cspan_at(&work_t, place + layout__PLACE_RADIUS)) + z_t;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        (*y_track_t) = (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) + (arm_t * cos_roll + arm * cos_roll_t) - (r_t * sin_roll + r * sin_roll_t);
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + arm * cos_roll - r * sin_roll;
        (*z_track_t) = arm_t * sin_roll + arm * sin_roll_t + (r_t * cos_roll + r * cos_roll_t) - (*cspan_at(&work_t, place + layout__PLACE_HEIGHT));
        (*z_track) = arm * sin_roll + r * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        v1 = slope * cos_roll + sin_roll;
        v2 = cos_roll - slope * sin_roll;
        v3 = v1 / v2;
        (*outline_slope_t) = (slope_t * cos_roll + slope * cos_roll_t + sin_roll_t - v3 * (cos_roll_t - (slope_t * sin_roll + slope * sin_roll_t))) / v2;
        (*outline_slope) = v3;
    }
    else
    {
        sin_yaw_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW));
        sin_yaw = (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
        cos_yaw_t = (*cspan_at(&work_t, place + layout__PLACE_COS_YAW));
        cos_yaw = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, place, slope, slope_t);
        v4 = sin_yaw * r;
        v5 = r * cos_phi;
        v6 = arm * cos_roll - v5 * sin_roll;
        (*y_track_t) = (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) + ((sin_yaw_t * r + sin_yaw * r_t) * sin_phi + v4 * sin_phi_t) + (cos_yaw_t * v6 + cos_yaw * (arm_t * cos_roll + arm * cos_roll_t - ((r_t * cos_phi + r * cos_phi_t) * sin_roll + v5 * sin_roll_t)));
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + v4 * sin_phi + cos_yaw * v6;
        v7 = r * cos_phi;
        (*z_track_t) = arm_t * sin_roll + arm * sin_roll_t + ((r_t * cos_phi + r * cos_phi_t) * cos_roll + v7 * cos_roll_t) - (*cspan_at(&work_t, place + layout__PLACE_HEIGHT));
        (*z_track) = arm * sin_roll + v7 * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        v8 = slope * cos_roll + cos_phi * sin_roll;
        normal_y_t = sin_yaw_t * sin_phi + sin_yaw * sin_phi_t - (cos_yaw_t * v8 + cos_yaw * (slope_t * cos_roll + slope * cos_roll_t + (cos_phi_t * sin_roll + cos_phi * sin_roll_t)));
        normal_y = sin_yaw * sin_phi - cos_yaw * v8;
        normal_z_t = cos_phi_t * cos_roll + cos_phi * cos_roll_t - (slope_t * sin_roll + slope * sin_roll_t);
        normal_z = cos_phi * cos_roll - slope * sin_roll;
        v9 = -normal_y;
        v10 = v9 / normal_z;
        (*outline_slope_t) = ((-normal_y_t) - v10 * normal_z_t) / normal_z;
        (*outline_slope) = v10;
    }
    return 0;
}

/* Tangent of ``outline_jet``. */
static inline int64_t tangent_locus__outline_jet_t(double* y_track, double* y_track_t, double* z_track, double* z_track_t, double* outline_slope, double* outline_slope_t, double* stretch, double* stretch_t, double* slope_rate, double* slope_rate_t, array_double_1d work, array_double_1d work_t, int64_t place, double y, double y_t, double z, double z_t, double slope, double slope_t, double bend, double bend_t)
{
    double sin_roll_t;
    double sin_roll;
    double cos_roll_t;
    double cos_roll;
    double arm_t;
    double arm;
    double r_t;
    double r;
    double v1;
    double v2;
    double v3;
    double v4;
    double sin_yaw_t;
    double sin_yaw;
    double cos_yaw_t;
    double cos_yaw;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double w_t;
    double w;
    double phi_rate_t;
    double phi_rate;
    double v5;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    double v14;
    double v15;
    double v16;
    double v17;
    double v18;
    double v19;
    double normal_y_t;
    double normal_y;
    double normal_z_t;
    double normal_z;
    double v20;
    double v21;
    double v22;
    double normal_y_rate_t;
    double normal_y_rate;
    double v23;
    double v24;
    double normal_z_rate_t;
    double normal_z_rate;
    double v25;
    double v26;
    double v27;
    double v28;
    double v29;
    sin_roll_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL));
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll_t = (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    arm_t = (*cspan_at(&work_t, place + layout__PLACE_ARM)) + y_t;
    arm = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    r_t = (*cspan_at(&work_t, place + layout__PLACE_RADIUS)) + z_t;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        (*y_track_t) = (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) + (arm_t * cos_roll + arm * cos_roll_t) - (r_t * sin_roll + r * sin_roll_t);
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + arm * cos_roll - r * sin_roll;
        (*z_track_t) = arm_t * sin_roll + arm * sin_roll_t + (r_t * cos_roll + r * cos_roll_t) - (*cspan_at(&work_t, place + layout__PLACE_HEIGHT));
        (*z_track) = arm * sin_roll + r * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        (*stretch_t) = cos_roll_t - (slope_t * sin_roll + slope * sin_roll_t);
        (*stretch) = cos_roll - slope * sin_roll;
        v1 = slope * cos_roll + sin_roll;
        v2 = v1 / (*stretch);
        (*outline_slope_t) = (slope_t * cos_roll + slope * cos_roll_t + sin_roll_t - v2 * (*stretch_t)) / (*stretch);
        (*outline_slope) = v2;
        v3 = (*stretch) * (*stretch);
        v4 = bend / v3;
        (*slope_rate_t) = (bend_t - v4 * ((*stretch_t) * (*stretch) + (*stretch) * (*stretch_t))) / v3;
        (*slope_rate) = v4;
    }
    else
    {
        sin_yaw_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW));
        sin_yaw = (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
        cos_yaw_t = (*cspan_at(&work_t, place + layout__PLACE_COS_YAW));
        cos_yaw = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, place, slope, slope_t);
        w_t = (*cspan_at(&work_t, place + layout__PLACE_W_PER_SLOPE)) * slope + (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) * slope_t;
        w = (*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE)) * slope;
        phi_rate_t = 0.0;
        phi_rate = 0.0;
        if (w * w < 1.0)
        {
            v5 = -(*cspan_at(&work, place + layout__PLACE_W_PER_SLOPE));
            v6 = v5 * bend;
            v7 = 1.0 - w * w;
            v8 = sqrt(v7);
            v9 = v6 / v8;
            phi_rate_t = ((-(*cspan_at(&work_t, place + layout__PLACE_W_PER_SLOPE))) * bend + v5 * bend_t - v9 * tangent_rates__root_rate(v8, -(w_t * w + w * w_t))) / v8;
            phi_rate = v9;
        }
        v10 = sin_yaw * r;
        v11 = r * cos_phi;
        v12 = arm * cos_roll - v11 * sin_roll;
        (*y_track_t) = (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) + ((sin_yaw_t * r + sin_yaw * r_t) * sin_phi + v10 * sin_phi_t) + (cos_yaw_t * v12 + cos_yaw * (arm_t * cos_roll + arm * cos_roll_t - ((r_t * cos_phi + r * cos_phi_t) * sin_roll + v11 * sin_roll_t)));
        (*y_track) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) + v10 * sin_phi + cos_yaw * v12;
        v13 = r * cos_phi;
        (*z_track_t) = arm_t * sin_roll + arm * sin_roll_t + ((r_t * cos_phi + r * cos_phi_t) * cos_roll + v13 * cos_roll_t) - (*cspan_at(&work_t, place + layout__PLACE_HEIGHT));
        (*z_track) = arm * sin_roll + v13 * cos_roll - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
        v14 = r * cos_phi;
        v15 = slope * sin_phi + v14 * phi_rate;
        v16 = r * sin_phi;
        v17 = slope * cos_phi - v16 * phi_rate;
        v18 = cos_roll - sin_roll * v17;
        (*stretch_t) = sin_yaw_t * v15 + sin_yaw * (slope_t * sin_phi + slope * sin_phi_t + ((r_t * cos_phi + r * cos_phi_t) * phi_rate + v14 * phi_rate_t)) + (cos_yaw_t * v18 + cos_yaw * (cos_roll_t - (sin_roll_t * v17 + sin_roll * (slope_t * cos_phi + slope * cos_phi_t - ((r_t * sin_phi + r * sin_phi_t) * phi_rate + v16 * phi_rate_t)))));
        (*stretch) = sin_yaw * v15 + cos_yaw * v18;
        v19 = slope * cos_roll + cos_phi * sin_roll;
        normal_y_t = sin_yaw_t * sin_phi + sin_yaw * sin_phi_t - (cos_yaw_t * v19 + cos_yaw * (slope_t * cos_roll + slope * cos_roll_t + (cos_phi_t * sin_roll + cos_phi * sin_roll_t)));
        normal_y = sin_yaw * sin_phi - cos_yaw * v19;
        normal_z_t = cos_phi_t * cos_roll + cos_phi * cos_roll_t - (slope_t * sin_roll + slope * sin_roll_t);
        normal_z = cos_phi * cos_roll - slope * sin_roll;
        v20 = sin_yaw * cos_phi;
        v21 = sin_phi * phi_rate;
        v22 = bend * cos_roll - v21 * sin_roll;
        normal_y_rate_t = (sin_yaw_t * cos_phi + sin_yaw * cos_phi_t) * phi_rate + v20 * phi_rate_t - (cos_yaw_t * v22 + cos_yaw * (bend_t * cos_roll + bend * cos_roll_t - ((sin_phi_t * phi_rate + sin_phi * phi_rate_t) * sin_roll + v21 * sin_roll_t)));
        normal_y_rate = v20 * phi_rate - cos_yaw * v22;
        v23 = -sin_phi;
        v24 = v23 * phi_rate;
        normal_z_rate_t = ((-sin_phi_t) * phi_rate + v23 * phi_rate_t) * cos_roll + v24 * cos_roll_t - (bend_t * sin_roll + bend * sin_roll_t);
        normal_z_rate = v24 * cos_roll - bend * sin_roll;
        v25 = -normal_y;
        v26 = v25 / normal_z;
        (*outline_slope_t) = ((-normal_y_t) - v26 * normal_z_t) / normal_z;
        (*outline_slope) = v26;
        v27 = -(normal_y_rate * normal_z - normal_y * normal_z_rate);
        v28 = normal_z * normal_z;
        v29 = v27 / v28;
        (*slope_rate_t) = ((-(normal_y_rate_t * normal_z + normal_y_rate * normal_z_t - (normal_y_t * normal_z_rate + normal_y * normal_z_rate_t))) - v29 * (normal_z_t * normal_z + normal_z * normal_z_t)) / v28;
        (*slope_rate) = v29;
    }
    return 0;
}

/* Tangent of ``outline_x``. */
static inline int64_t tangent_locus__outline_x_t(double* result_0, double* result_1, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t)
{
    double z;
    double z_t;
    double slope;
    double slope_t;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double r_t;
    double r;
    double v1;
    double v2;
    double lateral_t;
    double lateral;
    double v3;
    tangent_profile_table__height_slope_t(&z, &z_t, &slope, &slope_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
    tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, place, slope, slope_t);
    r_t = (*cspan_at(&work_t, place + layout__PLACE_RADIUS)) + z_t;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    v1 = (*cspan_at(&work, place + layout__PLACE_ARM)) + y;
    v2 = r * cos_phi;
    lateral_t = ((*cspan_at(&work_t, place + layout__PLACE_ARM)) + y_t) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) + v1 * (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL)) - ((r_t * cos_phi + r * cos_phi_t) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + v2 * (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)));
    lateral = v1 * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) - v2 * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    v3 = (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r;
    (*result_0) = v3 * sin_phi - (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral;
    (*result_1) = ((*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) * r + (*cspan_at(&work, place + layout__PLACE_COS_YAW)) * r_t) * sin_phi + v3 * sin_phi_t - ((*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) * lateral + (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * lateral_t);
    return 0;
}
