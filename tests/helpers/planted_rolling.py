"""Planted errors in how a wheelset rolls: towards standstill, and freely.  Rows (name, old, new, meaning, the
file that sees it, module) for planted.py.  The file alone sees it, in some seconds."""

STANDSTILL = "creep/test_standstill.py"

ROLLING_LAWS = [
    (
        "slow_patches",
        """        patch = side.patches[number]
        factor = open_rolling(tables, work.rolling, patch, friction)
        solve_creep_force(tables, work.rolling, patch)
        close_rolling(patch, factor)
""",
        """        patch = side.patches[number]
        if patch.speed > 1e-6:
            factor = open_rolling(tables, work.rolling, patch, friction)
            solve_creep_force(tables, work.rolling, patch)
            close_rolling(patch, factor)
""",
        "patches that roll slowly keep the creep forces of an earlier step",
        STANDSTILL,
    ),
    (
        "soft_rest",
        "\nREST: Final[float] = 1e-12",
        "\nREST: Final[float] = 1e-6",
        "creep forces fade already at some micrometres a second",
        STANDSTILL,
    ),
    (
        "rest_across",
        "    if is_rolling(tables, inputs) or inputs.lateral_velocity != 0.0 or inputs.yaw_rate != 0.0:",
        "    if is_rolling(tables, inputs):",
        "a wheelset that slides without rolling has no friction",
        STANDSTILL,
    ),
]
