"""Errors in profile files, fleets and stores: (name, old, new, meaning, the file that sees it, module) for
planted.py."""

PROFILES = "wrcontact/profiles"
STRANGERS, FOREIGN, HEADS = (
    f"profiles/test_{name}.py" for name in ("strangers", "foreign_files", "orientation")
)
FLEET = "fleet/test_fleet.py"

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
    (
        "leaning_anyhow",
        "abs(head.inclination - track) > LEANING",
        "abs(head.inclination - track) > 1.0",
        "a head is turned upright from the track's inclination, whatever its own is",
        HEADS,
        f"{PROFILES}/orientation.py",
    ),
    (
        "leaning_twice",
        "        given = track\n",
        "        given = 0.0\n",
        "a rail that leans as its track is inclined twice",
        HEADS,
        f"{PROFILES}/orientation.py",
    ),
    (
        "left_lean",
        'f"left_{kind}", left_track)',
        'f"left_{kind}", track)',
        "the left rail is turned upright from the right track's inclination",
        HEADS,
        f"{PROFILES}/catalogue.py",
    ),
    (
        "grave_last",
        'yield Grave(f"{_named_profile(profile, side)}: {remark}")',
        'yield f"{_named_profile(profile, side)}: {remark}"',
        "what makes all results wrong is said after all tables",
        HEADS,
        "wrcontact/conditioning/remarks.py",
    ),
    (
        "turned_by_base",
        "ends < min(middle, 0.5 * (low + high))",
        "ends < middle + 1e-9",
        "a head on a wide base is turned over",
        FOREIGN,
        f"{PROFILES}/repair.py",
    ),
    (
        "gap_anywhere",
        "NEEDED, FIELD = 16.0, 45.0",
        "NEEDED, FIELD = 6.0, 45.0",
        "a gap above the place of the gauge cuts the gauge face off",
        FOREIGN,
        f"{PROFILES}/repair.py",
    ),
    (
        "header_points",
        "        if before < MANY:",
        "        if before < 0:",
        "numbers in a header are points",
        FOREIGN,
        f"{PROFILES}/readers.py",
    ),
    (
        "silent_lines",
        "number for number, _ in lines if points",
        "number for number, _ in rows if points",
        "lines with an empty field are dropped without a word",
        FOREIGN,
        f"{PROFILES}/formats.py",
    ),
    (
        "part_of_a_rail",
        "    _refuse_gauge_face(y, z)\n    if",
        "    if",
        "a part of a rail is read as a wheel",
        FOREIGN,
        f"{PROFILES}/running_circle.py",
    ),
    (
        "fleet_track",
        "return find_profile(source, kind, smoothing, track=track)",
        "return find_profile(source, kind, smoothing, track=1 / 40)",
        "rails of a fleet are turned upright from 1:40, whatever the track's inclination is",
        FLEET,
        "wrcontact/fleet/files.py",
    ),
    (
        "range_in_metres",
        "low, high = file.y_range_mm",
        "low, high = file.y_range",
        "one of two heads is cut out in metres of a file in millimetres",
        STRANGERS,
        f"{PROFILES}/repair.py",
    ),
]
