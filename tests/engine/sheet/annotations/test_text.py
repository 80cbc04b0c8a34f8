"""Writing is found, and nothing else is taken for it."""

from typing import Any

import cv2
import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.inking import ink_annotations
from gaussiancad_core.drawing.lettering import label
from gaussiancad_core.drawing.style import SheetStyle
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.annotations.text import Letters, find_letters

Sketch = Any
"""The class that the fixture gives."""

WIDTH, HEIGHT = 640, 400
TALL, STROKE = 18.0, 2.2


def _written(text: str, x: float, y: float, angle: float = 0.0) -> Mask:
    words = label(text, (x, y), TALL, angle)
    annotation = Annotation(AnnotationKind.TEXT, 0, label=words)
    return ink_annotations((annotation,), SheetStyle(width=WIDTH, height=HEIGHT)) >= 0.5


def _near(ink: Mask) -> Mask:
    return cv2.dilate(ink.astype(np.uint8), np.ones((5, 5), np.uint8)) > 0


def _found(ink: Mask, explained: Mask | None = None) -> Letters:
    told = np.zeros_like(ink) if explained is None else _near(explained)
    return find_letters(ink, told, STROKE)


def _part(sketch: Sketch) -> Mask:
    """A box with a dashed line, a dashed cross and a small circle with its mark."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    drawn.broken((60, 110), (400, 110), (12, 6)).broken((200, 60), (200, 300), (12, 6))
    drawn.arc((320, 220), 9.0, 2.0).line((308, 220), (332, 220), 1.5).line(
        (320, 208), (320, 232), 1.5
    )
    return drawn.weight >= 0.5


@pytest.mark.parametrize(
    "text", ["125", "R8", "M10x1.5", "52,49", "ABCDEFGHKLMNOPQRSTUVXYZ", "2x 45°"]
)
@pytest.mark.parametrize("angle", [0.0, -np.pi / 2])
def test_words_are_found_whole(text: str, angle: float) -> None:
    ink = _written(text, 320, 200, angle)
    letters = _found(ink)
    assert (letters.mask & ~ink).sum() == 0
    assert (ink & ~letters.mask).sum() == 0
    rows, columns = np.nonzero(letters.mask)
    boxes = np.array([mark.box for mark in letters.marks])
    assert (boxes[:, :2].min(0) == (columns.min(), rows.min())).all()
    assert (boxes[:, 2:].max(0) == (columns.max() + 1, rows.max() + 1)).all()
    assert {mark.kind for mark in letters.marks} == {AnnotationKind.TEXT}


def test_a_word_is_one_mark_and_words_apart_are_two() -> None:
    ink = _written("125", 200, 200) | _written("34", 500, 200)
    boxes = sorted(mark.box for mark in _found(ink).marks)
    assert len(boxes) == 2
    assert boxes[0][2] < 300 < boxes[1][0]
    for box in boxes:
        assert box[1] == pytest.approx(191, abs=2)
        assert box[3] == pytest.approx(209, abs=2)


def test_what_shapes_explain_is_no_letter(sketch: Sketch) -> None:
    part = _part(sketch)
    letters = _found(part, part)
    assert not letters.mask.any()
    assert letters.marks == ()


def test_dashes_are_no_letters_even_unexplained(sketch: Sketch) -> None:
    """Straight pieces say nothing by themselves."""
    drawn = sketch(WIDTH, HEIGHT).broken((60, 110), (400, 110), (12, 6))
    drawn.broken((90, 130), (390, 290), (14, 6), 3.0)
    assert not _found(drawn.weight >= 0.5).mask.any()


def test_writing_beside_the_part(sketch: Sketch) -> None:
    part = _part(sketch)
    text = _written("62", 230, 40) | _written("R8", 450, 200)
    letters = _found(part | text, part)
    assert np.array_equal(letters.mask, text)
    assert len(letters.marks) == 2


def test_a_one_is_a_letter_beside_others(sketch: Sketch) -> None:
    """It looks like a dash: its neighbours tell."""
    ink = _written("181", 200, 200)
    assert np.array_equal(_found(ink).mask, ink)
    bar = sketch(WIDTH, HEIGHT).line((400, 191), (400, 209), 2.0).weight >= 0.5
    assert np.array_equal(_found(ink | bar).mask, ink)


def test_a_one_joins_what_stands_on_both_of_its_sides(sketch: Sketch) -> None:
    """Else the lone digit after it, inside a view, would be a slot of the part."""
    box = sketch(WIDTH, HEIGHT).lines((60, 60), (560, 60), (560, 340), (60, 340), (60, 60))
    inside, beside = _written("Ø18", 320, 200), _written("62", 320, 30)
    letters = _found((box.weight >= 0.5) | inside | beside)
    assert np.array_equal(letters.mask, inside | beside)
    assert len(letters.marks) == 2


def test_an_o_explained_as_a_circle_joins_its_word() -> None:
    ink = _written("10", 200, 200)
    _, labels = cv2.connectedComponents(ink.astype(np.uint8))
    nought = labels == labels[:, np.nonzero(ink)[1].max()].max()
    seven = _written("7", 172, 200)
    letters = _found(ink | seven, nought)
    assert np.array_equal(letters.mask, ink | seven)


def test_large_letters_are_drawing() -> None:
    """What is taller than a twenty-fifth of the sheet is no writing."""
    ink = np.kron(_written("R8", 320, 200), np.ones((3, 3), bool))[400:800, 640:1280]
    assert ink.any()
    assert not _found(ink).mask.any()


def test_an_open_arrowhead_at_its_line_is_no_letter(sketch: Sketch) -> None:
    word = _written("2.344", 300, 320)
    lines = sketch(WIDTH, HEIGHT).line((198, 300), (240, 300))
    arrow = sketch(WIDTH, HEIGHT).line((200, 300), (200, 344))
    arrow.line((200, 300), (196, 314)).line((200, 300), (204, 314))
    # Less than a twenty-fifth of a wide sheet, as letters may be, but much taller than the number;
    # what the shaft ends at explains it in part.
    wide = [
        np.pad(own, ((0, 0), (0, 600))) for own in (word, lines.weight >= 0.5, arrow.weight >= 0.5)
    ]
    letters = _found(wide[0] | wide[1] | wide[2], wide[1])
    assert (letters.mask == wide[0]).all()
    assert len(letters.marks) == 1


def test_blank_paper() -> None:
    letters = _found(np.zeros((HEIGHT, WIDTH), bool))
    assert not letters.mask.any()
    assert letters.marks == ()


def test_a_bore_with_its_centre_mark_is_no_word(sketch: Sketch) -> None:
    """The cross touches nothing and is a plus by its looks; the circle around it is no O."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    drawn.arc((230, 180), 22.0, 2.0).arc((230, 180), 10.0, 2.0)
    drawn.line((222, 180), (238, 180), 1.5).line((230, 172), (230, 188), 1.5)
    found = _found((drawn.weight >= 0.5) | _written("125", 500, 200))
    assert len(found.marks) == 1
    assert found.marks[0].box[0] > 420


