"""One wheel on a rail whose section changes: its contact on the constant rail that this one is at its pose, turned back into
the track."""

from math import fabs, sqrt
from typing import Final

from ..elementary.circle import atan, atan2
from ..layout import (
    DEPTH_GEOMETRY,
    LOAD_VERTICAL,
    NOT_CONVERGED,
    OFF_PROFILE,
    ROLLING_STRIP_LIMIT,
    TANGENTIAL_NONE,
    UNLOADED,
    VALID,
    Leaning,
    LeaningPatch,
    Pair,
    Patch,
    Place,
    SectionFrame,
    Sections,
    SectionTouch,
    SideSearch,
    Tables,
    Work,
)
from ..search.roll import follow_side
from ..search.smallest_gap import search_side
from ..sections.section_surface import section_jet, section_ruling
from ..sections.wheel_radius import within_turn
from ..surface.locus import outline_point, outline_x
from ..surface.tables import height_slope
from ..wheelset.input_checks import has_wear
from ..wheelset.leaning_wheel import leaning_place
from ..wheelset.prescribed_height import GRAZING, is_damped
from ..wheelset.side import load_side, lower_wheel, solve_side, touch_side
from ..wheelset.residuals import DEEPEST
from .section_damping import damp_leaning_patches
from .nearest_places import valley_at
from .one_valley import has_one_valley
from .rail_at_pose import write_rail_at_pose
from .section_frame import into_track, open_section_frame, place_in_frame, point_in_track, wheel_turn
from .section_wear import turn_wear
from .bridges import BESIDE, direction_between, is_oblique
from .facing_lines import ALL, follow_valley

#: The middle of a patch may lie so far off the rail [m]: it is a mean over a patch that may be round.
OFF_RAIL: Final[float] = 2e-4
#: The frame is turned so often, with what is then known of the parts.
TURNS: Final[int] = 2
#: The rail is laid up to gaps of this many times the overlap: what is close to the patch shapes it, too.
BEYOND_DEPTH: Final[float] = 6.0
#: At first it is laid up to this gap [m], and all of it where that is not enough or the wheel may overlap it farther away.
NEAR: Final[float] = 8e-4


def lay_rail(tables: Tables, work: Work, index: int, height: float, far: float, depth: float) -> bool:
    """Lay the frame of side ``index`` whose wheelset has the vertical shift ``height`` [m], and the constant rail in it, up to
    gaps of ``far`` [m]; whether there is one.  Where parts beyond grooves carry, too, once it is lowered by another ``depth`` [m],
    the frame lies between their directions."""
    pair = tables.pairs[index]
    touch = work.touches[index]
    position = work.inputs.track_position
    q = section_ruling(pair.sections, position + touch.rail_x, touch.rail_y - pair.sections.lateral)
    if not lay_lines(pair, work, index, height, far, q):
        return False
    for turn in range(TURNS):
        count, between = direction_between(pair.sections, depth)
        if pair.sections.bridged and count > 1:
            if not lay_lines(pair, work, index, height, far, between):
                return False
    return write_rail_at_pose(tables, pair)


def lay_lines(pair: Pair, work: Work, index: int, height: float, far: float, q: float) -> bool:
    """Lay the frame along the direction with the lateral rate ``q`` [-], and the nodes in it; whether there are any."""
    touch = work.touches[index]
    side = work.sides[index]
    open_section_frame(pair, touch, height, q)
    frame = pair.sections.frame
    place_in_frame(frame, touch.place, side.place)
    frame.turn = 0.0
    if pair.out_of_round:
        frame.turn = within_turn(work.inputs.wheel_rotation) + wheel_turn(frame, touch.place, side.place)
    return follow_valley(pair, side.place, touch, work.inputs.track_position, far)


def find_in_frame(pair: Pair, side: SideSearch, y: float) -> bool:
    """Find the smallest gap in the frame, from the wheel abscissa ``y`` [m] on; whether the wheel is above its rail."""
    side.best_y = y
    if follow_side(pair, side):
        return True
    return search_side(pair, side, False)


def load_touching(tables: Tables, work: Work, index: int, height: float, force: float):
    """Side ``index`` of a rigid wheelset that touches at the vertical shift ``height`` [m], under a ``force`` [N]; the
    status.  Only where it may overlap its rail farther away, all of that is laid, and again where parts beyond grooves carry."""
    sections = tables.pairs[index].sections
    status, covered = load_touching_within(tables, work, index, height, force, NEAR, 0.0)
    if not covered:
        status, covered = load_touching_within(tables, work, index, height, force, ALL, 0.0)
        if covered and status == VALID and sections.bridged:
            depth = depth_in_track(tables, work, index)
            status, covered = load_touching_within(tables, work, index, height, force, ALL, depth)
    if not covered:
        return NOT_CONVERGED
    if status == VALID and is_oblique(sections, depth_in_track(tables, work, index)):
        return NOT_CONVERGED
    return status


