"""The outputs: one row for each, in the order of the kernel's array.

A new output takes a row here and the code in the kernel that writes its field.
"""

from .rows import Blocks, Output, Run, Vector

#: Patches that are reported for each wheel.
PATCH_LIMIT = 3
#: Stations of an outline, unless another number is asked for: at least and at most.
STATION_COUNT, STATION_LEAST, STATION_LIMIT = 31, 3, 201

PATCH = (
    Output("normal_force", "N", 1e5, "normal force", 0.0),
    Output("area", "m2", 1e-4, "contact area", 0.0),
    Output("max_pressure", "Pa", 1e9, "highest contact pressure", 0.0),
    Output("length", "m", 1e-2, "length in rolling direction", 0.0),
    Output("width", "m", 1e-2, "width in the contact plane", 0.0),
    Output(
        "centroid", "m", 1e-3, "centre of load in the contact plane, from the contact point to the field side"
    ),
    Output(
        "contact_angle",
        "rad",
        0.1,
        "angle of its force: that of the rail's normal at its centre of load, positive towards the flange",
    ),
    Output(
        "penetration",
        "m",
        1e-4,
        "local penetration of the undeformed surfaces at its point of smallest gap or largest overlap",
    ),
    Output(
        "rolling_radius",
        "m",
        0.5,
        "rolling radius at its centre of load: nominal radius plus height of the wheel profile",
        0.0,
    ),
    Output("x_track", "m", 1e-3, "centre of load in the track frame, forward"),
    Output(
        "y_track",
        "m",
        1.0,
        "centre of load in the track frame, to the right of the track centre (not mirrored)",
    ),
    Output("z_track", "m", 1e-3, "centre of load in the track frame, down from top of rail"),
    Vector("force", "N", 1e5, "force of the rail on the wheel, {axis}"),
    Output(
        "creepage.x",
        "1",
        1e-3,
        "longitudinal creepage at its centre of load: velocity of the wheel "
        "against the rail, forward, over the rolling speed",
        field="creepage_x",
    ),
    Output(
        "creepage.y",
        "1",
        1e-3,
        "lateral creepage, in the plane of the patch, positive to the left on both sides",
        field="creepage_y",
    ),
    Output(
        "creepage.spin",
        "1/m",
        1.0,
        "spin: rotation of the wheel about the normal from the rail to the wheel, over the rolling speed",
        field="spin",
    ),
    Output("tangential.x", "N", 1e4, "creep force on the wheel, forward", field="creep_force_x"),
    Output(
        "tangential.y",
        "N",
        1e4,
        "creep force on the wheel, in the plane of the patch to the field side",
        field="creep_force_y",
    ),
    Output(
        "tangential.moment",
        "N.m",
        10.0,
        "moment of the tractions on the wheel about the normal from the "
        "rail to the wheel through its centre of load",
        field="creep_moment",
    ),
    Output(
        "stick_share",
        "1",
        1.0,
        "share of the area that sticks; zero where the model does not know it",
        0.0,
        1.0,
    ),
    Output("max_shear", "Pa", 1e8, "largest traction; zero where the model does not know it", 0.0),
    Output("friction_power", "W", 1e3, "power that friction takes from the motion"),
    Output("saturation", "1", 1.0, "creep force over friction times normal force", 0.0),
    Output(
        "wear_number",
        "N",
        100.0,
        "wear number T gamma: creep forces times creepages without spin; this "
        "and what follows is zero without fatigue_outputs",
        0.0,
    ),
    Output("fatigue_damage", "1", 1e-6, "T gamma damage of a passage; a sum of 1 begins a crack", 0.0),
    Output(
        "shakedown_ratio",
        "1",
        1.0,
        "peak pressure of an ellipse with its load and area, over yield_shear",
        0.0,
    ),
    Output(
        "surface_fatigue_index",
        "1",
        0.1,
        "creep force over normal force, minus 1 / shakedown_ratio; "
        "above zero the surface yields at every passage",
    ),
    Output(
        "slope",
        "rad",
        0.01,
        "inclination of the normal of its force along the track, positive where it pushes back; zero on a rail "
        "that is the same all along the track",
    ),
)

