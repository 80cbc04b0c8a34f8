"""Strokes that others cross: dashed circles stay whole, and ink counts for one stroke."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import cv2
import numpy as np
import numpy.typing as npt
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.lines.strokes import as_plain_strokes
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.samples.classed import PartClass, classed_part
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.sheet_stages import read_views
from gaussiancad_core.sheet.tracing.ink_runs import Piece
from gaussiancad_core.sheet.tracing.shadows import without_shadows
from gaussiancad_core.sheet.views.role_score import Drawings, arrange
from gaussiancad_core.sheet.views.sheet_layout import view_clusters

_DASH, _GAP = 12.0, 6.0


def _framed(sketch):  # noqa: ANN001, ANN202
    return sketch(400, 300).lines((12, 12), (388, 12), (388, 288), (12, 288), (12, 12), width=2.5)


def _circles(strokes: Iterable[Stroke]) -> list[tuple[float, float, float]]:
    """(x, y, radius) of whole hidden circles."""
    return [
        (*s.centre, s.radius)
        for s in strokes
        if isinstance(s, Arc) and s.linetype is Linetype.HIDDEN and s.sweep > 6.28
    ]


def _view(part: TopoDS_Shape, role: Role) -> tuple[Sequence[Stroke], Sequence[Stroke]]:
    """The strokes of a part's view as read from a clean sheet, and as they were drawn."""
    sheet = draw_sheet(part, (Role.FRONT, Role.TOP, Role.RIGHT), Projection.THIRD, PRESETS["clean"])
    clean = clean_sheet(cv2.cvtColor(sheet.image, cv2.COLOR_RGB2GRAY))
    layout = arrange(Drawings(view_clusters(clean.ink, 0.0), clean.ink), {}, Projection.THIRD)
    found = next(view for view in read_views(clean, layout) if view.role is role)
    drawn = next(view for view in sheet.views if view.role is role)
    return found.strokes, as_plain_strokes(drawn.strokes)


def test_dashed_circles_that_many_lines_cross_are_whole() -> None:
    """Bores under a stepped plate: edges, pockets and slots run through their dashes."""
    top, drawn = _view(classed_part(PartClass.HOLES, 3, 3), Role.TOP)
    truth = np.array(_circles(drawn))
    assert len(truth) == 6
    away = np.abs(truth[:, None] - np.array(_circles(top))[None]).max(2)
    assert away.min(1) == pytest.approx(0.0, abs=0.5)


def test_a_hidden_arc_reaches_the_hidden_line_that_ends_it() -> None:
    """A flat under a shaft's chamfer: at either end two dashes meet at a flat angle."""
    top, drawn = _view(classed_part(PartClass.REVOLVED, 700, 0), Role.TOP)
    assert _ends(top) == pytest.approx(_ends(drawn), abs=0.7)


def _ends(strokes: Iterable[Stroke]) -> npt.NDArray[np.float64]:
    """(n, 6) linetype, length and the lowest and highest ends of strokes, in this order; px."""
    rows = []
    for stroke in strokes:
        first, last = stroke.sample(1.0)[[0, -1]]
        closed = isinstance(stroke, Arc) and stroke.sweep > 6.28
        ends = (
            (0.0,) * 4 if closed else (*min(first, last, key=tuple), *max(first, last, key=tuple))
        )
        rows.append((float(stroke.linetype is Linetype.HIDDEN), stroke.length, *ends))
    return np.array(sorted(rows))


def test_a_stroke_across_the_course_of_a_hidden_line_is_no_piece_of_it(sketch) -> None:  # noqa: ANN001
    drawing = _framed(sketch)
    drawing.broken((12, 100), (250, 100), (_DASH, _GAP), 1.5)
    drawing.line((250, 12), (250, 288), 2.5)
    # At eleven degrees, as a shallow roof beside a hidden edge.
    drawing.lines((250, 92), (330, 107.5), (330, 200), (250, 215), width=2.5)
    found = drawing.strokes()
    beyond = [
        s
        for s in found
        if isinstance(s, Segment)
        and min(s.start[0], s.end[0]) > 245
        and max(s.start[0], s.end[0]) < 335
        and abs(s.start[1] - s.end[1]) < 2.0
    ]
    assert beyond == []
    assert not any(isinstance(s, Arc) for s in found)


