"""Writes the type stubs of the package `winnow`: its calls with their keywords.

make_stubs.py PACKAGE-FOLDER, which holds the built module; writes __init__.pyi there.
"""

import inspect
import pathlib
import sys

HEAD = '''\
from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from types import TracebackType
from typing import Any, Literal, overload

import numpy as np
import numpy.typing as npt

_Path = str | PathLike[str]
_Array = npt.NDArray[Any]
_Progress = Callable[[str, int, int, str], object]

__version__: str

class Error(Exception):
    kind: str

class MissingPart(Error): ...

class Report(dict[str, Any]):
    def __init__(self, fields: Mapping[str, Any]) -> None: ...
    def __getattr__(self, name: str) -> Any: ...

class Mesh:
    points: _Array
    faces: _Array
    attributes: dict[str, _Array]
    report: Report | None
    def __init__(
        self,
        points: npt.ArrayLike,
        faces: npt.ArrayLike,
        attributes: Mapping[str, npt.ArrayLike] | None = ...,
        report: Report | None = ...,
    ) -> None: ...

class _ProgressBar:
    def __call__(self, stage: str, done: int, total: int, unit: str) -> None: ...
    def close(self) -> None: ...

def progress_bar() -> _ProgressBar: ...
def has_part(name: str) -> bool: ...
'''

# The types of what the calls take besides options.
OWN = {
    "input": "_Path",
    "output": "_Path",
    "original": "_Path",
    "simplified": "_Path",
    "target_count": "int | str | None = ...",
    "target_reduction": "float | None = ...",
    "progress": "_Progress | None = ...",
}
COUNTS = {"N", "SIZE", "BITS"}
NUMBERS = {"LENGTH", "ANGLE", "VALUE"}


def type_of(option):
    if option.flag:
        return "bool = ..."
    if option.takes in COUNTS:
        return "int | str | None = ..."
    if option.takes in NUMBERS:
        return "float | str | None = ..."
    if option.field in ("colored", "picture", "map", "scratch"):
        return "_Path | None = ..."
    if option.field in ("attributes", "crop", "view"):
        return "str | Sequence[Any] | None = ..."
    return "str | None = ..." if option.words else "float | str | None = ..."


def parameters_of(call, options, own):
    lines = []
    for name, parameter in inspect.signature(call).parameters.items():
        if name == "self":
            lines.append("self")
            continue
        if parameter.kind is inspect.Parameter.KEYWORD_ONLY and "*" not in lines:
            lines.append("*")
        kind = own.get(name) or OWN.get(name) or type_of(options[name])
        lines.append(f"{name}: {kind}")
    return ",\n".join("    " + line for line in lines)


def stub_of(name, call, options, returned, own=None, overloaded=False):
    head = "@overload\n" if overloaded else ""
    parameters = parameters_of(call, options, own or {})
    return f"\n{head}def {name}(\n{parameters},\n) -> {returned}: ...\n"


def indented(text):
    return "".join("    " + line if line.strip() else line for line in text.splitlines(True))


def stubs():
    import winnow
    from winnow import _options

    options = {
        option.name: option
        for table in _options.TABLES
        for option in _options.options_of(table)
    }
    text = HEAD
    arrays = {"points": "npt.ArrayLike", "faces": "npt.ArrayLike", "like": "None = ..."}
    of_mesh = {"points": "Any", "faces": "None = ...", "like": "None = ..."}
    like = {"points": "Any", "faces": "npt.ArrayLike | None = ...", "like": "object"}
    plain, mapped = {"return_map": "Literal[False] = ..."}, {"return_map": "Literal[True]"}
    for own, returned in (
        (arrays | plain, "tuple[_Array, _Array]"),
        (arrays | mapped, "tuple[_Array, _Array, _Array]"),
        (of_mesh | plain, "Mesh"),
        (of_mesh | mapped, "tuple[Mesh, _Array]"),
        (like | {"return_map": "bool = ..."}, "Any"),
    ):
        text += stub_of("simplify", winnow.simplify, options, returned, own, overloaded=True)
    several = {"input": "_Path | Sequence[_Path]"}
    text += stub_of("simplify_file", winnow.simplify_file, options, "Report", several)
    text += stub_of("progressive", winnow.progressive, options, "Report", several)
    frames = {"frames": "npt.ArrayLike | Sequence[npt.ArrayLike]", "faces": "npt.ArrayLike"}
    for per_frame, returned in (
        ("None = ...", "tuple[_Array, _Array]"),
        ("float | str", "tuple[Any, Any]"),
    ):
        text += stub_of(
            "simplify_sequence",
            winnow.simplify_sequence,
            options,
            returned,
            frames | {"per_frame": per_frame},
            overloaded=True,
        )
    for call in (winnow.convert, winnow.compare, winnow.info):
        text += stub_of(call.__name__, call, options, "Report")
    text += """
class Progressive:
    info: Report
    face_count: int
    base_face_count: int
    def __init__(self, path: _Path, *, memory: int | str | None = ...) -> None: ...
    @property
    def shown_face_count(self) -> int: ...
    def go_to(self, faces: int) -> None: ...
    def step_forward(self) -> bool: ...
    def step_back(self) -> bool: ...
    def mesh(self) -> Mesh: ...
"""
    text += indented(stub_of("extract", winnow.Progressive.extract, options, "Mesh")[1:])
    text += "\nclass Stream:\n    report: Report | None\n"
    text += indented(stub_of("__init__", winnow.Stream.__init__, options, "None")[1:])
    text += indented('''\
def __enter__(self) -> Stream: ...
def __exit__(
    self,
    kind: type[BaseException] | None,
    error: BaseException | None,
    trace: TracebackType | None,
) -> None: ...
def add(self, points: npt.ArrayLike, faces: npt.ArrayLike) -> None: ...
def add_points(self, points: npt.ArrayLike) -> None: ...
def add_faces(self, faces: npt.ArrayLike) -> None: ...
def finish(self) -> Report: ...
def close(self) -> None: ...
''')
    return text


if __name__ == "__main__":
    package = pathlib.Path(sys.argv[1])
    sys.path.insert(0, str(package.parent))
    (package / "__init__.pyi").write_text(stubs())
