# SPDX-License-Identifier: Apache-2.0
"""What `pipeline new-plugin KIND NAME --python` writes passes its own tests, untouched."""
import os
import subprocess
import sys

import pytest

import xgm


@pytest.mark.parametrize("kind", ["cost", "filter", "matcher", "refinement"])
def test_new_stage_passes_its_tests_and_matches_the_sample_pair(kind, program, tmp_path):
    program("new-plugin", kind, "own_stage", "--python")
    folder = tmp_path / "own_stage"
    paths = [os.path.dirname(os.path.dirname(xgm.__file__))]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(paths)}
    for file in ("test_own_stage.py", "own_stage.py"):
        subprocess.run([sys.executable, folder / file], check=True, env=environment)
    assert "my_plugin" not in (folder / "own_stage.py").read_text()
