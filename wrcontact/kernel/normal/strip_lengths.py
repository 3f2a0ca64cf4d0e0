"""Half-lengths of the strips from their line loads; eqs. (S6)-(S9)."""

from math import pi, sqrt

from ..layout import StripProblem, Tables
from .strip_surfaces import limit_lengths


def correct_lengths(tables: Tables, problem: StripProblem):
    """Line load, square of the corrected half-length, and pressure of every strip.

    At fixed line load the half-length follows from two conditions that are one for an ellipse: the curvature
    of the middle line along the track, eqs. (S3) and (S6), and ANALYN's ratio of line load to half-length,
    eq. (S7).  Their geometric mean is taken, eq. (S8).
    """
    strips = problem.strips
    count = problem.count
    scale = 0.5 * pi * pi * tables.contact_modulus
    for i in range(count):
        strip = strips[i]
        line_load = 0.0
        square = 0.0
        pressure = 0.0
        if strip.y > 0.0:
            half = strip.half_length
            line_load = scale * half * strip.y / strip.width
            bend = 0.0
            row = problem.influences[i]
            for j in range(count):
                other = strips[j]
                away = strip.station - other.station
                bend += row[j] * other.y / (other.half_length * other.half_length + away * away)
            by_curvature = half * half * bend / (2.0 * strip.A)
            by_load = line_load / strip.load_per_square
            square = sqrt(by_curvature * by_load)
            pressure = 2.0 / pi * line_load / sqrt(square)
        strip.line_load = line_load
        strip.half_length_square = square
        strip.pressure = pressure
    return 0


def adopt_lengths(problem: StripProblem):
    """Give loaded strips their corrected half-lengths, for the next sweep."""
    strips = problem.strips
    count = problem.count
    longest = 0.0
    for i in range(count):
        strip = strips[i]
        if strip.half_length_square > 0.0:
            half = sqrt(strip.half_length_square)
            strip.half_length = half
            if half > longest:
                longest = half
    limit_lengths(strips, count, longest)
    return 0
