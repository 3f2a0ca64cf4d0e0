"""The kernel's arrays in named records; the only place that says what stands where.

``tables``     what is fixed during a simulation: settings at the head, then the tables that they point to.
``work``       the workspace of one step.
``state``      what one step leaves for the next; it never changes an answer.
Inputs and outputs of a step are the records Inputs and Outputs.
"""

import hashlib
import sys

from .arrays import *  # noqa: F403
from .contact import *  # noqa: F403
from .creep import *  # noqa: F403
from .interface import *  # noqa: F403
from .patch import *  # noqa: F403
from .record import clear, copy, inlined, native, offset, seldom, size  # noqa: F401
from .search import *  # noqa: F403
from .sections import *  # noqa: F403


def digest():
    """Hexadecimal digits that change with every constant and with every field's name, place and type."""
    layout = sys.modules[__name__]
    lines = []
    for name, value in sorted(vars(layout).items()):
        numbers = value if isinstance(value, tuple) else (value,)
        if name.isupper() and all(isinstance(number, (int, float)) for number in numbers):
            lines.append(f"{name} = {value!r}")
        elif hasattr(value, "_fields_") and hasattr(value, "scalars"):
            lines += [
                f"{name}.{field}: {kind.__name__} at {getattr(value, field).offset}"
                for field, kind in value._fields_
            ]
            lines += [f"{name}.{field}: {kind.__name__}" for field, kind in value.scalars.items()]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()
