"""The steady rolling problem on given cells, by semi-smooth Newton steps; the linear equations of a step by
generalised minimal residuals (Saad and Schultz 1986).

Friction says of every cell's traction p, bound g and slip s:  |p| <= g;  |p| < g and s = 0;  or
p = -g s/|s|.  With any c > 0 this is one equation, p = P(p - c s), where P cuts a vector to the length g.
(R6), (R7) of docs/theory/rolling.md.
"""

import numpy as np
from scipy.sparse.linalg import LinearOperator, gmres

DIMENSION_LIMIT = 120
#: Largest |p - P(p - c s)| over the largest bound at which a solution stands.
PRECISION = 1e-6
STEP_LIMIT = 60
SHORTEST_STEP = 0.1
#: Relative residual to which the linear equations of a step are solved.
LINEAR_PRECISION = 3e-3


class Friction:
    """The friction equation at one state: its residual (2, ny, nx) and the derivative of the cut."""

    def __init__(self, tractions, slip, bound, scale):
        wanted = tractions - scale * slip
        length = np.hypot(*wanted)
        self.tractions, self.slip = tractions, slip
        self.loaded = bound > 0.0
        self.slips = self.loaded & (length > bound)
        length = np.where(length > 0.0, length, 1.0)
        share = np.where(self.slips, bound / length, 1.0)
        self.residual = np.where(self.loaded, tractions - share * wanted, tractions)
        self.error = np.abs(self.residual).max()
        self.norm = np.sqrt((self.residual**2).sum())
        ex, ey = wanted / length
        self.xx = np.where(self.slips, share * (1.0 - ex * ex), 1.0) * self.loaded
        self.yy = np.where(self.slips, share * (1.0 - ey * ey), 1.0) * self.loaded
        self.xy = np.where(self.slips, -share * ex * ey, 0.0)

    def cut(self, change):
        """Change of the cut vector (2, ny, nx)."""
        x, y = change
        return np.stack([self.xx * x + self.xy * y, self.xy * x + self.yy * y])


def row_inverses(friction, influence, scale):
    """Inverse of each row's own linear equations (ny, 2 nx, 2 nx), the preconditioner; in single precision,
    which is enough for it and takes half the time."""
    rows, columns = influence.shape
    along, across = (np.eye(columns) - scale * influence.rows).astype(np.float32)
    blocks = np.empty((rows, 2 * columns, 2 * columns), np.float32)
    xx, xy, yy = (each[:, :, None].astype(np.float32) for each in (friction.xx, friction.xy, friction.yy))
    own = np.eye(columns, dtype=np.float32)
    blocks[:, :columns, :columns] = own - xx * along
    blocks[:, :columns, columns:] = -xy * across
    blocks[:, columns:, :columns] = -xy * along
    blocks[:, columns:, columns:] = own - yy * across
    return np.linalg.inv(blocks)


def newton_step(friction, influence, scale):
    """Change of the tractions (2, ny, nx) that makes the linearised friction equation zero, or the best of
    DIMENSION_LIMIT vectors.  Preconditioned from the right, so that the residual is that of the equation."""
    rows, columns = influence.shape
    inverses = row_inverses(friction, influence, scale)

    def precondition(vector):
        by_row = vector.astype(np.float32).reshape(2, rows, columns).transpose(1, 0, 2)
        found = (inverses @ by_row.reshape(rows, 2 * columns, 1)).reshape(rows, 2, columns)
        return found.transpose(1, 0, 2).astype(float).ravel()

    def derivative(vector):
        change = vector.reshape(2, rows, columns)
        return (change - friction.cut(change - scale * influence(change))).ravel()

    size = friction.residual.size
    operator = LinearOperator((size, size), lambda vector: derivative(precondition(vector)), dtype=float)
    found, _ = gmres(
        operator,
        -friction.residual.ravel(),
        rtol=LINEAR_PRECISION,
        atol=0.0,
        restart=DIMENSION_LIMIT,
        maxiter=1,
    )
    return precondition(found).reshape(2, rows, columns)


def solve_friction(influence, rigid_slip, bound, start):
    """Friction's state at its solution, and the number of Newton steps.

    Parameters
    ----------
    influence : a :class:`~wrcontact.halfspace.rolling.contact.SlipInfluence`.
    rigid_slip : slip of the rigid bodies over V (2, ny, nx) [1].
    bound : friction times pressure (ny, nx) [Pa]; zero outside the patch.
    start : tractions to start from (2, ny, nx) [Pa].

    Raises
    ------
    ArithmeticError
        if the residual does not fall to PRECISION within STEP_LIMIT steps.
    """
    scale = 1.0 / influence.own[0]
    allowed = PRECISION * bound.max()

    def state(tractions):
        return Friction(tractions, rigid_slip + influence(tractions), bound, scale)

    friction = state(start)
    for count in range(STEP_LIMIT):
        if friction.error <= allowed:
            return friction, count
        step, share = newton_step(friction, influence, scale), 1.0
        trial = state(friction.tractions + step)
        while trial.norm > (1.0 - 0.1 * share) * friction.norm and share > SHORTEST_STEP:
            share *= 0.5
            trial = state(friction.tractions + share * step)
        friction = trial
    raise ArithmeticError(
        f"steady rolling: the residual stays at {friction.error:.1e} Pa (allowed {allowed:.1e} Pa)"
    )
