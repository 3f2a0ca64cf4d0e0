"""The rotation of wheels about their axle on which a given torque acts: how it is sought.

The torque T of the creep forces about the axle falls with the rotation w where friction does not fall with
the sliding velocity; what is sought is T(w) + M = 0, with the torque M from outside, 0 of wheels that roll
freely.  Of every strip i with the velocity v_i of the wheel against the rail but for the rotation about the
axle, and the direction u_i in which that rotation moves its place backwards,

    w_i = v_i . u_i / r_i,   T(min w_i) >= 0 >= T(max w_i)                                       (A1)

Between both the search follows a stand-in that needs no model of creep forces: each patch with Kalker's
coefficients and the saturation of Vermeulen and Johnson (1964),

    f_x = -G a b C11 (v . u - w r) / V_ref,   f_y = G a b (C22 eta + C23 sqrt(ab) phi),   t = |f| / (mu N)
    T_s(w) = -sum r mu N S(t) f_x / |f|,   S = t - t^2/3 + t^3/27, or 1 from t = 3               (A2)

It begins at T_s + M = 0 and goes on with what the last two rates have shown the stand-in to lack:

    T_s(w) + D + E (w - w_k) = 0,   D = T_k + M - T_s(w_k),   E the secant slope of T - T_s      (A3)

Rates that were tried enclose the one that is sought; where four of them have not halved the enclosure, the
next one is in its middle.  Where a model's force jumps, the enclosure ends at the jump: there the rate is the
one at which the creep forces still turn the wheels forward.
"""

from math import fabs, sqrt
from typing import Final

from ..layout import (
    ROLLING_STRIP_LIMIT,
    AXLE_PATCHES,
    Motion,
    Patch,
    Tables,
    Turning,
    TurningPatch,
    clear,
)
from .creepage import REST
from .tractions import kalker_coefficients

#: The torque that is left is less than this share of that of all friction [-].
BALANCED: Final[float] = 1e-9
#: So many rates are tried at most: halving alone needs half of them.
TURNS: Final[int] = 200
#: Rates that were tried in a row without halving the enclosure, after which it is halved.
SLOW: Final[int] = 4
#: An end of the enclosure that was not tried may be off by this share [-].
MARGIN: Final[float] = 1e-9
#: Rates are one when they differ by less than this share, or by less than this [rad/s].
SAME_SHARE: Final[float] = 4e-16
SAME_RATE: Final[float] = 1e-26
#: With a torque from outside the wheels may turn so many times as fast as they roll.
SPINNING: Final[float] = 6.0
#: E of eq. (A3) counts up to so many times the distance to where it expects the rate.
REACH: Final[float] = 4.0
#: Newton's steps of the stand-in.
STEPS: Final[int] = 60
STEP_SHARP: Final[float] = 1e-14


def heading_velocity(motion: Motion, x: float, y_track: float, z_track: float):
    """Velocity [m/s] of a place of the wheel against its rail along the wheel's heading u, without the
    rotation about the axle; and the part of u along the track."""
    rail = motion.rail
    y = y_track - motion.centre_y
    z = z_track - motion.centre_z
    ahead_x = motion.axle_y * z - motion.axle_z * y
    ahead_y = motion.axle_z * x - motion.axle_x * z
    ahead_z = motion.axle_x * y - motion.axle_y * x
    distance = sqrt(ahead_x * ahead_x + ahead_y * ahead_y + ahead_z * ahead_z)
    along = motion.speed - motion.track_rate * y_track + motion.turn_y * z - motion.turn_z * y
    lateral = (
        motion.lateral
        + (motion.track_rate + motion.turn_z) * x
        - motion.turn_x * z
        - rail.lateral
        + rail.roll * (z_track - rail.z)
    )
    vertical = (
        motion.vertical
        + motion.turn_x * y
        - motion.turn_y * x
        - rail.vertical
        - rail.roll * (y_track - rail.y)
    )
    return (along * ahead_x + lateral * ahead_y + vertical * ahead_z) / distance, ahead_x / distance


def begin_turning(turning: Turning, wanted: float, speed: float):
    """Begin to seek the rotation under the torque ``wanted`` [N m] at this ``speed`` [m/s]; no patch is known
    yet."""
    turning.count = 0
    turning.wanted = wanted
    turning.scale = 0.0
    turning.speed = fabs(speed)
    turning.low = 0.0
    turning.high = 0.0


