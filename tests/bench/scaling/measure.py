# SPDX-License-Identifier: Apache-2.0
"""What the jobs of a scene in tiles take, as inputs of simulate.py.

Seconds are those of the processor, with one thread: what else the machine does matters little.

    measure.py PROGRAM LEFT RIGHT DISPARITIES WORK_DIR [--tile 1000] [--pipeline tmgm16_refined]
"""
import argparse
import json
import resource
import subprocess
from pathlib import Path


def processor_seconds(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def plan(options, work, tile, *more):
    pair = ["--left", options.left, "--right", options.right, "--threads", 1]
    command = [options.program, "tiles", "plan", *more, *pair, "--tiles", f"{tile}x{tile}"]
    subprocess.run([str(part) for part in [*command, "-o", work]], check=True)
    return json.loads((work / "manifest.json").read_text())


def job_seconds(options, work, name):
    return processor_seconds(options.program, "tiles", "run", work / "manifest.json", name)


def look_seconds(options, preprocess):
    """Of a job that matches next to nothing: one disparity of the smallest tile."""
    work = options.work / ("look_" + (preprocess or "plain"))
    arguments = ["sgm8", "--disparities", "0:0", "--set", f"preprocess=[{preprocess}]"]
    plan(options, work, 64, *arguments)
    return job_seconds(options, work, "tile_1_1")


def measure(options):
    work = options.work / "matched"
    manifest = plan(options, work, options.tile, options.pipeline, "--disparities",
                    options.disparities)
    megapixels = manifest["size"][0] * manifest["size"][1] / 1e6
    start = processor_seconds(options.program, "--version")
    look = look_seconds(options, "ransac_deskew")
    plain = look_seconds(options, "")
    coarse = job_seconds(options, work, "coarse")
    tiles = [job for job in manifest["jobs"] if "place" in job]
    seconds = [job_seconds(options, work, job["name"]) - look for job in tiles]
    areas = [job["place"][2] * job["place"][3] / 1e6 for job in tiles]
    join = processor_seconds(options.program, "tiles", "join", work / "manifest.json")
    return {
        "megapixels": megapixels,
        "start_seconds": start,
        "look_seconds": look,
        "look_seconds_without_deskew": plain,
        "coarse_seconds_after_look": coarse - look,
        "tile_seconds_after_look_per_megapixel": [s / a for s, a in zip(seconds, areas)],
        "join_seconds": join,
        "image_bytes": sum(Path(file).stat().st_size for file in (options.left, options.right)),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    for name in ("program", "left", "right", "disparities"):
        parser.add_argument(name)
    parser.add_argument("work", type=Path)
    parser.add_argument("--tile", type=int, default=1000)
    parser.add_argument("--pipeline", default="tmgm16_refined")
    print(json.dumps(measure(parser.parse_args()), indent=2))


if __name__ == "__main__":
    main()
