"""GENSYS's .wheel and .rail: columns y and z in mm, y positive towards the track centre, z down (manual of its program
KPF)."""

from . import plain
from .base import Format, columns, register


def read(text, kind=None, select=None):
    """Points from the text; flange and gauge side are at larger y."""
    points = plain.read(text)
    points.y, points.defined = -points.y, True
    return points


def write(profile, y, z):
    """The profile's text."""
    return f"# {profile.name}\n{columns(-y[::-1], z[::-1])}"


register(Format("GENSYS", 50, {".wheel": "wheel", ".rail": "rail"}, read, write=write))
register(
    Format(
        "GENSYS's contact functions",
        51,
        {".kpfr": ""},
        unwritten="whose form was not found in a public text",
    )
)
