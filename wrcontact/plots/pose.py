"""One pose: wheel and rail of both sides as they touch, with the contact plane, and their patches."""

import numpy as np

from .geometry import rail_outline, wheel_outline
from .patch import draw_outlines
from .style import CONTACT_COLOUR, INK, KILONEWTON, MM, QUIET, RAIL_COLOUR, WHEEL_COLOUR, new_figure, styled

AROUND = 48e-3  # [m] shown to both sides of the rail's highest point
ABOVE, BELOW = 22e-3, 34e-3  # [m] shown above and below top of rail
PLANE = 30e-3  # [m] drawn length of the contact plane


@styled
def pose_figure(system, state):
    """Both wheels on their rails at one pose, seen in the direction of travel, above patches and pressures."""
    figure = new_figure(9, 10)
    panels = figure.subplots(3, 2, height_ratios=(4, 3.6, 2.2))
    figure.suptitle(_headline(state), x=0.01, ha="left")
    for panel, side in zip(panels[0], ("left", "right")):
        draw_contact(panel, system, state, side)
    draw_outlines(figure, panels[1:], state)
    return figure


@styled
def contact_figure(system, state):
    """Both wheels on their rails at one pose, seen in the direction of travel."""
    figure = new_figure(9, 4.2)
    figure.suptitle(_headline(state), x=0.01, ha="left")
    for panel, side in zip(figure.subplots(1, 2), ("left", "right")):
        draw_contact(panel, system, state, side)
    return figure


def draw_contact(panel, system, state, side):
    """Wheel and rail of one side in track coordinates [mm], height up, with contact point and contact plane."""
    panel.set_label(f"{side} contact")
    y_rail, z_rail = rail_outline(system, side)
    y_wheel, z_wheel = wheel_outline(system, state, side)
    panel.fill_between(y_rail / MM, -z_rail / MM, -60, color=RAIL_COLOUR, alpha=0.25, linewidth=0)
    panel.fill_between(y_wheel / MM, -z_wheel / MM, 60, color=WHEEL_COLOUR, alpha=0.15, linewidth=0)
    panel.plot(y_rail / MM, -z_rail / MM, color=RAIL_COLOUR, label="rail")
    panel.plot(y_wheel / MM, -z_wheel / MM, color=WHEEL_COLOUR, label="wheel")
    draw_plane(panel, getattr(state, side), side)
    centre = y_rail[np.argmin(z_rail)]
    panel.set(xlim=((centre - AROUND) / MM, (centre + AROUND) / MM), ylim=(-BELOW / MM, ABOVE / MM), aspect="equal",
              xlabel="across the track, to the right + [mm]", ylabel="above top of rail [mm]")
    panel.set_title(_describe(state, side))


def draw_plane(panel, contact, side):
    """The contact point, and the contact plane through it."""
    y, z = contact.contact.y_track, contact.contact.z_track
    rise = np.tan(contact.contact_angle) * (1 if side == "right" else -1)
    reach = 0.5 * PLANE * np.cos(contact.contact_angle)
    ends = np.array([-reach, reach])
    panel.plot((y + ends) / MM, (-z + rise * ends) / MM, color=CONTACT_COLOUR, linewidth=1.2, linestyle=(0, (4, 2)), label="contact plane")
    panel.plot([y / MM], [-z / MM], "o", color=CONTACT_COLOUR, markersize=5, label="contact point")


def _describe(state, side):
    contact = getattr(state, side)
    return (f"{side.capitalize()} wheel touches at y = {contact.contact.y_wheel / MM:.1f} mm\n"
            f"of its profile, contact angle {np.degrees(contact.contact_angle):.1f}°")


def _headline(state):
    shift, yaw, _, force, transfer = state.inputs
    load = f"{force / KILONEWTON:g} kN per wheel" + (f", load transfer {transfer:g}" if transfer else "")
    return (f"Wheelset {shift / MM:g} mm to the right, yaw {np.degrees(yaw):g}°, {load}: "
            f"roll {np.degrees(state.roll):.3f}°")


__all__ = ["INK", "QUIET", "contact_figure", "draw_contact", "pose_figure"]
