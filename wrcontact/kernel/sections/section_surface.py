"""Height and derivatives of the surface through the sections of a rail, from its table.

The surface is that of wrcontact/sections/surface.py, which has the equations.
"""

from ..layout import SectionBreaks, SectionCubic, SectionKnot, Sections


def break_below(breaks: SectionBreaks, count: int, u: float):
    """The interval, of ``count``, that holds ``u`` [m], or the nearest."""
    low = 0
    high = count
    while high - low > 1:
        middle = (low + high) // 2
        if breaks[middle] <= u:
            low = middle
        else:
            high = middle
    return low


def cubic_value(cubic: SectionCubic, t: float):
    return cubic.c0 + t * (cubic.c1 + t * (cubic.c2 + t * cubic.c3))


def cubic_jet(cubic: SectionCubic, t: float):
    """Value of a cubic and its first and second derivative."""
    return (
        cubic.c0 + t * (cubic.c1 + t * (cubic.c2 + t * cubic.c3)),
        cubic.c1 + t * (2.0 * cubic.c2 + 3.0 * t * cubic.c3),
        2.0 * cubic.c2 + 6.0 * t * cubic.c3,
    )


def line_below(sections: Sections, first: int, t: float, y: float):
    """The line, behind the knot ``first`` of an interval, whose lateral place at ``t`` [m] is the last one at or below
    ``y`` [m]; at least the first line, and at most the last but one."""
    low = 0
    high = sections.knot_count - 1
    while high - low > 1:
        middle = (low + high) // 2
        if cubic_value(sections.knots[first + middle].place, t) <= y:
            low = middle
        else:
            high = middle
    return low


def clamped_position(sections: Sections, u: float):
    """The position ``u`` [m], or the nearest one that has cubics; it is the first one if it is not a number."""
    last = sections.breaks[sections.interval_count]
    return min(max(sections.breaks[0], u), last)


def section_edges(sections: Sections, u: float):
    """Lateral places [m] of the gauge-side and of the field-side end of the section at ``u`` [m]."""
    at = clamped_position(sections, u)
    interval = break_below(sections.breaks, sections.interval_count, at)
    first = interval * sections.knot_count
    t = at - sections.breaks[interval]
    return (
        cubic_value(sections.knots[first].place, t),
        cubic_value(sections.knots[first + sections.knot_count - 1].place, t),
    )


def section_jet(sections: Sections, u: float, y: float):
    """Height [m] at ``u``, ``y`` [m] and its derivatives z_u, z_y [-], z_uu, z_uy, z_yy [1/m]."""
    at = clamped_position(sections, u)
    interval = break_below(sections.breaks, sections.interval_count, at)
    first = interval * sections.knot_count
    t = at - sections.breaks[interval]
    low = first + line_below(sections, first, t, y)
    before = sections.knots[low]
    behind = sections.knots[low + 1]
    if y < cubic_value(before.place, t):
        z, z_u, z_y, z_uu, z_uy, z_yy = straight_jet(before, t, y)
    elif y > cubic_value(behind.place, t):
        z, z_u, z_y, z_uu, z_uy, z_yy = straight_jet(behind, t, y)
    else:
        z, z_u, z_y, z_uu, z_uy, z_yy = quintic_jet(before, behind, t, y)
    return z, z_u, z_y, z_uu, z_uy, z_yy


def straight_jet(knot: SectionKnot, t: float, y: float):
    """The jet beyond the first or last line: on the straight line through it."""
    place, place_u, place_uu = cubic_jet(knot.place, t)
    z, z_u, z_uu = cubic_jet(knot.height, t)
    s, s_u, s_uu = cubic_jet(knot.slope, t)
    w = y - place
    return (
        z + s * w,
        z_u + s_u * w - s * place_u,
        s,
        z_uu + s_uu * w - 2.0 * s_u * place_u - s * place_uu,
        s_u,
        0.0,
    )