def test_a_small_circle_is_no_box_around_the_cross_in_it(sketch: Sketch) -> None:
    """The cross takes up most of the circle; a letter's box is a rectangle."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    drawn.arc((230, 180), 13.5, 4.0)
    drawn.line((222, 180), (238, 180), 4.0).line((230, 172), (230, 188), 4.0)
    found = _found((drawn.weight >= 0.5) | _written("125", 500, 200))
    assert len(found.marks) == 1
    assert found.marks[0].box[0] > 420


def test_the_corners_of_a_narrow_pocket_are_no_word(sketch: Sketch) -> None:
    """Its bottom is a dash and a stub, so that its corners look like an L and a J."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    for x, end in ((200, 211), (217, 215)):
        drawn.line((x, 61), (x, 71), 2.0).line((x, 75), (x, 85), 2.0).line((x, 85), (end, 85), 2.0)
    found = _found((drawn.weight >= 0.5) | _written("125", 500, 200))
    assert len(found.marks) == 1
    assert found.marks[0].box[0] > 420


def test_tall_pockets_beside_each_other_are_no_word(sketch: Sketch) -> None:
    """They are taller than what is written beside the view."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    for x in (150.0, 194.0):
        corners = [(x, 200.0), (x + 34.0, 200.0), (x + 34.0, 220.0), (x, 220.0)]
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            drawn.line(start, end, 2.0)
    beside = np.pad(_written("125", 500, 200), 300)
    found = _found(np.pad(drawn.weight >= 0.5, 300) | beside)
    assert np.array_equal(found.mask, beside)


def test_the_corners_of_a_low_notch_are_no_word(sketch: Sketch) -> None:
    """They are lower than what is written beside the view."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    for start, end, leg in ((150.0, 161.0, 151.0), (166.0, 177.0, 176.0)):
        drawn.line((start, 200.0), (end, 200.0), 2.0).line((leg, 200.0), (leg, 206.0), 2.0)
    beside = _written("125", 500, 200)
    found = _found((drawn.weight >= 0.5) | beside)
    assert np.array_equal(found.mask, beside)


