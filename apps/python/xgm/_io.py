# SPDX-License-Identifier: Apache-2.0
"""Files: disparities, scenes and points."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._arrays import PathLike, to_image, to_map, with_plain_rows
from ._errors import UsageError
from ._synth import Calibration

KITTI_DIVISOR = 256


def read_disparities(file: PathLike, divisor: Optional[float] = None,
                     no_data: Sequence[float] = ()) -> NDArray[np.float32]:
    """Disparities in px, float32, shape (height, width), NaN where there is none: of a PFM, a float
    TIFF, or an image of whole numbers, whose value / divisor is the disparity and 0 means none."""
    found: NDArray[np.float32] = _native.read_disparities(os.fspath(file), divisor, list(no_data))
    return found


def read_kitti(file: PathLike) -> NDArray[np.float32]:
    """read_disparities() of KITTI's format, a 16-bit PNG of 1/256 px."""
    return read_disparities(file, KITTI_DIVISOR)


def write_pfm(file: PathLike, disparity: Any) -> None:
    """Writes disparities in px as a PFM of float32, NaN as +inf."""
    _native.write_pfm(os.fspath(file), to_map("the map", disparity))


def write_kitti(file: PathLike, disparity: Any) -> None:
    """Writes disparities as KITTI does: a 16-bit PNG of 1/256 px, 0 = none; so they lie from 1/256
    to 65535/256 px. A disparity of 0 px is written as 1/256, because 0 means that there is none."""
    values = to_map("the map", disparity)
    known = np.isfinite(values)
    levels = np.rint(np.where(known, values, 0) * np.float32(KITTI_DIVISOR))
    if (levels < 0).any() or (levels > 65535).any():
        raise UsageError("KITTI's format holds disparities from 0 to 255.99 px; write a PFM")
    stored = np.where(known, np.maximum(levels, 1), 0).astype(np.uint16)
    _native.write_png16(os.fspath(file), with_plain_rows(stored))


def write_point_cloud(file: PathLike, disparity: Any, calibration: Calibration, left: Any, *,
                      channels: str = "rgb") -> int:
    """Writes a point of every pixel that has a depth as binary PLY, in the unit of the baseline
    (mm), coloured by the left image. Returns how many."""
    if channels not in ("rgb", "bgr"):
        raise UsageError(f"channels={channels!r}: give 'rgb' or 'bgr'")
    count: int = _native.write_cloud(os.fspath(file), to_map("the map", disparity),
                                     list(map(float, calibration)), to_image("left", left),
                                     channels == "rgb")
    return count


def read_point_cloud(file: PathLike) -> Dict[str, NDArray[np.float64]]:
    """The vertices of a PLY: an array for each property, such as "x" and "red"."""
    names, points = _native.read_points(os.fspath(file))
    return {name: points[:, i] for i, name in enumerate(names)}


def find_scenes(folder: PathLike, dataset: str = "") -> List[Dict[str, Any]]:
    """The scenes of a data set in a folder: files, disparities and what is missing, as
    `pipeline scenes --json` tells them."""
    scenes: List[Dict[str, Any]] = json.loads(_native.find_scenes(os.fspath(folder), dataset))
    return scenes
