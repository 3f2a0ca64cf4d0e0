"""Errors in profile files, fleets and stores: (name, old, new, meaning, the file that sees it, module) for
planted.py."""

PROFILES = "wrcontact/profiles"
STRANGERS, FOREIGN = (f"profiles/test_{name}.py" for name in ("strangers", "foreign_files"))

FILED = [
    (
        "first_point_back",
        "        )\n    return -BACK\n",
        "        )\n    return -BACK - found.y.min()\n",
        "the first point of a MiniProf wheel is taken for the back of its flange",
        FOREIGN,
        f"{PROFILES}/running_circle.py",
    ),
    (
        "back_anywhere",
        "return float(low) if near.max() - near.min() >= RISE else None",
        "return float(low)",
        "any first point is the back of a flange",
        FOREIGN,
        f"{PROFILES}/running_circle.py",
    ),
    (
        "one_branch",
        "gone[index[first]] = gone[index[run]] = True",
        "gone[index[run]] = False",
        "points that run back stay and cut the flange off",
        STRANGERS,
        f"{PROFILES}/repair.py",
    ),
    (
        "silent_cut",
        "        if abs(last - end) > CUT:",
        "        if abs(last - end) > 1e9:",
        "a flange that is lost behind a fold is not told",
        FOREIGN,
        f"{PROFILES}/repair.py",
    ),
    (
        "thickness_without_back",
        "        return math.nan\n    beyond",
        "        return end\n    beyond",
        "the thickness of a flange counts from the end of its points",
        FOREIGN,
        "wrcontact/wear/shape.py",
    ),
]
