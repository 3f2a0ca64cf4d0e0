"""The errors that plant_errors.py plants, and where they stand in the sources."""

from collections import namedtuple

from tests.helpers.paths import ROOT
from tests.helpers.planted_answers import ANSWERS
from tests.helpers.planted_asked import ASKED
from tests.helpers.planted_files import FILED
from tests.helpers.planted_laws import LAWS
from tests.helpers.planted_rolling import ROLLING_LAWS
from tests.helpers.planted_sections import SECTIONED
from tests.helpers.planted_strips import STRIP_LAWS
from tests.helpers.planted_wear import WORN

#: ``old`` occurs once in the kernel, and is replaced by ``new``; the tests in the room or the file
#: ``first`` run before all others. ``module`` is the flat name of the kernel's file, or the path of a
#: file elsewhere; without it the file is the one of the kernel in which ``old`` occurs.
Error = namedtuple("Error", "name old new meaning first module", defaults=[""])

ERRORS = [
    Error(
        "end_from_minimum",
        "y = held(frame.traces[WHEEL].abscissa - direction * width * frame.plane.cos)",
        "y = region.wheel",
        "of a width that ends at a profile's end the derivative is sought beyond that end",
        "derivative/test_derivatives.py",
    ),
    Error(
        "end_inner",
        "inner = held(width) * (1.0 - 10.0 * HALVED_SHARP)",
        "inner = held(width) * (1.0 + 10.0 * HALVED_SHARP)",
        "the derivative of a width that ends at a profile's end is taken behind that end",
        "derivative/test_derivatives.py",
    ),
    Error(
        "end_of_wheel",
        "if nonzero(out) and (y < pair.wheel.start + WIDTH_TRACE or",
        "if nonzero(out) and (y < pair.wheel.start - WIDTH_TRACE or",
        "a width that ends at the wheel's inner end does not follow that end",
        "derivative/test_derivatives.py",
    ),
    Error(
        "same_penetration",
        "if prescribed == self._penetration:  # by value: an array may have changed in place",
        "if self._penetration is not None:  # by value: an array may have changed in place",
        "a penetration that follows another one is taken for the same",
        "wheelset/test_bounded_work.py",
        "wrcontact/stepper.py",
    ),
    Error(
        "sliver_without_pressure",
        "if patch.pressure_square == 0.0 and patch.totals.load > 0.0:",
        "if patch.pressure_square < 0.0 and patch.totals.load > 0.0:",
        "a patch between two strips has neither pressure nor length",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "jump_on_one_side",
        "if steady == 1:\n        roll = bracket.low",
        "if steady == 2:\n        roll = bracket.low",
        "at a jump the wheel that jumps carries less than its load",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "unbounded_contradictions",
        "and fabs(method.move_height) + fabs(method.move_roll) > NOT_LAST:\n            return roll, NOT_CONVERGED",
        "and fabs(method.move_height) + fabs(method.move_roll) > NOT_LAST:\n            method.best += 0.0",
        "trials that a search contradicts go round in a circle",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "creep_slope_over_time",
        "over = 1.0 / (step * work.inputs.rail_time_step)",
        "over = 0.0 / (step * work.inputs.rail_time_step)",
        "rails on springs settle without the slope of the creep forces over the time step",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "rails_leave_a_jump",
        "settled.standing = not is_balanced(equilibrium, work.sides[index], UNSETTLED)",
        "settled.standing = is_balanced(equilibrium, work.sides[index], -1.0)",
        "rails at a jump settle anew for each rate of the axle",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "difference_of_another_force",
        "slopes.vertical_vertical = (equilibrium.vertical - left_vertical) / DIFFERENCE",
        "slopes.vertical_vertical = (equilibrium.vertical - left_lateral) / DIFFERENCE",
        "a rail settles by Newton's method with a wrong derivative",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "bracket_without_slope",
        "share = GROWTH * patch.normal_z / (patch.totals.load * patch.penetration)",
        "share = 0.0 * patch.normal_z / (patch.totals.load * patch.penetration)",
        "a rail at a jump is bracketed without the slope of the contact",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "rail_beside_a_jump",
        "if vertical != nearer_end(bracket):\n        status",
        "if vertical == nearer_end(bracket):\n        status",
        "a rail stands at the farther end of a jump",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "roll_sign",
        "difference = sides[1].best - sides[0].best\n    rate",
        "difference = sides[1].best + sides[0].best\n    rate",
        "a sign in the equation of the roll",
        "search",
    ),
    Error(
        "missed_minimum",
        "    walk(pair, side, node, -1)",
        "    walk(pair, side, node, 1)",
        "the gap is searched to one side only: a minimum on the other is missed",
        "search/test_corners.py",
    ),
    Error(
        "bound_at_the_end",
        "search_cell(pair, side, min(least, -1.0), most, low, high)",
        "search_cell(pair, side, -1.0, most, low, high)",
        "where the rail ends, its gap is taken to bend down by no more than 1 1/m",
        "search/test_corners.py",
    ),
    Error(
        "sharp_corner",
        "if turn > LEAST_CORNER and (",
        "if turn > 1e9 and (",
        "corners between zones are not rounded: the search does not see their jump of slope",
        "search/test_corners.py",
    ),
    Error(
        "corner_step",
        "z_0 + half, slope_0, bend_0, z_1 - half",
        "z_0, slope_0, bend_0, z_1",
        "a corner's piece does not reach the heights to which its sides are led",
        "search/test_corners.py",
    ),
    Error(
        "turned_joint",
        "MEETING: Final[float] = 1e-4",
        "MEETING: Final[float] = 1e-9",
        "an inclined rail ends at its first step in height",
        "search/test_corners.py",
    ),
    Error(
        "hidden_gap",
        "HIDDEN: Final[float] = 1e-11",
        "HIDDEN: Final[float] = 1e-7",
        "a cell of the search may hide 0.1 um",
        "search/test_corners.py",
    ),
    Error(
        "own_bound",
        "own_most = most_rail - least_wheel +",
        "own_most = least_rail - least_wheel +",
        "a part of a cell is bounded by the wrong bend of its rail",
        "search/test_corners.py",
    ),
    Error(
        "unsettled_roll",
        "        return settled, True\n",
        "        return roll, True\n",
        "the roll is the one that the search has ended at, from wherever it started",
        "system/test_one_state.py",
    ),
    Error(
        "unsure_grid",
        "UNSURE: Final[float] = 2e-12",
        "UNSURE: Final[float] = -1.0",
        "a roll between two places of the grid is rounded as its last bits come",
        "system/test_one_state.py",
    ),
    Error(
        "stale_minima",
        "if known and before_left ==",
        "if known or before_left ==",
        "the minima of the step before are taken though the search has found a smaller one",
        "search/test_corners.py",
    ),
    Error(
        "stale_outputs",
        "workspace.known = False",
        "workspace.known = True",
        "after a step that failed, its inputs count as those of the outputs",
        "wheelset/test_skips.py",
        "rows",
    ),
    Error(
        "swapped_loads",
        "1.0 + float(2 * index - 1) * inputs.load_transfer",
        "1.0 + float(1 - 2 * index) * inputs.load_transfer",
        "load is transferred to the other side",
        "normal/test_normal_contact.py",
    ),
    Error(
        "mirror_yaw",
        "mirrored.sin_yaw = -place.sin_yaw",
        "mirrored.sin_yaw = place.sin_yaw",
        "the left wheel is mirrored without its yaw",
        "search/test_corners.py",
    ),
    Error(
        "yaw_term",
        "(around * around / r - bend * e2 * e2) / steep",
        "around * around / (r * steep)",
        "the longitudinal curvature lacks its term of yaw",
        "normal/test_conformal.py",
    ),
    Error(
        "wrong_profile",
        "(pair.rail_curvature, abscissa)",
        "(pair.wheel_curvature, abscissa)",
        "the rail's curvature is read in the wheel's table",
        "contact/test_separation.py",
    ),
    Error(
        "off_profile",
        "    if fabs(mismatch) >= PARALLEL:",
        "    if fabs(mismatch) >= 1e9:",
        "a wheel on the end of a profile is not reported by its status",
        "search/test_rigid.py",
    ),
    Error(
        "hertz_power",
        "penetration = root * root\n",
        "penetration = root * sqrt(root)\n",
        "the power 1/2 for Hertz's 2/3",
        "normal/test_normal_contact.py",
    ),
    Error(
        "hertz_cell",
        "(octave + HERTZ_OCTAVES) + cell) + column",
        "(octave + HERTZ_OCTAVES) + cell + 1) + column",
        "Hertz's table is read one cell too far",
        "normal/test_normal_contact.py",
    ),
    Error(
        "arc_series",
        "ARC_10: Final[float] = -0.01759",
        "ARC_10: Final[float] = -0.01749",
        "the last coefficient of the arc tangent is wrong in its third digit",
        "elementary/test_elementary.py",
    ),
    Error(
        "analyn_axes",
        "beta = table_value(table, 0, A / side)",
        "beta = table_value(table, 0, side / A)",
        "ANALYN's 1 + beta is taken for the other axis",
        "normal/test_auto.py",
    ),
    Error(
        "last_node",
        "region.last = after",
        "region.last = after - 1",
        "a region ends one node early",
        "normal/test_auto.py",
    ),
    Error(
        "isolated_patches",
        "    result *= planes_cosine(one, other)",
        "    result *= 0.0 * planes_cosine(one, other)",
        "patches side by side do not press on each other",
        "normal/test_conformal.py",
    ),
    Error(
        "full_cell",
        "return mean - bend / 6.0",
        "return mean + bend / 6.0",
        "the load of a cell has its bend with the other sign",
        "normal/test_normal_contact.py",
        "wrcontact/kernel/patch/quadrature.py",
    ),
    Error(
        "early_end",
        "NEARLY_SHARP: Final[float] = 1e-9",
        "NEARLY_SHARP: Final[float] = 1e-4",
        "Newton's method for the force gives up some steps early",
        "normal/test_normal_contact.py",
    ),
    Error(
        "elastic_loads",
        "side_status = balance_side(tables, work, 1, right, height)",
        "side_status = balance_side(tables, work, 1, left, height)",
        "the right elastic wheel carries the left one's load",
        "wheelset/test_bounded_work.py",
    ),
    Error(
        "elastic_sharp",
        "ELASTIC_SHARP: Final[float] = 1e-13",
        "ELASTIC_SHARP: Final[float] = 1e-8",
        "the elastic equilibrium is found to a tolerance thousands of times wider",
        "derivative/test_derivatives.py",
    ),
    Error(
        "cell_joint",
        "cell.jump = cell.rail_jump * cell.share",
        "cell.jump = -cell.rail_jump * cell.share",
        "the bend of an overlap jumps the other way at a joint of the rail",
        "contact/test_turning_cells.py",
    ),
    Error(
        "light_centroid",
        "if totals.load > 0.0:\n        totals.centroid",
        "if totals.load > 1.0:\n        totals.centroid",
        "the patch of a light wheel has its centroid at the contact point",
        "patch/test_filling.py",
    ),
    Error(
        "light_torque",
        "if not torque > 0.0:\n        return low",
        "if not torque > 1.0:\n        return low",
        "the rotation of a light wheel is sought beside its solution",
        "creep/test_free_rolling.py",
    ),
    Error(
        "edge_traction",
        "    p_x = 0.0\n    p_y = 0.0\n    if weight < 1.0:",
        "    p_x = 0.0\n    p_y = 1.0\n    if weight < 1.0:",
        "tractions behind a stick zone add to those of no slip zone",
        "creep/test_creep_forces.py",
        "traction_integration",
    ),
    Error(
        "strips_to_the_edge",
        "    if after <= patch.last:\n        outer = strips[after]",
        "    if after > patch.last:\n        outer = strips[after]",
        "between strips the outline falls to zero at the edge of the patch",
        "patch/test_stations.py",
        "outline",
    ),
    Error(
        "no_move_without_derivatives",
        "        if not fabs(determinant) > SINGULAR:\n            return False",
        "        if not fabs(determinant) < SINGULAR:\n            return False",
        "an elastic search ends where the derivatives that it has found are lost",
        "wheelset/test_elastic.py",
        "elastic",
    ),
    Error(
        "touching_arch",
        "if not spread > 0.0:\n        return 0.0\n    first_root",
        "if not spread > 0.0:\n        return 1.0\n    first_root",
        "a strip's pressure that only touches zero has a load",
        "patch/test_quadrature.py",
    ),
    Error(
        "chord_expansion",
        "2.0 / 15.0 * bend * width",
        "2.0 / 16.0 * bend * width",
        "the load of nearly straight pressures is expanded with another coefficient",
        "patch/test_quadrature.py",
    ),
    Error(
        "foot_not_followed",
        "        error += change\n",
        "        error += 0.0 * change\n",
        "a slope that was not followed to the foot of its normal is taken for known",
        "contact/test_turning_cells.py",
    ),
    Error(
        "cell_departure",
        "rest = node.departure + length * (0.2",
        "rest = 0.0 * length * (0.2",
        "the bend of an overlap is taken for straight between two samples",
        "contact/test_turning_cells.py",
    ),
    Error(
        "falling_stretch",
        "largest_fall(0.5 * left, bend, length, stretch)",
        "largest_fall(1.0 * left, bend, length, stretch)",
        "an overlap counts as one that only falls where it may rise again",
        "contact/test_turning_cells.py",
    ),
    Error(
        "turning_normal",
        "left = slope - TURNED * depth * scan.rail[cell].turns[reach]",
        "left = slope + TURNED * depth * scan.rail[cell].turns[reach]",
        "what a turning normal takes from the slope of an overlap is added to it",
        "contact/test_turning_cells.py",
    ),
    Error(
        "rail_way",
        "return way + (abscissa - found) / rate",
        "return way - (abscissa - found) / rate",
        "a sign in the way along the rail at an abscissa",
        "contact/test_overlap.py",
    ),
    Error(
        "rate_departure",
        "return least > departure",
        "return least > 0.0 * departure - 100.0",
        "a cell counts as one in which the slope difference rises whatever its bounds say",
        "search/test_search_bounds.py",
    ),
    Error(
        "moment",
        "y * force_z - z * force_y",
        "y * force_z + z * force_y",
        "a sign in the moment of a patch",
        "wheelset/test_damping.py",
        "patch_places",
    ),
    Error(
        "piece",
        "-15.0 * rest + 7.0 * slope - bend",
        "-15.0 * rest + 8.0 * slope - bend",
        "a wrong coefficient of the profiles' quintics",
        "prepare/test_preparation.py",
    ),
    Error(
        "scan_bound",
        "cell.least_bends[exponent] = least",
        "cell.least_bends[exponent] = most",
        "the search takes the rail's largest bend for its smallest one",
        "search/test_corners.py",
    ),
    Error(
        "derivative_rule",
        "y = moving(y, -mismatch / held(rate))",
        "y = moving(y, mismatch / held(rate))",
        "the contact moves the wrong way in the derivatives",
        "derivative/test_derivatives.py",
    ),
    Error(
        "moment_z",
        "normal_moment[2] += x * force_y",
        "normal_moment[2] += 0.0 * x * force_y",
        "the moment about the vertical axis is zero",
        "wheelset/test_damping.py",
        "patch_places",
    ),
    Error(
        "halved_slant",
        "region.slant = slant / (start",
        "region.slant = 0.5 * slant / (start",
        "the ridge of a yawed wheel's patch is half as oblique",
        "normal/test_strip_properties.py",
    ),
    Error(
        "inclined",
        "INCLINED: Final[float] = 0.9659258262890683",
        "INCLINED: Final[float] = 0.9063077870366499",
        "the lead of one patch over another counts from 25 degrees on instead of 15",
        "contact/test_planes.py",
    ),
    Error(
        "swapped_extents",
        """out.patch_length = 2.0 * totals.max_half_length
    out.patch_width = totals.width""",
        """out.patch_width = 2.0 * totals.max_half_length
    out.patch_length = totals.width""",
        "the kernel writes a wheel's patch length as its width",
        "interface/test_witnesses.py",
    ),
    Error(
        "swapped_names",
        """"patch_length", "m", 1e-2, "length of the contact in rolling direction", 0.0),
    Output(
        "patch_width",
        "m",
        1e-2,
        "width of the contact in the contact plane, from first to last loaded point",
        0.0,
    ),""",
        """"patch_width", "m", 1e-2, "length of the contact in rolling direction", 0.0, field="patch_length"),
    Output(
        "patch_length",
        "m",
        1e-2,
        "width of the contact in the contact plane, from first to last loaded point",
        0.0,
        field="patch_width",
    ),""",
        "the outputs patch_length and patch_width of the FMUs have each other's names",
        "interface/test_witnesses.py",
        "wrcontact/interface/outputs.py",
    ),
    Error(
        "pressure_in_newtons",
        "out.max_pressure = totals.max_pressure\n    out.length",
        "out.max_pressure = totals.max_pressure * totals.area\n    out.length",
        "the pressure of a patch is written in N",
        "interface",
    ),
    Error(
        "creep_mirror",
        "add_vector(total.force, part.force, 1.0, mirror)",
        "add_vector(total.force, part.force, 1.0, 1.0)",
        "the left wheel's force points right",
        "creep",
    ),
    Error(
        "creep_across",
        "patch.creepage_y = -(normal_z",
        "patch.creepage_y = (normal_z",
        "the lateral slip has the other sign",
        "creep",
    ),
    Error(
        "creep_power",
        "friction_power = -patch.speed",
        "friction_power = patch.speed",
        "a sign in the friction power",
        "creep",
    ),
    Error(
        "creep_spin",
        "+ cosine * turning",
        "- cosine * turning",
        "the moment of spin turns the other way about the vertical axis",
        "creep",
    ),
    Error(
        "wear_share",
        "fabs(patch.creep_y * patch.creepage_y)",
        "fabs(patch.creep_y * patch.creepage_x)",
        "the wear number takes the wrong creepage",
        "interface/test_witnesses.py",
    ),
    Error(
        "spring_rest",
        "stiffness * (deflection - rest) - force",
        "stiffness * deflection - force",
        "dampers hold a rail to its foot, not to where it has been",
        "wheelset/test_springs.py",
    ),
    Error(
        "spring_mirror",
        "lateral = -work.inputs.left_rail_deflection_lateral_before",
        "lateral = work.inputs.left_rail_deflection_lateral_before",
        "the left rail has come from the other side",
        "wheelset/test_springs.py",
    ),
    Error(
        "spring_rate",
        "deflection.vertical_rate = (vertical - equilibrium.vertical_before) / time_step",
        "deflection.vertical_rate = 0.0",
        "a rail on dampers moves down without a velocity",
        "wheelset/test_springs.py",
    ),
    Error(
        "spring_friction",
        "            solve_side_creep(tables, work, index)\n        sum_side",
        "            pass\n        sum_side",
        "springs carry the creep forces of another deflection",
        "wheelset/test_springs.py",
    ),
    Error(
        "friction_side",
        "friction = work.inputs.right_friction",
        "friction = work.inputs.left_friction",
        "the right wheel has the left one's friction",
        "creep",
    ),
    Error(
        "friction_fall",
        "exp(-parameters.friction_fall_rate * sliding) + fall",
        "exp(-parameters.friction_fall_rate * sliding)",
        "friction falls to zero",
        "creep",
    ),
    Error(
        "friction_flange",
        "share = 0.5 + 0.5 * (angle -",
        "share = 0.5 - 0.5 * (angle -",
        "the tread has the friction of the flange",
        "creep",
    ),
    Error(
        "friction_slope",
        "initial = parameters.slope_reduction",
        "initial = 1.0",
        "wet rails do not reduce the initial slope",
        "creep",
    ),
    Error(
        "friction_load",
        "-forces.force[2] / wanted",
        "-forces.normal_force[2] / wanted",
        "a vertical load leaves out what friction carries",
        "creep",
    ),
    # lines drawn by --lines 30 --seed 1914, with one word changed by hand.  Passed over are what is no more
    # than the start of an iteration (traces.py: trace.bend), a branch for no yaw whose formula holds with yaw
    # as well (locus.py: place.yawed), and a rate that is zero there (contact_rules.py: start + place)
    Error(
        "drawn_width",
        "totals.width = totals.stop - totals.start",
        "totals.width = totals.stop + totals.start",
        "the width of a patch is the sum of its edges' stations",
        "interface",
    ),
    Error(
        "drawn_step",
        "step = float(direction) * region.spacing",
        "step = -float(direction) * region.spacing",
        "the mean normal of a pressed wheel takes the rail on the other side",
        "wheelset",
        "patch_places",
    ),
    Error(
        "drawn_place",
        "z_2, slope = height_slope(Profile.at(tables, profile), y_2)",
        "z_2, slope = height_slope(Profile.at(tables, profile), y_1)",
        "the rough curvature takes the height of another node",
        "surface",
    ),
    Error(
        "drawn_capability",
        '"canHandleVariableCommunicationStepSize": "true"',
        '"canHandleVariableCommunicationStepSize": "false"',
        "FMUs of FMI 2 say that their steps are equal",
        "fmu/test_python_description.py",
        "wrcontact/fmu/description.py",
    ),
    Error(
        "drawn_root",
        "q = sqrt(last)",
        "q = sqrt(first)",
        "an integral of a root takes both ends for the first",
        "patch/test_quadrature.py",
    ),
    Error(
        "drawn_depth",
        "if tables.depth == DEPTH_ALL:",
        "if tables.depth != DEPTH_ALL:",
        "an outline is written where none is asked for",
        "interface",
        "side",
    ),
    Error(
        "drawn_weight",
        "0.1494513491505804\n    work[scratch + 2]",
        "0.1594513491505804\n    work[scratch + 2]",
        "a weight of Gauss's formula",
        "surface",
    ),
    Error(
        "drawn_index",
        "index: int | None = None",
        "index: int | None = 0",
        "the status counts as the first of the kernel's outputs",
        "results",
        "wrcontact/interface/variables.py",
    ),
    Error(
        "drawn_slope",
        "slope = p1 + u * (p2 + u * (p3",
        "slope = p1 + u * (p2 - u * (p3",
        "a sign in the slope of the profiles",
        "prepare",
        "tables",
    ),
    Error(
        "drawn_bound",
        "low = min(max(low, start), stop)",
        "low = max(max(low, start), stop)",
        "the search takes the bends at the end of a profile for those of a stretch",
        "search",
        "prepare_scan",
    ),
    *(
        Error(*law)
        for law in (*ANSWERS, *ASKED, *FILED, *LAWS, *ROLLING_LAWS, *SECTIONED, *STRIP_LAWS, *WORN)
    ),
]


def planted(text, error):
    """``text`` of the module with the error in it."""
    found = text.count(error.old)
    if found != 1:
        raise ValueError(f"{error.name}: {error.old!r} occurs {found} times, and should occur once")
    return text.replace(error.old, error.new)


def source_of(error, root=ROOT):
    """The file in which the error is planted."""
    from tools.transpile_kernel import FILES, flat_name

    if "/" in error.module:
        return root / error.module
    paths = FILES["kernel_modules"](root / "wrcontact" / "kernel")
    if error.module:
        return next(path for path in paths if flat_name(path) == error.module)
    found = [path for path in paths if error.old in path.read_text(encoding="utf-8")]
    if len(found) != 1:
        raise ValueError(
            f"{error.name}: {error.old!r} occurs in {len(found)} files of the kernel, and should occur in one"
        )
    return found[0]
