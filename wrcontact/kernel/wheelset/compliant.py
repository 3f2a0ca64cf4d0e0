"""Compliant contact: height and roll of the wheelset are given, and each wheel's load follows from how deep
it is in its rail (prescribed_height.py), which may stand on springs (springs.py)."""

from ..layout import OFF_PROFILE, UNLOADED, VALID, Tables, Work, seldom
from ..search.roll import nearest_start, place_both
from ..surface.rails import is_sprung
from .prescribed_height import is_damped, load_at_height, search_near
from .rolled_rails import set_reference
from .input_checks import counted_status, is_needed
from .rolling_contact import open_given_motion
from .rail_deflection import equilibrate_again, equilibrate_rail
from .side import clear_side
from .springs import rest_rail


@seldom
def solve_compliant(tables: Tables, work: Work):
    """The requested sides of the wheelset at the height and roll of the inputs; the status."""
    roll = work.inputs.roll
    height = work.inputs.vertical_shift
    set_reference(work.sides, height)
    if tables.sprung:
        rest_rail(tables, work, 0)
        rest_rail(tables, work, 1)
    place_both(tables, work.inputs, work.sides, roll)
    work.wheelset.roll = roll
    work.wheelset.vertical_shift = height
    if is_damped(tables):
        open_given_motion(tables, work)
    if not search_requested(tables, work):
        return OFF_PROFILE
    status = VALID
    clear_side(work.sides[0])
    clear_side(work.sides[1])
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            side_status = load_standing(tables, work, index, height)
            status = counted_status(tables, index, status, side_status)
    return status


@seldom
def search_requested(tables: Tables, work: Work) -> bool:
    """Search the smallest gaps of the requested sides, each by itself; whether their wheels are above their
    rails."""
    row = nearest_start(tables.starts, work.inputs.lateral_shift)
    above = True
    if is_needed(tables, work.inputs, 0):
        above = search_near(tables, work, 0, row)
    if is_needed(tables, work.inputs, 1) and not search_near(tables, work, 1, row):
        above = False
    return above


@seldom
def load_standing(tables: Tables, work: Work, index: int, height: float):
    """The load of a requested side at ``height`` [m], whose rail is rigid or has settled on its springs; its
    status."""
    if is_sprung(tables, index):
        return equilibrate_rail(tables, work, index, height)
    return load_at_height(tables, work, index, height)


@seldom
def turn_compliant(tables: Tables, work: Work, index: int):
    """A side of the wheelset that is solved, with its wheel turning at another rate: its rail on springs
    settles again; the status."""
    height = work.inputs.vertical_shift
    if not (is_sprung(tables, index) and is_needed(tables, work.inputs, index)):
        return VALID
    status = equilibrate_again(tables, work, index, height)
    if status > UNLOADED:
        status = equilibrate_anew(tables, work, index)
    return status


@seldom
def equilibrate_anew(tables: Tables, work: Work, index: int):
    """A side of the wheelset that is solved, whose rail settles on its springs from rest on; the status."""
    rest_rail(tables, work, index)
    place_both(tables, work.inputs, work.sides, work.inputs.roll)
    if not search_near(tables, work, index, nearest_start(tables.starts, work.inputs.lateral_shift)):
        return OFF_PROFILE
    return equilibrate_rail(tables, work, index, work.inputs.vertical_shift)


@seldom
def leave_jumps(tables: Tables, work: Work, first: int, last: int):
    """Let the rails of the sides ``first`` ... ``last`` that stand at a jump of their forces settle from rest on,
    since with other creep forces they may stand elsewhere in balance; whether there were any, and the status."""
    left = False
    status = VALID
    for index in range(first, last + 1):
        settled = work.settled[index]
        needed = is_sprung(tables, index) and is_needed(tables, work.inputs, index)
        if needed and settled.standing and not settled.lifted:
            left = True
            status = max(status, equilibrate_anew(tables, work, index))
    return left, status
