# SPDX-License-Identifier: Apache-2.0
"""Surfaces of satellite images: the same as the command line's."""
import json
import os
import subprocess
import threading

import numpy as np
import pytest

import xgm

if not xgm.REASONS:
    pytest.skip("built without GDAL and PROJ", allow_module_level=True)


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    folder = tmp_path_factory.mktemp("place")
    subprocess.run([os.environ["XGM_PIPELINE"], "synth", str(folder), "--satellite", "--size", "300",
                    "--relief", "20", "--force"], check=True, capture_output=True)
    return next(folder.iterdir())


@pytest.fixture(scope="module")
def images(place):
    return [place / "image_1.tif", place / "image_2.tif"]


@pytest.fixture(scope="module")
def surface(images, place):
    return xgm.load("dsm_tsgm8").run_surface(images, dem=place / "dem.tif", truth=place / "dsm.tif")


def test_the_surface_is_that_of_the_command_line(surface, place, program, tmp_path):
    program("run", "dsm_tsgm8", "--images", str(place / "image_1.tif"), str(place / "image_2.tif"),
            "--dem", str(place / "dem.tif"), "--truth", str(place / "dsm.tif"), "--output", "theirs")
    theirs = json.loads((tmp_path / "theirs" / "run.json").read_text())
    ours = surface.record
    for same in ("grid", "pairs", "covered_share", "cells", "truth"):
        assert ours[same] == theirs[same], same
    assert surface.picture() == (tmp_path / "theirs" / "dsm.png").read_bytes()
    assert surface.covered > 0.5


def test_layers_have_the_shape_of_the_grid(surface):
    grid = surface.record["grid"]
    layers = (surface.heights, surface.pairs, surface.spread, surface.gap, surface.source,
              surface.orthoimage, surface.reasons)
    assert {layer.shape for layer in layers} == {(grid["rows"], grid["columns"])}
    assert surface.geotransform == (grid["left"], grid["resolution_m"], 0, grid["top"], 0,
                                    -grid["resolution_m"])
    empty = np.isnan(surface.heights)
    assert np.array_equal(surface.reasons != 0, empty)
    assert np.array_equal(surface.source == xgm.SOURCES.index("none"), empty)
    assert "% have a height" in repr(surface) and surface._repr_png_().startswith(b"\x89PNG")


def test_files_are_written_and_clouds_are_made_a_surface_again(images, place, surface, tmp_path):
    pipeline = xgm.load("dsm_tsgm8")
    scene = tmp_path / "scene.yaml"
    scene.write_text(f"images: [{images[0]}, {images[1]}]\ndem: {place / 'dem.tif'}\n")
    written = pipeline.run_surface(scene=scene, output=tmp_path / "out", threads=1)
    assert np.array_equal(written.heights, surface.heights, equal_nan=True)
    assert (tmp_path / "out" / "dsm.tif").is_file()
    again = pipeline.run_surface(clouds=tmp_path / "out" / "cloud.ply")
    assert again.reasons is None and again.covered > 0.5
    small = pipeline.run_surface(scene=scene, area="0,0:150x100")
    assert small.heights.size < written.heights.size / 2


@pytest.mark.parametrize("arguments, said", [
    ({}, "at least two satellite images"),
    ({"area": (1, 2)}, "west, south, east, north"),
    ({"geoid": "egm1900"}, "egm1900"),
    ({"dem": "missing.tif"}, "missing.tif"),
])
def test_mistakes_are_told_before_any_work(images, arguments, said):
    given = images if arguments else None
    with pytest.raises(xgm.UsageError, match=said):
        xgm.load("dsm_tsgm8").run_surface(given, **arguments)


def test_pipelines_of_the_other_family_are_refused(images):
    with pytest.raises(xgm.UsageError, match="no pipeline of type surface"):
        xgm.load("sgm8").run_surface(images)
    with pytest.raises(xgm.UsageError, match="matches no single image pair"):
        xgm.load("dsm_tsgm8").run(np.zeros((9, 9), np.uint8), np.zeros((9, 9), np.uint8), (0, 4))


def test_a_run_is_cancelled(images):
    cancel = threading.Event()
    cancel.set()
    with pytest.raises(xgm.Cancelled):
        xgm.load("dsm_tsgm8").run_surface(images, cancel=cancel)
