"""The region around a contact point or a deepest point, and what belongs to its inclination."""

from math import sqrt
from typing import Final

from ..layout import LOAD_VERTICAL, Frame, Region, State, Tables
from ..surface.rails import upright_share
from .contact_plane import normal_gap

#: Station of a bound that is none [m]; longer than any profile.
BEYOND: Final[float] = 1.0
#: Tolerance of the traces [m]; the residual is removed to second order, which leaves rounding.
PLACE_TRACE: Final[float] = 1e-8


def incline_region(tables: Tables, frame: Frame, region: Region, slope: float):
    """Give a region in the contact point's plane its inclination, the rail's ``slope`` there, and what
    follows from it."""
    cosine = 1.0 / sqrt(1.0 + slope * slope)
    region.inclination = slope
    region.own = False
    region.alignment = 1.0
    region.offset = 0.0
    region.cos = cosine
    region.sin = slope * cosine
    region.share = 1.0
    if tables.load == LOAD_VERTICAL:
        region.share = upright_share(frame.place, cosine, region.sin)


def measure_contact(tables: Tables, frame: Frame, state: State):
    """Note in the open frame how the gap bends at the contact point, and the wheel's 1/R_x."""
    gap, rate, bend, curvature = normal_gap(tables, frame, state, 0.0, PLACE_TRACE)
    frame.bend = bend
    frame.curvature = curvature


def open_contact_region(tables: Tables, frame: Frame, region: Region):
    """The region of the rigid contact point itself, station and gap zero."""
    region.station = 0.0
    region.gap = 0.0
    region.rail = frame.rail.y
    region.wheel = frame.wheel.y
    region.bend = frame.bend
    region.curvature = frame.curvature
    region.low = -BEYOND
    region.high = BEYOND
    incline_region(tables, frame, region, frame.plane.sin / frame.plane.cos)
