# SPDX-License-Identifier: Apache-2.0
"""What forests are trained on and how they are judged (apps/training), by samples made by hand."""
import pathlib
import sys
import tempfile
import unittest

SKIPPED = 77
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "apps" / "training"))

try:
    import numpy as np

    import forest
    import scenes
except ImportError as missing:
    print(f"SKIPPED: apps/training needs numpy and scikit-learn (python3-sklearn): {missing}")
    sys.exit(SKIPPED)


def samples(visible, hidden, name="scene"):
    """Matcher 1 is right where both views show the pixel, matcher 2 where one hides it; the first
    feature tells which it is, the second nothing. One more pixel of each kind teaches nothing."""
    shown = np.repeat([True, False], [visible + 1, hidden + 1])
    errors = np.where(np.stack([shown, ~shown], 1), 0.0, 9.0)
    errors[[0, -1]] = 9.0
    nothing = np.arange(len(shown)) % 7
    features = np.stack([np.where(shown, 10, 200), nothing], 1).astype(np.uint8)
    return forest.Samples(name, 0, features, errors, shown)


def write_pfm(file, rows):
    values = np.array(rows, "<f4")
    file.write_bytes(b"Pf\n%d %d\n-1\n" % values.shape[::-1] + values[::-1].tobytes())


class Drawn(unittest.TestCase):
    def drawn(self, part, hidden):
        kept = forest.drawn(part, hidden, np.random.RandomState(1))
        return part.visible[kept].sum(), (~part.visible[kept]).sum()

    def test_all_of_a_small_scene(self):
        self.assertEqual(self.drawn(samples(100, 40), 1), (100, 40))

    def test_hidden_ones_by_their_share(self):
        part = samples(3 * forest.PER_SCENE, forest.PER_SCENE)
        self.assertEqual(self.drawn(part, 1), (forest.PER_SCENE, forest.PER_SCENE // 3))
        self.assertEqual(self.drawn(part, 0.5), (forest.PER_SCENE, forest.PER_SCENE // 6))
        self.assertEqual(self.drawn(part, 0), (forest.PER_SCENE, 0))

    def test_a_scene_of_one_kind(self):
        self.assertEqual(self.drawn(samples(100, 0), 1), (100, 0))
        self.assertEqual(self.drawn(samples(0, 40), 1), (0, 40))

    def test_none_twice_and_the_same_again(self):
        part = samples(2 * forest.PER_SCENE, 50)
        first, again = (forest.drawn(part, 1, np.random.RandomState(3)) for _ in range(2))
        self.assertEqual(len(set(first)), len(first))
        self.assertEqual(list(first), list(again))


class Trained(unittest.TestCase):
    def test_hidden_pixels_are_learnt_only_from_hidden_samples(self):
        part = samples(400, 200)
        for hidden, chosen in ((0, [0, 0]), (1, [0, 1])):
            model = forest.train([part, part], 1, 4, hidden)
            of_each = model.predict(np.array([[10, 3], [200, 3]], np.uint8)).argmax(1)
            self.assertEqual(list(of_each), chosen)

    def test_scenes_left_out_are_judged_by_kind(self):
        rows = dict(forest.leave_out([samples(300, 100, str(k)) for k in range(4)], 2, 1, 1))
        visible, everything = 1 / 301, 2 / 402
        np.testing.assert_allclose(rows["forest"], [visible] * 3 + [everything] * 3)
        np.testing.assert_allclose(rows["best choice"], rows["forest"])
        np.testing.assert_allclose(rows["matcher 1"], [visible] * 3 + [102 / 402] * 3)
        np.testing.assert_allclose(rows["matcher 2"], [1.0] * 3 + [302 / 402] * 3)


class Truth(unittest.TestCase):
    def test_what_the_right_view_hides_is_known_but_not_visible(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder)
            # From x = 3 on a thing at 2 px, before it and right of it a wall at 0 px.
            write_pfm(scene / "disp0GT.pfm", [[0, 0, 0, 2, 2, 0, np.inf], [1] * 7])
            write_pfm(scene / "disp1GT.pfm", [[0, 2, 2, 0, 0, 0, 0], [1] * 7])
            truth, visible = scenes.read_truth(scene)
            self.assertTrue(np.isnan(truth[0, 6]))
            self.assertEqual(list(truth[0, :6]), [0, 0, 0, 2, 2, 0])
            # The thing hides two pixels of the wall; what the right image ends before is not shown
            # either.
            self.assertEqual(list(visible[0]), [True, False, False, True, True, True, False])
            self.assertEqual(list(visible[1]), [False] + [True] * 6)

    def test_without_a_right_truth_all_is_visible(self):
        with tempfile.TemporaryDirectory() as folder:
            write_pfm(pathlib.Path(folder) / "disp0GT.pfm", [[1, 2], [3, np.inf]])
            truth, visible = scenes.read_truth(pathlib.Path(folder))
            self.assertTrue(visible.all())
            self.assertTrue(np.isnan(truth[1, 1]))

    def test_samples_keep_the_kind_of_their_pixel(self):
        kind = [("row", "<i4"), ("column", "<i4"), ("disparities", "<f4", (2,)),
                ("matcher 1: cost 1, 3x3", "|u1"), ("matcher 2: cost 1, 3x3", "|u1")]
        records = np.array([(0, 0, (1, 5), 7, 8), (0, 1, (np.nan, 2), 9, 10), (1, 0, (3, 3), 1, 2)],
                           kind)
        truth = np.array([[1, 4], [np.nan, 0]], np.float32)
        visible = np.array([[True, False], [True, True]])
        part = forest.Samples.of(records, truth, visible, "scene")
        self.assertEqual(part.costs, 1)
        self.assertEqual(part.visible.tolist(), [True, False])
        self.assertEqual(part.features.tolist(), [[7, 8], [9, 10]])
        self.assertEqual(part.errors.tolist(), [[0, 4], [np.inf, 2]])


if __name__ == "__main__":
    unittest.main()
