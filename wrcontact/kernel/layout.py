"""Named offsets into the kernel's arrays; the only place where they are numbers.

``inputs``  what moves: the pose and the load of one wheelset.
``outputs`` what comes back: wheelset block, then left block, then right block, in the order of the FMU's variables.
"""

from typing import Final

# inputs ------------------------------------------------------------------------------------------
IN_LATERAL_SHIFT: Final[int] = 0
IN_YAW: Final[int] = 1
IN_ROLL_GUESS: Final[int] = 2
IN_NORMAL_FORCE: Final[int] = 3
IN_LOAD_TRANSFER: Final[int] = 4
IN_VERTICAL_SHIFT: Final[int] = 5    # prescribed height and roll of the compliant form
IN_ROLL: Final[int] = 6
INPUT_COUNT: Final[int] = 7

# outputs: wheelset -------------------------------------------------------------------------------
OUT_ROLL: Final[int] = 0
OUT_VERTICAL_SHIFT: Final[int] = 1
OUT_FORCE: Final[int] = 2            # resultant of the contact forces on the wheelset, x, y, z in the track frame
OUT_MOMENT: Final[int] = 5           # and their moment about the wheelset's centre
OUT_LEFT: Final[int] = 8
OUT_RIGHT: Final[int] = OUT_LEFT + 134
OUTPUT_COUNT: Final[int] = OUT_RIGHT + 134

# outputs: one side, relative to OUT_LEFT or OUT_RIGHT --------------------------------------------
SIDE_PATCH_COUNT: Final[int] = 0
SIDE_X_WHEEL: Final[int] = 1
SIDE_Y_WHEEL: Final[int] = 2
SIDE_Z_WHEEL: Final[int] = 3
SIDE_Y_RAIL: Final[int] = 4
SIDE_Z_RAIL: Final[int] = 5
SIDE_X_TRACK: Final[int] = 6
SIDE_Y_TRACK: Final[int] = 7
SIDE_Z_TRACK: Final[int] = 8
SIDE_CONTACT_ANGLE: Final[int] = 9
SIDE_ROLLING_RADIUS: Final[int] = 10
SIDE_CURVATURE_X: Final[int] = 11
SIDE_CURVATURE_Y: Final[int] = 12
SIDE_PENETRATION: Final[int] = 13
SIDE_NORMAL_FORCE: Final[int] = 14
SIDE_AREA: Final[int] = 15
SIDE_MAX_PRESSURE: Final[int] = 16
SIDE_PATCH_LENGTH: Final[int] = 17
SIDE_PATCH_WIDTH: Final[int] = 18
SIDE_PATCH_CENTROID: Final[int] = 19
SIDE_PATCH: Final[int] = 20          # PATCH_LIMIT blocks of PATCH_SIZE
SIDE_STATION: Final[int] = 41        # STATION_COUNT values each
SIDE_HALF_LENGTH: Final[int] = 72
SIDE_PRESSURE: Final[int] = 103
SIDE_SIZE: Final[int] = 134

# outputs: one patch ------------------------------------------------------------------------------
PATCH_NORMAL_FORCE: Final[int] = 0
PATCH_AREA: Final[int] = 1
PATCH_MAX_PRESSURE: Final[int] = 2
PATCH_LENGTH: Final[int] = 3
PATCH_WIDTH: Final[int] = 4
PATCH_CENTROID: Final[int] = 5
PATCH_CONTACT_ANGLE: Final[int] = 6
PATCH_SIZE: Final[int] = 7
PATCH_LIMIT: Final[int] = 3
STATION_COUNT: Final[int] = 31       # of an outline, unless another number is asked for:
STATION_LEAST: Final[int] = 3
STATION_LIMIT: Final[int] = 201

