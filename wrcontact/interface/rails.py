"""The inputs that say where the rails are: rows of the table in inputs.py."""

from .rows import Input

#: Permitted size of a rail's displacement [m] and of its roll [rad].
RAIL_LIMIT, RAIL_ROLL_LIMIT = 0.05, 0.05

#: Sides with rails of their own.
RAIL_SIDES = ("left", "right")


def _rows(side):
    """The inputs of one side."""
    place = f"{side.capitalize()} rail"
    for field, way in (("rail_lateral", "to the right"), ("rail_vertical", "down")):
        yield Input(f"{side}.{field}", "m", 1e-3, f"displacement from its nominal place, {way}", -RAIL_LIMIT,
                    RAIL_LIMIT, field=f"{side}_{field}", place=place)
    yield Input(f"{side}.rail_roll", "rad", 1e-2, "rotation about its highest point in its nominal place, "
                "positive with the right side down", -RAIL_ROLL_LIMIT, RAIL_ROLL_LIMIT,
                field=f"{side}_rail_roll", place=place)


RAILS = tuple(row for side in RAIL_SIDES for row in _rows(side))
