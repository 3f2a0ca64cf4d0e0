"""Errors in rails whose section changes: (name, old, new, meaning, the file that sees it, module) for planted.py."""

SEARCH, SURFACE = "sections/test_search.py", "sections/test_surface.py"

SECTIONED = [
    (
        "section_twist_sign",
        "slope_u - b0 * place_u + (by_v_u + by_vv * v_u) * v_y + by_v * v_uy,",
        "slope_u + b0 * place_u + (by_v_u + by_vv * v_u) * v_y + by_v * v_uy,",
        "the mixed derivative of a moving section has the wrong sign of its place",
        "sections/test_bounds.py",
        "section_surface",
    ),
    (
        "section_lean_sign",
        "-z_u / np.sqrt(1.0 + z_u**2 + z_y**2)], axis=-1)",
        "z_u / np.sqrt(1.0 + z_u**2 + z_y**2)], axis=-1)",
        "angles are sought behind a wheel on a rising rail",
        SEARCH,
        "wrcontact/sections/kernel_table.py",
    ),
    (
        "section_rolled_lever",
        "lever = max((place.arm + low) * place.sin_roll, (place.arm + high) * place.sin_roll)",
        "lever = 0.0 * max((place.arm + low) * place.sin_roll, (place.arm + high) * place.sin_roll)",
        "a rolled wheel is taken for too high to touch",
        SEARCH,
        "section_spread",
    ),
    (
        "section_run_out",
        "middle = -slope / half - 0.5 * bend",
        "middle = slope / half - 0.5 * bend",
        "the surface runs out steeper beyond the last slice",
        SURFACE,
        "wrcontact/sections/along.py",
    ),
    (
        "section_offset_scale",
        "positions = scale * (offset + np.array([row[0] for row in rows])) * MM",
        "positions = (offset + scale * np.array([row[0] for row in rows])) * MM",
        "the offset of a slice file is not scaled",
        "sections/test_files.py",
        "wrcontact/sections/files.py",
    ),
]