def test_dots_and_dashes_beside_a_word_are_no_points_of_it(sketch: Sketch) -> None:
    word = _written("125", 320, 200)
    rows, columns = np.nonzero(word)
    beyond, below = columns.max() + 12, rows.max() + 12
    drawn = sketch(WIDTH, HEIGHT).line((beyond, 200), (beyond + 3, 200), 3.0)
    drawn.line((320, below), (323, below), 3.0)
    beside = drawn.weight >= 0.5
    letters = _found(word | beside)
    assert not (letters.mask & beside).any()
    assert (word & ~letters.mask).sum() == 0


def test_a_dashed_hole_with_its_drill_tip_is_no_word(sketch: Sketch) -> None:
    """Corners that lines do not explain, around what they bound, as tall as the writing beside."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    ink = (drawn.weight >= 0.5) | _written("FRONT VIEW", 230, 340)
    hole = sketch(WIDTH, HEIGHT)
    hole.lines((200, 188), (200, 204), (207, 204), width=2.0)
    hole.lines((219, 204), (226, 204), (226, 188), width=2.0)
    hole.lines((205, 209), (213, 215), (221, 209), width=2.0)
    letters = _found(ink | (hole.weight >= 0.5), drawn.weight >= 0.5)
    assert not (letters.mask & (hole.weight >= 0.5)).any()
    assert letters.mask[325:355].any()


def test_the_corners_of_a_drilled_bore_are_no_word(sketch: Sketch) -> None:
    """A side, the bottom and a flank of the tip meet in each, as high as the writing beside."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    ink = (drawn.weight >= 0.5) | _written("125", 500, 200)
    bore = sketch(WIDTH, HEIGHT)
    for x, way in ((200, 1), (236, -1)):
        bore.lines((x, 180), (x, 170), (x + 14 * way, 170), width=3.0)
        bore.line((x, 170), (x + 7 * way, 163), 3.0)
        # They go on.
        bore.line((x, 186), (x, 230), 2.0).line((x + 12 * way, 158), (x + 15 * way, 155), 2.0)
    dashes = bore.weight >= 0.5
    letters = _found(ink | dashes, drawn.weight >= 0.5)
    assert not (letters.mask & dashes).any()
    assert letters.mask.any()


