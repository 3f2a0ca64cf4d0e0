"""The record of a linear wheelset, and what follows from it without the contact."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..methods.words import did_you_mean

#: Places of the wheelset, in the order of the matrices.
COORDINATES = ("lateral_shift", "vertical_shift", "roll", "yaw")


class PatchCoefficients(NamedTuple):
    """One patch of the steady motion, and its coefficients of Kalker's linear theory.

    side : "left" or "right".
    number : of the patch, from 1.
    normal_force : [N].
    contact_angle : of its force [rad].
    half_length, half_width : semi-axes of the ellipse of its area and of its proportions [m].
    c11, c22, c23, c33 : Kalker's creepage coefficients [1], with the ratio of the semi-axes kept to 0.1 ... 10.
    f11, f22 : G a b C11, G a b C22 [N]: force over creepage.
    f23 : G (a b)^1.5 C23 [N m]: lateral force over spin, and moment over lateral creepage.
    f33 : G (a b)^2 C33 [N m2]: moment over spin.
    """

    side: str
    number: int
    normal_force: float
    contact_angle: float
    half_length: float
    half_width: float
    c11: float
    c22: float
    c23: float
    c33: float
    f11: float
    f22: float
    f23: float
    f33: float


@dataclass(frozen=True)
class Linearization:
    """A wheelset near a steady motion: its contact as matrices (n, n), in SI.

    With q the changes of the ``coordinates`` and Q the generalised forces of both rails on the wheelset, which
    are ``force.y``, ``force.z``, the moment about its own x axis and ``moment.z``,

        Q = Q0 - stiffness q - damping q'

    so that M q'' + (damping + D + G) q' + (stiffness + K) q = 0 with the mass M, dampers D and springs K of a
    suspension, and G = ``gyroscopic(inertia_pitch)``.  The wheels turn freely, or as the inputs say.

    Attributes
    ----------
    coordinates : names of the degrees of freedom (n,).
    stiffness, damping : all of the contact.
    normal_stiffness, normal_damping : of the pressures alone: the springs of the contact and the gravitational
        stiffness; the damping is that of ``contact_damping``, zero without.
    creep_stiffness, creep_damping : what the creep forces add.
    forces : Q0 (n,) [N, N m].
    speed : [m/s].
    wheel_rate : rotation about the axle [rad/s].
    place : lateral shift, vertical shift, roll and yaw of the steady motion (4,) [m, rad].
    amplitude : of the lateral shift where the matrices are quasi-linear [m], else 0.
    rotation : what the rotation about the axle couples (n, n) [1]; ``gyroscopic`` has it times its moment.
    patches : a :class:`~wrcontact.linear.PatchCoefficients` for each patch of the steady motion.
    """

    coordinates: tuple[str, ...]
    normal_stiffness: NDArray[np.float64]
    creep_stiffness: NDArray[np.float64]
    normal_damping: NDArray[np.float64]
    creep_damping: NDArray[np.float64]
    rotation: NDArray[np.float64]
    forces: NDArray[np.float64]
    speed: float
    wheel_rate: float
    place: tuple[float, ...]
    amplitude: float
    patches: tuple[PatchCoefficients, ...]

    @property
    def stiffness(self) -> NDArray[np.float64]:
        return self.normal_stiffness + self.creep_stiffness

    @property
    def damping(self) -> NDArray[np.float64]:
        return self.normal_damping + self.creep_damping

    def gyroscopic(self, inertia_pitch: float) -> NDArray[np.float64]:
        """Matrix G (n, n) of a wheelset with the moment of inertia ``inertia_pitch`` [kg m2] about its axle:
        I w yaw' in the equation of the roll, -I w roll' in that of the yaw."""
        return inertia_pitch * self.wheel_rate * self.rotation

    def condensed(
        self,
        keep: Sequence[str] = ("lateral_shift", "yaw"),
    ) -> Linearization:
        """The record of fewer degrees of freedom, ``keep``: the others follow them without inertia.

        By default two are left, the classical wheelset: height and roll are those at which the rails carry the
        load.  The contact's springs are then rigid constraints, and ``normal_stiffness`` is the gravitational
        stiffness.  With b the coordinates that follow, the dynamic stiffness K + s D is condensed to the first
        power of s:

            L = [I, -K_ab K_bb^-1],  T = [I; -K_bb^-1 K_ba],  K -> L K T,  D -> L D T

        Its parts are those of the pressures alone, each with L and T of these; what the creep forces add is the
        rest.

        Parameters
        ----------
        keep : names of coordinates.

        Raises
        ------
        ValueError
            if there is no such coordinate, or the contact does not hold those that follow: a wheel has lifted.
        """
        for name in keep:
            if name not in self.coordinates:
                raise ValueError(
                    f"keep has {name!r}{did_you_mean(name, self.coordinates)}; permitted are "
                    f"{', '.join(self.coordinates)}"
                )
        a = [self.coordinates.index(name) for name in keep]
        b = [place for place in range(len(self.coordinates)) if place not in a]
        try:
            whole, alone = (_projection(each, a, b) for each in (self.stiffness, self.normal_stiffness))
        except np.linalg.LinAlgError:
            others = " and ".join(self.coordinates[place] for place in b)
            raise ValueError(
                f"keep is {keep!r}; the contact does not hold {others}, which has to follow: a wheel has lifted"
            ) from None
        parts = {}
        for name in ("stiffness", "damping"):
            normal = parts[f"normal_{name}"] = _projected(alone, getattr(self, f"normal_{name}"))
            parts[f"creep_{name}"] = _projected(whole, getattr(self, name)) - normal
        return replace(
            self,
            coordinates=tuple(keep),
            rotation=_projected(whole, self.rotation),
            forces=whole[0] @ self.forces,
            **parts,
        )

    def state_matrix(
        self,
        mass: ArrayLike,
        stiffness: ArrayLike = 0.0,
        damping: ArrayLike = 0.0,
        inertia_pitch: float = 0.0,
    ) -> NDArray[np.float64]:
        """Matrix A (2n, 2n) of x' = A x with x = (q, q') of the wheelset on a suspension.

        Parameters
        ----------
        mass : of the coordinates: (n,) masses and moments of inertia [kg, kg m2], or a matrix (n, n).
        stiffness, damping : of the suspension against what stands still: numbers, (n,) or (n, n).
        inertia_pitch : moment of inertia about the axle [kg m2].

        Raises
        ------
        ValueError
            if a shape does not fit, or a mass is not above 0.
        """
        n = len(self.coordinates)
        masses, springs, dampers = (
            _matrix(name, value, n)
            for name, value in (("mass", mass), ("stiffness", stiffness), ("damping", damping))
        )
        if not (np.diag(masses) > 0.0).all():
            raise ValueError(f"mass is {mass!r}; permitted are numbers above 0, in kg and kg.m2")
        slow = self.stiffness + springs
        fast = self.damping + dampers + self.gyroscopic(inertia_pitch)
        return np.block([[np.zeros((n, n)), np.eye(n)], [np.linalg.solve(masses, np.hstack([-slow, -fast]))]])

    def eigenvalues(self, mass: ArrayLike, **suspension: Any) -> NDArray[np.complex128]:
        """Eigenvalues (2n,) of :meth:`state_matrix` [1/s, rad/s]; the motion grows where a real part is
        above 0."""
        return np.linalg.eigvals(self.state_matrix(mass, **suspension)).astype(complex)

    def hunting_root(self, mass: ArrayLike, slower_than: float = 300.0, **suspension: Any) -> complex:
        """The eigenvalue that grows fastest among the oscillations ``slower_than`` [rad/s] so many; the wheelset
        on the springs of its contacts is faster.  NaN if there is none."""
        found = [root for root in self.eigenvalues(mass, **suspension) if 1e-3 < root.imag < slower_than]
        return complex(max(found, key=lambda root: root.real)) if found else complex(np.nan, np.nan)


def _projection(stiffness, a, b):
    """L (n, m) and T (m, n) of :meth:`Linearization.condensed`; without ``b`` they choose."""
    size = len(stiffness)
    left, right = np.zeros((len(a), size)), np.zeros((size, len(a)))
    left[range(len(a)), a] = right[a, range(len(a))] = 1.0
    if b:
        inner = stiffness[np.ix_(b, b)]
        left[:, b] = -np.linalg.solve(inner.T, stiffness[np.ix_(a, b)].T).T
        right[b] = -np.linalg.solve(inner, stiffness[np.ix_(b, a)])
    return left, right


def _projected(sides, matrix):
    left, right = sides
    return left @ matrix @ right


def _matrix(name, value, size):
    """A number or (n,) on the diagonal, or (n, n) as it is."""
    given = np.asarray(value, dtype=float)
    if given.shape == (size, size):
        return given
    if given.shape in ((), (size,)):
        return np.diag(np.broadcast_to(given, (size,)))
    raise ValueError(
        f"{name} has the shape {given.shape}; permitted are a number, ({size},) and ({size}, {size})"
    )
