"""Planted errors in how a wheelset rolls: towards standstill, and freely.  Rows (name, old, new, meaning, the
file that sees it, module) for planted.py.  The file alone sees it, in some seconds."""

STANDSTILL = "creep/test_standstill.py"
FREE = "creep/test_free_rolling.py"

ROLLING_LAWS = [
    (
        "slow_patches",
        """        factor = open_rolling(tables, work.rolling, patch, friction)
        solve_creep_force(tables, work.rolling, patch)
        close_rolling(patch, factor)
""",
        """        if patch.speed > 1e-6:
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
    (
        "unbalanced_wheels",
        "\nBALANCED: Final[float] = 1e-9",
        "\nBALANCED: Final[float] = 1e-5",
        "wheels roll freely with a torque of some N m",
        FREE,
    ),
    (
        "nominal_wheels",
        "    return given == 0.0 and inputs.free_rolling != 0.0 and tables.parameters.nominal_rolling == 0.0",
        "    return given == 0.0 and inputs.free_rolling != 0.0 and tables.parameters.nominal_rolling == 1.0",
        "free rolling is that of the nominal radius, and the other way round",
        FREE,
    ),
    (
        "torque_sign",
        "    left = torque + turning.wanted",
        "    left = torque - turning.wanted",
        "a motor brakes",
        FREE,
    ),
    (
        "kept_shift",
        "        renew_shift(rolling, patch)",
        "        rolling.shift = creepage_shift(rolling)",
        "while a rotation is sought, strips keep the shift of creepages of the first one that was tried",
        FREE,
    ),
    (
        "held_rate",
        "seeded(rate, -missing / slope))",
        "seeded(rate, 0.0))",
        "derivatives hold the rotation of wheels that roll freely",
        FREE,
        "wrcontact/kernel/derivative/turning_rules.py",
    ),
    (
        "lonely_side",
        "        needed = is_free(tables, inputs, index) and not are_independent(tables)",
        "        needed = False and not are_independent(tables)",
        "one side of a wheelset is asked for, and turns as if there was no other",
        FREE,
    ),
    (
        "wide_adhesion",
        "    return turning.wanted != 0.0 and (spins or slides)",
        "    return turning.wanted > 1e9 and (spins or slides)",
        "more torque than the wheels carry has no status of its own",
        FREE,
    ),
]
