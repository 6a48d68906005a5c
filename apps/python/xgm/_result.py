# SPDX-License-Identifier: Apache-2.0
"""What a run gives."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Optional

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._arrays import PathLike
from ._errors import UsageError

import os

#: Names of the values of ``status``: ``STATUS[0]`` is "valid".
STATUS = tuple(_native.statuses)


class Map:
    """Disparities of one view.

    ``disparity``: float32, shape (height, width), px, NaN where there is none; pixel (x, y) of the
    left image lies at (x - disparity, y) in the right one. ``status``: uint8, why a pixel has a
    disparity or none, see STATUS. ``confidence``: float32, how sure each matched disparity is, 0 to
    1, NaN where there is none; None if the pipeline makes no confidence. All share their memory with
    the library.
    """

    def __init__(self, disparity: NDArray[np.float32], status: NDArray[np.uint8],
                 confidence: Optional[NDArray[np.float32]] = None) -> None:
        self.disparity = disparity
        self.status = status
        self.confidence = confidence

    def is_status(self, name: str) -> NDArray[np.bool_]:
        """Where pixels have this status, such as "occluded"."""
        if name not in STATUS:
            raise UsageError(f"there is no status '{name}'; statuses: {', '.join(STATUS)}")
        found: NDArray[np.bool_] = self.status == STATUS.index(name)
        return found

    @property
    def density(self) -> float:
        """Share of pixels that have a disparity, 0 to 1."""
        return float(np.isfinite(self.disparity).mean())

    def status_shares(self) -> Dict[str, float]:
        """Share of pixels of each status, 0 to 1."""
        counts = np.bincount(self.status.ravel(), minlength=len(STATUS)) / self.status.size
        return {name: float(share) for name, share in zip(STATUS, counts)}

    def masked(self) -> np.ma.MaskedArray[Any, np.dtype[np.float32]]:
        """The disparities as a masked array."""
        masked: np.ma.MaskedArray[Any, np.dtype[np.float32]]
        masked = np.ma.masked_invalid(self.disparity, copy=False)
        return masked

    def picture(self, status: bool = False) -> bytes:
        """A PNG of the map in colours (blue far, red near, black none), or of its statuses, with a
        legend."""
        draw = _native.status_png if status else _native.disparity_png
        return draw(self.disparity, self.status)

    def _repr_png_(self) -> bytes:
        return self.picture()

    def write(self, folder: PathLike) -> None:
        """Writes disparity.pfm, disparity.png, status.png and, if there is a confidence,
        confidence.pfm, as the command line does."""
        _native.write_maps(os.fspath(folder), self.disparity, self.status, self.confidence)

    def __repr__(self) -> str:
        height, width = self.disparity.shape
        return f"<xgm.{type(self).__name__}: {width} x {height} px, {100 * self.density:.1f} % found>"


class Result(Map):
    """The map of the left image, and all that is known of its run.

    ``reverse`` is the Map of the right image, if the pipeline makes one (its disparities have the
    opposite sign), else None. ``warnings`` lists what looked wrong; ``seconds`` is the time of
    matching.
    """

    def __init__(self, run: Any) -> None:
        super().__init__(run.disparity(), run.status(), run.confidence())
        self._run = run
        self._record: Optional[Dict[str, Any]] = None
        reverse = run.reverse_disparity()
        self.reverse = None if reverse is None else Map(reverse, run.reverse_status(),
                                                        run.reverse_confidence())
        self.warnings: List[str] = run.warnings + ([run.failure] if run.failure else [])
        self.seconds: float = run.seconds

    @property
    def record(self) -> Dict[str, Any]:
        """The record of the run: what run.json holds (docs/conventions.md)."""
        if self._record is None:
            self._record = json.loads(self._run.record_json())
        return self._record