def quintic_jet(before: SectionKnot, behind: SectionKnot, t: float, y: float):
    """The jet between two lines."""
    place, place_u, place_uu = cubic_jet(before.place, t)
    z0, z0_u, z0_uu = cubic_jet(before.height, t)
    s0, s0_u, s0_uu = cubic_jet(before.slope, t)
    b0, b0_u, b0_uu = cubic_jet(before.behind, t)
    h, h_u, h_uu = cubic_jet(behind.place, t)
    z1, z1_u, z1_uu = cubic_jet(behind.height, t)
    s1, s1_u, s1_uu = cubic_jet(behind.slope, t)
    b1, b1_u, b1_uu = cubic_jet(behind.before, t)
    h -= place
    h_u -= place_u
    h_uu -= place_uu
    q = h * h
    q_u = 2.0 * h * h_u
    q_uu = 2.0 * (h_u * h_u + h * h_uu)
    r = z1 - z0 - h * s0 - 0.5 * q * b0
    r_u = z1_u - z0_u - h_u * s0 - h * s0_u - 0.5 * (q_u * b0 + q * b0_u)
    r_uu = (
        z1_uu
        - z0_uu
        - (h_uu * s0 + 2.0 * h_u * s0_u + h * s0_uu)
        - 0.5 * (q_uu * b0 + 2.0 * q_u * b0_u + q * b0_uu)
    )
    d = s1 - s0
    d_u = s1_u - s0_u
    e = h * d - q * b0
    e_u = h_u * d + h * d_u - q_u * b0 - q * b0_u
    e_uu = h_uu * d + 2.0 * h_u * d_u + h * (s1_uu - s0_uu) - q_uu * b0 - 2.0 * q_u * b0_u - q * b0_uu
    d = b1 - b0
    d_u = b1_u - b0_u
    f = 0.5 * q * d
    f_u = 0.5 * (q_u * d + q * d_u)
    f_uu = 0.5 * (q_uu * d + 2.0 * q_u * d_u + q * (b1_uu - b0_uu))
    w = y - place
    v = w / h
    v_y = 1.0 / h
    v_u = (-place_u - v * h_u) * v_y
    v_uu = (-place_uu - 2.0 * v_u * h_u - v * h_uu) * v_y
    v_uy = -h_u * v_y * v_y
    # the rest of degree 3 to 5, and its derivatives by v
    a3 = 10.0 * r - 4.0 * e + f
    a4 = -15.0 * r + 7.0 * e - 2.0 * f
    a5 = 6.0 * r - 3.0 * e + f
    a3_u = 10.0 * r_u - 4.0 * e_u + f_u
    a4_u = -15.0 * r_u + 7.0 * e_u - 2.0 * f_u
    a5_u = 6.0 * r_u - 3.0 * e_u + f_u
    square = v * v
    rest_uu = (
        10.0 * r_uu
        - 4.0 * e_uu
        + f_uu
        + v * (-15.0 * r_uu + 7.0 * e_uu - 2.0 * f_uu + v * (6.0 * r_uu - 3.0 * e_uu + f_uu))
    )
    by_v = square * (3.0 * a3 + v * (4.0 * a4 + 5.0 * v * a5))
    by_v_u = square * (3.0 * a3_u + v * (4.0 * a4_u + 5.0 * v * a5_u))
    by_vv = v * (6.0 * a3 + v * (12.0 * a4 + 20.0 * v * a5))
    slope = s0 + w * b0
    slope_u = s0_u + w * b0_u
    return (
        z0 + w * (s0 + 0.5 * w * b0) + square * v * (a3 + v * (a4 + v * a5)),
        z0_u
        + w * (s0_u + 0.5 * w * b0_u)
        - slope * place_u
        + square * v * (a3_u + v * (a4_u + v * a5_u))
        + by_v * v_u,
        slope + by_v * v_y,
        z0_uu
        + w * (s0_uu + 0.5 * w * b0_uu)
        - 2.0 * slope_u * place_u
        + b0 * place_u * place_u
        - slope * place_uu
        + square * v * rest_uu
        + 2.0 * by_v_u * v_u
        + by_vv * v_u * v_u
        + by_v * v_uu,
        slope_u - b0 * place_u + (by_v_u + by_vv * v_u) * v_y + by_v * v_uy,
        b0 + by_vv * v_y * v_y,
    )


def section_ruling(sections: Sections, u: float, y: float):
    """The lateral rate [-], along the track, of the line of equal share through ``u``, ``y`` [m]."""
    at = clamped_position(sections, u)
    interval = break_below(sections.breaks, sections.interval_count, at)
    first = interval * sections.knot_count
    t = at - sections.breaks[interval]
    low = first + line_below(sections, first, t, y)
    place, rate, bend = cubic_jet(sections.knots[low].place, t)
    other, other_rate, bend = cubic_jet(sections.knots[low + 1].place, t)
    share = min(max((y - place) / (other - place), 0.0), 1.0)
    return rate + share * (other_rate - rate)
