"""Arrays give what the program makes of their file, and files give the same bytes."""

import numpy as np
import pytest
import winnow
from conftest import read_ply, waves, write_ply

OPTIONS = [
    {"target_count": 500},
    {"target_reduction": 0.9},
    {"error": "0.1%"},
    {"target_count": 500, "fit": 2},
    {"cell": 3.0},
    {"grid": 12, "normals": True},
    {"target_count": 300, "refine": "volume"},
    {"target_count": 300, "refine": "importance", "boundary": "keep"},
    {"target_count": 600, "topology": "free", "max_normal_deviation": 30},
    {"target_count": 200, "crop": [[5, 5, -2], [40, 30, 2]], "weld": 0.01, "detail": "full"},
]


def words_of(options):
    words = []
    for name, value in options.items():
        if name == "target_count":
            words += ["--faces", value]
        elif name == "target_reduction":
            words += ["--ratio", {0.9: "10%"}[value]]
        elif value is True:
            words += ["--" + name]
        elif name == "crop":
            words += ["--crop", ",".join(str(x) for x in np.ravel(value))]
        else:
            words += ["--" + name.replace("_", "-"), value]
    return words


@pytest.mark.parametrize("options", OPTIONS, ids=lambda options: " ".join(map(str, options)))
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_arrays_give_what_the_program_writes(program, tmp_path, options, dtype):
    points, faces = waves(dtype=dtype)
    write_ply(tmp_path / "in.ply", points, faces)
    program("simplify", "in.ply", "-o", "out.ply", "-q", *words_of(options))
    want_points, want_faces, want_attributes = read_ply(tmp_path / "out.ply")
    mesh = winnow.simplify(winnow.Mesh(points, faces), **options)
    assert mesh.points.dtype == want_points.dtype
    assert mesh.points.tobytes() == want_points.tobytes()
    assert np.array_equal(mesh.faces, want_faces)
    assert {n: a.tobytes() for n, a in mesh.attributes.items()} == {
        n: a.tobytes() for n, a in want_attributes.items()
    }


def test_attributes_come_back_as_the_program_writes_them(program, tmp_path):
    points, faces = waves()
    random = np.random.default_rng(5)
    attributes = {
        "red": random.integers(0, 256, len(points)).astype(np.uint8),
        "green": random.integers(0, 256, len(points)).astype(np.uint8),
        "blue": random.integers(0, 256, len(points)).astype(np.uint8),
        "heat": random.random(len(points)).astype(np.float32),
        "depth": random.random(len(points)),
    }
    write_ply(tmp_path / "in.ply", points, faces, attributes)
    program("simplify", "in.ply", "-o", "out.ply", "-q", "--faces", 700)
    _, _, want = read_ply(tmp_path / "out.ply")
    mesh = winnow.simplify(winnow.Mesh(points, faces, attributes), target_count=700)
    assert list(mesh.attributes) == list(want)
    for name, values in want.items():
        assert mesh.attributes[name].dtype == values.dtype
        assert mesh.attributes[name].tobytes() == values.tobytes()


def test_files_give_the_same_bytes(program, tmp_path):
    points, faces = waves()
    write_ply(tmp_path / "in.ply", points, faces)
    program("simplify", "in.ply", "-o", "out.obj", "-q", "--faces", 900)
    report = winnow.simplify_file(tmp_path / "in.ply", tmp_path / "new.obj", faces=900)
    assert (tmp_path / "new.obj").read_bytes() == (tmp_path / "out.obj").read_bytes()
    assert 898 <= report.output.faces <= 900  # at most one collapse less
    program("convert", "out.obj", "-o", "out.stl", "-q")
    winnow.convert(tmp_path / "out.obj", tmp_path / "new.stl")
    assert (tmp_path / "new.stl").read_bytes() == (tmp_path / "out.stl").read_bytes()


@pytest.mark.parametrize("batch", [1, 7, 100])
def test_a_stream_gives_the_bytes_of_its_file(program, tmp_path, batch):
    points, faces = waves()
    write_ply(tmp_path / "in.ply", points, faces)
    program("simplify", "in.ply", "-o", "out.ply", "-q", "--faces", 400)
    with winnow.Stream(tmp_path / "new.ply", faces=400) as stream:
        for part in np.array_split(points, batch):
            stream.add_points(part)
        for part in np.array_split(faces, batch):
            stream.add_faces(part)
    assert stream.report.input.faces == len(faces)
    assert (tmp_path / "new.ply").read_bytes() == (tmp_path / "out.ply").read_bytes()


def test_threads_and_memory_change_nothing():
    points, faces = waves(200)
    results = [
        winnow.simplify(points, faces, target_count=5000, threads=threads, memory=memory)
        for threads, memory in [(1, "512M"), (2, "512M"), (2, "64M")]
    ]
    for new_points, new_faces in results[1:]:
        assert new_points.tobytes() == results[0][0].tobytes()
        assert new_faces.tobytes() == results[0][1].tobytes()
