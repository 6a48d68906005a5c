# SPDX-License-Identifier: Apache-2.0
"""What a selection gives that picks among the winners of the single directions (SGM-Forest).

    /usr/bin/python3 directions.py PROGRAM WINNERS WORK_DIR SCENES_DIR

PROGRAM is build/release/bin/pipeline, WINNERS build/release/bin/xgm_bench_winners. Trains a forest
on generated scenes, judges it on the scenes of SCENES_DIR (folders with disp0GT.pfm and
mask0nocc.png), and prints tables: shares of wrong pixels as they are selected, then after the
median filter and the left-right check of pipeline sgm8. Needs scikit-learn and OpenCV's Python
module. Winners stay in WORK_DIR and are not computed again.
"""
import argparse
import pathlib
import subprocess
import sys

import cv2
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[3] / "apps" / "training"))
import forest  # noqa: E402
import scenes  # noqa: E402

PENALTY = "{type: canny, p1: 24, p2_edge: 27, p2: 96}"  # of sgm8
HALF_WEIGHT = ("PianoL", "Playtable")  # in averages of the benchmark
NONE = -32768
# Direction k of the right view, seen in a mirror, is direction MIRRORED[k] of the left one.
MIRRORED = [4, 1, 3, 2, 0, 5, 7, 6]
PARTS = ("paths", "support", "windows")  # of the features, see features_of()


def options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("winners")
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("scenes")
    parser.add_argument("--penalty", default=PENALTY, help="YAML of the penalty stage")
    parser.add_argument("--generated", type=int, default=45, help="scenes to train on")
    parser.add_argument("--trees", type=int, default=16)
    parser.add_argument("--without", nargs="*", choices=PARTS, default=[],
                        help="features to leave out")
    return parser.parse_args()


def winners_of(scene, chosen):
    """Records of both views; the right one in a mirror, so that it looks like a left one."""
    folder = chosen.work / "winners" / chosen.penalty / str(scene.resolve()).replace("/", "_")
    if not (folder / "right.npy").exists():
        subprocess.run([chosen.winners, str(scene), chosen.penalty, str(folder)], check=True)
    left, right = np.load(folder / "left.npy"), np.load(folder / "right.npy")[:, ::-1].copy()
    order = [0] + [1 + k for k in MIRRORED]
    disparities = right["disparities"][..., order]
    right["disparities"] = np.where(disparities == NONE, NONE, -disparities)
    for name in ("sums", "costs"):
        right[name] = right[name][..., order]
    right["paths"] = right["paths"][..., order, :][..., MIRRORED]
    return left, right


def share_around(disparities, radius, stride):
    """Share of the winners of the sums around each pixel that each candidate is within 1 px of."""
    sums = np.pad(disparities[..., 0], radius, mode="edge")
    height, width = disparities.shape[:2]
    steps = range(0, 2 * radius + 1, stride)
    near = [np.abs(disparities - sums[v:v + height, u:u + width, None]) <= 1
            for v in steps for u in steps]
    return np.mean(near, axis=0) * 255