#: Outputs of one wheel.  Those up to ``curvature_y`` are its geometry, those from ``penetration`` on follow
#: from its load.
SIDE = (
    Output("patch_count", "1", 1.0, "number of loaded regions", 0, PATCH_LIMIT, whole=True),
    Output(
        "contact.x_wheel",
        "m",
        1e-3,
        "contact point in the wheel profile frame, forward of the principal "
        "profile; the frame yaws and rolls with the wheelset but does not spin",
    ),
    Output(
        "contact.y_wheel",
        "m",
        1e-2,
        "contact point in the wheel profile frame, from the running circle to the field side",
    ),
    Output(
        "contact.z_wheel", "m", 1e-3, "contact point in the wheel profile frame, down from the running circle"
    ),
    Output(
        "contact.y_rail",
        "m",
        1e-2,
        "contact point in the rail profile frame, from the highest point of "
        "the inclined head to the field side",
    ),
    Output(
        "contact.z_rail",
        "m",
        1e-3,
        "contact point in the rail profile frame, down from the highest point of the inclined head",
    ),
    Output("contact.x_track", "m", 1e-3, "contact point in the track frame, forward"),
    Output(
        "contact.y_track",
        "m",
        1.0,
        "contact point in the track frame, to the right of the track centre (not mirrored)",
    ),
    Output("contact.z_track", "m", 1e-3, "contact point in the track frame, down from top of rail"),
    Output("contact_angle", "rad", 0.1, "contact angle, positive towards the flange"),
    Output(
        "rolling_radius",
        "m",
        0.5,
        "rolling radius at the contact point: nominal radius plus height of the wheel profile",
        0.0,
    ),
    Output(
        "curvature_x",
        "1/m",
        1.0,
        "relative (combined) principal curvature of wheel and rail at the "
        "contact point, in rolling direction",
    ),
    Output(
        "curvature_y",
        "1/m",
        10.0,
        "relative (combined) principal curvature of wheel and rail at the contact point, across the rail",
    ),
    Output("penetration", "m", 1e-4, "penetration: approach of the two bodies", 0.0),
    Output("normal_force", "N", 1e5, "normal force, total over the patches", 0.0),
    Output("area", "m2", 1e-4, "contact area, total over the patches", 0.0),
    Output("max_pressure", "Pa", 1e9, "highest contact pressure", 0.0),
    Output("patch_length", "m", 1e-2, "length of the contact in rolling direction", 0.0),
    Output(
        "patch_width",
        "m",
        1e-2,
        "width of the contact in the contact plane, from first to last loaded point",
        0.0,
    ),
    Output(
        "patch_centroid",
        "m",
        1e-3,
        "centre of load in the contact plane, from the contact point to the field side",
    ),
    Vector("force", "N", 1e5, "force of the rail on the wheel, {axis}"),
    Vector("moment", "N.m", 1e4, "moment of this force about the wheelset's centre, around the axis {axis}"),
    Vector(
        "normal.force",
        "N",
        1e5,
        "part of the force that is due to the pressures alone, {axis}",
        field="normal_part",
    ),
    Vector(
        "normal.moment",
        "N.m",
        1e4,
        "moment of this part about the wheelset's centre, around the axis {axis}",
        field="normal_moment",
    ),
    Output("friction_power", "W", 1e3, "power that friction takes from the motion, sum over the patches"),
    Output(
        "wear_number",
        "N",
        100.0,
        "wear number T gamma: creep forces times creepages without spin, sum over the patches",
        0.0,
    ),
    Output(
        "driving_torque",
        "N.m",
        1e3,
        "torque of the creep forces about the axle, positive where they turn the wheel forward",
    ),
    Output(
        "damping_power", "W", 10.0, "power that contact damping takes from the motion, sum over the patches"
    ),
    Output(
        "derailment_quotient",
        "1",
        0.1,
        "Y/Q of EN 14363: force of the wheel on its rail, outwards over "
        "downwards; zero where it does not press its rail down",
    ),
    Output(
        "rail_deflection_lateral",
        "m",
        1e-3,
        "displacement of the rail from the foot of its springs, to the right; zero where it is rigid",
    ),
    Output(
        "rail_deflection_vertical",
        "m",
        1e-3,
        "displacement of the rail from the foot of its springs, down; zero where it is rigid",
    ),
    Output(
        "wheel_rate_found",
        "rad/s",
        20.0,
        "rotation about the axle that creepages hold for: the one that is given, or that follows",
    ),
    Output(
        "model_error",
        "1",
        0.01,
        "estimate of the relative error of max_pressure, of the normal_model auto, and of analyn with "
        "error_outputs; else zero",
        0.0,
    ),
    Blocks("patch", PATCH_LIMIT, PATCH, "patch"),
    Run(
        "station",
        "m",
        1e-3,
        "lateral position of an outline station in the contact plane, from the contact "
        "point to the field side",
    ),
    Run("half_length", "m", 1e-2, "half the length of the patch in rolling direction at the station", 0.0),
    Run("pressure", "Pa", 1e9, "contact pressure on the centre line of the patch at the station", 0.0),
    Run("shear", "Pa", 1e8, "creep force per area, mean over the length of the patch at the station", 0.0),
    Run(
        "slip",
        "m/s",
        0.01,
        "sliding velocity at the station, such that shear times slip is the friction power per area",
        0.0,
    ),
)

