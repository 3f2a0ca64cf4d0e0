"""The command line in a process of its own."""

import csv
import os
import subprocess
import sys

import numpy as np

#: A process sees the package that this one sees, and no display.
OUTSIDE = {
    **{k: v for k, v in os.environ.items() if k not in ("DISPLAY", "MPLBACKEND")},
    "PYTHONPATH": os.pathsep.join(sys.path),
    "MPLBACKEND": "Agg",
}


def start(*words, folder):
    """Run Python with these words in a process of its own."""
    settings = {
        "cwd": folder,
        "env": OUTSIDE,
        "capture_output": True,
        "text": True,
        "encoding": "utf-8",
        "timeout": 300,
    }
    return subprocess.run([sys.executable, *words], **settings)


def read_csv(path):
    """Columns by name; NaN for empty cells."""
    with open(path, newline="", encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array([[float(cell or "nan") for cell in row] for row in rows]).T))
