# SPDX-License-Identifier: Apache-2.0
"""Refinement "my_plugin": the vertex of the parabola through the sums beside the winner."""
import os

import numpy as np
import xgm


@xgm.stage("refinement", "my_plugin")
class MyPlugin:
    """The vertex of a parabola through three sums."""

    strength: float = xgm.param(1.0, "Share of the way to the vertex.", range=(0, 1))

    def run(self, map, sums, context):
        left, centre, right = sums[..., 0], sums[..., 1], sums[..., 2]  # NaN where there is none
        curvature = left - 2 * centre + right
        with np.errstate(divide="ignore", invalid="ignore"):
            shift = np.where(curvature > 0, 0.5 * (left - right) / curvature, 0)
        return map.disparity + self.strength * np.clip(shift, -0.5, 0.5)


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    print(xgm.load(os.path.join(here, "pipeline.yaml")).run())
