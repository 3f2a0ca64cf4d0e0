"""The errors that plant_errors.py plants, and where they stand in the sources."""

from collections import namedtuple

from tests.helpers.paths import ROOT

#: ``old`` occurs once in the kernel, and is replaced by ``new``; the tests in the room
#: ``first`` run before all others. ``module`` is the flat name of the kernel's file, or the path of a
#: file elsewhere; without it the file is the one of the kernel in which ``old`` occurs.
Error = namedtuple("Error", "name old new meaning first module", defaults=[""])

ERRORS = [
    Error("roll_sign", "difference = sides[1].best - sides[0].best\n    rate",
          "difference = sides[1].best + sides[0].best\n    rate",
          "a sign in the equation of the roll", "search"),
    Error("missed_minimum", "    walk(tables, side, state, node, -1, 0)",
          "    walk(tables, side, state, node, 1, 1)",
          "the gap is searched to one side only: a minimum on the other is missed", "search"),
    Error("stale_minima", "if known == 1 and before_left ==", "if known == 1 or before_left ==",
          "the minima of the step before are taken though the search has found a smaller one", "search"),
    Error("stale_outputs", "workspace.known = False", "workspace.known = True",
          "after a step that failed, its inputs count as those of the outputs", "wheelset"),
    Error("swapped_loads", "sign = float(2 * index - 1)", "sign = float(1 - 2 * index)",
          "load is transferred to the other side", "normal"),
    Error("mirror_yaw", "mirrored.sin_yaw = -place.sin_yaw", "mirrored.sin_yaw = place.sin_yaw",
          "the left wheel is mirrored without its yaw", "search"),
    Error("yaw_term", "(around * around / r - bend * e2 * e2) / steep", "around * around / (r * steep)",
          "the longitudinal curvature lacks its term of yaw", "normal"),
    Error("wrong_profile", "(tables.rail_curvature, abscissa)", "(tables.wheel_curvature, abscissa)",
          "the rail's curvature is read in the wheel's table", "contact"),
    Error("off_profile", "    if fabs(mismatch) >= PARALLEL:", "    if fabs(mismatch) >= 1e9:",
          "a wheel on the end of a profile is not reported by its status", "search"),
    Error("hertz_power", "stiffness)) ** (2.0 / 3.0)", "stiffness)) ** (3.0 / 4.0)",
          "the power 3/4 for Hertz's 2/3", "normal"),
    Error("hertz_cell", "at = HERTZ_ROW * cell + column",
          "at = HERTZ_ROW * (cell + 1) + column",
          "Hertz's table is read one cell too far", "normal"),
    Error("analyn_axes", "beta = table_value(table, 0, log(A / side))",
          "beta = table_value(table, 0, log(side / A))",
          "ANALYN's 1 + beta is taken for the other axis", "normal"),
    Error("last_node", "region.last = after", "region.last = after - 1", "a region ends one node early",
          "normal"),
    Error("isolated_patches", "    result *= planes_cosine(one, other)",
          "    result *= 0.0 * planes_cosine(one, other)", "patches side by side do not press on each other",
          "normal"),
    Error("early_end", "NEARLY_SHARP: Final[float] = 1e-9", "NEARLY_SHARP: Final[float] = 1e-4",
          "Newton's method for the force gives up some steps early", "normal"),
    Error("strip_near", "row[j] += near_share(", "row[j] -= near_share(",
          "the correction of neighbouring strips has the wrong sign", "normal"),
    Error("elastic_loads", "outcome = balance_side(tables, work, state, 1, right, height)",
          "outcome = balance_side(tables, work, state, 1, left, height)",
          "the right elastic wheel carries the left one's load", "wheelset"),
    Error("elastic_sharp", "ELASTIC_SHARP: Final[float] = 1e-13", "ELASTIC_SHARP: Final[float] = 1e-10",
          "the elastic equilibrium is found to a tolerance a thousand times wider", "tangent"),
    Error("moment", "resultant[3] += y * force_z - z * force_y", "resultant[3] += y * force_z + z * force_y",
          "a sign in the moment of a patch", "wheelset"),
    Error("piece", "-15.0 * rest + 7.0 * slope - bend", "-15.0 * rest + 8.0 * slope - bend",
          "a wrong coefficient of the profiles' quintics", "prepare"),
    Error("scan_bound", "cell.least_bends[exponent] = least", "cell.least_bends[exponent] = most",
          "the search takes the rail's largest bend for its smallest one", "search"),
    Error("tangent_rule", "y = moving(y, -mismatch / held(rate))", "y = moving(y, mismatch / held(rate))",
          "the contact moves the wrong way in the derivatives", "tangent"),
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
        raise ValueError(f"{error.name}: {error.old!r} occurs in {len(found)} files of the kernel, and "
                         f"should occur in one")
    return found[0]
