"""The inputs that say where the rails are: rows of the table in inputs.py."""

from .rows import Input

#: Permitted size of a rail's displacement [m].
RAIL_LIMIT = 0.05

#: Sides with rails of their own.
RAIL_SIDES = ("left", "right")

RAILS = tuple(
    Input(f"{side}.{field}", "m", 1e-3, f"displacement from its nominal place, {way}",
          -RAIL_LIMIT, RAIL_LIMIT, field=f"{side}_{field}", place=f"{side.capitalize()} rail")
    for side in RAIL_SIDES
    for field, way in (("rail_lateral", "to the right"), ("rail_vertical", "down"))
)
