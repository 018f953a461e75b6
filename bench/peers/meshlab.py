#!/usr/bin/env python3
"""MeshLab's simplifiers as a whole program from file to file, through its own server:

    peer_meshlab IN OUT --faces N|--cell SIZE   vertex clustering
    peer_meshlab IN OUT --faces N --collapse    quadric edge collapse

The server reads and writes. For clustering with --faces the cell is found by trial outside the
reported times, and reported, so that a timed run can be given --cell. The server opens a window
system even though it shows nothing: DISPLAY must name one (Xvfb will do). Its times are taken from
the lines that it logs; writing is part of `seconds_simplify`, loading its plugins part of the whole
only.
"""

import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import time

# All that the filters ask for, at MeshLab's defaults.
COLLAPSE = ("Simplification: Quadric Edge Collapse Decimation", """
  <Param type="RichInt" name="TargetFaceNum" value="{size:d}"/>
  <Param type="RichFloat" name="TargetPerc" value="0"/>
  <Param type="RichFloat" name="QualityThr" value="0.3"/>
  <Param type="RichBool" name="PreserveBoundary" value="false"/>
  <Param type="RichFloat" name="BoundaryWeight" value="1"/>
  <Param type="RichBool" name="PreserveNormal" value="false"/>
  <Param type="RichBool" name="PreserveTopology" value="false"/>
  <Param type="RichBool" name="OptimalPlacement" value="true"/>
  <Param type="RichBool" name="PlanarQuadric" value="false"/>
  <Param type="RichFloat" name="PlanarWeight" value="0.001"/>
  <Param type="RichBool" name="QualityWeight" value="false"/>
  <Param type="RichBool" name="AutoClean" value="true"/>
  <Param type="RichBool" name="Selected" value="false"/>""")
CLUSTERING = ("Simplification: Clustering Decimation", """
  <Param type="RichAbsPerc" name="Threshold" value="{size!r}" min="0" max="1e30"/>
  <Param type="RichBool" name="Selected" value="false"/>""")


def simplify(source, target, method, size):
    """One run of the server: its report."""
    name, parameters = method
    with tempfile.NamedTemporaryFile("w", suffix=".mlx") as script:
        script.write(f'<!DOCTYPE FilterScript>\n<FilterScript>\n <filter name="{name}">'
                     f"{parameters.format(size=size)}\n </filter>\n</FilterScript>\n")
        script.flush()
        with tempfile.TemporaryFile("w+") as out:
            server = subprocess.Popen(["meshlabserver", "-i", source, "-o", target, "-s",
                                       script.name],
                                      stdout=out, stderr=subprocess.PIPE, text=True,
                                      errors="replace")
            passed = {}
            said = ""
            for said in server.stderr:
                for start in ("Opening a file", "Reading filter"):
                    if said.startswith(start):
                        passed.setdefault(start, time.perf_counter())
            code = server.wait()
            end = time.perf_counter()
            out.seek(0)
            log = out.read()
    read = re.search(r"loaded has (\d+) vn (\d+) fn", log)
    written = re.search(r"saved as .*\((\d+) vn (\d+) fn\)", log)
    if code != 0 or not read or not written or len(passed) != 2:
        sys.exit(f"peer_meshlab: {said.strip() or 'it wrote nothing'} (exit code {code})")
    return {"faces_in": int(read[2]), "faces_out": int(written[2]),
            "seconds_read": passed["Reading filter"] - passed["Opening a file"],
            "seconds_simplify": end - passed["Reading filter"]}


def find_cell(source, target, faces):
    """The cell that comes closest to the faces, which are in proportion to 1 / cell²."""
    cell, best, best_miss = 1.0, 1.0, math.inf
    for _ in range(8):
        found = max(1, simplify(source, target, CLUSTERING, cell)["faces_out"])
        miss = abs(math.log(found / faces))
        if miss < best_miss:
            best, best_miss = cell, miss
        if miss < 0.01:
            break
        cell *= math.sqrt(found / faces)
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", metavar="IN", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("target", metavar="OUT",
                        type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--faces", type=int)
    parser.add_argument("--collapse", action="store_true")
    parser.add_argument("--cell", type=float)
    options = parser.parse_args()
    if not options.faces and (options.collapse or not options.cell):
        parser.error("say --faces N")
    if options.collapse:
        report = simplify(options.source, options.target, COLLAPSE, options.faces)
    else:
        cell = options.cell or find_cell(options.source, options.target, options.faces)
        report = simplify(options.source, options.target, CLUSTERING, cell) | {"cell": cell}
    print(json.dumps(report))


if __name__ == "__main__":
    main()
