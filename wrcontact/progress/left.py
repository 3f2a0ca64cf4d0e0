"""The time that a work still needs, as it is shown: it never grows."""

import math


class TimeLeft:
    """The time left of one work, from the share that is done when a step ends.

    Between steps it falls with the time, to zero at least; where a work gets slower it stays as it was shown.
    """

    def __init__(self):
        self._share, self._at, self._shown = 0.0, 0.0, math.inf

    def after(self, share, elapsed):
        """The time left [s], None before the first step, where ``share`` of the work is done ``elapsed`` [s]
        after its begin."""
        if share > self._share:
            self._share, self._at = share, elapsed
        if not self._share:
            return None
        whole = self._at / min(self._share, 1.0)
        self._shown = min(self._shown, max(whole - elapsed, 0.0))
        return self._shown
