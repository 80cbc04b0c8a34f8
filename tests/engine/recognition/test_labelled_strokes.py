"""What strokes stand for is told by how they meet, their pens, and the writing between them."""

import itertools
import math
from math import tau

import numpy as np
import pytest
from engine.recognition.labels_of_files import labels_of, reading_of

from gaussiancad_core.files.vectors import (
    StrokeKind,
    StrokeRole,
    VectorStroke,
    VectorText,
)
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.recognition.drawn_layout import doubtful_lines, strokes_of_other_pens
from gaussiancad_core.sheet_model.labelled_strokes import Label
from gaussiancad_core.views.drawn_groups import DrawingKind

Points = list[tuple[float, float]]

_WIDE, _THIN = 4.0, 2.0


def _lines(*ends: tuple[float, float, float, float], width: float = _WIDE) -> list[VectorStroke]:
    return [VectorStroke(LineSegment((a, b), (c, d)), width) for a, b, c, d in ends]


def _box(x: float, y: float, w: float, h: float, width: float = _WIDE) -> list[VectorStroke]:
    corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]
    return [VectorStroke(LineSegment(a, b), width) for a, b in itertools.pairwise(corners)]


def _text(x: float, y: float, text: str = "12") -> VectorText:
    return VectorText(text, (x - 10.0, y - 5.0, x + 10.0, y + 5.0))


def _frame(width: float = _WIDE) -> list[VectorStroke]:
    return _box(20, 20, 960, 660, width)


def _table(x: float, y: float, width: float) -> tuple[list[VectorStroke], list[VectorText]]:
    """Two columns and three rows of writing."""
    dividers = [(x, y + 20, x + 200, y + 20), (x, y + 40, x + 200, y + 40)]
    lines = _box(x, y, 200, 60, width) + _lines(*dividers, (x + 80, y, x + 80, y + 60), width=width)
    texts = [_text(x + dx, y + dy) for dx in (40, 140) for dy in (10, 30, 50)]
    return lines, texts


def _dimension(x0: float, x1: float, y: float, edge: float) -> list[VectorStroke]:
    """A dimension line with two extension lines that begin at an edge."""
    rows = (x0, edge, x0, y - 5), (x1, edge, x1, y - 5), (x0, y, x1, y)
    return _lines(*rows, width=_THIN)


def _labels(strokes: list[VectorStroke], texts: list[VectorText] | None = None) -> list[Label]:
    return labels_of(strokes, *(texts or ()))


def test_the_wide_pen_that_closes_outlines_is_the_parts() -> None:
    part, dimension = _box(300, 300, 200, 100), _dimension(300, 500, 250, 300)
    labels = _labels(part + dimension, [_text(400, 240)])
    assert labels == [Label.EDGE] * 4 + [Label.OTHER] * 3


@pytest.mark.parametrize("width", [_WIDE, 6.0])
def test_frames_and_tables_are_told_whatever_their_pen(width: float) -> None:
    part = _box(300, 300, 200, 100)
    table, texts = _table(780, 620, width)
    labels = _labels(part + _frame(width) + table, texts)
    assert labels == [Label.EDGE] * 4 + [Label.FRAME] * (4 + len(table))


@pytest.mark.parametrize("written", [True, False])
def test_a_title_block_beneath_tells_a_frame_by_what_is_written_in_its_cells(
    written: bool,
) -> None:
    part = _box(300, 200, 200, 100)
    upper, lower = _box(60, 40, 880, 400), _box(60, 460, 880, 200)
    dividers = _lines((60, 520, 940, 520), (60, 580, 940, 580), (400, 460, 400, 660))
    texts = [_text(200, y) for y in (490, 550, 620)] if written else []
    labels = _labels([*part, *upper, *lower, *dividers], texts)
    assert (labels == [Label.EDGE] * 4 + [Label.FRAME] * 11) is written


