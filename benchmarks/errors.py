"""Errors and poses.

Errors against independent references are mean and worst errors of penetration, area and peak pressure.
*Positions*: the right wheel from tread to flange (data/positions.csv).  *Hunting run*: both wheels during
growing hunting with yaw and load transfer (hunting.csv).  Both are results of a half-space
solver on the true three-dimensional gap, whose own errors are 0.004, 0.9 and 0.6 %.

Besides them: what other preparations of ANALYN's input change, what the number of stations decides, and the
elastic equilibrium.
"""

import math
from functools import cache
from typing import NamedTuple

import numpy as np

import data
import wrcontact
from wrcontact.halfspace.contact import solve_contact
from wrcontact.halfspace.wheel_on_rail import wheel_on_rail
from wrcontact.kernel import layout
from wrcontact.progress import tracked

FORCE = 78.5e3  # [N]
SHIFT, YAW = 6.6e-3, 0.02  # [m, rad] amplitudes of the timed runs
ANY_YAW = 0.035  # [rad] 2 deg
PATCH = ("penetration", "area", "max_pressure")
PLACE = ("x_wheel", "y_wheel", "z_wheel")
SIDES = ("left", "right")


@cache
def system(**options):
    return wrcontact.ContactSystem(**options)


# ------------------------------------------------------------------------------------------------------ poses


def trajectory(count, yaw=YAW):
    """Lateral shift [m] and yaw [rad]: from flange to flange, about twice in 2000 poses; yaw a quarter cycle
    apart."""
    turn = 12.0 * np.arange(count) / 2000
    return SHIFT * np.sin(turn), yaw * np.cos(turn)


def anywhere(count, yaw=ANY_YAW):
    """Lateral shift [m] and yaw [rad] (count,) of independent random poses."""
    random = np.random.default_rng(0)
    return random.uniform(-SHIFT, SHIFT, count), yaw * random.uniform(-1, 1, count)


def inputs_of(poses, force=FORCE):
    """Inputs (n, INPUT_COUNT) of lateral shifts [m] and yaws [rad] under a force [N]; the others are zero."""
    shift, yaw = poses
    inputs = np.zeros((len(shift), layout.INPUT_COUNT))
    for place, values in (
        (layout.IN_LATERAL_SHIFT, shift),
        (layout.IN_YAW, yaw),
        (layout.IN_NORMAL_FORCE, force),
    ):
        inputs[:, place] = values
    return inputs


# --------------------------------------------------------------------------------------- against stored poses


class Errors(NamedTuple):
    """Relative errors of penetration, area and peak pressure (3,)."""

    mean: np.ndarray
    worst: np.ndarray
    count: int  # wheels that were compared


@cache
def positions(system):
    """:class:`Errors` on the 20 positions."""
    run = data.columns(data.POSITIONS)
    table = system.evaluate_many(run["lateral_shift"], run["yaw"], run["normal_force"])
    return compared(table, run, ("right",))


@cache
def hunting(system, every=1, yawed=True):
    """:class:`Errors` at each ``every``-th row of the hunting run; ``yawed=False`` sets the yaw to zero."""
    run = {name: column[::every] for name, column in data.columns(data.HUNTING).items()}
    table = system.evaluate_many(
        run["lateral_shift"], run["yaw"] * yawed, run["normal_force"], run["load_transfer"]
    )
    return compared(table, run, SIDES)


def compared(table, run, sides):
    """:class:`Errors` of a table of states against a stored run; ArithmeticError if a pose is not solved."""
    if np.any(table.status != 0):
        raise ArithmeticError(
            f"{np.sum(table.status != 0)} of the stored poses are not solved: {set(table.status.tolist())}"
        )
    shares = np.array(
        [
            np.concatenate(
                [getattr(getattr(table, side), name) / run[f"{side}.{name}"] - 1 for side in sides]
            )
            for name in PATCH
        ]
    )
    return summary(shares)


def summary(shares):
    """:class:`Errors` from signed relative errors (3, n)."""
    size = np.abs(shares)
    return Errors(size.mean(axis=1), size.max(axis=1), size.shape[1])


def percentages(positions, hunting):
    """Both :class:`Errors` as they are kept [%]."""
    return {
        "positions mean": 100 * positions.mean,
        "positions worst": 100 * positions.worst,
        "hunting mean": 100 * hunting.mean,
        "hunting worst": 100 * hunting.worst,
    }


def rigid(system):
    """Largest errors of the rigid contact in the hunting run: roll [rad] and contact position [mm]."""
    run = data.columns(data.HUNTING)
    table = system.evaluate_many(run["lateral_shift"], run["yaw"], run["normal_force"], run["load_transfer"])
    place = max(
        np.max(np.abs(getattr(getattr(table, side).contact, name) - run[f"{side}.contact.{name}"]))
        for side in SIDES
        for name in PLACE
    )
    return {"roll": np.max(np.abs(table.roll - run["roll"])), "position": place * 1e3}


