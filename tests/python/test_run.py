# SPDX-License-Identifier: Apache-2.0
"""Arrays in, maps out: the same as the command line's, for every type of image."""
import re

import numpy as np
import pytest

import xgm


def as_written(folder):
    return xgm.read_disparities(folder / "disparity.pfm")


def same(a, b):
    return a.dtype == b.dtype and np.array_equal(a, b, equal_nan=True)


@pytest.mark.parametrize("name", xgm.pipelines())
def test_every_shipped_pipeline_gives_the_bytes_of_the_command_line(name, scene, program, tmp_path):
    scene.write(tmp_path / "scene")
    program("run", name, "scene", "--output", "out")
    result = xgm.load(name).run(scene.left, scene.right, scene.disparities)
    assert same(result.disparity, as_written(tmp_path / "out"))
    assert result.density > 0.3


def test_an_empty_map_is_told(sgm8):
    flat = np.zeros((20, 30), np.uint8)
    result = sgm8.run(flat, flat + 1, (0, 4), mask=np.zeros((20, 30), bool))
    assert result.density == 0
    assert any("the map is empty" in warning for warning in result.warnings)


def test_what_is_written_is_what_the_command_line_writes(scene, sgm8, program, tmp_path):
    scene.write(tmp_path / "scene")
    program("run", "sgm8", "scene", "--output", "theirs")
    ours = sgm8.run(scene=tmp_path / "scene", output=tmp_path / "ours")
    for name in ("disparity.pfm", "disparity.png", "status.png"):
        assert (tmp_path / "ours" / name).read_bytes() == (tmp_path / "theirs" / name).read_bytes()
    assert ours.record["truth"][0]["region"] == "all"
    assert [output["file"] for output in ours.record["outputs"]][0] == "disparity.pfm"


def test_a_confidence_comes_with_the_map_and_is_written_with_it(scene, sgm8, tmp_path):
    assert sgm8.run(scene.left, scene.right, (0, 32)).confidence is None
    sure = xgm.load("sgm8", set={"matcher.matcher.confidence": "peak_ratio"})
    result = sure.run(scene.left, scene.right, (0, 32))
    assert result.confidence.dtype == np.float32
    assert np.array_equal(np.isfinite(result.confidence), np.isfinite(result.disparity))
    assert np.nanmin(result.confidence) >= 0 and np.nanmax(result.confidence) <= 1
    assert result.reverse.confidence.shape == result.disparity.shape
    result.write(tmp_path)
    assert same(xgm.read_disparities(tmp_path / "confidence.pfm"), result.confidence)


@pytest.mark.parametrize("left, right", [("scene/im0.png", "scene/im1.png")])
def test_files_and_arrays_give_the_same(scene, sgm8, tmp_path, left, right):
    scene.write(tmp_path / "scene")
    of_files = sgm8.run(tmp_path / left, str(tmp_path / right), scene.disparities)
    assert same(of_files.disparity, sgm8.run(scene.left, scene.right, (0, 32)).disparity)


def test_result_has_map_status_reverse_and_record(scene, sgm8):
    result = sgm8.run(scene.left, scene.right, range(0, 32), truth=scene.truth)
    assert result.disparity.dtype == np.float32 and result.disparity.shape == (120, 160)
    assert result.status.dtype == np.uint8 and result.status.shape == (120, 160)
    has = np.isfinite(result.disparity)
    assert np.array_equal(has, result.is_status("valid") | result.is_status("filled"))
    assert result.reverse.disparity.shape == (120, 160)
    assert np.nanmax(result.reverse.disparity) <= 0.5
    assert result.record["disparities"]["first"] == 0 and result.record["disparities"]["last"] == 31
    assert result.record["truth"][0]["judged_pixels"] == 160 * 120
    assert sum(result.status_shares().values()) == pytest.approx(1)
    assert result._repr_png_().startswith(b"\x89PNG") and result.picture(status=True)
    assert 0 < result.seconds < 60


