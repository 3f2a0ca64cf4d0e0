"""One step of a wheelset on rails whose section changes along the track.

The recipe: check the inputs; search the smallest gaps of both wheels, and for a rigid wheelset the roll at which they are
equal; lay the constant rail that each of them is at this pose, and solve the contact with it; add up all forces.  The report
writes the outputs.
"""

from ..layout import (
    INPUT_COUNT,
    INVALID_INPUT,
    MODE_COMPLIANT,
    MODE_RIGID,
    UNLOADED,
    VALID,
    Inputs,
    State,
    Tables,
    Work,
    offset,
)
from ..elementary.runs import copy_run
from ..patch.outline import row_size
from ..wheelset.report import report
from ..wheelset.input_checks import check_inputs, counted_outcome, is_moving, is_needed, side_force
from ..wheelset.rigid import penetration_status
from ..wheelset.side import clear_side
from ..wheelset.vertical_load import release_friction
from .section_forces import sum_pushes
from .section_report import report_slopes
from .section_roll import find_section_roll, touch_both
from .section_side import load_pressed, load_touching


def check_section_inputs(tables: Tables, inputs: Inputs):
    """The outcome of the inputs: besides what a constant rail forbids, rails that change are not rolled and nothing has a
    velocity."""
    status = check_inputs(tables, inputs)
    if status == VALID:
        if inputs.left_rail_roll != 0.0 or inputs.right_rail_roll != 0.0 or is_moving(tables, inputs):
            status = INVALID_INPUT
    return status


def evaluate_changing(tables: Tables, work: Work):
    """Evaluate the wheelset at the workspace's inputs into its outputs; the status."""
    status = check_section_inputs(tables, work.inputs)
    if status != VALID:
        return status
    release_friction(work)
    work.contact.filling = True
    work.contact.coarse = False
    work.contact.following = False
    clear_side(work.sides[0])
    clear_side(work.sides[1])
    if tables.mode == MODE_COMPLIANT:
        status = stand_compliant(tables, work)
    else:
        status = stand_rigid(tables, work)
    if status <= UNLOADED:
        sum_pushes(tables, work)
        if tables.mode == MODE_RIGID:
            status = penetration_status(tables, work, status)
    if status <= UNLOADED:
        report(tables, work)
        report_slopes(work, 0)
        report_slopes(work, 1)
    return status


def stand_rigid(tables: Tables, work: Work):
    """Both wheels touch, and each carries its load there; the outcome."""
    roll, status = find_section_roll(tables, work)
    if status != VALID:
        return status
    height = 0.5 * (work.touches[0].best + work.touches[1].best)
    work.wheelset.roll = roll
    work.wheelset.vertical_shift = height
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            outcome = load_touching(tables, work, index, work.touches[index].best, side_force(work, index))
            status = counted_outcome(tables, index, status, outcome)
    return status


def stand_compliant(tables: Tables, work: Work):
    """The wheelset at the height and roll of the inputs; the outcome."""
    height = work.inputs.vertical_shift
    work.wheelset.roll = work.inputs.roll
    work.wheelset.vertical_shift = height
    status = touch_both(tables, work, work.inputs.roll)
    if status != VALID:
        return status
    for index in range(2):
        if is_needed(tables, work.inputs, index):
            outcome = load_pressed(tables, work, index, height)
            status = counted_outcome(tables, index, status, outcome)
    return status


def step_changing_row(
    tables: Tables, state: State, workspace: Work, inputs: "float[:]", outputs: "float[:]", row: int
):
    """Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status. Inputs as before are not evaluated again."""
    changed = not workspace.known
    for i in range(INPUT_COUNT):
        if not workspace.inputs[i] == inputs[INPUT_COUNT * row + i]:
            changed = True
        workspace.inputs[i] = inputs[INPUT_COUNT * row + i]
    status = workspace.status
    if changed:
        workspace.known = False
        status = evaluate_changing(tables, workspace)
    if status <= UNLOADED:
        workspace.known = True
        workspace.status = status
        size = row_size(tables)
        copy_run(workspace.raw, offset(workspace.outputs, workspace), outputs, size * row, size)
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
