"""What is said about a profile that was put right: one warning a file, one line on a command line."""

import sys
import warnings
from contextlib import contextmanager


class ProfileWarning(UserWarning):
    """A profile file was put right before it was used; the sentence says what was done, where and by how much."""


class Refusal(ValueError):
    """Why a file is no profile, without its name: "has 5 points; permitted are 10 or more"."""


def remark(kind, name, remarks):
    """Warn of all ``remarks`` on one profile at once; nothing where there are none."""
    if remarks:
        warnings.warn(f"{kind} profile {name}: {'; '.join(remarks)}", ProfileWarning, stacklevel=4)


@contextmanager
def remarks_in_lines(prefix):
    """Inside, every different ProfileWarning is one line on the error stream that starts with ``prefix``."""
    with warnings.catch_warnings():
        show, said = warnings.showwarning, set()

        def say(message, category, *where, **more):
            if not issubclass(category, ProfileWarning):
                show(message, category, *where, **more)
            elif str(message) not in said:
                said.add(str(message))
                print(f"{prefix}: {' '.join(str(message).split())}", file=sys.stderr)

        warnings.simplefilter("always", ProfileWarning)
        warnings.showwarning = say
        yield


def stretch(y):
    """"y = -3.2 mm" or "y = -3.2 ... 4.1 mm", of abscissae ``y`` (n,)."""
    low, high = min(y), max(y)
    return f"y = {low:.4g} mm" if high - low < 1e-3 else f"y = {low:.4g} ... {high:.4g} mm"


def counted(count, word):
    """"1 point", "3 points"."""
    return f"{count} {word}" if count == 1 else f"{count} {word}s"