def test_types_of_images_that_mean_the_same_give_the_same(grey_scene, sgm8):
    left, right, search = grey_scene.left, grey_scene.right, grey_scene.disparities
    wanted = sgm8.run(left, right, search).disparity
    variants = {
        "float32": [image.astype(np.float32) for image in (left, right)],
        "float64": [image.astype(np.float64) for image in (left, right)],
        "one channel": [image[:, :, None] for image in (left, right)],
        "big-endian": [image.astype(">f4") for image in (left, right)],
        "rows apart": [np.repeat(image, 2, axis=0)[::2] for image in (left, right)],
        "columns apart": [np.repeat(image, 2, axis=1)[:, ::2] for image in (left, right)],
        "upside down": [image[::-1].copy()[::-1] for image in (left, right)],
    }
    for name, (a, b) in variants.items():
        assert same(sgm8.run(a, b, search).disparity, wanted), name


def test_16_bit_images_are_scaled_as_files_are(grey_scene, sgm8, program, tmp_path):
    deep = xgm.synth((160, 120), (0, 32), seed=4, bits=16)
    assert deep.left.dtype == np.uint16
    deep.write(tmp_path / "scene")
    program("run", "sgm8", "scene", "--output", "out")
    result = sgm8.run(deep.left, deep.right, deep.disparities)
    assert same(result.disparity, as_written(tmp_path / "out"))


def test_order_of_channels(scene, sgm8):
    wanted = sgm8.run(scene.left, scene.right, scene.disparities).disparity
    blue_first = sgm8.run(scene.left[:, :, ::-1], scene.right[:, :, ::-1], scene.disparities,
                          channels="bgr")
    assert same(blue_first.disparity, wanted)
    deep = [image.astype(">u2") * 257 for image in (scene.left, scene.right)]
    turned = [image[:, :, ::-1] for image in deep]
    for images, channels in ((deep, "rgb"), (turned, "bgr")):
        assert same(sgm8.run(*images, scene.disparities, channels=channels).disparity, wanted)


def test_masks_arrays_alpha_and_numpys_own_mean_the_same(scene, sgm8):
    left, right, search = scene.left, scene.right, scene.disparities
    usable = np.ones((120, 160), bool)
    usable[20:60, 70:110] = False
    wanted = sgm8.run(left, right, search, mask=usable)
    assert np.array_equal(wanted.is_status("masked"), ~usable)
    hidden = np.ma.masked_array(left, mask=np.repeat(~usable[:, :, None], 3, axis=2))
    alpha = np.dstack([left, np.where(usable, 255, 0).astype(np.uint8)])
    for variant in (sgm8.run(hidden, right, search), sgm8.run(alpha, np.dstack(
            [right, np.full((120, 160), 255, np.uint8)]), search),
            sgm8.run(left, right, search, mask=(usable.astype(np.uint8) * 255, None))):
        assert same(variant.disparity, wanted.disparity)
        assert same(variant.status, wanted.status)
    left_hidden = sgm8.run(left, right, search, mask=(None, usable))
    assert not left_hidden.is_status("masked").any()


def test_nan_in_float_images_is_no_data(grey_scene, sgm8):
    left = grey_scene.left.astype(np.float32)
    left[10:20, 40:60] = np.nan
    before = left.copy()
    result = sgm8.run(left, grey_scene.right.astype(np.float32), grey_scene.disparities)
    assert result.is_status("masked").sum() == 200
    assert same(left, before), "the user's array is left as it is"


def test_float_images_of_levels_are_shared_and_others_left_alone(grey_scene):
    from xgm import _native
    from xgm._arrays import to_image

    left = grey_scene.left.astype(np.float32)

    def first_plane(image):
        none = _native.ArrayTruth(None, None, None)
        request = _native.request_of_arrays(to_image("left", image), to_image("right", image), True,
                                            none)
        return request.left_planes()[0]

    assert np.shares_memory(first_plane(left), left)
    assert np.shares_memory(first_plane(left[5:90, 3:77]), left)
    unit = left / np.float32(255)
    before = unit.copy()
    assert not np.shares_memory(first_plane(unit), unit)
    assert same(unit, before)


