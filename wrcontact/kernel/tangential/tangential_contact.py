"""The creep force of a patch by the chosen model."""

from ..layout import (
    TANGENTIAL_FASTRIP,
    TANGENTIAL_FASTSIM,
    TANGENTIAL_POLACH,
    TANGENTIAL_STRIPS,
    RollingPatch,
    Tables,
)
from .coupled_strips import solve_strips
from .dissipation import keep_dissipating
from .fastrip import solve_fastrip
from .fastsim import solve_fastsim
from .polach import solve_polach


def solve_tangential(tables: Tables, rolling: RollingPatch):
    """Force, moment, stick share and largest traction of a patch that rolls, into its record.

    All are zero where nothing presses or nothing rubs.  A patch that rolls backwards is solved as its mirror
    image that rolls forwards.
    """
    clear_found(rolling)
    if rolling.load > 0.0 and rolling.friction > 0.0 and rolling.half_length > 0.0:
        if rolling.backwards:
            mirror_rolling(rolling)
        if tables.tangential == TANGENTIAL_STRIPS:
            solve_strips(tables, rolling)
        elif tables.tangential == TANGENTIAL_FASTSIM:
            solve_fastsim(tables, rolling)
        elif tables.tangential == TANGENTIAL_FASTRIP:
            solve_fastrip(tables, rolling)
        elif tables.tangential == TANGENTIAL_POLACH:
            solve_polach(tables, rolling)
        if tables.tangential != TANGENTIAL_POLACH and not rolling.bare:
            # Polach's formula has no moment, which belongs to the power of spin
            keep_dissipating(rolling)
        if rolling.backwards:
            mirror_rolling(rolling)
    return 0


def clear_found(rolling: RollingPatch):
    """Nothing is found yet."""
    rolling.force_x = 0.0
    rolling.force_y = 0.0
    rolling.moment = 0.0
    rolling.stick_share = 0.0
    rolling.max_shear = 0.0
    for i in range(rolling.count):
        strip = rolling.strips[i]
        strip.force_x = 0.0
        strip.force_y = 0.0
        strip.moment = 0.0
    return 0


def mirror_rolling(rolling: RollingPatch):
    """The mirror image of a patch, what is known of it and what is found, in the plane across the rail."""
    rolling.creepage_x = -rolling.creepage_x
    rolling.spin = -rolling.spin
    rolling.force_x = -rolling.force_x
    rolling.moment = -rolling.moment
    for i in range(rolling.count):
        strip = rolling.strips[i]
        strip.x = -strip.x
        strip.slip = -strip.slip
        strip.force_x = -strip.force_x
        strip.moment = -strip.moment
    return 0
