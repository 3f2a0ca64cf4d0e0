/* Generated from surface/rails.py by tools/transpile_kernel.py; change that one.
 *
 * Rails that are moved from their nominal place.
 *
 * Seen from its rail the wheelset moves the other way. Search and contact therefore work in the frame that moves
 * with the rail, in which the rail is in its nominal place; only what is reported is taken back to the track.
 *
 * A rail rolls about its highest point in its nominal place, after it was displaced. In its frame the wheelset's
 * axle has another yaw and roll, its centre is elsewhere, and down is not the frame's vertical: how far the
 * wheelset has come down moves it sideways too. A place therefore holds for one vertical shift, its
 * ``reference``; the frame's vertical gap is the way down from there to first order only, and where the gap is
 * sought, the reference follows it (wheelset/leaning.py).
 */

#include "rails.h"

/* Let the rail below a placed wheel be displaced to the field side by ``lateral`` and down by
 * ``vertical`` [m].
 */
static inline int64_t rails__move_rail(array_double_1d work, int64_t place, double lateral, double vertical)
{
    (*cspan_at(&work, place + layout__PLACE_SHIFT)) -= lateral;
    (*cspan_at(&work, place + layout__PLACE_HEIGHT)) += vertical;
    (*cspan_at(&work, place + layout__PLACE_RAIL_LATERAL)) = lateral;
    (*cspan_at(&work, place + layout__PLACE_RAIL_VERTICAL)) = vertical;
    return INT64_C(0);
}

/* Let the rail below a placed wheel roll by ``angle`` [rad], field side down, about its highest point,
 * whose nominal place is ``rail_y`` [m]; turn_leaning has to follow.
 */
static inline int64_t rails__lean_rail(array_double_1d work, int64_t place, double rail_y, double angle)
{
    double sine;
    double cosine;
    double across;
    double down;
    sine = sin(angle);
    cosine = cos(angle);
    across = (*cspan_at(&work, place + layout__PLACE_SHIFT)) - rail_y;
    down = (*cspan_at(&work, place + layout__PLACE_REFERENCE)) - (*cspan_at(&work, place + layout__PLACE_HEIGHT));
    (*cspan_at(&work, place + layout__PLACE_SHIFT)) = rail_y + cosine * across + sine * down;
    (*cspan_at(&work, place + layout__PLACE_HEIGHT)) = (*cspan_at(&work, place + layout__PLACE_REFERENCE)) - (cosine * down - sine * across);
    (*cspan_at(&work, place + layout__PLACE_RAIL_ROLL)) = angle;
    (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) = sine;
    (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) = cosine;
    (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW)) = (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
    (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
    (*cspan_at(&work, place + layout__PLACE_LEANING)) = (double)(1);
    return INT64_C(0);
}

/* Yaw and roll that a placed wheelset has in the frame of its rolled rail: those of its axle, since a
 * wheel is round.
 */
static inline int64_t rails__turn_leaning(array_double_1d work, int64_t place)
{
    double sin_roll;
    double cos_roll;
    double along;
    double level;
    double across;
    double sine;
    double cosine;
    sin_roll = (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
    cos_roll = (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
    along = (-(*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW))) * cos_roll;
    level = (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * cos_roll;
    across = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * level + (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * sin_roll;
    sine = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * sin_roll - (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * level;
    cosine = sqrt(along * along + across * across);
    (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) = (-along) / cosine;
    (*cspan_at(&work, place + layout__PLACE_COS_YAW)) = across / cosine;
    locus__set_roll(work, place, sine, cosine);
    return INT64_C(0);
}

/* Sine and cosine of the angle about the axle by which the wheelset's axes lie before those that yaw and
 * roll in the rail's frame give it.
 */
static inline int64_t rails__pitch_of_frame(double* sine, double* cosine, array_double_1d work, int64_t place)
{
    double forward;
    double down;
    forward = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW));
    down = (-(*cspan_at(&work, place + layout__PLACE_RAIL_SIN))) * (*cspan_at(&work, place + layout__PLACE_TRACK_SIN_YAW));
    (*sine) = -(((*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) - forward * (*cspan_at(&work, place + layout__PLACE_COS_YAW))) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + down * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)));
    (*cosine) = (*cspan_at(&work, place + layout__PLACE_TRACK_COS_YAW)) * (*cspan_at(&work, place + layout__PLACE_COS_YAW)) + forward * (*cspan_at(&work, place + layout__PLACE_SIN_YAW));
    return 0;
}

/* The vertical share, in the track, of a force along a normal with this cosine and sine in the rail's
 * frame.
 */
static inline double rails__upright_share(array_double_1d work, int64_t place, double cosine, double sine)
{
    double share;
    share = cosine;
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        share = (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * cosine - (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * sine;
    }
    return share;
}

/* Coordinates to the field side and down [m], in the track, of a point at ``y``, ``z`` in the frame of
 * the moved rail whose nominal place is ``rail_y``.
 */
static inline int64_t rails__on_track(double* result_0, double* result_1, array_double_1d work, int64_t place, double rail_y, double y, double z)
{
    double across;
    if ((*cspan_at(&work, place + layout__PLACE_LEANING)) == 1.0)
    {
        across = y - rail_y;
        y = rail_y + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * across - (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * z;
        z = (*cspan_at(&work, place + layout__PLACE_RAIL_SIN)) * across + (*cspan_at(&work, place + layout__PLACE_RAIL_COS)) * z;
    }
    (*result_0) = y + (*cspan_at(&work, place + layout__PLACE_RAIL_LATERAL));
    (*result_1) = z + (*cspan_at(&work, place + layout__PLACE_RAIL_VERTICAL));
    return 0;
}