def test_a_stepped_part_with_numbers_in_it_is_no_table() -> None:
    corners = [(300, 300), (700, 300), (700, 350), (600, 350), (600, 400), (300, 400), (300, 300)]
    part = [VectorStroke(LineSegment(a, b), _WIDE) for a, b in itertools.pairwise(corners)]
    part += _lines((450, 300, 450, 400))
    texts = [_text(350, 330), _text(500, 330), _text(650, 330)]
    assert set(_labels(part, texts)) == {Label.EDGE}


def test_a_cutting_trace_in_the_parts_pen_ends_somewhere_and_is_none_of_it() -> None:
    part = _box(300, 300, 200, 100)
    trace = _lines((400, 250, 400, 290), (400, 250, 360, 250))
    assert _labels(part + trace) == [Label.EDGE] * 4 + [Label.OTHER] * 2


def test_dashes_by_the_file_and_one_by_one_are_hidden_lines() -> None:
    part = _box(300, 300, 200, 100)
    by_file = [
        VectorStroke(LineSegment((350, 300), (350, 400)), _THIN, (8.0, 4.0), StrokeRole.HIDDEN)
    ]
    one_by_one = _lines(*((430, y, 430, y + 8) for y in range(304, 396, 12)), width=1.0)
    labels = _labels(part + by_file + one_by_one)
    assert labels == [Label.EDGE] * 4 + [Label.HIDDEN] * (1 + len(one_by_one))


def test_slanted_parallels_from_edge_to_edge_are_hatching() -> None:
    part = _box(300, 300, 200, 100)
    hatching = _lines(*((x, 300, x - 40, 340) for x in (340, 380, 420, 460)), width=_THIN)
    floor = _lines((300, 340, 500, 340))
    labels = _labels(part + floor + hatching)
    assert labels == [Label.EDGE] * 5 + [Label.HATCH] * 4


def test_short_lines_of_a_hatching_are_parallel_as_far_as_the_files_numbers_tell() -> None:
    """In a wall of 6 px a third of a pixel turns a line by two degrees and more."""
    part = _box(300, 300, 200, 100) + _lines((306, 300, 306, 400))
    places = range(310, 400, 15)
    hatching = _lines(
        *((300, y, 306, y - 6 + (0.25 if k % 2 else 0.0)) for k, y in enumerate(places)),
        width=_THIN,
    )
    assert _labels(part + hatching)[5:] == [Label.HATCH] * len(places)


def test_slanted_parallels_are_no_hatching_where_each_view_has_but_one() -> None:
    places = [(60.0 + 220.0 * k, 100.0 + 130.0 * k) for k in range(4)]
    views = [item for x, y in places for item in _box(x, y, 120, 90)]
    slanted = [(x, y + 90.0, x + 90.0, y) for x, y in places]
    assert Label.HATCH not in _labels(views + _lines(*slanted, width=_THIN))


def test_what_the_file_calls_hatching_is_hatching_however_few_its_lines() -> None:
    ends = (310, 340, 350, 300), (480, 400, 500, 380), (600, 340, 640, 300)
    named = [
        VectorStroke(LineSegment((a, b), (c, d)), _THIN, role=StrokeRole.HATCH)
        for a, b, c, d in ends
    ]
    assert _labels(_box(300, 300, 200, 100) + named)[-3:] == [Label.HATCH] * 3


def test_what_the_file_calls_a_dimension_is_none_of_the_part() -> None:
    dimension = [
        VectorStroke(item.curve, _WIDE, kind=StrokeKind.DIMENSION)
        for item in _box(600, 300, 200, 100)
    ]
    labels = _labels(_box(300, 300, 200, 100) + dimension)
    assert labels[4:] == [Label.OTHER] * 4


