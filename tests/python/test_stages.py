# SPDX-License-Identifier: Apache-2.0
"""Stages written in Python are checked, described, run and explained like the library's own."""
import gc
import threading
import time

import numpy as np
import pytest

import xgm

SEMI_GLOBAL = ("{type: semi_global, cost: %s, penalty: {type: constant, p1: 10, p2: 60}, "
               "aggregation: {type: sgm, directions: 4}, refinement: %s}")


def run(scene, text, **arguments):
    return xgm.load_text(text).run(scene.left, scene.right, scene.disparities, **arguments)


@xgm.stage("filter", "py_far", publication="Nobody, 2024.")
class Far:
    """Takes small disparities away.

    Only the first paragraph is the summary.
    """
    least: float = xgm.param(8, "Smallest disparity that is kept.", range=(0, 1000), unit="px")
    window: int = xgm.param(3, "Unused.", range=(1, 9), odd=True)
    mode: str = xgm.param("hard", "Unused.", choices=("hard", "soft"))
    weights: list[float] = xgm.param([1, 2], "Unused.", elements=(2, 3))
    on: bool = True
    ignored = 5

    def run(self, map, pair, context):
        if pair.is_reverse or not self.on:
            return map
        context.figure("least", self.least)
        return np.where(map.disparity >= self.least, map.disparity, np.nan)


@xgm.stage("cost", "py_difference")
class Difference:
    """Absolute difference of grey levels."""
    max_cost = 40

    def run(self, pair, disparities, context):
        base, match = pair.base.grey, pair.match.grey
        for d in disparities:
            moved = np.full_like(match, np.nan)
            first, last = max(d, 0), match.shape[1] + min(d, 0)
            moved[:, first:last] = match[:, first - d:last - d]
            yield np.minimum(np.abs(base - moved), self.max_cost)


@xgm.stage("refinement", "py_parabola")
class Parabola:
    def run(self, map, sums, context):
        before, here, after = np.moveaxis(sums, 2, 0)
        curvature = before + after - 2 * here
        with np.errstate(all="ignore"):
            shift = np.where(curvature > 0, (before - after) / (2 * curvature), 0)
        return map.disparity + np.clip(np.nan_to_num(shift), -0.5, 0.5).astype(np.float32)


@xgm.stage("matcher", "py_blocks")
class Blocks:
    """Sum of absolute differences in a window, the smallest wins."""
    radius: int = xgm.param(2, "Of the window, px.", range=(0, 20))

    def run(self, pair, disparities, context):
        costs = np.stack([self._windows(slice) for slice in
                          Difference().run(pair, disparities, context)])
        costs[np.isnan(costs)] = np.inf
        best = costs.argmin(axis=0)
        disparity = (best + disparities.start).astype(np.float32)
        disparity[np.isinf(costs.min(axis=0))] = np.nan
        return disparity

    def _windows(self, values):
        side = 2 * self.radius + 1
        padded = np.pad(values, self.radius, mode="edge")
        windows = np.lib.stride_tricks.sliding_window_view(padded, (side, side))
        return windows.sum(axis=(2, 3))


def total(result, scene):
    return xgm.evaluate(result, scene, thresholds=[1])["non-occluded"]["thresholds"][0]["total"]


def test_filter(scene):
    plain = xgm.load("sgm8").run(scene.left, scene.right, scene.disparities)
    pipeline = xgm.load("sgm8", set={"postprocess": [{"type": "py_far", "least": 12}]})
    result = pipeline.run(scene.left, scene.right, scene.disparities)
    kept = plain.disparity >= 12
    assert np.array_equal(result.disparity[kept], plain.disparity[kept])
    assert np.isnan(result.disparity[~kept]).all()
    lost = np.isfinite(plain.disparity) & ~kept
    assert lost.any() and result.is_status("ambiguous")[lost].all()
    stages = [stage for stage in result.record["stages"] if stage["plugin"] == "py_far"]
    assert stages[0]["figures"] == {"least": 12} and "least=12" in str(pipeline)


def test_cost_is_the_built_in_one(scene):
    ours = run(scene, "matcher: " + SEMI_GLOBAL % ("py_difference", "parabola"))
    assert total(ours, scene) < 0.35


def test_cost_in_a_pyramid_of_ragged_ranges(scene):
    result = run(scene, "matcher: {type: pyramid, scale: 2, matcher: {type: left_right, matcher: "
                 + SEMI_GLOBAL % ("py_difference", "parabola") + "}}")
    assert result.density > 0.4


