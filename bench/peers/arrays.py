#!/usr/bin/env python3
"""Simplifiers for Python, from arrays to arrays:

    arrays.py winnow|vtk|vtk-pro|open3d IN OUT --faces N

Reads a binary PLY, and times nothing but the call: what the package needs made of arrays of numpy
counts, and so do arrays made of its result. Prints a report.
"""

import argparse
import json
import resource
import time

import numpy as np

TYPES = {"float": "<f4", "double": "<f8", "uchar": "u1", "int": "<i4", "uint": "<u4"}


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    counts, columns, element = {}, [], None
    for line in data[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
        elif words[0] == "property" and element == "vertex":
            columns.append((words[2], TYPES[words[1]]))
    vertices = np.frombuffer(data, np.dtype(columns), counts["vertex"], end)
    rows = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
    faces = np.frombuffer(data, rows, counts["face"], end + vertices.nbytes)["corners"]
    return np.stack([vertices[axis] for axis in "xyz"], axis=-1), np.ascontiguousarray(faces)


def write(path, points, faces):
    rows = np.empty(len(faces), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    rows["count"], rows["corners"] = 3, faces
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
                   "property float x\nproperty float y\nproperty float z\n"
                   f"element face {len(faces)}\nproperty list uchar int vertex_indices\n"
                   "end_header\n".encode())
        file.write(points.astype("<f4").tobytes() + rows.tobytes())


def winnow(points, faces, count):
    import winnow as package

    return package.simplify(points, faces, target_count=count)


def vtk_by(decimation):
    def simplify(points, faces, count):
        from vtkmodules.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray,
                                                   vtk_to_numpy)
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        from vtkmodules.vtkFiltersCore import vtkDecimatePro, vtkQuadricDecimation

        places, cells, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
        # VTK does not hold what it is given by reference, so it gets copies.
        places.SetData(numpy_to_vtk(points, deep=1))
        offsets = np.arange(0, 3 * len(faces) + 1, 3)
        cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=1),
                      numpy_to_vtkIdTypeArray(faces.astype(np.int64).ravel(), deep=1))
        mesh.SetPoints(places)
        mesh.SetPolys(cells)
        kinds = {"quadric": vtkQuadricDecimation, "pro": vtkDecimatePro}
        made = kinds[decimation]()
        made.SetInputData(mesh)
        made.SetTargetReduction(1 - count / len(faces))
        made.Update()
        out = made.GetOutput()
        corners = vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        return vtk_to_numpy(out.GetPoints().GetData()).copy(), corners.copy()

    return simplify


def open3d(points, faces, count):
    import open3d as package

    mesh = package.geometry.TriangleMesh(
        package.utility.Vector3dVector(points.astype(np.float64)),
        package.utility.Vector3iVector(faces))
    mesh = mesh.simplify_quadric_decimation(count)
    return np.asarray(mesh.vertices).copy(), np.asarray(mesh.triangles).copy()


PACKAGES = {"winnow": winnow, "vtk": vtk_by("quadric"), "vtk-pro": vtk_by("pro"),
            "open3d": open3d}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("package", choices=PACKAGES)
    parser.add_argument("source")
    parser.add_argument("target")
    parser.add_argument("--faces", type=int, required=True)
    options = parser.parse_args()
    points, faces = read(options.source)
    simplify = PACKAGES[options.package]
    corners = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    simplify(corners, np.int32([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]), 4)  # loads it
    start, processor = time.perf_counter(), time.process_time()
    small_points, small_faces = simplify(points, faces, options.faces)
    report = {"seconds_simplify": time.perf_counter() - start,
              "cpu_seconds_simplify": time.process_time() - processor,
              "faces_in": len(faces), "faces_out": len(small_faces),
              "peak_bytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024}
    write(options.target, small_points, small_faces)
    print(json.dumps(report))


if __name__ == "__main__":
    main()
