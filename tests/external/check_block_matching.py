# SPDX-License-Identifier: Apache-2.0
"""The example of docs/external.md matches a pair whose disparity is known, with numpy alone."""
import importlib.util
import json
import pathlib
import sys
import tempfile

SKIPPED = 77

try:
    import numpy as np
except ImportError:
    print("SKIPPED: the example of docs/external.md needs numpy")
    sys.exit(SKIPPED)

EXAMPLE = pathlib.Path(__file__).parent / "block_matching.py"


def check(colour):
    spec = importlib.util.spec_from_file_location("block_matching", EXAMPLE)
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    example.cv2 = None
    shape = (40, 60, 3) if colour else (40, 60)
    levels = np.random.default_rng(1).integers(0, 256, shape).astype(np.float32)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        np.save(folder / "base.npy", levels)
        np.save(folder / "match.npy", np.roll(levels, -5, axis=1))  # x - 5 shows what x does
        (folder / "request.json").write_text(json.dumps({
            "xgm_exchange": 1, "view": "left", "disparities": [-2, 9],
            "base": {"image": "base.npy"}, "match": {"image": "match.npy"}}))
        sys.argv = ["block_matching.py", str(folder / "request.json")]
        example.main()
        disparity = np.load(folder / "disparity.npy")
    assert disparity.dtype == np.float32 and disparity.shape == (40, 60)
    assert (disparity[:, 12:-12] == 5).all()


check(colour=False)
check(colour=True)
