# SPDX-License-Identifier: Apache-2.0
"""Maps against truth, benches, generated scenes."""
import numpy as np
import pytest

import xgm


def test_evaluate_counts_as_the_definitions_say(scene):
    truth = scene.truth
    map = truth + np.float32(0.25)
    map[:60] += 2
    map[:, :40] = np.nan
    figures = xgm.evaluate(map, truth, thresholds=[1, 3])["all"]
    assert figures["judged_pixels"] == truth.size
    assert figures["invalid"] == pytest.approx(40 / 160)
    bad = [score["bad"] for score in figures["thresholds"]]
    assert bad == pytest.approx([0.5 * 120 / 160, 0])
    assert figures["average_error_px"] == pytest.approx(1.25, abs=1e-4)


def test_evaluate_takes_files_masks_and_results(scene, sgm8, tmp_path):
    result = sgm8.run(scene.left, scene.right, scene.disparities)
    xgm.write_pfm(tmp_path / "map.pfm", result.disparity)
    wanted = xgm.evaluate(result, scene)
    assert set(wanted) >= {"all", "non-occluded", "occluded"}
    of_file = xgm.evaluate(tmp_path / "map.pfm", scene.truth, non_occluded=scene.non_occluded)
    of_bool = xgm.evaluate(result.masked(), scene.truth, non_occluded=scene.non_occluded == 255)
    assert of_file == wanted and of_bool == wanted
    with pytest.raises(xgm.Error, match="size|120"):
        xgm.evaluate(result, scene.truth[:50])


def test_bench_gives_a_row_for_each_run(tmp_path):
    for seed in (1, 2):
        xgm.synth((120, 90), (0, 24), seed=seed, objects=4).write(tmp_path / "data" / f"s{seed}")
    told = []
    rows = xgm.bench(["sgm8", xgm.load("sgm8", set={"matcher.matcher.aggregation.directions": 4})],
                     tmp_path / "data", thresholds=[1],
                     progress=lambda share, stage: told.append((share, stage)))
    assert [(row["pipeline"], row["scene"]) for row in rows] == [
        (name, scene) for scene in ("s1", "s2") for name in ("sgm8", "sgm8+directions=4")]
    truth = xgm.read_disparities(tmp_path / "data/s1/disp0GT.pfm")
    result = xgm.load("sgm8").run(scene=tmp_path / "data/s1")
    judged = xgm.evaluate(result, truth, thresholds=[1], non_occluded=xgm.synth((120, 90), (0, 24), seed=1,
                                                     objects=4).non_occluded)
    assert rows[0]["total_1"] == judged["non-occluded"]["thresholds"][0]["total"]
    assert rows[0]["state"] == "done" and rows[0]["seconds"] > 0 and "sgm8" in str(rows)
    assert told[-1][0] == 1


def test_a_bench_goes_on_where_it_was_and_a_failure_stops_no_other_run(tmp_path):
    xgm.synth((120, 90), (0, 24), objects=4).write(tmp_path / "data/s")

    class Fails:
        def run(self, map, pair, context):
            raise ValueError("no")

    xgm.stage("filter", "py_fails")(Fails)
    pipelines = {"fine": "sgm8", "faulty": xgm.load("sgm8", set={"postprocess": ["py_fails"]})}
    first = xgm.bench(pipelines, tmp_path / "data", output=tmp_path / "out")
    assert {row["pipeline"]: row["state"] for row in first} == {"fine": "done", "faulty": "failed"}
    assert any("ValueError: no" in row.get("failure", "") for row in first)
    second = xgm.bench(pipelines, tmp_path / "data", output=tmp_path / "out")
    assert [row["seconds"] for row in second if row["pipeline"] == "fine"] == \
        [row["seconds"] for row in first if row["pipeline"] == "fine"]


def test_synth_is_that_of_the_command_line(program, tmp_path):
    program("synth", "theirs", "--size", "100x80", "--disparities", "0:23", "--seed", "7",
            "--fault", "noise=2")
    scene = xgm.synth((100, 80), (0, 24), seed=7, faults=["noise=2"])
    scene.write(tmp_path / "ours")
    for name in ("im0.png", "im1.png", "disp0GT.pfm", "mask0nocc.png", "calib.txt"):
        assert (tmp_path / "ours" / name).read_bytes() == \
            (tmp_path / "theirs/scene_0001" / name).read_bytes()
    assert scene.left.shape == (80, 100, 3) and scene.truth.shape == (80, 100)
    assert scene.disparities == (0, 24)
    with pytest.raises(xgm.Error, match="nois"):
        xgm.synth(faults=["nois"])


def test_sample_is_what_is_matched_without_images(sgm8):
    sample = xgm.sample()
    assert np.array_equal(sgm8.run().disparity,
                          sgm8.run(sample.left, sample.right, sample.disparities).disparity,
                          equal_nan=True)
