"""Files: reports, converting, comparing, streams."""

import inspect

import numpy as np
import pytest
import winnow
from conftest import waves, write_ply

POINTS, FACES = waves()


@pytest.fixture
def scan(tmp_path):
    write_ply(tmp_path / "scan.ply", POINTS, FACES)
    return tmp_path / "scan.ply"


def test_info_tells_what_is_in_a_mesh(scan):
    report = winnow.info(scan)
    assert report.faces == report["faces"] == len(FACES)
    assert report.vertices == len(POINTS)
    assert report.edges.boundary == 4 * 59
    assert not report.watertight
    assert np.allclose(report.box.min, POINTS.min(axis=0))
    assert "faces" in dir(report)
    with pytest.raises(AttributeError, match="no 'face'"):
        report.face


def test_compare_tells_distances(scan, tmp_path):
    winnow.simplify_file(scan, tmp_path / "small.ply", faces=1000)
    report = winnow.compare(scan, tmp_path / "small.ply", samples=10000, fail_above="1%")
    assert 0 < report.distance.symmetric.rms_percent < 1
    assert report.fail_above.exceeded is False
    assert 999 <= report.simplified.faces <= 1000  # at most one collapse less


def test_several_files_are_one_model(scan, tmp_path):
    write_ply(tmp_path / "other.ply", POINTS + np.float32([100, 0, 0]), FACES)
    report = winnow.simplify_file([scan, tmp_path / "other.ply"], tmp_path / "all.ply", faces=2000)
    assert report.input.faces == 2 * len(FACES)


def test_an_output_is_replaced_only_if_that_is_said(scan, tmp_path):
    winnow.convert(scan, tmp_path / "scan.obj")
    with pytest.raises(winnow.Error, match="`force`") as error:
        winnow.convert(scan, tmp_path / "scan.obj")
    assert error.value.kind == "usage"
    winnow.convert(scan, tmp_path / "scan.obj", force=True, from_="ply")


def test_a_stream_takes_batches_with_numbers_of_their_own(tmp_path):
    with winnow.Stream(tmp_path / "small.ply", faces=2000) as stream:
        for i in range(3):
            stream.add(POINTS + np.float32([0, 0, 10 * i]), FACES)
    assert stream.report.input.faces == 3 * len(FACES)
    assert stream.report.input.bad_faces.out_of_range == 0
    assert stream.report.output.faces <= 2000


def test_faces_beyond_a_batch_are_bad(tmp_path):
    with winnow.Stream(tmp_path / "small.ply", faces=2000) as stream:
        stream.add(POINTS, FACES)
        stream.add(POINTS, np.array([[0, 1, len(POINTS)], [0, 1, -1]]))
    assert stream.report.input.bad_faces.out_of_range == 2


def test_an_exception_in_a_stream_leaves_nothing(tmp_path):
    with pytest.raises(RuntimeError):
        with winnow.Stream(tmp_path / "small.ply", faces=2000) as stream:
            stream.add(POINTS, FACES)
            raise RuntimeError
    assert list(tmp_path.iterdir()) == []
    with pytest.raises(ValueError, match="closed"):
        stream.add(POINTS, FACES)


def test_a_stream_is_of_one_type(tmp_path):
    stream = winnow.Stream(tmp_path / "small.ply", faces=2000)
    stream.add(POINTS, FACES)
    with pytest.raises(winnow.Error) as error:
        stream.add(POINTS.astype(float), FACES)
    assert error.value.kind == "usage"
    stream.close()
    assert list(tmp_path.iterdir()) == []


def test_keywords_are_those_of_the_program():
    for call in (winnow.simplify_file, winnow.convert, winnow.compare):
        parameters = inspect.signature(call).parameters
        assert {"memory", "threads", "scratch", "progress", "force"} <= set(parameters)
        for name in parameters:
            assert f"{name}:" in call.__doc__ or name in call.__doc__
    assert "max_normal_deviation" in inspect.signature(winnow.simplify).parameters
    assert "from" not in inspect.signature(winnow.convert).parameters
    assert "Default 6" in winnow.simplify.__doc__ or "default 6" in winnow.simplify.__doc__
