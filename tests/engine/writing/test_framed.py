"""What is written in the margin of a sheet is of its frame."""

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.annotation_marks import line_mark
from gaussiancad_core.writing.sheet_texts import SheetText, framed

_SHAPE = (700, 1000)
_CORNERS = (40.0, 30.0, 960.0, 670.0)


def _frame() -> list:
    x0, y0, x1, y1 = _CORNERS
    ends = [((x0, y0), (x1, y0)), ((x0, y1), (x1, y1)), ((x0, y0), (x0, y1)), ((x1, y0), (x1, y1))]
    outer = [((10.0, 10.0), (990.0, 10.0))]
    # The title block's own lines, and an edge that is no frame.
    block = [((700.0, 600.0), (960.0, 600.0))]
    marks = [line_mark(AnnotationKind.FRAME, *end) for end in (*ends, *outer, *block)]
    return [*marks, line_mark(AnnotationKind.EXTENSION, (100.0, 300.0), (900.0, 300.0))]


def _text(x: float, y: float) -> SheetText:
    return SheetText("4", (x - 5.0, y - 5.0, x + 5.0, y + 5.0))


def test_numbers_of_zones_are_fields_and_dimensions_are_not() -> None:
    zones = [_text(500, 20), _text(500, 685), _text(25, 350), _text(980, 350)]
    others = [_text(500, 60), _text(800, 640), _text(60, 350)]
    assert all(item.field for item in framed(zones, _frame(), _SHAPE))
    assert not any(item.field for item in framed(others, _frame(), _SHAPE))


def test_without_a_frame_nothing_is_in_a_margin() -> None:
    assert not any(item.field for item in framed([_text(5, 5), _text(995, 695)], (), _SHAPE))
