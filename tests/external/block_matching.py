# SPDX-License-Identifier: Apache-2.0
"""A matcher for stages of type external (docs/external.md): block matching.

It is called with the path of request.json, reads the images beside it, and writes disparity.npy
there. With cv2 (python3-opencv) it is OpenCV's StereoBM, else a few lines of numpy.
"""
import json
import pathlib
import sys

import numpy as np

try:
    import cv2
except ImportError:
    cv2 = None

BLOCK = 9  # px


def grey(levels):
    """Of an array of grey levels, or of red, green and blue."""
    return levels if levels.ndim == 2 else levels @ np.float32([0.299, 0.587, 0.114])


def block_sums(values):
    """Sums of the blocks around all pixels; the border is repeated."""
    half = BLOCK // 2
    padded = np.pad(values, ((half + 1, half), (half + 1, half)), mode="edge")
    sums = padded.cumsum(0, dtype=np.float64).cumsum(1)
    return sums[BLOCK:, BLOCK:] - sums[:-BLOCK, BLOCK:] - sums[BLOCK:, :-BLOCK] + sums[:-BLOCK, :-BLOCK]


def with_numpy(base, match, first, last):
    """The disparity whose block differs least; NaN where nothing can be seen."""
    best = np.full(base.shape, np.inf)
    found = np.full(base.shape, np.nan, np.float32)
    width = base.shape[1]
    for d in range(first, last + 1):
        columns = np.arange(width) - d
        seen = (columns >= 0) & (columns < width)
        if not seen.any():
            continue
        shifted = match[:, columns.clip(0, width - 1)]
        cost = block_sums(np.abs(base - shifted))
        better = seen & (cost < best)
        best[better] = cost[better]
        found[better] = d
    return found


def with_opencv(base, match, first, last):
    count = (last - first + 16) // 16 * 16  # StereoBM wants a multiple of 16
    matcher = cv2.StereoBM_create(count, BLOCK)
    matcher.setMinDisparity(first)
    sixteenths = matcher.compute(base.round().astype(np.uint8), match.round().astype(np.uint8))
    disparity = sixteenths.astype(np.float32) / 16
    disparity[disparity < first] = np.nan
    return disparity


def main():
    request_file = pathlib.Path(sys.argv[1])
    folder = request_file.parent
    request = json.loads(request_file.read_text())
    if request["xgm_exchange"] != 1:
        sys.exit("this program knows version 1 of the exchange only")
    base = grey(np.load(folder / request["base"]["image"]))
    match = grey(np.load(folder / request["match"]["image"]))
    first, last = request["disparities"]
    compute = with_opencv if cv2 and min(base.shape) > BLOCK else with_numpy
    disparity = compute(base, match, first, last)
    print(f"{request['view']} view, {np.isfinite(disparity).mean():.0%} matched")
    np.save(folder / "disparity.npy", disparity.astype(np.float32))


if __name__ == "__main__":
    main()