def enclose_rates(turning: Turning, motion: Motion, patch: Patch):
    """Let the enclosure hold the rates of all strips of a patch; eq. (A1)."""
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        if strip.line_load > 0.0:
            along, ahead = heading_velocity(motion, patch.x_track + strip.x, strip.y_track, strip.z_track)
            enclose_rate(turning, along / strip.rolling_radius)


def enclose_rate(turning: Turning, rate: float):
    """Let the enclosure hold the ``rate`` of a strip [rad/s]."""
    if turning.count == 0:
        turning.low = rate
        turning.high = rate
        turning.count = 1
    turning.low = min(turning.low, rate)
    turning.high = max(turning.high, rate)


def add_stand_in(tables: Tables, turning: Turning, motion: Motion, patch: Patch, friction: float):
    """Add a patch with this coefficient of ``friction`` to the stand-in.  Its lateral force is that of its creepages, over
    the rolling speed of these."""
    if patch.half_width > 0.0 and patch.half_length > 0.0 and turning.count < AXLE_PATCHES:
        own = turning.patches[turning.count]
        turning.count = turning.count + 1
        along, ahead = heading_velocity(motion, patch.x_track, patch.y_track, patch.z_track)
        first, second, third = kalker_coefficients(tables.rolling, patch.half_length / patch.half_width)
        area = patch.half_length * patch.half_width
        own.along = along
        own.radius = patch.rolling_radius
        own.ahead = patch.rolling_radius * ahead
        own.stiffness = tables.shear_modulus * area * first
        own.lateral = (
            tables.shear_modulus
            * area
            * (second * patch.creepage_y + third * sqrt(area) * patch.spin)
            * patch.speed
        )
        own.limit = friction * patch.totals.load
        turning.scale += own.limit * own.radius


def widen_enclosure(turning: Turning):
    """Make both ends of the enclosure a little wider, or with a torque from outside as wide as wheels are let
    to spin; neither is tried yet."""
    size = max(fabs(turning.low), fabs(turning.high))
    wide = MARGIN * size
    if turning.wanted != 0.0:
        largest = 0.0
        for i in range(turning.count):
            largest = max(largest, (turning.speed + SPINNING * REST) / turning.patches[i].radius)
        wide = (SPINNING - 1.0) * max(size, largest)
    turning.low -= wide
    turning.high += wide
    turning.end_low = turning.low
    turning.end_high = turning.high
    reopen_enclosure(turning)


def reopen_enclosure(turning: Turning):
    """Let the enclosure be what it was at first, with neither end tried."""
    turning.low = turning.end_low
    turning.high = turning.end_high
    turning.low_known = False
    turning.high_known = False


def begin_search(turning: Turning, start: float):
    """Begin a search in the enclosure at the rate ``start``."""
    turning.shift = turning.wanted
    turning.slope = 0.0
    turning.reach = 0.0
    turning.missing = 0.0
    turning.rate = start
    turning.torque = 0.0
    turning.turns = 0
    turning.slow = 0
    turning.span = turning.high - turning.low


def patch_stand_in(own: TurningPatch, speed: float, rate: float):
    """Torque of a patch of the stand-in about the axle [N m], and its slope over the rate."""
    rolling = 0.5 * (speed + fabs(rate * own.ahead))
    reference = sqrt(rolling * rolling + REST * REST)
    along = own.stiffness * (own.along - rate * own.radius) / reference
    across = own.lateral / reference
    force = sqrt(along * along + across * across)
    torque = 0.0
    slope = 0.0
    if own.limit > 0.0:
        t = force / own.limit
        share = 1.0 - t / 3.0 + t * t / 27.0
        share_slope = -1.0 / 3.0 + 2.0 * t / 27.0
        if t > 3.0:
            share = 1.0 / t
            share_slope = -share * share
        steep = share
        if force > 0.0:
            steep += along * share_slope * (along / force) / own.limit
        torque = own.radius * along * share
        slope = -own.radius * own.stiffness * own.radius / reference * steep
    return torque, slope


