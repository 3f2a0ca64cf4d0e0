"""The creep force of a patch by the chosen model."""

from ..layout import TANGENTIAL_POLACH, RollingPatch, Tables
from .polach import solve_polach


def solve_tangential(tables: Tables, rolling: RollingPatch):
    """Force, moment, stick share and largest traction of a patch that rolls, into its record.

    All are zero where nothing presses or nothing rubs.
    """
    rolling.force_x = 0.0
    rolling.force_y = 0.0
    rolling.moment = 0.0
    rolling.stick_share = 0.0
    rolling.max_shear = 0.0
    if rolling.load > 0.0 and rolling.friction > 0.0:
        if tables.tangential == TANGENTIAL_POLACH:
            solve_polach(tables, rolling)
    return 0
