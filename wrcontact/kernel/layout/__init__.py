"""The kernel's arrays in named records; the only place that says what stands where.

``tables``     what is fixed during a simulation: settings at the head, then the tables that they point to.
``work``       the workspace of one step.
``state``      what one step leaves for the next; it never changes an answer.
Inputs and outputs of a step are the records Inputs and Outputs.
"""

from .choices import *  # noqa: F403
from .contact import *  # noqa: F403
from .digest import digest  # noqa: F401
from .interface import *  # noqa: F403
from .marks import inlined, seldom  # noqa: F401
from .motion import *  # noqa: F403
from .normal import *  # noqa: F403
from .offsets import *  # noqa: F403
from .patch import *  # noqa: F403
from .record import offset, size  # noqa: F401
from .search import *  # noqa: F403
from .sizes import *  # noqa: F403
from .surface import *  # noqa: F403
from .tables import *  # noqa: F403
from .tangential import *  # noqa: F403
from .wheelset import *  # noqa: F403
from .work import *  # noqa: F403
