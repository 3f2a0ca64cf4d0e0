"""The report of a step: the only place where outputs are written.

Outputs of the left wheel are mirrored here.  On the right the creepages of the outputs have the opposite
signs of the patch's lateral creepage and spin, and so have their moments: they hold for y to the left and the
normal from the rail to the wheel on both sides.  Where nothing rolls there is no rolling speed to refer
creepages and wear numbers to: they are zero, also where a wheelset slides.
"""

from math import sqrt
from typing import Final

from ..layout import (
    DEPTH_GEOMETRY,
    DEPTH_PATCHES,
    PATCH_LIMIT,
    ROLLING_STRIP_LIMIT,
    RUN_COUNT,
    SIDES_BOTH,
    SIDE_PENETRATION,
    SIDE_SIZE,
    SIDE_STATION,
    STATION_COUNT,
    STRIP_OUTPUTS_SIZE,
    WEAR_RUN_COUNT,
    WEAR_STRIPS,
    ContactPoint,
    Outline,
    Patch,
    PatchOutputs,
    SideOutputs,
    SideSearch,
    StripOutputs,
    Tables,
    Vector,
    WearRuns,
    Work,
    clear,
    copy,
    offset,
    seldom,
)
from ..patch.outline import wear_place
from ..surface.rails import on_springs
from .fatigue import shakedown_ratio, wear_number_damage
from .distributed_power import distribute_power
from .input_checks import has_creep_forces, is_requested, is_rolling
from .rolling_contact import strip_slip

#: Runs of an outline that are there without friction: stations, half-lengths and pressures.
OUTLINE_RUNS: Final[int] = 3


def report(tables: Tables, work: Work):
    """Write the outputs that are requested, and what stands for those that are not."""
    outputs = work.outputs
    outputs.roll = work.wheelset.roll
    outputs.vertical_shift = work.wheelset.vertical_shift
    forces = work.wheelset.forces
    write_vector(outputs.force, forces.force, 1.0, 1.0)
    write_vector(outputs.moment, forces.moment, 1.0, 1.0)
    write_vector(outputs.normal_part, forces.normal_force, 1.0, 1.0)
    write_vector(outputs.normal_moment, forces.normal_moment, 1.0, 1.0)
    outputs.driving_torque = forces.driving_torque
    for index in range(2):
        report_side(tables, work, index)
    if tables.sides != SIDES_BOTH or tables.depth == DEPTH_GEOMETRY:
        # the resultant is that of both sides and their loads
        for i in range(3):
            outputs.force[i] = tables.absent
            outputs.moment[i] = tables.absent
            outputs.normal_part[i] = tables.absent
            outputs.normal_moment[i] = tables.absent
        outputs.driving_torque = tables.absent


def found_rate(tables: Tables, work: Work, index: int):
    """The rotation that the creepages of side ``index`` hold for [rad/s]."""
    rate = 0.0
    if is_rolling(tables, work.inputs) or has_creep_forces(tables, work):
        rate = work.sides[index].motion.wheel_rate
    return rate


def report_side(tables: Tables, work: Work, index: int):
    """The outputs of side ``index``."""
    side = work.sides[index]
    out = work.outputs.left[index]
    mirror = float(2 * index - 1)
    first = first_omitted(tables, index)
    if first > 0:
        report_point(side.point, out, mirror)
    if first > SIDE_PENETRATION:
        rolling = is_rolling(tables, work.inputs)
        report_load(side, out, mirror, rolling)
        out.wheel_rate_found = found_rate(tables, work, index)
        out.model_error = side.model_error
        report_deflection(tables, side, out, mirror)
        report_patches(side, out, mirror, rolling)
        if tables.fatigue:
            report_fatigue(side, out, tables.parameters.yield_shear, rolling)
    for i in range(first, SIDE_SIZE):
        out[i] = tables.absent
    if first <= SIDE_PENETRATION:
        out.patch_count = tables.absent
    if tables.stations != STATION_COUNT:
        for i in range(SIDE_STATION, first):
            out[i] = 0.0
    outline = Outline.at(work, outline_place(tables, work, index))
    if first > SIDE_STATION:
        report_outline(side, outline, tables.stations, has_creep_forces(tables, work))
    else:
        for i in range(RUN_COUNT * tables.stations):
            outline.numbers[i] = tables.absent
    if tables.wear:
        report_wear(tables, work, index, first > SIDE_STATION)


