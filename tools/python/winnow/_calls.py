"""The calls of the library."""

import contextlib
import os
from decimal import Decimal

import numpy as np

from . import _mesh, _winnow
from ._mesh import Mesh
from ._options import with_options
from ._report import Report

# Of an array these mean nothing, or have another name.
OF_FILES = ("from", "to", "ascii", "compress", "quantize", "up", "map", "force")
RENAMED = {"faces": "target_count", "ratio": "target_reduction"}


def path_of(path, name):
    if not isinstance(path, (str, os.PathLike)):
        raise TypeError(f"{name} must be the name of a file, not a {type(path).__name__}")
    return os.fspath(path)


def beside(output, surroundings):
    """Where scratch goes unless that is said: beside the output, or to a folder on a disk."""
    if "scratch" not in surroundings:
        folder = os.path.dirname(output) or "." if output and output != "-" else ""
        surroundings["scratch"] = folder or os.environ.get("TMPDIR") or "/var/tmp"
    return surroundings


def check_progress(progress):
    if progress is not None and not callable(progress):
        raise TypeError(f"progress must be callable, not a {type(progress).__name__}")
    return progress


@contextlib.contextmanager
def renamed():
    """Errors with the names that simplify() has for options."""
    try:
        yield
    except _winnow.Error as error:
        error.args = (in_array_words(str(error)),)
        raise


def in_array_words(text):
    for field, name in RENAMED.items():
        text = text.replace(f"`{field}`", f"`{name}`")
    return text


def add_targets(options, target_count, target_reduction):
    if target_count is not None:
        options["faces"] = str(target_count)
    if target_reduction is not None:
        reduction = float(target_reduction)
        if not 0 <= reduction < 1:
            raise ValueError(f"target_reduction must be at least 0 and below 1, not {reduction}")
        options["ratio"] = str(1 - Decimal(repr(reduction)))  # of 0.9 it is 0.1


def of_type(faces, given):
    """Of the type that the faces of the input have, where that was a choice."""
    return faces if given.dtype == faces.dtype else faces.astype(given.dtype)


@with_options("simplify", leave_out=(*OF_FILES, *RENAMED))
def simplify(
    points,
    faces=None,
    *,
    target_count=None,
    target_reduction=None,
    like=None,
    return_map=False,
    progress=None,
    options,
    surroundings,
):
    """Makes a mesh in memory small: arrays in, arrays out.

    points: array (n, 3), float32 or float64, in any unit, of any layout; or a mesh: a
        `winnow.Mesh`, or an object with `.vertices` and `.faces` (trimesh), `.points` and VTK's
        faces (PyVista), `.vertices` and `.triangles` (Open3D).
    faces: array (m, 3) of a whole-number type, numbers of points from 0; only with an array.
    target_count: exactly so many faces; 4 or more.
    target_reduction: this part of the faces goes; from 0 to below 1.
    like: a mesh of the kind that is returned.
    return_map: also where the points went: array (n), int64, of each point of the input the number
        of the new point that it became a part of; -1 where there is none.
    progress: called with a stage, how much is done, of how much (0: not known), and the unit.

    Returns (points, faces) for arrays, and a `winnow.Mesh` with attributes and report for a mesh,
    unless `like` is given; with `return_map` the map comes behind. The arrays own their memory;
    faces have the type of the input's. The input is not copied where the numbers of a row stand
    side by side, and must not change meanwhile.

    Raises TypeError and ValueError for arrays of other types and shapes, naming them, and
    winnow.Error. What `progress` raises ends the call, and so does Ctrl-C.

    >>> import numpy as np, winnow
    >>> x, y = np.meshgrid(np.arange(50.0), np.arange(50.0))
    >>> points = np.stack([x, y, np.sin(x / 5)], axis=-1).reshape(-1, 3)
    >>> corner = (np.arange(49)[:, None] * 50 + np.arange(49)).ravel()
    >>> faces = np.concatenate([corner + [[0], [1], [51]], corner + [[0], [51], [50]]], axis=1).T
    >>> points, faces = winnow.simplify(points, faces, target_count=500)
    >>> faces.shape
    (500, 3)
    """
    check_progress(progress)
    if faces is not None:
        mesh = Mesh(points, faces)
    else:
        if isinstance(points, (np.ndarray, list)):
            raise TypeError("faces is missing; it must be an array (m, 3)")
        mesh = _mesh.mesh_of(points)
    add_targets(options, target_count, target_reduction)
    with renamed():
        arrays, where, report = _winnow.simplify_arrays(
            mesh.points,
            mesh.faces,
            list(mesh.attributes.items()),
            bool(return_map),
            options,
            beside("", surroundings),
            progress,
        )
    new_points, new_faces, attributes = arrays
    new_faces = of_type(new_faces, mesh.faces)
    if faces is not None and like is None:
        return (new_points, new_faces, where) if return_map else (new_points, new_faces)
    report["notes"] = [in_array_words(note) for note in report["notes"]]
    small = Mesh(new_points, new_faces, attributes, Report(report))
    small = small if like is None else _mesh.same_kind(small, like)
    return (small, where) if return_map else small


