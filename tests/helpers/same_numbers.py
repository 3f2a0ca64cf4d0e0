"""Whether two measurements of the same thing have the same numbers."""

import math

#: Kept numbers have four digits.  On another platform the last bits differ, which amounts to 1e-10 at poses
#: beside jumps, and numerics of libraries (splines, half-space) to some 1e-4; what a table shows changes from
#: about a per cent on.
RELATIVE = 5e-3
#: Below what tables show [% or the unit of a column].
ABSOLUTE = 2e-3


#: Trials of a single pose beside a jump: rounding, which differs between processors, moves the jump, and the
#: search for it takes one trial more or less (measured: 1 of 66, 1 of 73).  Means over poses do not move.
SINGLE_POSES = {"99 %": 0.05, "most": 0.05}


def differences(found, kept, absolute=ABSOLUTE, where="", relative=RELATIVE, wider=None):
    """Sentences on what differs between two nested dicts and lists of numbers and words.  ``wider`` gives the
    permitted relative difference of numbers by the name of their column; all others have ``relative``."""
    if isinstance(kept, dict):
        if not isinstance(found, dict) or list(found) != list(kept):
            return [f"{where}: other names"]
        return [
            each
            for name in kept
            for each in differences(
                found[name],
                kept[name],
                absolute,
                f"{where} {name}".strip(),
                (wider or {}).get(name, relative),
                wider,
            )
        ]
    if isinstance(kept, list | tuple):
        if len(found) != len(kept):
            return [f"{where}: {len(found)} values instead of {len(kept)}"]
        return [
            each
            for k, (one, other) in enumerate(zip(found, kept))
            for each in differences(one, other, absolute, f"{where}[{k}]", relative, wider)
        ]
    if isinstance(kept, str):
        return [] if found == kept else [f"{where}: {found!r} instead of {kept!r}"]
    same = math.isclose(found, kept, rel_tol=relative, abs_tol=absolute) or (
        math.isnan(found) and math.isnan(kept)
    )
    return [] if same else [f"{where}: {found} instead of {kept}"]
