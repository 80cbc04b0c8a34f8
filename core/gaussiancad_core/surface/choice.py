"""Which surface a run delivers: that of the trained Gaussians, or the hull on which they started.

Splatting may mend what masks that contradict each other took away from the hull; where they do not,
it only rounds the hull's edges.  Truth is not known, but the masks are: the surface whose shadows
are nearer to them is taken, the hull where they are alike.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

import numpy as np

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.meshes import TriangleMesh
from gaussiancad_core.splatting.gaussians import Gaussians
from gaussiancad_core.surface.poisson import PoissonSettings, gaussian_surface
from gaussiancad_core.surface.repair import simplified
from gaussiancad_core.surface.silhouettes import silhouette_difference
from gaussiancad_core.views import ViewSet

_HULL_TOLERANCE = 1e-4
"""By how much the hull may be simplified, as a share of the longest edge: what the eye and the
masks do not see, and a fiftieth of the triangles."""


class SurfaceSource(Enum):
    """What a surface was made from."""

    GAUSSIANS = "gaussians"
    HULL = "hull"


@dataclass(frozen=True, eq=False)
class ChosenSurface:
    """A surface and what it was preferred to.

    Attributes:
        mesh: watertight, mm.
        source: what it was made from.
        differences: of the shadows from the masks, for all that were compared, see
            :func:`.silhouettes.silhouette_difference`.
    """

    mesh: TriangleMesh
    source: SurfaceSource = SurfaceSource.GAUSSIANS
    differences: Mapping[SurfaceSource, float] = field(default_factory=dict)


def better_surface(
    hull: TriangleMesh,
    gaussians: Gaussians,
    views: ViewSet,
    settings: PoissonSettings | None = None,
) -> ChosenSurface:
    """The Poisson surface of trained Gaussians or the hull.

    Args:
        hull: on which they started; watertight, mm.
        gaussians: mm.
        views: in parallel projection.
        settings: of the Poisson surface.

    Raises:
        NoModelError: ``no-surface``, the Gaussians bound no body and the hull is not closed.
    """
    settings = settings or PoissonSettings()
    longest = float(np.ptp(hull.bounds, axis=0).max())
    start = simplified(hull, _HULL_TOLERANCE * longest)
    if start is None:
        return ChosenSurface(gaussian_surface(gaussians, settings, hull))
    differences = {SurfaceSource.HULL: silhouette_difference(start, views)}
    try:
        trained = gaussian_surface(gaussians, settings)
    except NoModelError:
        return ChosenSurface(start, SurfaceSource.HULL, differences)
    differences[SurfaceSource.GAUSSIANS] = silhouette_difference(trained, views)
    if differences[SurfaceSource.GAUSSIANS] < differences[SurfaceSource.HULL]:
        return ChosenSurface(trained, SurfaceSource.GAUSSIANS, differences)
    return ChosenSurface(start, SurfaceSource.HULL, differences)
