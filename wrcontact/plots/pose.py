"""Picture of one pose: wheels on rails with contact point and contact plane, and the patches."""

import numpy as np

from ..conventions import SIDES
from .geometry import rail_outline, wheel_outline
from .patch import chosen_sides, draw_outlines, of_one_pose
from .style import (
    CONTACT_COLOUR,
    DEGREE,
    INK,
    KILONEWTON,
    MM,
    RAIL_COLOUR,
    RAIL_LABEL,
    WHEEL_COLOUR,
    given_axes,
    in_lines,
    new_figure,
    number,
    styled,
)

# [m] shown from the rail's highest point to the track centre and to the field side
INSIDE, OUTSIDE = 78e-3, 54e-3
ABOVE, BELOW = 18e-3, 38e-3  # [m] shown above and below top of rail
PLANE = 32e-3  # [m] drawn length of the contact plane
HIGH = 0.1  # [m] upper end of a drawn wheel, outside the picture


@styled
@of_one_pose()
def pose_figure(system, state, ax=None):
    """Both wheels on their rails at one pose, seen in the direction of travel, above patches and pressures;
    in the axes ``ax`` (3, 2) or in a new figure; returns the figure."""
    if ax is None:
        ax = _titled(new_figure(9, 9.6), system, state).subplots(3, 2, height_ratios=(2, 3.9, 1.6))
    figure, panels = given_axes(ax, (3, 2))
    draw_contacts(panels[0], system, state)
    draw_outlines(figure, panels[1:], system, state)
    for panel in panels[1:, 0]:  # the left wheel's field side is to the left, as in its section
        panel.invert_xaxis()
    return figure


@styled
@of_one_pose()
def contact_figure(system, state, ax=None, side=None):
    """Both wheels on their rails at one pose, or one ``side``, seen in the direction of travel; in the axes
    ``ax`` (2,) or (1,), or in a new figure; returns the figure."""
    sides = chosen_sides(side)
    if ax is None:
        ax = _titled(new_figure(4.5 * len(sides), 3.3), system, state).subplots(1, len(sides))
    figure, panels = given_axes(ax, (len(sides),))
    draw_contacts(panels, system, state, sides)
    return figure


def _titled(figure, system, state):
    title = in_lines(_headline(system, state), figure.get_size_inches()[0])
    figure.suptitle(title, x=0.01, ha="left")
    return figure


def draw_contacts(panels, system, state, sides=SIDES):
    """Draw the contacts of the ``sides`` into as many ``panels``."""
    for panel, side in zip(panels, sides):
        draw_contact(panel, system, state, side)
    middle_of_rail = (OUTSIDE if sides[0] == "left" else INSIDE) / (INSIDE + OUTSIDE)
    shown = {label: line for panel in panels for line, label in zip(*panel.get_legend_handles_labels())}
    panels[0].legend(
        shown.values(),
        shown.keys(),
        loc="lower center",
        bbox_to_anchor=(middle_of_rail, -0.03),
        handlelength=1.8,
        labelspacing=0.3,
    )


def draw_contact(panel, system, state, side):
    """Wheel and rail of one side in track coordinates [mm], height up, with contact point and contact
    plane."""
    panel.set_label(f"{side} contact")
    y_rail, z_rail = rail_outline(system, side, state)
    panel.fill(y_rail / MM, -z_rail / MM, color=RAIL_COLOUR, alpha=0.3, linewidth=0)
    panel.plot(y_rail / MM, -z_rail / MM, color=RAIL_COLOUR)
    y_wheel, z_wheel = wheel_outline(system, state, side)
    y_wheel, z_wheel = y_wheel[[0, *range(len(y_wheel)), -1]], np.concatenate([[-HIGH], z_wheel, [-HIGH]])
    panel.fill(y_wheel / MM, -z_wheel / MM, color=WHEEL_COLOUR, alpha=0.15, linewidth=0)
    panel.plot(y_wheel / MM, -z_wheel / MM, color=WHEEL_COLOUR)
    draw_plane(panel, getattr(state, side), side)
    draw_patch_places(panel, getattr(state, side))
    top = y_rail[np.argmin(z_rail)]
    _frame(panel, top, side)
    panel.text(top / MM, -7, "rail", color=RAIL_LABEL, ha="center", va="center")
    panel.text(top / MM, ABOVE / MM - 2, "wheel", color=WHEEL_COLOUR, ha="center", va="top")
    panel.set_title(_describe(getattr(state, side), side))


def draw_plane(panel, contact, side):
    """The contact plane, and the contact point in it."""
    y, z = contact.contact.y_track, contact.contact.z_track
    rise = np.tan(contact.contact_angle) * (1 if side == "right" else -1)
    ends = np.array([-0.5, 0.5]) * PLANE * np.cos(contact.contact_angle)
    panel.plot(
        (y + ends) / MM,
        (-z + rise * ends) / MM,
        color=CONTACT_COLOUR,
        linewidth=1.2,
        linestyle=(0, (4, 2)),
        label="contact plane",
    )
    panel.plot([y / MM], [-z / MM], "o", color=CONTACT_COLOUR, markersize=5, label="contact point")


def draw_patch_places(panel, contact):
    """The centres of load of all patches, with their numbers where there are several."""
    if not contact.patch_count > 1:
        return
    y, z = (
        np.array([getattr(patch, name) for patch in contact.patches]) / MM for name in ("y_track", "z_track")
    )
    panel.plot(y, -z, "o", color="white", markeredgecolor=INK, markersize=4, label="patch", zorder=4)
    for number_of, place in enumerate(zip(y, -z), 1):
        panel.annotate(
            str(number_of),
            place,
            (0, -5),
            textcoords="offset points",
            ha="center",
            va="top",
            fontsize=8,
            color=INK,
        )


def _frame(panel, top, side):
    """Show the flange on the inner side and the tread on the outer one; ``top`` is the rail's highest point
    [m]."""
    low, high = (-INSIDE, OUTSIDE) if side == "right" else (-OUTSIDE, INSIDE)
    panel.set(
        xlim=((top + low) / MM, (top + high) / MM),
        ylim=(-BELOW / MM, ABOVE / MM),
        aspect="equal",
        xlabel="across the track, right + [mm]",
        ylabel="above top of rail [mm]",
        yticks=(-30, -20, -10, 0, 10),
    )


def _describe(contact, side):
    return (
        f"{side.capitalize()} wheel touches at y = {number(contact.contact.y_wheel / MM, 1)} mm\n"
        f"of its profile, contact angle {number(contact.contact_angle / DEGREE, 1)}°"
    )


def _headline(system, state):
    """Pose, load and roll in one line."""
    shift, yaw = state.inputs.lateral_shift, state.inputs.yaw
    return (
        f"Lateral shift {number(shift / MM, 2)} mm, yaw {number(yaw / DEGREE, 2)}°, "
        f"{_load(system, state)}: roll {number(state.roll / DEGREE, 3)}°"
    )


def _load(system, state):
    """Text on the load: forces, or the height of the wheelset."""
    if system.parameters["contact_mode"] == "compliant":
        return f"{number(state.vertical_shift / MM, 3)} mm down"
    force, transfer = state.inputs.normal_force, state.inputs.load_transfer
    return f"{number(force / KILONEWTON, 1)} kN per wheel" + (
        f", load transfer {number(transfer, 2)}" if transfer else ""
    )
