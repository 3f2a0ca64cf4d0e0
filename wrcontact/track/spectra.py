"""Spectra of track irregularities, with the source of their constants.

All are one-sided power spectral densities over the wave number W [rad/m], in m2/(rad/m): the variance of the waves
between two wave numbers is the integral between them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..methods.words import did_you_mean

QUANTITIES = ("lateral", "vertical", "cross_level", "gauge")
#: Of ERRI B176 [rad/m].
CUT, ROLL, SHORT = 0.8246, 0.0206, 0.4380
#: Of the FRA [rad/m], and the factor before its constants.
FRA_CUT, FRA_SHARE = 0.8245, 0.25


@dataclass(frozen=True)
class Spectrum:
    """Spectra of one kind of track.

    Attributes
    ----------
    name : as :func:`spectrum` takes it.
    source : of the formula and of the constants, and how they were compared.
    longest, shortest : waves for which the spectrum is meant [m].
    lateral, vertical : of the middle of the track, by the wave number [rad/m]: functions, [m2/(rad/m)].
    cross_level : of the difference of the rails' heights.
    gauge : of the deviation of the gauge.
    """

    name: str
    source: str
    longest: float
    shortest: float
    lateral: Callable[[ArrayLike], NDArray[Any]]
    vertical: Callable[[ArrayLike], NDArray[Any]]
    cross_level: Callable[[ArrayLike], NDArray[Any]]
    gauge: Callable[[ArrayLike], NDArray[Any]]

    def variance(self, quantity: str, longest: float | None = None, shortest: float | None = None) -> float:
        """Variance [m2] of the waves between two lengths [m], by Gauss's rule over the logarithm.

        Raises
        ------
        ValueError
            if there is no such quantity.
        """
        if quantity not in QUANTITIES:
            raise ValueError(f"quantity is {quantity!r}; permitted are {', '.join(QUANTITIES)}")
        ends = np.log([2.0 * np.pi / (longest or self.longest), 2.0 * np.pi / (shortest or self.shortest)])
        nodes, weights = np.polynomial.legendre.leggauss(16)
        edges = np.linspace(*ends, 201)
        half = 0.5 * np.diff(edges)[:, None]
        waves = np.exp(0.5 * (edges[1:] + edges[:-1])[:, None] + half * nodes)
        return float((half * weights * waves * getattr(self, quantity)(waves)).sum())


def _falling(size, cut, roll):
    """``size cut^2 / ((W^2 + roll^2) (W^2 + cut^2))``."""
    return lambda wave: size * cut**2 / ((np.square(wave) + roll**2) * (np.square(wave) + cut**2))


def _band(size, cut, roll, short):
    """``size cut^2 W^2 / ((W^2 + roll^2) (W^2 + cut^2) (W^2 + short^2))``."""
    fall = _falling(size, cut, roll)
    return lambda wave: fall(wave) * np.square(wave) / (np.square(wave) + short**2)


def _european(level, lateral, vertical, gauge):
    """The spectra of ERRI B176; the cross level is that of both rails, 2 b times the angle whose spectrum is printed, so
    that the printed b^-2 becomes 4."""
    return Spectrum(
        f"ERRI {level}",
        "ERRI B176, in Claus and Schiehlen, Modeling and simulation of railway bogie structural vibrations (1998). "
        "Lateral and vertical constants of the high level agree with the table of the GENSYS manual, TRC_IPSD; the "
        "vertical ones of both with three programs, lateral and gauge with one",
        200.0,
        3.0,
        _falling(lateral, CUT, ROLL),
        _falling(vertical, CUT, ROLL),
        _band(4.0 * vertical, CUT, ROLL, SHORT),
        _band(gauge, CUT, ROLL, SHORT),
    )


def _american(number, lateral, vertical, short):
    """Of the FRA; constants in cm2 rad/m."""
    rails = _falling(4.0 * FRA_SHARE * vertical * 1e-4, FRA_CUT, short)
    return Spectrum(
        f"FRA {number}",
        "FRA class, in Lei and Noda, Analyses of dynamic response of vehicle and track coupling system with random "
        "irregularity of track vertical profile (2002), after Garg and Dukkipati (1984). The vertical constants were "
        "compared with three programs and with those that one of them quotes from Berawi (2013); the lateral ones and those of "
        "cross level and gauge with none. Fryba (1996) has smaller ones",
        300.0,
        1.5,
        _falling(FRA_SHARE * lateral * 1e-4, FRA_CUT, 0.0),
        _falling(FRA_SHARE * vertical * 1e-4, FRA_CUT, 0.0),
        rails,
        rails,
    )


def _powers(ends, sizes, powers):
    """``A / f^n`` by pieces [mm2/(1/m)] over f = W / 2 pi [1/m], as [m2/(rad/m)]."""

    def found(wave):
        f = np.asarray(wave, dtype=float) / (2.0 * np.pi)
        piece = np.searchsorted(ends, f, side="right")
        return 1e-6 * np.array(sizes)[piece] / f ** np.array(powers)[piece] / (2.0 * np.pi)

    return found


#: By name.
SPECTRA = {
    found.name: found
    for found in (
        _european("low", 2.119e-7, 4.032e-7, 5.32e-8),
        _european("high", 6.125e-7, 1.08e-6, 1.032e-7),
        _american(1, 3.3634, 1.2107, 0.6046),
        _american(2, 1.2107, 1.0181, 0.9308),
        _american(3, 0.4128, 0.6816, 0.8520),
        _american(4, 0.3027, 0.5376, 1.1312),
        _american(5, 0.0762, 0.2095, 0.8209),
        _american(6, 0.0339, 0.0339, 0.4380),
        Spectrum(
            "China ballastless",
            "TB/T 3352-2014, PSD of ballastless track irregularities of high-speed railway; constants agree in three "
            "programs",
            200.0,
            2.0,
            _powers((0.0450, 0.1234), (3.9513e-3, 1.1047e-2, 7.5633e-4), (1.8670, 1.5354, 2.8171)),
            _powers(
                (0.0187, 0.0474, 0.1533),
                (1.0544e-5, 3.5588e-3, 1.9784e-2, 3.9488e-4),
                (3.3891, 1.9271, 1.3643, 3.4516),
            ),
            _powers((0.0258, 0.1163), (3.6148e-3, 4.3685e-2, 4.5867e-3), (1.7278, 1.0461, 2.0939)),
            _powers((0.1090, 0.2938), (5.4978e-2, 5.0701e-3, 1.8778e-4), (0.8282, 1.9037, 4.5948)),
        ),
    )
}


def spectrum(name: str | Spectrum) -> Spectrum:
    """A spectrum by its name, in any case: "ERRI low", "ERRI high", "FRA 1" ... "FRA 6", "China ballastless".  "AAR 4" ...
    "AAR 6" are those of the FRA.  Of FRA classes 7 ... 9 no constants are known.

    Raises
    ------
    ValueError
        if there is none.
    """
    if isinstance(name, Spectrum):
        return name
    known = {each.casefold(): found for each, found in SPECTRA.items()}
    asked = str(name).casefold().replace("aar ", "fra ")
    if asked not in known:
        raise ValueError(
            f"spectrum is {name!r}{did_you_mean(str(name), SPECTRA)}; permitted are {', '.join(SPECTRA)}"
        )
    return known[asked]