def test_colours_are_pens() -> None:
    red, black = (255, 0, 0), (0, 0, 0)
    part = [VectorStroke(s.curve, _THIN, colour=black) for s in _box(300, 300, 200, 100)]
    hole = [VectorStroke(CircularArc((400, 350), 20, 0.0, tau), _THIN, colour=black)]
    notes = [VectorStroke(s.curve, _THIN, colour=red) for s in _dimension(300, 500, 250, 300)]
    labels = _labels(part + hole + notes)
    assert labels == [Label.EDGE] * 5 + [Label.OTHER] * 3


@pytest.mark.parametrize(
    "strokes",
    [
        pytest.param([], id="nothing"),
        pytest.param(_frame(), id="a frame alone"),
        pytest.param(
            _lines((300, 300, 400, 300), (300, 340, 400, 340), (300, 380, 400, 380)), id="loose"
        ),
    ],
)
def test_where_nothing_closes_no_view_is_told(strokes: list[VectorStroke]) -> None:
    reading, _ = reading_of(strokes)
    assert reading.ranking is None


def test_lines_of_another_pen_from_edge_to_edge_are_doubtful() -> None:
    """Smooth edges are drawn thin by some; dimensions have heads."""
    part = _box(300, 300, 200, 100)
    smooth = _lines((420, 300, 420, 400), width=_THIN)
    heads = [(x, 350, x + way * 8, 350 + up) for x, way in ((300, 1), (500, -1)) for up in (3, -3)]
    backs = [(x, 353, x, 347) for x in (308, 492)]
    dimension = _lines((300, 350, 500, 350), *heads, *backs, width=_THIN)
    reading, scale = reading_of(part + smooth + dimension)
    assert reading.ranking is not None
    (line,) = doubtful_lines(reading, reading.ranking.best, scale)
    assert line.box == pytest.approx((420, 300, 420, 400))
    (other,) = strokes_of_other_pens(reading, reading.ranking.best, scale)
    assert (other.start, other.end) == (line.start, line.end)


def test_layers_that_close_outlines_with_the_parts_are_it_too() -> None:
    part = [VectorStroke(s.curve, _WIDE, layer="OUTER") for s in _box(300, 300, 200, 100)]
    inner = [VectorStroke(LineSegment((420, 300), (420, 400)), _WIDE, layer="INNER")]
    other = [VectorStroke(s.curve, _WIDE, layer="SIDE") for s in _box(600, 300, 50, 100)]
    notes = [VectorStroke(s.curve, _WIDE, layer="DIM") for s in _dimension(300, 500, 250, 300)]
    labels = _labels(part + inner + other + notes)
    assert labels == [Label.EDGE] * 9 + [Label.OTHER] * 3


def test_an_outline_that_spans_the_sheet_but_leaves_it_room_is_no_frame() -> None:
    """A plate drawn as large as goes, with a narrow view beside it."""
    part = [*_box(60, 100, 620, 450), *_box(800, 100, 40, 450)]
    labels = _labels(part + _frame(2.0))
    assert labels == [Label.EDGE] * len(part) + [Label.FRAME] * 4


def _isometric(x: float, y: float, side: float) -> list[VectorStroke]:
    """The nine edges of a cube that are seen."""
    way = {"a": (0.866 * side, -0.5 * side), "b": (-0.866 * side, -0.5 * side), "c": (0.0, -side)}

    def at(*ways: str) -> tuple[float, float]:
        return x + sum(way[w][0] for w in ways), y + sum(way[w][1] for w in ways)

    edges = ["", "a"], ["", "b"], ["", "c"], ["a", "ac"], ["b", "bc"], ["c", "ac"], ["c", "bc"]
    edges = (*edges, ["ac", "abc"], ["bc", "abc"])
    return [VectorStroke(LineSegment(at(*one), at(*two)), _WIDE) for one, two in edges]


