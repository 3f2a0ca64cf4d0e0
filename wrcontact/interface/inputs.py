"""The inputs: one row for each, in the order of the kernel's array."""

from .friction import FRICTION
from .motion import MOTION
from .rails import RAILS
from .rows import Input

#: Permitted |lateral shift| [m] and |yaw| [rad]; beyond it the contact leaves the profiles' running surfaces.
LATERAL_LIMIT, YAW_LIMIT = 0.015, 0.12
#: Permitted |roll| [rad], within which the roll is searched; 12 mm of lateral shift need 0.013.
ROLL_LIMIT = 0.12
#: Declared range of the height in compliant contact [m]: a flange on top of the rail lifts the wheelset by 28
#: mm.
HEIGHT_LIMIT = 0.05

INPUTS = (
    Input("lateral_shift", "m", 1e-3,
          "Lateral shift of the wheelset against the track centre, positive to the right", -LATERAL_LIMIT,
          LATERAL_LIMIT, positional=True),
    Input("yaw", "rad", 1e-2, "Yaw of the wheelset, positive clockwise seen from above",
          -YAW_LIMIT, YAW_LIMIT, positional=True),
    Input("roll_guess", "rad", 1e-3, "Where the search for the roll angle starts; changes the cost of a "
          "step, never its answer", -0.5, 0.5, hint=True),
    Input("normal_force", "N", 1e5, "Load per wheel before load transfer: normal force, total over its "
          "patches, or its vertical component (parameter load); in compliant mode used only for the "
          "equilibrium outputs", 0.0, 1e7, start=78500.0, positional=True, usual=(0.0, 1e6)),
    Input("load_transfer", "1", 0.1, "Share L of the load N moved from left to right: N (1 + L) on the right "
          "wheel, N (1 - L) on the left; in compliant mode used only for the equilibrium outputs",
          -1.0, 1.0, positional=True),
    Input("vertical_shift_input", "m", 1e-3, "Vertical shift of the wheelset in the contact_mode compliant, "
          "positive down; other modes do not read it",
          -HEIGHT_LIMIT, HEIGHT_LIMIT, field="vertical_shift"),
    Input("roll_input", "rad", 1e-3, "Roll of the wheelset in the contact_mode compliant, positive with the "
          "right wheel down; other modes do not read it", -ROLL_LIMIT, ROLL_LIMIT, field="roll"),
    *RAILS,
    *MOTION,
    *FRICTION,
)

INPUT_NAMES = tuple(row.name for row in INPUTS)
INPUT_UNITS = tuple(row.unit for row in INPUTS)
INPUT_NOMINALS = tuple(row.nominal for row in INPUTS)
#: What an output may depend on.  An FMU declares its dependencies once for all methods: in elastic contact
#: all of these move everything, velocities and friction too where friction carries a part of a vertical load.
ANSWERED = tuple(row.name for row in INPUTS if not row.hint)
