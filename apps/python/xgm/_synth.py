# SPDX-License-Identifier: Apache-2.0
"""Scenes whose true disparities are known exactly."""

from __future__ import annotations

import os
from typing import Any, NamedTuple, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._arrays import PathLike, to_range, to_threads


class Calibration(NamedTuple):
    """Cameras of a rectified pair: a pixel (x, y) of the left image with disparity d shows a point
    at the depth baseline * focal / (d + doffs). focal, cx, cy and doffs in px, baseline in mm."""

    focal: float
    cx: float
    cy: float
    doffs: float
    baseline: float


class SyntheticScene:
    """A generated pair and its truth.

    ``left``, ``right``: (height, width, 3) in the order red, green, blue, or (height, width) if
    grey; uint8 or uint16. ``truth``, ``reverse_truth``: float32, (height, width), px.
    ``non_occluded``: uint8, 255 where a left pixel is visible in the right image. ``disparities``:
    (first, last + 1) to search. ``calibration``: invented cameras.
    """

    def __init__(self, made: Any) -> None:
        self._made = made
        self.left: NDArray[Any] = made.left()
        self.right: NDArray[Any] = made.right()
        self.truth: NDArray[np.float32] = made.truth()
        self.reverse_truth: NDArray[np.float32] = made.reverse_truth()
        self.non_occluded: NDArray[np.uint8] = made.non_occluded()
        self.disparities: Tuple[int, int] = made.disparities()
        self.calibration = Calibration(*made.calibration())

    def write(self, folder: PathLike) -> None:
        """Writes a scene folder in the layout of Middlebury, version 3."""
        self._made.write(os.fspath(folder))


def synth(size: Tuple[int, int] = (640, 480), disparities: Any = (0, 64), *, seed: int = 1,
          objects: int = 12, colour: bool = True, bits: int = 8, faults: Sequence[str] = (),
          threads: int = 0) -> SyntheticScene:
    """Generates a scene (docs/synth.md); each seed gives another one.

    size: (width, height), px. disparities: (first, last + 1) of all surfaces. bits: 8 or 16.
    faults: as for --fault of `pipeline synth`: ["blur", "noise=3"].
    """
    return SyntheticScene(_native.generate(size, to_range(disparities), seed, objects, colour, bits,
                                           list(faults), to_threads(threads)))


def sample() -> SyntheticScene:
    """The built-in sample pair: 640 x 480 px, disparities (0, 64)."""
    return SyntheticScene(_native.sample())
