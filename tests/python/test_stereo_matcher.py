# SPDX-License-Identifier: Apache-2.0
"""OpenCV's habits: blue first, int16 of 1/16 px, (minDisparity - 1) * 16 for none."""
import numpy as np
import pytest

import xgm


def test_compute_is_16_times_the_map(scene):
    matcher = xgm.StereoMatcher(minDisparity=2, numDisparities=30, pipeline="sgm8")
    fixed = matcher.compute(scene.left[:, :, ::-1], scene.right[:, :, ::-1])
    map = xgm.load("sgm8").run(scene.left, scene.right, (2, 32)).disparity
    assert fixed.dtype == np.int16 and fixed.shape == map.shape
    known = np.isfinite(map)
    assert np.array_equal(fixed[known], np.rint(map[known] * 16).astype(np.int16))
    assert (fixed[~known] == (2 - 1) * 16).all()


def test_disparities_can_be_asked_and_changed():
    matcher = xgm.StereoMatcher(numDisparities=128, pipeline="sgm8")
    assert (matcher.getMinDisparity(), matcher.getNumDisparities()) == (0, 128)
    matcher.setMinDisparity(-16)
    matcher.setNumDisparities(32)
    assert (matcher.getMinDisparity(), matcher.getNumDisparities()) == (-16, 32)
    with pytest.raises(xgm.UsageError, match="16 bit hold"):
        matcher.setNumDisparities(5000)
