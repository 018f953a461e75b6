"""Section of bench/run: winnow and others for Python, from arrays to arrays."""

import os
import pathlib
import statistics

from harness import MIB, Failed, Table, measure, median, warm

DRIVER = pathlib.Path(__file__).resolve().parent / "peers/arrays.py"
PACKAGES = {"winnow": "winnow.simplify", "vtk": "VTK vtkQuadricDecimation",
            "vtk-pro": "VTK vtkDecimatePro", "open3d": "Open3D quadric decimation"}


def section_python(bench):
    """Arrays to arrays in Python, to 10 %"""
    options = bench.options
    source = bench.generate(options.python_faces)
    faces = options.python_faces // 10
    folders = sorted(pathlib.Path(options.build).rglob("python/winnow/_winnow.*.so"))
    if not folders:
        raise Failed("the package for Python is not built (-DWINNOW_PYTHON=ON)")
    os.environ["PYTHONPATH"] = str(folders[0].parent.parent)
    warm(source)
    kept = {name: bench.work / f"arrays-{name}.ply" for name in PACKAGES}
    candidates = {"winnow, the program": lambda: bench.winnow(source, "--faces", faces)}
    for name, title in PACKAGES.items():
        command = ["/usr/bin/python3", DRIVER, name, source, kept[name], "--faces", faces]
        candidates[title] = lambda command=command: measure(command, timeout=600)
    runs = bench.in_turn(candidates)

    table = Table("package", "faces out", "seconds of the call", "times winnow's", "peak MiB",
                  "RMS % of the diagonal", "max %")
    base = statistics.median(seconds_of(run) for run in runs["winnow.simplify"])
    for title, found in runs.items():
        if isinstance(found, str):
            table.fail(title, found)
            continue
        path = bench.out if title == "winnow, the program" else next(
            kept[name] for name in PACKAGES if PACKAGES[name] == title)
        judged = bench.compare(source, path, "--memory", options.large_memory)["report"]
        seconds = statistics.median(seconds_of(run) for run in found)
        distance = judged["distance"]["symmetric"]
        table.add(title, judged["simplified"]["faces"], seconds, seconds / base,
                  round(median(found, "peak_bytes") / MIB), distance["rms_percent"],
                  distance["max_percent"])
    print("Of the program's time reading its header and writing are left out. Peaks are of the "
          "whole process with all arrays.\n")
    table.print()
    for path in kept.values():
        path.unlink(missing_ok=True)
    return runs


def seconds_of(run):
    report = run["report"]
    if "seconds_simplify" in report:
        return report["seconds_simplify"]
    return report["stage_seconds"]["cluster"] + report["stage_seconds"]["refine"]
