"""The lateral shifts of ``wrcontact sweep``."""

import numpy as np

from .door import Refused

MOST_ROWS, MOST_PRINTED = 1_000_000, 10_000
WIDEST = 1000.0  # lateral shift [mm]
START, STOP, STEP = -8.0, 8.0, 0.5  # [mm]


def shifts_of(start, stop, step, to_file):
    """Lateral shifts [m] from ``start`` to ``stop`` [mm], both included where ``step`` [mm] fits, and the
    step; None are the usual ones.  A file may have more of them than are printed."""
    start, stop, step = (
        usual if given is None else given for given, usual in zip((start, stop, step), (START, STOP, STEP))
    )
    if not (-WIDEST <= start <= stop <= WIDEST and 0 < step < np.inf):
        raise Refused(
            f"--from-mm {start:g}, --to-mm {stop:g}, --step-mm {step:g} do not define a sweep; "
            f"permitted are --step-mm > 0 and {-WIDEST:g} <= --from-mm <= --to-mm <= {WIDEST:g}"
        )
    count = np.floor((stop - start) / step + 1e-9) + 1 if step > 1e-300 else np.inf
    most = MOST_ROWS if to_file else MOST_PRINTED
    if count > most:
        files = "" if to_file else f", with --output FILE at most {MOST_ROWS}"
        raise Refused(f"--step-mm {step:g} gives {count:.10g} rows; permitted are at most {most}{files}")
    return np.round(start + step * np.arange(int(count)), 9) / 1e3, step
