"""Where a rail lies whose section changes along the track: keywords of Python, one for each side."""

from ..methods.numbers import Number
from .inputs import POSITION_LIMIT

#: The one of a rail that is the same all along the track, which then stands for a roller.
ROLLER = "roller_radius"
#: Their rows by name; the kernel finds them in its tables of sections, not among its parameters.
SECTION_PLACES = {
    "rail_position": Number(
        0.0,
        -POSITION_LIMIT,
        POSITION_LIMIT,
        "m",
        "Place along the track of the position 0 of a rail whose section changes",
        nominal=1.0,
        python_only=True,
    ),
    "rail_reversed": Number(
        False,
        0,
        1,
        "1",
        "Whether the positions of a rail whose section changes count against the track; its sides stay",
        switch=True,
        python_only=True,
    ),
    "rail_origin_y": Number(
        0.0,
        -2.0,
        2.0,
        "m",
        "Lateral distance of the origin of changing sections from the track's centre, to the field side; 0: by the "
        "gauge of the section at position 0, whose highest place then has the height 0",
        nominal=0.75,
        python_only=True,
    ),
    "rail_origin_z": Number(
        0.0,
        -1.0,
        1.0,
        "m",
        "How far the origin of changing sections lies below the running surface; beside rail_origin_y only",
        nominal=1e-3,
        python_only=True,
    ),
    ROLLER: Number(
        0.0,
        0.0,
        1000.0,
        "m",
        "Radius of the roller in the place of a rail, at the highest place of its section; 0: a rail",
        nominal=1.0,
        python_only=True,
    ),
}
