# SPDX-License-Identifier: Apache-2.0
"""The model of simulate.py beside what follows from its definition where that is plain."""
import copy
import json
import unittest

import simulate

MEASURED = json.loads((simulate.HERE / "measured.json").read_text())


def plain(**cluster):
    """Of equal tiles, without anything that a cluster adds but what is given."""
    inputs = copy.deepcopy(MEASURED)
    inputs["tile"]["spread"] = [1.0]
    inputs["cluster"] = {
        "workers_per_node": 1,
        "dispatched_per_second": 1e9,
        "server_bytes_per_second": 1e15,
        "link_bytes_per_second": 1e15,
        "straggler": {"share": 0, "factor": 1},
        **cluster,
    }
    return inputs


def ends(inputs, seconds, workers, fetch_bytes=0):
    server = simulate.FileServer(inputs["cluster"])
    return simulate.run_jobs(seconds, workers, 0.0, inputs, fetch_bytes, server)


class Model(unittest.TestCase):
    def test_one_worker_does_one_job_after_the_other(self):
        end, spent = ends(plain(), [3.0, 1.0, 2.0], 1)
        self.assertAlmostEqual(end, 6, places=5)
        self.assertAlmostEqual(spent, 6, places=5)

    def test_with_a_worker_for_each_job_the_longest_decides(self):
        end, spent = ends(plain(), [3.0, 1.0, 2.0], 3)
        self.assertAlmostEqual(end, 3, places=5)
        self.assertAlmostEqual(spent, 6, places=5)

    def test_workers_wait_for_the_scheduler(self):
        end, _ = ends(plain(dispatched_per_second=2), [0.1] * 10, 1000)
        self.assertAlmostEqual(end, 10 / 2 + 0.1, places=5)

    def test_nodes_share_the_file_server_and_fetch_once(self):
        inputs = plain(server_bytes_per_second=100, link_bytes_per_second=100, workers_per_node=2)
        self.assertAlmostEqual(ends(inputs, [1.0] * 2, 2, 100)[0], 2, places=5)
        self.assertAlmostEqual(ends(inputs, [1.0] * 6, 2, 100)[0], 4, places=5)
        self.assertAlmostEqual(ends(inputs, [1.0] * 4, 4, 100)[0], 3, places=5)

    def test_a_run_is_fit_and_coarse_then_tiles_then_join(self):
        inputs = plain()
        for preprocess in ("ransac_deskew", "none"):
            run = simulate.simulate(inputs, 100, 1, preprocess)
            start = inputs["job"]["start_seconds"]
            first = start + simulate.coarse_seconds(inputs, 100, preprocess)
            if preprocess != "none":
                fit = inputs["fit"]
                first += start + fit["seconds_per_megapixel"] * fit["most_megapixels"]
            tiles = simulate.tile_count(100, inputs["tile"]["side"])
            join = start + inputs["join"]["seconds_per_megapixel"] * 100
            job = inputs["job"]
            share = (1.5 * inputs["tile"]["side"] + 2 * inputs["tile"]["halo"]) / 10_000  # of the rows
            before = job["seconds_of_tile"]
            before += job["seconds_per_coarse_megapixel"] * 100 / 8**2 * share
            matching = tiles * before + inputs["tile"]["seconds_per_megapixel"] * 100
            self.assertAlmostEqual(run.parts["first"], first, places=4)
            self.assertAlmostEqual(run.parts["tiles"], matching, places=4)
            self.assertAlmostEqual(run.seconds, first + matching + join, places=4)
            self.assertAlmostEqual(run.worker_seconds, run.seconds, places=4)

    def test_the_measured_run_is_the_same_each_time_and_no_slower_with_more_workers(self):
        runs = [simulate.simulate(MEASURED, 400, workers).seconds for workers in (1, 16, 128)]
        self.assertEqual(runs[2], simulate.simulate(MEASURED, 400, 128).seconds)
        self.assertGreater(runs[0], runs[1])
        self.assertGreater(runs[1], runs[2])

    def test_coarse_levels_are_the_finest_that_are_small_enough_or_the_coarsest(self):
        coarse = {"most_megapixels": 4, "coarsest_scale": 8}
        for megapixels, small in ((1, 1 / 4), (16, 4), (17, 17 / 16), (1000, 1000 / 64)):
            self.assertEqual(simulate.coarse_megapixels(megapixels, coarse), small)

    def test_one_worker_takes_no_longer_than_one_process_but_for_starts_coarse_maps_and_the_join(self):
        inputs = plain()
        jobs = simulate.simulate(inputs, 100, 1)
        tiles = simulate.tile_count(100, inputs["tile"]["side"])
        plan = inputs["plan"]["seconds_per_megapixel"] * 100
        one = simulate.one_process_seconds(inputs, 100) - plan
        more = tiles * simulate.before_tile_seconds(inputs, 100) + inputs["job"]["start_seconds"]
        self.assertAlmostEqual(jobs.seconds - jobs.parts["join"] - one, more, places=3)

    def test_square_images_are_cut_into_squares(self):
        self.assertEqual(simulate.tile_count(100, 2000), 25)
        self.assertEqual(simulate.tile_count(100.1, 2000), 36)
        self.assertEqual(simulate.tile_count(1, 2000), 1)


if __name__ == "__main__":
    unittest.main()
