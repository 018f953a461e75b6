"""Meshes as arrays: what is taken, what is given back."""

import sys

import numpy as np


class Mesh:
    """A triangle mesh: its vertices, its faces, and what the vertices carry.

    points: array (n, 3), float32 or float64; in any unit.
    faces: array (m, 3) of a whole-number type; numbers of points, from 0.
    attributes: a dict of arrays (n), by name. `nx`, `ny`, `nz` are a normal, `red`, `green`, `blue`
        a colour; others are any number. Up to 32 bits or float64.
    report: what `simplify` did, where it made the mesh.

    Raises TypeError and ValueError, naming the argument, where a type or a shape is another.

    >>> mesh = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], {"heat": np.zeros(3)})
    >>> mesh
    Mesh(3 points, 1 faces, heat)
    """

    def __init__(self, points, faces, attributes=None, report=None):
        self.points = points_of(points)
        self.faces = faces_of(faces)
        self.attributes = {
            name: attribute_of(name, values, len(self.points))
            for name, values in (attributes or {}).items()
        }
        self.report = report

    def __repr__(self):
        names = "".join(f", {name}" for name in self.attributes)
        return f"Mesh({len(self.points)} points, {len(self.faces)} faces{names})"


def native(array):
    """With the bytes of numbers in this machine's order."""
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def side_by_side(array):
    """With rows that the library reads where they are; copied only where they are not."""
    rows, width = array.strides[0], array.itemsize * (array.shape[1] if array.ndim == 2 else 1)
    packed = array.ndim == 1 or array.strides[1] == array.itemsize
    if packed and (rows >= width or len(array) < 2):
        return array if len(array) > 1 else np.ascontiguousarray(array)
    return np.ascontiguousarray(array)


def rows_of_three(array, name, count):
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} must have the shape ({count}, 3), not {array.shape}")
    return side_by_side(native(array))


def points_of(points):
    given = isinstance(points, np.ndarray)
    array = np.asarray(points)
    if not given and array.dtype.kind in "iu":
        array = array.astype(np.float64)
    if array.size == 0 and array.ndim == 1 and not given:
        array = np.empty((0, 3))
    if array.dtype.kind != "f" or array.itemsize not in (4, 8):
        raise TypeError(f"points must be float32 or float64, not {array.dtype}")
    return rows_of_three(array, "points", "n")


def faces_of(faces):
    given = isinstance(faces, np.ndarray)
    array = np.asarray(faces)
    if array.size == 0 and array.ndim == 1 and not given:
        array = np.empty((0, 3), np.int32)
    if array.dtype.kind not in "iu":
        raise TypeError(f"faces must be of a whole-number type, not {array.dtype}")
    if array.itemsize < 4:
        array = array.astype(np.int32)
    return rows_of_three(array, "faces", "m")


def attribute_of(name, values, count):
    if not isinstance(name, str):
        raise TypeError(f"attributes must have texts as names, not {name!r}")
    array = np.asarray(values)
    if array.dtype.kind not in "iuf" or (array.dtype.kind == "f" and array.itemsize not in (4, 8)):
        raise TypeError(f"attributes: '{name}' must be of numbers, not {array.dtype}")
    if array.dtype.kind in "iu" and array.itemsize == 8:
        raise TypeError(f"attributes: '{name}' must be of up to 32 bits or float64")
    if array.shape != (count,):
        raise ValueError(f"attributes: '{name}' must have the shape ({count},), not {array.shape}")
    return side_by_side(native(array))


# Of other packages' meshes nothing is imported: they are known by what they have.


def triangles_of_vtk(faces):
    """3, i, j, k, 3, i, j, k, ... as rows of three."""
    flat = np.asarray(faces)
    if flat.ndim != 1:
        return flat
    if flat.size % 4 != 0 or (flat.size and (flat.reshape(-1, 4)[:, 0] != 3).any()):
        raise ValueError("faces must all be triangles; triangulate() the mesh first")
    return flat.reshape(-1, 4)[:, 1:]


def is_mesh(thing):
    return hasattr(thing, "vertices") or (hasattr(thing, "points") and hasattr(thing, "faces"))


def mesh_of(thing):
    """A Mesh of anything that is known as one."""
    if isinstance(thing, Mesh):
        return Mesh(thing.points, thing.faces, thing.attributes)
    if hasattr(thing, "vertices") and hasattr(thing, "triangles"):  # Open3D
        return Mesh(np.asarray(thing.vertices), np.asarray(thing.triangles))
    if hasattr(thing, "vertices") and hasattr(thing, "faces"):  # trimesh
        return Mesh(np.asarray(thing.vertices), np.asarray(thing.faces))
    if hasattr(thing, "points") and hasattr(thing, "faces"):  # PyVista
        return Mesh(np.asarray(thing.points), triangles_of_vtk(thing.faces))
    raise TypeError(
        f"points must be an array or a mesh (with .vertices or .points, and .faces), not a "
        f"{type(thing).__name__}"
    )


def same_kind(mesh, like):
    """`mesh` as an object of the kind of `like`."""
    if isinstance(like, Mesh):
        return mesh
    kind = like if isinstance(like, type) else type(like)
    if hasattr(like, "vertices") and hasattr(like, "triangles"):
        utility = sys.modules[kind.__module__.split(".")[0]].utility
        return kind(
            utility.Vector3dVector(mesh.points.astype(np.float64)),
            utility.Vector3iVector(mesh.faces.astype(np.int32)),
        )
    if hasattr(like, "vertices") and hasattr(like, "faces"):
        return kind(vertices=mesh.points, faces=mesh.faces.astype(np.int64), process=False)
    if hasattr(like, "points") and hasattr(like, "faces"):
        threes = np.full((len(mesh.faces), 1), 3, np.int64)
        return kind(mesh.points, np.hstack([threes, mesh.faces.astype(np.int64)]).ravel())
    raise TypeError(f"like must be a mesh, not a {kind.__name__}")
