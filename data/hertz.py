"""Hertz's contact in closed form, by scipy."""

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipkm1

MODULUS = 210e9 / (2 * (1 - 0.28**2))


def hertz(A, B, force):
    """Penetration, semi-axes a (along), b (across) and peak pressure of Hertz's contact by scipy's elliptic
    integrals.

    Johnson (1985), eq. (4.24)-(4.32), with separation A x^2 + B s^2.
    """
    small, large = min(A, B), max(A, B)

    def mismatch(log_q):
        q = np.exp(log_q)
        K, E = ellipkm1(q * q), ellipe(1 - q * q)
        return (K - E) / (E / q**2 - K) - small / large

    q = 1.0
    if small < large:
        q = np.exp(brentq(mismatch, np.log(1e-6), np.log(1 - 1e-9), xtol=1e-15, rtol=1e-15))
    K, E = ellipkm1(q * q), ellipe(1 - q * q)
    L = (2 * E / (np.pi * q**2)) ** (1 / 3)
    scale = (0.75 * force / (MODULUS * (A + B))) ** (1 / 3)
    a, b = (L * scale, q * L * scale) if A < B else (q * L * scale, L * scale)
    penetration = 2 * K / (np.pi * L) * ((0.75 * force / MODULUS) ** 2 * (A + B)) ** (1 / 3)
    return penetration, a, b, 1.5 * force / (np.pi * a * b)
