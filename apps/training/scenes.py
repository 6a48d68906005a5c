# SPDX-License-Identifier: Apache-2.0
"""Scenes to train on: generated ones, and others with ground truth."""
import pathlib
import random
import subprocess

import numpy as np

# Each fault with the values that it is drawn between: from hardly visible to about the worst that
# photographs of one pair have. Those that a matcher cannot survive teach nothing.
FAULTS = {
    "weak_texture": [(0.7, 0.98), (0.2, 1.0)],
    "repetitive": [(0.5, 0.9), (8, 24)],
    "shadow": [(0.2, 0.8)],
    "highlight": [(0.3, 1.2)],
    "blur": [(0.3, 1.0)],
    "vignetting": [(0.2, 0.8)],
    "exposure": [(0.6, 1.6), (-10, 10)],
    "noise": [(1, 6)],
    "gamma": [(0.7, 1.5)],
    "vertical": [(-0.002, 0.002), (-0.002, 0.002), (-0.7, 0.7)],
}


def generated(program, folder, count, seed):
    """Generates `count` scenes below `folder`; returns their folders."""
    return [generate(program, pathlib.Path(folder) / f"scene_{seed + k}", seed + k)
            for k in range(count)]


def generate(program, folder, seed):
    """One scene, which depends on `seed` alone. A scene that is there already stays."""
    scene = folder / "scene_0001"
    if scene.exists():
        return scene
    draw = random.Random(seed)

    def between(low, high):  # random() is the same in all versions of Python; other draws are not
        return low + (high - low) * draw.random()

    options = ["--size", f"{int(between(320, 520))}x{int(between(260, 400))}",
               "--disparities", f"{int(between(0, 12))}:{int(between(36, 76))}",
               "--objects", str(int(between(4, 32))), "--seed", str(seed)]
    share = 0.25 if seed % 3 == 0 else 0.06  # most photographs of a pair have few faults
    faults = [f"{name}=" + ",".join(f"{between(*bounds):.4f}" for bounds in values)
              for name, values in FAULTS.items() if draw.random() < share]
    # Some of the weakest textures in every second scene: that is where matchers differ most.
    if seed % 2 == 0 and not any(fault.startswith("weak_texture") for fault in faults):
        faults.append(f"weak_texture={between(0.9, 0.99):.4f},{between(0.3, 0.8):.4f}")
    command = [program, "synth", str(folder), *options]
    subprocess.run(command + (["--fault", *faults] if faults else []), check=True,
                   stdout=subprocess.DEVNULL)
    return scene


def found(folders):
    """The scenes in these folders: folders that hold a truth."""
    scenes = []
    for folder in map(pathlib.Path, folders):
        scenes += sorted(truth.parent for truth in folder.rglob("disp0GT.pfm"))
    return scenes


def read_truth(scene):
    """True disparities of a scene, px, NaN where they are not known; and whether both views show
    the pixel, which is taken for granted if there is no truth of the right view."""
    left = read_pfm(scene / "disp0GT.pfm")
    if not (scene / "disp1GT.pfm").exists():
        return left, np.ones(left.shape, bool)
    right = read_pfm(scene / "disp1GT.pfm")
    row, column = np.indices(left.shape)
    there = np.nan_to_num(np.round(column - left), nan=-1).astype(int)
    inside = (there >= 0) & (there < left.shape[1])
    seen = right[row, np.where(inside, there, 0)]
    return left, inside & (np.abs(seen - left) <= 1)


def read_pfm(path):
    """A map, NaN where it has no value. The bottom row comes first."""
    with open(path, "rb") as file:
        if file.readline().strip() != b"Pf":
            raise SystemExit(f"{path}: is no PFM of one channel")
        width, height = map(int, file.readline().split())
        order = "<f4" if float(file.readline()) < 0 else ">f4"
        values = np.frombuffer(file.read(), order).reshape(height, width)[::-1]
    return np.where(np.isfinite(values), values, np.nan).astype(np.float32)
