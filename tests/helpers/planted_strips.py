"""Errors in laws of the strips: (name, old, new, meaning, the file that sees it, module) for planted.py."""

NORMAL = "wrcontact/kernel/normal"
LENGTHS, PATCHES, PRESSURES, RUNS, SURFACES = (
    f"{NORMAL}/strip_{name}.py" for name in ("lengths", "patches", "pressures", "runs", "surfaces"))
HERTZ, WAVES, PARTS = (
    "normal/test_strip_hertz.py", "prepare/test_waves.py",
    "normal/test_strip_parts.py")

STRIP_LAWS = [
    ("strip_near", "facing[j] = cosine * other.width", "facing[j] = 0.5 * cosine * other.width",
     "a strip presses those after it down by half as much", HERTZ, PRESSURES),
    ("strip_logarithm", "row[first + j] -= singular[j] *", "row[first + j] -= 0.9 * singular[j] *",
     "the logarithm's correction is a tenth too small", HERTZ, PRESSURES),
    ("strip_spacing", "rest = constant + spacing_at(", "rest = constant + 0.0 * spacing_at(",
     "strips that lie apart displace like a smooth pressure", HERTZ, PRESSURES),
    ("strip_beside", "* influence - TESTED_HEIGHT * left", "* influence + TESTED_HEIGHT * left",
     "the logarithm's correction has the other sign near the ends of strips", HERTZ, PRESSURES),
    ("strip_edges", "start_move = edge_move(", "start_move = 0.0 * edge_move(",
     "the first edge of a run does not move", HERTZ, LENGTHS),
    ("strip_swing", "known / (known + fabs(move))", "known / (known + 0.1 * fabs(move))",
     "edges that swing are hardly held", HERTZ, LENGTHS),
    ("strip_power", "POWER: Final[float] = 0.45", "POWER: Final[float] = 0.15",
     "half-lengths follow the displacements at their ends a third as fast", HERTZ, LENGTHS),
    ("strip_move", "move = -MOVED * (front", "move = MOVED * (front",
     "the middles of a yawed wheel's strips move the wrong way", HERTZ, LENGTHS),
    ("strip_end_axis", "axis = 1.5 * inner.next_axis - 0.5 * second.next_axis", "axis = inner.next_axis",
     "the outermost strip has the axis of the next one", HERTZ, LENGTHS),
    ("strip_share", "strip.share = between(low.share, high.share, u)", "strip.share = 1.0",
     "all of the penetration comes along the normal of every strip", HERTZ, RUNS),
    ("strip_peak", "pressure -= rigid * roughness(", "pressure -= 0.0 * rigid * roughness(",
     "pressures do not know the fine part of the gap", HERTZ, PATCHES),
    ("strip_area", "strip.next_half * waves.sin[i] * strip.stretch", "strip.next_half * waves.sin[i]",
     "areas are measured on the rail and not on the curve between wheel and rail", HERTZ, PATCHES),
    ("strip_smooth", "for m in range(1, count):\n                smooth +=",
     "for m in range(1, count - 1):\n                smooth +=", "the last cosine is no part of the gap",
     WAVES, "wrcontact/kernel/prepare/waves.py"),
    ("strip_levels", "at.level = zone.depth - beta *", "at.level = zone.depth - 0.9 * beta *",
     "the first strips are longer and wider than ANALYN's", HERTZ, SURFACES),
    ("strip_raised", "at.level += rise", "at.level += 0.5 * rise", "levels are raised by half", PARTS, RUNS),
    ("strip_pull", "PULLING: Final[float] = 1e-3", "PULLING: Final[float] = 1e3", "no run that pulls is cut",
     PARTS, RUNS),
    ("strip_cut", "/ (max(inner, 0.0) - outer)", "/ (max(inner, 0.0) + outer)",
     "a run is cut in the wrong place", PARTS, RUNS),
    ("strip_join", "before.low == low and before.next_stop >= start",
     "before.low == low and before.next_stop <= start", "runs that overlap are not joined", PARTS, RUNS),
]
