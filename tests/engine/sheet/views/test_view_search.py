"""Views are those that belong together, without what sticks out of them where that tells."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.principal_views import LayoutRequest
from gaussiancad_core.sheet.views import view_search
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet.views.view_search import arranged

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


def test_slivers_beside_a_large_figure_are_no_views(sketch) -> None:  # noqa: ANN001
    drawn = sketch(900, 600).lines((90, 140), (420, 140), (420, 460), (90, 460), (90, 140))
    for top, bottom in ((180, 240), (300, 400)):
        drawn.lines((700, top), (714, top), (714, bottom), (700, bottom), (700, top))
    sheet = _opened(drawn.grey)
    separated = SeparatedSheet(sheet.clean, ())
    with pytest.raises(NoModelError, match="largest figure") as caught:
        arranged(sheet, separated, LayoutRequest({}, None))
    assert caught.value.code == "views-not-aligned"
    named = {Role.FRONT: (698.0, 298.0, 717.0, 403.0), Role.TOP: (698.0, 178.0, 717.0, 243.0)}
    _, layout = arranged(sheet, separated, LayoutRequest(named, None))
    assert set(layout.boxes) == {Role.FRONT, Role.TOP}


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
    _answer(monkeypatch, lambda request: cut if request.figures else plain, left)
    sheet = _blank()
    request = LayoutRequest({}, Projection.THIRD)
    assert arranged(sheet, SeparatedSheet(sheet.clean, ()), request)[1].boxes == found


def _opened(grey: np.ndarray) -> OpenedSheet:
    return OpenedSheet(SheetImage(Path("sheet.png"), grey, ""), 0)


def _blank() -> OpenedSheet:
    grey = np.full((200, 300), 255, np.uint8)
    grey[100, 20:280] = grey[20:180, 100] = 0
    return _opened(grey)


def _answer(
    monkeypatch: pytest.MonkeyPatch,
    boxes: Callable[[LayoutRequest], dict[Role, Box]],
    left: tuple[Box, ...] = (),
) -> None:
    """Let the search find these views, without looking at the sheet."""

    def find(
        sheet: OpenedSheet, separated: SeparatedSheet, request: LayoutRequest
    ) -> tuple[SeparatedSheet, Layout]:
        layout = Layout(boxes(request), Projection.THIRD, "default", (), ())
        rest = () if request.figures else left
        return separated, replace(layout, left_out=rest)

    monkeypatch.setattr(view_search, "find_named_layout", find)
