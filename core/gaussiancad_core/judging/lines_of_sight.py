"""What lines of sight at places of a view meet of a solid, one surface after another.

Between two lines of sight nothing is drawn where both meet the same surfaces in the same order.
Where the first surfaces differ, a visible line runs between them; where later ones do, a hidden
one.
"""

from dataclasses import dataclass

import numpy as np

from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers
from gaussiancad_core.judging.sight_kernels import BINS, MOST_MET, cross, cut, sign
from gaussiancad_core.model.axes import ViewFrame


@dataclass(frozen=True, eq=False)
class Met:
    """What lines of sight meet, the nearest first.

    Attributes:
        count: (n,) crossings of each line of sight.
        surface: (n, MOST_MET) numbers of surfaces.
        depth: (n, MOST_MET) mm along the view's look.
    """

    count: Numbers
    surface: Numbers
    depth: Floats


@dataclass(frozen=True, eq=False)
class Seen:
    """What two lines of sight are compared by.

    Attributes:
        every: (n,) a number for the surfaces in their order.
        sharp: (n,) the same with surfaces as one that pass smoothly into each other.
        first: (n,) the nearest of these; -1 where nothing is met.
    """

    every: Numbers
    sharp: Numbers
    first: Numbers


def crossings(solid: FacetedSolid, frame: ViewFrame, places: Floats) -> Met:
    """What lines of sight meet.

    Args:
        solid: mm.
        frame: of the view.
        places: (n, 2) mm in the view's plane (right, up).
    """
    axes = np.array([frame.right, frame.up, frame.look], dtype=np.float64)
    corners = (solid.vertices @ axes.T)[solid.triangles]
    low, high = places.min(axis=0), places.max(axis=0)
    pitch = np.maximum((high - low) / BINS, 1e-12)
    bins = np.minimum(((places - low) / pitch).astype(np.int64), BINS - 1)
    number = bins[:, 0] * BINS + bins[:, 1]
    order = np.argsort(number, kind="stable")
    starts = np.searchsorted(number[order], np.arange(BINS * BINS + 1))
    count = np.zeros(len(places), np.int64)
    surface = np.zeros((len(places), MOST_MET), np.int64)
    depth = np.zeros((len(places), MOST_MET))
    cross(
        corners,
        solid.surfaces,
        places,
        (order, starts, low, pitch),
        (count, surface, depth),
    )
    return Met(count, surface, depth)


def seen(met: Met, smooth: Numbers) -> Seen:
    """What lines of sight are compared by.

    Args:
        met: by them.
        smooth: of each surface, the first that it passes into smoothly.
    """
    count = len(met.count)
    every, sharp, first = (np.zeros(count, np.int64) for _ in range(3))
    sign(met.count, met.surface, smooth, (every, sharp, first))
    return Seen(every, sharp, first)


def cut_open(met: Met, at: Floats, number: int) -> Met:
    """The same with what lies before a plane taken away.

    Args:
        met: by lines of sight.
        at: (n,) mm along the look, where each is cut; NaN where it is not.
        number: of the surface that the plane makes where it cuts material.
    """
    count, surface, depth = met.count.copy(), met.surface.copy(), met.depth.copy()
    cut(count, surface, depth, at, number)
    return Met(count, surface, depth)
