"""Progressive files: what is extracted is what the program extracts."""

import numpy as np
import pytest
import winnow
from conftest import read_ply, waves, write_ply

POINTS, FACES = waves()


@pytest.fixture
def levels(tmp_path):
    heat = np.arange(len(POINTS), dtype=np.float32)
    write_ply(tmp_path / "scan.ply", POINTS, FACES, {"heat": heat})
    winnow.progressive(tmp_path / "scan.ply", tmp_path / "scan.wpm", base=100)
    return winnow.Progressive(tmp_path / "scan.wpm")


def test_the_file_is_the_programs(program, tmp_path, levels):
    program("progressive", "scan.ply", "-o", "program.wpm", "--base", "100", "-q")
    assert (tmp_path / "program.wpm").read_bytes() == (tmp_path / "scan.wpm").read_bytes()


@pytest.mark.parametrize(
    "options", [{"faces": 1000}, {"ratio": 0.1}, {"ratio": 1}, {"faces": 500, "normals": True}]
)
def test_a_level_is_what_the_program_extracts(program, tmp_path, levels, options):
    words = [f"--{n}" if v is True else f"--{n}={v}" for n, v in options.items()]
    program("extract", "scan.wpm", "-o", "out.ply", "-q", *words)
    points, faces, attributes = read_ply(tmp_path / "out.ply")
    mesh = levels.extract(**options)
    assert mesh.points.tobytes() == points.tobytes()
    assert np.array_equal(mesh.faces, faces)
    assert list(mesh.attributes) == list(attributes)
    for name, values in attributes.items():
        assert mesh.attributes[name].tobytes() == values.tobytes()
    for array in (mesh.points, mesh.faces, mesh.attributes["heat"]):
        assert array.flags.owndata and array.flags.writeable


def test_what_there_is_can_be_seen_before_anything_is_extracted(levels):
    assert levels.face_count == levels.info.faces == len(FACES)
    assert 99 <= levels.base_face_count <= 200
    assert levels.info.attributes == ["heat (float)"]
    assert "Progressive(" in repr(levels) and str(len(FACES)) in repr(levels)


def test_up_and_down_gives_the_same_levels(levels):
    few, many = levels.extract(faces=300), levels.extract(faces=3000)
    assert 299 <= len(few.faces) <= 300 and 2999 <= len(many.faces) <= 3000
    assert many.report.input.faces == len(FACES)
    assert np.array_equal(levels.extract(faces=300).points, few.points)


def test_single_steps_lead_to_all_faces_and_back(levels):
    base = levels.mesh()
    assert levels.shown_face_count == levels.base_face_count == len(base.faces)
    counts = [levels.shown_face_count]
    while levels.step_forward():
        counts.append(levels.shown_face_count)
    assert counts == sorted(counts) and counts[-1] == levels.face_count
    assert all(after - before <= 2 for before, after in zip(counts, counts[1:]))
    full = levels.mesh()
    assert np.array_equal(np.sort(full.points, axis=0), np.sort(POINTS, axis=0))
    steps = 0
    while levels.step_back():
        steps += 1
    assert steps == len(counts) - 1
    assert levels.mesh().points.tobytes() == base.points.tobytes()
    assert {tuple(sorted(face)) for face in levels.mesh().faces} == {
        tuple(sorted(face)) for face in base.faces
    }


def test_a_step_changes_one_place_and_points_keep_their_numbers(levels):
    levels.go_to(1000)
    before = levels.mesh()
    assert levels.step_forward()
    after = levels.mesh()
    assert len(after.points) - len(before.points) == 1
    moved = (after.points[: len(before.points)] != before.points).any(axis=1)
    assert moved.sum() <= 1
    assert levels.step_back()
    assert levels.mesh().points.tobytes() == before.points.tobytes()


def test_a_level_that_cannot_be_shown_is_refused(tmp_path, levels):
    with pytest.raises(winnow.Error) as error:
        levels.go_to(5)
    assert error.value.kind == "usage"
    with pytest.raises(winnow.Error) as error:
        winnow.Progressive(tmp_path / "scan.wpm", memory="1K").go_to(5000)
    assert error.value.kind in ("usage", "resources")


def test_counts_that_cannot_be_are_refused(tmp_path, levels):
    for options in ({"faces": 5}, {}, {"ratio": 3}):
        with pytest.raises(winnow.Error) as error:
            levels.extract(**options)
        assert error.value.kind == "usage"
    with pytest.raises(TypeError, match="unexpected keyword argument 'grid'"):
        levels.extract(grid=5)
    with pytest.raises(winnow.Error, match="scan.ply") as error:
        winnow.Progressive(tmp_path / "scan.ply")
    assert error.value.kind == "bad_input"
    with pytest.raises(TypeError, match="path must be"):
        winnow.Progressive(3)