def features_of(records, without):
    """Bytes, of each pixel: what each candidate is less the winner of the sums, its sum and cost,
    its cost along each path; how many directions are within 1 px of it, and how many pixels
    near by."""
    disparities = records["disparities"].astype(np.int32)
    parts = [np.clip(disparities[..., 1:] - disparities[..., :1], -127, 127) + 128,
             records["sums"][..., 1:] // 2, records["costs"]]
    if "paths" not in without:
        paths = records["paths"]
        parts += [paths.reshape(*paths.shape[:2], -1), paths.min(-1), paths.max(-1)]
    if "support" not in without:
        parts.append(np.sum(np.abs(disparities[..., None, 1:] - disparities[..., None]) <= 1, -1))
    if "windows" not in without:
        parts += [share_around(disparities, 2, 1), share_around(disparities, 5, 2)]
    return np.concatenate([np.minimum(part, 255).astype(np.uint8) for part in parts], axis=-1)


def samples_of(scene, chosen):
    """Pixels of the left view whose candidates differ and whose truth is known."""
    records, _ = winners_of(scene, chosen)
    truth, visible = scenes.read_truth(scene)
    used = np.isfinite(truth) & visible & disputed(records)
    errors = np.abs(records["disparities"].astype(np.float32) - truth[..., None])[used]
    return forest.Samples(scene.name, 0, features_of(records, chosen.without)[used], errors,
                          visible[used])


def disputed(records):
    disparities = records["disparities"]
    return (disparities[..., 0] != NONE) & (disparities.max(-1) > disparities.min(-1))


def selections(records, model, chosen):
    """The map of each way to select. A mean is that of the candidates within 1 px."""
    disparities = records["disparities"].astype(np.float64)
    scores = np.ones(disparities.shape)
    asked = disputed(records)
    scores[asked] = np.maximum(model.predict(features_of(records, chosen.without)[asked]), 0) + 1e-6

    def picked(choice):
        return np.take_along_axis(disparities, choice[..., None], -1)[..., 0]

    def mean(pick, weights):
        weights = weights * (np.abs(disparities - pick[..., None]) <= 1)
        return np.sum(weights * disparities, -1) / np.sum(weights, -1)

    # Where nothing is disputed all scores are equal, and the first is taken.
    pick = picked(scores.argmax(-1))
    maps = {"wta": disparities[..., 0],
            "wta, mean": mean(disparities[..., 0], np.ones(disparities.shape)),
            "forest": pick, "forest, mean": mean(pick, scores)}
    missing = records["disparities"][..., 0] == NONE
    return {name: np.where(missing, np.nan, values) for name, values in maps.items()}


def checked(left, right):
    """Medians of 3x3 of both views; NaN where they differ by more than 1 px. `right` is mirrored.
    """
    maps = [cv2.medianBlur(values.astype(np.float32), 3) for values in (left, right)]
    other = maps[1][:, ::-1]
    row, column = np.indices(left.shape)
    there = np.nan_to_num(np.round(column - maps[0]), nan=-1).astype(int)
    inside = (there >= 0) & (there < left.shape[1])
    seen = other[row, np.where(inside, there, 0)]
    return np.where(inside & (np.abs(maps[0] - seen) <= 1), maps[0], np.nan)


def judged_truth(scene):
    truth = scenes.read_pfm(scene / "disp0GT.pfm")
    mask = cv2.imread(str(scene / "mask0nocc.png"), cv2.IMREAD_GRAYSCALE)
    return np.where(mask == 255, truth, np.nan)


def wrong(disparities, truth):
    """Shares of wrong or missing pixels at each threshold."""
    known = np.isfinite(truth)
    errors = np.nan_to_num(np.abs(disparities[known] - truth[known]), nan=np.inf)
    return [100 * np.mean(errors > bound) for bound in forest.THRESHOLDS]


def judge(scene, model, chosen):
    """Shares of wrong pixels of each way to select: as selected, and after filter and check."""
    views = winners_of(scene, chosen)
    truth = judged_truth(scene)
    left, right = (selections(records, model, chosen) for records in views)
    candidates = views[0]["disparities"].astype(np.float64)
    errors = np.abs(candidates - truth[..., None])
    alone = [wrong(candidates[..., 1 + k], truth) for k in range(8)]
    selected = {"best single direction": min(alone, key=lambda shares: shares[1])}
    selected |= {name: wrong(values, truth) for name, values in left.items()}
    best = np.take_along_axis(candidates, errors.argmin(-1)[..., None], -1)[..., 0]
    selected["best choice"] = wrong(best, truth)
    return selected, {name: wrong(checked(left[name], right[name]), truth) for name in left}


def print_table(title, names, rows):
    weights = [0.5 if name in HALF_WEIGHT else 1 for name in names]
    print(f"\n{title}\n\n| | 0.5 px | 1 px | 2 px |\n|---|--:|--:|--:|")
    for way in rows[0]:
        shares = np.average([row[way] for row in rows], axis=0, weights=weights)
        print(f"| {way} | " + " | ".join(f"{share:.2f}" for share in shares) + " |")


def main():
    chosen = options()
    training = scenes.generated(chosen.program, chosen.work / "scenes", chosen.generated, 1)
    samples = [samples_of(scene, chosen) for scene in training]
    model = forest.train(samples, 1, chosen.trees, hidden=0)
    print(f"{len(samples)} scenes, {samples[0].features.shape[1]} features, {chosen.trees} trees, "
          f"{chosen.penalty}", flush=True)
    judges = scenes.found([chosen.scenes])
    names = [scene.name for scene in judges]
    selected, after = zip(*(judge(scene, model, chosen) for scene in judges))
    shares = [100 * np.mean(disputed(winners_of(scene, chosen)[0])) for scene in judges]
    print(f"Candidates differ at {np.mean(shares):.1f} % of the pixels of the left views")
    print_table("As selected, share of wrong pixels in %", names, selected)
    print_table("After median filter and left-right check", names, after)


if __name__ == "__main__":
    main()
