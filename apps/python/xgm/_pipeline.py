# SPDX-License-Identifier: Apache-2.0
"""Pipelines: loaded, described, run."""

from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Tuple, Union

from . import _native
from ._arrays import PathLike, is_path, to_image, to_map, to_range, to_threads, to_tiles
from ._errors import ConfigError, Diagnostic, UsageError
from ._progress import Progress, Watch, logger
from ._result import Result
from ._surface import Area, Paths, Surface, run_surface

Changes = Mapping[str, Any]


def _yaml(value: Any) -> str:
    """Texts are YAML already, as for --set; all else is JSON, which YAML understands."""
    return value if isinstance(value, str) else json.dumps(value)


def _pairs(changes: Optional[Changes]) -> List[Tuple[str, str]]:
    return [(path, _yaml(value)) for path, value in (changes or {}).items()]


class Explanation(NamedTuple):
    """Why a pixel has its disparity, or none: a text for people, and all of it as data."""

    text: str
    data: Dict[str, Any]

    def __str__(self) -> str:
        return self.text


class Pipeline:
    """A checked pipeline: immutable, and run by any number of threads at once. See load()."""

    def __init__(self, loaded: Any, changes: List[Tuple[str, str]]) -> None:
        self._native = loaded
        self._changes = changes

    @property
    def file(self) -> str:
        """The file that it was loaded from, or the name given to its text."""
        return str(self._native.file)

    @property
    def resolved(self) -> Dict[str, Any]:
        """Every parameter with its value, defaults included; it is itself a pipeline."""
        resolved: Dict[str, Any] = json.loads(self._native.resolved_json())
        return resolved

    @property
    def disparities(self) -> Optional[Tuple[int, int]]:
        """(first, last + 1) that the pipeline itself asks for, if it does."""
        disparities: Optional[Tuple[int, int]] = self._native.disparities()
        return disparities

    def __str__(self) -> str:
        return str(self._native.graph())

    def __repr__(self) -> str:
        return f"<xgm.Pipeline {self.file}>"

    def run(
        self,
        left: Any = None,
        right: Any = None,
        disparities: Any = None,
        *,
        mask: Any = None,
        channels: str = "rgb",
        truth: Any = None,
        truth_divisor: Optional[float] = None,
        scene: Optional[PathLike] = None,
        scene_name: str = "",
        dataset: str = "",
        range_maps: Optional[Tuple[Any, Any]] = None,
        output: Optional[PathLike] = None,
        report: bool = False,
        dump: str = "",
        cloud: Optional[PathLike] = None,
        depth: Optional[PathLike] = None,
        tiles: Union[bool, Tuple[int, int]] = False,
        threads: int = 0,
        memory_limit: Optional[float] = None,
        progress: Progress = None,
        cancel: Any = None,
    ) -> Result:
        """Matches a rectified pair.

        left, right: the images, of one size: arrays of shape (height, width) or (height, width,
            channels) of uint8, uint16, float32 or float64, masked ones included, or names of files.
            Values are taken as from files (docs/conventions.md, "Images and masks"); float32 grey
            levels from 0 to 255 are not copied. Without images and scene, the built-in sample pair
            is matched.
        disparities: (first, last + 1) to search, px; or range(first, last + 1). Needed unless the
            scene or the pipeline says it.
        mask: not 0 where a pixel of the left image may be used; (left, right) for both. Of numpy's
            masked arrays the elements that are not masked are used.
        channels: "rgb" (numpy, Pillow, imageio) or "bgr" (cv2): the order in colour arrays.
        truth: true disparities, an array or a file; the record then has the errors of the map.
        scene: the folder of a scene instead of images; `scene_name` and `dataset` as for the
            command line.
        range_maps: (smallest, largest) disparity to search at each pixel of the left image, px:
            two arrays of its shape, NaN where nothing is to be searched, or two files.
        output: a folder for the files of `pipeline run`; report, dump, cloud, depth: which of them.
        tiles: True, or (width, height): match in parts, with the memory of one part.
        threads: 0 for all processors. The map does not depend on it.
        memory_limit: bytes that the process may take.
        progress: called with the share that is done (0 to 1) and the path of the stage; None shows
            a bar of tqdm, if that is there, in a terminal or notebook; False nothing.
        cancel: anything with is_set(), such as threading.Event; ends the run with xgm.Cancelled.

        Raises UsageError for mistakes of the caller, Error if the run fails. Ctrl-C and exceptions
        of `progress` end the run.
        """
        request = make_request(left, right, disparities, mask, channels, truth, truth_divisor, scene,
                               scene_name, dataset, range_maps, memory_limit)
        wishes = _native.RunWishes()
        wishes.folder, wishes.report, wishes.dump = _name(output), report, dump
        wishes.cloud, wishes.depth = _name(cloud), _name(depth)
        wishes.changes, wishes.tiles = self._changes, to_tiles(tiles)
        wishes.threads = to_threads(threads)
        with Watch(progress, cancel) as hooks:
            return Result(_native.run(self._native, request, wishes, hooks))

    def run_surface(
        self,
        images: Paths = None,
        *,
        scene: Optional[PathLike] = None,
        dem: Paths = None,
        masks: Paths = None,
        cameras: Paths = None,
        area: Area = None,
        band: int = 0,
        clouds: Paths = None,
        truth: Optional[PathLike] = None,
        geoid: str = "",
        output: Optional[PathLike] = None,
        threads: int = 0,
        progress: Progress = None,
        cancel: Any = None,
    ) -> Surface:
        """Makes a surface model of satellite images; for pipelines of type surface (docs/satellite.md).

        images: at least two files with RPC cameras; cameras: files of these, if the images have
            none; masks: files, one for each image, 0 where it must not be used.
        scene: a file in YAML that names all of these; what is given beside it counts.
        dem: files of known heights, which bound the search.
        area: (west, south, east, north) in degrees, "COLUMN,ROW:WIDTHxHEIGHT" of the first image, or
            a file with an outline; None for what the first image shows.
        band: of all images, from 1 on; 0 for the mean of all bands.
        clouds: files of clouds of earlier runs instead of images: nothing is matched.
        truth: a raster of true heights; the record then has the errors.
        geoid: what heights are counted from: "egm96", "egm2008"; "" for the ellipsoid.
        output: a folder for the files of `pipeline run`.
        threads, progress, cancel and what is raised: as in run().
        """
        return run_surface(self._native, self._changes, images, scene, dem, masks, cameras, area, band,
                           clouds, truth, geoid, output, threads, progress, cancel)

    def explain(self, x: int, y: int, left: Any = None, right: Any = None, disparities: Any = None,
                *, mask: Any = None, channels: str = "rgb", truth: Any = None,
                truth_divisor: Optional[float] = None, scene: Optional[PathLike] = None,
                scene_name: str = "", dataset: str = "",
                range_maps: Optional[Tuple[Any, Any]] = None, threads: int = 0,
                progress: Progress = None, cancel: Any = None) -> Explanation:
        """Says why pixel (x, y) of the left image has its disparity, stage by stage (docs/explain.md).
        The other arguments are those of run()."""
        request = make_request(left, right, disparities, mask, channels, truth, truth_divisor, scene,
                               scene_name, dataset, range_maps, None)
        with Watch(progress, cancel) as hooks:
            [(text, data)] = _native.explain(self._native, request, [(x, y)], to_threads(threads),
                                               hooks)
        return Explanation(text, json.loads(data))


