"""Hunting: Klingel's wave at low speed, the critical speed, and the limit cycle beyond it.

    python -m examples.hunting_wheelset.hunting [FOLDER]

prints the figures and draws FOLDER/hunting.png.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import wrcontact
from wrcontact.conditioning import equivalent_conicity
from wrcontact.plots.style import CONTACT_COLOUR, MM, QUIET, WHEEL_COLOUR, new_figure, save, styled

from .coupling import CONES, CONTACT, Loop, build
from .stability import Linear

RADIUS, LOAD = 0.46, 157e3  # [m], [N]
STEP = 1e-4  # [s]
#: Cases of Klingel's wave: contact, and lateral shift at the start [m]; and their speed [m/s].
KLINGEL, SLOW = {"cone 1:20": (CONES, 0.5e-3), "S1002": (CONTACT, 3e-3)}, 10.0
#: Soft primary suspension, one axle box, for the critical speed of S1002: [N/m], [N.s/m].
SOFT = {"longitudinal_stiffness": 2e5, "lateral_stiffness": 1e5, "vertical_damping": 3e4}
#: Stiffer, and without dampers, for that of the cone.
SUSPENSION = {"longitudinal_stiffness": 3.6e5, "lateral_stiffness": 2e5}
#: Speeds [m/s] of the limit cycles, and the starts [m] of a small and of a large swing.
SPEEDS, SMALL, LARGE = (20.0, 25.0, 30.0, 33.0, 36.0, 39.0, 42.0, 45.0, 50.0), 0.3e-3, 5e-3
#: How long a cycle is awaited [s].
PATIENCE = 6.0


# --- Klingel ------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Rolling:
    """Rolling radii of a pair of profiles under load: ``shift`` (n,), ``difference`` of the radii, right
    minus left (n,), ``roll`` (n,) and the half distance of the contacts ``arm``, in m and rad."""

    shift: np.ndarray
    difference: np.ndarray
    roll: np.ndarray
    arm: float

    def conicity(self, amplitude):
        """Equivalent conicity for a wheelset that swings by ``amplitude`` [m]."""
        return float(np.ravel(equivalent_conicity(self.shift, self.difference, amplitude))[0])

    def wavelength(self, amplitude, rolls=True):
        """Klingel's 2 pi sqrt(b r0 / tan(gamma)) [m]; with ``rolls``, of a wheelset that also rolls about its
        x axis (docs/reference/conventions.md): 1 - r0 dq/dy more under the root."""
        slope = np.interp(amplitude, self.shift, self.roll) / amplitude if rolls else 0.0
        return 2 * np.pi * np.sqrt(self.arm * RADIUS * (1 - RADIUS * slope) / self.conicity(amplitude))


def rolling(system, reach, count=121):
    """:class:`Rolling` of a system, each wheel's radius and place weighted by the loads of its patches, for
    lateral shifts of -``reach`` ... ``reach`` [m]."""
    shifts = np.linspace(-reach, reach, count)
    states = [system.evaluate(lateral_shift=shift, normal_force=LOAD / 2) for shift in shifts]

    def mean(wheel, name):
        loads = [patch.normal_force for patch in wheel.patches]
        return np.average([getattr(patch, name) for patch in wheel.patches], weights=loads)

    def apart(name):
        """Right minus left (n,)."""
        return np.array([mean(state.right, name) - mean(state.left, name) for state in states])

    return Rolling(
        shifts,
        apart("rolling_radius"),
        np.array([state.roll for state in states]),
        float(apart("y_track").mean()) / 2,
    )


def crossings(x, y):
    """Places where ``y`` (n,) passes zero, linear in between."""
    k = np.flatnonzero(y[:-1] * y[1:] < 0)
    return x[k] - y[k] * (x[k + 1] - x[k]) / (y[k + 1] - y[k])


def measured_wave(run, skip=1):
    """Wavelength [m] and amplitude [m] of a run from zero to zero, without the first ``skip`` half waves,
    while the wheelset finds its rotation and its roll."""
    way = run["distance"]
    zeros = crossings(way, run["lateral_shift"])[skip:]
    inside = (way >= zeros[0]) & (way <= zeros[-1])
    amplitude = np.ptp(run["lateral_shift"][inside]) / 2
    return 2 * np.mean(np.diff(zeros)), amplitude


def elastic(contact):
    """The :class:`wrcontact.ContactSystem` of a contact FMU with these parameters, in elastic contact."""
    return wrcontact.ContactSystem(
        wheel=contact.get("wheel_profile", "S1002"),
        contact_mode="elastic",
        rail_inclination=contact.get("rail_inclination", 0.025),
    )


def klingel(archives, contact, start, waves=2.5):
    """Measured wavelength, its amplitude, Klingel's wavelength with and without roll [m], and the run, of a
    free wheelset from ``start`` [m]."""
    curve = rolling(elastic(contact), 1.6 * start)
    given = {"frame_speed": SLOW, "start_lateral_shift": start}
    with Loop(archives, given, contact, seen=("distance",)) as loop:
        run = loop.run(waves * curve.wavelength(start) / SLOW, STEP)
    wave, amplitude = measured_wave(run)
    return wave, amplitude, curve.wavelength(amplitude), curve.wavelength(amplitude, rolls=False), run


# --- critical speed and limit cycle -------------------------------------------------------------------------


def cycle(archives, speed, start, duration, contact=None, suspension=SOFT, step=STEP):
    """A run at ``speed`` [m/s] from ``start`` [m], and its amplitude at the end [m], over its last fifth."""
    with Loop(archives, suspension | {"frame_speed": speed, "start_lateral_shift": start}, contact) as loop:
        run = loop.run(duration, step, every=10)
    return run, np.ptp(run["lateral_shift"][-len(run.time) // 5 :]) / 2


def growth(run):
    """Growth [1/s] of an oscillation, from its turning points; nan for fewer than four."""
    y = run["lateral_shift"]
    k = np.flatnonzero((y[1:-1] - y[:-2]) * (y[2:] - y[1:-1]) < 0) + 1
    if len(k) < 4:
        return np.nan
    sizes = np.abs(np.diff(y[k]))
    return np.polyfit((run.time[k][1:] + run.time[k][:-1]) / 2, np.log(sizes), 1)[0]


def cycles(archives, speeds=SPEEDS, patience=PATIENCE):
    """Runs at each speed from a large and a small swing: lists of (run, amplitude at the end [m])."""
    return {start: [cycle(archives, speed, start, patience) for speed in speeds] for start in (LARGE, SMALL)}


@styled
def draw(linear, found, speeds=SPEEDS):
    """Figure of the growth of small swings, the amplitudes reached, and a limit cycle.

    Parameters
    ----------
    linear : an open :class:`Linear` of the same wheelset.
    found : what :func:`cycles` returns for ``speeds``.
    """
    critical = linear.critical_speed(20.0, 80.0)
    figure = new_figure(7.6, 6.4)
    (grows, reached), (swing, plane) = figure.subplots(2, 2)
    sweep = np.linspace(5.0, speeds[-1], 46)
    grows.plot(sweep, [linear.root(speed).real for speed in sweep], color=WHEEL_COLOUR)
    grows.axhline(0.0, color=QUIET, linewidth=0.8)
    grows.set(title="Growth of small swings", xlabel="speed [m/s]", ylabel="growth [1/s]")
    for start, marker, words in ((LARGE, "o", "from a large swing"), (SMALL, "x", "from a small swing")):
        reached.plot(
            speeds,
            [amplitude / MM for _, amplitude in found[start]],
            marker,
            color=CONTACT_COLOUR,
            fillstyle="none",
            label=f"{words}, {start / MM:g} mm",
        )
    reached.set(title=f"Amplitude after {PATIENCE:g} s", xlabel="speed [m/s]", ylabel="lateral shift [mm]")
    reached.legend(loc="center right", fontsize=8, frameon=True, framealpha=1.0, edgecolor="none")
    for panel in (grows, reached):
        panel.axvline(critical, color=QUIET, linestyle="--", linewidth=0.8)
    grows.annotate(
        f"{critical:.1f} m/s",
        (critical, grows.get_ylim()[1]),
        xytext=(3, -10),
        textcoords="offset points",
        fontsize=8,
        color=QUIET,
    )
    place = len(speeds) - 2
    run = found[SMALL][place][0]
    swing.plot(run.time, run["lateral_shift"] / MM, color=WHEEL_COLOUR, linewidth=0.8)
    swing.set(
        title=f"{speeds[place]:g} m/s, from a small swing", xlabel="time [s]", ylabel="lateral shift [mm]"
    )
    last = slice(-len(run.time) // 5, None)
    plane.plot(run["lateral_shift"] / MM, 1e3 * run["yaw"], color=QUIET, linewidth=0.4)
    plane.plot(run["lateral_shift"][last] / MM, 1e3 * run["yaw"][last], color=CONTACT_COLOUR)
    plane.set(title="Its limit cycle", xlabel="lateral shift [mm]", ylabel="yaw [mrad]")
    return figure


if __name__ == "__main__":
    folder = Path((sys.argv[1:] or ["out"])[0])
    archives = build(folder)
    for name, case in KLINGEL.items():
        wave, amplitude, rolled, plain, run = klingel(archives, *case)
        print(
            f"{name}: amplitude {amplitude / MM:.3f} mm, wavelength {wave:.3f} m, Klingel {plain:.3f} m, "
            f"with roll {rolled:.3f} m, difference {100 * (wave / rolled - 1):.2f} %, "
            f"status {run.worst_status}"
        )
    with Linear(archives, SOFT) as linear:
        print(f"critical speed {linear.critical_speed(20.0, 80.0):.2f} m/s")
        found = cycles(archives)
        for start, row in found.items():
            print(
                f"from {start / MM:g} mm: "
                + ", ".join(
                    f"{speed:g} m/s {amplitude / MM:.2f} mm" for speed, (_, amplitude) in zip(SPEEDS, row)
                )
            )
        save(draw(linear, found), folder / "hunting.png")
