# SPDX-License-Identifier: Apache-2.0
"""Surface models of satellite images."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._arrays import PathLike, is_path, to_threads
from ._errors import UsageError
from ._progress import Progress, Watch

#: Names of the values of ``Surface.reasons``: ``REASONS[0]`` is that of cells with a height.
REASONS: Tuple[str, ...] = tuple(getattr(_native, "reasons", ()))
#: Names of the values of ``Surface.source``.
SOURCES = ("none", "measured", "filled")

Paths = Union[None, PathLike, Sequence[PathLike]]
Area = Union[None, PathLike, Tuple[float, float, float, float]]


class Surface:
    """A surface model, north up. All arrays have the shape (rows, columns) of its grid and share
    their memory with the library.

    ``heights``: float32, m above the ellipsoid or the geoid, NaN where there is none.
    ``geotransform``: where the cells lie, as GDAL and rasterio (``Affine.from_gdal``) have it, in
    ``crs``, a text that PROJ understands.
    ``pairs``: how many pairs have a height in the cell; ``spread``: how far they disagree, m;
    ``gap``: median distance of the two sights of a cell's points, m; ``source``: see SOURCES;
    ``orthoimage``: grey levels; ``reasons``: why a cell is empty, see REASONS, None if the surface
    was made of clouds.
    ``covered``: share of cells that have a height; ``record``: what run.json holds.
    """

    def __init__(self, run: Any) -> None:
        self._run = run
        self.heights: NDArray[np.float32] = run.heights()
        self.pairs: NDArray[np.float32] = run.pairs()
        self.spread: NDArray[np.float32] = run.spread()
        self.gap: NDArray[np.float32] = run.gap()
        self.source: NDArray[np.uint8] = run.source()
        self.orthoimage: NDArray[np.float32] = run.orthoimage()
        self.reasons: Optional[NDArray[np.uint8]] = run.reasons()
        self.geotransform: Tuple[float, ...] = tuple(run.geotransform())
        self.crs: str = run.crs()
        self.covered: float = run.covered
        self.seconds: float = run.seconds
        self.warnings: List[str] = run.warnings + ([run.failure] if run.failure else [])
        self.record: Dict[str, Any] = json.loads(run.record_json)

    def picture(self) -> bytes:
        """A PNG of the heights in colours, shaded, with a legend in m."""
        picture: bytes = self._run.picture()
        return picture

    def _repr_png_(self) -> bytes:
        return self.picture()

    def __repr__(self) -> str:
        rows, columns = self.heights.shape
        step = self.geotransform[1]
        return (f"<xgm.Surface: {columns} x {rows} cells of {step:g} m, "
                f"{100 * self.covered:.1f} % have a height>")


def _names(paths: Paths) -> List[str]:
    if paths is None:
        return []
    if is_path(paths):
        return [os.fspath(paths)]
    return [os.fspath(path) for path in paths]  # type: ignore[union-attr]


def _area_text(area: Area) -> str:
    if area is None:
        return ""
    if isinstance(area, (str, os.PathLike)):
        return os.fspath(area)
    try:
        west, south, east, north = (float(edge) for edge in area)
    except (TypeError, ValueError):
        raise UsageError(f"area={area!r}: give (west, south, east, north) in degrees, a window "
                         "'COLUMN,ROW:WIDTHxHEIGHT' of the first image, or a file") from None
    return f"{west!r},{south!r},{east!r},{north!r}"


def run_surface(pipeline: Any, changes: List[Tuple[str, str]], images: Paths, scene: Optional[PathLike],
                dem: Paths, masks: Paths, cameras: Paths, area: Area, band: int, clouds: Paths,
                truth: Optional[PathLike], geoid: str, output: Optional[PathLike], threads: int,
                progress: Progress, cancel: Any) -> Surface:
    """See Pipeline.run_surface()."""
    if not hasattr(_native, "run_surface"):
        raise UsageError("this package was built without GDAL and PROJ, which surfaces need; "
                         "install libgdal-dev and libproj-dev, and build it again")
    scene_file = "" if scene is None else os.fspath(scene)
    files = _native.read_surface_scene(scene_file) if scene_file else _native.SurfaceFiles()
    given = {"images": _names(images), "dem": _names(dem), "masks": _names(masks),
             "cameras": _names(cameras), "area": _area_text(area), "band": band,
             "clouds": _names(clouds), "truth": "" if truth is None else os.fspath(truth)}
    for name, value in given.items():
        if value:
            setattr(files, name, value)
    if not files.images and not files.clouds:
        raise UsageError("give at least two satellite images (images=[...]), a scene in YAML, or clouds")
    wishes = _native.SurfaceWishes()
    wishes.folder = "" if output is None else os.fspath(output)
    wishes.geoid, wishes.changes, wishes.threads = geoid, changes, to_threads(threads)
    with Watch(progress, cancel) as hooks:
        return Surface(_native.run_surface(pipeline, files, scene_file, wishes, hooks))