def stand_in(turning: Turning, rate: float):
    """T_s(``rate``) of eq. (A2) [N m], and about its slope."""
    torque = 0.0
    slope = 0.0
    for i in range(turning.count):
        part, part_slope = patch_stand_in(turning.patches[i], turning.speed, rate)
        torque += part
        slope += part_slope
    return torque, slope


def corrected(turning: Turning, rate: float):
    """The left side of eq. (A3) at ``rate``, and its slope."""
    torque, slope = stand_in(turning, rate)
    away = rate - turning.rate
    slope += turning.slope
    if fabs(away) > turning.reach:
        slope -= turning.slope
        if away > 0.0:
            away = turning.reach
        else:
            away = -turning.reach
    return torque + turning.shift + turning.slope * away, slope


def stand_in_rate(turning: Turning):
    """The rate of eq. (A3) within the enclosure, or the end of it that is nearest."""
    low = turning.low
    high = turning.high
    torque, slope = corrected(turning, low)
    if not torque > 0.0:
        return low
    torque, slope = corrected(turning, high)
    if not torque < 0.0:
        return high
    rate = turning.rate
    if not (rate > low and rate < high):
        rate = 0.5 * (low + high)
    for i in range(STEPS):
        torque, slope = corrected(turning, rate)
        if torque > 0.0:
            low = rate
        else:
            high = rate
        following = 0.5 * (low + high)
        if slope < 0.0:
            newton = rate - torque / slope
            if newton > low and newton < high:
                following = newton
        move = fabs(following - rate)
        rate = following
        if not move > STEP_SHARP * fabs(rate):
            return rate
    return rate


def next_rate(turning: Turning):
    """The rate to be tried next."""
    span = turning.high - turning.low
    known = turning.low_known and turning.high_known
    turning.slow = turning.slow + 1
    if not span > 0.5 * turning.span:
        turning.slow = 0
        turning.span = span
    middle = 0.5 * (turning.low + turning.high)
    if turning.slow >= SLOW and known:
        turning.slow = 0
        turning.span = span
        return middle
    rate = stand_in_rate(turning)
    if (rate == turning.low and turning.low_known) or (rate == turning.high and turning.high_known):
        rate = middle
    return rate


def note_torque(turning: Turning, rate: float, torque: float):
    """Keep that the creep forces have this ``torque`` [N m] at ``rate``, and learn from it what the stand-in
    lacks."""
    left = torque + turning.wanted
    model, slope = stand_in(turning, rate)
    missing = torque - model
    turning.slope = 0.0
    if turning.turns > 0 and rate != turning.rate:
        turning.slope = (missing - turning.missing) / (rate - turning.rate)
        if not slope + turning.slope < 0.0:
            turning.slope = 0.0
    turning.reach = 0.0
    if slope + turning.slope < 0.0:
        turning.reach = REACH * fabs(left / (slope + turning.slope))
    turning.turns = turning.turns + 1
    turning.shift = left - model
    turning.missing = missing
    turning.rate = rate
    turning.torque = left
    if left > 0.0:
        if rate >= turning.high:
            # the end was not one
            turning.high = rate + 2.0 * (rate - turning.low) + MARGIN * fabs(rate)
            turning.high_known = False
        turning.low = rate
        turning.low_known = True
    else:
        if rate <= turning.low:
            turning.low = rate - 2.0 * (turning.high - rate) - MARGIN * fabs(rate)
            turning.low_known = False
        turning.high = rate
        turning.high_known = True


def is_balanced(turning: Turning) -> bool:
    """Whether the last rate that was tried leaves no torque."""
    return fabs(turning.torque) <= BALANCED * turning.scale


def is_beyond(turning: Turning) -> bool:
    """Whether wheels that spin as fast as they are let to, or are held as much, do not carry the torque from
    outside."""
    spins = turning.torque > 0.0 and not turning.rate < turning.end_high
    slides = turning.torque < 0.0 and not turning.rate > turning.end_low
    return turning.wanted != 0.0 and (spins or slides)


def is_at_jump(turning: Turning) -> bool:
    """Whether the rates that enclose the one that is sought have become one."""
    size = max(fabs(turning.low), fabs(turning.high))
    apart = turning.high - turning.low
    return turning.low_known and turning.high_known and not apart > SAME_SHARE * size + SAME_RATE
