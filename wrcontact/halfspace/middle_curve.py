"""The curve between wheel and rail over which a contact is solved, and its normals.

A rail point r is joined with the wheel's outline along the mean of both bodies' normals there; the middle of
the joint is a point of the curve, and the curve's arc length is the station sigma (H8 of docs/method.md).
Seen along the track the patch lies on this curve.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

RAIL_STEP = 4e-5         # [m] of the rail's abscissa between two points of the curve
#: Where the bodies are farther apart than FAR [m] the curve is the rail's, with the rail's normals; up to
#: NEAR they count half each, and in between the change is gradual.
NEAR, FAR = 0.3e-3, 1e-3
ROUNDS = 6               # of the joint's direction, which is the mean of the normals at its ends
LONGEST = 20             # points of the outline passed in one round
ASIDE = 1e-6             # [m]; a joint that ends farther from its normal has found nothing


@dataclass(frozen=True)
class MiddleCurve:
    """Points (k,) of the curve, in the track frame of a right wheel.

    Attributes
    ----------
    s : stations [m], rising from the rail's inner side to its field side.
    y, z : places [m].
    angle : of the normals (0, -sin, -cos) [rad].
    x : where along the track the wheel is closest to each normal [m].
    ridge : distance [m] from the point to the wheel there, along the normal; inf where they are not close.
    rail : distance [m] from the point to the rail along the normal.
    rail_y : abscissa of the rail point that it belongs to [m], in the track frame.
    """

    s: np.ndarray
    y: np.ndarray
    z: np.ndarray
    angle: np.ndarray
    x: np.ndarray
    ridge: np.ndarray
    rail: np.ndarray
    rail_y: np.ndarray

    def at(self, name, s):
        """The attribute ``name`` at stations s [m], straight between the points."""
        return np.interp(s, self.s, getattr(self, name))

    def shifted(self, station):
        """The same with stations counted from ``station`` [m]."""
        return MiddleCurve(**{**vars(self), "s": self.s - station})

    def station_of(self, rail_y):
        """Station [m] of the point that belongs to the rail's abscissa ``rail_y`` [m]."""
        return float(np.interp(rail_y, self.rail_y, self.s))


def middle_curve(pair):
    """The curve of a placed wheel and its rail, over the whole rail; stations from its inner end on."""
    rail_y, rail_z, rail_angle = pair.rail_points(RAIL_STEP)
    joint, angle, x = _join(pair.outline, rail_y, rail_z, rail_angle)
    near = np.clip((FAR - np.where(np.isfinite(joint), joint, FAR)) / (FAR - NEAR), 0.0, 1.0)
    share = near**2 * (3.0 - 2.0 * near)
    angle = rail_angle + share * (angle - rail_angle)
    half = 0.5 * share * np.where(np.isfinite(joint), joint, 0.0)
    y, z = rail_y - half * np.sin(angle), rail_z - half * np.cos(angle)
    s = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))])
    return MiddleCurve(s, y, z, angle, x, np.where(share > 0.0, joint - half, np.inf), -half, rail_y)


def _join(outline, y, z, angle):
    """From rail points (k,) with normals at ``angle`` along the mean normals to the outline: distance [m],
    negative in an overlap and NaN where the outline is not met; mean angle [rad]; the outline's x [m]."""
    place = cKDTree(np.stack([outline.y, outline.z], axis=-1)).query(np.stack([y, z], axis=-1))[1]
    count = np.arange(len(outline.y))
    for _ in range(ROUNDS):
        k = np.clip(place.astype(int), 0, len(count) - 2)
        at_y, at_z, facing = (np.interp(place, count, each) for each in (outline.y, outline.z, outline.angle))
        mean = 0.5 * (angle + facing)
        # zero where the outline's point lies on the normal
        aside = (at_y - y) * np.cos(mean) - (at_z - z) * np.sin(mean)
        rate = ((outline.y[k + 1] - outline.y[k]) * np.cos(mean)
                - (outline.z[k + 1] - outline.z[k]) * np.sin(mean))
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.nan_to_num(aside / rate)
        place = np.clip(place - np.clip(step, -LONGEST, LONGEST), 0, len(count) - 1)
    t = -(at_y - y) * np.sin(mean) - (at_z - z) * np.cos(mean)
    return np.where(np.abs(aside) < ASIDE, t, np.nan), mean, np.interp(place, count, outline.x)
