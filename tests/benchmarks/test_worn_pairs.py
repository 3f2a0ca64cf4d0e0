"""New, worn and measured pairs against the half-space's stored answers."""

import numpy as np
import pytest

from benchmarks import worn_pairs


def test_the_estimate_holds_for_poses_that_were_drawn_later():
    """Against the half-space's stored answers: in the mean, in rank, and class by class."""
    count = 160
    truth = worn_pairs.references(count, worn_pairs.STORED, None).reshape(-1, 2, 3)[..., 2]
    own, peak = np.full((count, 2), np.nan), np.full((count, 2), np.nan)
    for index in range(count):
        state = worn_pairs.standing(worn_pairs.pose(index), error_outputs=True)
        if state.status == 0:
            own[index] = state.left.model_error, state.right.model_error
            peak[index] = state.left.max_pressure, state.right.max_pressure
    known = np.isfinite(own) & np.isfinite(truth)
    own, error = own[known], np.abs(peak[known] / truth[known] - 1)
    assert len(own) > 300
    assert own.mean() == pytest.approx(error.mean(), rel=0.5)  # measured 1.2
    ranks = [np.argsort(np.argsort(each)) for each in (own, error)]
    assert np.corrcoef(*ranks)[0, 1] > 0.6
    low, middle, high = (
        error[(own >= a) & (own < b)].mean() for a, b in ((0, 0.01), (0.01, 0.02), (0.02, 1))
    )
    assert 2 * low < middle and 1.5 * middle < high


@pytest.mark.parametrize("index", [1, 7])
def test_the_stored_answers_are_those_of_the_half_space(index):
    """They are printed with seven digits."""
    stored = worn_pairs.references(index + 1, worn_pairs.STORED, None)[index]
    np.testing.assert_allclose(worn_pairs.half_space(index), stored, rtol=1e-6)


def test_the_stored_wheels_that_roll_are_those_of_the_half_space():
    stored = worn_pairs.references(3, worn_pairs.ROLLING, None)[2]
    found = worn_pairs.half_space_rolling(2)
    np.testing.assert_allclose(found, stored, atol=1e-4 * stored[3])


def test_models_keep_their_order_on_worn_pairs():
    """Errors of ANALYN, auto and strips fall in this order on wheels of worn pairs."""
    truth, means = worn_pairs.references(60, worn_pairs.STORED, None).reshape(-1, 2, 3), []
    for name in ("hertz", "analyn", "auto", "analyn_strip"):
        errors = []
        for index in range(worn_pairs.KINDS.index("both worn"), 60, len(worn_pairs.KINDS)):
            state = worn_pairs.standing(worn_pairs.pose(index), normal_model=name)
            found = [
                [getattr(wheel, part) for part in worn_pairs.PATCH] for wheel in (state.left, state.right)
            ]
            errors += np.abs(np.array(found) / truth[index] - 1.0).tolist()
        means.append(np.nanmean(errors, axis=0))  # not of wheels without contact
    assert np.all(np.diff(means, axis=0) <= 0.0)
