"""Errors and costs of the models of creep forces on single patches: ``python -m benchmarks.tangential``.

Errors are those of the force against the complete theory in % of mu N, mean / 95 % / largest, on the cases of
tests/reference/creep; costs are those of one patch, cutting it into strips included, in the unit of
machine.py.
"""

import sys

from tests.helpers import creep_cases
from wrcontact.creep import forces
from wrcontact.kernel.binding.library import default_kernel, span

from . import machine

#: (name in the table, model, with spin as published).
MODELS = (("coupled strips", "strips", False), ("FASTSIM", "fastsim", False),
          ("FASTSIM as published", "fastsim", True), ("FaStrip", "fastrip", False),
          ("FaStrip as published", "fastrip", True), ("Polach", "polach", False))
CALLS, ROUNDS = 2000, 7


def error_rows():
    """A row for each model: its name and a text for each set of cases."""
    for words, name, published in MODELS:
        model = creep_cases.Model(name, published)
        yield [words, *("{:.2f} / {:.1f} / {:.1f}".format(*creep_cases.summary(
            creep_cases.errors(model, cases)[:, 0])) for cases in creep_cases.SETS)]


def patch_cost(name, published, case):
    """:class:`~benchmarks.machine.Cost` of a patch, cut into strips and solved."""
    model = creep_cases.Model(name, published)
    model.forces(case)
    patch, kernel = case.parts[0], default_kernel()
    tables = span(forces.model_tables(model.number, patch.youngs_modulus, patch.poisson_ratio))
    workspace = span(model.workspace)
    cut, solve = kernel.library.wrcontact_cut_patch, kernel.library.wrcontact_solve_tangential

    def work():
        for _ in range(CALLS):
            cut(workspace, 0)
            solve(tables, workspace)

    return machine.cost(work, CALLS, ROUNDS)


def cost_rows():
    """A row for each model: its name and the units of a patch, the mean over some cases."""
    some = creep_cases.cases("patches")[::23] + creep_cases.cases("ellipses")[::60]
    for words, name, published in MODELS:
        found = [patch_cost(name, published, case).units for case in some]
        yield [words, f"{sum(found) / len(found):.2f}", f"{max(found):.2f}"]


def table(heads, rows):
    """Rows of texts as a table in Markdown."""
    lines = [heads, ["---"] + ["---:"] * (len(heads) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def main():
    counts = [f"{name} ({len(creep_cases.cases(name))})" for name in creep_cases.SETS]
    print(table(["% of μN", *counts], error_rows()), end="\n\n")
    if default_kernel().compiled:
        print(table([f"units of {machine.UNIT}", "mean", "largest"], cost_rows()))


if __name__ == "__main__":
    sys.exit(main())
