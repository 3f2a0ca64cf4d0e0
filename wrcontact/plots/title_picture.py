"""One picture of what the package computes: contact lines on both profiles, and a patch with pressure and
shear."""

from .lines import contact_lines
from .patch import of_one_pose
from .shear import patch_map
from .style import new_figure, styled


@styled
@of_one_pose()
def hero_figure(system, state, side="right"):
    """Where a wheel touches its rail over the lateral shift, :func:`contact_lines`, beside its patches at
    one pose with pressure and shear stress, :func:`patch_map`; in a new figure, which is returned."""
    figure = new_figure(11.2, 3.9)
    lines, patch = figure.subplots(1, 2, width_ratios=(1.75, 1))
    contact_lines(system, lines, side=side)
    patch_map(system, state, patch, side=side)
    return figure
