"""Edges of a solid that a view shows and the sheet does not draw."""

import numpy as np
import numpy.typing as npt
import shapely

from gaussiancad_core.judging.difference_kinds import NO_KIND, kinds_between
from gaussiancad_core.judging.drawn_lines import DrawnSheet, DrawnView
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats, Numbers
from gaussiancad_core.judging.lines_of_sight import seen
from gaussiancad_core.judging.opened_views import met_in, with_cut
from gaussiancad_core.judging.sight_pairs import NO_LINE, Drawn

_FAR, _FAR_SHARE = 2.0, 0.006
"""How far from all strokes an edge of the solid is undrawn: lengths from a stroke to the lines of
sight beside it, and share of the longest extent, at least."""

_FLAT = 0.2
"""Share of an edge's length that a view shows of it at least to look at it there."""

_EDGE_STEP = 1.0 / 60.0
"""Share of the longest extent between places on an edge."""

_ONCE = 1.0 / 120.0
"""Share of the longest extent within which what two edges draw counts once."""

Rows = tuple[Numbers, Floats, Floats, Floats, Numbers, Numbers]
"""Kinds, places (n, 2) and halves of their pieces (n, 2) in mm, mm of line, lines, edges."""


def undrawn_edges(
    solid: FacetedSolid, sheet: DrawnSheet, view: DrawnView, chords: shapely.STRtree
) -> Rows:
    """Places on the solid's edges that it shows in a view where no stroke is near."""
    frame = view.role.frame
    axes = np.array([frame.right, frame.up], dtype=np.float64)
    at, way, mm, edge = _on_edges(solid, _EDGE_STEP * sheet.longest)
    at, way = at @ axes.T, way @ axes.T
    flat = np.hypot(*way.T)
    chosen = flat > _FLAT
    least = max(_FAR * sheet.aside, _FAR_SHARE * sheet.longest)
    chosen[chords.query(shapely.points(at), predicate="dwithin", distance=least)[0]] = False
    at, way, mm, edge = (
        at[chosen],
        way[chosen] / flat[chosen, None],
        (mm * flat)[chosen],
        edge[chosen],
    )
    if not len(at):
        none = np.zeros(0, int)
        return none, np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0), none, none
    across = sheet.aside * np.stack([-way[:, 1], way[:, 0]], axis=1)
    signs = seen(met_in(solid, view, np.vstack([at - across, at + across])), with_cut(solid))
    numbers = np.arange(len(at))
    kind = kinds_between(
        signs,
        (numbers, numbers + len(at)),
        np.full(len(at), Drawn.NOTHING.value),
        view,
    )
    kept = (kind != NO_KIND) & _first_at(at, _ONCE * sheet.longest)
    return (
        kind[kept],
        at[kept],
        way[kept] * (mm[kept] / 2.0)[:, None],
        mm[kept],
        np.full(int(kept.sum()), NO_LINE),
        edge[kept],
    )


def _on_edges(solid: FacetedSolid, step: float) -> tuple[Floats, Floats, Floats, Numbers]:
    """(n, 3) places on the solid's edges, unit vectors along them, mm that each stands for, and
    numbers of the edges."""
    ways = solid.sharp[:, 1] - solid.sharp[:, 0]
    lengths = np.linalg.norm(ways, axis=1)
    counts = np.maximum(np.ceil(lengths / step), 1).astype(np.int64)
    chord = np.repeat(np.arange(len(counts)), counts)
    share = (np.arange(len(chord)) - np.repeat(np.cumsum(counts) - counts, counts) + 0.47) / counts[
        chord
    ]
    at = solid.sharp[chord, 0] + share[:, None] * ways[chord]
    units = ways[chord] / np.maximum(lengths, 1e-12)[chord, None]
    return at, units, (lengths / counts)[chord], solid.edges[chord]


def _first_at(at: Floats, step: float) -> npt.NDArray[np.bool_]:
    """(n,) whether no earlier place lies in the same square."""
    first = np.zeros(len(at), bool)
    first[np.unique(np.round(at / step).astype(np.int64), axis=0, return_index=True)[1]] = True
    return first
