"""Curves with transitions, whose curvature grows evenly: clothoids."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..methods.numbers import is_plain


@dataclass(frozen=True)
class Curve:
    """Straight track, a transition, a full curve, a transition, and straight track again.

    Parameters
    ----------
    radius : of the full curve [m], positive to the right.
    transition : length of each transition [m]; curvature and cant grow evenly along it (clothoid).
    length : of the full curve [m].
    start : distance at which the first transition begins [m].
    cant : how much lower the inner rail is than the outer one in the full curve [m].
    """

    radius: float
    transition: float
    length: float
    start: float = 0.0
    cant: float = 0.0

    def __post_init__(self):
        if not is_plain(self.radius) or not 10.0 <= abs(self.radius) < math.inf:
            raise ValueError(
                f"radius is {self.radius!r}; permitted are numbers of 10 m at least, negative to the left"
            )
        for name in ("transition", "length"):
            value = getattr(self, name)
            if not is_plain(value) or not 0.0 < value < math.inf:
                raise ValueError(f"{name} is {value!r}; permitted are numbers above 0, in m")
        if not -0.3 <= self.cant <= 0.3:
            raise ValueError(f"cant is {self.cant!r}; permitted are -0.3 ... 0.3 m")

    def _share(self, distance):
        """Share of the full curve at a distance, 0 ... 1."""
        way = np.asarray(distance, dtype=float) - self.start
        leaving = 2.0 * self.transition + self.length - way
        return np.clip(np.minimum(way, leaving) / self.transition, 0.0, 1.0)

    def curvature(self, distance: ArrayLike) -> NDArray[Any]:
        """At places along the track [1/m], positive to the right: the input ``track_curvature``."""
        return self._share(distance) / self.radius

    def cant_at(self, distance: ArrayLike) -> NDArray[Any]:
        """How much lower the inner rail is at places along the track [m]."""
        return self._share(distance) * self.cant

    def heading(self, distance: ArrayLike) -> NDArray[Any]:
        """Direction against that before the curve [rad], positive to the right: the integral of the curvature."""
        t, full = self.transition, self.length
        way = np.asarray(distance, dtype=float) - self.start
        first = np.clip(way, 0.0, t)
        middle = np.clip(way - t, 0.0, full)
        last = np.clip(way - t - full, 0.0, t)
        return (first**2 / (2.0 * t) + middle + last - last**2 / (2.0 * t)) / self.radius

    def position(self, distance: ArrayLike) -> tuple[NDArray[Any], NDArray[Any]]:
        """Places (x, y) [m] in the plane, from where the first transition begins: x ahead, y to the right.

        Integrals of cosine and sine of the heading by Gauss's rule on stretches of 1 m at most.
        """
        where = np.asarray(distance, dtype=float)
        nodes, weights = np.polynomial.legendre.leggauss(8)
        pieces = np.maximum(1, np.ceil(abs(where - self.start)).astype(int)).max(initial=1)
        edges = self.start + (where - self.start)[..., None] * np.linspace(0.0, 1.0, pieces + 1)
        half = 0.5 * np.diff(edges, axis=-1)[..., None]
        along = 0.5 * (edges[..., 1:] + edges[..., :-1])[..., None] + half * nodes
        turned = self.heading(along)
        return tuple((half * weights * of(turned)).sum(axis=(-1, -2)) for of in (np.cos, np.sin))
