"""A long run in the limit cycle between the flanges: statuses, and the time it takes.

python -m examples.hunting_wheelset.long_run [FOLDER [STEPS]]
"""

import sys

import numpy as np

from .coupling import CONTACT, Loop, build
from .hunting import LARGE, SOFT

SPEED, STEP, STEPS = 36.0, 1e-4, 1_000_000  # [m/s], [s]


def hunt(archives, steps=STEPS, contact=None):
    """A :class:`Run` of so many steps from a large swing, every 100th of them recorded.

    Its ``worst_status`` is of all steps."""
    given = SOFT | {"frame_speed": SPEED, "start_lateral_shift": LARGE}
    with Loop(archives, given, contact) as loop:
        return loop.run(steps * STEP, STEP, every=100)


def report(run, steps):
    """A sentence with the amplitude at the end, the largest status and the real-time factor."""
    amplitude = np.ptp(run["lateral_shift"][-len(run.time) // 5 :]) / 2
    return (
        f"{steps} steps of {STEP * 1e3:g} ms, {steps * STEP:g} s at {SPEED:g} m/s, tangential_model "
        f"{CONTACT['tangential_model']}: amplitude {amplitude * 1e3:.3f} mm, largest status "
        f"{run.worst_status}. It took {run.seconds:.1f} s, a real-time factor of "
        f"{run.seconds / (steps * STEP):.2f}; the processor worked for {run.processor:.1f} s of them, "
        f"{run.processor / steps * 1e6:.0f} us a step"
    )


if __name__ == "__main__":
    folder, steps = (*sys.argv[1:], *["out", str(STEPS)][len(sys.argv) - 1 :])
    print(report(hunt(build(folder), int(steps)), int(steps)))
