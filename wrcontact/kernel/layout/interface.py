"""Records and constants that follow from the rows of inputs, parameters and outputs (wrcontact/interface).

The order of the fields is that of the rows. A field has the name of its row, or the
part of it behind the dot.  Beside them, by number: what can be wanted of a step, and its status.
"""

from typing import Final

from ...interface import inputs as _inputs, outputs as _outputs, rows as _rows, variables as _variables
from ...interface.friction import FRICTION_LIMIT
from ...interface.inputs import (
    CURVATURE_LIMIT,
    INPUT_NOMINALS,
    LATERAL_LIMIT,
    RAIL_LIMIT,
    RAIL_ROLL_LIMIT,
    RATE_LIMIT,
    ROLL_LIMIT,
    SPEED_LIMIT,
    TIME_LIMIT,
    TORQUE_LIMIT,
    VELOCITY_LIMIT,
    WHEEL_LIMIT,
    YAW_LIMIT,
)
from ...interface.outputs import PATCH_LIMIT, STATION_COUNT, STATION_LEAST, STATION_LIMIT
from ...interface.parameters import KERNEL_PARAMETERS
from ...methods import FAMILIES as _FAMILIES
from ...methods.normal import Resolution as _Resolution
from .record import Float, record, run, size

#: Three components x, y, z.
Vector = run(len(_rows.AXES))

SIDES_BOTH: Final[int] = 0
SIDES_LEFT: Final[int] = 1
SIDES_RIGHT: Final[int] = 2
DEPTH_GEOMETRY: Final[int] = 0  # contact point, angle, radius, curvatures
DEPTH_PATCHES: Final[int] = 1  # and penetration, patches
DEPTH_ALL: Final[int] = 2  # and the outline

# status of a step ----------------------------------------------------------------------------------
VALID: Final[int] = 0
UNLOADED: Final[int] = 1
OFF_PROFILE: Final[int] = 2
NOT_CONVERGED: Final[int] = 3
INVALID_INPUT: Final[int] = 4
BEYOND_ADHESION: Final[int] = 5


def _record_of(name, fields, words):
    """A record class with these ``fields``, {name: type}."""
    return record(type(name, (), {"__annotations__": dict(fields), "__doc__": words, "__module__": __name__}))


def _fields_of(rows, blocks):
    """{field: type} of rows of inputs or outputs; ``blocks`` are the classes of their blocks by name."""
    kinds = {_rows.Vector: Vector, _rows.Run: Float * STATION_COUNT}
    return {
        row.name if isinstance(row, _rows.Blocks) else row.field: blocks[row.name] * row.count
        if isinstance(row, _rows.Blocks)
        else kinds.get(type(row), float)
        for row in rows
    }


Inputs = _record_of("Inputs", _fields_of(_inputs.INPUTS, {}), "What moves.")
PatchOutputs = _record_of("PatchOutputs", _fields_of(_outputs.PATCH, {}), "Outputs of one patch.")
SideOutputs = _record_of(
    "SideOutputs", _fields_of(_outputs.SIDE, {"patch": PatchOutputs}), "Outputs of one wheel."
)
Outputs = _record_of(
    "Outputs", _fields_of(_outputs.WHEELSET, {}) | {"left": SideOutputs * 2}, "Outputs of a wheelset."
)
Parameters = _record_of(
    "Parameters", {name: float for name in KERNEL_PARAMETERS}, "All parameters, methods by their numbers."
)
Resolution = _record_of("Resolution", {name: float for name in _Resolution._fields}, "Nodes and strips.")

#: Runs of an outline.
RUN_COUNT = sum(isinstance(row, _rows.Run) for row in _outputs.SIDE)
#: Runs of an outline that are there with wear_outputs only.
WEAR_RUN_COUNT = len(_outputs.WEAR)

if size(Outputs) != _variables.FIRST_WEAR - _variables.FIRST_OUTPUT:
    raise TypeError(
        f"the record of outputs has {size(Outputs)} numbers, the table of variables "
        f"{_variables.FIRST_WEAR - _variables.FIRST_OUTPUT}"
    )

# numbers of the methods: MODE_RIGID, SEPARATION_NORMAL, ...
globals().update(
    {
        f"{family.constant}_{method.name.upper()}": method.kernel_number
        for family in _FAMILIES
        for method in family.methods
        if not method.python_only
    }
)
