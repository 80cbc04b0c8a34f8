"""Edges gathered to drawings: what touches, and what lies within."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np
import shapely

from gaussiancad_core.geometry.near_points import connected_groups
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke, lines_of
from gaussiancad_core.structure.closed_outlines import faces_of

_NEAR = 0.3
"""mm within which edges are of one drawing."""

_WITHIN, _LEAST_SIDE = 0.6, 0.05
"""Share of a group's box that lies within another one's, for both to be one drawing; mm that a box
is wide at least."""

_SMALLEST, _THINNEST = 3.0, 0.3
"""mm of a drawing's longer and shorter side at least."""

_LEAST_AREA = 4.0
"""mm^2 that the outline of a view encloses at least."""


class DrawingKind(Enum):
    """What a drawing is."""

    PLAIN = "plain"
    SECTION = "section"
    PICTORIAL = "pictorial"
    DETAIL = "detail"
    FLAT_PATTERN = "flat-pattern"
    SCRAP = "scrap"
    """Lines that enclose nothing, or next to nothing."""


@dataclass(frozen=True, eq=False)
class DrawnView:
    """A drawing on a sheet.

    Attributes:
        box: around its edges, mm.
        edges: visible ones.
        outline: what they enclose; empty where they do not close.
        hidden: hidden ones within its box.
        hatching: families of hatching within its box.
        narrow: other solid strokes within its box that may show the part: threads, smooth edges.
        kind: what it is.
        name: what its title calls it, in small letters: a role's name, or ``pictorial``; empty
            where it has none.
        title: its title as written.
        rough: mm by which places of it may be off, as it was painted or traced; 0 of what a file
            tells.
    """

    box: Box
    edges: tuple[PaperStroke, ...]
    outline: shapely.Geometry
    hidden: tuple[PaperStroke, ...] = ()
    hatching: tuple[tuple[PaperStroke, ...], ...] = ()
    narrow: tuple[PaperStroke, ...] = ()
    kind: DrawingKind = DrawingKind.PLAIN
    name: str = ""
    title: str = ""
    rough: float = 0.0

    @property
    def size(self) -> tuple[float, float]:
        """mm that it is wide and high."""
        return self.box[2] - self.box[0], self.box[3] - self.box[1]

    @property
    def area(self) -> float:
        """mm^2 of its box."""
        return self.size[0] * self.size[1]


def drawn_views(
    edges: Sequence[PaperStroke],
    hidden: Sequence[PaperStroke],
    families: Sequence[Sequence[PaperStroke]],
    others: Sequence[PaperStroke] = (),
) -> list[DrawnView]:
    """The drawings of a sheet.

    Args:
        edges: visible ones.
        hidden: hidden ones.
        families: of hatching.
        others: solid strokes that are no edges and of which nobody knows what they are.
    """
    found = []
    for group in _gathered(edges):
        box = _box(group)
        width, height = box[2] - box[0], box[3] - box[1]
        if max(width, height) < _SMALLEST or min(width, height) < _THINNEST:
            continue
        outline = faces_of(group).outline
        kind = DrawingKind.PLAIN if outline.area >= _LEAST_AREA else DrawingKind.SCRAP
        found.append(DrawnView(box, tuple(group), outline, kind=kind))
    return [_filled(view, hidden, families, others) for view in found]


def _filled(
    view: DrawnView,
    hidden: Sequence[PaperStroke],
    families: Sequence[Sequence[PaperStroke]],
    others: Sequence[PaperStroke],
) -> DrawnView:
    """A drawing with what lies in its box besides edges."""
    frame = shapely.box(*view.box).buffer(_NEAR)
    inside = tuple(stroke for stroke in hidden if frame.contains(stroke.line))
    hatching = tuple(
        tuple(family)
        for family in families
        if all(frame.contains(stroke.line) for stroke in family)
    )
    narrow = tuple(stroke for stroke in others if frame.contains(stroke.line))
    return replace(view, hidden=inside, hatching=hatching, narrow=narrow)


def _gathered(edges: Sequence[PaperStroke]) -> list[list[PaperStroke]]:
    """Groups of edges that touch, with those that lie in their boxes; the largest first."""
    if not edges:
        return []
    lines = lines_of(edges)
    pairs = shapely.STRtree(lines).query(lines, "dwithin", _NEAR)
    numbers = connected_groups(pairs.T, len(edges))
    groups: list[list[PaperStroke]] = [[] for _ in range(int(numbers.max()) + 1)]
    for edge, number in zip(edges, numbers.tolist(), strict=True):
        groups[number].append(edge)
    boxes = np.array([_box(group) for group in groups])
    sizes = np.maximum(boxes[:, 2:] - boxes[:, :2], _LEAST_SIDE)
    merged: list[list[PaperStroke]] = []
    around = np.empty((0, 4))
    for index in np.argsort(-sizes.prod(axis=1), kind="stable").tolist():
        box, area = boxes[index], sizes[index].prod()
        shared = np.minimum(around[:, 2:], box[2:]) - np.maximum(around[:, :2], box[:2])
        common = np.maximum(shared, _LEAST_SIDE).prod(axis=1)
        holding = np.flatnonzero((shared > -_LEAST_SIDE).all(axis=1) & (common > _WITHIN * area))
        if len(holding):
            first = int(holding[0])
            merged[first] += groups[index]
            around[first, :2] = np.minimum(around[first, :2], box[:2])
            around[first, 2:] = np.maximum(around[first, 2:], box[2:])
        else:
            merged.append(list(groups[index]))
            around = np.vstack([around, box])
    return merged


def _box(strokes: Sequence[PaperStroke]) -> Box:
    boxes = np.array([stroke.box for stroke in strokes])
    x0, y0 = boxes[:, :2].min(axis=0).tolist()
    x1, y1 = boxes[:, 2:].max(axis=0).tolist()
    return x0, y0, x1, y1
