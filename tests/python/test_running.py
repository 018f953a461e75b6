"""A run lets other threads work, tells of its progress, and can be stopped."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import winnow
from conftest import waves


def test_progress_is_told_in_the_callers_thread():
    points, faces = waves(300)
    told = []
    here = threading.get_ident()

    def progress(stage, done, total, unit):
        assert threading.get_ident() == here
        told.append((stage, done, total, unit))

    winnow.simplify(points, faces, target_count=1000, progress=progress)
    assert told
    assert all(stage and done <= total and unit for stage, done, total, unit in told if total)


def test_a_callback_that_raises_stops_the_run():
    points, faces = waves(1000)

    class Enough(Exception):
        pass

    raised = []

    def progress(*_):
        raised.append(time.monotonic())
        raise Enough("now")

    with pytest.raises(Enough, match="now"):
        winnow.simplify(points, faces, target_count=1000, detail="full", progress=progress)
    assert len(raised) == 1 and time.monotonic() - raised[0] < 1
    # And what comes next is not stopped.
    few_points, few_faces = waves(20)
    assert len(winnow.simplify(few_points, few_faces, target_count=50)[1]) in (49, 50)


def test_ctrl_c_stops_within_a_second():
    points, faces = waves(1500)
    sent = []

    def interrupt():
        time.sleep(0.5)
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        winnow.simplify(points, faces, target_count=1000, detail="full")
    assert time.monotonic() - sent[0] < 1
    thread.join()


def test_other_threads_work_meanwhile():
    points, faces = waves(700)
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.01)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.monotonic()
    winnow.simplify(points, faces, target_count=1000, detail="full")
    end = time.monotonic()
    stop.set()
    thread.join()
    within = [t for t in ticks if start < t < end]
    assert len(within) > 5


def test_two_runs_at_once_give_what_each_gives_alone():
    points, faces = waves(150)
    wanted = winnow.simplify(points, faces, target_count=2000)
    results = [None, None]

    def run(i):
        results[i] = winnow.simplify(points, faces, target_count=2000)

    threads = [threading.Thread(target=run, args=(i,)) for i in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results:
        assert result[0].tobytes() == wanted[0].tobytes()


def test_the_bar_shows_every_stage(capsys, monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    points, faces = waves(300)
    bar = winnow.progress_bar()
    winnow.simplify(points, faces, target_count=1000, progress=bar)
    bar.close()
    assert "\r" in capsys.readouterr().err


def test_the_bar_is_tqdms_where_that_is_there(capsys):
    pytest.importorskip("tqdm")
    points, faces = waves(300)
    bar = winnow.progress_bar()
    winnow.simplify(points, faces, target_count=1000, progress=bar)
    assert bar._bar is not None and "tqdm" in type(bar._bar).__module__
    bar.close()
    assert "write" in capsys.readouterr().err


PEAK = """
import numpy as np, winnow
from conftest import waves

def status(field):
    lines = open("/proc/self/status").read().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(field)) / 1024

points, faces = waves(1200)
winnow.simplify(*waves(20), target_count=50)
open("/proc/self/clear_refs", "w").write("5")  # the peak begins anew
before = status("VmRSS")
new = winnow.simplify(points, faces, target_count=30_000, refine="none", memory="64M", threads=2)
print(status("VmHWM") - before - sum(array.nbytes for array in new) / 2**20)
"""


def test_memory_is_the_arrays_and_the_budget():
    environment = dict(os.environ)
    environment["PYTHONPATH"] += os.pathsep + os.path.dirname(__file__)
    run = subprocess.run(
        [sys.executable, "-c", PEAK], env=environment, capture_output=True, text=True, check=True
    )
    assert float(run.stdout) < 64 + 32
