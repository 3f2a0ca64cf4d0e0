"""Files of the slices of a crossing's nose, for the tests."""

import numpy as np

from tests.helpers.sections import nose_points

MM = 1e-3
POSITIONS = np.linspace(-0.1, 0.1, 5)


def simpack(points):
    rows = "\n".join(f"{y:.9f} {z:.9f}" for y, z in points / MM)
    return (
        "header.begin\n  version = 1\n  type = 0\nheader.end\nspline.begin\n  units.len.f = 1000.\n  point.begin\n"
        f"{rows}\n  point.end\nspline.end\n"
    )


def columns(points, unit=MM):
    return "".join(f"{y:.12e} {z:.12e}\n" for y, z in points / unit)


def section(k):
    return nose_points() + [0.0, -0.1 * POSITIONS[k]]


def write_slices(folder, head="0.01 1.0", features=None, ending="prr", unit=MM, middle="1"):
    for k in range(5):
        text = simpack(section(k)) if ending == "prr" else columns(section(k), unit)
        (folder / f"nose_{k}.{ending}").write_text(text)
    rows = [f"{1e3 * u - 0.01:.6f} 'nose_{k}.{ending}'  % slice" for k, u in enumerate(POSITIONS)]
    lines = [
        "% artificial nose",
        f"{head}  U_OFFSET",
        "  5  NSLC",
        f"{len(features[0]) if features else 0} 0 0",
        middle,
    ]
    lines += ["", *rows]
    if features:
        lines += [f"{1e3 * u - 0.01:.6f} " + " ".join(map(str, row)) for u, row in zip(POSITIONS, features)]
    path = folder / "nose.slcs"
    path.write_text("\n".join(lines) + "\n")
    return path