def test_refinement_is_the_built_in_one(scene):
    ours, theirs = (run(scene, "matcher: " + SEMI_GLOBAL % ("census", name)).disparity
                    for name in ("py_parabola", "parabola"))
    known = np.isfinite(theirs)
    assert np.array_equal(known, np.isfinite(ours))
    assert np.abs(ours[known] - theirs[known]).max() < 1e-3


def test_matcher_also_inside_left_right(scene):
    usable = np.ones((120, 160), bool)
    usable[:, :9] = False
    alone = run(scene, "matcher: {type: py_blocks, radius: 3}", mask=usable)
    assert np.array_equal(alone.is_status("masked"), ~usable)
    checked = run(scene, "matcher: {type: left_right, matcher: py_blocks}")
    assert checked.reverse is not None and checked.is_status("occluded").any()
    assert total(checked, scene) < 0.5


def test_described_and_listed():
    text = xgm.describe("filter/py_far")
    for part in ("Takes small disparities away.", "Source: Nobody, 2024.", "least = 8.0",
                 "Smallest disparity that is kept.", "a number from 0 to 1000, px", "hard", "odd"):
        assert part in text, part
    assert "Only the first" not in text
    assert ("filter", "py_far", "Takes small disparities away.") in xgm.plugins("filter")


def test_explained(scene):
    pipeline = xgm.load("sgm8", set={"postprocess": [{"type": "py_far", "least": 31}]})
    explanation = pipeline.explain(80, 60, scene.left, scene.right, scene.disparities)
    assert "postprocess[0]" in explanation.text and "py_far" in explanation.text
    assert any(event["plugin"] == "py_far" for event in explanation.data["events"])


@pytest.mark.parametrize("written, text", [
    ("{type: py_far, leats: 3}", "py_far has no parameter 'leats'; did you mean 'least'?"),
    ("{type: py_far, least: -1}", "'least' cannot be -1; give a number from 0 to 1000"),
    ("{type: py_far, window: 4}", "odd"),
    ("{type: py_far, mode: hart}", "did you mean 'hard'?"),
    ("{type: py_far, weights: [1]}", "'weights'"),
    ("{type: py_far, on: 3}", "'on'"),
    ("py_fat", "there is no filter called 'py_fat'; did you mean 'py_far'?"),
])
def test_mistakes_in_parameters_are_located(written, text):
    with pytest.raises(xgm.ConfigError) as caught:
        xgm.load_text(f"matcher: opencv_sgbm\npostprocess:\n  - {written}\n", name="mine.yaml")
    [found] = caught.value.diagnostics
    assert found.line == 3 and found.column > 4 and text in str(found)


BAD = {
    "raises": (lambda self, map, pair, context: 1 / 0, "raised ZeroDivisionError: division by zero"),
    "shape": (lambda self, map, pair, context: map.disparity[1:], r"has shape \(119, 160\)"),
    "none": (lambda self, map, pair, context: None, "returned None"),
    "text": (lambda self, map, pair, context: "text", "has shape"),
    "type": (lambda self, map, pair, context: map.disparity.astype(complex), "complex"),
    "three": (lambda self, map, pair, context: (1, 2, 3), "returned 3 values"),
    "infinite": (lambda self, map, pair, context: np.full_like(map.disparity, 1e9), "faulty result"),
    "status": (lambda self, map, pair, context: (map.disparity, np.full_like(map.status, 77)),
               "faulty result: the status is none there is"),
    "writes": (lambda self, map, pair, context: map.disparity.fill(0), "read-only"),
}


@pytest.mark.parametrize("name", BAD)
def test_what_goes_wrong_in_a_filter_names_the_stage(name, scene):
    function, text = BAD[name]
    xgm.stage("filter", "py_bad")(type("Bad", (), {"run": function}))
    with pytest.raises(xgm.Error, match=text) as caught:
        run(scene, "matcher: opencv_sgbm\npostprocess: [py_bad]")
    assert caught.value.stage == "postprocess[0]" and "filter 'py_bad'" in str(caught.value)
    if name == "raises":
        assert isinstance(caught.value.__cause__, ZeroDivisionError)
        assert caught.value.__cause__.__traceback__ is not None