def _masks(mask: Any) -> Tuple[Any, Any]:
    if isinstance(mask, tuple):
        if len(mask) != 2:
            raise UsageError("mask: give one mask, or (left, right)")
        return mask[0], mask[1]
    return mask, None


def _array_request(left: Any, right: Any, mask: Any, channels: str, truth: Any,
                   divisor: Optional[float]) -> Any:
    if channels not in ("rgb", "bgr"):
        raise UsageError(f"channels={channels!r}: give 'rgb' or 'bgr'")
    left_mask, right_mask = _masks(mask)
    known = _native.ArrayTruth(None, None, None)
    if truth is not None:
        if is_path(truth):
            truth = _native.read_disparities(os.fspath(truth), divisor, [])
        known = _native.ArrayTruth(to_map("truth", truth), None, None)
    return _native.request_of_arrays(to_image("left", left, left_mask),
                                     to_image("right", right, right_mask), channels == "rgb", known)


def _name(file: Optional[PathLike]) -> str:
    return "" if file is None else os.fspath(file)


def _file_request(left: Any, right: Any, mask: Any, truth: Any, divisor: Optional[float]) -> Any:
    left_mask, right_mask = _masks(mask)
    if not all(name is None or is_path(name) for name in (left_mask, right_mask, truth)):
        raise UsageError("images that are files have masks and a truth that are files; read them "
                         "to mix files and arrays")
    return _native.request_of_files(_name(left), _name(right), _name(left_mask), _name(right_mask),
                                    _name(truth), divisor)


