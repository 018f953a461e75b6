"""Sequences: arrays (t, n, 3) give what the program makes of a file for each frame."""

import numpy as np
import pytest
import winnow
from conftest import read_ply, waves, write_ply

POINTS, FACES = waves(40)
FRAMES = np.stack([POINTS + np.float32([0, 0, 1]) * np.sin(POINTS[:, :1] + t) for t in range(4)])


def written(program, tmp_path, frames, *words):
    for t, points in enumerate(frames):
        write_ply(tmp_path / f"in-{t}.ply", points, FACES)
    names = [f"in-{t}.ply" for t in range(len(frames))]
    program("sequence", *names, "-o", "out-{frame}.ply", "-q", *words)
    return [read_ply(tmp_path / f"out-{t}.ply")[:2] for t in range(len(frames))]


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_an_array_comes_back_with_one_connectivity(program, tmp_path, dtype):
    moving = FRAMES.astype(dtype)
    want = written(program, tmp_path, moving, "--faces", 600)
    frames, faces = winnow.simplify_sequence(moving, FACES, target_count=600)
    assert isinstance(frames, np.ndarray) and frames.ndim == 3 and frames.dtype == dtype
    assert frames.shape == (4, len(want[0][0]), 3) and 599 <= len(faces) <= 600
    assert frames.flags.owndata and faces.flags.owndata
    for frame, (points, own_faces) in zip(frames, want):
        assert frame.tobytes() == points.tobytes()
        assert np.array_equal(faces, own_faces)


def test_frames_of_their_own_come_back_as_lists(program, tmp_path):
    options = {"target_reduction": 0.8, "per_frame": 0.5, "deformation_weight": 1}
    want = written(program, tmp_path, FRAMES, "--ratio=20%", "--per-frame=0.5",
                   "--deformation-weight=1")
    frames, faces = winnow.simplify_sequence(FRAMES, FACES, **options)
    assert isinstance(frames, list) and isinstance(faces, list) and len(frames) == len(faces) == 4
    for points, own_faces, (want_points, want_faces) in zip(frames, faces, want):
        assert points.tobytes() == want_points.tobytes()
        assert np.array_equal(own_faces, want_faces)
    faces[0][:] = 0  # each owns its memory
    assert faces[1].any()


LAYOUTS = {
    "list": list,
    "fortran": np.asfortranarray,
    "every_other": lambda a: np.repeat(a, 2, axis=1)[:, ::2],
    "time_last": lambda a: np.moveaxis(np.ascontiguousarray(np.moveaxis(a, 0, -1)), -1, 0),
    "generator": lambda a: (frame for frame in a),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_frames_may_have_any_layout(layout):
    want, want_faces = winnow.simplify_sequence(FRAMES, FACES, target_count=500)
    frames, faces = winnow.simplify_sequence(
        LAYOUTS[layout](FRAMES), FACES.astype(np.uint64), target_count=500
    )
    assert frames.tobytes() == want.tobytes()
    assert np.array_equal(faces, want_faces) and faces.dtype == np.uint64


def test_frames_may_be_mapped_from_a_file(tmp_path):
    np.save(tmp_path / "frames.npy", FRAMES)
    mapped = np.load(tmp_path / "frames.npy", mmap_mode="r")
    want, _ = winnow.simplify_sequence(FRAMES, FACES, target_count=500)
    assert winnow.simplify_sequence(mapped, FACES, target_count=500)[0].tobytes() == want.tobytes()


WRONG = [
    (FRAMES[0], FACES, ValueError, r"frames must have the shape \(t, n, 3\)"),
    (FRAMES[:1], FACES, ValueError, "frames must be two or more"),
    (3, FACES, TypeError, r"frames must be an array \(t, n, 3\)"),
    ([POINTS, POINTS[:9]], FACES, ValueError, r"frames\[1\] must have the shape"),
    ([POINTS, POINTS.astype(float)], FACES, TypeError, r"frames\[1\] must be float32"),
    ([POINTS, POINTS.astype("U3")], FACES, TypeError, r"frames\[1\]: points must be float32"),
    (FRAMES, FACES * 1.0, TypeError, "faces must be of a whole-number type"),
    (FRAMES, FACES[:, :2], ValueError, r"faces must have the shape \(m, 3\)"),
]


@pytest.mark.parametrize("frames, faces, kind, message", WRONG)
def test_wrong_arrays_are_named(frames, faces, kind, message):
    with pytest.raises(kind, match=message):
        winnow.simplify_sequence(frames, faces, target_count=100)


def test_wrong_options_are_named():
    for options, message in [
        ({}, "target_count"),
        ({"target_count": 1}, "`target_count` takes"),
        ({"target_count": 99, "per_frame": 3}, "`per_frame`"),
    ]:
        with pytest.raises(winnow.Error, match=message) as error:
            winnow.simplify_sequence(FRAMES, FACES, **options)
        assert error.value.kind == "usage"


def test_a_callback_that_raises_stops_the_run():
    points, faces = waves(400)

    def progress(*_):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        winnow.simplify_sequence([points, points + 1], faces, target_count=100, progress=progress)
