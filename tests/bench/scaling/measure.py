# SPDX-License-Identifier: Apache-2.0
"""What the jobs of a scene in tiles take, as inputs of simulate.py.

Seconds are those of the processor, with one thread: what else the machine does matters little.

    measure.py PROGRAM LEFT RIGHT DISPARITIES WORK_DIR [--tile 1000] [--pipeline tmgm16_refined]
        [--first-jobs-only]
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
    """The manifest, and what planning took."""
    pair = ["--left", options.left, "--right", options.right, "--threads", 1]
    seconds = processor_seconds(options.program, "tiles", "plan", *more, *pair,
                                "--tiles", f"{tile}x{tile}", "-o", work)
    return json.loads((work / "manifest.json").read_text()), seconds


def job_seconds(options, work, name):
    return processor_seconds(options.program, "tiles", "run", work / "manifest.json", name)


def idle_seconds(options, name, *arguments):
    """Of the jobs before the tiles, and of a tile, that match next to nothing: one disparity, in the
    smallest tile."""
    work = options.work / name
    manifest, _ = plan(options, work, 64, *arguments, "--disparities", "0:0")
    last = manifest["jobs"][-1]
    seconds = {before: job_seconds(options, work, before) for before in last["needs"]}
    return {**seconds, "tile": job_seconds(options, work, last["name"])}


def tiles_measured(options, work, jobs, idle):
    """Seconds of the tiles for each of their megapixels, and of the join."""
    tiles = [job for job in jobs if "place" in job]
    areas = [job["place"][2] * job["place"][3] / 1e6 for job in tiles]
    seconds = [job_seconds(options, work, job["name"]) - idle for job in tiles]
    join = processor_seconds(options.program, "tiles", "join", work / "manifest.json")
    return {
        "tile_seconds_per_megapixel": [own / area for own, area in zip(seconds, areas)],
        "join_seconds": join,
    }


def measure(options):
    work = options.work / "matched"
    arguments = [options.pipeline, "--disparities", options.disparities]
    manifest, planning = plan(options, work, options.tile, *arguments)
    megapixels = manifest["size"][0] * manifest["size"][1] / 1e6
    idle_coarse = {
        name: idle_seconds(options, name, "tsgm8", "--set", f"preprocess=[{stages}]")["coarse"]
        for name, stages in (("ransac_deskew", "ransac_deskew"), ("none", ""))
    }
    flat = idle_seconds(options, "flat", "sgm8")["tile"]
    firsts = [job["name"] for job in manifest["jobs"] if "place" not in job]
    measured = {
        "megapixels": megapixels,
        "plan_seconds": planning,
        "start_seconds": processor_seconds(options.program, "--version"),
        "idle_tile_seconds": flat,
        "idle_coarse_seconds": idle_coarse,
        **{name + "_seconds": job_seconds(options, work, name) for name in firsts},
        "image_bytes": sum(Path(file).stat().st_size for file in (options.left, options.right)),
    }
    if not options.first_jobs_only:
        measured.update(tiles_measured(options, work, manifest["jobs"], flat))
    return measured


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    for name in ("program", "left", "right", "disparities"):
        parser.add_argument(name)
    parser.add_argument("work", type=Path)
    parser.add_argument("--tile", type=int, default=1000)
    parser.add_argument("--pipeline", default="tmgm16_refined")
    parser.add_argument("--first-jobs-only", action="store_true", help="no tiles, no join")
    print(json.dumps(measure(parser.parse_args()), indent=2))


if __name__ == "__main__":
    main()
