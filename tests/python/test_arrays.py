"""Every type and layout of arrays gives the same result, and outputs own their memory."""

import numpy as np
import pytest
import winnow
from conftest import waves

POINTS, FACES = waves()
WANTED = winnow.simplify(POINTS, FACES, target_count=800)


def check(points, faces):
    new_points, new_faces = winnow.simplify(points, faces, target_count=800)
    assert new_points.tobytes() == WANTED[0].tobytes()
    assert np.array_equal(new_faces, WANTED[1])
    return new_points, new_faces


@pytest.mark.parametrize("dtype", "i2 u2 i4 u4 i8 u8 >i4 >u8".split())
def test_faces_may_have_any_whole_number_type(dtype):
    _, faces = check(POINTS, FACES.astype(dtype))
    wide = np.dtype(dtype).itemsize >= 4
    assert faces.dtype == (np.dtype(dtype).newbyteorder("=") if wide else np.int32)


def padded(array):
    wide = np.zeros((len(array), 5), array.dtype)
    wide[:, 1:4] = array
    return wide[:, 1:4]


LAYOUTS = {
    "fortran": np.asfortranarray,
    "padded": padded,
    "reversed": lambda a: a[::-1].copy()[::-1],
    "every_other": lambda a: np.repeat(a, 2, axis=0)[::2],
    "foreign_bytes": lambda a: a.astype(a.dtype.newbyteorder(">")),
    "turned": lambda a: a[:, ::-1].copy()[:, ::-1],
    "lists": lambda a: a.tolist(),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_arrays_may_have_any_layout(layout):
    points, faces = LAYOUTS[layout](POINTS), LAYOUTS[layout](FACES)
    if layout == "lists":
        points = np.float32(points)  # numbers in lists are double
    check(points, faces)


def test_arrays_may_be_read_only_or_mapped(tmp_path):
    np.save(tmp_path / "points.npy", POINTS)
    mapped = np.load(tmp_path / "points.npy", mmap_mode="r")
    check(mapped, FACES)


def test_nothing_is_copied_where_rows_stand_apart():
    structs = np.zeros(len(POINTS), np.dtype([("at", "f4", 3), ("heat", "f4")]))
    structs["at"], structs["heat"] = POINTS, POINTS[:, 2]
    mesh = winnow.Mesh(structs["at"], FACES, {"heat": structs["heat"]})
    assert np.shares_memory(mesh.points, structs)
    assert np.shares_memory(mesh.faces, FACES)
    assert np.shares_memory(mesh.attributes["heat"], structs)
    small = winnow.simplify(mesh, target_count=800)
    assert small.points.tobytes() == WANTED[0].tobytes()


def test_outputs_own_their_memory():
    before = POINTS.copy()
    mesh = winnow.simplify(winnow.Mesh(POINTS, FACES, {"heat": POINTS[:, 2]}), target_count=800)
    for array in (mesh.points, mesh.faces, mesh.attributes["heat"]):
        assert array.flags.owndata and array.flags.writeable and array.flags.c_contiguous
    mesh.points[:] = 0
    assert np.array_equal(POINTS, before)


def test_positions_have_the_type_of_the_input_unless_another_is_wanted():
    assert winnow.simplify(POINTS, FACES, target_count=800)[0].dtype == np.float32
    assert winnow.simplify(POINTS.astype(float), FACES, target_count=800)[0].dtype == np.float64
    points, _ = winnow.simplify(POINTS, FACES, target_count=800, positions="double")
    assert points.dtype == np.float64


@pytest.mark.parametrize("options", [{"target_count": 800}, {"cell": 2}, {"target_count": 90}])
def test_the_map_leads_from_each_point_to_a_new_one(options):
    points, faces, where = winnow.simplify(POINTS, FACES, return_map=True, **options)
    again = winnow.simplify(POINTS, FACES, **options)
    assert np.array_equal(points, again[0]) and np.array_equal(faces, again[1])
    assert where.shape == (len(POINTS),) and where.dtype == np.int64 and where.flags.owndata
    assert where.min() >= -1 and np.array_equal(np.unique(where[where >= 0]), range(len(points)))
    # Each face that is left is where one of the input went.
    images = {tuple(sorted(face)) for face in where[FACES].tolist()}
    assert all(tuple(sorted(face)) in images for face in faces.tolist())


def test_the_map_comes_beside_a_mesh():
    mesh, where = winnow.simplify(winnow.Mesh(POINTS, FACES), target_count=800, return_map=True)
    assert np.array_equal(mesh.points, WANTED[0])
    unused = np.append(POINTS, [[1, 2, 3]], axis=0).astype(POINTS.dtype)
    *_, longer = winnow.simplify(unused, FACES, target_count=800, return_map=True)
    assert len(longer) == len(where) + 1 and longer[-1] == -1 and longer[0] >= 0
