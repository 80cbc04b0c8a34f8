"""Ruled tables among the views: neighbouring rectangular cells, most of which hold text."""

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import Polygon

from gaussiancad_core.geometry.near_points import connected_groups
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.structure.drawing_area import is_ruled

_SHORTEST = 2.0
"""mm of a ruled line at least."""

_FEWEST_LINES, _FEWEST_CELLS = 5, 3
"""Lines of a table, and cells with text, at least."""

_HELD = 0.5
"""Share of the cells that hold text at least."""

_LEAST_CELL, _LARGEST_CELL = 1.0, 0.3
"""mm^2 of a cell at least, and share of the drawing area at most."""

_SQUARE = 0.97
"""Share of its box that a rectangular cell fills at least."""

_BESIDE, _SHARED = 0.15, 2.0
"""mm between the sides of neighbouring cells at most, and that such sides are long at least."""

_AROUND = 0.3
"""mm around a table that belong to it."""


def tables_apart(
    labelled: LabelledStrokes, area: Polygon, words: Sequence[Box]
) -> tuple[LabelledStrokes, list[Polygon]]:
    """The strokes, those of tables told, and the boxes of these.

    Args:
        labelled: the strokes; a part within its dimensions is no table, so these come first.
        area: in which the views lie, mm.
        words: boxes of what is written, mm.
    """
    open_numbers = labelled.numbers(Label.OPEN)
    ruled = [
        labelled.strokes[number].line
        for number in open_numbers
        if labelled.strokes[number].length > _SHORTEST and is_ruled(labelled.strokes[number])
    ]
    if len(ruled) < _FEWEST_LINES:
        return labelled, []
    faces = shapely.polygonize([shapely.union_all(ruled)]).geoms
    around = area.buffer(2.0 * _BESIDE)
    cells = [
        face
        for face in faces
        if _LEAST_CELL < face.area < _LARGEST_CELL * area.area and _is_box(face)
        if around.contains(face)
    ]
    found = _tables(cells, words)
    if not found:
        return labelled, []
    shut = shapely.union_all(found).buffer(_AROUND)
    inside = [number for number in open_numbers if shut.contains(labelled.strokes[number].line)]
    return labelled.with_label(inside, Label.TABLE, "within a ruled table"), found


def _is_box(face: Polygon) -> bool:
    return not face.interiors and bool(face.area > _SQUARE * face.envelope.area)


def _tables(cells: Sequence[Polygon], words: Sequence[Box]) -> list[Polygon]:
    """Boxes around neighbouring cells that hold text."""
    if len(cells) < _FEWEST_CELLS:
        return []
    corners = np.array(words).reshape(-1, 4)
    middles = (corners[:, :2] + corners[:, 2:]) / 2.0
    bounds = shapely.bounds(cells)
    held = [bool(((middles > box[:2]) & (middles < box[2:])).all(axis=1).any()) for box in bounds]
    grown = [cell.buffer(_BESIDE) for cell in cells]
    pairs = shapely.STRtree(cells).query(grown, "intersects").T
    sides = [grown[one].intersection(cells[other]).length > _SHARED for one, other in pairs]
    groups = connected_groups(pairs[np.array(sides, dtype=bool)], len(cells))
    found = []
    for group in np.unique(groups).tolist():
        members = np.flatnonzero(groups == group).tolist()
        with_text = sum(held[index] for index in members)
        if with_text >= max(_FEWEST_CELLS, _HELD * len(members)):
            found.append(shapely.union_all([cells[index] for index in members]).envelope)
    return found
