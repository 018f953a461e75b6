"""Runs with the package's folder in PYTHONPATH, and WINNOW_PROGRAM naming the program."""

import os
import subprocess

import numpy as np
import pytest

PLY_TYPES = {
    "char": "i1",
    "uchar": "u1",
    "short": "<i2",
    "ushort": "<u2",
    "int": "<i4",
    "uint": "<u4",
    "float": "<f4",
    "double": "<f8",
}


def waves(n=60, dtype=np.float32):
    """A bumpy square of 2 (n - 1)² faces."""
    x, y = np.meshgrid(np.arange(n, dtype=np.float64), np.arange(n, dtype=np.float64))
    points = np.stack([x, y, np.sin(x / 4) * np.cos(y / 5)], axis=-1).reshape(-1, 3)
    corner = (np.arange(n - 1)[:, None] * n + np.arange(n - 1)).ravel()
    first, second = corner + [[0], [1], [n + 1]], corner + [[0], [n + 1], [n]]
    faces = np.concatenate([first, second], axis=1).T
    return points.astype(dtype), np.ascontiguousarray(faces, np.int32)


def write_ply(path, points, faces, attributes=None):
    """A binary PLY of arrays."""
    names = {value: name for name, value in PLY_TYPES.items()}
    columns = [(name, points[:, i]) for i, name in enumerate("xyz")] + list(
        (attributes or {}).items()
    )
    record = np.dtype([(name, values.dtype.newbyteorder("<")) for name, values in columns])
    vertices = np.empty(len(points), record)
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    for name, values in columns:
        vertices[name] = values
        code = values.dtype.newbyteorder("<").str.replace("|", "")
        lines.append(f"property {names[code]} {name}")
    lines += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
    rows = np.empty(len(faces), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    rows["count"], rows["corners"] = 3, faces
    with open(path, "wb") as file:
        file.write(("\n".join(lines) + "\nend_header\n").encode())
        file.write(vertices.tobytes() + rows.tobytes())


def read_ply(path):
    """Points, faces and attributes of a binary PLY of the program's."""
    with open(path, "rb") as file:
        data = file.read()
    head, body = data.split(b"end_header\n", 1)
    counts, columns = {}, []
    element = None
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
        elif words[0] == "property" and element == "vertex":
            columns.append((words[2], PLY_TYPES[words[1]]))
    vertices = np.frombuffer(body, np.dtype(columns), counts["vertex"])
    rows = np.frombuffer(
        body,
        np.dtype([("count", "u1"), ("corners", "<u4", 3)]),
        counts["face"],
        vertices.nbytes,
    )
    points = np.stack([vertices[name] for name in "xyz"], axis=-1)
    attributes = {name: vertices[name] for name, _ in columns if name not in "xyz"}
    return points, rows["corners"], attributes


@pytest.fixture
def program(tmp_path):
    """Runs the program in an empty folder."""

    def run(*words):
        subprocess.run(
            [os.environ["WINNOW_PROGRAM"], *map(str, words)], cwd=tmp_path, check=True, timeout=300
        )

    return run
