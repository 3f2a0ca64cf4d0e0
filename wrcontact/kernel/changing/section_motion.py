"""The velocities of a wheelset on rails whose section changes.

Where wheel and rail do not approach each other, eq. (A4) of creep/leaning.py says which vertical velocity and roll rate a
rigid wheelset has.  In the frame of the track, which moves along, a rail with the slope z_u comes down with the speed z_u V:
what the normal's part along the track adds is that of a rail with this vertical velocity, and so does a wheel that is not round
as it turns.

A roller turns below a wheelset that stays where it is: with the radius R its surface runs back with the speed V, that of the
inputs, at the highest place, and with (V / R) (R - z) elsewhere.  It comes neither up nor down.
"""

from ..creep.motion import open_left_rail, open_right_rail, set_contact_rates
from ..layout import MODE_COMPLIANT, Motion, Pair, SectionTouch, Tables, Work
from ..wheelset.input_checks import is_moving
from ..wheelset.leaning_wheel import move_wheel
from ..wheelset.rolling_contact import open_given_motion


def move_changing(tables: Tables, work: Work):
    """The velocities of the wheelset, if it rolls: those of the inputs, or in rigid contact those with which both wheels stay on
    their rails."""
    if not is_moving(tables, work.inputs):
        return
    open_changing_motion(tables, work)
    if tables.mode != MODE_COMPLIANT:
        left = work.sides[0].motion
        right = work.sides[1].motion
        constrain_touch(tables.pairs[0], left, work.touches[0])
        constrain_touch(tables.pairs[1], right, work.touches[1])
        set_contact_rates(left, right)
        open_left_rail(tables.pairs[0], left.rail, work.inputs)
        open_right_rail(tables.pairs[1], right.rail, work.inputs)


def open_changing_motion(tables: Tables, work: Work):
    """The motion as the inputs give it, with rollers that turn."""
    open_given_motion(tables, work)
    for index in range(2):
        roller = tables.pairs[index].roller
        rail = work.sides[index].motion.rail
        rail.turn = 0.0
        if roller > 0.0:
            rail.turn = work.inputs.speed / roller
            rail.axle_x = -work.inputs.track_position
            rail.axle_z = roller
            if index == 0:
                rail.axle_z += work.inputs.left_rail_vertical
            else:
                rail.axle_z += work.inputs.right_rail_vertical


def constrain_touch(pair: Pair, motion: Motion, touch: SectionTouch):
    """The normal of the place where a rigid wheel touches its rail keeps it there; the rail comes down as it changes."""
    constraint = motion.constraint
    x = touch.rail_x
    y = touch.rail_y + touch.place.rail_lateral - motion.centre_y
    z = touch.rail_z + touch.place.rail_vertical - motion.centre_z
    constraint.y = touch.slope
    constraint.z = -1.0
    constraint.moment_x = -y - z * touch.slope
    constraint.moment_y = z * touch.along + x
    constraint.moment_z = x * touch.slope - y * touch.along
    if not pair.roller > 0.0:
        motion.rail.vertical += touch.along * motion.speed
    motion.rail.vertical += touch.turn_rate * motion.wheel_rate


def move_changing_patches(tables: Tables, work: Work):
    """Creepages of all patches and their strips, if the wheelset rolls."""
    if is_moving(tables, work.inputs):
        move_wheel(tables, work, 0)
        move_wheel(tables, work, 1)
