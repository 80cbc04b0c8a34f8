"""In free space no paper tells a frame from an outline: what it holds does."""

import itertools
from math import tau

import pytest
from engine.recognition.labels_of_files import labels_of, reading_of

from gaussiancad_core.files.vectors import StrokeKind, VectorStroke, VectorText
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.sheet_model.labelled_strokes import Label

_SIZE = (1000, 700)


def _box(x: float, y: float, w: float, h: float, layer: str = "") -> list[VectorStroke]:
    corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]
    return [
        VectorStroke(LineSegment(a, b), 2.0, layer=layer) for a, b in itertools.pairwise(corners)
    ]


def _circle(x: float, y: float, layer: str = "") -> list[VectorStroke]:
    return [VectorStroke(CircularArc((x, y), 20.0, 0.0, tau), 2.0, layer=layer)]


def _text(x: float, y: float, text: str = "t=3") -> VectorText:
    return VectorText(text, (x - 10.0, y - 5.0, x + 10.0, y + 5.0))


_AROUND = (50.0, 50.0, 900.0, 600.0)
_HOLES = _circle(300, 300), _circle(700, 400)
_VIEW = [*_box(300, 200, 300, 200), *_circle(400, 300)]


def _labels(
    strokes: list[VectorStroke], *texts: VectorText, has_paper: bool = False
) -> list[Label]:
    return labels_of(strokes, *texts, has_paper=has_paper)


def _is_guessed(strokes: list[VectorStroke]) -> bool:
    area = reading_of(strokes, has_paper=False)[0].area
    return area.is_framed and not area.is_certain


@pytest.mark.parametrize("layer", ["", "HOLES"])
@pytest.mark.parametrize("texts", [[], [_text(500, 680)]])
def test_the_outline_of_a_plate_with_holes_is_no_frame(layer: str, texts: list[VectorText]) -> None:
    holes = [*_circle(300, 300, layer), *_circle(700, 400, layer), *_box(450, 200, 80, 60, layer)]
    assert set(_labels(_box(*_AROUND) + holes, *texts)) == {Label.EDGE}


def test_words_within_the_outline_of_a_plate_in_one_pen_make_it_no_frame() -> None:
    strokes = [*_box(*_AROUND), *_HOLES[0], *_HOLES[1]]
    assert set(_labels(strokes, _text(500, 350))) == {Label.EDGE}


def test_a_note_beside_what_goes_around_a_view_tells_that_it_is_no_frame() -> None:
    assert _labels(_box(*_AROUND) + _VIEW, _text(500, 680))[:4] == [Label.EDGE] * 4


def test_what_goes_around_a_view_with_a_hole_is_a_frame() -> None:
    labels = _labels(_box(*_AROUND) + _VIEW, _text(500, 550))
    assert labels == [Label.FRAME] * 4 + [Label.EDGE] * 5


def test_a_frame_may_have_two_lines() -> None:
    strokes = _box(*_AROUND) + _box(60, 60, 880, 580) + _VIEW
    assert _labels(strokes) == [Label.FRAME] * 8 + [Label.EDGE] * 5


@pytest.mark.parametrize("layer", ["", "FRAME"])
def test_an_edge_within_a_view_tells_that_what_goes_around_is_a_frame(layer: str) -> None:
    edge = VectorStroke(LineSegment((300.0, 300.0), (600.0, 300.0)), 2.0)
    strokes = [*_box(*_AROUND, layer), *_box(300, 200, 300, 200), edge]
    assert _labels(strokes) == [Label.FRAME] * 4 + [Label.EDGE] * 5


def _ring(x: float, y: float, radius: float) -> VectorStroke:
    return VectorStroke(CircularArc((x, y), radius, 0.0, tau), 2.0)


def test_a_counterbore_does_not() -> None:
    rings = [_ring(300, 300, 60), _ring(300, 300, 100), *_HOLES[1]]
    assert set(_labels(_box(*_AROUND) + rings)) == {Label.EDGE}
    flange = [_ring(300, 300, 100), _ring(260, 300, 20), _ring(340, 300, 20)]
    assert _labels(_box(*_AROUND) + flange)[:4] == [Label.FRAME] * 4


def test_an_engraved_letter_does_not() -> None:
    crossbar = VectorStroke(LineSegment((500.0, 120.0), (540.0, 120.0)), 2.0)
    letter = [*_box(500, 100, 40, 40), crossbar]
    assert _labels([*_box(*_AROUND), *_HOLES[0], *letter])[:5] == [Label.EDGE] * 5


def test_a_bend_line_across_a_plate_does_not() -> None:
    bend = VectorStroke(LineSegment((500.0, 50.0), (500.0, 650.0)), 2.0, layer="BEND")
    labels = _labels([*_box(*_AROUND), *_HOLES[0], bend])
    assert labels[:5] == [Label.EDGE] * 5


_POCKET = [*_box(120, 120, 525, 375), *_circle(250, 250)]


@pytest.mark.parametrize("radius", [10.0, 60.0])
def test_a_hole_beside_what_looks_like_a_view_is_in_the_part_of_the_outline(radius: float) -> None:
    strokes = [*_box(*_AROUND), *_POCKET, _ring(800, 350, radius)]
    assert set(_labels(strokes)) == {Label.EDGE}


def test_two_pockets_with_a_hole_beside_them_are_no_views() -> None:
    other = [*_box(670, 120, 200, 375), *_circle(750, 250)]
    strokes = [*_box(*_AROUND), *_POCKET, *other, _ring(500, 580, 20.0)]
    assert set(_labels(strokes)) == {Label.EDGE}


def test_dimensions_of_a_pocket_divide_nothing() -> None:
    ends = ((200, 250), (200, 450)), ((500, 250), (500, 450)), ((200, 350), (500, 350))
    measures = [VectorStroke(LineSegment(*end), 1.0, kind=StrokeKind.DIMENSION) for end in ends]
    strokes = [*_box(*_AROUND), *_box(200, 200, 300, 50), *_HOLES[1], *measures]
    assert _labels(strokes)[:4] == [Label.EDGE] * 4


def test_around_a_single_view_a_frame_is_a_guess() -> None:
    strokes = [*_box(*_AROUND), *_POCKET]
    assert _labels(strokes)[:4] == [Label.FRAME] * 4
    assert _is_guessed(strokes)


@pytest.mark.parametrize("width", [20, 120])
def test_around_views_in_a_row_a_frame_is_certain(width: int) -> None:
    plain = _box(680, 200, width, 200)
    strokes = [*_box(*_AROUND), *_VIEW, *plain]
    assert _labels(strokes) == [Label.FRAME] * 4 + [Label.EDGE] * 9
    assert not _is_guessed(strokes)
    # In no row with it, it is a recess beside a pocket.
    aside = _box(680, 150, width, 200)
    assert set(_labels([*_box(*_AROUND), *_VIEW, *aside])) == {Label.EDGE}


@pytest.mark.parametrize(("left", "guessed"), [(40.0, False), (20.0, True)])
def test_the_margins_of_a_sheet_tell_its_edge_and_frame(left: float, guessed: bool) -> None:
    inner = _box(50.0 + left, 70.0, 880.0 - left, 560.0)
    strokes = [*_box(*_AROUND), *inner, *_VIEW]
    assert _labels(strokes) == [Label.FRAME] * 8 + [Label.EDGE] * 5
    assert _is_guessed(strokes) is guessed


def test_paper_tells_a_frame_by_its_margins() -> None:
    strokes = [*_box(*_AROUND, "FRAME"), *_box(300, 200, 300, 200)]
    assert _labels(strokes, has_paper=True)[:4] == [Label.FRAME] * 4
