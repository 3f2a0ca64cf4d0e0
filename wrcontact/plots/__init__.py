"""Pictures: contacts over the lateral shift, one pose with its patches, creep forces, runs, the check of a
pair, and the demo.

>>> import wrcontact, wrcontact.plots
>>> system = wrcontact.ContactSystem()
>>> figure = wrcontact.plots.pose_figure(system, system.evaluate(lateral_shift=5e-3))
>>> wrcontact.plots.save(figure, "pose.png")                                                # doctest: +SKIP

Functions whose name ends with ``_figure`` draw several panels and return the figure.  All others draw on
one ``axis`` of matplotlib, by default in a new figure, and return it:

>>> axis = wrcontact.plots.contact_lines(system)
>>> wrcontact.plots.save(axis, "lines.png")                                                 # doctest: +SKIP
"""

from ..conditioning.curves import find_jumps
from ..results.runs import read_run
from .along import along_track_figure, around_wheel_figure
from .animation import animate
from .check import check_figure
from .creepage import creep_curves
from .demo import demo_figure
from .history import history
from .lateral_curves import contact_angle, radius_difference, roll_angle
from .lines import contact_lines
from .locus import root_locus_figure
from .patch import outline_figure
from .pose import contact_figure, pose_figure
from .sections import sections_figure
from .shear import patch_map
from .style import new_figure, save
from .sweep import sweep, sweep_figure
from .title_picture import hero_figure
from .traction import PatchTractions, patch_tractions
from .view_3d import wheel_on_rail
from .wear import fatigue_figure, shakedown_figure, wear_depth_figure, wear_figure

__all__ = [
    "PatchTractions",
    "along_track_figure",
    "around_wheel_figure",
    "animate",
    "check_figure",
    "contact_angle",
    "contact_figure",
    "contact_lines",
    "creep_curves",
    "demo_figure",
    "fatigue_figure",
    "find_jumps",
    "hero_figure",
    "history",
    "new_figure",
    "outline_figure",
    "patch_map",
    "patch_tractions",
    "pose_figure",
    "radius_difference",
    "read_run",
    "roll_angle",
    "root_locus_figure",
    "save",
    "sections_figure",
    "shakedown_figure",
    "sweep",
    "sweep_figure",
    "wear_depth_figure",
    "wear_figure",
    "wheel_on_rail",
]
