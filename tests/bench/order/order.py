# SPDX-License-Identifier: Apache-2.0
"""The paper's eight variants on the same scenes at three sizes: does their order depend on the size?

    order.py PROGRAM SHRINK WORK_DIR [--seeds 11,12,13] [--aloe DIR]

PROGRAM is build/release/bin/pipeline, SHRINK build/release/bin/xgm_bench_shrink. Scenes of 6 MP are
generated; with --aloe (the folder that `make demo` leaves, build/aloe) a photographed pair is added.
Prints a table of each set of scenes. What was measured stays in WORK_DIR and is not measured again.
"""
import argparse
import json
import resource
import subprocess
from pathlib import Path

VARIANTS = ["sgm8", "sgm16", "mgm8", "mgm16", "tsgm8", "tsgm16", "tmgm8", "tmgm16"]
FACTORS = [4, 2, 1]
SIZE = "2944x1984"
DISPARITIES = 256
TOTALS = ["total_0.5", "total_1", "total_2"]


def run(*command):
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL)


def generated_scenes(options):
    """Name and folder of each."""
    for seed in options.seeds:
        folder = options.work / "whole" / f"seed_{seed}"
        if not (folder / "scene_0001").exists():
            run(options.program, "synth", folder, "--size", SIZE,
                "--disparities", f"0:{DISPARITIES - 1}", "--seed", seed)
        yield f"seed_{seed}", folder / "scene_0001"


def aloe_scene(options):
    """Debian's pair has whole pixels of the full size, 0 where nothing is known."""
    folder = options.work / "whole" / "aloe"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "dataset.yaml").write_text(
        "type: folder\nleft: aloeL.jpg\nright: aloeR.jpg\ntruth: aloeGT.png\ntruth_divisor: 1\n"
        "disparities: [0, 223]\n")
    for name in ("aloeL.jpg", "aloeR.jpg", "aloeGT.png"):
        if not (folder / name).exists():
            (folder / name).symlink_to((options.aloe / name).resolve())
    yield "aloe", folder


def shrink(options, name, scenes):
    """Makes a data set of the scenes for each factor."""
    for scene, folder in scenes:
        for factor in FACTORS:
            smaller = options.work / f"{name}_{factor}" / scene
            if not smaller.exists():
                run(options.shrink, folder, factor, smaller)


def measured(options, scene, variant):
    """Errors of a variant, and the processor's seconds for reading, matching and judging."""
    output = options.work / "results" / scene.parent.name / scene.name / variant
    known = output / "measured.json"
    if known.exists():
        return json.loads(known.read_text())
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(options.program, "run", variant, scene, "--threads", 2, "-o", output)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    regions = json.loads((output / "run.json").read_text())["truth"]
    judged = next(region for region in regions if region["region"] == "non-occluded")
    found = {"invalid": 100 * judged["invalid"]}
    for threshold in judged["thresholds"]:
        for kind in ("total", "bad"):
            found[f"{kind}_{threshold['delta_px']:g}"] = 100 * threshold[kind]
    found["seconds"] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    known.write_text(json.dumps(found))
    return found


def mean(options, name, scenes, factor, variant):
    rows = [measured(options, options.work / f"{name}_{factor}" / scene, variant)
            for scene, _ in scenes]
    return {key: sum(row[key] for row in rows) / len(rows) for key in rows[0]}


def table(options, name, scenes):
    """Lines of Markdown: a row for each variant, columns for each size."""
    results = {(variant, factor): mean(options, name, scenes, factor, variant)
               for factor in FACTORS for variant in VARIANTS}
    sizes = ["full size" if factor == 1 else f"1/{factor}" for factor in FACTORS]
    yield f"| {name} | " + " | ".join(f"{size} | invalid | bad 1 | s" for size in sizes) + " |"
    yield "|---|" + "--:|" * 4 * len(FACTORS)
    for variant in VARIANTS:
        cells = [variant]
        for factor in FACTORS:
            row = results[variant, factor]
            cells.append(" / ".join(f"{row[error]:.2f}" for error in TOTALS))
            cells += [f"{row['invalid']:.2f}", f"{row['bad_1']:.2f}", f"{row['seconds']:.1f}"]
        yield "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    for name in ("program", "shrink", "work"):
        parser.add_argument(name, type=Path)
    parser.add_argument("--seeds", default="11,12,13",
                        type=lambda text: [int(seed) for seed in text.split(",")])
    parser.add_argument("--aloe", type=Path, help="folder of aloeL.jpg, aloeR.jpg and aloeGT.png")
    options = parser.parse_args()
    sets = {}
    if options.aloe:
        sets["aloe"] = list(aloe_scene(options))
    sets["generated"] = list(generated_scenes(options))
    for name, scenes in sets.items():
        shrink(options, name, scenes)
    for name, scenes in sets.items():
        print("\n".join(table(options, name, scenes)), end="\n\n", flush=True)


if __name__ == "__main__":
    main()
