"""Errors in wear and fatigue: (name, old, new, meaning, the file that sees it, module) for planted.py."""

WEAR = "wrcontact/wear"
LAWS, ADDING, MOVING, RUNNING, TIRED = (
    f"wear/test_{name}.py" for name in ("laws", "accumulate", "update", "run", "fatigue")
)

WORN = [
    (
        "worn_plateau",
        "self.steep * (x - self.second) + self.plateau",
        "self.steep * (x - self.second)",
        "the printed erratum of the Sheffield law",
        LAWS,
        f"{WEAR}/laws.py",
    ),
    (
        "worn_friction",
        "k * power_density / (friction * self.hardness)",
        "k * power_density / self.hardness",
        "Archard's law takes friction force for load",
        LAWS,
        f"{WEAR}/laws.py",
    ),
    (
        "worn_slip",
        "0.5 * (1.0 - x) * pressure) / (0.5",
        "0.4 * (1.0 - x) * pressure) / (0.5",
        "the part of a strip that sticks carries less",
        LAWS,
        f"{WEAR}/cells.py",
    ),
    (
        "worn_rest",
        "share = np.where(k == last[there], left[there]",
        "share = np.where(k == last[there], 0.0",
        "the last bin of a stretch gets nothing",
        ADDING,
        f"{WEAR}/bins.py",
    ),
    (
        "worn_lean",
        "math.cos(angle) * self.y + math.sin(angle)",
        "math.cos(angle) * self.y - math.sin(angle)",
        "a rail leans to the other side",
        ADDING,
        f"{WEAR}/bins.py",
    ),
    (
        "worn_time",
        'np.abs(rows["speed"]) * _shares(',
        "20.0 * _shares(",
        "time and not distance weights the rows of a file",
        ADDING,
        f"{WEAR}/rows.py",
    ),
    (
        "worn_nodes",
        "(ends[:, -1:] - (on_rail[:, -1:] - on_rail[:, :1])) / 2",
        "0.0 * ends[:, -1:]",
        "strips begin at their nodes",
        ADDING,
        f"{WEAR}/cells.py",
    ),
    (
        "worn_normal",
        "(y + into * slope) / MM",
        "y / MM",
        "the depth is taken off vertically",
        MOVING,
        f"{WEAR}/update.py",
    ),
    (
        "worn_mirror",
        'mode="reflect"',
        'mode="constant"',
        "smoothing loses depth at the ends",
        MOVING,
        f"{WEAR}/update.py",
    ),
    (
        "worn_half",
        "worn_profile(arcs[side], 0.5 * depth",
        "worn_profile(arcs[side], 0.0 * depth",
        "the midpoint rule simulates the beginning twice",
        RUNNING,
        f"{WEAR}/run.py",
    ),
    (
        "tired_area",
        "1.5 * load / area",
        "1.0 * load / area",
        "the mean pressure for the peak",
        TIRED,
        f"{WEAR}/fatigue.py",
    ),
    (
        "tired_ratio",
        "ratio = 1.5 * patch",
        "ratio = 1.0 * patch",
        "the mean pressure for the peak, in a step",
        "wheelset/test_fatigue_outputs.py",
        "wrcontact/kernel/wheelset/fatigue.py",
    ),
    (
        "tired_shear",
        "(w - root).imag + z * slope.real",
        "(w - root).imag - z * slope.real",
        "a sign in the stress below a traction",
        TIRED,
        f"{WEAR}/fatigue.py",
    ),
]