# tables: settings at the head, then the profile, scan and Hertz tables they point to ----------------
SET_RADIUS: Final[int] = 0           # nominal radius [m]
SET_ARM: Final[int] = 1              # half the distance of the running circles [m]
SET_RAIL_Y: Final[int] = 2           # track coordinate of the right rail's highest point [m]
SET_CONTACT_MODULUS: Final[int] = 3  # E* [Pa]
SET_LATERAL_LIMIT: Final[int] = 4    # largest |lateral shift| [m]
SET_YAW_LIMIT: Final[int] = 5        # largest |yaw| [rad]
SET_WHEEL: Final[int] = 6            # offsets of the tables
SET_RAIL: Final[int] = 7
SET_SCAN: Final[int] = 8
SET_HERTZ: Final[int] = 9
SET_NORMAL_MODEL: Final[int] = 10    # one of MODEL_...
SET_LONGITUDINAL: Final[int] = 11    # one of LONGITUDINAL_...
SET_PENETRATION_LEFT: Final[int] = 12   # prescribed penetration [m]; not a number: the force is prescribed
SET_PENETRATION_RIGHT: Final[int] = 13
SET_NODES: Final[int] = 14           # nodes per half-width of the interpenetration, a multiple of five
SET_STRIDE: Final[int] = 15          # every so many of them are traced on the profiles
SET_STRIPS: Final[int] = 16          # strips of the strip correction
SET_SWEEPS: Final[int] = 17          # and how often it is made
SET_INFLUENCE: Final[int] = 18       # offset of its table
SET_STARTS: Final[int] = 19          # offset of the table of starts
SET_SIDES: Final[int] = 20           # which sides are wanted, one of SIDES_...
SET_DEPTH: Final[int] = 21           # what is wanted of them, one of DEPTH_...
SET_ABSENT: Final[int] = 22          # what stands in outputs that are not wanted: not a number
SET_STATIONS: Final[int] = 23        # stations of an outline; where it then lies is told in outline.py
SET_SEPARATION: Final[int] = 24      # one of SEPARATION_...
SET_LATERAL: Final[int] = 25         # one of LATERAL_...
SET_WHEEL_CURVATURE: Final[int] = 26    # offsets of the tables of the profiles' lateral curvatures
SET_RAIL_CURVATURE: Final[int] = 27
SET_MODE: Final[int] = 30            # one of MODE_...
SET_LOAD: Final[int] = 31            # one of LOAD_...
SETTING_COUNT: Final[int] = 48

MODE_RIGID: Final[int] = 0
MODE_ELASTIC: Final[int] = 1
MODE_COMPLIANT: Final[int] = 2
LOAD_NORMAL: Final[int] = 0
LOAD_VERTICAL: Final[int] = 1

MODEL_HERTZ: Final[int] = 0
MODEL_ANALYN: Final[int] = 1
MODEL_ANALYN_STRIP: Final[int] = 2
SIDES_BOTH: Final[int] = 0
SIDES_LEFT: Final[int] = 1
SIDES_RIGHT: Final[int] = 2
DEPTH_GEOMETRY: Final[int] = 0       # contact point, angle, radius, curvatures
DEPTH_PATCHES: Final[int] = 1        # and penetration, patches
DEPTH_ALL: Final[int] = 2            # and the outline
LONGITUDINAL_EFFECTIVE: Final[int] = 0
LONGITUDINAL_BASIC: Final[int] = 1
SEPARATION_NORMAL: Final[int] = 0
SEPARATION_VERTICAL: Final[int] = 1
SEPARATION_EQUIDISTANT: Final[int] = 2
SEPARATION_CHORD: Final[int] = 3
LATERAL_ADAPTIVE: Final[int] = 0
LATERAL_SMOOTH: Final[int] = 1
LATERAL_ROUGH: Final[int] = 2

# state: what one step leaves for the next; never changes an answer ----------------------------------
STATE_ROLL: Final[int] = 0           # last valid roll [rad]
STATE_WARM: Final[int] = 1           # 1 when STATE_ROLL holds one
STATE_GAP_COUNT: Final[int] = 2      # evaluations of the vertical gap since the state was cleared
STATE_SCAN_COUNT: Final[int] = 3     # scans of one side
STATE_ROLL_COUNT: Final[int] = 4     # iterations of the roll search
STATE_NODE_COUNT: Final[int] = 5     # evaluations of the normal gap
STATE_SOLVE_COUNT: Final[int] = 6    # iterations of the force solve
STATE_Y_LEFT: Final[int] = 7         # wheel abscissae of the last contacts [m]
STATE_Y_RIGHT: Final[int] = 8
STATE_SHIFT: Final[int] = 9          # and the lateral shift [m]
STATE_STRIP_COUNT: Final[int] = 10   # systems of strips solved
STATE_SIZE: Final[int] = 11

# outcome of a step ---------------------------------------------------------------------------------
VALID: Final[int] = 0
UNLOADED: Final[int] = 1
OFF_PROFILE: Final[int] = 2
NOT_CONVERGED: Final[int] = 3
INVALID_INPUT: Final[int] = 4