def depth_in_track(tables: Tables, work: Work, index: int):
    """How far a wheel is lowered [m] that has this penetration."""
    side = work.sides[index]
    return side.penetration / work.contact.frame.plane.cos / tables.pairs[index].sections.frame.down[2]


def load_touching_within(
    tables: Tables, work: Work, index: int, height: float, force: float, far: float, depth: float
):
    """The status of that with a rail up to gaps of ``far`` [m], laid for an overlap of about ``depth`` [m], and whether the wheel
    overlaps it nowhere else."""
    pair = tables.pairs[index]
    side = work.sides[index]
    if not lay_rail(tables, work, index, height, far, depth):
        return NOT_CONVERGED, True
    if not find_in_frame(pair, side, work.touches[index].y):
        return NOT_CONVERGED, True
    if tables.load == LOAD_VERTICAL:
        force /= pair.sections.frame.down[2]
    status = solve_side(tables, work, index, force)
    if status > UNLOADED:
        return status, far >= ALL
    return finish_side(tables, work, index, status, height, depth_in_track(tables, work, index))


def load_pressed(tables: Tables, work: Work, index: int, height: float):
    """Side ``index`` of a wheelset whose vertical shift ``height`` [m] is given; the status, UNLOADED if lifted."""
    if height - work.touches[index].best > DEEPEST:
        return OFF_PROFILE
    status, covered = load_pressed_within(tables, work, index, height, NEAR)
    if not covered:
        status, covered = load_pressed_within(tables, work, index, height, ALL)
    if not covered:
        return NOT_CONVERGED
    if status == VALID and is_oblique(tables.pairs[index].sections, 0.0):
        return NOT_CONVERGED
    if status == VALID and is_damped(tables):
        damp_leaning_patches(tables, work, index)
    return status


def load_pressed_within(tables: Tables, work: Work, index: int, height: float, far: float):
    """The status of that with a rail up to gaps of ``far`` [m], and whether the wheel overlaps it nowhere else."""
    pair = tables.pairs[index]
    side = work.sides[index]
    touch = work.touches[index]
    approach = height - touch.best
    if not approach > GRAZING:
        if not lay_rail(tables, work, index, touch.best, far, 0.0) or not find_in_frame(pair, side, touch.y):
            return NOT_CONVERGED, True
        status = touch_side(tables, work, index)
        return finish_side(tables, work, index, status, touch.best, 0.0)
    if not lay_rail(tables, work, index, height, far, 0.0) or not find_in_frame(pair, side, touch.y):
        return NOT_CONVERGED, True
    # the frame holds for this height
    side.best = -approach * pair.sections.frame.down[2]
    status = lower_wheel(tables, work, index, -side.best)
    if status == VALID and tables.depth != DEPTH_GEOMETRY:
        count, status = load_side(tables, work, index, 0.0, work.contact.frame.depth)
    if status > UNLOADED:
        return status, far >= ALL
    return finish_side(tables, work, index, status, height, approach)


def finish_side(tables: Tables, work: Work, index: int, status: int, height: float, depth: float):
    """Turn a side that is solved back into the track, and see whether its rail was one along it, and enough of it: the
    status, and whether the wheel, ``depth`` [m] below where it touches, overlaps no other part of it."""
    pair = tables.pairs[index]
    side = work.sides[index]
    if status > UNLOADED:
        return status, True
    turn_point(pair, work, index, height)
    on_rail = True
    for number in range(side.patch_count):
        leaning = work.leaning[leaning_place(index, number)]
        if has_strips(tables):
            lean_strips(pair, work.touches[index], side, number, leaning)
        turn_patch(pair, work.touches[index], side, number, leaning)
        on_rail = on_rail and lies_on_rail(pair, work, work.touches[index].place, leaning.own)
    if has_wear(tables) and side.patch_count > 0:
        turn_wear(pair, work, index)
    pair.rail_y = pair.sections.lateral
    search = work.section_search
    if not on_rail or not has_one_valley(pair, work.touches[index], search, depth + BESIDE):
        return NOT_CONVERGED, True
    covered = covers(pair.sections, search.low, search.high, depth) and not search.on_bridge
    return status, covered


def lies_on_rail(pair: Pair, work: Work, place: Place, at: Leaning) -> bool:
    """Whether a patch of the constant rail lies on the changing one: between two nodes, such as those of a bridge, that may be
    another one."""
    sections = pair.sections
    z, z_u, z_y, z_uu, z_uy, z_yy = section_jet(
        sections, work.inputs.track_position + at.x, at.y - place.rail_lateral - sections.lateral
    )
    return fabs(z + place.rail_vertical - at.z) < OFF_RAIL * sqrt(1.0 + z_u * z_u + z_y * z_y)


