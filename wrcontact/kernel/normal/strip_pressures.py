"""Pressures of the strips: no strip pulls, none without load penetrates, and together they carry the force;
eq. (S5).

A linear complementarity problem: elimination for the strips that are taken as loaded, then an exchange of
those that pull or penetrate, until none does.
"""

from math import pi
from typing import Final

from ..layout import Equations, State, StripProblem, Tables
from .elimination import eliminate
from .strip_influence import know_influences

#: All wrong strips are exchanged at once in so many rounds, then one strip in each round, which cannot go in
#: circles.
EXCHANGES: Final[int] = 10
EXCHANGE_LIMIT: Final[int] = 200
#: A strip without load is loaded if it penetrates by this share of the penetration; rounding is 1e-14.
TOUCH: Final[float] = 1e-12


def solve_pressures(problem: StripProblem, equations: Equations, tables: Tables, state: State, force: float,
                    by_penetration: bool, yawed: bool):
    """y of all strips, and which are loaded, under ``force`` [N], or at the problem's penetration where
    ``by_penetration``; the penetration [m], and whether found."""
    penetration = problem.penetration
    for exchange in range(EXCHANGE_LIMIT):
        state.strip_count += 1.0
        know_influences(tables.influence, problem, yawed)
        size = list_loaded(problem)
        write_equations(problem, equations, size)
        eliminate(equations, size)
        if not by_penetration:
            penetration = equilibrium_penetration(problem, equations, tables, size, force)
        read_solution(problem, equations, size, penetration)
        single = exchange >= EXCHANGES
        if exchange_strips(problem, penetration, single) == 0:
            return penetration, True
    return penetration, False


def list_loaded(problem: StripProblem):
    """List the loaded strips; their number."""
    size = 0
    for i in range(problem.count):
        if problem.strips[i].loaded:
            problem.loaded[size] = float(i)
            size += 1
    return size


def write_equations(problem: StripProblem, equations: Equations, size: int):
    """sum_j F_ij y_j = right-hand side, for the loaded strips: once the displacement for a penetration of 1,
    once the gap."""
    for rank in range(size):
        row = equations[rank]
        i = int(problem.loaded[rank])
        influences = problem.influences[i]
        for other in range(size):
            row[other] = influences[int(problem.loaded[other])]
        row[size] = problem.strips[i].share
        row[size + 1] = problem.strips[i].gap


def equilibrium_penetration(problem: StripProblem, equations: Equations, tables: Tables, size: int,
                            force: float):
    """Penetration [m] at which the solved strips carry ``force`` [N]: (pi^2/2) E* sum_j a_j y_j, as far
    as it counts."""
    unit_load = 0.0
    rest_load = 0.0
    for rank in range(size):
        row = equations[rank]
        strip = problem.strips[int(problem.loaded[rank])]
        half = strip.half_length * strip.counted
        unit_load += half * row[size]
        rest_load += half * row[size + 1]
    return (force / (0.5 * pi * pi * tables.contact_modulus) + rest_load) / unit_load


def read_solution(problem: StripProblem, equations: Equations, size: int, penetration: float):
    """y of every strip at the ``penetration`` [m]."""
    for i in range(problem.count):
        problem.strips[i].y = 0.0
    for rank in range(size):
        row = equations[rank]
        problem.strips[int(problem.loaded[rank])].y = penetration * row[size] - row[size + 1]


def exchange_strips(problem: StripProblem, penetration: float, single: bool):
    """Unload strips that pull and load strips that penetrate, where ``single`` only the last one of all; how
    many."""
    strips = problem.strips
    count = problem.count
    changed = 0
    for back in range(count):
        i = count - 1 - back
        strip = strips[i]
        if not single or changed == 0:
            if strip.loaded:
                if strip.y < 0.0:
                    strip.loaded = False
                    changed += 1
            else:
                pushed = (strip.share - TOUCH) * penetration - strip.gap
                row = problem.influences[i]
                for j in range(count):
                    if strips[j].y != 0.0:
                        pushed -= row[j] * strips[j].y
                if pushed > 0.0:
                    strip.loaded = True
                    changed += 1
    return changed