def test_a_pictorial_whose_box_overlaps_a_view_takes_nothing_from_it() -> None:
    view = _box(300, 530, 150, 100)
    pictorial = _isometric(560, 560, 160)
    reading, scale = reading_of([*view, *pictorial])
    kinds = {found.kind: np.array(found.box) * scale for found in reading.views}
    assert kinds.keys() == {DrawingKind.PLAIN, DrawingKind.PICTORIAL}
    assert kinds[DrawingKind.PLAIN] == pytest.approx([300, 530, 450, 630])
    assert kinds[DrawingKind.PICTORIAL][0] < 450


def test_a_curve_of_chords_within_a_view_is_no_pictorial() -> None:
    """As programs write the curve in which two surfaces meet."""
    angles = [0.35 * math.pi + 0.01 * k for k in range(60)]
    places = [(400.0 + 90.0 * math.cos(a), 300.0 + 90.0 * math.sin(a)) for a in angles]
    curve = [
        VectorStroke(LineSegment(a, b), _WIDE) for a, b in itertools.pairwise([*places, places[0]])
    ]
    labels = _labels(_box(300, 300, 200, 100) + curve)
    assert labels == [Label.EDGE] * (4 + len(curve))


def test_a_hexagon_in_line_with_a_view_is_no_pictorial() -> None:
    """Its sides have the directions of an isometric picture."""
    (x, y), radius = (700.0, 250.0), 100.0
    angles = [math.pi / 6.0 + k * math.pi / 3.0 for k in range(7)]
    corners = [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]
    hexagon = [VectorStroke(LineSegment(a, b), _WIDE) for a, b in itertools.pairwise(corners)]
    half = radius * math.cos(math.pi / 6.0)
    neighbour = _box(x - half, 500, 2.0 * half, 100)
    reading, _ = reading_of([*hexagon, *neighbour])
    assert {view.kind for view in reading.views} == {DrawingKind.PLAIN}


def _pieces(y: float, *ends: tuple[float, float]) -> list[VectorStroke]:
    """Level pieces of a line, a stroke each."""
    return _lines(*((x0, y, x1, y) for x0, x1 in ends), width=_THIN)


def test_long_and_short_pieces_by_turns_are_a_centre_line_and_even_ones_a_hidden_line() -> None:
    outline = _box(300, 200, 300, 200)
    chain = _pieces(250, (290, 340), (350, 360), (370, 420), (430, 440), (450, 500), (510, 520))
    phantom = _pieces(300, (310, 350), (356, 362), (368, 374), (380, 420), (426, 432), (438, 444))
    ends = (302, 306), *((x, x + 20) for x in range(316, 580, 30)), (586, 592)
    dashes = _pieces(350, *ends)
    labels = _labels(outline + chain + phantom + dashes)
    parts = len(chain) + len(phantom)
    assert labels[4 : 4 + parts] == [Label.CENTRE] * parts
    assert labels[4 + parts :] == [Label.HIDDEN] * len(dashes)


def test_the_edges_of_a_comb_are_no_dashes() -> None:
    teeth = [(300.0 + 40.0 * k, 320.0 + 40.0 * k) for k in range(8)]
    corners = [(300.0, 300.0)]
    for x0, x1 in teeth:
        corners += [(x0, 200.0), (x1, 200.0), (x1, 260.0), (x1 + 20.0, 260.0)]
    corners += [(corners[-1][0], 300.0), (300.0, 300.0)]
    comb = _lines(*(a + b for a, b in itertools.pairwise(corners)))
    assert _labels(comb) == [Label.EDGE] * len(comb)


@pytest.mark.parametrize("ring", [[], _box(700, 500, 60, 40, _THIN)])
def test_a_thin_pen_that_encloses_something_of_its_own_draws_no_views(
    ring: list[VectorStroke],
) -> None:
    """Threads are thin; so is a hole in a picture beside the views."""
    part = _box(300, 300, 200, 100)
    threads = _lines((300, 320, 500, 320), (300, 380, 500, 380), width=_THIN)
    labels = _labels(part + threads + ring)
    assert labels[:6] == [Label.EDGE] * 4 + [Label.OTHER] * 2
