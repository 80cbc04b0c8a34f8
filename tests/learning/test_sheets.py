"""Random sheets: repeatable, all kinds of ink on them, and the truth where the ink is."""

import random

import cv2
import numpy as np
import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from learning.sheets import clean_sheet, composing, font_names, samples
from learning.sheets.canvas import Canvas
from learning.sheets.chains_of_points import (
    beyond,
    dashed,
    length,
    rectangle,
    segment,
)
from learning.sheets.cut_hatching import hatch_lines
from learning.sheets.letter_fonts import Fonts
from learning.sheets.rendering import INK, Rendered, rendered
from learning.sheets.spoiling import spoiled
from learning.sheets.text_pixels import Lettering, text_mask
from learning.sheets.variants import slab, squashed
from learning.training_parts import Circle, DrawnPart, PartSection, PartView
from learning.training_samples import (
    EITHER,
    HEAT_MOST,
    HEAT_SHIFT,
    ON_HIDDEN,
    UNKNOWN,
)

pytestmark = pytest.mark.slow

_SHEETS = 30


def _part() -> DrawnPart:
    """A block with a rounded edge and a bore, by hand: nothing here needs the kernel."""
    edges = [segment(*item) for item in ([(0, 0), (60, 0)], [(60, 0), (60, 40)])]
    edges += [segment(*item) for item in ([(60, 40), (0, 40)], [(0, 40), (0, 0)])]
    visible = tuple(edge.astype(np.float32) for edge in edges)
    hidden = tuple(segment((x, 0), (x, 40)).astype(np.float32) for x in (20.0, 30.0))
    tangent = (segment((50, 0), (50, 40)).astype(np.float32),)
    circle = Circle((25.0, 20.0), 5.0, 0.0, 2.0 * np.pi, hidden=False)
    view = PartView(visible, hidden, tangent, (circle,))
    cut = PartView(visible, (), (), (), ((rectangle(0, 0, 20, 40).astype(np.float32),),))
    views = {Role.FRONT: view, Role.TOP: view, Role.RIGHT: view}
    return DrawnPart(views, (PartSection(Role.FRONT, SectionKind.FULL, cut),), visible)


@pytest.fixture(scope="module")
def sheets() -> list[Rendered]:
    return [clean_sheet(random.Random(seed), [_part()]) for seed in range(_SHEETS)]


def test_the_same_seed_gives_the_same_samples() -> None:
    first, second = (list(samples(5, [_part()], 256, 3)) for _ in range(2))
    assert len(first) == 3
    for one, other in zip(first, second, strict=True):
        assert np.array_equal(one.grey, other.grey)
        assert np.array_equal(one.classes, other.classes)
        assert np.array_equal(one.extra, other.extra)


def test_samples_have_the_size_that_was_asked_for() -> None:
    for seed in range(4):
        for sample in samples(seed, [_part()], 224, 2):
            for layer in (sample.grey, sample.classes, sample.extra):
                assert layer.shape == (224, 224) and layer.dtype == np.uint8


def test_a_piece_may_be_larger_than_the_sheet() -> None:
    sample = next(samples(1, [_part()], 3040, 1))
    assert sample.grey.shape == sample.classes.shape == sample.extra.shape == (3040, 3040)


def test_every_class_is_on_some_sheet(sheets: list[Rendered]) -> None:
    found = set().union(*(np.unique(sheet.classes).tolist() for sheet in sheets))
    assert found >= {int(item) for item in InkClass}
    assert found <= {*(int(item) for item in InkClass), UNKNOWN}


def test_what_has_a_class_is_darker_than_paper(sheets: list[Rendered]) -> None:
    for sheet in sheets:
        labelled = (sheet.classes != InkClass.PAPER) & (sheet.classes != UNKNOWN)
        assert (sheet.ink[labelled] >= INK).all()
        assert (sheet.ink[sheet.classes == InkClass.PAPER] < INK).all()


def test_little_ink_is_of_unknown_class(sheets: list[Rendered]) -> None:
    inked = np.concatenate([sheet.classes[sheet.ink >= INK] for sheet in sheets])
    assert np.mean(inked == UNKNOWN) < 0.01


def test_tracks_cover_hidden_lines(sheets: list[Rendered]) -> None:
    hidden = [sheet.extra[sheet.classes == InkClass.HIDDEN] & EITHER for sheet in sheets]
    tracks = np.concatenate(hidden)
    assert len(tracks)
    assert np.mean(tracks == ON_HIDDEN) > 0.99


def test_visible_lines_over_tracks_count_for_nothing(sheets: list[Rendered]) -> None:
    for sheet in sheets:
        over = sheet.extra[sheet.classes == InkClass.VISIBLE] & EITHER
        assert not (over == ON_HIDDEN).any()


