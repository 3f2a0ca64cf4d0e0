/* Generated from tangent_rails.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of rails.py.
 */

#include "tangent_rails.h"

/* Tangent of ``move_rail``. */
static inline int64_t tangent_rails__move_rail_t(array_double_1d work, array_double_1d work_t, int64_t place, double lateral, double lateral_t, double vertical, double vertical_t)
{
    (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) = (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) - lateral_t;
    (*cspan_at(&work, place + layout__PLACE_SHIFT)) = (*cspan_at(&work, place + layout__PLACE_SHIFT)) - lateral;
    (*cspan_at(&work_t, place + layout__PLACE_HEIGHT)) = (*cspan_at(&work_t, place + layout__PLACE_HEIGHT)) + vertical_t;
    (*cspan_at(&work, place + layout__PLACE_HEIGHT)) = (*cspan_at(&work, place + layout__PLACE_HEIGHT)) + vertical;
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_LATERAL)) = lateral_t;
    (*cspan_at(&work, place + layout__PLACE_RAIL_LATERAL)) = lateral;
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_VERTICAL)) = vertical_t;
    (*cspan_at(&work, place + layout__PLACE_RAIL_VERTICAL)) = vertical;
    return INT64_C(0);
}

/* Tangent of ``lean_rail``. */
static inline int64_t tangent_rails__lean_rail_t(array_double_1d work, array_double_1d work_t, int64_t place, double rail_y, double rail_y_t, double angle, double angle_t)
{
    double sine_t;
    double sine;
    double cosine_t;
    double cosine;
    double across_t;
    double across;
    double down_t;
    double down;
    sine_t = cos(angle) * angle_t;
    sine = sin(angle);
    cosine_t = (-sin(angle)) * angle_t;
    cosine = cos(angle);
    across_t = (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) - rail_y_t;
    across = (*cspan_at(&work, place + layout__PLACE_SHIFT)) - rail_y;
    down_t = (*cspan_at(&work_t, place + layout__PLACE_REFERENCE)) - (*cspan_at(&work_t, place + layout__PLACE_HEIGHT));
    down = (*cspan_at(&work, place + layout__PLACE_REFERENCE)) - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
    (*cspan_at(&work_t, place + layout__PLACE_SHIFT)) = rail_y_t + (cosine_t * across + cosine * across_t) + (sine_t * down + sine * down_t);
    (*cspan_at(&work, place + layout__PLACE_SHIFT)) = rail_y + cosine * across + sine * down;
    (*cspan_at(&work_t, place + layout__PLACE_HEIGHT)) = (*cspan_at(&work_t, place + layout__PLACE_REFERENCE)) - (cosine_t * down + cosine * down_t - (sine_t * across + sine * across_t));
    (*cspan_at(&work, place + layout__PLACE_HEIGHT)) = (*cspan_at(&work, place + layout__PLACE_REFERENCE)) - (cosine * down - sine * across);
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_ROLL)) = angle_t;
    (*cspan_at(&work, place + layout__PLACE_RAIL_ROLL)) = angle;
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) = sine_t;
    (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) = sine;
    (*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) = cosine_t;
    (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) = cosine;
    (*cspan_at(&work_t, place + layout__PLACE_TRACK_SIN_YAW)) = (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW));
    (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW)) = (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
    (*cspan_at(&work_t, place + layout__PLACE_TRACK_COS_YAW)) = (*cspan_at(&work_t, place + layout__PLACE_COS_YAW));
    (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
    (*cspan_at(&work_t, place + layout__PLACE_LEANING)) = 0.0;
    (*cspan_at(&work, place + layout__PLACE_LEANING)) = (double)(1);
    return INT64_C(0);
}

/* Tangent of ``turn_leaning``. */
static inline int64_t tangent_rails__turn_leaning_t(array_double_1d work, array_double_1d work_t, int64_t place)
{
    double sin_roll_t;
    double sin_roll;
    double cos_roll_t;
    double cos_roll;
    double v1;
    double along_t;
    double along;
    double level_t;
    double level;
    double across_t;
    double across;
    double sine_t;
    double sine;
    double v2;
    double v3;
    double cosine_t;
    double cosine;
    double v4;
    double v5;
    double v6;
    sin_roll_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL));
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll_t = (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    v1 = -(*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW));
    along_t = (-(*cspan_at(&work_t, place + layout__PLACE_TRACK_SIN_YAW))) * cos_roll + v1 * cos_roll_t;
    along = v1 * cos_roll;
    level_t = (*cspan_at(&work_t, place + layout__PLACE_TRACK_COS_YAW)) * cos_roll + (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * cos_roll_t;
    level = (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * cos_roll;
    across_t = (*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * level + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * level_t + ((*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) * sin_roll + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * sin_roll_t);
    across = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * level + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * sin_roll;
    sine_t = (*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * sin_roll + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * sin_roll_t - ((*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) * level + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * level_t);
    sine = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * sin_roll - (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * level;
    v2 = along * along + across * across;
    v3 = sqrt(v2);
    cosine_t = tangent_rates__root_rate(v3, along_t * along + along * along_t + (across_t * across + across * across_t));
    cosine = v3;
    v4 = -along;
    v5 = v4 / cosine;
    (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) = ((-along_t) - v5 * cosine_t) / cosine;
    (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = v5;
    v6 = across / cosine;
    (*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) = (across_t - v6 * cosine_t) / cosine;
    (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = v6;
    tangent_locus__set_roll_t(work, work_t, place, sine, sine_t, cosine, cosine_t);
    return INT64_C(0);
}

/* Tangent of ``pitch_of_frame``. */
static inline int64_t tangent_rails__pitch_of_frame_t(double* sine, double* sine_t, double* cosine, double* cosine_t, array_double_1d work, array_double_1d work_t, int64_t place)
{
    double forward_t;
    double forward;
    double v1;
    double down_t;
    double down;
    double v2;
    forward_t = (*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW)) + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * (*cspan_at(&work_t, place + layout__PLACE_TRACK_SIN_YAW));
    forward = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW));
    v1 = -(*cspan_at(&work, place + layout__PLACE_RAIL_SIN));
    down_t = (-(*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN))) * (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW)) + v1 * (*cspan_at(&work_t, place + layout__PLACE_TRACK_SIN_YAW));
    down = v1 * (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW));
    v2 = (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) - forward * (*cspan_at(&work, place + layout__PLACE_COS_YAW));
    (*sine_t) = -(((*cspan_at(&work_t, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) + (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) - (forward_t * (*cspan_at(&work, place + layout__PLACE_COS_YAW)) + forward * (*cspan_at(&work_t, place + layout__PLACE_COS_YAW)))) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + v2 * (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL)) + (down_t * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) + down * (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL))));
    (*sine) = -(v2 * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + down * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)));
    (*cosine_t) = (*cspan_at(&work_t, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work, place + layout__PLACE_COS_YAW)) + (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work_t, place + layout__PLACE_COS_YAW)) + (forward_t * (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) + forward * (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)));
    (*cosine) = (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work, place + layout__PLACE_COS_YAW)) + forward * (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
    return 0;
}

