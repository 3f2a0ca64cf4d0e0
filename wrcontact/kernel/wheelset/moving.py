"""The motion of a wheelset whose contact is solved: its velocities, and the creepages of its patches."""

from ..layout import MODE_COMPLIANT, MODE_ELASTIC, TANGENTIAL_NONE, State, Tables, Work
from ..motion.contact_rates import constrain_loaded, constrain_touching, set_contact_rates
from ..motion.creepage import STANDSTILL, move_patch, move_strips
from ..motion.wheelset_motion import open_left_rail, open_motion, open_right_rail, set_rates
from .forces import sum_side
from .requested import is_requested, is_rolling
from .side import touch_side


def open_given_motion(left_tables: Tables, right_tables: Tables, work: Work):
    """The motion as the inputs give it, at the wheelset's pose."""
    left = work.sides[0].motion
    right = work.sides[1].motion
    open_motion(right_tables, left, work.inputs, work.wheelset, -1.0)
    open_motion(right_tables, right, work.inputs, work.wheelset, 1.0)
    open_left_rail(left_tables, left.rail, work.inputs)
    open_right_rail(right_tables, right.rail, work.inputs)
    set_rates(left, right, work.inputs, work.inputs.vertical_velocity, work.inputs.roll_rate)


def move_patches(left_tables: Tables, right_tables: Tables, work: Work, state: State):
    """Creepages of all patches and their strips, if the wheelset rolls; in compliant contact vertical
    velocity and roll rate are given, otherwise they follow from contact with both rails."""
    if not is_rolling(work.inputs):
        return
    open_given_motion(left_tables, right_tables, work)
    if right_tables.mode != MODE_COMPLIANT:
        constrain_side(left_tables, work, state, 0)
        constrain_side(right_tables, work, state, 1)
        set_contact_rates(work.sides[0].motion, work.sides[1].motion, work.inputs)
    for index in range(2):
        side = work.sides[index]
        for number in range(side.patch_count):
            patch = side.patches[number]
            move_patch(side.motion, patch)
            if right_tables.tangential != TANGENTIAL_NONE and patch.speed > STANDSTILL:
                move_strips(side.motion, patch)


def constrain_side(tables: Tables, work: Work, state: State, index: int):
    """What keeps the wheel of side ``index`` on its rail: the normal where it touches, or its force if it is
    elastic and carries a load."""
    side = work.sides[index]
    if tables.mode == MODE_ELASTIC and side.patch_count > 0:
        sum_side(side, False)
        constrain_loaded(side.motion, side.forces)
    else:
        if not is_requested(tables, index):
            touch_side(tables, work, state, index)
        constrain_touching(side.motion, side.point)
