"""Into a curve with flange contact: the run through the transition, and the steady state behind it.

    python -m examples.hunting_wheelset.curve_entry [FOLDER]

prints the steady state and draws FOLDER/curve_entry.png.  There is no cant, so that the
centrifugal force of the load pushes outwards with 13 % of it.
"""

import sys
from pathlib import Path

import numpy as np
from scipy.optimize import root

import wrcontact
from wrcontact.plots.style import INK, MM, QUIET, SIDE_COLOUR, new_figure, save, styled

from .coupling import CONTACT, Loop, build
from .wheelset import CONTACT_INPUTS, Wheelset

SPEED, RADIUS_OF_CURVE = 14.0, 150.0  # [m/s], [m]
WHEELSET = {
    "frame_speed": SPEED,
    "curve_curvature": 1 / RADIUS_OF_CURVE,
    "curve_start": 5.0,
    "transition_length": 20.0,
    "longitudinal_stiffness": 8e6,
    "lateral_stiffness": 1e5,
    "lateral_damping": 2e4,
    "longitudinal_damping": 2e4,
    "half_wheelbase": 1.25,
    "canted": 0.0,
}
DURATION, STEP = 4.0, 1e-4  # [s]
SEEN = (
    "distance",
    "track_curvature",
    *(
        f"{side}.{name}"
        for side in ("left", "right")
        for name in ("force.y", "force.z", "patch[1].contact_angle")
    ),
)


def enter(archives, wheelset=WHEELSET, contact=None, duration=DURATION, every=10):
    """The run into the curve, every ``every``-th step of it."""
    with Loop(archives, wheelset, contact, seen=SEEN) as loop:
        return loop.run(duration, STEP, every=every)


def equilibrium(system, wheelset, guess):
    """The steady state in the full curve without any run: motion (9,), for which the accelerations vanish.

    Parameters
    ----------
    system : a compliant :class:`wrcontact.ContactSystem`, evaluated in Python, without an FMU.
    wheelset : parameters of the wheelset.
    guess : motion (9,) near it, whose velocities but for that of the wheels are zero.

    Raises
    ------
    RuntimeError
        if no steady state is found from there.
    """
    model = Wheelset(instance_name="steady")
    model.parameters.update(wheelset)
    model.prepare()
    scale = np.array([1e-3, 1e-4, 1e-4, 1e-3, 1e-1])
    moving = [0, 1, 2, 3, 8]

    def accelerations(scaled):
        motion = np.zeros(9)
        motion[moving] = scaled * scale
        inputs = {name.replace(".", "_"): value for name, value in zip(CONTACT_INPUTS, motion)}
        state = system.evaluate(
            **inputs, speed=wheelset["frame_speed"], track_curvature=wheelset["curve_curvature"]
        )
        model.forces.update(
            {
                "force.y": state.force.y,
                "force.z": state.force.z,
                "moment.x": state.moment.x,
                "moment.y": state.moment.y,
                "moment.z": state.moment.z,
                "driving_torque": state.driving_torque,
            }
        )
        model.place, model.rate = motion[:4].tolist(), motion[4:].tolist()
        return model.accelerations(wheelset["curve_start"] + 2 * wheelset["transition_length"])

    found = root(accelerations, np.asarray(guess)[moving] / scale, method="hybr", options={"xtol": 1e-10})
    if not np.abs(found.fun).max() < 1e-3:  # [m/s2, rad/s2]
        raise RuntimeError(f"no steady state in the curve: {found.message}")
    motion = np.zeros(9)
    motion[moving] = found.x * scale
    return motion


@styled
def draw(run):
    """Figure of a run: curvature, lateral shift and yaw, forces on both rails."""
    figure = new_figure(7.2, 6.4)
    axes = figure.subplots(3, sharex=True, height_ratios=(1, 2, 2))
    way = run["distance"]
    axes[0].plot(way, 1e3 * run["track_curvature"], color=INK)
    axes[0].set_ylabel("curvature [1/km]")
    axes[1].plot(way, run["lateral_shift"] / MM, color=INK, label="lateral shift [mm]")
    axes[1].plot(way, 1e3 * run["yaw"], color=QUIET, linestyle="--", label="yaw [mrad]")
    for side, colour in SIDE_COLOUR.items():
        axes[2].plot(way, -run[f"{side}.force.y"] / 1e3, color=colour, label=f"{side}, to the right")
        axes[2].plot(way, -run[f"{side}.force.z"] / 1e3, color=colour, linestyle=":", label=f"{side}, down")
    axes[2].set_ylabel("force on the rail [kN]")
    axes[2].set_xlabel("distance [m]")
    axes[1].legend(ncols=2)
    axes[2].legend(ncols=2, loc="center right", bbox_to_anchor=(1.0, 0.66))
    figure.suptitle(f"Into a curve to the right of {RADIUS_OF_CURVE:g} m at {SPEED:g} m/s, S1002 on UIC60")
    return figure


if __name__ == "__main__":
    folder = Path((sys.argv[1:] or ["out"])[0])
    run = enter(build(folder))
    system = wrcontact.ContactSystem(**CONTACT)
    end = run.motion[-1]
    still = equilibrium(system, WHEELSET, end)
    for name, column in (("lateral shift [mm]", 0), ("roll [mrad]", 2), ("yaw [mrad]", 3)):
        print(f"{name:20s} run {1e3 * end[column]:10.6f}   equilibrium {1e3 * still[column]:10.6f}")
    ratio = run["left.force.y"][-1] / run["left.force.z"][-1]
    print(f"left wheel Y/Q {abs(ratio):.3f}, largest status {run.worst_status}")
    save(draw(run), folder / "curve_entry.png")
