"""Builds what the bench runs: winnow as users get it, and a driver of every installed peer."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TREE = ROOT / "build/bench"  # where the preset says
PACKAGES = {"meshoptimizer": "libmeshoptimizer-dev", "vtk": "libvtk9-dev",
            "open3d": "libopen3d-dev",
            "cgal": "libcgal-dev libeigen3-dev", "openmesh": "libopenmesh-dev",
            "meshlab": "meshlab xvfb libgl1-mesa-dri"}


def build():
    """Configures and builds by the preset `bench`; returns the peers that are not installed."""
    def run(*command):
        print(f"({' '.join(command)})", file=sys.stderr, flush=True)
        done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{done.stdout}\nbench/run: cannot build; "
                     "tools/setup installs what winnow is built from")
        return done.stdout

    said = run("cmake", "--preset", "bench", "-DWINNOW_TESTS=OFF")
    run("cmake", "--build", "--preset", "bench")
    absent = re.findall(r"bench: (\w+) not found", said)
    return {peer: PACKAGES[peer] for peer in absent if peer in PACKAGES}
