# SPDX-License-Identifier: Apache-2.0
"""How the time of a scene in tiles falls with the number of workers, by simulation.

A run is `fit`, which looks at the whole scene, `coarse`, then all tiles, then the join. A job waits for
its turn at the scheduler, then for a worker; its node fetches the images from the file server once,
which all nodes share; a tile reads rows of the coarse maps, matches its window, and writes its part. What jobs
take was measured (measured.json), what a cluster adds is assumed (cluster in the same file). Nothing
else is in the model: no other users, no failing nodes, and not the plan, which comes before.

    simulate.py [--megapixels 6,100,400] [--workers 1,16,128,1000] [--preprocess none]
"""
import argparse
import heapq
import json
import math
import random
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent


@dataclass
class Result:
    seconds: float  # from the first job's begin to the end of the join
    worker_seconds: float  # that jobs take together, fetching included
    parts: dict  # seconds of the run that fit and coarse, tiles and join take


class FileServer:
    """Serves all that fetch in equal shares, none faster than its link.

    Fetches come in the order of time; each is as fast as those that are under way when it begins
    allow. So it is too slow by as much as the others end before it, which overestimates waiting by
    less than a factor of two and keeps the model small.
    """

    def __init__(self, cluster):
        self.total = cluster["server_bytes_per_second"]
        self.link = cluster["link_bytes_per_second"]
        self.ends = []  # of fetches that are under way

    def fetch(self, now, size):
        while self.ends and self.ends[0] <= now:
            heapq.heappop(self.ends)
        rate = min(self.link, self.total / (len(self.ends) + 1))
        end = now + size / rate
        heapq.heappush(self.ends, end)
        return end


def tile_count(megapixels, tile_side):
    """Of a square image; tiles are cut to about the same size."""
    side = math.sqrt(megapixels * 1e6)
    return math.ceil(side / tile_side) ** 2


def coarse_megapixels(megapixels, coarse):
    """Of the finest level that is matched as a whole, by the rule of framework/tiles."""
    scale = 2
    while scale < coarse["coarsest_scale"] and megapixels / scale**2 > coarse["most_megapixels"]:
        scale *= 2
    return megapixels / scale**2


def share_of_coarse(megapixels, tile):
    """Of the rows that a tile reads: its own and those of the halo, in strips half as high as tiles."""
    return min(1.0, (1.5 * tile["side"] + 2 * tile["halo"]) / math.sqrt(megapixels * 1e6))


def tile_seconds(inputs, megapixels, tiles, seed):
    """Drawn from the measured spread around the mean, which holds for the mean size of tiles."""
    draw = random.Random(seed)
    spread = inputs["tile"]["spread"]
    mean_spread = sum(spread) / len(spread)
    mean = inputs["tile"]["seconds_per_megapixel"] * megapixels / tiles
    slow = inputs["cluster"]["straggler"]
    seconds = []
    for _ in range(tiles):
        factor = draw.choice(spread) / mean_spread
        if draw.random() < slow["share"]:
            factor *= slow["factor"]
        seconds.append(mean * factor)
    return seconds


def fit_seconds(inputs, megapixels, preprocess):
    """Of what is looked for in the whole scene before anything is matched."""
    fit = inputs["fit"]
    looked_at = min(megapixels, fit["most_megapixels"])
    return fit["seconds_per_megapixel"] * looked_at if preprocess != "none" else 0.0


def coarse_seconds(inputs, megapixels, preprocess):
    """All of the images is read and made smaller, also changed as preprocess says; then matched."""
    coarse = inputs["coarse"]
    reading = coarse["seconds_per_megapixel_read"][preprocess] * megapixels
    return reading + coarse["seconds_per_megapixel"] * coarse_megapixels(megapixels, coarse)


def before_tile_seconds(inputs, megapixels):
    """Of each tile beside its matching: the program starts, and reads its rows of the coarse maps."""
    small = coarse_megapixels(megapixels, inputs["coarse"])
    small *= share_of_coarse(megapixels, inputs["tile"])
    return inputs["job"]["seconds_of_tile"] + inputs["job"]["seconds_per_coarse_megapixel"] * small


