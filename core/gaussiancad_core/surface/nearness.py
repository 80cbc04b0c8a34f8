"""The surface of the trained Gaussians, weighed against the hull on which they started.

A run delivers the former.  Splatting may mend what masks that contradict each other took away from
the hull; where they do not, it only rounds the hull's edges.  Truth is not known, but the masks
are: it is told which of the two has shadows nearer to them, the hull where they are alike.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

import numpy as np

from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.surface.mesh_shadows import silhouette_difference
from gaussiancad_core.surface.repair import UNSEEN, simplified


class Nearer(Enum):
    """What is nearer to the drawing."""

    GAUSSIANS = "gaussians"
    HULL = "hull"


@dataclass(frozen=True, eq=False)
class WeighedSurface:
    """A surface beside the hull.

    Attributes:
        mesh: of the Gaussians, watertight, mm; None where they bound no body.
        hull: with as few triangles as its form needs, mm.
        differences: of the shadows of either from the masks, see
            :func:`.mesh_shadows.silhouette_difference`.
    """

    mesh: TriangleMesh | None
    hull: TriangleMesh
    differences: Mapping[Nearer, float]

    @property
    def nearer(self) -> Nearer:
        """Which of the two is nearer to the masks."""
        shares = self.differences
        trained = shares.get(Nearer.GAUSSIANS)
        return (
            Nearer.GAUSSIANS
            if trained is not None and trained < shares[Nearer.HULL]
            else Nearer.HULL
        )


def weighed(surface: TriangleMesh | None, hull: TriangleMesh, views: ViewSet) -> WeighedSurface:
    """Compare the shadows of a surface and of a hull with the masks.

    Args:
        surface: of the Gaussians, watertight, mm; None where they bound no body.
        hull: on which they started, mm.
        views: whose masks are compared, in parallel projection.
    """
    longest = float(np.ptp(hull.bounds, axis=0).max())
    # A hull that is not closed cannot be simplified.
    few = simplified(hull, UNSEEN * longest) or hull
    differences = {Nearer.HULL: silhouette_difference(few, views)}
    if surface is not None:
        differences[Nearer.GAUSSIANS] = silhouette_difference(surface, views)
    return WeighedSurface(surface, few, differences)
