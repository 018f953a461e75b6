"""Section of bench/run: the page of `winnow view`, in Node.js and in a headless Chromium."""

import json
import pathlib
import shutil
import subprocess

from harness import Failed, Table, short

HERE = pathlib.Path(__file__).resolve().parent / "viewer"


def run(*words):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, timeout=600,
                          check=False)
    if done.returncode != 0:
        raise Failed(f"{words[1]}: {done.stderr.strip()[-300:]}")
    return json.loads(done.stdout)


def section_viewer(bench):
    """The viewer: splits a second in JavaScript, frames while the slider moves, first picture"""
    options = bench.options
    node, chromium = shutil.which("node"), shutil.which("chromium")
    if node is None or chromium is None:
        raise Failed("Node.js or Chromium is missing; tools/setup checks installs them")
    table = Table("faces", "splits a second of the page's processor time: read and applied",
                  "taken back", "read and applied by the clock", "first picture, ms",
                  "frames/s while the slider moves",
                  "the page's work a frame, ms: median", "95 %")
    result = {}
    for faces in options.viewer_faces:
        source = bench.generate(faces)
        wpm = bench.work / f"viewer-{faces}.wpm"
        subprocess.run([options.winnow, "progressive", source, "-o", wpm, "--force", "-q"],
                       check=True)
        splits = run(node, HERE / "splits.mjs", wpm)
        frames = run(node, HERE / "frames.mjs", options.winnow, chromium, wpm)
        result[short(faces)] = {**splits, **frames}
        table.add(short(faces), splits["up"], splits["down"], splits["elapsed"],
                  frames["firstPicture"], frames["drawn"], frames["work"], frames["longest"])
    table.print()
    return result