# workspace: one array, cut up here ------------------------------------------------------------------
SCAN_LIMIT: Final[int] = 400         # scan nodes over one wheel
REGION_LIMIT: Final[int] = 3         # loaded regions of one wheel
REGION_BLOCK: Final[int] = 48        # numbers kept of each
NODE_FIELDS: Final[int] = 9          # node arrays of each
NODE_LIMIT: Final[int] = 256         # their length
NODE_MIDDLE: Final[int] = 128        # place of node 0 in them
PLACE_BLOCK: Final[int] = 16         # a placed wheel
SIDE_BLOCK: Final[int] = 400         # search data of one side
CONTACT_BLOCK: Final[int] = 40       # contact frame and tracer
SUPPORT_BLOCK: Final[int] = 16       # how one side carries its load, while the height is sought
ISLAND_BLOCK: Final[int] = 80        # loaded islands of one wheel
STRIP_FIELDS: Final[int] = 16        # strip arrays
STRIP_LIMIT: Final[int] = 104        # their length
OVERLAP_LIMIT: Final[int] = 200      # samples of the overlap of a pressed wheel to either side
OVERLAP_BLOCK: Final[int] = 64 + 4 * 2 * OVERLAP_LIMIT
ROLLS_BLOCK: Final[int] = 256        # rolls at which both sides have been searched
SEPARATION_BLOCK: Final[int] = 8     # origin of the region whose separation is measured

WORK_INPUTS: Final[int] = 0          # inputs of the row at work
WORK_KNOWN: Final[int] = WORK_INPUTS + INPUT_COUNT  # 1 when the outputs below belong to them
WORK_STATUS: Final[int] = WORK_KNOWN + 1            # and their status
WORK_OUTPUTS: Final[int] = WORK_STATUS + 1          # outputs under construction
WORK_OUTLINES: Final[int] = WORK_OUTPUTS + OUTPUT_COUNT       # left and right outline, where they follow the outputs
WORK_PLACE: Final[int] = WORK_OUTLINES + 6 * STATION_LIMIT    # left and right placed wheel
WORK_SIDE: Final[int] = WORK_PLACE + 2 * PLACE_BLOCK          # left and right search data
WORK_CONTACT: Final[int] = WORK_SIDE + 2 * SIDE_BLOCK         # contact frame of the side at work
WORK_REGION: Final[int] = WORK_CONTACT + CONTACT_BLOCK
WORK_NODES: Final[int] = WORK_REGION + REGION_BLOCK * REGION_LIMIT
WORK_ISLANDS: Final[int] = WORK_NODES + NODE_LIMIT * NODE_FIELDS * REGION_LIMIT
WORK_STRIPS: Final[int] = WORK_ISLANDS + ISLAND_BLOCK
WORK_DISTANCE: Final[int] = WORK_STRIPS + STRIP_FIELDS * STRIP_LIMIT        # logarithms of distances, square
WORK_INFLUENCE: Final[int] = WORK_DISTANCE + STRIP_LIMIT * STRIP_LIMIT      # displacement of strips by strips, square
WORK_SYSTEM: Final[int] = WORK_INFLUENCE + STRIP_LIMIT * STRIP_LIMIT        # the system that is solved
WORK_SEPARATION: Final[int] = WORK_SYSTEM + STRIP_LIMIT * (STRIP_LIMIT + 2)
WORK_FRAMES: Final[int] = WORK_SEPARATION + SEPARATION_BLOCK                # of the regions, and the contact point's
WORK_OVERLAP: Final[int] = WORK_FRAMES + CONTACT_BLOCK * (REGION_LIMIT + 1)   # where a pressed wheel overlaps its rail
WORK_SUPPORT: Final[int] = WORK_OVERLAP + OVERLAP_BLOCK                     # left and right
WORK_ROLLS: Final[int] = WORK_SUPPORT + 2 * SUPPORT_BLOCK                   # on the way from level to a roll
WORK_SIZE: Final[int] = WORK_ROLLS + ROLLS_BLOCK

# search data of one side, relative to its block
SIDE_BEST: Final[int] = 0            # smallest gap found [m]
SIDE_BEST_Y: Final[int] = 1          # its wheel abscissa
SIDE_BEST_RAIL: Final[int] = 2       # and its rail abscissa, while the roll is sought
SIDE_FIRST: Final[int] = 3           # first and last of the scan nodes listed as candidates for further regions:
SIDE_LAST: Final[int] = 4
SIDE_NODE: Final[int] = 8            # their numbers
SIDE_ABSCISSA: Final[int] = 48       # their places on the rail [m]
SIDE_STACK: Final[int] = 88          # cells still to be searched
