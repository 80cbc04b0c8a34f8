"""A part's exact lines in three views, and the same with what sheets of practice lack."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import Enum
from random import Random

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.drawing.drawn_sheet import PartLines, part_lines
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.model.views import Arc, Linetype, Segment

_CUT = Role.RIGHT

_PITCH = 0.02
"""From line to line of the hatching, as a share of the longest extent."""

_GRID = 1e-4
"""Share of the longest extent to which coordinates are rounded: of a PDF with 0.05 pt on A4."""

_LOST = 3

_LONG = 0.02
"""Share of the longest extent from which a line can be lost: specks lack nobody."""


class Lack(Enum):
    """What a drawing lacks."""

    NOTHING = "three-views"
    HIDDEN_BUT_SECTION = "two-and-section"
    DIGITS = "rounded"
    STROKES = "strokes-lost"
    HIDDEN = "no-hidden-lines"


@dataclass(frozen=True)
class Drawing:
    """What is drawn of a part.

    Attributes:
        lines: of its views.
        hatching: of a view that is cut open.
    """

    lines: PartLines
    hatching: dict[Role, tuple[Segment, ...]]


def drawn_lacking(shape: TopoDS_Shape, lack: Lack, lot: Random) -> Drawing:
    """Three views of a part in third angle.

    Args:
        shape: mm.
        lack: what they lack.
        lot: which strokes are lost.
    """
    if lack is Lack.HIDDEN_BUT_SECTION:
        return _with_section(shape)
    lines = part_lines(shape, ROLES)
    longest = float(lines.size.max())
    if lack is Lack.DIGITS:
        return _of(lines, {role: _rounded(row, longest) for role, row in lines.views.items()})
    if lack is Lack.HIDDEN:
        return _of(lines, {role: tuple(_visible(row)) for role, row in lines.views.items()})
    return _of(lines, _some_lost(lines, longest, lot) if lack is Lack.STROKES else lines.views)


def _of(lines: PartLines, views: dict[Role, tuple[DrawnStroke, ...]]) -> Drawing:
    return Drawing(replace(lines, views=views), {})


def _visible(strokes: tuple[DrawnStroke, ...]) -> Iterator[DrawnStroke]:
    return (stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE)


def _with_section(shape: TopoDS_Shape) -> Drawing:
    """A view that is cut open in the middle beside two without hidden lines."""
    lines = part_lines(shape, ROLES, sections=((_CUT, SectionKind.FULL),))
    cut = lines.sections[_CUT, SectionKind.FULL]
    views = {role: tuple(_visible(row)) for role, row in lines.views.items()}
    hatching = cut.hatching(_PITCH * float(lines.size.max()))
    return Drawing(replace(lines, views={**views, _CUT: cut.strokes}), {_CUT: hatching})


def _rounded(strokes: tuple[DrawnStroke, ...], longest: float) -> tuple[DrawnStroke, ...]:
    grid = _GRID * longest

    def near(values: object) -> tuple[float, ...]:
        return tuple((np.round(np.asarray(values) / grid) * grid).tolist())

    made: list[DrawnStroke] = []
    for stroke in strokes:
        if isinstance(stroke, Segment):
            ends = near(stroke.start), near(stroke.end)
            if ends[0] != ends[1]:
                made.append(replace(stroke, start=ends[0], end=ends[1]))
        elif isinstance(stroke, Arc):
            radius = max(grid, near([stroke.radius])[0])
            made.append(replace(stroke, centre=near(stroke.centre), radius=radius))
        elif isinstance(stroke, Polyline):
            made.append(replace(stroke, points=tuple(near(point) for point in stroke.points)))
        else:
            made.append(stroke)
    return tuple(made)


def _some_lost(
    lines: PartLines, longest: float, lot: Random
) -> dict[Role, tuple[DrawnStroke, ...]]:
    """Without some strokes, and one of the others in the other linetype."""
    long = [
        (role, number)
        for role, row in lines.views.items()
        for number, stroke in enumerate(row)
        if _length(stroke) > _LONG * longest
    ]
    *lost, mistaken = lot.sample(long, min(len(long), _LOST + 1))
    views = {}
    for role, row in lines.views.items():
        kept = [
            _other_linetype(stroke) if (role, number) == mistaken else stroke
            for number, stroke in enumerate(row)
            if (role, number) not in lost
        ]
        views[role] = tuple(kept)
    return views


def _length(stroke: DrawnStroke) -> float:
    points = stroke.sample(1.0)
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


def _other_linetype(stroke: DrawnStroke) -> DrawnStroke:
    is_visible = stroke.linetype is Linetype.VISIBLE
    return replace(stroke, linetype=Linetype.HIDDEN if is_visible else Linetype.VISIBLE)
