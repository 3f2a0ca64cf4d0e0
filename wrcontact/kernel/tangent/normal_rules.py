"""Rules for the iterations of the room normal (wheelset_rules.py has the method): penetrations of
regions that share a load.
"""

from ..layout import State, Tables, Work
from ..normal.analyn import load_regions, region_load, solve_penetrations
from ..normal.elimination import eliminate
from ..normal.interaction import region_influence
from .intrinsics import held, rate_of, seeded


def penetrations_rule(work: Work, tables: Tables, state: State, count: int, force: float, penetration: float,
                      prescribed: bool):
    """``solve_penetrations`` as it is lowered: of each region local penetration = turn penetration - gap -
    sum of pushes, and of all the load is the force.

    Linear equations for the rates of the penetrations, from how loads follow the
    local ones and move at fixed ones.
    """
    regions = work.contact.regions
    nodes = work.contact.nodes
    given = penetration
    penetration, satisfied = solve_penetrations(tables, regions, nodes, state, count, force, penetration,
                                          prescribed)
    if not satisfied:
        return penetration, satisfied
    size = count + 1
    equations = work.contact.equations
    for i in range(count):
        region = regions[i]
        region.local_penetration = held(region.local_penetration)
    total = load_regions(regions, nodes, count)
    last = equations[count]
    for i in range(count):
        block = regions[i]
        row = equations[i]
        pushed = 0.0
        for j in range(count):
            share = 0.0
            if j != i:
                share = region_influence(tables, block, regions[j])
            pushed += share * regions[j].load
            row[j] = held(share)
        rest = block.alignment * held(penetration) - block.gap - pushed
        row[count] = -held(block.alignment)
        row[size] = rate_of(rest)
        row[size + 1] = 0.0
    for j in range(count):
        block = regions[j]
        load, stiffness = region_load(block, nodes[j], seeded(block.local_penetration, 1.0))
        per_level = rate_of(load) - rate_of(block.load)
        for i in range(count):
            equations[i][j] = held(equations[i][j]) * per_level
        equations[j][j] = held(equations[j][j]) + 1.0
        last[j] = 0.0
        if not prescribed:
            last[j] = held(block.share) * per_level
    last[count] = 0.0
    last[size] = rate_of(force - total)
    last[size + 1] = 0.0
    if prescribed:
        last[count] = 1.0
        last[size] = rate_of(given)
    eliminate(equations, size)
    for i in range(count):
        region = regions[i]
        region.local_penetration = seeded(region.local_penetration, equations[i][size])
    load_regions(regions, nodes, count)
    penetration = seeded(penetration, last[size])
    return penetration, satisfied
