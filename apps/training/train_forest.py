# SPDX-License-Identifier: Apache-2.0
"""Trains the forest of a pipeline whose matcher is `fusion`.

    train_forest.py pipelines/models/fusion_best.forest --pipeline pipelines/fusion_best.yaml \\
        --program build/release/bin/pipeline --work build/training

Generates scenes, lets the program compute the features (fuser forest_samples), trains a random forest
with scikit-learn, tells how well forests do on scenes that they were not trained on, and writes the
file. The same options give the same bytes. docs/fusion.md tells more.
"""
import argparse
import hashlib
import pathlib
import subprocess

import numpy as np
import yaml

import forest
import scenes


def options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output", help="file of the forest")
    parser.add_argument("--pipeline", required=True, help="file of the pipeline")
    parser.add_argument("--program", required=True, help="the program `pipeline`")
    parser.add_argument("--work", required=True,
                        help="folder of scenes and samples; what is there is not made anew")
    parser.add_argument("--generated", type=int, default=45, help="generated scenes to train on")
    parser.add_argument("--scenes", nargs="*", default=[],
                        help="folders with more scenes to train on: im0, im1 and disp0GT.pfm")
    parser.add_argument("--judge", nargs="*", default=[],
                        help="folders with scenes to judge the forest by, never to train on")
    parser.add_argument("--hidden", type=float, default=forest.HIDDEN,
                        help="samples that one view hides: 1 takes the share that a scene has of "
                             "them, 0 none")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--trees", type=int, default=forest.TREES)
    parser.add_argument("--folds", type=int, default=4,
                        help="parts of the scenes, each left out once; 0: none is")
    return parser.parse_args()


def sampling_pipeline(source, target, samples):
    """The pipeline with forest_samples in the place of its fuser."""
    document = yaml.safe_load(pathlib.Path(source).read_text())
    fuser = document["matcher"]["fuser"]
    document["matcher"]["fuser"] = {"type": "forest_samples", "file": str(samples),
                                    "costs": fuser.get("costs", [])}
    document.pop("postprocess", None)
    target.write_text(yaml.safe_dump(document, sort_keys=False))


def samples_of(scene, chosen):
    """The samples of a scene, with the true disparities; computed unless they are there."""
    key = hashlib.sha256(str(scene).encode()).hexdigest()[:12]
    folder = pathlib.Path(chosen.work) / "samples" / key
    file = folder / "samples.npy"
    if not file.exists():
        folder.mkdir(parents=True, exist_ok=True)
        pipeline, partial = folder / "pipeline.yaml", folder / "partial.npy"
        sampling_pipeline(chosen.pipeline, pipeline, partial)
        subprocess.run([chosen.program, "run", str(pipeline), str(scene), "--output",
                        str(folder / "run")], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        partial.rename(file)
    return forest.Samples.of(np.load(file), *scenes.read_truth(scene), scene.name)


def print_judgement(title, rows):
    print(f"{title}: share of wrong pixels in % where candidates differ, at 0.5 / 1 / 2 px, of the "
          "pixels that both views show, then of all")
    for name, shares in rows:
        print(f"  {name:12}" + "".join(f"{100 * share:8.2f}" for share in shares))


def main():
    chosen = options()
    training = scenes.generated(chosen.program, pathlib.Path(chosen.work) / "scenes",
                                chosen.generated, chosen.seed) + scenes.found(chosen.scenes)
    samples = [samples_of(scene, chosen) for scene in training]
    if chosen.folds:
        print_judgement("scenes left out",
                        forest.leave_out(samples, chosen.folds, chosen.seed, chosen.hidden))
    trained = forest.train(samples, chosen.seed, chosen.trees, chosen.hidden)
    judges = [samples_of(scene, chosen) for scene in scenes.found(chosen.judge)]
    if judges:
        print_judgement("scenes of --judge", forest.judge([(trained, judges)]))
    content = forest.to_bytes(trained, samples[0], [
        f"scenes: {chosen.generated} generated from seed {chosen.seed}"
        + "".join(f", {pathlib.Path(folder).name}" for folder in chosen.scenes),
        f"samples: {sum(len(part.features) for part in samples)}, {chosen.hidden:g} of the share "
        "of those that one view hides"])
    pathlib.Path(chosen.output).write_bytes(content)
    print(f"{chosen.output}: {len(content)} bytes, sha256 {hashlib.sha256(content).hexdigest()}")


if __name__ == "__main__":
    main()
