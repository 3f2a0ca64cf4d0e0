"""Quoted results of another program: CONTACT v25.2 (Vollebregt), timed on another machine.

Errors of its approximations refer to its own complete theory at ten of the positions, 0 ... 6.5 mm at 78.5 kN.  Its times are
for one wheel with prescribed force, search included; a wheelset has two wheels.  No time was reported for Kik-Piotrowski.
"""

from typing import NamedTuple

import numpy as np

SOURCE = "CONTACT v25.2, quoted, other machine"
WHEELS = 2


class Peer(NamedTuple):
    """One program: shortest and longest time of one wheel [ms], or None; errors as shares (3,)."""

    name: str
    milliseconds: tuple | None
    mean: np.ndarray
    worst: np.ndarray

    @property
    def microseconds(self):
        """Shortest and longest time of a wheelset [us], or None."""
        return self.milliseconds and tuple(1e3 * WHEELS * time for time in self.milliseconds)


PEERS = (
    Peer("CONTACT's ANALYN", (6, 32), np.array([0.019, 0.059, 0.078]), np.array([0.049, 0.18, 0.20])),
    Peer("CONTACT's Kik-Piotrowski", None, np.array([0.009, 0.067, 0.104]), np.array([0.038, 0.18, 0.28])),
    Peer("CONTACT's complete theory", (5, 85), np.zeros(3), np.zeros(3)),
)