def test_a_line_is_labelled_where_it_is_drawn() -> None:
    canvas = Canvas(60, 40)
    canvas.lines([segment((10.0, 20.0), (50.0, 20.0))], InkClass.CENTRE, 4.0, 255)
    canvas.lines([segment((30.0, 5.0), (30.0, 35.0))], InkClass.VISIBLE, 4.0, 200)
    canvas.corners.append(np.array([30.0, 5.0]))
    sheet = rendered(canvas, smooth=True)
    assert sheet.classes[20, 15] == InkClass.CENTRE
    assert sheet.classes[20, 30] == InkClass.VISIBLE
    assert sheet.classes[20, 55] == InkClass.PAPER and sheet.classes[28, 15] == InkClass.PAPER
    assert sheet.extra[5, 30] >> HEAT_SHIFT >= HEAT_MOST - 3
    assert sheet.extra[20, 30] >> HEAT_SHIFT == 0


def test_marks_beyond_the_sheet_leave_it_empty() -> None:
    canvas = Canvas(40, 30)
    mask = np.full((8, 8), 255, np.uint8)
    for corner in ((-20.0, 5.0), (60.0, 5.0), (5.0, -20.0), (5.0, 60.0)):
        canvas.stamp(mask, corner, InkClass.TEXT, 255)
    assert not rendered(canvas, smooth=True).ink.any()


def test_dashes_are_as_long_as_their_pattern_says() -> None:
    pieces = dashed(segment((0.0, 0.0), (100.0, 0.0)), (10.0, 5.0))
    assert [length(piece) for piece in pieces] == pytest.approx([10.0] * 7)
    assert [piece[0, 0] for piece in pieces] == pytest.approx([15.0 * item for item in range(7)])


def test_a_line_is_cut_at_a_border() -> None:
    (piece,) = beyond(segment((0.0, 0.0), (10.0, 20.0)), 0, 4.0, 1)
    assert piece.tolist() == [[4.0, 8.0], [10.0, 20.0]]


def test_hatching_stays_in_its_area() -> None:
    outer, hole = rectangle(0, 0, 40, 40), rectangle(10, 10, 30, 30)
    lines = hatch_lines((outer, hole), 45.0, (4.0, 2.0))
    assert lines
    for line in lines:
        middle = line.mean(axis=0)
        assert (line > -1e-6).all() and (line < 40.0 + 1e-6).all()
        assert not ((middle > 10.0) & (middle < 30.0)).all()


def test_slabs_and_squashed_parts_fit_together() -> None:
    for seed in range(40):
        chance = random.Random(seed)
        part = slab(chance)
        thin = squashed(part, chance)
        for item in (part, thin):
            width, height = np.ptp(item.views[Role.FRONT].box(), axis=0)
            depth = np.ptp(item.views[Role.TOP].box(), axis=0)[1]
            assert np.ptp(item.views[Role.TOP].box(), axis=0)[0] == pytest.approx(width, rel=1e-3)
            side = np.ptp(item.views[Role.RIGHT].box(), axis=0)
            assert side == pytest.approx([depth, height], rel=1e-3)


def test_there_is_always_a_font() -> None:
    assert font_names()[0] == "Hershey"


def test_sheets_are_lettered_without_any_font_of_the_system(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(composing, "system_fonts", lambda: Fonts((), ()))
    found = [clean_sheet(random.Random(seed), [_part()]) for seed in range(4)]
    assert any((sheet.classes == InkClass.TEXT).any() for sheet in found)


def test_letters_that_a_font_lacks_are_replaced() -> None:
    lettering = Lettering(None, cv2.FONT_HERSHEY_SIMPLEX, 1.0)
    plain, crossed = (text_mask(item, 12.0, lettering) for item in ("O12", "⌀12"))
    assert plain.shape == crossed.shape
    assert crossed.sum() > plain.sum()


@pytest.mark.parametrize("seed", range(12))
def test_spoiling_keeps_the_truth_on_the_ink(seed: int) -> None:
    sheet = Canvas(200, 200)
    sheet.lines([rectangle(40.0, 60.0, 160.0, 140.0)], InkClass.VISIBLE, 5.0, 255)
    clean = rendered(sheet, smooth=True)
    this_spoiled = spoiled(clean, np.random.default_rng(seed))
    ink = this_spoiled.grey[this_spoiled.classes == InkClass.VISIBLE].astype(float)
    paper = this_spoiled.grey[this_spoiled.classes == InkClass.PAPER].astype(float)
    inverted = np.median(paper) < np.median(ink)
    contrast = np.median(paper) - np.median(ink)
    assert contrast < -30.0 if inverted else contrast > 30.0
    assert abs(len(ink) - (clean.classes == InkClass.VISIBLE).sum()) < 0.2 * len(ink)
