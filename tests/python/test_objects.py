"""Meshes of other packages are taken by what they have, and given back as the same kind."""

import sys
import types

import numpy as np
import pytest
import winnow
from conftest import waves

POINTS, FACES = waves()
WANTED = winnow.simplify(POINTS, FACES, target_count=800)


class Trimesh:
    def __init__(self, vertices, faces, process=True):
        assert not process
        self.vertices, self.faces = vertices, faces


class PolyData:
    def __init__(self, points, faces):
        self.points, self.faces = points, faces


class TriangleMesh:  # its module has `utility`, as open3d has
    def __init__(self, vertices, triangles):
        self.vertices, self.triangles = vertices, triangles


TriangleMesh.__module__ = "open3d_like.geometry"


@pytest.fixture(autouse=True)
def utility(monkeypatch):
    module = types.ModuleType("open3d_like")
    module.utility = types.SimpleNamespace(
        Vector3dVector=lambda a: a.astype(np.float64), Vector3iVector=lambda a: a.astype(np.int32)
    )
    monkeypatch.setitem(sys.modules, "open3d_like", module)


def vtk_faces(faces):
    return np.hstack([np.full((len(faces), 1), 3), faces]).ravel()


def threes(faces):
    return faces.reshape(-1, 4)[:, 1:]


MESHES = {
    "trimesh": (Trimesh(POINTS, FACES, process=False), lambda m: (m.vertices, m.faces)),
    "pyvista": (PolyData(POINTS, vtk_faces(FACES)), lambda m: (m.points, threes(m.faces))),
    "open3d": (TriangleMesh(POINTS, FACES), lambda m: (m.vertices, m.triangles)),
    "winnow": (winnow.Mesh(POINTS, FACES), lambda m: (m.points, m.faces)),
}


@pytest.mark.parametrize("name", MESHES)
def test_a_mesh_comes_back_as_what_it_was(name):
    mesh, arrays = MESHES[name]
    small = winnow.simplify(mesh, target_count=800, like=mesh)
    assert type(small) is type(mesh)
    points, faces = arrays(small)
    assert np.array_equal(points, WANTED[0])
    assert np.array_equal(faces, WANTED[1])


@pytest.mark.parametrize("name", MESHES)
def test_without_like_it_is_a_mesh_of_winnow(name):
    small = winnow.simplify(MESHES[name][0], target_count=800)
    assert isinstance(small, winnow.Mesh)
    assert np.array_equal(small.points, WANTED[0])
    assert 799 <= small.report.output.faces <= 800


def test_arrays_become_what_like_is():
    small = winnow.simplify(POINTS, FACES, target_count=800, like=MESHES["trimesh"][0])
    assert isinstance(small, Trimesh)


def test_polygons_of_vtk_are_refused():
    mesh = PolyData(POINTS, np.array([4, 0, 1, 2, 3]))
    with pytest.raises(ValueError, match="triangulate"):
        winnow.simplify(mesh, target_count=100)
