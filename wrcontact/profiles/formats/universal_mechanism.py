"""Universal Mechanism's .wpf and .rpf, which are not written; what is read of them are columns of numbers."""

from .base import Format, register

register(
    Format(
        "Universal Mechanism",
        60,
        {".wpf": "", ".rpf": ""},
        unwritten="whose form was not found in a public text",
    )
)