simplify.__doc__ = in_array_words(simplify.__doc__)


@with_options("simplify")
def simplify_file(input, output, *, progress=None, options, surroundings):
    """Makes a mesh in a file small: from file to file, of any size, in bounded memory.

    input: the name of a file, or a list of names, which are one model.
    output: the name of the file to write.
    progress: called with a stage, how much is done, of how much (0: not known), and the unit.

    Returns a Report. Raises winnow.Error; what `progress` raises ends the call, and so does Ctrl-C.
    """
    inputs = input if isinstance(input, (list, tuple)) else [input]
    output = path_of(output, "output")
    report = _winnow.simplify_files(
        [path_of(name, "input") for name in inputs],
        output,
        options,
        beside(output, surroundings),
        check_progress(progress),
    )
    return Report(report)


@with_options("convert")
def convert(input, output, *, progress=None, options, surroundings):
    """Changes the format of a mesh, and nothing else.

    input, output: names of files.
    progress: called with a stage, how much is done, of how much (0: not known), and the unit.

    Returns a Report. Raises winnow.Error.
    """
    output = path_of(output, "output")
    return Report(
        _winnow.convert_file(
            path_of(input, "input"),
            output,
            options,
            beside(output, surroundings),
            check_progress(progress),
        )
    )


@with_options("compare")
def compare(original, simplified, *, progress=None, options, surroundings):
    """Measures how far a small mesh is from its original, and what is wrong with it.

    original, simplified: names of files; the second must fit into memory.
    progress: called with a stage, how much is done, of how much (0: not known), and the unit.

    Returns a Report; distances are in model units, and in percent of the diagonal. Raises
    winnow.Error.
    """
    return Report(
        _winnow.compare_files(
            path_of(original, "original"),
            path_of(simplified, "simplified"),
            options,
            beside("", surroundings),
            check_progress(progress),
        )
    )


@with_options(
    "convert",
    leave_out=("strict", "to", "ascii", "positions", "compress", "quantize", "up", "force"),
)
def info(input, *, progress=None, options, surroundings):
    """Tells what is in a mesh: format, counts, box, watertight or not, parts, volume.

    input: the name of a file.
    progress: called with a stage, how much is done, of how much (0: not known), and the unit.

    Returns a Report; lengths are in model units. Raises winnow.Error.
    """
    return Report(
        _winnow.info_of_file(
            path_of(input, "input"),
            options,
            beside("", surroundings),
            check_progress(progress),
        )
    )


def has_part(name):
    """Whether winnow was built with a part that may be left out: 'gltf' or 'compare'.

    Calls that need a part that is not there raise winnow.MissingPart.
    """
    if name not in ("gltf", "compare"):
        raise ValueError(f"name must be 'gltf' or 'compare', not {name!r}")
    return name in _winnow.built_parts()