#: Outputs of the wheelset, ahead of those of the left and then the right wheel.
WHEELSET = (
    Output("roll", "rad", 1e-3, "Roll of the wheelset, positive with the right wheel down"),
    Output("vertical_shift", "m", 1e-3, "Vertical shift of the wheelset, positive down"),
    Vector("force", "N", 1e5, "Resultant of the contact forces on the wheelset, {axis}"),
    Vector(
        "moment",
        "N.m",
        1e4,
        "Moment of the contact forces about the wheelset's centre, around the axis {axis}",
    ),
    Vector(
        "normal.force",
        "N",
        1e5,
        "Part of the resultant that is due to the pressures alone, {axis}",
        field="normal_part",
    ),
    Vector(
        "normal.moment",
        "N.m",
        1e4,
        "Moment of this part about the wheelset's centre, around the axis {axis}",
        field="normal_moment",
    ),
    Output(
        "driving_torque",
        "N.m",
        1e3,
        "Torque of the creep forces about the axle, positive where they turn the wheels forward",
    ),
)

#: Outputs of one wheel that follow all others, if the parameter wear_outputs is true.
WEAR = (
    Run(
        "wheel_place",
        "m",
        1e-2,
        "place of the station in the wheel profile frame, from the running circle to the field side",
    ),
    Run(
        "rail_place",
        "m",
        1e-2,
        "place of the station in the rail profile frame, from the highest point of "
        "the inclined head to the field side",
    ),
    Run(
        "power",
        "W/m",
        1e5,
        "friction power per width at the station; its trapezoidal sum over the stations "
        "is the friction power of the wheel",
    ),
    Run(
        "patch_of",
        "1",
        1.0,
        "number of the patch that the station lies in, between patches of the nearest one; zero without load",
        0.0,
    ),
)

#: Of each strip of a patch along the rolling direction; in Python only, with wear_outputs.
STRIPS = (
    Output(
        "wheel_place",
        "m",
        1e-2,
        "place of its middle in the wheel profile frame, from the running circle to the field side",
    ),
    Output(
        "rail_place",
        "m",
        1e-2,
        "place of its middle in the rail profile frame, from the highest point "
        "of the inclined head to the field side",
    ),
    Output("width", "m", 1e-3, "width across the rail, as stations count it", 0.0),
    Output("line_load", "N/m", 1e7, "load per width", 0.0),
    Output("half_length", "m", 1e-2, "half its length in rolling direction", 0.0),
    Output("power", "W/m", 1e5, "friction power per width"),
    Output("slip", "m/s", 0.01, "sliding velocity: friction power over creep force", 0.0),
)