def run_jobs(seconds, workers, begin, inputs, fetch_bytes, server):
    """All may begin at `begin`; returns when the last has ended and what workers spent together."""
    cluster = inputs["cluster"]
    per_node = cluster["workers_per_node"]
    free = [(begin, worker) for worker in range(workers)]
    heapq.heapify(free)
    fetched = {}  # node: when it has the images
    last = begin
    spent = 0.0
    for index, own in enumerate(seconds):
        dispatched = begin + (index + 1) / cluster["dispatched_per_second"]
        idle, worker = heapq.heappop(free)
        start = max(idle, dispatched)
        node = worker // per_node
        if node not in fetched:
            fetched[node] = server.fetch(start, fetch_bytes)
        end = max(start, fetched[node]) + own
        spent += end - start
        last = max(last, end)
        heapq.heappush(free, (end, worker))
    return last, spent


def simulate(inputs, megapixels, workers, preprocess="ransac_deskew", seed=1):
    tiles = tile_count(megapixels, inputs["tile"]["side"])
    image_bytes = inputs["job"]["image_bytes_per_megapixel"] * megapixels
    start = inputs["job"]["start_seconds"]
    server = FileServer(inputs["cluster"])
    first = [start + coarse_seconds(inputs, megapixels, preprocess)]
    if preprocess != "none":
        first.insert(0, start + fit_seconds(inputs, megapixels, preprocess))
    first_end, spent = run_jobs(first, 1, 0.0, inputs, image_bytes, server)
    before = before_tile_seconds(inputs, megapixels)
    jobs = [before + own for own in tile_seconds(inputs, megapixels, tiles, seed)]
    tiles_end, spent_by_tiles = run_jobs(jobs, workers, first_end, inputs, image_bytes, server)
    join = start + inputs["join"]["seconds_per_megapixel"] * megapixels
    end = tiles_end + join
    return Result(
        seconds=end,
        worker_seconds=spent + spent_by_tiles + join,
        parts={"first": first_end, "tiles": tiles_end - first_end, "join": join},
    )


def one_process_seconds(inputs, megapixels, preprocess="ransac_deskew"):
    """Of `pipeline run --tiles` with one thread, which looks at the images itself and joins nothing."""
    looks = inputs["plan"]["seconds_per_megapixel"] * megapixels
    looks += fit_seconds(inputs, megapixels, preprocess)
    coarse = coarse_seconds(inputs, megapixels, preprocess)
    tiles = inputs["tile"]["seconds_per_megapixel"] * megapixels
    return inputs["job"]["start_seconds"] + looks + coarse + tiles


def numbers(text):
    return [float(number) for number in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--inputs", default=HERE / "measured.json")
    parser.add_argument("--megapixels", type=numbers, default=[6, 25, 100, 400, 2500])
    parser.add_argument("--workers", type=numbers, default=[1, 16, 128, 1000])
    parser.add_argument(
        "--preprocess",
        choices=["ransac_deskew", "none"],
        default="ransac_deskew",
        help="what is done to the images",
    )
    options = parser.parse_args()
    inputs = json.loads(Path(options.inputs).read_text())
    head = ["MP", "jobs", "one process"] + [f"{workers:g} workers" for workers in options.workers]
    print("| " + " | ".join(head) + " |")
    print("|---:" * len(head) + "|")
    for megapixels in options.megapixels:
        one = one_process_seconds(inputs, megapixels, options.preprocess)
        jobs = tile_count(megapixels, inputs["tile"]["side"]) + 2
        jobs += options.preprocess != "none"
        row = [f"{megapixels:g}", jobs, f"{one:.0f} s"]
        for workers in map(int, options.workers):
            run = simulate(inputs, megapixels, workers, options.preprocess)
            parts = " + ".join(f"{part:.0f}" for part in run.parts.values())
            row.append(f"{run.seconds:.0f} s = {parts}; {one / run.seconds:.1f}x")
        print("| " + " | ".join(map(str, row)) + " |")


if __name__ == "__main__":
    main()