def test_result_shares_its_memory_and_outlives_everything(scene):
    result = xgm.load("sgm8").run(scene.left, scene.right, scene.disparities)
    assert not result.disparity.flags.owndata and not result.status.flags.owndata
    assert np.shares_memory(result.disparity, result._run.disparity())
    disparity, wanted = result.disparity, result.disparity.copy()
    del result
    assert same(disparity, wanted)


def test_tiles_and_memory_limit(scene, sgm8):
    result = sgm8.run(scene.left, scene.right, scene.disparities, tiles=(80, 80))
    assert result.density > 0.3
    with pytest.raises(xgm.UsageError, match="allows"):
        sgm8.run(scene.left, scene.right, scene.disparities, memory_limit=1e6)


def test_range_maps_are_arrays_or_files(grey_scene, sgm8, tmp_path):
    left, right = grey_scene.left, grey_scene.right
    smallest = np.full((120, 160), 2.0, np.float32)
    largest = smallest + np.arange(160, dtype=np.float32) % 7
    smallest[50:60, 20:40] = np.nan
    xgm.write_pfm(tmp_path / "min.pfm", smallest)
    xgm.write_pfm(tmp_path / "max.pfm", largest)
    of_files = sgm8.run(left, right, range_maps=(tmp_path / "min.pfm", tmp_path / "max.pfm"))
    of_arrays = sgm8.run(left, right, range_maps=(smallest, largest.astype(np.float64)))
    assert same(of_arrays.disparity, of_files.disparity)
    assert same(of_arrays.status, of_files.status)
    assert of_arrays.record["disparities"]["from"] == "range maps"
    within = of_arrays.is_status("valid")
    assert (of_arrays.disparity[within] >= smallest[within] - 0.5).all()
    assert (of_arrays.disparity[within] <= largest[within] + 0.5).all()
    masked = np.ma.masked_array(np.nan_to_num(smallest), mask=np.isnan(smallest))
    assert same(sgm8.run(left, right, range_maps=(masked, largest)).disparity, of_files.disparity)


def test_pixels_are_explained_with_the_range_maps_of_their_run(grey_scene, sgm8, tmp_path):
    left, right = grey_scene.left, grey_scene.right
    smallest = np.full((120, 160), 2.0, np.float32)
    largest = smallest + np.arange(160, dtype=np.float32) % 7
    smallest[50:60, 20:40] = np.nan
    result = sgm8.run(left, right, range_maps=(smallest, largest))
    xgm.write_pfm(tmp_path / "min.pfm", smallest)
    xgm.write_pfm(tmp_path / "max.pfm", largest)
    of_files = (tmp_path / "min.pfm", tmp_path / "max.pfm")
    for x, searched in ((80, [2, 5]), (30, None)):
        explanation = sgm8.explain(x, 55, left, right, range_maps=(smallest, largest))
        [level] = explanation.data["levels"]
        assert level["range"] == searched
        assert explanation.data["status"] == xgm.STATUS[result.status[55, x]]
        assert explanation.data == sgm8.explain(x, 55, left, right, range_maps=of_files).data
    with pytest.raises(xgm.Error, match="two arrays or two files"):
        sgm8.explain(80, 55, left, right, range_maps=(smallest,))


@pytest.mark.parametrize("maps, words", [
    ((np.zeros((120, 160)),), "two arrays or two files"),
    ((np.zeros((120, 160)), "max.pfm"), "one is a file"),
    ((np.zeros((120, 160)), np.ones((119, 160))), "range_maps[1]: is 160 x 119"),
    ((np.zeros((20, 30)), np.ones((20, 30))), "are 160 x 120"),
    ((np.ones((120, 160)), np.zeros((120, 160))), "is the smallest given first?"),
    ((np.zeros(160), np.ones(160)), "range_maps[0]: has shape (160)"),
])
def test_range_maps_that_cannot_be_are_said(grey_scene, sgm8, maps, words):
    with pytest.raises(xgm.Error, match=re.escape(words)):
        sgm8.run(grey_scene.left, grey_scene.right, range_maps=maps)