def first_omitted(tables: Tables, index: int):
    """The first of the outputs of side ``index`` that is not requested; SIDE_SIZE if all are."""
    first = SIDE_SIZE
    if tables.depth == DEPTH_PATCHES:
        first = SIDE_STATION
    if tables.depth == DEPTH_GEOMETRY:
        first = SIDE_PENETRATION
    if not is_requested(tables, index):
        first = 0
    return first


def report_point(point: ContactPoint, out: SideOutputs, mirror: float):
    """Where a wheel touches."""
    out.x_wheel = point.x_wheel
    out.y_wheel = point.y_wheel
    out.z_wheel = point.z_wheel
    out.y_rail = point.y_rail
    out.z_rail = point.z_rail
    out.x_track = point.x_track
    out.y_track = mirror * point.y_track
    out.z_track = point.z_track
    out.contact_angle = point.contact_angle
    out.rolling_radius = point.rolling_radius
    out.curvature_x = point.curvature_x
    out.curvature_y = point.curvature_y


def report_load(side: SideSearch, out: SideOutputs, mirror: float, rolling: bool):
    """How a wheel carries its load: totals and forces."""
    totals = side.totals
    out.patch_count = float(side.patch_count)
    out.penetration = side.penetration
    out.normal_force = totals.load
    out.area = totals.area
    out.max_pressure = totals.max_pressure
    out.patch_length = 2.0 * totals.max_half_length
    out.patch_width = totals.width
    out.patch_centroid = totals.centroid
    forces = side.forces
    write_vector(out.force, forces.force, 1.0, mirror)
    write_vector(out.moment, forces.moment, mirror, 1.0)
    write_vector(out.normal_part, forces.normal_force, 1.0, mirror)
    write_vector(out.normal_moment, forces.normal_moment, mirror, 1.0)
    out.friction_power = forces.friction_power
    out.wear_number = 0.0
    if rolling:
        out.wear_number = forces.wear_number
    out.driving_torque = forces.driving_torque
    out.damping_power = forces.damping_power
    # Y over Q, outwards over downwards, both on the rail
    out.derailment_quotient = 0.0
    if forces.force[2] < 0.0:
        out.derailment_quotient = forces.force[1] / forces.force[2]


def report_deflection(tables: Tables, side: SideSearch, out: SideOutputs, mirror: float):
    """How far the rail stands from the foot of its springs."""
    out.rail_deflection_lateral = 0.0
    out.rail_deflection_vertical = 0.0
    if on_springs(tables):
        out.rail_deflection_lateral = mirror * side.deflection.lateral + 0.0
        out.rail_deflection_vertical = side.deflection.vertical + 0.0


def report_patches(side: SideSearch, out: SideOutputs, mirror: float, rolling: bool):
    """The heaviest patches of a wheel by falling load, and zeros for missing ones."""
    for rank in range(side.patch_count, PATCH_LIMIT):
        clear(out.patch[rank])
    for number in range(side.patch_count):
        rank = side.patches[number].rank
        if rank == 0 and number < PATCH_LIMIT:
            clear(out.patch[number])
        elif rank > 0 and rank <= PATCH_LIMIT:
            report_patch(side.patches[number], out.patch[rank - 1], mirror, rolling)


def report_patch(patch: Patch, out: PatchOutputs, mirror: float, rolling: bool):
    """One patch."""
    totals = patch.totals
    out.normal_force = totals.load
    out.area = totals.area
    out.max_pressure = totals.max_pressure
    out.length = 2.0 * totals.max_half_length
    out.width = totals.width
    out.centroid = totals.centroid
    out.contact_angle = patch.contact_angle
    out.penetration = patch.penetration
    out.rolling_radius = patch.rolling_radius
    out.x_track = patch.x_track
    out.y_track = mirror * patch.y_track
    out.z_track = patch.z_track
    write_vector(out.force, patch.forces.force, 1.0, mirror)
    out.creepage_x = 0.0
    out.creepage_y = 0.0
    out.spin = 0.0
    if rolling:
        out.creepage_x = patch.creepage_x
        out.creepage_y = 0.0 - mirror * patch.creepage_y
        out.spin = 0.0 - mirror * patch.spin
    out.creep_force_x = patch.creep_x
    out.creep_force_y = patch.creep_y
    out.creep_moment = 0.0 - mirror * patch.creep_moment
    out.stick_share = patch.stick_share
    out.max_shear = patch.max_shear
    out.friction_power = patch.forces.friction_power
    out.saturation = patch.saturation
    out.wear_number = 0.0
    out.fatigue_damage = 0.0
    out.shakedown_ratio = 0.0
    out.surface_fatigue_index = 0.0
    out.slope = 0.0