def test_no_word_is_on_both_sides_of_an_outline(sketch: Sketch) -> None:
    """A dashed hole is as near to the number beside the view as its letters are to each other."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    number = _written("125", 426, 200)
    hole = sketch(WIDTH, HEIGHT)
    hole.lines((370, 188), (370, 204), (377, 204), width=2.0)
    hole.lines((389, 204), (396, 204), (396, 188), width=2.0)
    hole.lines((375, 209), (383, 215), (391, 209), width=2.0)
    dashes = hole.weight >= 0.5
    letters = _found((drawn.weight >= 0.5) | number | dashes, drawn.weight >= 0.5)
    assert np.array_equal(letters.mask, number)


def test_what_is_taller_than_the_writing_is_no_letter_in_a_box(sketch: Sketch) -> None:
    """A tapered pocket with edges from corner to corner, in a view that is a box around it."""
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (200, 60), (200, 200), (60, 200), (60, 60))
    ink = (drawn.weight >= 0.5) | _written("125", 500, 200)
    corners = (96, 96), (164, 96), (164, 164), (96, 164)
    inner = (130, 103), (157, 130), (130, 157), (110, 130)
    pocket = sketch(WIDTH, HEIGHT).lines(*corners, corners[0]).lines(*inner, inner[0])
    for k, corner in enumerate(corners):
        pocket.line(corner, inner[k]).line(corner, inner[k - 1])
    # A dash of what is hidden behind joins it.
    pocket.line((90, 146), (104, 146), 2.0)
    large = np.pad(pocket.weight >= 0.5, 900)
    found = _found(np.pad(ink, 900) | large)
    assert not (found.mask & large).any()
    assert found.mask.any()


def test_two_lines_of_writing_in_a_view_are_found(sketch: Sketch) -> None:
    drawn = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    inside = _written("R8 4x", 230, 160) | _written("TYP 2", 230, 184)
    ink = (drawn.weight >= 0.5) | inside | _written("125", 230, 340)
    letters = _found(ink, drawn.weight >= 0.5)
    assert (letters.mask & inside).sum() == inside.sum()


def test_an_i_between_letters_of_straight_strokes_is_one(sketch: Sketch) -> None:
    """Lines explain V and E, so that W alone is a letter by itself."""
    ink = _written("VIEW", 320, 200)
    columns = np.flatnonzero(ink.any(axis=0))
    straight = ink.copy()
    straight[:, columns.min() + int(0.72 * np.ptp(columns)) :] = False
    letters = _found(ink, straight)
    assert (ink & ~letters.mask).sum() == 0


@pytest.mark.parametrize("text", ["52", "94", "26", "78"])
def test_letters_much_thinner_than_lines_are_found(text: str) -> None:
    """Small digits have little more ink than a line of the sheet's width as long as they."""
    words = label(text, (320, 200), 13.0, 0.0)
    annotation = Annotation(AnnotationKind.TEXT, 0, label=words)
    ink = ink_annotations((annotation,), SheetStyle(width=WIDTH, height=HEIGHT)) >= 0.5
    letters = find_letters(ink, np.zeros_like(ink), 4.0)
    assert (ink & ~letters.mask).sum() == 0


def test_close_hidden_lines_are_no_writing(sketch: Sketch) -> None:
    """Dashes whose ink joins, as high as the words beside the view."""
    view = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    outline = view.weight >= 0.5
    dashes = sketch(WIDTH, HEIGHT)
    for x in (200, 203, 206, 212):
        dashes.broken((x, 64), (x, 296), (18, 10), 3.0)
    hidden = dashes.weight >= 0.5
    words = _written("FRONT VIEW", 230, 340)
    letters = _found(outline | hidden | words, outline)
    assert not (letters.mask & hidden).any()
    assert (words & ~letters.mask).sum() == 0


def test_pockets_above_each_other_are_no_word(sketch: Sketch) -> None:
    """As high as the numbers beside the view, and no further apart than letters are."""
    view = sketch(WIDTH, HEIGHT).lines((60, 60), (400, 60), (400, 300), (60, 300), (60, 60))
    pockets = sketch(WIDTH, HEIGHT)
    for y in (150, 182):
        pockets.lines((200, y), (213, y), (213, y + 20), (200, y + 20), (200, y))
    inside = pockets.weight >= 0.5
    ink = (view.weight >= 0.5) | inside | _written("125", 230, 340)
    letters = _found(ink, view.weight >= 0.5)
    assert not (letters.mask & inside).any()
    assert letters.mask[325:355].any()


def test_numbers_corner_to_corner_are_two_words() -> None:
    ink = _written("98", 200, 150) | _written("80", 200 + 1.9 * TALL, 150 - 1.2 * TALL)
    assert len(_found(ink).marks) == 2
    # Below each other they are a note of two lines.
    ink = _written("98", 200, 150) | _written("80", 200, 150 - 1.5 * TALL)
    assert len(_found(ink).marks) == 1
