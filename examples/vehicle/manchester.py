"""Data of the passenger vehicle of the Manchester benchmarks.

Iwnicki, S. (1998). Manchester benchmarks for rail vehicle simulation. Vehicle System Dynamics 30 (3-4),
295-313: vehicle 1.  The paper was not at hand.  "Compared" are numbers that another program has from it: the
file on the Manchester vehicle in VEqMon2D (github.com/DanielCanteroNTNU/VEqMon2D).  The others are from
memory of the paper, or ours.  Left out are the series springs of the dampers, the bump stops and the bending
of the air springs.
"""

from dataclasses import dataclass

GRAVITY = 9.81  # [m/s2]
WHEEL_RADIUS = 0.46  # [m]


@dataclass(frozen=True)
class Body:
    """Mass [kg], moments of inertia in roll, pitch and yaw [kg m2], height of the centre [m]."""

    mass: float
    inertia: tuple
    height: float


@dataclass(frozen=True)
class Suspension:
    """Stiffness [N/m] and damping [N s/m] along, across and down."""

    stiffness: tuple
    damping: tuple


#: Masses, pitch inertia of car and frame: compared.  Other inertias, and heights: from memory.
CAR = Body(32000.0, (56800.0, 1.97e6, 1.97e6), 1.8)
FRAME = Body(2615.0, (1722.0, 1476.0, 3067.0), 0.6)
WHEELSET = Body(1813.0, (1120.0, 112.0, 1120.0), WHEEL_RADIUS)
#: Half distances [m]: of the pivots and of the wheelsets of a bogie (compared); of axle boxes and springs.
HALF_PIVOTS, HALF_BASE, HALF_BOXES, HALF_SPRINGS = 9.5, 1.28, 1.0, 1.0
#: Of an axle box.  Down: damping compared; stiffness from memory, VEqMon2D has 1.20e6.  Along and across:
#: stiffness from memory, damping ours.
PRIMARY = Suspension((31.391e6, 3.884e6, 1.22e6), (15e3, 2e3, 4e3))
#: Ours: an axle box so soft along the track that the bogie hunts at a speed that trains reach.
SOFT = Suspension((2e6, 3.884e6, 1.22e6), (0.0, 2e3, 4e3))
#: Of one side of a bogie, at this height [m].  Down: compared.  Along and across: from memory.
SECONDARY, SECONDARY_HEIGHT = Suspension((0.16e6, 0.16e6, 0.43e6), (0.0, 32e3, 20e3)), 0.83
#: Of a bogie: stiffness of the roll bar [N m/rad], from memory; stiffness in pitch [N m/rad], and of the
#: traction rod [N/m, N s/m]: ours.
ROLL_BAR, PITCH, ROD = 0.94e6, 21e3, (5e6, 25e3)
#: Weight on both wheels of a wheelset [N].
LOAD = GRAVITY * (CAR.mass / 4 + FRAME.mass / 2 + WHEELSET.mass)
