"""The examples of the docstrings and of docs/python.md run, and the stubs say what is there."""

import doctest
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
import winnow
import winnow._mesh
import winnow._progress
import winnow._report
import winnow._stream

DOCS = pathlib.Path(__file__).parents[2] / "docs" / "python.md"
PACKAGE = pathlib.Path(winnow.__file__).parent


def test_docs_run_as_one_notebook(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = DOCS.read_text()
    cells = re.findall(r"```python\n(.*?)```", text, re.S)
    assert len(cells) > 3
    names = {}
    for cell in cells:
        exec(compile(cell, str(DOCS), "exec"), names)


@pytest.mark.parametrize(
    "name",
    [
        "",
        ".simplify",
        ".simplify_sequence",
        ".Mesh",
        ".Progressive",
        ".Stream",
        ".Report",
        ".progress_bar",
    ],
)
def test_examples_of_docstrings_run(name):
    thing = getattr(winnow, name[1:]) if name else winnow
    runner = doctest.DocTestRunner()
    found = doctest.DocTestFinder(recurse=False).find(thing, "winnow" + name, globs={"np": np})
    examples = [test for test in found if test.examples]
    assert examples
    for test in examples:
        test.globs.update(winnow=winnow, Mesh=winnow.Mesh, Report=winnow.Report)
        test.globs.update(progress_bar=winnow.progress_bar)
        assert runner.run(test).failed == 0


def mypy(module, *words):
    pytest.importorskip("mypy")
    environment = dict(os.environ, MYPYPATH=str(PACKAGE.parent), PYTHONPATH=str(PACKAGE.parent))
    run = subprocess.run(
        [sys.executable, "-m", module, *words], env=environment, capture_output=True, text=True
    )
    return run.returncode, run.stdout + run.stderr


def test_stubs_fit_the_package(tmp_path):
    (tmp_path / "allowed").write_text("winnow\\._.*\n")
    code, text = mypy("mypy.stubtest", "winnow", "--allowlist", str(tmp_path / "allowed"),
                      "--ignore-unused-allowlist", "--ignore-missing-stub")
    assert code == 0, text


TYPED = """
import numpy as np
import winnow

points, faces = winnow.simplify(np.zeros((9, 3)), np.zeros((3, 3), int), target_count=4)
reveal_type(points)
*arrays, where = winnow.simplify(points, faces, target_count=4, return_map=True)
mesh = winnow.simplify(winnow.Mesh(points, faces), target_reduction=0.5, normals=True)
reveal_type(mesh.report)
winnow.simplify_file("a.ply", "b.ply", faces="1M", fit=1, progress=print).output.faces
level = winnow.Progressive("a.wpm").extract(faces=20_000, normals=True)
reveal_type(level.points)
frames, shared = winnow.simplify_sequence(np.zeros((5, 9, 3)), faces, target_count=4)
lists, own = winnow.simplify_sequence([points, points], faces, target_count=4, per_frame=0.5)
"""


def test_a_typed_program_passes_and_a_wrong_one_does_not(tmp_path):
    (tmp_path / "typed.py").write_text(TYPED)
    code, text = mypy("mypy", "--strict", "--no-incremental", str(tmp_path / "typed.py"))
    assert code == 0, text
    assert "ndarray" in text and "Report | None" in text.replace("Union[winnow.Report, None]",
                                                                 "Report | None")
    (tmp_path / "wrong.py").write_text("import winnow\nwinnow.simplify_file(3, 'b', faces=[])\n")
    code, text = mypy("mypy", "--strict", "--no-incremental", str(tmp_path / "wrong.py"))
    assert code == 1 and text.count("error:") == 2, text
