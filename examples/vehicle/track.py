"""The line of the track in the plane, and where a wheelset is on it."""

import math

import numpy as np

#: Spacing of the points of the line [m]; straight between them, it is 4e-8 m off at a radius of 300 m.
SPACING = 0.01


class Track:
    """A straight track with displacements across it, or one with a curve.

    Parameters
    ----------
    displacement : function of the distance [m] that gives how far the rails lie to the right [m].
    radius : of a curve to the right [m]; inf is a straight track.
    begin, transition : where the clothoid into the curve begins, and its length [m].
    length : of the track [m], behind which nothing runs.
    """

    def __init__(
        self, displacement=lambda distance: 0.0, radius=math.inf, begin=0.0, transition=30.0, length=400.0
    ):
        self.displacement, self.straight = displacement, math.isinf(radius)
        self.curvature = lambda s: min(max((s - begin) / transition, 0.0), 1.0) / radius
        if not self.straight:
            self.way = np.arange(-20.0, length, SPACING)
            run = np.clip(self.way - begin, 0.0, None)
            inside = np.minimum(run, transition)
            self.heading = (inside**2 / (2 * transition) + (run - inside)) / radius
            middle = (self.heading[1:] + self.heading[:-1]) / 2
            self.x = self.way[0] + SPACING * np.append(0.0, np.cumsum(np.cos(middle)))
            self.y = SPACING * np.append(0.0, np.cumsum(np.sin(middle)))

    def at(self, x, y):
        """Of a place: distance along the track [m], shift to the right of the displaced track [m], heading
        [rad], curvature [1/m]."""
        if self.straight:
            return x, y - self.displacement(x), 0.0, 0.0
        s = np.interp(x, self.x, self.way)
        for _ in range(3):
            heading = np.interp(s, self.way, self.heading)
            ahead, right = math.cos(heading), math.sin(heading)
            off_x, off_y = x - np.interp(s, self.way, self.x), y - np.interp(s, self.way, self.y)
            s += off_x * ahead + off_y * right
        return s, off_y * ahead - off_x * right - self.displacement(s), heading, self.curvature(s)


def bulge(distance):
    """Displacement [m] of 4 mm over 10 m of the track, 25 m ahead."""
    return 2e-3 * (1 - math.cos(2 * math.pi * (distance - 25) / 10)) if 25 < distance < 35 else 0.0


def irregular(seed=1, waves=40):
    """A function of the distance: random displacement across the track, in ``waves`` cosines of 3 ... 50 m.

    ``S(W) = A W_c^2 / ((W_r^2 + W^2) (W_c^2 + W^2))`` with A = 2.119e-7 rad m, W_c = 0.8246 rad/m and
    W_r = 0.0206 rad/m: the spectrum of ERRI B176 for good track, from memory.
    """
    edges = np.geomspace(2 * np.pi / 50, 2 * np.pi / 3, waves + 1)
    middle, width = np.sqrt(edges[1:] * edges[:-1]), np.diff(edges)
    density = 2.119e-7 * 0.8246**2 / ((0.0206**2 + middle**2) * (0.8246**2 + middle**2))
    sizes = np.sqrt(2 * density * width)
    phases = np.random.default_rng(seed).uniform(0, 2 * np.pi, waves)

    def displacement(distance):
        fade = min(max((distance - 15.0) / 20.0, 0.0), 1.0)  # the vehicle begins on straight track
        return fade * float(sizes @ np.cos(middle * distance + phases))

    return displacement
