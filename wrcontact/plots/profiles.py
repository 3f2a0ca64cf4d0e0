"""Pictures of standard profiles, small and side by side, all of a kind in the same scale."""

import numpy as np

from .style import MM, RAIL_COLOUR, WHEEL_COLOUR, new_figure, styled

COLUMNS = 5
#: Width and height of one picture [in], and what it shows of y and z [mm], by kind.
SIZE = 1.9, 1.15
WINDOW = {"rail": ((-42.0, 42.0), (-4.0, 38.0)), "wheel": ((-73.0, 73.0), (-12.0, 34.0))}
STEP = 0.05  # [mm]


@styled
def draw_profiles(profiles):
    """A figure with one small picture of each of ``profiles``, rails before wheels."""
    rows = [
        row for kind in WINDOW for row in _rows([profile for profile in profiles if profile.kind == kind])
    ]
    width = SIZE[0] * max(map(len, rows))
    figure = new_figure(width, SIZE[1] * len(rows) + 0.2)
    axes = figure.subplots(len(rows), max(map(len, rows)), squeeze=False)
    for axis in axes.flat:
        axis.set_axis_off()
    for along, row in zip(axes, rows):
        for axis, profile in zip(along, row):
            _draw(axis, profile)
    return figure


def _rows(profiles):
    """The profiles, at most COLUMNS in a row."""
    return [profiles[i : i + COLUMNS] for i in range(0, len(profiles), COLUMNS)]


def _draw(axis, profile):
    y, z = outline(profile)
    colour = WHEEL_COLOUR if profile.kind == "wheel" else RAIL_COLOUR
    ground = WINDOW[profile.kind][1][0 if profile.kind == "wheel" else 1]
    axis.fill_between(y, z, ground, color=colour, alpha=0.18, linewidth=0.0)
    axis.plot(y, z, color=colour, linewidth=1.1)
    corners = [joint.y / MM for joint in profile.joints if abs(joint.slope_step) > 0.02]
    axis.plot(corners, profile.height(np.array(corners) * MM) / MM, ".", color=colour, markersize=3.0)
    axis.set_title(profile.name, fontsize=8)
    (low, high), (top, bottom) = WINDOW[profile.kind]
    axis.set(xlim=(low, high), ylim=(bottom, top), aspect="equal")


def outline(profile):
    """Points y and z (n,) [mm] along the whole ``profile``."""
    y = np.arange(profile.start / MM, profile.stop / MM, STEP)
    y = np.append(y, profile.stop / MM)
    z = profile.height(y * MM) / MM
    return y[np.isfinite(z)], z[np.isfinite(z)]