def has_strips(tables: Tables) -> bool:
    """Whether patches are cut into strips along the rolling direction."""
    return tables.tangential != TANGENTIAL_NONE or has_wear(tables)


def covers(sections: Sections, low: float, high: float, depth: float) -> bool:
    """Whether the rail that is laid reaches from the wheel abscissa ``low`` to ``high`` [m] and far beyond the overlap of a
    wheel that is lowered by ``depth`` [m], or to its own ends."""
    near = sections.far < BEYOND_DEPTH * depth
    short = sections.cut_first and (near or sections.nodes[sections.first].wheel > low)
    return not short and not (sections.cut_last and (near or sections.nodes[sections.last].wheel < high))


def turn_point(pair: Pair, work: Work, index: int, height: float):
    """The place of contact of a side in the track, on its wheel and on its rail."""
    side = work.sides[index]
    point = side.point
    place = work.touches[index].place
    sections = pair.sections
    move, rise, lift = valley_at(sections, point.y_track)
    x, y, z = point_in_track(
        sections.frame,
        sections.frame.centre[0] + point.x_track + move,
        point.y_track,
        point.z_track + lift,
    )
    z, z_u, z_y, z_uu, z_uy, z_yy = section_jet(
        sections, work.inputs.track_position + x, y - sections.lateral
    )
    point.y_rail = y - sections.lateral
    point.z_rail = z
    # where the wheel stands, which a pressed one is moved from to touch
    wheel_z, wheel_slope = height_slope(pair.wheel, point.y_wheel)
    y_frame, z_frame, outline_slope = outline_point(side.place, point.y_wheel, wheel_z, wheel_slope)
    wheel_x, wheel_y, wheel_down = point_in_track(
        sections.frame,
        sections.frame.centre[0] + outline_x(pair, side.place, point.y_wheel),
        y_frame,
        z_frame,
    )
    if pair.out_of_round:
        d, rate = deviation_at(pair, side.place, point.x_track + move, point.y_track, point.z_track + lift)
        point.rolling_radius += d
        wheel_x += sections.frame.along[0] * move
        wheel_y += sections.frame.along[1] * move
    point.x_wheel = wheel_x * place.cos_yaw + (wheel_y - place.shift) * place.sin_yaw
    r = point.rolling_radius
    point.z_wheel = sqrt(max(r * r - point.x_wheel * point.x_wheel, 0.0)) - place.radius
    point.x_track = x
    point.y_track = y + place.rail_lateral
    point.z_track = z + place.rail_vertical
    point.contact_angle = -atan(z_y)


def lean(pair: Pair, touch: SectionTouch, at: Leaning, x: float, y: float, z: float):
    """Note the place ``x``, ``y``, ``z`` of the constant rail, x from the wheelset's centre, as that of a contact in the track;
    how far it moves along the frame from the wheel's outline [m], the slope of both surfaces along the frame there [-], and how much
    lower both are there [m]."""
    frame = pair.sections.frame
    move, rise, lift = valley_at(pair.sections, y)
    at.x, at.y, at.z = point_in_track(frame, frame.centre[0] + x + move, y, z + lift)
    at.y += touch.place.rail_lateral
    at.z += touch.place.rail_vertical
    return move, rise, lift


def lean_plane(frame: SectionFrame, at: Leaning, x: float, y: float, z: float):
    """Note the plane of a contact whose normal from the rail to the wheel has this direction in the frame [any unit]."""
    size = sqrt(x * x + y * y + z * z)
    x /= size
    y /= size
    z /= size
    level = sqrt(1.0 - x * x)
    at.down[0], at.down[1], at.down[2] = into_track(frame, -x, -y, -z)
    at.ahead[0], at.ahead[1], at.ahead[2] = into_track(frame, level, -x * y / level, -x * z / level)
    at.aside[0], at.aside[1], at.aside[2] = into_track(frame, 0.0, -z / level, y / level)


def radius_change(touch: SectionTouch, frame: SectionFrame, at: Leaning, move: float):
    """How much larger the rolling radius is at a place that lies ``move`` [m] ahead of the outline [m]: the wheel's abscissa
    is another one there where the axle does not lie across the frame."""
    place = touch.place
    axle_x = -place.sin_yaw * place.cos_roll
    axle_y = place.cos_yaw * place.cos_roll
    axle_z = place.sin_roll
    moved = move * (frame.along[0] * axle_x + frame.along[1] * axle_y + frame.along[2] * axle_z)
    sine = at.down[0] * axle_x + at.down[1] * axle_y + at.down[2] * axle_z
    return -moved * sine / sqrt(1.0 - sine * sine)


