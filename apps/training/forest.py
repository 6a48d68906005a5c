# SPDX-License-Identifier: Apache-2.0
"""Random forests that tell which of several disparities is right: training, judging, writing."""
import dataclasses
import struct

import numpy as np
from sklearn.ensemble import RandomForestRegressor

FEATURE_VERSION = 1  # kFeatureVersion of plugins/fuser/candidate_features
THRESHOLDS = (0.5, 1.0, 2.0)  # px; a disparity's score is the share of them that it meets
TREES = 32
LEAVES = 1024
TREES_OF_FOLDS = 8  # enough to tell how good a forest is
PER_SCENE = 6000  # visible samples of a scene to train on, so that each scene counts alike
HIDDEN = 1.0  # hidden samples beside them: 1 takes the share that the scene has, 0 none


@dataclasses.dataclass
class Samples:
    """Pixels of one scene whose candidates differ, and whose truth is known."""
    name: str
    costs: int
    features: np.ndarray  # bytes
    errors: np.ndarray    # px, of each matcher; infinite where it has no disparity
    visible: np.ndarray   # whether both views show the pixel

    @staticmethod
    def of(records, truth, visible, name):
        disparities = records["disparities"]
        true = truth[records["row"], records["column"]]
        known = np.isfinite(true)
        first = records.dtype.fields[records.dtype.names[3]][1]
        features = records.view(np.uint8).reshape(len(records), -1)[:, first:]
        errors = np.nan_to_num(np.abs(disparities - true[:, None]), nan=np.inf)
        costs = sum(field.startswith("matcher 1: cost") and field.endswith(", 3x3")
                    for field in records.dtype.names)
        shown = visible[records["row"], records["column"]]
        return Samples(name, costs, features[known], errors[known], shown[known])

    def scores(self):
        return np.mean([self.errors <= bound for bound in THRESHOLDS], axis=0)


def drawn(part, hidden, draw):
    """Which samples of a scene a forest is trained on."""
    scores = part.scores()
    # What the forest says matters only where the matchers' scores differ.
    worth = scores.max(1) > scores.min(1)
    visible = draw.permutation(np.flatnonzero(worth & part.visible))
    others = draw.permutation(np.flatnonzero(worth & ~part.visible))
    taken = min(1, PER_SCENE / max(1, len(visible)))  # of the visible ones
    return np.sort(np.concatenate([visible[:PER_SCENE],
                                   others[:round(hidden * taken * len(others))]]))


def train(samples, seed, trees, hidden):
    """A forest whose outputs are the scores of the matchers."""
    draw = np.random.RandomState(seed)
    features, scores = [], []
    for part in samples:
        kept = drawn(part, hidden, draw)
        features.append(part.features[kept])
        scores.append(part.scores()[kept])
    scores = np.concatenate(scores)
    model = RandomForestRegressor(n_estimators=trees, max_leaf_nodes=LEAVES, min_samples_leaf=8,
                                  max_features=0.33, max_samples=0.5, n_jobs=-1,
                                  random_state=seed)
    return model.fit(np.concatenate(features), scores,
                     sample_weight=scores.max(1) - scores.min(1))


def judge(pairs):
    """Shares of wrong pixels of (forest, samples) pairs together, each scene alike: of each matcher
    alone, of the best choice, of the forest's. Of the pixels that both views show, then of all."""
    sums = {}
    scenes = [(model, part) for model, parts in pairs for part in parts]
    for model, part in scenes:
        predicted = np.where(np.isfinite(part.errors), model.predict(part.features), -1)
        pixels = np.arange(len(part.errors))
        found = {f"matcher {m + 1}": part.errors[:, m] for m in range(part.errors.shape[1])}
        found["best choice"] = part.errors.min(1)
        found["forest"] = part.errors[pixels, predicted.argmax(1)]
        for name, errors in found.items():
            shares = np.array([np.mean(of > bound) for of in (errors[part.visible], errors)
                               for bound in THRESHOLDS])
            sums[name] = sums.get(name, 0) + shares / len(scenes)
    return list(sums.items())


def leave_out(samples, folds, seed, hidden):
    """Judges each scene by a forest that was trained on the scenes of the other folds."""
    pairs = []
    for fold in range(folds):
        rest = [part for k, part in enumerate(samples) if k % folds != fold]
        pairs.append((train(rest, seed, TREES_OF_FOLDS, hidden), samples[fold::folds]))
    return judge(pairs)


def to_bytes(model, example, comments):
    """The file: plugins/fuser/forest/forest_file.hpp describes it."""
    features, matchers = example.features.shape[1], example.errors.shape[1]
    header = ["xgm forest 1", *("# " + comment for comment in comments),
              f"features {FEATURE_VERSION} {matchers} {example.costs} {features}",
              f"trees {len(model.estimators_)}"]
    return ("\n".join(header) + "\n").encode() + b"".join(
        tree_bytes(each.tree_) for each in model.estimators_)


def tree_bytes(tree):
    """Nodes are numbered in their order, leaves after them."""
    is_leaf = tree.children_left < 0
    number = np.where(is_leaf, np.cumsum(is_leaf) - 1 + np.sum(~is_leaf), np.cumsum(~is_leaf) - 1)
    nodes = [struct.pack("<BBHH", tree.feature[i], int(tree.threshold[i]),
                         number[tree.children_left[i]], number[tree.children_right[i]])
             for i in np.flatnonzero(~is_leaf)]
    scores = np.floor(255 * tree.value[is_leaf, :, 0] + 0.5).astype(np.uint8)
    return struct.pack("<H", len(nodes)) + b"".join(nodes) + scores.tobytes()