# ----------------------------- other preparations of ANALYN's input (docs/theory/curvature.md)


CHOICE_SHIFTS = {"1 mm (tread)": 1e-3, "6 mm (flange root)": 6e-3, "6.5 mm (flange)": 6.5e-3}  # [m]
CHOICES = (
    ("separation", "vertical"),
    ("separation", "equidistant"),
    ("separation", "equidistant_chord"),
    ("longitudinal_curvature", "basic"),
    ("lateral_curvature", "smooth"),
    ("lateral_curvature", "rough"),
)
CHOICE_NODES = 38  # so many that their number has no part in the choice_changes


def choice_patches(**options):
    """Penetration, area and peak pressure (3, 3) of the right wheel at CHOICE_SHIFTS."""
    table = system(nodes=CHOICE_NODES, **options).evaluate_many(list(CHOICE_SHIFTS.values()), 0.0, FORCE)
    return np.array([getattr(table.right, name) for name in PATCH]).T


def choice_changes():
    """Rows by choice: changes [%] of penetration, area and peak pressure at each shift."""
    usual = choice_patches()
    found = {f'{name} "{choice}"': choice_patches(**{name: choice}) for name, choice in CHOICES}
    return {name: dict(zip(CHOICE_SHIFTS, 100 * (values / usual - 1))) for name, values in found.items()}


# ---------------------------------------------------------------------- stations of the outline
# (docs/guides/fmu.md)


STATION_NUMBERS = (31, 61, 201)
STATION_SHIFT = 1e-3  # [m] one patch on the tread


def station_errors():
    """By number: station_errors [%] of area and load from the trapezoidal rule over the outline."""
    found = {}
    for number in STATION_NUMBERS:
        side = system(stations=number).evaluate(STATION_SHIFT).right
        outline, steps = side.outline, np.diff(side.outline.station)
        area, load = (
            float(np.sum(0.5 * (values[1:] + values[:-1]) * steps))
            for values in (2.0 * outline.half_length, 0.5 * np.pi * outline.half_length * outline.pressure)
        )
        found[str(number)] = {
            "area": 100 * abs(area / side.area - 1),
            "load": 100 * abs(load / side.normal_force - 1),
        }
    return found


# ------------------------------------------------- elastic equilibrium (docs/theory/elastic.md)


TRIAL_POSES = 500
MODELS = "hertz", "analyn", "analyn_strip"
NEAR = 6.5  # [mm] flange contact begins


def trials(model, load):
    """Trials of each of TRIAL_POSES random poses, up to 8 mm and 0.03 rad, 1 ... 150 kN."""
    rng = np.random.default_rng(4)
    stepper = system(contact_mode="elastic", normal_model=model, load=load).stepper()
    side, found = layout.Work.at(stepper._workspace).sides[1], []
    for shift, yaw, force in rng.uniform((-8e-3, -0.03, 1e3), (8e-3, 0.03, 150e3), (TRIAL_POSES, 3)):
        stepper.inputs[[0, 1, 3]] = shift, yaw, force
        before = side.roll_count
        stepper.step()
        found.append(side.roll_count - before)
    return np.array(found)


def largest_roll_step(yaw, step=1e-6):
    """Largest step of the roll [rad] from -8 to 8 mm, and how far from the middle [mm]: at both signs of the
    shift it is the same but for rounding."""
    shift = np.arange(-8e-3, 8e-3, step)
    table = system(contact_mode="elastic").evaluate_many(shift, yaw, FORCE)
    steps = np.abs(np.diff(table.roll))
    return steps.max(), 1e3 * abs(shift[np.argmax(steps)] + 0.5 * step)


def all_trials():
    """By model and load: mean, 99 % and largest number of trials."""
    rows = {}
    for model in MODELS:
        for load in ("normal", "vertical"):
            count = trials(model, load)
            rows[f"{model}, load {load}"] = {
                "mean": count.mean(),
                "99 %": np.percentile(count, 99),
                "most": count.max(),
            }
    return rows


def roll_steps(quick=False):
    """By yaw: largest change of the roll [µrad] in 1 µm of lateral shift, and where [mm]."""
    rows = {}
    for degrees in tracked((0, 1, 2), "rolls of the elastic wheelset"):
        largest, shift = largest_roll_step(math.radians(degrees), 1e-4 if quick else 1e-6)
        rows[f"{degrees}°"] = {"step": 1e6 * largest, "at": shift}
    return rows


def manchester():
    """Largest difference from the rolls of the Manchester contact benchmark, case A-2.2 [µrad], elastic and
    rigid, up to NEAR [mm] and beyond."""
    run = data.columns(data.MANCHESTER)
    shift, left, right = (
        run[name] for name in ("lateral_shift_mm", "normal_force_left_N", "normal_force_right_N")
    )
    rows = {}
    for mode in ("elastic", "rigid"):
        table = system(contact_mode=mode).evaluate_many(
            1e-3 * shift, run["yaw_rad"], (left + right) / 2, (right - left) / (left + right)
        )
        off = 1e6 * np.abs(table.roll - run["roll_rad"])
        rows[mode] = {"near": off[shift <= NEAR].max(), "beyond": off[shift > NEAR].max()}
    return rows


