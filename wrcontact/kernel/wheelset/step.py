"""One step of a wheelset: from pose and load to contact positions, roll and patches.

The recipe: check the inputs, find the roll at which both wheels touch, describe each contact and
solve its normal contact; for an elastic wheelset, find the height and roll at which both wheels carry
their loads. If the wheelset rolls, creepages follow, and from them the creep forces, with the rotation that is
given or that follows from the torque on the axle; all forces are added up.
Where the load is a vertical one, friction carries some of it, and the wheelset is solved again. The report
writes the outputs.
"""

from ..layout import (
    MODE_COMPLIANT,
    MODE_ELASTIC,
    MODE_RIGID,
    NOT_CONVERGED,
    OFF_PROFILE,
    UNLOADED,
    VALID,
    State,
    Tables,
    Work,
)
from ..search.roll import place_both
from .compliant import solve_compliant
from .depth_rates import follow_depths
from .elastic import solve_elastic
from .forces import sum_forces
from .free_rolling import release_rates, roll_freely, turns_freely
from .input_checks import check_inputs, requested_outcome, side_force
from .rolled_rails import (
    ELASTIC_MET,
    MEETINGS,
    has_rolled_rail,
    next_reference,
    note_reference,
    open_reference,
    set_reference,
)
from .rolling_contact import move_patches, move_wheelset, solve_creep_forces
from .report import report
from .rows import keep_row, open_row
from .rigid import find_roll, keep_roll, penetration_status, solve_rigid
from .residuals import turn_to
from .vertical_load import (
    LOAD_PASSES,
    carries_friction,
    is_load_lost,
    is_load_met,
    release_friction,
    share_load,
)


def evaluate(tables: Tables, work: Work, state: State):
    """Evaluate the wheelset at the workspace's inputs into its outputs; the status."""
    status = check_inputs(tables, work.inputs)
    if status != VALID:
        return status
    release_friction(work)
    release_rates(tables, work)
    status = solve_wheelset(tables, work, state)
    if status <= UNLOADED and carries_friction(tables, work):
        status = solve_with_friction(tables, work, state, status)
    if status <= UNLOADED and tables.mode == MODE_RIGID:
        status = penetration_status(tables, work, status)
    if status <= UNLOADED:
        report(tables, work)
    return status


def solve_with_friction(tables: Tables, work: Work, state: State, status: int):
    """Vertical loads of which friction carries a part: the wheelset again, until both are met; the status,
    NOT_CONVERGED where no loads are found."""
    outcome = status
    for i in range(LOAD_PASSES):
        if outcome > UNLOADED or is_load_met(work):
            return outcome
        if is_load_lost(work):
            return NOT_CONVERGED
        share_load(work)
        outcome = solve_wheelset(tables, work, state)
    return NOT_CONVERGED


def solve_wheelset(tables: Tables, work: Work, state: State):
    """Contact of both wheels, their patches' creepages and creep forces, and all forces; the status."""
    status = stand(tables, work, state)
    if status <= UNLOADED:
        move_wheelset(tables, work)
        follow_depths(tables, work)
        outcome = VALID
        if turns_freely(tables, work):
            outcome = roll_freely(tables, work)
        else:
            move_patches(tables, work)
            solve_creep_forces(tables, work)
        status = max(status, outcome)
        sum_forces(tables, work)
    return status


def stand(tables: Tables, work: Work, state: State):
    """Where the wheelset stands, and the patches of both wheels: rigid, elastic or compliant; the status."""
    work.contact.filling = True
    work.contact.coarse = False
    work.contact.following = False
    if tables.mode == MODE_COMPLIANT:
        return solve_compliant(tables, work)
    roll, status = find_roll(tables, work, state)
    if status != VALID:
        return status
    if tables.mode == MODE_RIGID:
        status = solve_rigid(tables, work, roll)
    if status <= UNLOADED:
        keep_roll(work, state, roll)
    if tables.mode == MODE_ELASTIC:
        status = elastic_from_rigid(tables, work, roll)
    return status


def elastic_from_rigid(tables: Tables, work: Work, rigid_roll: float):
    """Elastic contact: the height and roll at which both wheels carry their loads; the outcome."""
    roll, status = solve_elastic(tables, work, rigid_roll, side_force(work, 0), side_force(work, 1))
    if status <= UNLOADED and has_rolled_rail(work.sides):
        roll, status = meet_rolled_rails(tables, work, rigid_roll)
    work.wheelset.roll = roll
    work.wheelset.vertical_shift = support_height(work)
    return requested_outcome(tables, work, status)


def support_height(work: Work):
    """The height of a wheelset in equilibrium [m]: both sides' mean, which differ by rounding."""
    return 0.5 * (work.supports[0].height + work.supports[1].height)


def meet_rolled_rails(tables: Tables, work: Work, rigid_roll: float):
    """Roll [rad] and outcome in elastic equilibrium over rolled rails, sought together with the vertical
    shift; the equilibrium for the rigid height as reference is known."""
    roll = rigid_roll
    open_reference(work.reference, work.sides[1].place.reference, support_height(work))
    for i in range(MEETINGS):
        height = next_reference(work.reference, ELASTIC_MET)
        set_reference(work.sides, height)
        place_both(tables, work.inputs, work.sides, rigid_roll)
        if not turn_to(tables, work, rigid_roll):
            return roll, OFF_PROFILE
        roll, status = solve_elastic(tables, work, rigid_roll, side_force(work, 0), side_force(work, 1))
        if status > UNLOADED:
            return roll, status
        if note_reference(work.reference, height, support_height(work), ELASTIC_MET):
            return roll, status
    return roll, NOT_CONVERGED


def step_row(
    tables: Tables, state: State, workspace: Work, inputs: "float[:]", outputs: "float[:]", row: int
):
    """Evaluate row ``row`` of ``inputs`` into that of ``outputs``; the status. Inputs as
    before are not evaluated again."""
    status = workspace.status
    if open_row(workspace, inputs, row):
        status = evaluate(tables, workspace, state)
    keep_row(tables, workspace, outputs, row, status)
    return status


def step(tables: Tables, state: State, workspace: Work, inputs: "float[:]", outputs: "float[:]"):
    """Evaluate one wheelset at ``inputs`` into ``outputs``; the status.

    Outputs keep their values unless the status is VALID or UNLOADED. ``state`` holds where the next roll
    search starts; it never changes an answer.
    """
    return step_row(tables, state, workspace, inputs, outputs, 0)


def step_many(
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
        statuses[row] = float(step_row(tables, state, workspace, inputs, outputs, row))
