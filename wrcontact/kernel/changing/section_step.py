"""One step of a wheelset on rails whose section changes along the track.

The recipe: check the inputs; search the smallest gaps of both wheels, and for a rigid wheelset the roll at which they are
equal, for an elastic one height and roll at which both carry their loads; lay the constant rail that each of them is at this
pose, and solve the contact with it; if the wheelset rolls, creepages and creep forces follow as on constant rails; add up all
forces.  The report writes the outputs.
"""

from ..layout import (
    INVALID_INPUT,
    LOAD_VERTICAL,
    MODE_COMPLIANT,
    MODE_ELASTIC,
    MODE_RIGID,
    NOT_CONVERGED,
    UNLOADED,
    VALID,
    Inputs,
    State,
    Tables,
    Work,
)
from ..wheelset.free_rolling import release_rates, roll_freely, turns_freely
from ..wheelset.input_checks import check_inputs, counted_status, is_needed, side_force
from ..wheelset.prescribed_height import is_damped
from ..wheelset.report import report
from ..wheelset.rigid import penetration_status
from ..wheelset.rolling_contact import solve_creep_forces
from ..wheelset.rows import keep_row, open_row
from ..wheelset.side import begin_trial, clear_side
from ..wheelset.vertical_load import (
    LOAD_PASSES,
    is_load_lost,
    is_load_met,
    release_friction,
    share_load,
)
from .section_elastic import find_section_rates, stand_elastic
from .section_forces import sum_pushes
from .section_motion import move_changing, move_changing_patches, open_changing_motion
from .section_report import report_slopes
from .section_roll import find_section_roll, place_touches, touch_rail
from .section_side import load_pressed, load_touching


def check_section_inputs(tables: Tables, inputs: Inputs):
    """The status of the inputs: besides what a constant rail forbids, rails that change do not roll, and rollers have no
    curve."""
    status = check_inputs(tables, inputs)
    if status == VALID:
        if inputs.track_curvature != 0.0 and (tables.pairs[0].roller > 0.0 or tables.pairs[1].roller > 0.0):
            status = INVALID_INPUT
        if inputs.left_rail_roll != 0.0 or inputs.right_rail_roll != 0.0:
            status = INVALID_INPUT
        if inputs.left_rail_roll_velocity != 0.0 or inputs.right_rail_roll_velocity != 0.0:
            status = INVALID_INPUT
    return status


def evaluate_changing(tables: Tables, work: Work):
    """Evaluate the wheelset at the workspace's inputs into its outputs; the status."""
    status = check_section_inputs(tables, work.inputs)
    if status != VALID:
        return status
    release_friction(work)
    release_rates(tables, work)
    status = solve_changing(tables, work)
    if status <= UNLOADED and tables.load == LOAD_VERTICAL and tables.mode != MODE_COMPLIANT:
        status = carry_loads(tables, work, status)
    if status <= UNLOADED and tables.mode == MODE_RIGID:
        status = penetration_status(tables, work, status)
    if status <= UNLOADED:
        report(tables, work)
        report_slopes(work, 0)
        report_slopes(work, 1)
    return status


def carry_loads(tables: Tables, work: Work, status: int):
    """Vertical loads of which friction carries a part, and of patches whose normals lean: the wheelset again, until both are
    met (wheelset/vertical_load.py); the status, NOT_CONVERGED where no loads are found."""
    for i in range(LOAD_PASSES):
        if status > UNLOADED or is_load_met(work):
            return status
        if is_load_lost(work):
            return NOT_CONVERGED
        share_load(work)
        status = solve_changing(tables, work)
    return NOT_CONVERGED


def solve_changing(tables: Tables, work: Work):
    """Contact of both wheels, their patches' creepages and creep forces, and all forces; the status."""
    begin_trial(work.contact, True, False, False)
    clear_side(work.sides[0])
    clear_side(work.sides[1])
    if tables.mode == MODE_COMPLIANT:
        status = stand_compliant(tables, work)
    elif tables.mode == MODE_ELASTIC:
        status = find_section_rates(tables, work)
        if status <= UNLOADED:
            status = stand_elastic(tables, work)
    else:
        status = stand_rigid(tables, work)
    if status <= UNLOADED:
        move_changing(tables, work)
        rolling_status = VALID
        if turns_freely(tables, work):
            rolling_status = roll_freely(tables, work)
        else:
            move_changing_patches(tables, work)
            solve_creep_forces(tables, work)
        status = max(status, rolling_status)
        sum_pushes(tables, work)
    return status


def stand_rigid(tables: Tables, work: Work):
    """Both wheels touch, and each carries its load there; the status."""
    roll, status = find_section_roll(tables, work)
    if status != VALID:
        return status
    height = 0.5 * (work.touches[0].best + work.touches[1].best)
    work.wheelset.roll = roll
    work.wheelset.vertical_shift = height
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            side_status = load_touching(
                tables, work, index, work.touches[index].best, side_force(work, index)
            )
            status = counted_status(tables, index, status, side_status)
    return status


def stand_compliant(tables: Tables, work: Work):
    """The wheelset at the height and roll of the inputs; the status."""
    height = work.inputs.vertical_shift
    work.wheelset.roll = work.inputs.roll
    work.wheelset.vertical_shift = height
    if is_damped(tables):
        open_changing_motion(tables, work)
    place_touches(tables, work.inputs, work, work.inputs.roll)
    status = VALID
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            status = max(status, touch_rail(tables, work, index))
    if status != VALID:
        return status
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            side_status = load_pressed(tables, work, index, height)
            status = counted_status(tables, index, status, side_status)
    return status


def step_changing_row(
    tables: Tables, state: State, workspace: Work, inputs: "float[:]", outputs: "float[:]", row: int
):
    """Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status. Inputs as before are not evaluated again."""
    status = workspace.status
    if open_row(workspace, inputs, row):
        status = evaluate_changing(tables, workspace)
    keep_row(tables, workspace, outputs, row, status)
    return status


def step_changing(tables: Tables, state: State, workspace: Work, inputs: "float[:]", outputs: "float[:]"):
    """Evaluate one wheelset at ``inputs`` into ``outputs``; the status, as wheelset/step.py. The rails of the pose are written
    to ``tables``, which are the stepper's own; no answer depends on the step before."""
    return step_changing_row(tables, state, workspace, inputs, outputs, 0)


def step_changing_many(
    count: int,
    tables: Tables,
    state: State,
    workspace: Work,
    inputs: "float[:]",
    outputs: "float[:]",
    statuses: "float[:]",
):
    """Evaluate ``count`` rows of inputs, one after the other."""
    for row in range(count):
        statuses[row] = float(step_changing_row(tables, state, workspace, inputs, outputs, row))
