"""Runs of edges around a planned area: chords of one surface are a circle, arcs or a line."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum
from itertools import pairwise

import numpy as np

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.proposing.edge_on_surfaces import SurfaceKind
from gaussiancad_core.proposing.lines_by_plane import Circle, Floats, PlaneSheet
from gaussiancad_core.proposing.part_features import Prism, Turned

_ON_CIRCLE = 5.0
"""Tolerances within which corners lie on the circle that their edges are chords of."""

_STRAIGHT = 1e-2
"""Tolerances within which corners lie on one line."""

_FEW = 4
"""Corners up to which a run of edges stays edges."""

_SPECK = 1e-7
"""mm: shorter edges are none."""


class RunKind(Enum):
    """What a run of edges is."""

    CIRCLE = "circle"
    """All of a circle."""

    ARC = "arc"
    """A piece of one, a half at most."""

    LINE = "line"
    """Straight."""

    CURVE = "curve"
    """Free, through its corners."""


@dataclass(frozen=True, eq=False)
class EdgeRun:
    """Edges that are one.

    Attributes:
        kind: what they are.
        corners: (n, 2) mm, the ends first and last.
        circle: of an arc, or a circle.
    """

    kind: RunKind
    corners: Floats
    circle: Circle | None = None

    @property
    def middle(self) -> Floats:
        """(2,) mm, the corner that is farthest from the chord: of an arc, on its circle."""
        way = self.corners[-1] - self.corners[0]
        across = np.abs((self.corners - self.corners[0]) @ np.array([-way[1], way[0]]))
        corner = self.corners[int(across.argmax())]
        return corner if self.circle is None else _on(corner, self.circle)


def prism_rings(prism: Prism, sheet: PlaneSheet, *, with_arcs: bool = True) -> list[list[EdgeRun]]:
    """The rings of a prism's area as runs, the outer one first.

    Args:
        prism: of the sheet.
        sheet: whose surfaces its edges have.
        with_arcs: whether chords of circles are arcs; else each stays an edge.
    """
    loop, rings = prism.loop, []
    for ring in loop.rings:
        surfaces = loop.surfaces[ring]
        circles = [
            _circle_of(sheet, int(surface), prism.axis) if with_arcs else None
            for surface in surfaces
        ]
        names = surfaces.tolist() if with_arcs else list(range(len(surfaces)))
        rings.append(list(edge_runs(loop.edges[ring], names, circles, sheet.tolerance)))
    return rings


def profile_runs(turned: Turned, tolerance: float) -> list[EdgeRun]:
    """The profile of what is turned as runs, in radius and height."""
    names: dict[object, int] = {}
    runs = [
        names.setdefault(circle or ("edge", number), len(names))
        for number, circle in enumerate(turned.circles)
    ]
    return list(edge_runs(turned.edges, runs, turned.circles, tolerance))


def edge_runs(
    edges: Floats, names: Sequence[int], circles: Sequence[Circle | None], tolerance: float
) -> Iterator[EdgeRun]:
    """Edges around an area as runs.

    Args:
        edges: (m, 4) mm, from and to, around.
        names: of the surfaces behind them.
        circles: that edges are chords of.
        tolerance: mm.
    """
    for run in _same(names):
        corners = np.vstack([edges[run, :2], edges[run[-1], 2:]])
        circle = circles[run[0]]
        if circle is not None and _is_on(corners, circle, tolerance):
            if len(run) == len(names):
                yield EdgeRun(RunKind.CIRCLE, corners, circle)
                return
            if len(run) > 1:
                for piece in _halves(corners, circle):
                    yield EdgeRun(RunKind.ARC, piece, circle)
                continue
        if _is_straight(corners, tolerance):
            yield EdgeRun(RunKind.LINE, corners[[0, -1]])
        elif len(corners) > _FEW:
            yield EdgeRun(RunKind.CURVE, corners)
        else:
            for ends in pairwise(corners):
                yield EdgeRun(RunKind.LINE, np.array(ends))


def _circle_of(sheet: PlaneSheet, surface: int, axis: Axis) -> Circle | None:
    behind = sheet.surfaces[surface]
    if behind.kind is not SurfaceKind.CYLINDER or behind.axis is not axis:
        return None
    x, y, radius = behind.values
    return x, y, radius


def _same(names: Sequence[int]) -> list[list[int]]:
    """Runs of edges around that have one name."""
    count = len(names)
    starts = [k for k in range(count) if names[k] != names[k - 1]]
    if not starts:
        return [list(range(count))]
    ends = [*starts[1:], starts[0] + count]
    return [[k % count for k in range(start, end)] for start, end in zip(starts, ends, strict=True)]


def _is_on(corners: Floats, circle: Circle, tolerance: float) -> bool:
    away = np.hypot(*(corners - np.array(circle[:2])).T) - circle[2]
    return bool(np.abs(away).max() < _ON_CIRCLE * tolerance)


def _is_straight(corners: Floats, tolerance: float) -> bool:
    way = corners[-1] - corners[0]
    length = float(np.hypot(*way))
    if length <= _SPECK:
        return False
    across = (corners - corners[0]) @ np.array([-way[1], way[0]]) / length
    return bool(np.abs(across).max() < _STRAIGHT * tolerance + _SPECK)


def _halves(corners: Floats, circle: Circle) -> list[Floats]:
    """An arc, or two of what is more than a half circle: of a whole one, all but, the ends would
    hardly tell where it is."""
    way = corners[-1] - corners[0]
    sides = np.abs((corners - corners[0]) @ np.array([-way[1], way[0]]))
    top = int(sides.argmax())
    if not 0 < top < len(corners) - 1 or sides[top] <= circle[2] * np.hypot(*way):
        return [corners]
    middle = _on(corners[top], circle)
    return [np.vstack([corners[:top], middle]), np.vstack([middle, corners[top + 1 :]])]


def _on(corner: Floats, circle: Circle) -> Floats:
    """The place on a circle beside a corner."""
    centre = np.array(circle[:2])
    away = corner - centre
    return np.asarray(centre + away / np.hypot(*away) * circle[2])
