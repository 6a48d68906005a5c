# SPDX-License-Identifier: Apache-2.0
"""Files of disparities, points and scenes."""
import numpy as np
import pytest

import xgm


@pytest.fixture
def map():
    values = np.linspace(0.5, 200, 30 * 40, dtype=np.float32).reshape(30, 40)
    values[3:7, 5:9] = np.nan
    return values


def test_pfm_gives_back_what_was_written(map, tmp_path):
    xgm.write_pfm(tmp_path / "map.pfm", map)
    assert (tmp_path / "map.pfm").read_bytes().startswith(b"Pf\n40 30\n-1")
    assert np.array_equal(xgm.read_disparities(tmp_path / "map.pfm"), map, equal_nan=True)


def test_kitti_holds_256ths(map, tmp_path):
    map[0, 0] = 0
    xgm.write_kitti(tmp_path / "map.png", map)
    read = xgm.read_kitti(tmp_path / "map.png")
    assert np.array_equal(np.isnan(read), np.isnan(map))
    assert np.nanmax(np.abs(read - map)) <= 1 / 256
    assert read[0, 0] == np.float32(1 / 256)
    with pytest.raises(xgm.UsageError, match="KITTI's format holds"):
        xgm.write_kitti(tmp_path / "map.png", map * 2)


def test_points_lie_where_the_cameras_say(tmp_path):
    cameras = xgm.Calibration(focal=100, cx=20, cy=15, doffs=1, baseline=50)
    disparity = np.full((30, 40), np.nan, np.float32)
    disparity[10, 25] = 4
    left = np.zeros((30, 40, 3), np.uint8)
    left[10, 25] = (10, 20, 30)
    assert xgm.write_point_cloud(tmp_path / "points.ply", disparity, cameras, left) == 1
    points = xgm.read_point_cloud(tmp_path / "points.ply")
    depth = 50 * 100 / (4 + 1)
    wanted = {"x": (25 - 20) * depth / 100, "y": (10 - 15) * depth / 100, "z": depth,
              "red": 10, "green": 20, "blue": 30}
    assert {name: values[0] for name, values in points.items()} == pytest.approx(wanted)


def test_scenes_are_listed(tmp_path):
    xgm.synth((64, 48), (0, 16), objects=2).write(tmp_path / "data/one")
    [scene] = xgm.find_scenes(tmp_path / "data")
    assert scene["name"] == "one"
    with pytest.raises(xgm.Error):
        xgm.find_scenes(tmp_path / "nothing")


def test_files_that_are_none_are_named(tmp_path):
    (tmp_path / "text.pfm").write_text("Pf\nno numbers")
    with pytest.raises(xgm.Error, match="text.pfm"):
        xgm.read_disparities(tmp_path / "text.pfm")
    with pytest.raises(xgm.Error, match="points.ply"):
        xgm.read_point_cloud(tmp_path / "points.ply")
    with pytest.raises(xgm.UsageError, match="give disparities in px as an array of shape"):
        xgm.write_pfm(tmp_path / "map.pfm", np.zeros((3, 4, 5)))
