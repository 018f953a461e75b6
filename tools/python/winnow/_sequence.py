"""Meshes that move: one connectivity for all frames."""

import numpy as np

from . import _winnow
from ._calls import OF_FILES, RENAMED, add_targets, beside, check_progress, in_array_words, renamed
from ._mesh import faces_of, points_of
from ._options import with_options


def frames_of(frames):
    """Arrays (n, 3) of one shape and type; not copied where the library reads them as they are."""
    if isinstance(frames, np.ndarray) and (frames.ndim != 3 or frames.shape[2] != 3):
        raise ValueError(f"frames must have the shape (t, n, 3), not {frames.shape}")
    if not hasattr(frames, "__iter__"):
        raise TypeError(f"frames must be an array (t, n, 3), not a {type(frames).__name__}")
    arrays = []
    for i, frame in enumerate(frames):
        try:
            array = points_of(frame)
        except (TypeError, ValueError) as error:
            raise type(error)(f"frames[{i}]: {error}") from None
        if arrays and array.shape != arrays[0].shape:
            raise ValueError(
                f"frames[{i}] must have the shape {arrays[0].shape} of the first, not {array.shape}"
            )
        if arrays and array.dtype != arrays[0].dtype:
            raise TypeError(
                f"frames[{i}] must be {arrays[0].dtype} as the first is, not {array.dtype}"
            )
        arrays.append(array)
    if len(arrays) < 2:
        raise ValueError(f"frames must be two or more, not {len(arrays)}; for one use simplify()")
    return arrays


@with_options("sequence", leave_out=(*OF_FILES, *RENAMED, "normals"))
def simplify_sequence(
    frames,
    faces,
    *,
    target_count=None,
    target_reduction=None,
    progress=None,
    options,
    surroundings,
):
    """Makes a mesh that moves small: all frames get the same faces.

    frames: array (t, n, 3), float32 or float64, in any unit, also mapped from a file; or t arrays
        (n, 3). Frame after frame it has the positions of the same n points.
    faces: array (m, 3) of a whole-number type, numbers of points from 0; of all frames.
    target_count: so many faces in each frame; 4 or more.
    target_reduction: this part of the faces goes; from 0 to below 1.
    progress: called with a stage, how much is done, of how much (0: not known), and the unit.

    Returns (frames, faces): an array (t, k, 3) of the type of the input's, and an array (l, 3).
    With `per_frame` above 0 frames may differ in faces, and these are two lists, of t arrays (k, 3)
    and of t arrays (l, 3). The arrays own their memory.

    Raises TypeError and ValueError for arrays of other types and shapes, naming them, and
    winnow.Error. What `progress` raises ends the call, and so does Ctrl-C.

    >>> import numpy as np, winnow
    >>> x, y = np.meshgrid(np.arange(30.0), np.arange(30.0))
    >>> waves = [np.stack([x, y, np.sin(x / 5 + t)], axis=-1).reshape(-1, 3) for t in range(4)]
    >>> corner = (np.arange(29)[:, None] * 30 + np.arange(29)).ravel()
    >>> faces = np.concatenate([corner + [[0], [1], [31]], corner + [[0], [31], [30]]], axis=1).T
    >>> frames, faces = winnow.simplify_sequence(waves, faces, target_count=300)
    >>> frames.shape[0], frames.shape[2], len(faces) <= 300
    (4, 3, True)
    """
    check_progress(progress)
    points = frames_of(frames)
    given = faces_of(faces)
    add_targets(options, target_count, target_reduction)
    with renamed():
        result, per_frame = _winnow.simplify_frames(
            points, given, options, beside("", surroundings), progress
        )
    new_points, new_faces = [], []
    for i, (own_points, own_faces) in enumerate(result):
        result[i] = None
        new_points.append(own_points)
        shared = new_faces[-1] if own_faces is None else own_faces.astype(given.dtype, copy=False)
        new_faces.append(shared)
    if per_frame:
        return new_points, [own.copy() if i else own for i, own in enumerate(new_faces)]
    return stacked(new_points), new_faces[0]


def stacked(frames):
    """As one array; each of `frames` is let go when it is in."""
    whole = np.empty((len(frames), *frames[0].shape), frames[0].dtype)
    for i in range(len(frames)):
        whole[i] = frames[i]
        frames[i] = None
    return whole


simplify_sequence.__doc__ = in_array_words(simplify_sequence.__doc__)
