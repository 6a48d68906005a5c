# SPDX-License-Identifier: Apache-2.0
"""Progress, cancelling, Ctrl-C, and several threads."""
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import types

import numpy as np
import pytest

import xgm

SOON = 1.0  # s; what a user may wait for the end of a run


class Stop(Exception):
    pass


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_progress_never_falls_and_ends_at_1(scene):
    told = []
    xgm.load("tmgm8").run(scene.left, scene.right, scene.disparities,
                          progress=lambda share, stage: told.append((share, stage)))
    shares = [share for share, _ in told]
    assert shares[0] == 0 and shares[-1] == 1 and shares == sorted(shares)


def test_an_exception_of_progress_ends_a_large_run_and_the_next_one_is_right(large_scene, scene,
                                                                             sgm8):
    before = resident()
    raised = None

    def progress(share, stage):
        nonlocal raised
        if share > 0.02:
            raised = time.monotonic()
            raise Stop

    with pytest.raises(Stop):
        sgm8.run(large_scene.left, large_scene.right, large_scene.disparities, progress=progress)
    assert time.monotonic() - raised < SOON
    assert resident() - before < 200e6, "what the run held is given back"
    wanted = sgm8.run(scene.left, scene.right, scene.disparities, threads=1).disparity
    assert np.array_equal(sgm8.run(scene.left, scene.right, scene.disparities).disparity, wanted,
                          equal_nan=True)


def test_an_event_cancels_a_large_run(large_scene, sgm8):
    cancel = threading.Event()
    timer = threading.Timer(0.5, cancel.set)
    start = time.monotonic()
    timer.start()
    with pytest.raises(xgm.Cancelled):
        sgm8.run(large_scene.left, large_scene.right, large_scene.disparities, cancel=cancel)
    assert time.monotonic() - start < 0.5 + SOON


LARGE_RUN = """
import numpy as np, xgm
left = np.random.default_rng(1).integers(0, 256, (2000, 3000), np.uint8)
def progress(share, stage):
    if share > 0.01: print("running", flush=True)
try:
    xgm.load("sgm8").run(left, np.roll(left, -7, axis=1), (0, 128), progress=progress)
except KeyboardInterrupt:
    print("interrupted", flush=True)
    small = xgm.synth((160, 120), (0, 32), seed=3)
    print(xgm.load("sgm8").run(small.left, small.right, (0, 32)).density > 0.3)
"""


def test_ctrl_c_ends_a_large_run_and_the_next_one_is_right():
    environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(xgm.__file__).parent.parent)}
    child = subprocess.Popen([sys.executable, "-c", LARGE_RUN], stdout=subprocess.PIPE, text=True,
                             env=environment)
    assert child.stdout.readline() == "running\n"
    sent = time.monotonic()
    child.send_signal(signal.SIGINT)
    while child.stdout.readline() == "running\n":
        pass
    assert time.monotonic() - sent < SOON
    assert child.communicate(timeout=60)[0] == "True\n" and child.returncode == 0


def test_python_goes_on_while_a_run_does(scene):
    """The interpreter's lock is free: another thread counts all the time."""
    counted, done = 0, threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    result = xgm.load("mgm16").run(scene.left, scene.right, scene.disparities)
    seconds = time.monotonic() - start
    done.set()
    thread.join()
    assert result.density > 0.3
    assert counted > 50 * seconds


def test_two_threads_run_two_pipelines(scene):
    names = ["sgm8", "tmgm8"]
    wanted = {name: xgm.load(name).run(scene.left, scene.right, scene.disparities).disparity
              for name in names}
    found = {name: [] for name in names}

    def run(name):
        pipeline = xgm.load(name)
        for _ in range(4):
            found[name].append(pipeline.run(scene.left, scene.right, scene.disparities).disparity)

    threads = [threading.Thread(target=run, args=(name,)) for name in names]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for name in names:
        assert len(found[name]) == 4
        assert all(np.array_equal(map, wanted[name], equal_nan=True) for map in found[name])


def test_warnings_are_logged_and_kept(scene, sgm8, caplog):
    result = sgm8.run(scene.left, scene.left, scene.disparities)
    assert any("are the same" in warning for warning in result.warnings)
    assert any("are the same" in record.message for record in caplog.records
               if record.name == "xgm")


class FakeBar:
    made = []

    def __init__(self, total, **_):
        self.n, self.total, self.closed = 0, total, False
        FakeBar.made.append(self)

    def set_postfix_str(self, text, refresh):
        self.stage = text

    def update(self, more):
        self.n += more

    def close(self):
        self.closed = True


def test_a_bar_is_shown_where_somebody_sees_it_and_nowhere_else(scene, sgm8, monkeypatch):
    from xgm import _progress

    monkeypatch.setattr(_progress, "_SECONDS_BEFORE_A_BAR", 0)
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    auto = types.ModuleType("tqdm.auto")
    auto.tqdm = FakeBar
    monkeypatch.setitem(sys.modules, "tqdm.auto", auto)
    run = [scene.left, scene.right, scene.disparities]
    monkeypatch.setattr(sys.stderr, "isatty", lambda: False, raising=False)
    sgm8.run(*run)
    assert FakeBar.made == []
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    sgm8.run(*run, progress=False)
    assert FakeBar.made == []
    sgm8.run(*run)
    [bar] = FakeBar.made
    assert bar.closed and bar.n == pytest.approx(1) and bar.total == 1
