"""Make tools/tables/data/rolling_kernels.json: ``python tools/make_rolling_kernels.py``.

The functions P, R, P_s, R_s of eq. (K4) in tools/tables/rolling_table.py with their slopes over
ln eta, by Gauss-Legendre quadrature over graded pieces, and with them the factors f of eq. (K3) in
kernel/creep/stiffness.py, which make the kernel's strips of an ellipse as stiff as Kalker's.  Witness in
tests: scipy's adaptive quadrature.

    --check    compare with the stored file, write nothing
"""

import argparse
import json
import os
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
os.environ["WRCONTACT_KERNEL"] = "python"  # the factors do not depend on what is compiled

from tools.tables import rolling_table  # noqa: E402
from tools.tables.strip_nodes import strip_coefficients  # noqa: E402
from wrcontact.creep import kalker_table  # noqa: E402
from wrcontact.kernel import layout  # noqa: E402
from wrcontact.kernel.prepare import tables as fixed  # noqa: E402

GAUSS = np.polynomial.legendre.leggauss(24)
DIGITS = 12


def pieces(first, last, finest):
    """Points and weights (n,) on first ... last, over pieces that triple in length from ``finest`` on."""
    edges = [first, *(first + finest * 3.0 ** np.arange(60)), last]
    edges = [edge for edge in edges if edge < last] + [last]
    low, high = np.array(edges[:-1])[:, None], np.array(edges[1:])[:, None]
    points, weights = GAUSS
    return ((0.5 * (high + low + (high - low) * points)).ravel(), (0.5 * (high - low) * weights).ravel())


def reach(eta):
    """P, R, P_s, R_s (4,) and their slopes over ln eta at one eta, eq. (K4).

    With t = u + w, t' = u - w the difference of the cosines is 2 sin u sin w; by symmetry 8 times the
    integral over 0 < w < u < pi/2 is that over the square.
    """
    total = np.zeros((4, 2))
    for u, weight in zip(*pieces(0.0, 0.5 * np.pi, min(0.3, np.sqrt(eta) / 10.0))):
        w, weights = pieces(0.0, u, eta / (6.0 * np.sin(u)))
        X = 2.0 * np.sin(u) * np.sin(w)
        r = np.hypot(X, eta)
        near = np.array([eta / r, eta * X**2 / r**3])
        far = np.array([eta**3 / r**3, 3.0 * eta**3 * X**2 / r**5])
        spin = (np.sin(u + w) * np.sin(u - w)) ** 2
        total += (
            8.0
            * weight
            * np.array([near @ weights, far @ weights, near @ (spin * weights), far @ (spin * weights)])
        )
    return total * np.array([[1.0 / (2.0 * np.pi**2)]] * 2 + [[2.0 / np.pi**2]] * 2)


def reaches():
    """The numbers ``reaches`` of the file (4, 2, n)."""
    return np.moveaxis([reach(eta) for eta in np.exp(rolling_table.reach_nodes())], 0, -1)


def factors(found):
    """The numbers ``factors`` of the file (3, 3, 2, n) for its ``reaches``."""
    rolling_table.stored = lambda: {"reaches": found}
    ones = np.zeros((3, 3, 2, layout.SHAPE_CELLS + 1))
    ones[:, :, 0] = 1.0
    table = rolling_table.assemble(ones, rolling_table.uncorrected())
    array = np.concatenate([[0.0, 0.0, float(len(table))], table])
    work = layout.Work.at(np.zeros(layout.WORK_SIZE))
    result = []
    for column, nu in enumerate(kalker_table.POISSON_NODES):
        tables = layout.Tables.at(np.zeros(layout.SETTING_COUNT + layout.ROLLING_TABLE_SIZE))
        tables.rolling, tables.shear_modulus = layout.SETTING_COUNT, 1.0
        tables.parameters.poisson_ratio = nu
        fixed.append_rolling(tables, layout.SETTING_COUNT, memoryview(array), nu)

        def factor(shape, column=column, tables=tables):
            strips = np.array([strip_coefficients(tables, work, np.exp(one)) for one in shape]).T
            return 1.0 / (kalker_table.inverse_coefficients(shape, column) * strips)

        result.append(rolling_table.with_slope(factor, rolling_table.shape_nodes(), layout.SHAPE_PER_UNIT))
    return np.array(result)


def rounded(values):
    """Nested lists of numbers with DIGITS digits."""
    if isinstance(values, list):
        return [rounded(value) for value in values]
    return float(f"{values:.{DIGITS}g}")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    found = np.array(rounded(reaches().tolist()))
    stored = rolling_table.stored() if options.check else None
    numbers = {"reaches": found, "factors": factors(found)}
    if options.check:
        for name, values in numbers.items():
            print(f"{name} differ by {np.abs(values - stored[name]).max():.1e} from the stored ones")
        return
    rows = [f' "{name}": {json.dumps(rounded(values.tolist()))}' for name, values in numbers.items()]
    rolling_table.DATA.write_text("{\n" + ",\n".join(rows).replace("]], ", "]],\n  ") + "\n}\n")
    print(rolling_table.DATA)


if __name__ == "__main__":
    sys.exit(main())
