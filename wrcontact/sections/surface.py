"""The surface z(u, y) through the sections of a rail, with its first and second derivatives.

Every knot of the sections runs along the track on a line y_k(u), where height, slope and second derivative across are
z_k(u), s_k(u) and b_k(u): cubic splines through those of the slices (along.py). Between two lines the height is the
polynomial of degree 5 in y that has these at both. With v the share of the way from one line to the next, h their
distance and w = v h,

    z = z_0 + s_0 w + b_0 w^2 / 2 + v^3 (A_3 + A_4 v + A_5 v^2),
    A_3 = 10 R - 4 S + B / 2,  A_4 = -15 R + 7 S - B,  A_5 = 6 R - 3 S + B / 2,
    R = z_1 - z_0 - h s_0 - h^2 b_0 / 2,  S = h (s_1 - s_0 - h b_0),  B = h^2 (b_1 - b_0).

Second derivatives are continuous, but across the track where those of all slices jump. Beyond the first and the last
line the surface goes straight on.
"""

import numpy as np

from .along import LONGEST_RUN_OUT, backwards, least_of, splines

#: What a row of values at a slice's knot has: place, height, slope, second derivative before and behind.
PLACE, HEIGHT, SLOPE, BEFORE, BEHIND = range(5)
#: Lines closer together than this cross [m].
LEAST_DISTANCE = 1e-7
#: A run-out in which lines would cross is halved, at most so often.
RUN_OUT_HALVINGS = 8


class Surface:
    """The surface through ``values`` (n, k, 5) of the knots of slices at rising ``positions`` (n,) [m].

    Attributes
    ----------
    breaks : (m + 1,) [m], where the cubics along the track begin and the last one ends.
    cubics : (m, 4, k, 5), their coefficients.
    """

    def __init__(self, positions, values):
        self.positions = np.asarray(positions, dtype=float)
        run_out = LONGEST_RUN_OUT
        for _ in range(1 + RUN_OUT_HALVINGS):
            self.breaks, self.cubics = splines(self.positions, values, run_out)
            least = least_of(np.diff(self.cubics[..., PLACE], axis=2), np.diff(self.breaks))
            if (least > LEAST_DISTANCE).all() or (least[2:-2] <= LEAST_DISTANCE).any():
                break
            run_out *= 0.5
        if not least.min() > LEAST_DISTANCE:
            where = int(np.unravel_index(np.argmin(least), least.shape)[0])
            low, high = self.breaks[where], self.breaks[where + 1]
            raise ValueError(
                f"lines of equal share cross between the positions {low:.6g} and {high:.6g} m; permitted are sections "
                "whose places change little from slice to slice, or features that say what belongs together"
            )

    def placed(self, position, against, down):
        """The same surface with the position 0 at ``position`` [m], positions that count ``against`` the track or along it,
        and heights that are larger by ``down`` [m]."""
        if position == 0.0 and not against and down == 0.0:
            return self
        made = object.__new__(Surface)
        breaks, cubics = self.breaks, self.cubics.copy()
        if against:
            cubics = backwards(cubics, np.diff(breaks))[::-1]
            breaks = -breaks[::-1]
        cubics[:, 0, :, HEIGHT] += down
        made.positions = np.sort(-self.positions if against else self.positions) + position
        made.breaks, made.cubics = breaks + position, cubics
        return made

    def lines(self, u):
        """Values of all knot lines and their first and second derivatives along the track at ``u`` [m]: (3, k, 5)."""
        at, t = self._at(np.array([float(u)]))
        c = self.cubics[at[0]]
        t = t[0]
        return np.stack(
            [
                c[0] + t * (c[1] + t * (c[2] + t * c[3])),
                c[1] + t * (2.0 * c[2] + 3.0 * t * c[3]),
                2.0 * c[2] + 6.0 * t * c[3],
            ]
        )

    def samples(self, u, low, high, shares, beside):
        """Lateral places (n,) [m] by rising y and :meth:`jet` (8, n) at one position ``u`` [m]: at ``shares`` (s,) of the way
        from each line to the next, and ``beside`` [m] apart on both sides, from ``low`` to ``high`` [m].

        Where second derivatives jump at a line, those of both sides are there.
        """
        lines = self.lines(u)
        first = [lines[:, :-1, column, None] for column in (PLACE, HEIGHT, SLOPE, BEHIND)]
        second = [lines[:, 1:, column, None] for column in (PLACE, HEIGHT, SLOPE, BEFORE)]
        y = first[0][0] + (second[0][0] - first[0][0]) * shares
        jet = _quintic(first, second, y).reshape(8, -1)
        ends = []
        for line, towards in ((0, low), (-1, high)):
            away = np.linspace(
                towards, lines[0, line, PLACE], 2 + int(abs(towards - lines[0, line, PLACE]) / beside)
            )
            ends.append(
                (away, _line([lines[:, line, column] for column in (PLACE, HEIGHT, SLOPE, BEHIND)], away))
            )
        (before, jet_before), (behind, jet_behind) = ends
        return (
            np.concatenate([before, y.ravel(), behind[::-1]]),
            np.concatenate([jet_before, jet, jet_behind[:, ::-1]], axis=1),
        )

    def arcs(self, u):
        """Length of the section at ``u`` [m] from its first line to each (k,) [m], by Gauss's formula."""
        lines = self.lines(u)
        first = [lines[:, :-1, column, None] for column in (PLACE, HEIGHT, SLOPE, BEHIND)]
        second = [lines[:, 1:, column, None] for column in (PLACE, HEIGHT, SLOPE, BEFORE)]
        nodes, weights = np.polynomial.legendre.leggauss(10)
        distance = second[0][0] - first[0][0]
        slope = _quintic(first, second, first[0][0] + distance * 0.5 * (1.0 + nodes))[2]
        return np.append(0.0, np.cumsum(0.5 * distance[:, 0] * (np.hypot(1.0, slope) @ weights)))

    def edges(self, u):
        """Lateral places [m] of the first and of the last line at ``u`` [m], two arrays of its shape."""
        at, t = self._at(u)
        return tuple(self._values(at, t, knot, PLACE)[0] for knot in (0, -1))

    def _at(self, u):
        u = np.clip(u, self.breaks[0], self.breaks[-1])
        at = np.clip(np.searchsorted(self.breaks, u, side="right") - 1, 0, len(self.breaks) - 2)
        return at, u - self.breaks[at]

    def jet(self, u, y):
        """Height [m] and its derivatives z_u, z_y [-], z_uu, z_uy, z_yy [1/m], then those of the lateral place along a
        line of equal share q = Y_u [-] and q_u [1/m], at ``u`` and ``y`` [m]: (8,) and their common shape."""
        u, y = np.broadcast_arrays(np.asarray(u, dtype=float), np.asarray(y, dtype=float))
        at, t = self._at(u)
        low, high = np.zeros(u.shape, dtype=int), np.full(u.shape, self.cubics.shape[2] - 1)
        last = high.copy()
        while (high - low > 1).any():
            middle = (low + high) // 2
            right = (high - low > 1) & (self._values(at, t, middle, PLACE)[0] <= y)
            left = (high - low > 1) & ~right
            low, high = np.where(right, middle, low), np.where(left, middle, high)
        first = [self._values(at, t, low, column) for column in (PLACE, HEIGHT, SLOPE, BEHIND)]
        second = [self._values(at, t, high, column) for column in (PLACE, HEIGHT, SLOPE, BEFORE)]
        beside = y < first[0][0]
        beyond = (high == last) & (y > second[0][0])
        inside = _quintic(first, second, y)
        straight = [_line(end, y) for end in (first, second)]
        return np.where(beside, straight[0], np.where(beyond, straight[1], inside))

    def _values(self, at, t, knot, column):
        """Value and two derivatives along the track of a ``column`` of knots."""
        c0, c1, c2, c3 = (self.cubics[at, power, knot, column] for power in range(4))
        return np.stack(
            [c0 + t * (c1 + t * (c2 + t * c3)), c1 + t * (2.0 * c2 + 3.0 * t * c3), 2.0 * c2 + 6.0 * t * c3]
        )


