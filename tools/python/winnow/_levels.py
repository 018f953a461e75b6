"""Progressive files: all levels of detail of a mesh in one file."""

from . import _winnow
from ._calls import OF_FILES, beside, check_progress, path_of
from ._mesh import Mesh
from ._options import text_of, with_options
from ._report import Report


@with_options("progressive")
def progressive(input, output, *, progress=None, options, surroundings):
    """Writes a mesh as a progressive file: every count of faces from the base to all in one file.

    input: the name of a file, or a list of names, which are one model.
    output: the name of the file to write; such names end in .wpm.
    progress: called with a stage, how much is done, of how much (0: not known), and the unit.

    Returns a Report. Raises winnow.Error; what `progress` raises ends the call, and so does Ctrl-C.
    `winnow.Progressive` opens the file.
    """
    inputs = input if isinstance(input, (list, tuple)) else [input]
    output = path_of(output, "output")
    return Report(
        _winnow.progressive_file(
            [path_of(name, "input") for name in inputs],
            output,
            options,
            beside(output, surroundings),
            check_progress(progress),
        )
    )


class Progressive:
    """A progressive file, of which every level of detail can be extracted.

    path: the name of a file that `winnow.progressive` or the program wrote.
    memory: what the level that is shown may take, with the steps back from it (default "512M").

    face_count, base_face_count: faces at full count, and of the coarsest mesh.
    info: what the header says, a Report.
    shown_face_count: faces of the level that is shown, the coarsest at first.

    Raises winnow.Error where it is no such file.

    >>> import numpy as np, os, tempfile, winnow
    >>> folder = tempfile.TemporaryDirectory()
    >>> scan, levels = (os.path.join(folder.name, name) for name in ("scan.ply", "scan.wpm"))
    >>> with winnow.Stream(scan, ratio=1) as stream:
    ...     x, y = np.meshgrid(np.arange(30.0), np.arange(30.0))
    ...     corner = (np.arange(29)[:, None] * 30 + np.arange(29)).ravel()
    ...     faces = np.concatenate([corner + [[0], [1], [31]], corner + [[0], [31], [30]]], axis=1)
    ...     stream.add(np.stack([x, y, np.sin(x / 3)], axis=-1).reshape(-1, 3), faces.T)
    >>> report = winnow.progressive(scan, levels, base=100)
    >>> levels = winnow.Progressive(levels)
    >>> levels.face_count
    1682
    >>> len(levels.extract(faces=500).faces) in (499, 500)
    True
    >>> levels.go_to(500)
    >>> shown = levels.shown_face_count
    >>> levels.step_forward() and levels.step_back() and levels.shown_face_count == shown
    True
    """

    def __init__(self, path, *, memory=None):
        self._path = path_of(path, "path")
        self._surroundings = {} if memory is None else {"memory": text_of(memory, "memory")}
        self._level = None
        self.info = Report(_winnow.info_of_levels(self._path, {}))
        self.face_count = self.info.faces
        self.base_face_count = self.info.base_faces

    def __repr__(self):
        return f"Progressive({self._path!r}, {self.base_face_count} to {self.face_count} faces)"

    @with_options("extract", leave_out=OF_FILES)
    def extract(self, *, progress=None, options, surroundings):
        """The mesh of so many faces, or of one collapse less: what the program extracts.

        The file is read no further than the count needs.

        progress: called with a stage, how much is done, of how much (0: not known), and the unit.

        Returns a `winnow.Mesh` with attributes and report, whose arrays own their memory. Raises
        winnow.Error, also for fewer faces than the base has.
        """
        (points, faces, attributes), report = _winnow.extract_arrays(
            self._path, options, beside("", surroundings), check_progress(progress)
        )
        return Mesh(points, faces, attributes, Report(report))

    def _shown(self):
        if self._level is None:
            surroundings = beside("", dict(self._surroundings))
            self._level = _winnow.ShownLevel(self._path, surroundings)
        return self._level

    @property
    def shown_face_count(self):
        return self._shown().face_count()

    def go_to(self, faces):
        """Shows the most faces that are no more than this: one collapse less at the most."""
        self._shown().go_to(int(faces))

    def step_forward(self):
        """Takes one collapse back. False at full count."""
        return self._shown().step_forward()

    def step_back(self):
        """Makes the last of these collapses again. False at the coarsest mesh."""
        return self._shown().step_back()

    def mesh(self):
        """The level that is shown, a `winnow.Mesh` of arrays that own their memory.

        A point keeps its number as long as it is there; some may have no face. Flipped faces stay
        as they are, as with `raw`.
        """
        return Mesh(*self._shown().arrays())
