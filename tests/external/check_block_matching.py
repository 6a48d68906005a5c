# SPDX-License-Identifier: Apache-2.0
"""The example of docs/external.md matches pairs whose disparity is known.

check_block_matching.py numpy|opencv: by its own lines, or by OpenCV's StereoBM.
"""
import importlib.util
import json
import pathlib
import sys
import tempfile

SKIPPED = 77


def skip(what, package):
    print(f"SKIPPED: {what} needs {package}")
    sys.exit(SKIPPED)


try:
    import numpy as np
except ImportError:
    skip("the example of docs/external.md", "numpy (python3-numpy)")

EXAMPLE = pathlib.Path(__file__).parent / "block_matching.py"
SHIFT = 5  # px
WITH_OPENCV = sys.argv[1] == "opencv"


def load_example():
    spec = importlib.util.spec_from_file_location("block_matching", EXAMPLE)
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    if not WITH_OPENCV:
        example.cv2 = None
    elif example.cv2 is None:
        skip("StereoBM in the example of docs/external.md", "cv2 (python3-opencv)")
    else:
        example.with_numpy = None  # which must not be what is tested
    return example


def matched(example, levels, first, last):
    """What the example answers to a pair that is SHIFT px apart."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        np.save(folder / "base.npy", levels)
        np.save(folder / "match.npy", np.roll(levels, -SHIFT, axis=1))  # x - 5 shows what x does
        (folder / "request.json").write_text(json.dumps({
            "xgm_exchange": 1, "view": "left", "disparities": [first, last],
            "base": {"image": "base.npy"}, "match": {"image": "match.npy"}}))
        sys.argv = ["block_matching.py", str(folder / "request.json")]
        example.main()
        return np.load(folder / "disparity.npy")


def check(example, shape, first, last):
    levels = np.random.default_rng(1).integers(0, 256, shape).astype(np.float32)
    disparity = matched(example, levels, first, last)
    assert disparity.dtype == np.float32 and disparity.shape == shape[:2]
    inner = disparity[8:-8, 40:-40]  # windows are whole there, and the other image shows all
    assert np.isfinite(inner).mean() > 0.95, np.isfinite(inner).mean()
    assert (np.abs(inner[np.isfinite(inner)] - SHIFT) <= 2 / 16).all()  # StereoBM: in sixteenths


example = load_example()
for shape in ((80, 120), (80, 120, 3)):
    check(example, shape, -2, 9)  # not a multiple of 16, and some below 0
    check(example, shape, 0, 31)
