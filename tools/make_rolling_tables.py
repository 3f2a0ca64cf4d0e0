"""Make the stored exact creep forces of ellipses: ``python tools/make_rolling_tables.py``.

Kalker's steady rolling problem at the nodes of the correction table, 5490 solutions for each Poisson's
ratio, some ten minutes each.  Writes rolling_nu025.npz ... into tools/tables/data.  Finished lines of
nodes are kept in rolling_nu025.parts ... until their table is complete, so the program may be interrupted.

    --poisson NU ...    Poisson's ratios; 0.28 0.25 0.30 if left out
    --workers N         processes; 1
    --nodes N           solve about N nodes spread over the table and print how far they are from the stored
                        ones; write nothing
    --folder DIR        write there
"""

import argparse
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):  # small matrices: threads only disturb
    os.environ.setdefault(variable, "1")

import numpy as np  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from tools.tables import exact_nodes as nodes  # noqa: E402
from tools.tables.strip_nodes import EXACT  # noqa: E402

POISSON_RATIOS = (0.28, 0.25, 0.30)


def file_name(poisson_ratio):
    return f"rolling_nu{100 * poisson_ratio:03.0f}.npz"


def read_parts(path):
    """Lines of nodes solved before; a last row that was cut off is left out."""
    found, size = {}, len(nodes.RHO) * len(nodes.COLUMNS)
    for row in path.read_text().splitlines() if path.exists() else ():
        numbers = row.split()
        if len(numbers) == 3 + size + 1 and numbers[-1] == "end":
            line = tuple(int(each) for each in numbers[:3])
            found[line] = np.array(numbers[3:-1], dtype=float).reshape(len(nodes.RHO), -1)
    return found


def make_table(poisson_ratio, workers, folder):
    """Solve what is missing and write the table; returns its path."""
    path = folder / file_name(poisson_ratio)
    parts = path.with_suffix(".parts")
    folder.mkdir(parents=True, exist_ok=True)
    found = read_parts(parts)
    missing = [line for line in nodes.lines() if line not in found]
    solve = partial(nodes.solve_line, poisson_ratio=poisson_ratio)
    with parts.open("a") as file, ProcessPoolExecutor(workers) as pool:
        file.write("\n")
        for line, values in zip(missing, pool.map(solve, missing) if workers > 1 else map(solve, missing)):
            found[line] = values
            file.write(" ".join([*map(str, line), *(f"{each:.7g}" for each in values.ravel()), "end\n"]))
            file.flush()
    coefficients = [nodes.creep_coefficients(ratio, 1.0, poisson_ratio) for ratio in nodes.RATIO]
    np.savez_compressed(
        path,
        forces=nodes.filled(found).astype(np.float32),
        columns=np.array(nodes.COLUMNS),
        ratio=nodes.RATIO,
        beta=nodes.BETA,
        alpha=nodes.ALPHA,
        rho=nodes.RHO,
        poisson_ratio=poisson_ratio,
        creep_coefficients=np.array(coefficients),
    )
    parts.unlink()
    return path


def compare(poisson_ratio, count, folder):
    """Solve lines of nodes spread over the table; prints their largest difference from the stored ones."""
    with np.load(folder / file_name(poisson_ratio)) as stored:
        forces = stored["forces"]
    lines = nodes.lines()
    wanted = -(-count // len(nodes.RHO))
    for line in lines[len(lines) // (2 * wanted) :: len(lines) // wanted][:wanted]:
        apart = np.abs(nodes.solve_line(line, poisson_ratio) - forces[line]).max(axis=0)
        print(
            f"nu {poisson_ratio}, line {line}: "
            + ", ".join(f"{name} {each:.1e}" for name, each in zip(nodes.COLUMNS, apart)),
            flush=True,
        )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--poisson", type=float, nargs="+", default=POISSON_RATIOS)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--nodes", type=int)
    parser.add_argument("--folder", type=Path, default=EXACT)
    options = parser.parse_args()
    for poisson_ratio in options.poisson:
        if options.nodes:
            compare(poisson_ratio, options.nodes, options.folder)
        else:
            print(make_table(poisson_ratio, options.workers, options.folder), flush=True)


if __name__ == "__main__":
    sys.exit(main())
