"""The creep force of a patch by the chosen model."""

from ..layout import (
    ROLLING_STRIP_LIMIT,
    TANGENTIAL_FASTRIP,
    TANGENTIAL_FASTSIM,
    TANGENTIAL_POLACH,
    TANGENTIAL_STRIPS,
    Patch,
    Rolling,
    Tables,
)
from .coupled_strips import solve_coupled_strips
from .rolling_strips import clear_creep
from .fastrip import solve_fastrip
from .fastsim import solve_fastsim
from .friction import keep_dissipating
from .polach import solve_polach


def solve_creep_force(tables: Tables, rolling: Rolling, patch: Patch):
    """Force, moment, stick share and largest traction of a patch that rolls, into its record.

    All are zero where nothing presses or nothing rubs.  A patch that rolls backwards is solved as its mirror
    image that rolls forwards.
    """
    clear_creep(patch)
    if patch.totals.load > 0.0 and patch.friction > 0.0 and patch.half_length > 0.0:
        if patch.backwards:
            mirror_rolling(patch)
        if tables.tangential == TANGENTIAL_STRIPS:
            solve_coupled_strips(tables, rolling, patch)
        elif tables.tangential == TANGENTIAL_FASTSIM:
            solve_fastsim(tables, rolling, patch)
        elif tables.tangential == TANGENTIAL_FASTRIP:
            solve_fastrip(tables, rolling, patch)
        elif tables.tangential == TANGENTIAL_POLACH:
            solve_polach(tables, patch)
        if not rolling.bare:
            keep_dissipating(patch)
        if patch.backwards:
            mirror_rolling(patch)


def mirror_rolling(patch: Patch):
    """The mirror image of a patch, what is known of it and what is found, in the plane across the rail."""
    patch.creepage_x = -patch.creepage_x
    patch.spin = -patch.spin
    patch.creep_x = -patch.creep_x
    patch.creep_moment = -patch.creep_moment
    for i in range(ROLLING_STRIP_LIMIT):
        strip = patch.strips[i]
        strip.x = -strip.x
        strip.slip = -strip.slip
        strip.spin = -strip.spin
        strip.force_x = -strip.force_x
        strip.moment = -strip.moment