/* Tangent of ``upright_share``. */
static inline int64_t tangent_rails__upright_share_t(double* share, double* share_t, array_double_1d work, array_double_1d work_t, int64_t place, double cosine, double cosine_t, double sine, double sine_t)
{
    (*share_t) = cosine_t;
    (*share) = cosine;
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        (*share_t) = (*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * cosine + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * cosine_t - ((*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) * sine + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * sine_t);
        (*share) = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * cosine - (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * sine;
    }
    return 0;
}

/* Tangent of ``on_track``. */
static inline int64_t tangent_rails__on_track_t(double* result_0, double* result_1, double* result_2, double* result_3, array_double_1d work, array_double_1d work_t, int64_t place, double rail_y, double rail_y_t, double y, double y_t, double z, double z_t)
{
    double across_t;
    double across;
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        across_t = y_t - rail_y_t;
        across = y - rail_y;
        y_t = rail_y_t + ((*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * across + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * across_t) - ((*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) * z + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * z_t);
        y = rail_y + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * across - (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * z;
        z_t = (*cspan_at(&work_t, place + layout__PLACE_RAIL_SIN)) * across + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * across_t + ((*cspan_at(&work_t, place + layout__PLACE_RAIL_COS)) * z + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * z_t);
        z = (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * across + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * z;
    }
    (*result_0) = y + (*cspan_at(&work, place + layout__PLACE_RAIL_LATERAL));
    (*result_1) = y_t + (*cspan_at(&work_t, place + layout__PLACE_RAIL_LATERAL));
    (*result_2) = z + (*cspan_at(&work, place + layout__PLACE_RAIL_VERTICAL));
    (*result_3) = z_t + (*cspan_at(&work_t, place + layout__PLACE_RAIL_VERTICAL));
    return 0;
}
