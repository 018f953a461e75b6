"""winnow makes huge triangle meshes small, in bounded memory.

>>> import numpy as np, winnow
>>> points = np.random.default_rng(1).random((1000, 3))
>>> faces = np.arange(999).reshape(-1, 3)
>>> points, faces = winnow.simplify(points, faces, target_reduction=0.5)
>>> faces.shape[1]
3
"""

from ._calls import compare, convert, has_part, info, simplify, simplify_file
from ._levels import Progressive, progressive
from ._mesh import Mesh
from ._progress import progress_bar
from ._report import Report
from ._sequence import simplify_sequence
from ._stream import Stream
from ._winnow import Error, MissingPart, __version__

__all__ = [
    "Error",
    "Mesh",
    "MissingPart",
    "Progressive",
    "Report",
    "Stream",
    "__version__",
    "compare",
    "convert",
    "has_part",
    "info",
    "progress_bar",
    "progressive",
    "simplify",
    "simplify_file",
    "simplify_sequence",
]

for _name in __all__:
    if _name != "__version__":
        globals()[_name].__module__ = __name__