def _line(start: tuple[float, float], end: tuple[float, float]) -> tuple[Line, Piece]:
    way = np.subtract(end, start)
    length = float(np.hypot(*way))
    line = Line(start, (float(way[0]) / length, float(way[1]) / length))
    return line, Piece(0.0, length, Linetype.VISIBLE, 1.0)


def test_a_shadow_needs_a_longer_stroke_that_crosses_it() -> None:
    stroke, shadow = _line((0.0, 0.0), (80.0, 16.0)), _line((30.0, 8.0), (50.0, 8.0))
    assert without_shadows([stroke, shadow], 2.5) == [stroke]
    neighbour = _line((30.0, 12.0), (50.0, 12.0))
    assert without_shadows([stroke, neighbour], 2.5) == [stroke, neighbour]
    parallel = _line((30.0, 7.0), (50.0, 11.0))
    assert without_shadows([stroke, parallel], 2.5) == [stroke, parallel]
    short = _line((25.0, 5.0), (50.0, 10.0))
    assert without_shadows([short, shadow], 2.5) == [short, shadow]


def _hidden(strokes: Iterable[Stroke]) -> list[tuple[float, ...]]:
    """Ends of straight hidden strokes, rounded px."""
    ends = (
        sorted(tuple(round(v) for v in end) for end in (s.start, s.end))
        for s in strokes
        if isinstance(s, Segment) and s.linetype is Linetype.HIDDEN
    )
    return sorted((*one, *other) for one, other in ends)


def _with_rhythm(sketch):  # noqa: ANN001, ANN202
    """A framed sheet with a dashed line that tells the rhythm, and an edge at x = 200."""
    drawing = _framed(sketch).line((200, 12), (200, 288), 2.5)
    return drawing.broken((240, 60), (378, 60), (_DASH, _GAP), 1.5)


def test_a_hidden_leg_of_a_dash_is_told_by_its_corners(sketch) -> None:  # noqa: ANN001
    drawing = _with_rhythm(sketch)
    # A pocket 13 px deep: its short sides are a tick at the corner, a gap, and a tick.
    drawing.broken((187, 100), (187, 202), (_DASH, _GAP), 1.5)
    for y in (100, 202):
        drawing.line((187, y), (191, y), 1.5).line((196, y), (200, y), 1.5)
    found = _hidden(drawing.strokes())
    legs = [ends for ends in found if ends[0] < 200 and ends[1] == ends[3]]
    assert len(legs) == 2
    assert np.array(legs) == pytest.approx(
        np.array([[187, 100, 200, 100], [187, 202, 200, 202]]), abs=1.0
    )
    (side,) = (ends for ends in found if ends[0] < 200 and ends[0] == ends[2])
    assert side == pytest.approx((187, 100, 187, 202), abs=1.0)


def test_a_wide_gap_between_two_corners_parts_a_hidden_line(sketch) -> None:  # noqa: ANN001
    drawing = _with_rhythm(sketch)
    for y in (100, 113):
        drawing.broken((12, y), (150, y), (_DASH, _GAP), 1.5)
    drawing.line((150, 88), (150, 100), 1.5).line((150, 70), (150, 82), 1.5)
    drawing.line((150, 52), (150, 64), 1.5)
    drawing.line((150, 113), (150, 125), 1.5).line((150, 131), (150, 143), 1.5)
    drawing.line((150, 149), (150, 161), 1.5)
    upright = [ends for ends in _hidden(drawing.strokes()) if ends[0] == ends[2]]
    assert len(upright) == 2
    assert np.array(upright)[:, [1, 3]] == pytest.approx(np.array([[52, 100], [113, 161]]), abs=2.0)


