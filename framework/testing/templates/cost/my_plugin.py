# SPDX-License-Identifier: Apache-2.0
"""Cost "my_plugin": absolute difference of grey levels."""
import os

import numpy as np
import xgm


@xgm.stage("cost", "my_plugin")
class MyPlugin:
    """Absolute difference of grey levels."""

    max_cost = 60  # what run() gives is not greater
    scale: float = xgm.param(1.0, "Cost of a grey level.", range=(0.01, 100))

    def run(self, pair, disparities, context):
        base, match = pair.base.grey, pair.match.grey
        for d in disparities:  # (x, y) is compared with (x - d, y)
            difference = np.abs(base - np.roll(match, d, axis=1))
            yield np.minimum(self.scale * difference, self.max_cost)


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    print(xgm.load(os.path.join(here, "pipeline.yaml")).run())
