"""The part's ink stays, all other ink goes, and sheets without annotations are not touched."""

from dataclasses import dataclass, replace
from functools import cache

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.labels.labelled_ink import separate_by_labels
from gaussiancad_core.sheet.labels.labels_network import ink_labels
from sample_parts import sample

Kind = AnnotationKind

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
PARTS = ["l-bracket", "boss-plate", "rib-bracket"]


@dataclass(frozen=True)
class Case:
    """A drawn sheet taken apart."""

    style: SheetStyle
    drawn: Sheet
    clean: CleanSheet
    separated: SeparatedSheet


@cache
def _lines(part: str) -> PartLines:
    return part_lines(sample(part).build(), ROLES)


@cache
def _case(part: str, name: str) -> Case:
    style = replace(PRESETS[name], width=1440, height=900)
    drawn = compose_sheet(_lines(part), Projection.THIRD, style)
    grey = cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY)
    clean = clean_sheet(grey)
    return Case(style, drawn, clean, separate_by_labels(clean, ink_labels(grey)))


def _wider(mask: Mask, px: int) -> Mask:
    return cv2.dilate(mask.astype(np.uint8), np.ones((2 * px + 1, 2 * px + 1), np.uint8)) > 0


def _part_ink(case: Case) -> np.ndarray:
    strokes = tuple(stroke for view in case.drawn.views for stroke in view.strokes)
    return rasterise(strokes, case.style)


def _recall(case: Case) -> float:
    """Share of the part's inked length with ink left within 1 px."""
    strokes = [stroke for view in case.drawn.views for stroke in view.strokes]
    columns, rows = np.floor(np.concatenate([s.sample(0.5) for s in strokes])).astype(int).T
    inked = _part_ink(case)[rows, columns] > 0.5
    left = _wider(case.separated.part.ink, 1)[rows, columns]
    return float((left & inked).sum() / inked.sum())


def _left(case: Case, *kinds: AnnotationKind) -> float:
    """Share of the ink of annotations, 5 px and more away from the part's, that is still there."""
    chosen = tuple(mark for mark in case.drawn.annotations if mark.kind in kinds)
    ink = (ink_annotations(chosen, case.style) > 0.5) & ~_wider(_part_ink(case) > 0.1, 5)
    assert ink.any()
    return float((ink & case.separated.part.ink).sum() / ink.sum())


@pytest.mark.parametrize("part", PARTS)
def test_a_dimensioned_sheet_keeps_its_part(part: str) -> None:
    assert _recall(_case(part, "dimensioned")) >= 0.99


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize(
    ("kinds", "most"),
    [
        ((Kind.FRAME, Kind.TITLE_BLOCK, Kind.SYMBOL), 0.01),
        ((Kind.TEXT,), 0.01),
        # Of these more is left than of the others: up to a thirtieth of their ink.
        ((Kind.DIMENSION, Kind.EXTENSION, Kind.LEADER), 0.04),
    ],
)
def test_a_dimensioned_sheet_loses_the_rest(
    part: str, kinds: tuple[AnnotationKind, ...], most: float
) -> None:
    assert _left(_case(part, "dimensioned"), *kinds) <= most


@pytest.mark.parametrize("part", PARTS)
def test_all_of_it_together(part: str) -> None:
    assert _left(_case(part, "dimensioned"), *Kind) <= 0.01


@pytest.mark.parametrize("part", ["l-bracket", "rib-bracket"])
def test_an_american_sheet_keeps_its_part(part: str) -> None:
    assert _recall(_case(part, "ansi")) >= 0.99


@pytest.mark.parametrize("part", ["l-bracket", "boss-plate"])
def test_an_american_sheet_loses_its_centre_lines(part: str) -> None:
    """Hidden lines are as thin as they."""
    assert _left(_case(part, "ansi"), Kind.CENTRE_LINE) <= 0.025


@pytest.mark.parametrize("part", ["l-bracket", "boss-plate", "slotted-link", "rib-bracket"])
def test_a_sheet_without_annotations_is_not_touched(part: str) -> None:
    case = _case(part, "clean")
    assert case.separated.marks == ()
    assert np.array_equal(case.separated.part.ink, case.clean.ink)
    assert np.array_equal(case.separated.part.weight, case.clean.weight)
    assert case.separated.part.stroke_width == case.clean.stroke_width


@pytest.mark.parametrize("style", ["iso", "thin", "thick"])
def test_thin_hidden_lines_are_no_annotations(style: str) -> None:
    case = _case("boss-plate", style)
    assert case.separated.marks == ()
    assert np.array_equal(case.separated.part.ink, case.clean.ink)


@pytest.mark.parametrize("part", PARTS)
def test_nothing_is_drawn_anew(part: str) -> None:
    """What is left was there before, as dark as before."""
    case = _case(part, "dimensioned")
    left = case.separated.part
    assert not (left.ink & ~case.clean.ink).any()
    same = left.weight == case.clean.weight
    assert (same | (left.weight == 0.0)).all()
    assert left.turn == case.clean.turn
    assert left.stroke_width == case.clean.stroke_width


@pytest.mark.parametrize("part", PARTS)
def test_every_text_of_the_drawing_is_marked(part: str) -> None:
    """Each dimension's text lies in a mark, those of the title block in its fields."""
    case = _case(part, "dimensioned")
    stated = [m.box for m in case.separated.marks if m.kind in (Kind.TEXT, Kind.TITLE_BLOCK)]
    texts = [mark.label for mark in case.drawn.annotations if mark.group and mark.label is not None]
    assert texts
    for text in texts:
        x, y = text.centre
        assert any(x0 <= x <= x1 and y0 <= y <= y1 for x0, y0, x1, y1 in stated), text.text


@pytest.mark.parametrize("part", PARTS)
def test_marks_lie_where_there_was_ink(part: str) -> None:
    case = _case(part, "dimensioned")
    kinds = {mark.kind for mark in case.separated.marks}
    assert {Kind.FRAME, Kind.TITLE_BLOCK, Kind.TEXT, Kind.DIMENSION} <= kinds
    for mark in case.separated.marks:
        x0, y0, x1, y1 = mark.box
        rows = slice(max(int(y0) - 1, 0), int(np.ceil(y1)) + 2)
        columns = slice(max(int(x0) - 1, 0), int(np.ceil(x1)) + 2)
        assert case.clean.ink[rows, columns].any()
        if mark.line is not None:
            ends = np.array(mark.line)
            assert ends.min(0) == pytest.approx((x0, y0))
            assert ends.max(0) == pytest.approx((x1, y1))


def test_twice_is_once() -> None:
    """What is left of a sheet has nothing more to take off but crumbs."""
    case = _case("l-bracket", "dimensioned")
    left = case.separated.part
    again = separate_by_labels(left, ink_labels(left.picture)).part.ink
    lost = case.separated.part.ink & ~again
    assert lost.sum() < 0.02 * case.separated.part.ink.sum()
