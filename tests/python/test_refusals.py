"""What cannot be taken is refused by name."""

import numpy as np
import pytest
import winnow
from conftest import waves

POINTS, FACES = waves()

WRONG = [
    (POINTS.astype(np.int32), FACES, TypeError, "points must be float32 or float64, not int32"),
    (POINTS.astype(np.float16), FACES, TypeError, "points must be float32 or float64"),
    (POINTS.astype(complex), FACES, TypeError, "points must be float32 or float64"),
    (POINTS[:, :2], FACES, ValueError, r"points must have the shape \(n, 3\), not \(3600, 2\)"),
    (POINTS.ravel(), FACES, ValueError, "points must have the shape"),
    (POINTS, FACES.astype(float), TypeError, "faces must be of a whole-number type, not float64"),
    (POINTS, FACES > 3, TypeError, "faces must be of a whole-number type, not bool"),
    (POINTS, FACES[:, :2], ValueError, r"faces must have the shape \(m, 3\)"),
    (POINTS, FACES.ravel(), ValueError, "faces must have the shape"),
    (POINTS, None, TypeError, "faces is missing"),
    ("scan.ply", None, TypeError, "points must be an array or a mesh"),
]


@pytest.mark.parametrize("points, faces, kind, message", WRONG)
def test_wrong_arrays_are_named(points, faces, kind, message):
    with pytest.raises(kind, match=message):
        winnow.simplify(points, faces, target_count=100)


ATTRIBUTES = [
    (np.zeros(5), ValueError, r"attributes: 'heat' must have the shape \(3600,\), not \(5,\)"),
    (np.zeros((3600, 2)), ValueError, "attributes: 'heat' must have the shape"),
    (np.zeros(3600, np.int64), TypeError, "attributes: 'heat' must be of up to 32 bits"),
    (np.zeros(3600, "U3"), TypeError, "attributes: 'heat' must be of numbers"),
]


@pytest.mark.parametrize("values, kind, message", ATTRIBUTES)
def test_wrong_attributes_are_named(values, kind, message):
    with pytest.raises(kind, match=message):
        winnow.Mesh(POINTS, FACES, {"heat": values})


OPTIONS = [
    ({}, winnow.Error, "target_count"),
    ({"target_count": 2}, winnow.Error, "`target_count` takes"),
    ({"target_count": "many"}, winnow.Error, "`target_count` takes"),
    ({"target_reduction": 1.5}, ValueError, "target_reduction must be"),
    ({"target_count": 9, "refine": "best"}, winnow.Error, "`refine` takes one of"),
    ({"target_count": 9, "max_normal_deviation": 95}, winnow.Error, "`max_normal_deviation`"),
    ({"target_count": 9, "memory": "1k"}, winnow.Error, "`memory`"),
    ({"target_count": 9, "normals": "yes"}, TypeError, "normals takes True or False"),
    ({"target_count": 9, "refine": 3j}, TypeError, "refine takes no complex"),
    ({"faces_wanted": 9}, TypeError, "unexpected keyword argument 'faces_wanted'"),
    ({"target_count": 9, "progress": 3}, TypeError, "progress must be callable"),
    ({"target_count": 9, "like": 3}, TypeError, "like must be a mesh"),
]


@pytest.mark.parametrize("options, kind, message", OPTIONS)
def test_wrong_options_are_named(options, kind, message):
    with pytest.raises(kind, match=message):
        winnow.simplify(POINTS, FACES, **options)


def test_errors_have_a_kind(tmp_path):
    with pytest.raises(winnow.Error) as usage:
        winnow.simplify(POINTS, FACES, target_count=2)
    assert usage.value.kind == "usage"
    (tmp_path / "not.ply").write_text("ply\nnot at all\n")
    with pytest.raises(winnow.Error, match="not.ply") as bad:
        winnow.info(tmp_path / "not.ply")
    assert bad.value.kind == "bad_input"
    with pytest.raises(winnow.Error, match="none.ply"):
        winnow.simplify_file(tmp_path / "none.ply", tmp_path / "out.ply", faces=100)
    assert not (tmp_path / "out.ply").exists()


def test_nothing_to_simplify_is_bad_input():
    for points, faces in [([], []), (POINTS, np.empty((0, 3), int)), (POINTS * np.nan, FACES)]:
        with pytest.raises(winnow.Error) as error:
            winnow.simplify(points, faces, target_count=100)
        assert error.value.kind == "bad_input"


def test_indices_out_of_range_are_counted_and_left_out():
    bad = np.array([[0, 1, -1], [0, 1, 3600], [0, 1, 2**40]])
    mesh = winnow.simplify(
        winnow.Mesh(POINTS, np.concatenate([FACES.astype(np.int64), bad])), target_count=800
    )
    assert mesh.report.input.bad_faces.out_of_range == 3
    assert 799 <= len(mesh.faces) <= 800
