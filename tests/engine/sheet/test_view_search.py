"""Views are found by whichever way tells annotations from the part."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet import view_search
from gaussiancad_core.sheet.annotations.marks import Mark
from gaussiancad_core.sheet.annotations.separate import SeparatedSheet, separate_annotations
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.special_views.finding import LayoutRequest
from gaussiancad_core.sheet.view_search import find_views

FRONT, TOP, RIGHT = (
    (0.0, 100.0, 100.0, 160.0),
    (0.0, 0.0, 100.0, 60.0),
    (150.0, 100.0, 210.0, 160.0),
)
TWO = {Role.FRONT: FRONT, Role.TOP: TOP}
THREE = {**TWO, Role.RIGHT: RIGHT}
WIDE = {Role.FRONT: (0.0, 160.0, 160.0, 270.0), Role.TOP: (0.0, 0.0, 160.0, 120.0)}
"""Larger than all three."""
LONG = {**THREE, Role.RIGHT: (150.0, 100.0, 240.0, 160.0)}
"""A right view that is deeper than the top view."""


def test_outlines_narrower_than_what_is_inside_are_outlines_still(sketch) -> None:  # noqa: ANN001
    drawn = sketch(640, 460)
    views = {
        Role.TOP: (50.0, 40.0, 250.0, 190.0),
        Role.FRONT: (50.0, 250.0, 250.0, 400.0),
        Role.RIGHT: (350.0, 250.0, 500.0, 400.0),
    }
    for x0, y0, x1, y1 in views.values():
        drawn.lines((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0), width=2.0)
    # Lines that lie beside each other look like one wide line.
    for x0, x1 in ((80.0, 200.0), (380.0, 450.0)):
        drawn.lines((x0, 280.0), (x1, 280.0), (x1, 370.0), (x0, 370.0), (x0, 280.0), width=3.4)
    sheet = clean_sheet(drawn.grey)
    assert separate_annotations(sheet).by_weight
    _, layout = find_views(sheet, {}, Projection.THIRD)
    assert set(layout.boxes) == set(views)
    for role, box in views.items():
        assert layout.boxes[role] == pytest.approx(box, abs=3.0)


def test_slivers_beside_a_large_figure_are_no_views(sketch) -> None:  # noqa: ANN001
    drawn = sketch(900, 600).lines((90, 140), (420, 140), (420, 460), (90, 460), (90, 140))
    for top, bottom in ((180, 240), (300, 400)):
        drawn.lines((700, top), (714, top), (714, bottom), (700, bottom), (700, top))
    sheet = clean_sheet(drawn.grey)
    with pytest.raises(NoModelError, match="largest figure") as caught:
        find_views(sheet, {}, None)
    assert caught.value.code == "views-not-aligned"
    named = {Role.FRONT: (698.0, 298.0, 717.0, 403.0), Role.TOP: (698.0, 178.0, 717.0, 243.0)}
    _, layout = find_views(sheet, named, None)
    assert set(layout.boxes) == {Role.FRONT, Role.TOP}


@pytest.mark.parametrize(
    ("by_weight", "by_form", "found"),
    [
        # What was told by line widths lost a view, or made one larger.
        (TWO, THREE, THREE),
        (LONG, THREE, LONG),
        (THREE, TWO, THREE),
        # Two views, each with dimensions on two sides.
        (WIDE, THREE, THREE),
    ],
)
def test_whole_views_are_preferred_where_they_are_larger(
    monkeypatch: pytest.MonkeyPatch,
    by_weight: dict[Role, Box],
    by_form: dict[Role, Box],
    found: dict[Role, Box],
) -> None:
    _answer(monkeypatch, lambda separated, _: by_weight if separated.by_weight else by_form)
    assert find_views(_blank(), {}, Projection.THIRD)[1].boxes == found


def test_outlines_may_have_gaps_where_views_are_missing_else(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    _answer(monkeypatch, lambda separated, _: TWO if separated.closed else THREE)
    separated, layout = find_views(_blank(), {}, Projection.THIRD, by_weight=False)
    assert (separated.closed, layout.boxes) == (False, THREE)


@pytest.mark.parametrize(
    ("plain", "cut", "left", "found"),
    [
        # What sticks out of the third view keeps it from being one.
        (TWO, THREE, (), THREE),
        (LONG, THREE, (), THREE),
        (THREE, {**THREE, Role.LEFT: (-90.0, 100.0, -30.0, 160.0)}, (), THREE),
        (
            THREE,
            {**THREE, Role.LEFT: (-90.0, 100.0, -30.0, 160.0)},
            ((-90.0, 100.0, -20.0, 165.0),),
            {**THREE, Role.LEFT: (-90.0, 100.0, -30.0, 160.0)},
        ),
    ],
)
def test_what_sticks_out_is_cut_where_views_are_missing(
    monkeypatch: pytest.MonkeyPatch,
    plain: dict[Role, Box],
    cut: dict[Role, Box],
    left: tuple[Box, ...],
    found: dict[Role, Box],
) -> None:
    _answer(monkeypatch, lambda _, request: cut if request.figures else plain, left)
    assert find_views(_blank(), {}, Projection.THIRD)[1].boxes == found


def _blank() -> CleanSheet:
    grey = np.full((200, 300), 255, np.uint8)
    grey[100, 20:280] = grey[20:180, 100] = 0
    return clean_sheet(grey, 0)


def _answer(
    monkeypatch: pytest.MonkeyPatch,
    boxes: Callable[[SeparatedSheet, LayoutRequest], dict[Role, Box]],
    left: tuple[Box, ...] = (),
) -> None:
    """Let the search find these views, without looking at the sheet."""

    def separate(sheet: CleanSheet, by_weight: bool = True, closed: bool = True) -> SeparatedSheet:
        marks = (Mark(AnnotationKind.DIMENSION, FRONT),)
        return SeparatedSheet(sheet, marks, by_weight, closed=closed and not by_weight)

    def find(
        sheet: CleanSheet, separated: SeparatedSheet, request: LayoutRequest
    ) -> tuple[SeparatedSheet, Layout]:
        layout = Layout(boxes(separated, request), Projection.THIRD, "default", (), ())
        rest = () if request.figures else left
        return separated, replace(layout, left_out=rest)

    monkeypatch.setattr(view_search, "separate_annotations", separate)
    monkeypatch.setattr(view_search, "find_named_layout", find)
