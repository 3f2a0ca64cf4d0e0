"""The runs of docs/guides/vehicle.md with the whole vehicle, and their picture."""

import numpy as np

from wrcontact.plots.style import INK, MM, QUIET, SIDE_COLOUR, new_figure, styled

from . import hunting, theory
from . import manchester as data
from .contact import Contact, Nearby
from .track import Track, bulge, irregular

#: Over the bulge: solver of exudyn, step [s], how the contact answers, whether each iteration has a Jacobian.
SOLVERS = {
    "`VelocityVerlet`": ("VelocityVerlet", 0.25e-3, Contact, False),
    "`RK44`": ("RK44", 0.5e-3, Contact, False),
    "`GeneralizedAlpha`, Jacobian kept": ("GeneralizedAlpha", 1e-3, Contact, False),
    "the same, near motions by derivatives": ("GeneralizedAlpha", 1e-3, Nearby, False),
    "`GeneralizedAlpha`, full Newton": ("GeneralizedAlpha", 1e-3, Contact, True),
    "full Newton, near motions by derivatives": ("GeneralizedAlpha", 1e-3, Nearby, True),
}
#: Radius of the curve [m], speed there [m/s].
CURVE, CURVE_SPEED = 600.0, 20.0


def vehicle(speed, **given):
    from .model import Vehicle  # needs exudyn

    return Vehicle(speed, **given)


def weight():
    """On straight track at 40 m/s, 0.5 s."""
    return vehicle(40.0).run(0.5, 0.5e-3)


def over_bulge(name, duration=1.0):
    """Over 4 mm in 10 m at 30 m/s, by one of ``SOLVERS``."""
    solver, step, answer, full_newton = SOLVERS[name]
    running = vehicle(30.0, track=Track(bulge), answer=answer)
    return running.run(duration, step, solver, full_newton=full_newton)


def curve():
    """From straight track into a curve to the right, without cant."""
    return Track(radius=CURVE, begin=12.0, transition=30.0)


def through_curve(duration=5.0):
    """The run into the curve."""
    return vehicle(CURVE_SPEED, track=curve()).run(duration, 0.5e-3)


def on_irregular_track(duration=4.0):
    """At 40 m/s over irregular track."""
    return vehicle(40.0, track=Track(irregular()), answer=Nearby).run(duration, 1e-3, "GeneralizedAlpha")


def needed_in_curve(run, last=0.25):
    """Mean force on all wheelsets towards the inside of the full curve [N] in the ``last`` seconds of a run.

    And what it has to be: mass times acceleration of all bodies, ``r theta'^2 - r''``.
    """
    track, late = curve(), run.time > run.time[-1] - last
    heading, span = track.heading[-1], np.ptp(run.time[late])
    centre = track.x[-1] - CURVE * np.sin(heading), track.y[-1] + CURVE * np.cos(heading)
    away = run.places[late, :, :2] - centre
    radius, angle = np.hypot(*away.T).T, np.unwrap(np.arctan2(away[..., 1], away[..., 0]), axis=0)
    outwards, turning = (np.gradient(of, run.time[late], axis=0) for of in (radius, angle))
    needed = (radius * turning**2).mean(axis=0) - (outwards[-1] - outwards[0]) / span
    masses = 4 * [data.WHEELSET.mass] + 2 * [data.FRAME.mass] + [data.CAR.mass]
    return run["force_y"][late].sum(axis=1).mean(), needed @ masses


@styled
def draw(growths, bulged, curved, shaken):
    """Figure: growth of hunting (``{speed: growth}``), and runs over the bulge, through the curve and on
    irregular track."""
    figure = new_figure(7.2, 9.0)
    axes = figure.subplots(4)
    half, speeds = hunting.touching(), np.linspace(50.0, 95.0, 40)
    axes[0].axhline(0.0, color=QUIET, linewidth=0.8)
    wanted = [theory.root(speed, half).real for speed in speeds]
    axes[0].plot(speeds, wanted, color=QUIET, label="linear theory")
    axes[0].plot(list(growths), list(growths.values()), "o", color=INK, label="exudyn with wrcontact")
    axes[0].set(xlabel="speed [m/s]", ylabel="growth [1/s]", title="Hunting bogie on cones")
    axes[0].legend()
    way = np.linspace(0.0, 40.0, 400)
    axes[1].plot(way, [bulge(s) / MM for s in way], color=QUIET, linestyle=":", label="track")
    wheelset_paths(axes[1], bulged, (0, 1))
    axes[1].set(xlabel="distance [m]", ylabel="to the right [mm]", title="Over a bulge at 30 m/s")
    axes[1].legend()
    for side, colour in SIDE_COLOUR.items():
        axes[2].plot(curved.time, curved[f"{side}_load"][:, 0] / 1e3, color=colour, label=f"{side} wheel")
    axes[2].plot(curved.time, curved["force_y"].sum(axis=1) / 1e3, color=INK, label="lateral, all wheelsets")
    axes[2].set(
        xlabel="time [s]",
        ylabel="force [kN]",
        title=f"Into a curve to the right of {CURVE:g} m at {CURVE_SPEED:g} m/s: first wheelset",
    )
    axes[2].legend(loc=(0.02, 0.28))
    rough = irregular()
    first = shaken.places[:, 0, 0]
    axes[3].plot(first, [rough(s) / MM for s in first], color=QUIET, linestyle=":", label="track")
    wheelset_paths(axes[3], shaken, (0,))
    axes[3].plot(shaken.places[:, -1, 0], shaken.places[:, -1, 1] / MM, color="#0072B2", label="car body")
    axes[3].set(xlabel="distance [m]", ylabel="to the right [mm]", title="On irregular track at 40 m/s")
    axes[3].legend(ncols=3)
    return figure


def wheelset_paths(axis, run, numbers):
    """Lines of wheelsets over their distance."""
    for number, colour in zip(numbers, (INK, "#D55E00")):
        axis.plot(
            run.places[:, number, 0],
            run.places[:, number, 1] / MM,
            color=colour,
            label=f"wheelset {number + 1}",
        )
