"""Where stations and strips lie on the wheel and in the sections of a rail that changes, for models of wear
(normal/wear_places.py has places on the constant rail of the frame)."""

from ..layout import ROLLING_STRIP_LIMIT, Pair, SideSearch, Work, seldom
from ..surface.locus import outline_x
from ..surface.tables import height_slope
from ..wheelset.leaning_wheel import leaning_place
from .section_frame import point_in_track
from .nearest_places import valley_at


@seldom
def turn_wear(pair: Pair, work: Work, index: int):
    """Turn the places of the stations and of the strips of side ``index`` back into the sections; its strips lean already."""
    side = work.sides[index]
    lateral = work.touches[index].place.rail_lateral + pair.sections.lateral
    for j in range(pair.tables.stations):
        turn_station(pair, side, j)
    for number in range(side.patch_count):
        leaning = work.leaning[leaning_place(index, number)]
        worn = side.worn[number]
        for k in range(ROLLING_STRIP_LIMIT):
            move, rise, lift = valley_at(pair.sections, worn.rail_place[k])
            worn.rail_place[k] = leaning.strips[k].y - lateral
            worn.wheel_place[k] += abscissa_change(side, move)


@seldom
def turn_station(pair: Pair, side: SideSearch, j: int):
    """The places of station ``j`` of a side."""
    stations = pair.tables.stations
    frame = pair.sections.frame
    wheel = side.wear.numbers[j]
    across = side.wear.numbers[stations + j]
    move, rise, lift = valley_at(pair.sections, across)
    z, slope = height_slope(pair.rail, across)
    x, y, down = point_in_track(
        frame, frame.centre[0] + outline_x(pair, side.place, wheel) + move, across, z + lift
    )
    side.wear.numbers[j] = wheel + abscissa_change(side, move)
    side.wear.numbers[stations + j] = y - pair.sections.lateral


@seldom
def abscissa_change(side: SideSearch, move: float):
    """How much larger the wheel's abscissa is at a place that lies ``move`` [m] ahead along the frame [m]."""
    return -move * side.place.sin_yaw * side.place.cos_roll