def test_a_dash_of_a_hidden_circle_is_no_line() -> None:
    ring = Circle((50.0, 50.0), 22.0)
    whole = ring, Piece(0.0, ring.around, Linetype.HIDDEN, 1.0)
    line, piece = _line((45.5, 72.6), (54.5, 71.9))
    dash = line, replace(piece, linetype=Linetype.HIDDEN)
    assert without_shadows([whole, dash], 2.5, 11.0) == [whole]
    # A line of more than one dash may touch a circle.
    longer = line, replace(dash[1], start=-9.0, end=18.0)
    assert without_shadows([whole, longer], 2.5, 11.0) == [whole, longer]
    half = ring, replace(whole[1], end=0.5 * ring.around)
    assert without_shadows([half, dash], 2.5, 11.0) == [half, dash]


def test_where_a_circle_touches_a_line_there_is_no_piece_of_it() -> None:
    ring = Circle((50.0, 50.0), 19.0)
    whole = ring, Piece(0.0, ring.around, Linetype.VISIBLE, 1.0)
    touched = _line((41.0, 69.0), (59.0, 69.0))
    assert without_shadows([whole, touched], 2.5) == [whole]
    # A short straight side between two half circles begins where one of them ends.
    half = ring, Piece(0.0, 0.5 * np.pi * 19.0 + 4.0, Linetype.VISIBLE, 1.0)
    side = _line((50.0, 69.0), (38.0, 69.0))
    assert without_shadows([half, side], 2.5) == [half, side]
    ended = _line((41.0, 69.0), (59.0, 69.0))
    assert without_shadows([half, ended], 2.5) == [half, ended]


def test_the_round_ends_of_hidden_slots_are_arcs() -> None:
    """Their dashes go on in those of the straight sides; edges of a boss cross them."""
    top, drawn = _view(classed_part(PartClass.HOLES, 313, 5), Role.TOP)
    truth = np.array(
        [
            (*s.centre, s.radius)
            for s in drawn
            if isinstance(s, Arc) and s.linetype is Linetype.HIDDEN and s.sweep < 6.28
        ]
    )
    found = [
        (*s.centre, s.radius)
        for s in top
        if isinstance(s, Arc) and s.linetype is Linetype.HIDDEN and s.sweep > 3.0
    ]
    assert len(truth) == 3
    away = np.abs(truth[:, None] - np.array(found)[None]).max(2)
    assert away.min(1) == pytest.approx(0.0, abs=0.5)


def _hidden_arcs(strokes: Iterable[Stroke]) -> npt.NDArray[np.float64]:
    """(n, 4) x, y, radius and px along each, in order."""
    arcs = (s for s in strokes if isinstance(s, Arc) and s.linetype is Linetype.HIDDEN)
    found = [(*s.centre, s.radius, s.radius * s.sweep) for s in arcs]
    return np.array(sorted(found, key=lambda arc: np.rint(arc).tolist()))


@pytest.mark.parametrize(
    ("kind", "seed", "level", "role"),
    [(PartClass.FILLETS, 10, 3, Role.RIGHT), (PartClass.REVOLVED, 16, 2, Role.TOP)],
)
def test_hidden_arcs_are_as_long_as_they_were_drawn(
    kind: PartClass, seed: int, level: int, role: Role
) -> None:
    """Edges cross the dashes that lead to their ends, or would touch the rest of their circles."""
    found, drawn = (
        _hidden_arcs(strokes) for strokes in _view(classed_part(kind, seed, level), role)
    )
    assert found.shape == drawn.shape
    assert found == pytest.approx(drawn, abs=0.3)


def test_the_last_dash_of_a_line_may_lie_across_two_others(sketch) -> None:  # noqa: ANN001
    drawing = _framed(sketch)
    bottom = 12.0 + 5 * _DASH + 4 * _GAP
    drawing.broken((120, 12), (120, bottom), (_DASH, _GAP), 2.5)
    drawing.broken((12, bottom - 8.0), (388, bottom - 8.0), (_DASH, _GAP), 2.5)
    drawing.broken((120, bottom), (120 + 9 * _DASH + 8 * _GAP, bottom), (_DASH, _GAP), 2.5)
    (upright,) = [
        s
        for s in drawing.strokes()
        if isinstance(s, Segment)
        and s.linetype is Linetype.HIDDEN
        and abs(s.start[0] - s.end[0]) < 1.0
    ]
    assert max(upright.start[1], upright.end[1]) == pytest.approx(bottom + 0.5, abs=1.0)