def deviation_at(pair: Pair, place: Place, x: float, y: float, z: float):
    """How much larger than that of the round wheel the radius is [m] at a place of the frame, x from the wheelset's centre, and
    how fast it grows around the wheel there [m]."""
    frame = pair.sections.frame
    y -= frame.centre[1]
    z -= frame.centre[2]
    ahead = place.cos_yaw * x + place.sin_yaw * y
    level = place.cos_yaw * y - place.sin_yaw * x
    d, d_f, d_y, d_ff, d_fy, d_yy = section_jet(
        pair.deviation,
        frame.turn + atan2(ahead, place.cos_roll * z - place.sin_roll * level),
        place.cos_roll * level + place.sin_roll * z - place.arm,
    )
    return d, d_f


def into_rail(place: Place, at: Leaning):
    """The part along a contact's normal of the direction from the axle to it: nearly 1, less what the axle has of the normal."""
    axle = (
        -place.sin_yaw * place.cos_roll * at.down[0]
        + place.cos_yaw * place.cos_roll * at.down[1]
        + place.sin_roll * at.down[2]
    )
    return sqrt(max(1.0 - axle * axle, 0.0))


def lean_strips(pair: Pair, touch: SectionTouch, side: SideSearch, number: int, leaning: LeaningPatch):
    """Places, planes and rolling radii of the strips of a patch that is not turned yet."""
    patch = side.patches[number]
    frame = pair.sections.frame
    for k in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[k]
        at = leaning.strips[k]
        move, rise, lift = lean(pair, touch, at, patch.x_track + strip.x, strip.y_track, strip.z_track)
        lean_plane(frame, at, rise * strip.cos, strip.sin, -strip.cos)
        strip.rolling_radius += radius_change(touch, frame, at, move)
        if pair.out_of_round:
            d, rate = deviation_at(
                pair, side.place, patch.x_track + strip.x + move, strip.y_track, strip.z_track + lift
            )
            strip.rolling_radius += d


def turn_patch(pair: Pair, touch: SectionTouch, side: SideSearch, number: int, leaning: LeaningPatch):
    """Force, moment and place of a patch in the track."""
    patch = side.patches[number]
    frame = pair.sections.frame
    at = leaning.own
    # the force acts at the nearest place along the rail, along the normal there, which leans as both surfaces do
    move, rise, lift = lean(pair, touch, at, patch.x_track, patch.y_track, patch.z_track)
    along = -rise * patch.normal_z
    square = patch.normal_y * patch.normal_y + patch.normal_z * patch.normal_z
    share = 1.0
    if square > 0.0:
        share = 1.0 / sqrt(1.0 + along * along / square)
        lean_plane(frame, at, along, patch.normal_y, patch.normal_z)
        patch.rolling_radius += radius_change(touch, frame, at, move)
        at.swelling = 0.0
        if pair.out_of_round:
            d, rate = deviation_at(
                pair, side.place, patch.x_track + move, patch.y_track, patch.z_track + lift
            )
            patch.rolling_radius += d
            at.swelling = rate * into_rail(touch.place, at)
    x, y, z = into_track(frame, share * along, share * patch.normal_y, share * patch.normal_z)
    moment_x, moment_y, moment_z = into_track(
        frame,
        share * (patch.normal_moment[0] - lift * patch.normal_y),
        share * (patch.normal_moment[1] - move * patch.normal_z + (patch.z_track + lift) * along),
        share * (patch.normal_moment[2] + move * patch.normal_y - patch.y_track * along),
    )
    at_x, at_y, at_z = point_in_track(frame, frame.centre[0], 0.0, 0.0)
    at_y += touch.place.rail_lateral
    at_z += touch.place.rail_vertical
    patch.normal_x = x
    patch.normal_y = y
    patch.normal_z = z
    patch.normal_moment[0] = moment_x + at_y * z - at_z * y
    patch.normal_moment[1] = moment_y + at_z * x - at_x * z
    patch.normal_moment[2] = moment_z + at_x * y - at_y * x
    patch.x_track = at.x
    patch.y_track = at.y
    patch.z_track = at.z
    turn_angle(patch)


def turn_angle(patch: Patch):
    """The angles of the force of a patch across the track and along it."""
    slope = patch.normal_y / -patch.normal_z
    patch.contact_angle = -atan(slope)
    patch.angle_cos = 1.0 / sqrt(1.0 + slope * slope)
    patch.angle_sin = -slope * patch.angle_cos
    patch.slope = atan2(-patch.normal_x, -patch.normal_z)
