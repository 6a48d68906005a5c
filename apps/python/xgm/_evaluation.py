# SPDX-License-Identifier: Apache-2.0
"""How good maps are: one map, or many pipelines on many scenes."""

from __future__ import annotations

import json
import os
import tempfile
import warnings
from typing import Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from . import _native, _stages
from ._arrays import PathLike, is_path, status_of, to_map, to_mask, to_range, to_threads, with_plain_rows
from ._errors import UsageError
from ._pipeline import Pipeline, load
from ._progress import Progress, Watch
from ._result import Map

Thresholds = Optional[Sequence[float]]


def _arrays_of(map: Any) -> Tuple[NDArray[np.float32], NDArray[np.uint8]]:
    if isinstance(map, Map):
        return to_map("the map", map.disparity), with_plain_rows(map.status)
    if is_path(map):
        map = _native.read_disparities(os.fspath(map), None, [])
    disparity = to_map("the map", map)
    if np.isinf(disparity).any():
        disparity = np.where(np.isfinite(disparity), disparity, np.float32(np.nan))
    return disparity, status_of(disparity)


def evaluate(map: Any, truth: Any, *, non_occluded: Any = None, objects: Any = None,
             thresholds: Thresholds = None, scale: float = 1,
             clip: Any = None) -> Dict[str, Dict[str, Any]]:
    """The errors of a map (docs/evaluate.md): a dict for each region of the truth, "all" first.

    map: a Result, an array of disparities in px (not finite = none), or a file. truth: the same, of
    its size, or what synth() gave, which has the mask too. non_occluded: mask, 255 (or True) where
    a pixel is visible in both images. objects: mask, not 0 on moving objects. thresholds: px
    (0.5, 1, 2, 4). scale: factor of all errors. clip: (first, last + 1), the interval into which
    disparities are moved before.

    Shares are from 0 to 1, errors in px; None where nothing is known.
    """
    if isinstance(truth, _synthetic()):
        non_occluded = truth.non_occluded if non_occluded is None else non_occluded
        truth = truth.truth
    disparity, status = _arrays_of(map)
    true = _arrays_of(truth)[0]
    known = _native.ArrayTruth(true, to_mask("non_occluded", non_occluded, true.shape),
                               to_mask("objects", objects, true.shape))
    deltas = list(_native.usual_thresholds() if thresholds is None else thresholds)
    text, doubts = _native.evaluate(disparity, status, known, deltas, scale,
                                    None if clip is None else to_range(clip))
    for doubt in doubts:
        warnings.warn(doubt, stacklevel=2)
    return {region["region"]: region for region in json.loads(text)}


def _synthetic() -> Any:
    from ._synth import SyntheticScene

    return SyntheticScene


class Bench(List[Dict[str, Any]]):
    """The rows of a bench, one for each pipeline and scene, and the table of averages as text.

    ``pandas.DataFrame(bench)`` has a column for each figure. ``data`` is all that is known, as in
    bench.json (docs/bench.md).
    """

    def __init__(self, data: Dict[str, Any], table: str) -> None:
        super().__init__(_row(cell, data["rules"]) for cell in data["cells"])
        self.data = data
        self.table = table

    def __str__(self) -> str:
        return self.table


def _judged(cell: Dict[str, Any], region: str) -> Optional[Dict[str, Any]]:
    regions = {found["region"]: found for found in cell.get("truth", [])}
    wanted = region if region in regions else "non-occluded"
    return regions.get(wanted, regions.get("all"))


def _row(cell: Dict[str, Any], rules: Dict[str, Any]) -> Dict[str, Any]:
    row = {key: value for key, value in cell.items() if key not in ("truth", "weight", "folder")}
    judged = _judged(cell, rules["region"])
    if judged is None:
        return row
    for key, value in judged.items():
        if key == "thresholds":
            for score in value:
                delta = f"{score['delta_px']:g}"
                row[f"bad_{delta}"], row[f"total_{delta}"] = score["bad"], score["total"]
        else:
            row[key] = value
    return row


def _named(pipelines: Any) -> List[Tuple[str, Any, List[Tuple[str, str]]]]:
    if isinstance(pipelines, (Pipeline, str, os.PathLike)):
        pipelines = [pipelines]
    if not isinstance(pipelines, dict):
        loaded = [found if isinstance(found, Pipeline) else load(found) for found in pipelines]
        pipelines = {}
        for pipeline in loaded:
            stem = os.path.splitext(os.path.basename(pipeline.file))[0]
            name = stem + "".join(f"+{path.split('.')[-1]}={value}"
                                  for path, value in pipeline._changes)
            if name in pipelines:
                raise UsageError(f"two pipelines are called '{name}'; give a dict, with names")
            pipelines[name] = pipeline
    return [(name, found._native, found._changes) for name, found in
            ((name, p if isinstance(p, Pipeline) else load(p)) for name, p in pipelines.items())]


def bench(pipelines: Any, data: Union[PathLike, Sequence[PathLike]], *, dataset: str = "",
          scenes: Sequence[str] = (), output: Optional[PathLike] = None,
          thresholds: Thresholds = None, scale: float = 1, clip: bool = False, region: str = "",
          threads: int = 0, progress: Progress = None, cancel: Any = None) -> Bench:
    """Runs pipelines on the scenes of data sets, as `pipeline bench` does, but in this process.

    pipelines: names, files or Pipelines, in a list or, to name them, a dict. data: folders of
    scenes. output: a folder for the results, which a later call goes on from; without it they are
    removed. region: that is judged; "non-occluded" where it is known. The others are those of
    `pipeline bench` (docs/bench.md) and of Pipeline.run().
    """
    if output is None:
        with tempfile.TemporaryDirectory(prefix="xgm_bench_") as folder:
            return bench(pipelines, data, dataset=dataset, scenes=scenes, output=folder,
                         thresholds=thresholds, scale=scale, clip=clip, region=region,
                         threads=threads, progress=progress, cancel=cancel)
    wishes = _native.BenchWishes()
    wishes.output = os.fspath(output)
    folders = [data] if isinstance(data, (str, os.PathLike)) else data
    wishes.data = [os.fspath(folder) for folder in folders]
    wishes.dataset, wishes.scenes = dataset, list(scenes)
    wishes.threads = to_threads(threads)
    deltas = list(_native.usual_thresholds() if thresholds is None else thresholds)
    wishes.rules = _native.BenchRules(deltas, scale, clip, region)
    wishes.salts = sorted(salt for salt in _stages.salts.values() if salt)
    with Watch(progress, cancel) as hooks:
        text, table = _native.bench(_named(pipelines), wishes, hooks)
    return Bench(json.loads(text), table)
