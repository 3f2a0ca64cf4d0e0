"""Errors in what an engineer is asked for: (name, old, new, meaning, the file that sees it, module) for planted.py."""

LINEAR, CLIMBING = "linear/test_linear.py", "results/test_climbing.py"
TRACK = "track/test_track.py"

ASKED = [
    (
        "linear_gyroscope",
        "ROTATION[2, 3], ROTATION[3, 2] = 1.0, -1.0",
        "ROTATION[2, 3], ROTATION[3, 2] = -1.0, 1.0",
        "the axle's angular momentum points to the other side",
        LINEAR,
        "wrcontact/linear/point.py",
    ),
    (
        "linear_left_projection",
        "left[:, b] = -np.linalg.solve(inner.T, stiffness[np.ix_(a, b)].T).T",
        "left[:, b] = -np.linalg.solve(inner, stiffness[np.ix_(b, a)]).T",
        "creep forces are condensed as conservative ones",
        LINEAR,
        "wrcontact/linear/record.py",
    ),
    (
        "linear_phase",
        "weights = (with_cosine, with_sine) if fast else (with_sine, with_cosine)",
        "weights = (with_sine, with_cosine) if fast else (with_cosine, with_sine)",
        "the derivatives of a swing have the weights of the other phase",
        LINEAR,
        "wrcontact/linear/point.py",
    ),
    (
        "linear_load_transfer",
        'arm = 0.5 * system.parameters["running_circle_distance"]',
        'arm = -0.5 * system.parameters["running_circle_distance"]',
        "the load moves to the other wheel",
        LINEAR,
        "wrcontact/linear/point.py",
    ),
    (
        "climb_other_friction",
        'limits["right"] + frictions["left"], limits["left"] + frictions["right"]',
        'limits["right"] + frictions["right"], limits["left"] + frictions["left"]',
        "Weinstock's limit has the friction of the flange twice",
        CLIMBING,
        "wrcontact/results/climbing.py",
    ),
    (
        "climb_lift_side",
        'arm = (0.5 if side == "right" else -0.5)',
        'arm = (-0.5 if side == "right" else 0.5)',
        "the wheel that does not climb is lifted",
        CLIMBING,
        "wrcontact/results/climbing.py",
    ),
    (
        "climb_sum_of_y",
        'low_pass(y["right"] - y["left"], step)',
        'low_pass(y["right"] + y["left"], step)',
        "forces of both wheels outwards shift the track",
        CLIMBING,
        "wrcontact/results/climbing.py",
    ),
    (
        "track_amplitude",
        "np.sqrt(2.0 * getattr(kind, quantity)(waves[inside])",
        "np.sqrt(4.0 * getattr(kind, quantity)(waves[inside])",
        "a one-sided spectrum is taken for a two-sided one",
        TRACK,
        "wrcontact/track/irregularities.py",
    ),
    (
        "track_gauge",
        "self.lateral - 0.5 * self.gauge,\n            self.lateral + 0.5 * self.gauge,",
        "self.lateral + 0.5 * self.gauge,\n            self.lateral - 0.5 * self.gauge,",
        "a wider gauge moves the rails inwards",
        TRACK,
        "wrcontact/track/irregularities.py",
    ),
    (
        "track_waves_per_metre",
        "f ** np.array(powers)[piece] / (2.0 * np.pi)",
        "f ** np.array(powers)[piece]",
        "a density over waves per metre is taken for one over the wave number",
        TRACK,
        "wrcontact/track/spectra.py",
    ),
]
