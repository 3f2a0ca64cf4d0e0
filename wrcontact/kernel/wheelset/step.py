"""One step of a wheelset: from pose and load to contact positions, roll and patches.

The recipe: check the inputs, find the roll at which both wheels touch, describe each contact and
solve its normal contact; for an elastic wheelset, find the height and roll at which both wheels carry
their loads; add up the forces.
"""

from ..layout import (
    INPUT_COUNT,
    MODE_COMPLIANT,
    MODE_ELASTIC,
    MODE_RIGID,
    UNLOADED,
    VALID,
    WORK_INPUTS,
    WORK_OUTPUTS,
    State,
    Tables,
    Work,
)
from ..patch.outline import row_size
from .compliant import solve_compliant
from .elastic import solve_elastic
from .moving import is_rolling, write_creepages
from .requested import check_inputs, omit_outputs, side_force
from .resultant import write_resultant
from .rigid import find_roll, keep_roll, solve_rigid


def evaluate(tables: Tables, work: Work, state: State):
    """Evaluate the wheelset at the workspace's inputs into its outputs; the status."""
    status = check_inputs(tables, work.inputs)
    if status != VALID:
        return status
    work.contact.filling = True
    work.contact.coarse = False
    if tables.mode == MODE_COMPLIANT:
        status = solve_compliant(tables, work, state)
    else:
        roll, status = find_roll(tables, work, state)
        if status != VALID:
            return status
        if tables.mode == MODE_RIGID:
            status = solve_rigid(tables, work, state, roll)
        if status <= UNLOADED:
            keep_roll(work, state, roll)
        if tables.mode == MODE_ELASTIC:
            status = elastic_from_rigid(tables, work, state, roll)
    write_resultant(tables, work.inputs, work.outputs, work.supports[0].resultant, work.supports[1].resultant)
    if is_rolling(work.inputs) == 1:
        write_creepages(tables, work, state)
    omit_outputs(tables, work)
    return status


def elastic_from_rigid(tables: Tables, work: Work, state: State, rigid_roll: float):
    """Elastic contact: the height and roll at which both wheels carry their loads; the outcome."""
    roll, status = solve_elastic(tables, work, state, rigid_roll, side_force(work.inputs, 0),
                                 side_force(work.inputs, 1))
    work.outputs.roll = roll
    work.outputs.vertical_shift = 0.5 * (work.supports[0].height + work.supports[1].height)
    return status


def step_row(tables: Tables, state: State, workspace: Work, inputs: 'float[:]', outputs: 'float[:]',
             row: int):
    """Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status. Inputs as
    before are not evaluated again."""
    changed = 1
    if workspace.known:
        changed = 0
    for i in range(INPUT_COUNT):
        if not workspace[WORK_INPUTS + i] == inputs[INPUT_COUNT * row + i]:
            changed = 1
        workspace[WORK_INPUTS + i] = inputs[INPUT_COUNT * row + i]
    status = workspace.status
    if changed == 1:
        workspace.known = False
        status = evaluate(tables, workspace, state)
    if status <= UNLOADED:
        workspace.known = True
        workspace.status = status
        size = row_size(tables)
        for i in range(size):
            outputs[size * row + i] = workspace[WORK_OUTPUTS + i]
    return status


def step(tables: Tables, state: State, workspace: Work, inputs: 'float[:]', outputs: 'float[:]'):
    """Evaluate one wheelset at ``inputs`` into ``outputs``; the status.

    Outputs keep their values unless the status is VALID or UNLOADED. ``state`` holds where the next roll
    search starts; it never changes an answer.
    """
    return step_row(tables, state, workspace, inputs, outputs, 0)


def step_many(count: int, tables: Tables, state: State, workspace: Work, inputs: 'float[:]',
              outputs: 'float[:]', statuses: 'float[:]'):
    """Evaluate ``count`` rows of inputs, one after the other."""
    for row in range(count):
        statuses[row] = float(step_row(tables, state, workspace, inputs, outputs, row))
    return 0
