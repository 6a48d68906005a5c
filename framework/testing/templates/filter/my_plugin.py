# SPDX-License-Identifier: Apache-2.0
"""Filter "my_plugin": takes the disparities of far points away."""
import os

import numpy as np
import xgm


@xgm.stage("filter", "my_plugin")
class MyPlugin:
    """Takes the disparities of far points away."""

    least: float = xgm.param(4.0, "Disparities nearer to 0 are taken away.", unit="px",
                             range=(0, 10000))

    def run(self, map, pair, context):
        return np.where(np.abs(map.disparity) >= self.least, map.disparity, np.nan)


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    print(xgm.load(os.path.join(here, "pipeline.yaml")).run())
