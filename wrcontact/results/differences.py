"""Derivatives of outputs by differences, where a step has no differentiated one: on rails that change along the track."""

import math

import numpy as np

from ..interface.inputs import INPUTS
from ..kernel.layout import UNLOADED

#: Moves of an input [its unit]: small against a penetration, or as a share of the nominal value.
MOVES = {"m": 2e-6, "rad": 2e-6}
SHARE = 1e-3
#: Along the rail and around the wheel, and in yaw, whose levers are short.
SLOW_MOVES = {"track_position": 2e-5, "wheel_rotation": 2e-5, "yaw": 1e-5}
#: Differences over a move and over half of it are one derivative where they agree to this share of the larger one,
AGREEING = 0.05
#: and where what they bend over half a move is less than this share of that over the whole one,
JUMPING = 0.75
#: or where both are within this share of an output, over the move: the rounding of a step.
ROUNDING = 1e-9


def differences(step_many, inputs, centre, columns, places):
    """Derivatives (len(columns), len(places)) of outputs at ``places`` by the inputs of ``columns``, at ``inputs`` (k,), where they
    are ``centre`` (len(places),).

    ``step_many`` evaluates rows of inputs: their outputs (n, outputs) and status (n,). By Richardson's extrapolation of two central
    differences, over a move and half of it, within 1e-6 of a smooth output's derivative; NaN where both differ, as beside a jump
    of a derivative, or where one of the steps has status 2, 3 or 4.
    """
    shares = np.array([1.0, -1.0, 0.5, -0.5])
    moves = np.array([move_of(INPUTS[column]) for column in columns])
    rows = np.repeat(inputs[None], len(columns) * len(shares), axis=0)
    for k, column in enumerate(columns):
        rows[4 * k : 4 * k + 4, column] += moves[k] * shares
    outputs, status = step_many(rows)
    outputs = outputs[:, places].reshape(len(columns), 4, len(places))
    failed = (status.reshape(len(columns), 4) > UNLOADED).any(axis=1)
    whole = (outputs[:, 0] - outputs[:, 1]) / (2.0 * moves[:, None])
    half = (outputs[:, 2] - outputs[:, 3]) / moves[:, None]
    least = ROUNDING * np.abs(outputs).max(axis=1) / moves[:, None]
    largest = AGREEING * np.maximum(np.abs(whole), np.abs(half)) + least
    parted = np.abs(whole - half) > largest
    # a derivative that jumps here has another one to both sides, however short the move is
    bend = np.abs(outputs[:, 0] + outputs[:, 1] - 2.0 * centre) / moves[:, None]
    half_bend = np.abs(outputs[:, 2] + outputs[:, 3] - 2.0 * centre) / (0.5 * moves[:, None])
    parted |= (half_bend > JUMPING * bend + least) & (half_bend > largest)
    return np.where(parted | failed[:, None], math.nan, (4.0 * half - whole) / 3.0)


def move_of(row):
    """How far an input of this ``row`` is moved [its unit]."""
    return SLOW_MOVES.get(row.name, MOVES.get(row.unit, SHARE * row.nominal))
