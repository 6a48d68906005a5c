# SPDX-License-Identifier: Apache-2.0
"""Scenes that several tests match, and the program whose results the package's are compared with."""
import os
import subprocess
import types

import numpy as np
import pytest

import xgm


@pytest.fixture(scope="session")
def scene():
    """Colour, 8 bit."""
    return xgm.synth((160, 120), (0, 32), seed=3, objects=6)


@pytest.fixture(scope="session")
def grey_scene():
    return xgm.synth((160, 120), (0, 32), seed=4, objects=6, colour=False)


@pytest.fixture(scope="session")
def large_scene():
    """6 megapixels of noise, 7 px apart: runs take long enough to be ended."""
    left = np.random.default_rng(1).integers(0, 256, (2000, 3000), np.uint8)
    return types.SimpleNamespace(left=left, right=np.roll(left, -7, axis=1), disparities=(0, 128))


@pytest.fixture
def program(tmp_path):
    """Calls `pipeline` in the test's folder."""

    def call(*words):
        subprocess.run([os.environ["XGM_PIPELINE"], *words], cwd=tmp_path, check=True,
                       capture_output=True)

    return call


@pytest.fixture
def sgm8():
    return xgm.load("sgm8")
