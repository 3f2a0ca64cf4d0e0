"""A rail whose section changes along the track: its sections, and its heights from above."""

import matplotlib
import numpy as np

from .style import INK, MM, QUIET, SHIFT_COLOURS, new_figure, styled

SIZE = 9.0, 3.6  # [in]
#: Sections that are drawn at most, and points along and across of the map.
MOST_SECTIONS, ALONG, ACROSS = 25, 240, 240
STEP = 2.0  # [mm] of the colours
#: The map shows what lies this close below the highest place [mm]: a wheel reaches no deeper on a head.
DEPTH = 30.0


@styled
def sections_figure(sections):
    """The sections of a rail seen along the track, and a map of its heights [mm].

    Parameters
    ----------
    sections : :class:`~wrcontact.RailSections`.

    Returns
    -------
    figure
    """
    figure = new_figure(*SIZE)
    across, above = figure.subplots(1, 2, width_ratios=(1.0, 1.35))
    across.set_label("sections")
    above.set_label("heights")
    draw_sections(across, sections)
    mesh = draw_heights(above, sections)
    figure.colorbar(mesh, ax=above, label="height, up + [mm]", pad=0.02)
    figure.suptitle(sections.name, fontsize=10)
    return figure


def draw_sections(axis, sections):
    """The slices, coloured from the first to the last position."""
    positions = sections.positions
    chosen = np.unique(
        np.linspace(0, len(positions) - 1, min(len(positions), MOST_SECTIONS)).round().astype(int)
    )
    colours = matplotlib.colors.ListedColormap(SHIFT_COLOURS)
    span = np.ptp(positions)
    for k in chosen:
        y, z = sections.section(positions[k]).T / MM
        axis.plot(y, z, color=colours((positions[k] - positions[0]) / span), linewidth=1.0)
    axis.set(
        xlabel="lateral place, field side + [mm]", ylabel="down + [mm]", aspect="equal", adjustable="datalim"
    )
    axis.invert_yaxis()
    axis.set_title(f"{len(positions)} slices, {positions[0]:.4g} ... {positions[-1]:.4g} m", fontsize=8)


def draw_heights(axis, sections):
    """The map of heights [mm], with a line at each slice."""
    u = np.linspace(sections.positions[0], sections.positions[-1], ALONG)
    first, last = sections.edges(u)
    y = np.linspace(first.min(), last.max(), ACROSS)
    z = -sections.height(u[:, None], y[None, :]) / MM
    top = np.nanmax(z)
    levels = np.arange(STEP * np.floor((top - DEPTH) / STEP), top + STEP, STEP)
    mesh = axis.contourf(u, y / MM, z.T, levels, cmap="viridis", extend="min")
    for position in sections.positions:
        axis.axvline(position, color=QUIET, linewidth=0.3, gid="slice")
    for edge in (first, last):
        axis.plot(u, edge / MM, color=INK, linewidth=0.8)
    axis.set(xlabel="position along the track [m]", ylabel="lateral place [mm]")
    axis.invert_yaxis()
    return mesh