@pytest.mark.parametrize("costs, text", [
    (lambda d: np.zeros((3, 4)), r"costs of disparity 0 has shape \(3, 4\)"),
    (lambda d: np.full((120, 160), -1.0), "lie in -1 to -1; 0 to max_cost = 254 are wanted"),
    (lambda d: np.full((120, 160), 300), "0 to max_cost"),
])
def test_what_goes_wrong_in_a_cost_names_the_stage(costs, text, scene):
    xgm.stage("cost", "py_bad")(type("Bad", (), {
        "run": lambda self, pair, disparities, context: map(costs, disparities)}))
    with pytest.raises(xgm.Error, match=text) as caught:
        run(scene, "matcher: " + SEMI_GLOBAL % ("py_bad", "parabola"))
    assert caught.value.stage == "matcher.cost"


@pytest.mark.parametrize("count, text", [(5, "of 5 disparities; 32 are wanted"),
                                         (40, "of more than 32 disparities")])
def test_wrong_number_of_costs(count, text, scene):
    xgm.stage("cost", "py_bad")(type("Bad", (), {
        "run": lambda self, pair, disparities, context: [np.zeros((120, 160))] * count}))
    with pytest.raises(xgm.Error, match=text):
        run(scene, "matcher: " + SEMI_GLOBAL % ("py_bad", "parabola"))


def test_mistakes_in_declarations_are_told_at_once():
    with pytest.raises(TypeError, match="needs a default"):
        xgm.stage("filter", "py_x")(type("X", (), {"__annotations__": {"a": int}, "run": None,
                                                   "run": lambda self: 0}))
    with pytest.raises(TypeError, match="is of type bool, int, float, str or list"):
        xgm.stage("filter", "py_x")(type("X", (), {"__annotations__": {"a": dict}, "a": {},
                                                   "run": lambda self: 0}))
    with pytest.raises(TypeError, match="the default 'x' is not of type int"):
        xgm.stage("filter", "py_x")(type("X", (), {"__annotations__": {"a": int}, "a": "x",
                                                   "run": lambda self: 0}))
    with pytest.raises(TypeError, match=r"needs a method run\(\)"):
        xgm.stage("filter", "py_x")(type("X", (), {}))
    with pytest.raises(xgm.UsageError, match="cannot be written in Python"):
        xgm.stage("aggregation", "py_x")(type("X", (), {}))
    with pytest.raises(xgm.Error, match="already a filter called 'median'"):
        xgm.stage("filter", "median")(Far)


def test_a_class_is_replaced_and_loaded_pipelines_keep_theirs(scene):
    def filter_that_gives(value):
        def run(self, map, pair, context):
            return np.where(np.isfinite(map.disparity), np.float32(value), np.nan)
        return type("Gives", (), {"run": run})

    xgm.stage("filter", "py_again")(filter_that_gives(3))
    text = "matcher: opencv_sgbm\npostprocess: [py_again]"
    first = xgm.load_text(text)
    xgm.stage("filter", "py_again")(filter_that_gives(4))
    second = xgm.load_text(text)
    gc.collect()
    for pipeline, value in ((first, 3), (second, 4)):
        map = pipeline.run(scene.left, scene.right, scene.disparities).disparity
        assert np.nanmin(map) == np.nanmax(map) == value


def test_a_stage_that_loops_is_ended_too(scene):
    class Loops:
        def run(self, map, pair, context):
            while True:
                pass

    xgm.stage("filter", "py_loops")(Loops)
    cancel = threading.Event()
    threading.Timer(0.3, cancel.set).start()
    start = time.monotonic()
    with pytest.raises(xgm.Cancelled):
        run(scene, "matcher: opencv_sgbm\npostprocess: [py_loops]", cancel=cancel)
    assert time.monotonic() - start < 2


def test_a_context_that_is_kept_is_of_no_use_and_no_danger(scene):
    kept = []

    class Keeps:
        def run(self, map, pair, context):
            kept.extend([context, map, pair])
            return map

    xgm.stage("filter", "py_keeps")(Keeps)
    result = run(scene, "matcher: opencv_sgbm\npostprocess: [py_keeps]")
    with pytest.raises(xgm.Error, match="has ended"):
        kept[0].progress(1)
    assert np.array_equal(kept[1].disparity, result.disparity, equal_nan=True)
    assert kept[2].base.shape == (120, 160) and len(kept[2].base.planes) == 3
