"""The projection symbol is found, told right, and nothing else is taken for it."""

from functools import cache
from pathlib import Path

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.annotation_pen import Pen
from gaussiancad_core.drawing.drawn_sheet import PartLines, compose_sheet, part_lines
from gaussiancad_core.drawing.frame import draw_symbol
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.sheet_style import SheetStyle, parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.sheet_views import SheetViews, sheet_views
from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.special_views.symbol_pixels import pixel_symbol
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol, largest_symbol
from sample_parts import sample


@cache
def _lines() -> PartLines:
    return part_lines(sample("boss-plate").build(), (Role.FRONT, Role.TOP, Role.RIGHT))


def _grey(projection: Projection, look: str) -> np.ndarray:
    drawn = compose_sheet(_lines(), projection, parse_style(look))
    return cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY)


def _sheet(projection: Projection, look: str) -> CleanSheet:
    return upright_sheet(clean_sheet(_grey(projection, look)))


def _symbol(sheet: CleanSheet) -> ProjectionSymbol | None:
    return pixel_symbol(sheet, largest_symbol(sheet.ink.shape, None))


def _views(projection: Projection, stated_projection: Projection | None) -> SheetViews:
    grey = _grey(projection, "dimensioned")
    image = SheetImage(Path("sheet.png"), grey, "")
    return sheet_views(OpenedSheet(image), {}, stated_projection)


@pytest.mark.parametrize("projection", Projection)
@pytest.mark.parametrize(
    "look",
    [
        "dimensioned,text-height=14",
        "dimensioned,blur=0.7,noise=4,jpeg-quality=85,skew=0.4",
    ],
)
def test_the_symbol_of_a_title_block_tells_the_projection(
    projection: Projection, look: str
) -> None:
    style = parse_style(look)
    drawn = compose_sheet(_lines(), projection, style)
    clean = upright_sheet(clean_sheet(cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY)))
    symbol = _symbol(clean)
    assert symbol is not None
    assert symbol.projection is projection
    true = next(m.box for m in drawn.annotations if m.kind is AnnotationKind.SYMBOL)
    assert clean.turn.box_to_stored(symbol.mark.box) == pytest.approx(true, abs=4.0)


def _alone(projection: Projection, size: float, quarter_turns: int, width: float) -> CleanSheet:
    style = SheetStyle(width=400, height=400, annotation_width=width)
    marks = draw_symbol(projection, (200.0, 200.0), size, Pen.of(style))
    ink = np.rot90(ink_annotations(tuple(marks), style), quarter_turns)
    return clean_sheet(np.rint(255.0 * (1.0 - ink)).astype(np.uint8))


def _on_sheet(clean: CleanSheet, ink: np.ndarray, weight: np.ndarray) -> CleanSheet:
    wide = np.zeros((800, 1600), bool)
    darkness = np.zeros((800, 1600), np.float32)
    wide[:400, :400], darkness[:400, :400] = ink, weight
    return CleanSheet(wide, darkness, clean.stroke_width, clean.turn)


def _with_axes(
    clean: CleanSheet, box: tuple[float, ...], turns: int
) -> tuple[np.ndarray, np.ndarray]:
    """The same with one line through cone and circles, longer than both."""
    ink, weight = clean.ink.copy(), clean.weight.copy()
    x0, y0, x1, y1 = (round(value) for value in box)
    line = (slice(y0 - 8, y1 + 8), (x0 + x1) // 2)
    if turns % 2 == 0:
        line = ((y0 + y1) // 2, slice(x0 - 8, x1 + 8))
    ink[line], weight[line] = True, 1.0
    return ink, weight


@pytest.mark.parametrize("projection", Projection)
@pytest.mark.parametrize(
    ("turns", "size", "width"), [(0, 20.0, 1.5), (1, 26.0, 2.0), (2, 40.0, 2.0), (3, 20.0, 1.5)]
)
def test_it_may_stand_anywhere_and_any_way_up(
    projection: Projection, turns: int, size: float, width: float
) -> None:
    clean = _alone(projection, size, turns, width)
    # What is a twentieth of a sheet is no more than one of this small one.
    symbol = _symbol(_on_sheet(clean, clean.ink, clean.weight))
    assert symbol is not None
    assert symbol.projection is projection
    if size >= 26.0:
        ink, weight = _with_axes(clean, symbol.mark.box, turns)
        along = _symbol(_on_sheet(clean, ink, weight))
        assert along is not None
        assert along.projection is projection


def test_a_mirrored_symbol_says_the_same() -> None:
    """The end view stands beside the same end of the cone."""
    clean = _alone(Projection.FIRST, 40.0, 0, 2.0)
    symbol = _symbol(_on_sheet(clean, clean.ink[:, ::-1], clean.weight[:, ::-1]))
    assert symbol is not None
    assert symbol.projection is Projection.FIRST


@pytest.mark.parametrize("look", ["clean", "dimensioned,symbol=off", "ansi"])
def test_without_a_symbol_none_is_found(look: str) -> None:
    assert _symbol(_sheet(Projection.THIRD, look)) is None


def test_the_views_are_named_by_the_symbol() -> None:
    projection = Projection.FIRST
    found = _views(projection, None)
    layout = found.layout
    assert set(layout.boxes) == {Role.FRONT, Role.TOP, Role.RIGHT}
    assert (layout.projection, layout.source) == (projection, "inferred")
    assert (layout.symbol, layout.alternatives) == (projection, (projection.other,))
    assert AnnotationKind.SYMBOL in {mark.kind for mark in found.separated.marks}


def test_what_the_user_says_counts_more() -> None:
    layout = _views(Projection.FIRST, Projection.THIRD).layout
    assert (layout.projection, layout.source, layout.symbol) == (Projection.THIRD, "given", None)


def test_no_symbol_is_looked_for_among_more_pieces_than_a_sheet_has() -> None:
    crowd = np.full((2400, 1700), 255, np.uint8)
    for y in range(4, 2390, 16):
        for x in range(4, 1690, 16):
            cv2.rectangle(crowd, (x, y), (x + 9, y + 9), 0, 1)
    grey = _grey(Projection.THIRD, "dimensioned")
    width = max(grey.shape[1], crowd.shape[1])
    wide = [
        np.pad(item, ((0, 0), (0, width - item.shape[1])), constant_values=255)
        for item in (grey, crowd)
    ]
    few, many = (clean_sheet(np.vstack([wide[0], part])) for part in (wide[1][:1], wide[1]))
    largest = largest_symbol(grey.shape, None)
    found = pixel_symbol(few, largest)
    assert found is not None and found.projection is Projection.THIRD
    assert pixel_symbol(many, largest) is None
