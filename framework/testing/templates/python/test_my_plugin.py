# SPDX-License-Identifier: Apache-2.0
"""my_plugin works in pipeline.yaml: on a photographed pair and on images of odd kinds.

python3 test_my_plugin.py
"""
import os
import unittest

import numpy as np
import xgm

import my_plugin  # noqa: F401  makes the stage known to pipelines

HERE = os.path.dirname(os.path.abspath(__file__))


def run(left, right, disparities=(0, 16), **options):
    pipeline = xgm.load(os.path.join(HERE, "pipeline.yaml"))
    return pipeline.run(left, right, disparities, progress=False, **options)


def noise(height, width):
    return np.random.default_rng(1).uniform(0, 255, (height, width)).astype(np.float32)


class TestMyPlugin(unittest.TestCase):
    def test_it_matches_a_photographed_pair(self):
        pair = xgm.sample()
        self.assertGreater(run(pair.left, pair.right, (0, 64)).density, 0.5)

    def test_it_finds_a_shift_of_5_pixels(self):
        left = noise(60, 120)
        disparity = run(left, np.roll(left, -5, axis=1)).disparity[5:-5, 25:-5]
        self.assertGreater(np.mean(np.abs(disparity - 5) <= 1), 0.5)

    def test_it_takes_images_of_one_row_one_column_and_one_pixel(self):
        for shape in ((1, 40), (40, 1), (1, 1)):
            self.assertEqual(run(noise(*shape), noise(*shape)).disparity.shape, shape)

    def test_masked_pixels_stay_masked_whatever_their_levels(self):
        left, right = noise(40, 60), noise(40, 60)
        usable = np.ones(left.shape, bool)
        usable[10:20, 15:30] = False
        first = run(left, right, mask=usable)
        self.assertTrue(np.array_equal(first.is_status("masked"), ~usable))
        left[~usable] = 0
        again = run(left, right, mask=usable)
        self.assertTrue(np.array_equal(first.disparity, again.disparity, equal_nan=True))


if __name__ == "__main__":
    unittest.main()
