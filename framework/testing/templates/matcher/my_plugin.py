# SPDX-License-Identifier: Apache-2.0
"""Matcher "my_plugin": block matching by absolute differences in a window."""
import os

import numpy as np
import xgm


@xgm.stage("matcher", "my_plugin")
class MyPlugin:
    """Block matching by absolute differences."""

    window: int = xgm.param(5, "Side of the window.", unit="px", range=(1, 51), odd=True)

    def run(self, pair, disparities, context):
        base, match = levels(pair.base), levels(pair.match)
        least = np.full(base.shape, np.inf, np.float32)
        disparity = np.full(base.shape, np.nan, np.float32)
        for d in disparities:
            shifted = np.full(base.shape, np.nan, np.float32)
            first, last = max(0, d), min(base.shape[1], base.shape[1] + d)
            if first < last:
                shifted[:, first:last] = match[:, first - d:last - d]
            difference = np.abs(base - shifted)
            cost = np.where(np.isnan(difference), np.inf, mean(difference, self.window))
            disparity = np.where(cost < least, np.float32(d), disparity)
            least = np.minimum(cost, least)
        return disparity


def levels(view):
    """The grey levels, NaN where there are no data."""
    return view.grey if view.valid is None else np.where(view.valid != 0, view.grey, np.nan)


def mean(image, window):
    """Of the numbers in the window around each pixel; infinite where there are none."""
    known = np.isfinite(image)
    total, count = box_sum(np.where(known, image, 0), window), box_sum(known, window)
    return np.where(count > 0, total / np.maximum(count, 1), np.inf)


def box_sum(image, window):
    radius = window // 2
    sums = np.pad(image.astype(np.float64), ((radius + 1, radius), (radius + 1, radius)))
    sums = sums.cumsum(0).cumsum(1)
    return (sums[window:, window:] - sums[:-window, window:] - sums[window:, :-window]
            + sums[:-window, :-window])


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    print(xgm.load(os.path.join(here, "pipeline.yaml")).run())
