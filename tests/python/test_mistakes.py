# SPDX-License-Identifier: Apache-2.0
"""What is wrong is said with what is wanted, and mistakes of pipelines with their places."""
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import xgm

GOOD = np.zeros((30, 40), np.uint8)


@pytest.mark.parametrize("left, right, text", [
    (np.zeros(30, np.uint8), GOOD, r"left image has shape \(30\); give \(height, width\)"),
    (GOOD, np.zeros((30, 40, 7), np.uint8), r"right image has shape \(30, 40, 7\)"),
    (np.zeros((0, 40), np.uint8), GOOD, "it has no pixels"),
    (GOOD.astype(np.int64), GOOD, "left image is of int64; convert it to one of uint8, uint16"),
    (GOOD.astype(complex), GOOD, "left image is of complex128"),
    ([[1, 2], [3, 4]], GOOD, "left image is of type list; give a numpy array"),
    (GOOD, None, "give both images"),
    (GOOD, GOOD[:20], r"right: is 40 x 20 pixels but left is 40 x 30"),
    (GOOD, GOOD.astype(np.float32), "right: is float but left is 8-bit"),
])
def test_images(sgm8, left, right, text):
    with pytest.raises(xgm.Error, match=text):
        sgm8.run(left, right, (0, 8))


@pytest.mark.parametrize("disparities", [(8, 8), (9, 3), 8, (0, 1.5), (0, 8, 2), "0:8", range(0, 9, 2)])
def test_disparities(sgm8, disparities):
    with pytest.raises(xgm.UsageError, match="give .first, last . 1."):
        sgm8.run(GOOD, GOOD, disparities)


def test_other_arguments(sgm8, tmp_path):
    with pytest.raises(xgm.UsageError, match="--disparities|disparities"):
        sgm8.run(GOOD, GOOD)
    with pytest.raises(xgm.UsageError, match="'rgb' or 'bgr'"):
        sgm8.run(GOOD, GOOD, (0, 8), channels="rgba")
    with pytest.raises(xgm.UsageError, match=r"mask of the left image has shape \(3, 4\)"):
        sgm8.run(GOOD, GOOD, (0, 8), mask=np.ones((3, 4)))
    with pytest.raises(xgm.UsageError, match="not both"):
        sgm8.run(GOOD, GOOD, (0, 8), scene=tmp_path)
    with pytest.raises(xgm.UsageError, match="give an output folder"):
        sgm8.run(GOOD, GOOD, (0, 8), report=True)
    for arguments, text in (({"threads": -1}, "threads=-1: give how many"),
                            ({"threads": "2"}, "threads='2'"),
                            ({"tiles": (10, 10)}, r"each at least 64"),
                            ({"tiles": "auto"}, "tiles='auto': give True"),
                            ({"progress": 5}, "progress=5: give a function"),
                            ({"cancel": 5}, "cancel=5: give a threading.Event")):
        with pytest.raises(xgm.UsageError, match=text):
            sgm8.run(GOOD, GOOD, (0, 8), **arguments)
    with pytest.raises(xgm.Error, match="nowhere.png"):
        sgm8.run("nowhere.png", "nowhere.png", (0, 8))
    with pytest.raises(ValueError):  # a mistake of the caller is one of Python's, too
        xgm.load("sgm9")


def test_mistakes_of_a_pipeline_come_all_at_once_with_their_places():
    text = "matcher:\n  type: semi_global\n  cost: {type: censs}\n  penalty: constant\n" \
           "  aggregation: {type: sgm, directions: 5}\n"
    with pytest.raises(xgm.ConfigError) as caught:
        xgm.load_text(text, name="mine.yaml")
    diagnostics = caught.value.diagnostics
    assert [(found.file, found.line) for found in diagnostics] == [("mine.yaml", 3), ("mine.yaml", 5)]
    assert "did you mean 'census'?" in diagnostics[0].remedy
    assert str(caught.value).splitlines()[0].startswith("mine.yaml:3:16: error: ")


def test_a_plugin_that_nobody_has_loaded_is_told_with_the_ways_to_load_it():
    with pytest.raises(xgm.ConfigError) as caught:
        xgm.load("sgm8", set={"matcher.matcher.cost": "quite_unheard_of"})
    [found] = caught.value.diagnostics
    assert "there is no cost called 'quite_unheard_of'" in found.message
    assert "xgm.load_plugin" in found.remedy and "--plugin FILE" in found.remedy


def test_changes_take_values_of_python_and_yaml():
    changed = xgm.load("sgm8", set={"matcher.matcher.aggregation.directions": 16,
                                    "postprocess": "[median]"})
    assert changed.resolved["matcher"]["matcher"]["aggregation"]["directions"] == 16
    assert changed.resolved["postprocess"][0]["type"] == "median"
    with pytest.raises(xgm.ConfigError, match="--set matcher.sclae=4: error"):
        xgm.load("sgm8", set={"matcher.sclae": 4})


def test_unknown_names_get_suggestions():
    with pytest.raises(xgm.UsageError, match="sgm8"):
        xgm.load("sgm9")
    with pytest.raises(xgm.UsageError, match="did you mean 'census'"):
        xgm.describe("censs")
    with pytest.raises(xgm.Error, match="no_such_plugin.so"):
        xgm.load_plugin("no_such_plugin.so")


def test_plugins_that_cannot_be_loaded_are_warned_of_once(tmp_path):
    (tmp_path / "broken.so").write_text("no library")
    code = "import xgm\nxgm.load('sgm8')\nxgm.load('sgm8')"
    environment = {**os.environ, "XGM_PLUGIN_PATH": str(tmp_path),
                   "PYTHONPATH": str(pathlib.Path(xgm.__file__).parent.parent)}
    child = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True,
                           text=True, check=True)
    assert child.stderr.count("broken.so could not be loaded") == 1


@pytest.mark.skipif(all(name != "surface" for _, name, _ in xgm.plugins("pipeline")),
                    reason="built without GDAL")
def test_surface_pipelines_say_that_they_match_no_pair():
    with pytest.raises(xgm.UsageError, match="matches no single image pair"):
        xgm.load("dsm_tmgm16").run(GOOD, GOOD, (0, 8))