def _search(request: Any, range_maps: Any) -> None:
    """Has the disparities between two maps searched."""
    if not isinstance(range_maps, (tuple, list)) or len(range_maps) != 2:
        raise UsageError("range_maps: give (smallest, largest), two arrays or two files")
    if all(map(is_path, range_maps)):
        request.search_maps(*map(os.fspath, range_maps))
    elif any(map(is_path, range_maps)):
        raise UsageError("range_maps: one is a file and one is not; read the file "
                         "(xgm.read_disparities), or write the array")
    else:
        request.search_ranges(*(to_map(f"range_maps[{i}]", values)
                                for i, values in enumerate(range_maps)))


def make_request(left: Any, right: Any, disparities: Any, mask: Any, channels: str, truth: Any,
                 truth_divisor: Optional[float], scene: Optional[PathLike], scene_name: str,
                 dataset: str, range_maps: Any,
                 memory_limit: Optional[float]) -> Any:
    """A _native.Request of the arguments of run()."""
    if (left is None) != (right is None):
        raise UsageError("give both images, left and right")
    if scene is not None and left is not None:
        raise UsageError("give a scene, or images, not both")
    if left is None and (mask is not None or truth is not None):
        raise UsageError("mask and truth belong to images that are given; a scene has its own")
    if scene is not None:
        request = _native.request_of_scene(os.fspath(scene), scene_name, dataset)
    elif left is None:
        request = _native.request_of_sample()
    elif is_path(left) and is_path(right):
        request = _file_request(left, right, mask, truth, truth_divisor)
    else:
        request = _array_request(left, right, mask, channels, truth, truth_divisor)
    if disparities is not None:
        request.search(to_range(disparities))
    if range_maps is not None:
        _search(request, range_maps)
    if memory_limit is not None:
        request.limit_memory(memory_limit)
    return request


def _checked(loaded: Any, changes: List[Tuple[str, str]]) -> Pipeline:
    pipeline, diagnostics = loaded
    if pipeline is None:
        raise ConfigError([Diagnostic(*found) for found in diagnostics])
    return Pipeline(pipeline, changes)


_told_failures = 0


def _tell_failures() -> None:
    """Plugin files of XGM_PLUGIN_PATH that could not be loaded: each is warned of once."""
    global _told_failures
    failures = _native.failures()
    for file, reason in failures[_told_failures:]:
        logger.warning("plugin %s could not be loaded: %s", file, reason)
    _told_failures = len(failures)


def load(name: PathLike, set: Optional[Changes] = None) -> Pipeline:
    """Loads and checks a pipeline: a shipped one by its name ("tmgm16_refined"), or a file.

    set: changes, each with the path of a parameter and its value: {"matcher.scale": 4}. A text is
        YAML, as for --set of the command line: {"postprocess": "[median]"}.

    Raises ConfigError, which lists all mistakes with their places, or UsageError if there is no
    such pipeline.
    """
    _tell_failures()
    changes = _pairs(set)
    return _checked(_native.load(os.fspath(name), changes), changes)


def load_text(text: str, set: Optional[Changes] = None, name: str = "pipeline") -> Pipeline:
    """The same for the YAML of a pipeline; `name` stands for the file in messages."""
    _tell_failures()
    changes = _pairs(set)
    return _checked(_native.load_text(text, name, changes), changes)


def pipelines() -> List[str]:
    """Names of the shipped pipelines."""
    names: List[str] = _native.pipelines()
    return names


def plugins(kind: str = "") -> List[Tuple[str, str, str]]:
    """(kind, name, summary) of all plugins, or of those of a kind."""
    found: List[Tuple[str, str, str]] = _native.plugins(kind)
    return found


def describe(plugin: str) -> str:
    """A plugin's parameters with types, ranges, defaults and texts: "census", "cost/census"."""
    return str(_native.describe(plugin))


def load_plugin(file: PathLike) -> None:
    """Makes the stages of a plugin file (*.so) known to load()."""
    _native.load_plugin(os.fspath(file))