@seldom
def report_fatigue(side: SideSearch, out: SideOutputs, yield_shear: float, rolling: bool):
    """The outputs of fatigue of a wheel, for this yield stress in cyclic shear [Pa]."""
    for number in range(side.patch_count):
        patch = side.patches[number]
        if patch.rank > 0 and patch.rank <= PATCH_LIMIT:
            found = out.patch[patch.rank - 1]
            if rolling:
                found.wear_number = patch.forces.wear_number
                found.fatigue_damage = wear_number_damage(patch.forces.wear_number)
            ratio = shakedown_ratio(patch, yield_shear)
            found.shakedown_ratio = ratio
            if ratio > 0.0:
                force = sqrt(patch.creep_x * patch.creep_x + patch.creep_y * patch.creep_y)
                found.surface_fatigue_index = force / patch.totals.load - 1.0 / ratio


def write_vector(out: Vector, vector: Vector, plane: float, across: float):
    """Write a vector, x and z with the sign ``plane`` and y with the sign ``across``; zeros are positive."""
    out[0] = plane * vector[0] + 0.0
    out[1] = across * vector[1] + 0.0
    out[2] = plane * vector[2] + 0.0


def outline_place(tables: Tables, work: Work, index: int):
    """Offset in the workspace of the outline of side ``index``: among its outputs, or for another number of
    stations behind those of both sides."""
    place = offset(work.outputs.left[index].station, work)
    if tables.stations != STATION_COUNT:
        place = offset(work.outlines[0], work) + RUN_COUNT * tables.stations * index
    return place


def report_outline(side: SideSearch, outline: Outline, stations: int, with_creep: bool):
    """The outline of a side, with shear and slip if ``with_creep``."""
    known = 0
    if side.patch_count > 0:
        known = OUTLINE_RUNS * stations
        if with_creep:
            known = RUN_COUNT * stations
    for i in range(known):
        outline.numbers[i] = side.outline.numbers[i]
    for i in range(known, RUN_COUNT * stations):
        outline.numbers[i] = 0.0


@seldom
def report_wear(tables: Tables, work: Work, index: int, requested: bool):
    """The outputs of wear of side ``index``, if they are ``requested``."""
    side = work.sides[index]
    runs = WEAR_RUN_COUNT * tables.stations
    first = offset(work.outputs, work) + wear_place(tables)
    found = WearRuns.at(work, first + runs * index)
    strips = first + 2 * runs + WEAR_STRIPS * index
    work[first + 2 * runs + 2 * WEAR_STRIPS] = 0.0
    if not requested:
        for i in range(runs):
            found.numbers[i] = tables.absent
        for i in range(WEAR_STRIPS):
            work[strips + i] = tables.absent
        return
    for i in range(runs):
        found.numbers[i] = 0.0
    for rank in range(PATCH_LIMIT):
        clear(StripOutputs.at(work, strips + STRIP_OUTPUTS_SIZE * rank))
    if side.patch_count > 0:
        distribute_power(side, tables.stations)
        for i in range(runs):
            found.numbers[i] = side.wear.numbers[i]
        for number in range(side.patch_count):
            patch = side.patches[number]
            if patch.rank > 0 and patch.rank <= PATCH_LIMIT:
                complete_strips(patch, side.worn[number], has_creep_forces(tables, work))
                copy(side.worn[number], StripOutputs.at(work, strips + STRIP_OUTPUTS_SIZE * (patch.rank - 1)))


@seldom
def complete_strips(patch: Patch, worn: StripOutputs, with_creep: bool):
    """What the strips of a patch have beside places and power, with slip if ``with_creep``."""
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        worn.width[i] = strip.width
        worn.line_load[i] = strip.line_load
        worn.half_length[i] = strip.half_length
        worn.slip[i] = 0.0
        if with_creep:
            worn.slip[i] = strip_slip(patch, strip)
