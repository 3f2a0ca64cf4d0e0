"""The arrays ``setup``, from which the tables are prepared, and ``tables``: what is fixed during a simulation.

Settings are at the head of the tables, then come the tables that they point to.
"""

from .interface import Parameters, Resolution
from .normal import InfluenceTable
from .record import Float, To, record
from .surface import CurvatureTable, Profile


@record
class Setup:
    array = "setup"
    parameters: Parameters
    resolution: Resolution
    absent: float                   # not a number


@record
class Tables:
    array = "tables"
    radius: float                   # nominal radius [m]
    arm: float                      # half the distance of the running circles [m]
    rail_y: float                   # track coordinate of the right rail's highest point [m]
    contact_modulus: float          # E* [Pa]
    lateral_limit: float            # largest |lateral shift| [m]
    yaw_limit: float                # largest |yaw| [rad]
    wheel: To(Profile)
    rail: To(Profile)
    scan: float                     # offsets of the tables
    hertz: float
    normal_model: float             # one of MODEL_...
    longitudinal: float             # one of LONGITUDINAL_...
    penetration: Float * 2          # prescribed, left and right [m]; not a number: the force is prescribed
    nodes: float                    # nodes per half-width of the interpenetration, a multiple of five
    stride: float                   # every so many of them are traced on the profiles
    strips: int                     # strips of the strip correction that are asked for
    sweeps: int                     # and how often it is made
    influence: To(InfluenceTable)   # how its strips displace the half-space beside them
    starts: float                   # offset of the table of starts
    sides: float                    # which sides are wanted, one of SIDES_...
    depth: float                    # what is wanted of them, one of DEPTH_...
    absent: float                   # what stands in outputs that are not wanted: not a number
    stations: float                 # stations of an outline; where it then lies is told in outline.py
    separation: float               # one of SEPARATION_...
    lateral: float                  # one of LATERAL_...
    wheel_curvature: To(CurvatureTable)
    rail_curvature: To(CurvatureTable)
    spare_28: Float * 2
    mode: float                     # one of MODE_...
    load: float                     # one of LOAD_...
    parameters: Parameters          # all of the setup's
