"""A mesh that comes batch by batch."""

import numpy as np

from . import _winnow
from ._calls import beside, check_progress, path_of
from ._mesh import faces_of, points_of
from ._options import with_options
from ._report import Report


class Stream:
    @with_options("simplify", leave_out=("from",))
    def __init__(self, output, *, progress=None, options, surroundings):
        """Takes a mesh of any size batch by batch, and writes a small one.

        output: the name of the file to write.
        progress: called with a stage, how much is done, of how much (0: not known), and the unit.

        What is added is kept in memory while half of the budget lasts, and then in scratch. As a
        context manager it finishes at the end; an exception leaves nothing behind.

        >>> import numpy as np, os, tempfile, winnow
        >>> square = np.float32([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
        >>> folder = tempfile.TemporaryDirectory()
        >>> with winnow.Stream(os.path.join(folder.name, "small.ply"), faces=8) as stream:
        ...     for x in range(4):
        ...         stream.add(square + np.float32([x, 0, 0]), [[0, 1, 2], [0, 2, 3]])
        >>> stream.report.input.faces
        8
        """
        self._stream = None
        self._count = 0
        self._progress = check_progress(progress)
        self.report = None
        output = path_of(output, "output")
        self._stream = _winnow.Stream(output, options, beside(output, surroundings))

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if kind is None:
            self.finish()
        else:
            self.close()

    def add(self, points, faces):
        """Adds a batch: points (n, 3), and faces (m, 3) whose numbers are those of its own points.

        All points are float32 or all float64. Raises TypeError and ValueError, naming the argument,
        and winnow.Error.
        """
        first = self._count
        batch = points_of(points)
        faces = faces_of(faces)
        self.add_points(batch)
        self._add_faces(faces, first, len(batch))

    def add_points(self, points):
        """Adds points (n, 3). They are numbered from 0 over all that were added."""
        points = points_of(points)
        self._open().add_points(np.ascontiguousarray(points))
        self._count += len(points)

    def add_faces(self, faces):
        """Adds faces (m, 3) by the numbers that points have over all batches, also later ones."""
        self._add_faces(faces_of(faces), 0, 2**32)

    def _add_faces(self, faces, first, count):
        self._open().add_faces(np.ascontiguousarray(faces, dtype=np.int64), first, count)

    def _open(self):
        if self._stream is None:
            raise ValueError("the stream is closed")
        return self._stream

    def finish(self):
        """Simplifies and writes what was added. Returns the Report, which is also `report`.

        Raises winnow.Error; what `progress` raises ends the call, and so does Ctrl-C.
        """
        stream = self._open()
        try:
            self.report = Report(stream.finish(self._progress))
        finally:
            self.close()
        return self.report

    def close(self):
        """Gives up: nothing is written."""
        if self._stream is not None:
            self._stream.close()
        self._stream = None


Stream.__doc__ = Stream.__init__.__doc__
