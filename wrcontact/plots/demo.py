"""The picture of ``wrcontact demo``: contact positions, patches, and the run of the FMU."""

from matplotlib.ticker import MultipleLocator

from ..conventions import SIDES
from .geometry import wheel_zone
from .patch import draw_patch, frame_patch, pressure_scale, window_size
from .style import DEGREE, INK, KILONEWTON, MEGAPASCAL, MM, SIDE_COLOUR, new_figure, styled
from .sweep import draw_sweep, draw_zones, sweep

#: Lateral shifts [m] at which the right wheel's patch is drawn: two on the tread, two at the flange root, one
#: on the flange.
SHOWN_SHIFTS = (0.0, 3e-3, 5e-3, 6e-3, 7e-3)
#: Panels of the run, by rows: title, name of the variable (after the side, where a wheel has it), display
#: unit and its name.
RUN_PANELS = (
    ("Lateral shift", "lateral_shift", MM, "mm"),
    ("Yaw", "yaw", DEGREE, "deg"),
    ("Contact on the wheel profile", "contact.y_wheel", MM, "mm"),
    ("Normal force", "normal_force", KILONEWTON, "kN"),
    ("Largest pressure", "max_pressure", MEGAPASCAL, "MPa"),
    ("Patch area", "area", MM**2, "mm²"),
)


@styled
def demo_figure(system, run, stored):
    """Three rows: contacts and roll against the lateral shift, patches from tread to flange, and the run over
    time.

    ``run`` and ``stored`` have arrays (n,) in SI by FMU name: the outputs of the FMU, and the stored run with
    its inputs.
    """
    figure = new_figure(10, 10.6)
    rows = figure.subfigures(3, 1, height_ratios=(3.4, 3.4, 3.9), hspace=0.02)
    title = (
        f"Where {system.wheel.name} touches {system.rail.name} without yaw: three jumps lead from the "
        "tread to the flange"
    )
    draw_sweep(_titled(rows[0], title).subplots(1, 3), sweep(system))
    draw_patches(
        _titled(rows[1], "The patch of the right wheel from tread to flange at 78.5 kN, with a common scale"),
        system,
    )
    title = "The FMU steps through growing hunting: lines are its outputs, circles the stored reference"
    draw_run(_titled(rows[2], title).subplots(2, 3, sharex=True), run, stored)
    return figure


def _titled(row, title):
    row.suptitle(title, x=0.008, ha="left")
    return row


def draw_patches(row, system):
    """The right wheel's patch at :data:`SHOWN_SHIFTS`, in panels with a common scale and a colour bar."""
    states = [system.evaluate(lateral_shift=shift) for shift in SHOWN_SHIFTS]
    outlines = [state.right.outline for state in states]
    panels = row.subplots(1, len(states), sharey=True)
    for panel, shift, state, outline in zip(panels, SHOWN_SHIFTS, states, outlines):
        panel.set_label(f"patch at {shift / MM:g} mm")
        mesh = draw_patch(panel, outline, pressure_scale(outlines))
        frame_patch(panel, outline, *window_size(outlines))
        panel.xaxis.set_major_locator(MultipleLocator(5))
        panel.set_title(_describe(shift, state.right), fontsize=9, fontweight="normal")
    panels[0].set_ylabel("rolling direction [mm]")
    panels[len(panels) // 2].set_xlabel("lateral in the contact plane, field side + [mm]")
    row.colorbar(mesh, ax=panels, label="pressure [MPa]", pad=0.01, aspect=30)


def _describe(shift, side):
    """Zone and shift, then area and largest pressure, in two lines."""
    return (
        f"{wheel_zone(side.contact.y_wheel)}, {shift / MM:g} mm\n"
        f"{side.area / MM**2:.0f} mm², {side.max_pressure / MEGAPASCAL:.0f} MPa"
    )


def draw_run(panels, run, stored):
    """Draw inputs, contact positions, forces, pressures and areas of the run over time into panels (2, 3)."""
    for panel, (title, name, unit, unit_name) in zip(panels.flat, RUN_PANELS):
        panel.set_label(f"run {name}")
        panel.set_title(title)
        panel.set_ylabel(unit_name)
        if f"right.{name}" not in run:
            panel.plot(stored["time"], stored[name] / unit, color=INK)
        else:
            _compare(panel, run, stored, name, unit)
    by_name = dict(zip((name for _, name, *_ in RUN_PANELS), panels.flat))
    draw_zones(by_name["contact.y_wheel"], 1.02)
    by_name["normal_force"].set_ylim(40, None)
    by_name["normal_force"].legend(loc="lower left", ncols=2, handlelength=1.4)
    for panel in panels[-1]:
        panel.set_xlabel("time [s]")


def _compare(panel, run, stored, name, unit):
    """Outputs of the FMU for both wheels as lines, stored values as circles."""
    time = stored["time"]
    for side in SIDES:
        look = {"color": SIDE_COLOUR[side], "linewidth": 1}
        panel.plot(time, run[f"{side}.{name}"] / unit, label=side, **look)
        panel.plot(
            time,
            stored[f"{side}.{name}"] / unit,
            "o",
            markersize=2.4,
            fillstyle="none",
            markeredgewidth=0.5,
            **look,
        )
