"""The motion of a wheelset whose contact is solved: its velocities, and the creepages of its patches."""

from ..layout import MODE_COMPLIANT, MODE_ELASTIC, Inputs, State, Tables, Work
from ..motion.contact_rates import contact_rates, loaded_constraint, touching_constraint
from ..motion.creepage import write_side_creepages
from ..motion.wheelset_motion import open_motion, open_rails, set_rates
from .requested import is_requested
from .side import touch_side


def is_rolling(inputs: Inputs):
    """1 if the wheelset runs or its wheels turn, else 0: then there are no creepages."""
    rolling = 0
    if inputs.speed != 0.0 or inputs.wheel_rate != 0.0:
        rolling = 1
    return rolling


def open_given_motion(left_tables: Tables, right_tables: Tables, work: Work):
    """The motion as the inputs give it, at the pose of the outputs."""
    open_motion(right_tables, work.motion, work.inputs, work.outputs)
    open_rails(left_tables, right_tables, work.motion, work.inputs)
    set_rates(work.motion, work.inputs, work.inputs.vertical_velocity, work.inputs.roll_rate)
    return 0


def write_creepages(left_tables: Tables, right_tables: Tables, work: Work, state: State):
    """Creepages of all patches in the outputs; in compliant contact vertical velocity and roll rate are
    given, otherwise they follow from contact with both rails."""
    motion = work.motion
    open_given_motion(left_tables, right_tables, work)
    if right_tables.mode != MODE_COMPLIANT:
        constrain_side(left_tables, work, state, 0)
        constrain_side(right_tables, work, state, 1)
        vertical, roll_rate = contact_rates(motion, work.inputs)
        set_rates(motion, work.inputs, vertical, roll_rate)
    for index in range(2):
        write_side_creepages(motion, motion.rails[index], work.outputs.left[index], float(2 * index - 1))
    return 0


def constrain_side(tables: Tables, work: Work, state: State, index: int):
    """What keeps the wheel of side ``index`` on its rail: the normal where it touches, or its force if it is
    elastic and carries a load."""
    motion = work.motion
    out = work.outputs.left[index]
    if tables.mode == MODE_ELASTIC and out.force[2] != 0.0:
        loaded_constraint(out, motion.constraints[index])
    else:
        if is_requested(tables, index) == 0:
            touch_side(tables, work, state, index)
        touching_constraint(motion, out, float(2 * index - 1), motion.constraints[index])
    return 0
