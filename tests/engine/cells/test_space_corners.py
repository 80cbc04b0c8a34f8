"""Points and edges in space that three views show."""

import numpy as np
import pytest

from gaussiancad_core.cells.space_corners import SpatialEdges, spatial_edges
from gaussiancad_core.coordinates.carriers import find_carriers
from gaussiancad_core.evidence.drawn_views import exact_views
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment

_NEAR = 0.005
_ENDS = ((70.0, 0.0, 60.0), (100.0, 36.0, 60.0), (100.0, 0.0, 42.0))
"""Corners of the cut of a block of 100 x 80 x 60 mm, which are units as well."""

_VIEWS = {Role.FRONT: (0, 2), Role.TOP: (0, 1), Role.RIGHT: (1, 2)}


def _shown(shortened: float, short: float = 0.0) -> SpatialEdges:
    """The edges of the block; the cut's line in the front view ends early by a share."""
    size = (100.0, 80.0, 60.0)
    strokes = {}
    for role, (first, second) in _VIEWS.items():
        a, b = size[first], size[second]
        outline = [(0.0, 0.0), (a, 0.0), (a, b), (0.0, b)]
        lines = list(zip(outline, [*outline[1:], outline[0]], strict=True))
        # The edge that this view does not see as a part of its outline.
        ends = [(end[first], end[second]) for end in _ENDS]
        inner = next(
            (p, q)
            for p, q in ((ends[0], ends[1]), (ends[1], ends[2]), (ends[0], ends[2]))
            if p[0] != q[0] and p[1] != q[1]
        )
        if role is Role.FRONT:
            (x0, y0), (x1, y1) = inner
            inner = ((x0, y0), (x1 - shortened * (x1 - x0), y1 - shortened * (y1 - y0)))
        strokes[role] = tuple(Segment(p, q, Linetype.VISIBLE) for p, q in [*lines, inner])
    return spatial_edges(find_carriers(exact_views(strokes, size)), _NEAR, short)


def _as_points(shown: SpatialEdges) -> set[frozenset[tuple[float, ...]]]:
    return {
        frozenset(tuple(np.round(shown.points[end], 6).tolist()) for end in edge)
        for edge in shown.edges
    }


def test_edges_are_drawn_in_all_views() -> None:
    pairs = {frozenset((p, q)) for p in _ENDS for q in _ENDS if p < q}
    assert _as_points(_shown(0.0)) == pairs


def test_corners_are_places_of_all_views() -> None:
    shown = _shown(0.0)
    points = {tuple(np.round(point, 6).tolist()) for point in shown.points}
    assert set(_ENDS) <= points
    block = {(x, y, z) for x in (0.0, 100.0) for y in (0.0, 80.0) for z in (0.0, 60.0)}
    # The views alone do not tell that the corner is gone.
    assert points == block | set(_ENDS)


@pytest.mark.parametrize(("short", "edges"), [(0.0, 1), (1.0, 1), (3.0, 3)])
def test_a_line_that_ends_early_reaches_a_corner_within_its_tolerance(
    short: float, edges: int
) -> None:
    # A twentieth of the line is 1.75 units; without its end there is no third corner.
    shown = _shown(0.05, short)
    assert len(shown.edges) == edges
