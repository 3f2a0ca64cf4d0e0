"""Frames, signs, units, and the one mirror between left and right.

Track frame
    x forward, y to the right, z down; origin on the track centre line at top-of-rail height.
Wheelset
    centre at (0, lateral_shift, vertical_shift - nominal_radius); attitude R = Rz(yaw) Rx(roll),
    yaw positive clockwise from above (x to y), roll positive from y to z (right wheel down).
Wheel profile frame
    y to the field side from the running circle (flange at negative y), z down; the radius at y is the nominal
    radius plus the profile height.
Rail profile frame
    track-parallel axes, y to the field side, z down; origin at the highest point of the inclined head.
Left
    The left side is the mirror image of the right side in the plane y = 0: :data:`MIRROR` turns a pose of the left wheel into
    one of a right wheel, and the resulting y in the track frame back.  Longitudinal and vertical components stay.

All values inside are in m, N, Pa and rad.  Millimetres and degrees are used only in files and plots.
"""

MILLIMETRE = 1e-3  #: [m]

#: Signs that turn (lateral_shift, yaw, roll) of a left wheel into those of the equivalent right wheel, and back.
MIRROR = (-1.0, -1.0, -1.0)

SIDES = ("left", "right")
