"""The edges of a triangle mesh, each counted once."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt


@dataclass(frozen=True, eq=False)
class MeshEdges:
    """Distinct edges.

    Attributes:
        ends: (e, 2) vertices, the lower one first.
        of_triangle: (m, 3) which of them run 0-1, 1-2, 2-0 in each triangle.
        uses: (e,) how many triangles have each.
    """

    ends: npt.NDArray[np.int64]
    of_triangle: npt.NDArray[np.int64]
    uses: npt.NDArray[np.int64]


def mesh_edges(triangles: npt.NDArray[np.int64]) -> MeshEdges:
    """The edges of (m, 3) triangles."""
    count = int(triangles.max()) + 1 if len(triangles) else 1
    following = np.roll(triangles, -1, axis=1)
    # One number an edge sorts ten times as fast as a row of two.
    keys = np.minimum(triangles, following) * count + np.maximum(triangles, following)
    found, number, uses = np.unique(keys.ravel(), return_inverse=True, return_counts=True)
    ends = np.stack(np.divmod(found, count), axis=1)
    return MeshEdges(ends, number.reshape(-1, 3), uses)