# ---------------------------------------------------------------------- patches that turn
# (docs/theory/conformal.md)


TURNING_SHIFTS = (1e-3, 6e-3, 6.25e-3)  # [m]
TURNING_UNITS = (1e-6, 1e-6, 1e6)  # µm, mm², MPa
TURNING_MODELS = {"halfspace": "half-space", "analyn_strip": "strips", "analyn": "ANALYN"}


def turning_patches(quick=False):
    """Rows by name: both theories at TURNING_SHIFTS, with rigid contact; errors [%] of force, area and
    peak pressure against CONTACT, with compliant contact.  A quick run takes the first pose and row alone."""
    count = 1 if quick else None
    return {
        **turning_poses(TURNING_SHIFTS[:count]),
        **{model: against_contact(model, count) for model in TURNING_MODELS},
    }


def turning_poses(shifts):
    """Penetration [um], area [mm2] and peak pressure [MPa] by pose and theory."""
    found = {}
    for shift in shifts:
        planar = planar_contact(system(), system().evaluate(shift, 0.0, FORCE), FORCE)
        turning = system(normal_model="halfspace").evaluate(shift, 0.0, FORCE, side="right").right
        found[f"{1e3 * shift:g} mm"] = {
            name: [getattr(each, quantity) / unit for quantity, unit in zip(PATCH, TURNING_UNITS)]
            for name, each in (("planar", planar), ("conformal", turning))
        }
    return found


def against_contact(model, count=None):
    """Mean and worst error [%], and those of every row or of ``count``."""
    rows = data.rows_of(data.CONFORMAL)[:count]
    errors = []
    for row in rows:
        side = (
            system(normal_model=model, contact_mode="compliant")
            .evaluate(
                row["lateral_shift_mm"] * 1e-3,
                math.radians(row["yaw_deg"]),
                side="right",
                vertical_shift_input=row["vertical_shift_mm"] * 1e-3,
                roll_input=row["roll_rad"],
            )
            .right
        )
        given = row["N_f_N"], row["area_f_mm2"] * 1e-6, row["pmax_f_MPa"] * 1e6
        errors.append(100.0 * (np.array([side.normal_force, side.area, side.max_pressure]) / given - 1.0))
    names = [
        f"{row['lateral_shift_mm']:g} mm, {row['yaw_deg']:g}°, {row['vertical_load_kN']:g} kN" for row in rows
    ]
    return {
        "mean": np.mean(np.abs(errors), axis=0),
        "worst": np.max(np.abs(errors), axis=0),
        **dict(zip(names, errors)),
    }


# The half-space as it is usually taken, over one plane: wheel and rail along the normals of the plane that
# touches them at the rigid contact point, and pressures that act on each other without regard to their
# normals.  It is here for comparison alone: where a patch turns around the rail it is not the truth.

REACH = 0.03  # [m] of the domain around the contact point


def planar_contact(system, state, force):
    """The right wheel's contact over the plane at its rigid contact point, under a ``force`` [N] along the
    plane's normal.

    Parameters
    ----------
    system : :class:`~wrcontact.ContactSystem` with rigid contact.
    state : of this system, at one pose.

    Returns
    -------
    HalfspaceContact
        whose stations count from the contact point.

    Raises
    ------
    ArithmeticError
        where the solution is not found.
    """
    tables = system.stepper().tables
    pair = wheel_on_rail(
        tables,
        1,
        lateral_shift=state.inputs[layout.IN_LATERAL_SHIFT],
        yaw=state.inputs[layout.IN_YAW],
        roll=state.roll,
        vertical_shift=state.vertical_shift,
    )
    wheel = state.right
    return solve_contact(
        plane_gap(pair, wheel.contact, wheel.contact_angle),
        (-REACH, REACH, -REACH, REACH),
        contact_modulus=layout.Tables.at(tables).contact_modulus,
        force=force,
    )


def plane_gap(pair, contact, angle):
    """The gap over the plane through a rigid contact point with this contact ``angle`` [rad], as a function
    of x (n,) from there and s (m,) [m]."""

    def gap(x, s):
        y, z = contact.y_track + s * math.cos(angle), contact.z_track - s * math.sin(angle)
        normal = np.full(len(s), angle)
        along = np.broadcast_to(x[:, None] + contact.x_track, (len(x), len(s)))
        bow = 0.5 * x[:, None] ** 2 * math.cos(angle) / pair.radius
        with np.errstate(invalid="ignore"):
            return pair.wheel_along(along, y, z, normal, bow + 0.0 * s) - pair.rail_along(
                y, z, normal, np.zeros(len(s))
            )

    return gap
