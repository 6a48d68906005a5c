# SPDX-License-Identifier: Apache-2.0
"""For programs that use OpenCV's matchers: the same calls, another map."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._errors import UsageError
from ._pipeline import Changes, Pipeline, load
from ._result import Result

DISP_SHIFT = 4
DISP_SCALE = 1 << DISP_SHIFT


class StereoMatcher:
    """Stands for cv2.StereoSGBM_create(...) and cv2.StereoBM_create(...).

    minDisparity and numDisparities are as in OpenCV. `pipeline` does the matching: a name, a file,
    or a Pipeline. What else OpenCV's matchers are given (blockSize, P1, ...) is a parameter of the
    pipeline: change it with `set`, as in load(). Colour images have OpenCV's order, blue first.
    """

    def __init__(self, minDisparity: int = 0, numDisparities: int = 64, *,
                 pipeline: Any = "tmgm16_refined", set: Optional[Changes] = None,
                 channels: str = "bgr", threads: int = 0) -> None:
        if isinstance(pipeline, Pipeline) and set:
            raise UsageError("set: give it to load(), which has made this pipeline")
        self.pipeline = pipeline if isinstance(pipeline, Pipeline) else load(pipeline, set)
        self.channels = channels
        self.threads = threads
        self._begin, self._count = minDisparity, numDisparities
        self._check()

    def _check(self) -> None:
        largest = np.iinfo(np.int16).max // DISP_SCALE
        end = self._begin + self._count
        if self._count < 1 or self._begin - 1 < -largest or end > largest:
            raise UsageError(f"minDisparity={self._begin}, numDisparities={self._count}: 16 bit hold "
                             f"{-largest + 1} to {largest - 1} px; use Pipeline.run() for others")

    def getMinDisparity(self) -> int:
        return self._begin

    def getNumDisparities(self) -> int:
        return self._count

    def setMinDisparity(self, minDisparity: int) -> None:
        self._begin = minDisparity
        self._check()

    def setNumDisparities(self, numDisparities: int) -> None:
        self._count = numDisparities
        self._check()

    def match(self, left: Any, right: Any, **arguments: Any) -> Result:
        """Pipeline.run() with this matcher's disparities."""
        return self.pipeline.run(left, right, (self._begin, self._begin + self._count),
                                 channels=self.channels, threads=self.threads, **arguments)

    def compute(self, left: Any, right: Any) -> NDArray[np.int16]:
        """OpenCV's fixed-point map: int16, 16 * disparity, (minDisparity - 1) * 16 where there is
        none. Rounded to 1/16 px; match() gives the map itself."""
        disparity = self.match(left, right, progress=False).disparity
        none = np.float32((self._begin - 1) * DISP_SCALE)
        scaled = np.where(np.isfinite(disparity), np.rint(disparity * DISP_SCALE), none)
        return scaled.astype(np.int16)
