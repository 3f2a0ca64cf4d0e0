"""Kalker's creepage and spin coefficients of an ellipse: his table and its limits.

They give the linear force and the scale of the creepages at which friction is used up.
"""

import math

import numpy as np

#: Ratios g of the shorter to the longer half-axis, and Poisson's ratios, of COEFFICIENTS.
RATIOS = tuple(k / 10 for k in range(1, 11))
POISSON_RATIOS = (0.0, 0.25, 0.5)
#: C11, C22, C23 [half-length <= half-width, >][ratio][coefficient][Poisson's ratio]: Kalker (1990), table E3.
COEFFICIENTS = np.array((
    (((2.51, 3.31, 4.85), (2.51, 2.52, 2.53), (0.334, 0.473, 0.731)),
     ((2.59, 3.37, 4.81), (2.59, 2.63, 2.66), (0.483, 0.603, 0.809)),
     ((2.68, 3.44, 4.8), (2.68, 2.75, 2.81), (0.607, 0.715, 0.889)),
     ((2.78, 3.53, 4.82), (2.78, 2.88, 2.98), (0.72, 0.823, 0.977)),
     ((2.88, 3.62, 4.83), (2.88, 3.01, 3.14), (0.827, 0.929, 1.07)),
     ((2.98, 3.72, 4.91), (2.98, 3.14, 3.31), (0.93, 1.03, 1.18)),
     ((3.09, 3.81, 4.97), (3.09, 3.28, 3.48), (1.03, 1.14, 1.29)),
     ((3.19, 3.91, 5.05), (3.19, 3.41, 3.65), (1.13, 1.25, 1.4)),
     ((3.29, 4.01, 5.12), (3.29, 3.54, 3.82), (1.23, 1.36, 1.51)),
     ((3.4, 4.12, 5.2), (3.4, 3.67, 3.98), (1.33, 1.47, 1.63))),
    (((10.7, 11.7, 12.9), (10.7, 12.8, 16.0), (12.2, 14.6, 18.0)),
     ((6.96, 7.78, 8.82), (6.96, 8.14, 9.79), (5.72, 6.63, 7.89)),
     ((5.57, 6.34, 7.34), (5.57, 6.4, 7.51), (3.79, 4.32, 5.01)),
     ((4.84, 5.57, 6.57), (4.84, 5.48, 6.31), (2.88, 3.24, 3.7)),
     ((4.37, 5.1, 6.11), (4.37, 4.9, 5.56), (2.35, 2.62, 2.96)),
     ((4.06, 4.78, 5.8), (4.06, 4.5, 5.04), (2.01, 2.23, 2.5)),
     ((3.82, 4.54, 5.58), (3.82, 4.21, 4.67), (1.76, 1.95, 2.18)),
     ((3.65, 4.36, 5.42), (3.65, 3.99, 4.39), (1.58, 1.75, 1.94)),
     ((3.51, 4.22, 5.3), (3.51, 3.81, 4.16), (1.44, 1.59, 1.77)),
     ((3.4, 4.12, 5.2), (3.4, 3.67, 3.98), (1.33, 1.47, 1.63))),
))


def creep_coefficients(half_length, half_width, poisson_ratio):
    """C11, C22, C23 (3,) of an ellipse; its half-length lies along the rolling direction.

    Between the ratios of Kalker's table straight lines; 1/C is a parabola of Poisson's ratio.  Ellipses
    beyond the table, g < 0.1, have the limits of :func:`slender_coefficients`.
    """
    g = min(half_length / half_width, half_width / half_length)
    if g < RATIOS[0] * (1.0 - 1e-12):
        return slender_coefficients(half_length, half_width, poisson_ratio)
    table = COEFFICIENTS[int(half_length > half_width)]
    at_ratio = np.array([[np.interp(g, RATIOS, table[:, i, k]) for k in range(3)] for i in range(3)])
    return np.array([1.0 / np.polyval(np.polyfit(POISSON_RATIOS, 1.0 / each, 2), poisson_ratio)
                     for each in at_ratio])


def slender_coefficients(half_length, half_width, poisson_ratio):
    """C11, C22, C23 (3,) of a long or wide ellipse, as g = shorter / longer half-axis goes to 0.

    Kalker (1990), table E3, its last lines.
    """
    nu, g = poisson_ratio, min(half_length / half_width, half_width / half_length)
    if half_length <= half_width:
        plane = 0.25 * math.pi**2
        spin = math.pi * math.sqrt(g) / (3.0 * (1.0 - nu)) * (1.0 + nu * (math.log(16.0 / g) - 5.0))
        return np.array([plane / (1.0 - nu), plane, spin])
    long, rest = math.log(16.0 / g**2), 3.0 - math.log(4.0)
    first, second = long - 2.0 * nu, (1.0 - nu) * long + 2.0 * nu
    return np.array([2.0 * math.pi / (first * g) * (1.0 + rest / first),
                     2.0 * math.pi / (g * second) * (1.0 + (1.0 - nu) * rest / second),
                     2.0 * math.pi / (3.0 * g**1.5 * ((1.0 - nu) * long - 2.0 + 4.0 * nu))])
