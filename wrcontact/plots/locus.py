"""Root loci: eigenvalues of a linear wheelset or vehicle over the speed."""

import numpy as np

from .style import CONTACT_COLOUR, INK, QUIET, new_figure, styled


@styled
def root_locus_figure(speeds, roots, critical=None):
    """Eigenvalues over the speed: in the complex plane, and their damping over the speed.

    Parameters
    ----------
    speeds : (n,) [m/s].
    roots : eigenvalues (n, m) [1/s, rad/s], as of ``Linearization.eigenvalues`` or ``hunting_root``; those with an
        imaginary part below 0 are left out.
    critical : critical speed [m/s], marked if it is given.

    Returns
    -------
    figure

    Raises
    ------
    ValueError
        if there are not as many rows as speeds.
    """
    speeds, roots = np.asarray(speeds, dtype=float), np.atleast_2d(np.asarray(roots, dtype=complex).T).T
    if speeds.ndim != 1 or len(roots) != len(speeds):
        raise ValueError(
            f"roots has the shape {roots.shape} and speeds {speeds.shape}; permitted is a row for each speed"
        )
    rows, columns = np.nonzero(roots.imag > 1e-9)
    shown, at = roots[rows, columns], speeds[rows]
    figure = new_figure(8.4, 3.6)
    plane, over = figure.subplots(1, 2)
    points = plane.scatter(shown.real, shown.imag / (2.0 * np.pi), c=at, s=9, cmap="viridis")
    plane.axvline(0.0, color=QUIET, linewidth=0.8)
    plane.set(xlabel="growth [1/s]", ylabel="frequency [Hz]")
    figure.colorbar(points, ax=plane, label="speed [m/s]")
    over.plot(at, -shown.real / np.abs(shown), ".", color=INK, markersize=3)
    over.axhline(0.0, color=QUIET, linewidth=0.8)
    if critical is not None:
        over.axvline(
            critical, color=CONTACT_COLOUR, linewidth=0.9, label=f"critical speed {critical:.1f} m/s"
        )
        over.legend(loc="best")
    over.set(xlabel="speed [m/s]", ylabel="damping ratio [-]")
    return figure
