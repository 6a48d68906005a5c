# SPDX-License-Identifier: Apache-2.0
"""Dense disparity maps of rectified image pairs.

    result = xgm.load("tmgm16_refined").run(left, right, disparities=(0, 128))
    result.disparity   # float32, shape (height, width), px, NaN where there is none

docs/python.md is the guide.
"""

from ._errors import Cancelled, ConfigError, Diagnostic, Error, UsageError
from ._evaluation import Bench, bench, evaluate
from ._io import (find_scenes, read_disparities, read_kitti, read_point_cloud, write_kitti,
                  write_pfm, write_point_cloud)
from ._native import version as __version__
from ._pipeline import (Explanation, Pipeline, describe, load, load_plugin, load_text, pipelines,
                        plugins)
from ._result import STATUS, Map, Result
from ._stage_calls import Context, Pair, View
from ._stages import param, stage
from ._stereo_matcher import StereoMatcher
from ._surface import REASONS, SOURCES, Surface
from ._synth import Calibration, SyntheticScene, sample, synth

__all__ = [
    "Bench", "Calibration", "Cancelled", "ConfigError", "Context", "Diagnostic", "Error",
    "Explanation", "Map", "Pair", "Pipeline", "REASONS", "Result", "SOURCES",
    "STATUS", "StereoMatcher", "Surface", "SyntheticScene",
    "UsageError", "View", "__version__", "bench", "describe", "evaluate", "find_scenes", "load",
    "load_plugin", "load_text", "param", "pipelines", "plugins", "read_disparities", "read_kitti",
    "read_point_cloud", "sample", "stage", "synth", "write_kitti", "write_pfm", "write_point_cloud",
]
