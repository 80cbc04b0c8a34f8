from dataclasses import replace
from functools import cache

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.frame import block_box, border
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle
from gaussiancad_core.model.axes import Projection, Role
from sample_parts import sample
from sample_parts.random_parts import random_part

STYLE = PRESETS["dimensioned"]
Kind = AnnotationKind

ARRANGEMENTS = [
    ((Role.FRONT, Role.TOP, Role.RIGHT), Projection.THIRD),
    ((Role.FRONT, Role.TOP, Role.LEFT), Projection.FIRST),
    ((Role.FRONT, Role.BOTTOM, Role.RIGHT), Projection.THIRD),
    (tuple(Role), Projection.THIRD),
]


@cache
def _lines(part: str | int) -> PartLines:
    shape = sample(part).build() if isinstance(part, str) else random_part(part)
    return part_lines(shape, tuple(Role))


def _sheet(part: str | int, arrangement: int, style: SheetStyle = STYLE) -> Sheet:
    roles, projection = ARRANGEMENTS[arrangement]
    lines = _lines(part)
    chosen = PartLines(lines.size, {role: lines.views[role] for role in roles})
    return compose_sheet(chosen, projection, style)


@pytest.mark.parametrize("part", ["boss-plate", "wedge-block", 3, 8])
@pytest.mark.parametrize("arrangement", range(len(ARRANGEMENTS)))
def test_only_some_kinds_enter_the_views(part: str | int, arrangement: int) -> None:
    sheet = _sheet(part, arrangement)
    outside = (Kind.FRAME, Kind.TITLE_BLOCK, Kind.TEXT, Kind.DIMENSION, Kind.SYMBOL)
    frame = border(STYLE)
    for mark in sheet.annotations:
        if mark.kind in outside:
            pieces = [mark.box]
            if mark.kind is Kind.FRAME:
                # The border goes around everything: its lines one by one.
                pieces = [replace(mark, strokes=(stroke,)).box for stroke in mark.strokes]
            for x0, y0, x1, y1 in pieces:
                for view in sheet.views:
                    u0, v0, u1, v1 = view.box
                    assert x1 <= u0 or u1 <= x0 or y1 <= v0 or v1 <= y0, (mark.kind, view.role)
        if mark.kind in (Kind.DIMENSION, Kind.EXTENSION, Kind.LEADER, Kind.CENTRE_LINE):
            x0, y0, x1, y1 = mark.box
            assert frame[0] < x0 and frame[1] < y0 and x1 < frame[2] and y1 < frame[3]


@pytest.mark.parametrize("part", ["boss-plate", "wedge-block", 3, 8])
@pytest.mark.parametrize("arrangement", range(len(ARRANGEMENTS)))
def test_the_views_leave_the_title_block_its_corner(part: str | int, arrangement: int) -> None:
    x0, y0, _, _ = block_box(STYLE)
    for view in _sheet(part, arrangement).views:
        assert view.box[2] < x0 or view.box[3] < y0
