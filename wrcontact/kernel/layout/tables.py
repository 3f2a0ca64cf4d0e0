"""The arrays ``setup``, from which the tables are prepared, and ``tables``: what is
fixed during a simulation.

Each side has its tables. Where both sides are equal they are one array. Settings of the whole wheelset are
read from those of the right side, as are the starts.

Settings are at the head of the tables, then come the tables that they point to.
"""

from .interface import Parameters, Resolution
from .normal import HertzTable, InfluenceTable
from .record import Float, To, record
from .search import Scan, Starts
from .surface import CubicTable, CurvatureTable, Profile
from .tangential import RollingTable


@record
class Setup:
    array = "setup"
    parameters: Parameters
    resolution: Resolution
    height: float                   # of the wheelset's centre, the mean of both nominal radii [m]
    absent: float                   # not a number


@record
class Tables:
    array = "tables"
    radius: float                   # nominal radius [m]
    height: float                   # of the wheelset's centre, the mean of both nominal radii [m]
    arm: float                      # half the distance of the running circles [m]
    rail_y: float                   # track coordinate of the right rail's highest point [m]
    contact_modulus: float          # E* [Pa]
    lateral_limit: float            # largest |lateral shift| [m]
    yaw_limit: float                # largest |yaw| [rad]
    wheel: To(Profile)
    rail: To(Profile)
    scan: To(Scan)
    hertz: To(HertzTable)
    normal_model: int               # one of MODEL_...
    longitudinal: int               # one of LONGITUDINAL_...
    penetration: Float * 2          # prescribed, left and right [m]; not a number: the force is prescribed
    nodes: int                      # nodes per half-width of the interpenetration, a multiple of five
    stride: int                     # every so many of them are traced on the profiles
    strips: int                     # strips of the strip model that are asked for
    sweeps: int                     # and how often it is made
    influence: To(InfluenceTable)   # how its strips displace the half-space beside them
    starts: To(Starts)
    sides: int                      # which sides are wanted, one of SIDES_...
    depth: int                      # what is wanted of them, one of DEPTH_...
    absent: float                   # what stands in outputs that are not wanted: not a number
    stations: int                   # stations of an outline; where it then lies is told in outline.py
    separation: int                 # one of SEPARATION_...
    lateral: int                    # one of LATERAL_...
    wheel_curvature: To(CurvatureTable)
    rail_curvature: To(CurvatureTable)
    rail_arc: To(CubicTable)        # arc length of the rail from its start [m] over its abscissa
    rail_at_arc: To(CubicTable)     # and the abscissa over the arc length
    mode: int                       # one of MODE_...
    load: int                       # one of LOAD_...
    tangential: int                 # one of TANGENTIAL_...
    shear_modulus: float            # G of wheel and rail [Pa]
    rolling: To(RollingTable)       # what the models of creep forces read; 0 where none is chosen
    parameters: Parameters          # all of the setup's