def _times(a, b):
    """The product of two functions of u, with its two derivatives."""
    return np.stack([a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + 2.0 * a[1] * b[1] + a[0] * b[2]])


def _quintic(first, second, y):
    """The jet between two lines."""
    place, height, slope, bend = first
    h = second[0] - place
    square = _times(h, h)
    w, w_u, w_uu = y - place[0], -place[1], -place[2]
    R = second[1] - height - _times(h, slope) - 0.5 * _times(square, bend)
    S = _times(h, second[2] - slope) - _times(square, bend)
    B = _times(square, second[3] - bend)
    A3, A4, A5 = 10.0 * R - 4.0 * S + 0.5 * B, -15.0 * R + 7.0 * S - B, 6.0 * R - 3.0 * S + 0.5 * B
    v = w / h[0]
    v_u = (w_u - v * h[1]) / h[0]
    v_uu = (w_uu - 2.0 * v_u * h[1] - v * h[2]) / h[0]
    v_uy = -h[1] / square[0]
    T = v**3 * (A3 + v * (A4 + v * A5))
    T_v = v**2 * (3.0 * A3 + v * (4.0 * A4 + 5.0 * v * A5))
    T_vv = v * (6.0 * A3[0] + v * (12.0 * A4[0] + 20.0 * v * A5[0]))
    E, E_y = height + w * (slope + 0.5 * w * bend), slope + w * bend
    return np.stack(
        [
            E[0] + T[0],
            E[1] + E_y[0] * w_u + T[1] + T_v[0] * v_u,
            E_y[0] + T_v[0] / h[0],
            E[2] + 2.0 * E_y[1] * w_u + bend[0] * w_u**2 + E_y[0] * w_uu
            + T[2] + 2.0 * T_v[1] * v_u + T_vv * v_u**2 + T_v[0] * v_uu,
            E_y[1] + bend[0] * w_u + (T_v[1] + T_vv * v_u) / h[0] + T_v[0] * v_uy,
            bend[0] + T_vv / square[0],
            place[1] + v * h[1],
            place[2] + v * h[2],
        ]
    )  # fmt: skip


def _line(end, y):
    """The jet on the straight line through an ``end``."""
    place, height, slope, _ = end
    w = y - place[0]
    return np.stack(
        [
            height[0] + slope[0] * w,
            height[1] + slope[1] * w - slope[0] * place[1],
            slope[0] + 0.0 * w,
            height[2] + slope[2] * w - 2.0 * slope[1] * place[1] - slope[0] * place[2],
            slope[1] + 0.0 * w,
            0.0 * w,
            place[1] + 0.0 * w,
            place[2] + 0.0 * w,
        ]
    )
