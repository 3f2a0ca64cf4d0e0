"""Pictures: contacts against the lateral shift, one pose with its patches, the check of a pair, and the demo.

>>> import wrcontact, wrcontact.plots
>>> system = wrcontact.ContactSystem()
>>> figure = wrcontact.plots.pose_figure(system, system.evaluate(lateral_shift=5e-3))
>>> wrcontact.plots.save(figure, "pose.png")                                                # doctest: +SKIP
"""

from ..conditioning.curves import find_jumps
from .check import check_figure
from .demo import demo_figure
from .patch import outline_figure
from .pose import contact_figure, pose_figure
from .style import save
from .sweep import sweep, sweep_figure
from .wear import fatigue_figure, shakedown_figure, wear_depth_figure, wear_figure

__all__ = ["check_figure", "contact_figure", "demo_figure", "fatigue_figure", "find_jumps", "outline_figure",
           "pose_figure", "save", "shakedown_figure", "sweep", "sweep_figure", "wear_depth_figure",
           "wear_figure"]
