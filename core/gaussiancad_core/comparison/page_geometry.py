"""The geometry that a comparison's page carries: few triangles, in few bytes.

Coordinates are 16 bit shares of the bounding box, numbers are base64 of little-endian arrays.  The
result is drawn with at most ``MOST_TRIANGLES``; its deviations are those of the full mesh at the
nearest vertex, so that thinning moves colours by less than a triangle and invents none.
"""

import base64
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.deviation import (
    COLOUR_STOPS,
    LONGEST_EDGE_SHARE,
    Deviation,
    split_long_edges,
)
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

MOST_TRIANGLES = 60_000
_REFERENCE_TRIANGLES = 30_000
"""More of the reference are never carried: it is only laid over the result."""

_CLUSTERED = 8
_CELL_SHARE = 1.0 / 150.0


@dataclass(frozen=True, eq=False)
class PageGeometry:
    """What the page draws.

    Attributes:
        result: its triangles.
        values: (n,) mm, at the result's vertices.
        reference: its triangles, in the same coordinates.
    """

    result: TriangleMesh
    values: npt.NDArray[np.float64]
    reference: TriangleMesh

    def as_json(self, deviation: Deviation) -> dict[str, Any]:
        """The object that ``assets/viewer.js`` reads."""
        both = np.concatenate([self.result.bounds, self.reference.bounds])
        return {
            "result": _packed(self.result, self.values),
            "reference": _packed(self.reference, None),
            "low": both.min(axis=0).tolist(),
            "high": both.max(axis=0).tolist(),
            "range": deviation.limit,
            "signed": deviation.signed,
            "stops": COLOUR_STOPS.tolist(),
        }


def page_geometry(deviation: Deviation, reference: TriangleMesh) -> PageGeometry:
    """Thin out what is too large to be carried."""
    full = deviation.mesh
    background = _thinned(reference, _REFERENCE_TRIANGLES)
    if len(full.triangles) <= MOST_TRIANGLES:
        return PageGeometry(full, deviation.distances, background)
    from scipy.spatial import cKDTree

    longest = float(np.ptp(full.bounds, axis=0).max())
    # Thinning leaves few triangles on planes, where colours may change all the same.  One round of
    # splitting makes at most four of each.
    thin = _thinned(full, MOST_TRIANGLES // 2)
    thin = split_long_edges(thin, longest * LONGEST_EDGE_SHARE, MOST_TRIANGLES // 4)

    _, nearest = cKDTree(full.vertices).query(thin.vertices)
    values = deviation.distances[nearest]
    return PageGeometry(thin, values, background)


def _thinned(mesh: TriangleMesh, most: int) -> TriangleMesh:
    """The mesh itself, or one with fewer triangles that looks the same."""
    if len(mesh.triangles) <= most:
        return mesh
    from gaussiancad_core.kernel.bare_open3d import open3d

    source = open3d.geometry.TriangleMesh(
        open3d.utility.Vector3dVector(mesh.vertices),
        open3d.utility.Vector3iVector(mesh.triangles.astype(np.int32)),
    )
    if len(mesh.triangles) > _CLUSTERED * most:
        # Collapsing edges one by one takes long; cells first, which are a pixel or two.
        cell = float(np.ptp(mesh.bounds, axis=0).max()) * _CELL_SHARE
        contraction = open3d.geometry.SimplificationContraction.Quadric
        source = source.simplify_vertex_clustering(cell, contraction)
    fewer = source.simplify_quadric_decimation(most)
    return make_mesh(np.asarray(fewer.vertices), np.asarray(fewer.triangles))


def _packed(mesh: TriangleMesh, values: npt.NDArray[np.float64] | None) -> dict[str, Any]:
    low, high = mesh.bounds
    extent = high - low
    shares = (mesh.vertices - low) / np.where(extent > 0.0, extent, 1.0)
    packed: dict[str, Any] = {
        "places": _base64(np.rint(shares * 65535.0).astype("<u2")),
        "triangles": _base64(mesh.triangles.astype("<u4")),
        "low": low.tolist(),
        "extent": extent.tolist(),
    }
    if values is not None:
        packed["values"] = _base64(values.astype("<f4"))
    return packed


def _base64(values: npt.NDArray[np.generic]) -> str:
    return base64.b64encode(np.ascontiguousarray(values).tobytes()).decode("ascii")
