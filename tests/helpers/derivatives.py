"""Directional derivatives of a stepper's outputs, and central differences that they are held against."""

import re

import numpy as np

import wrcontact
from tests.helpers.inside import solver_of
from wrcontact.interface.variables import FIRST_OUTPUT, FIRST_WEAR, INTEGER, VARIABLES
from wrcontact.kernel import layout
from wrcontact.kernel.layout import (
    IN_LATERAL_SHIFT,
    IN_LOAD_TRANSFER,
    IN_NORMAL_FORCE,
    IN_ROLL,
    IN_VERTICAL_SHIFT,
    IN_YAW,
    INPUT_COUNT,
    OUTPUT_COUNT,
)

OUTPUTS = VARIABLES[FIRST_OUTPUT:FIRST_WEAR]
NAMES = [variable.name for variable in OUTPUTS]
CONTINUOUS = np.array([variable.type != INTEGER for variable in OUTPUTS])
NOMINAL = np.array([variable.nominal or 1.0 for variable in OUTPUTS])
USUAL = np.array([variable.nominal or 1.0 for variable in VARIABLES[:INPUT_COUNT]])
FAMILY = np.unique([re.sub(r"\[\d+\]", "", name) for name in NAMES], return_inverse=True)[1]

AGREE = 1e-6  # [of the derivative's scale] to differences
CLEAR = 3e-7  # [likewise] differences that agree with each other to this are held against derivatives
KINK = 1e-4  # [likewise] by which differences across a kink are off that their steps do not notice
# steps of differences, each twice the one before; the first, as a share of the input's nominal value:
STEPS = 16
SHORT = 3  # the first of them, which end before most kinks that the others cross
FIRST = np.where(np.isin(np.arange(INPUT_COUNT), (IN_VERTICAL_SHIFT, IN_ROLL)), 4e-7, 4e-6)

INPUTS = (IN_LATERAL_SHIFT, IN_YAW, IN_NORMAL_FORCE, IN_LOAD_TRANSFER)
COMPLIANT_INPUTS = (IN_LATERAL_SHIFT, IN_YAW, IN_VERTICAL_SHIFT, IN_ROLL)


def poses(count, seed, mode="rigid"):
    """Inputs (count, n) over tread and flange root, half of them without yaw; of a compliant wheelset the
    heights and rolls that an elastic one has."""
    rng = np.random.default_rng(seed)
    rows = np.zeros((count, INPUT_COUNT))
    rows[:, IN_LATERAL_SHIFT] = rng.uniform(-7e-3, 7e-3, count)
    rows[:, IN_YAW] = rng.uniform(-0.02, 0.02, count) * (np.arange(count) % 2)
    rows[:, IN_NORMAL_FORCE] = rng.uniform(1e4, 1.5e5, count)
    rows[:, IN_LOAD_TRANSFER] = rng.uniform(-0.6, 0.6, count)
    if mode == "compliant":
        elastic = wrcontact.ContactSystem(contact_mode="elastic").evaluate_many(*rows[:, INPUTS].T)
        rows[:, IN_VERTICAL_SHIFT], rows[:, IN_ROLL] = elastic.vertical_shift, elastic.roll
    return rows


def stepped(stepper, row):
    stepper.inputs[:] = row
    return stepper.step(), stepper.outputs.copy()


def derivative(stepper, row, seed):
    """Status and rates of the outputs at ``row`` along ``seed``: a number of one input, or a vector."""
    along = np.eye(INPUT_COUNT)[seed] if isinstance(seed, int) else np.asarray(seed, float)
    stepped(stepper, row)
    return solver_of(stepper).derivative(along)


def differences(stepper, row, number):
    """Central differences along one input, extrapolated from two steps each, where neighbouring ones agree
    best; how far these are apart; and the middle one of those over the SHORT steps, which are noisier."""
    found = []
    for k in range(STEPS):
        step = FIRST[number] * USUAL[number] * 2.0**k
        low, high = row.copy(), row.copy()
        low[number] -= step
        high[number] += step
        (worse, after), (bad, before) = stepped(stepper, high), stepped(stepper, low)
        valid = max(worse, bad) <= layout.UNLOADED
        found.append((after - before) / (high - low)[number] if valid else np.full(OUTPUT_COUNT, np.nan))
    found = np.array(found)
    sharper = (4.0 * found[:-1] - found[1:]) / 3.0
    apart = np.abs(np.diff(sharper, axis=0))
    apart = np.nan_to_num(np.maximum(apart[:-1], apart[1:]), nan=np.inf)
    best, columns = apart.argmin(axis=0), np.arange(OUTPUT_COUNT)
    return sharper[best + 1, columns], apart[best, columns], np.median(found[:SHORT], axis=0)


def scale(rates, number):
    """What a deviation is measured by: the largest rate of an output's kind (of all stations of a side, for
    one), or a thousandth of nominal values."""
    largest = np.zeros(FAMILY.max() + 1)
    np.maximum.at(largest, FAMILY, np.abs(rates))
    return np.maximum(largest[FAMILY], 1e-3 * NOMINAL / USUAL[number])
