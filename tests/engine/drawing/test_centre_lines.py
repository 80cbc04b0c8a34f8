import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind, Rhythm
from gaussiancad_core.drawing.annotation_pen import Direction, Pen
from gaussiancad_core.drawing.centre_lines import (
    draw_centre_lines,
    from_model,
    outermost,
    rounds,
    to_model,
)
from gaussiancad_core.drawing.drawn_sheet import part_lines
from gaussiancad_core.drawing.drawn_view import DrawnView, drawn_view
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.drawing.view_placing import place_views
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from sample_parts import sample

STYLE = PRESETS["dimensioned"]
PEN = Pen.of(STYLE)
FULL = 2.0 * np.pi


def views_of(
    name: str, roles: tuple[Role, ...] = (Role.FRONT, Role.TOP, Role.RIGHT)
) -> tuple[DrawnView, ...]:
    lines = part_lines(sample(name).build(), roles)
    places = place_views(lines.size, roles, Projection.THIRD, STYLE)
    return tuple(drawn_view(place, lines.views[place.role]) for place in places)


def _flat(*strokes: Segment | Arc) -> DrawnView:
    return DrawnView(Role.TOP, (0.0, 0.0, 200.0, 200.0), strokes, ())


def _circle(x: float, y: float, radius: float, sweep: float = FULL) -> Arc:
    return Arc((x, y), radius, 0.0, sweep, Linetype.VISIBLE)


def test_arcs_of_one_circle_count_together_and_fillets_not_at_all() -> None:
    halves = (
        Arc((50.0, 50.0), 20.0, 0.0, np.pi, Linetype.VISIBLE),
        Arc((50.0, 50.0), 20.0, np.pi, np.pi, Linetype.HIDDEN),
    )
    fillet = _circle(150.0, 150.0, 20.0, np.pi / 2.0)
    end_of_slot = _circle(100.0, 50.0, 10.0, np.pi)
    found = rounds(_flat(*halves, fillet, end_of_slot))
    assert [(circle.radius, circle.whole, circle.visible) for circle in found] == [
        (20.0, True, True),
        (10.0, False, True),
    ]
    hidden = Arc((50.0, 50.0), 20.0, 0.0, FULL, Linetype.HIDDEN)
    assert not rounds(_flat(hidden))[0].visible


def test_concentric_circles_share_the_lines_of_the_largest() -> None:
    circles = rounds(_flat(_circle(50, 50, 10), _circle(50, 50, 30), _circle(150, 50, 20)))
    assert sorted(circle.radius for circle in outermost(circles)) == [20.0, 30.0]


def test_large_circles_get_lines_and_small_ones_marks() -> None:
    marks = draw_centre_lines((_flat(_circle(60, 60, 40), _circle(160, 60, 6)),), PEN, 7)
    assert [(mark.kind, mark.rhythm, mark.group) for mark in marks] == [
        (AnnotationKind.CENTRE_LINE, Rhythm.LONG_SHORT, 7),
        (AnnotationKind.CENTRE_MARK, Rhythm.CONTINUOUS, 8),
    ]
    for mark, (x, y, radius) in zip(marks, ((60, 60, 40), (160, 60, 6)), strict=True):
        reach = radius + PEN.overshoot
        assert mark.box == pytest.approx((x - reach, y - reach, x + reach, y + reach))


def test_no_centre_line_runs_along_a_line_of_the_part() -> None:
    edge = Segment((60.0, 0.0), (60.0, 200.0), Linetype.HIDDEN)
    (mark,) = draw_centre_lines((_flat(_circle(60, 60, 40), edge),), PEN, 1)
    (line,) = mark.strokes
    assert line.start[1] == line.end[1] == 60.0


@pytest.mark.parametrize("role", list(Role))
@pytest.mark.parametrize("direction", list(Direction))
def test_places_on_the_model_s_axes_map_back(role: Role, direction: Direction) -> None:
    view = DrawnView(role, (100.0, 200.0, 400.0, 350.0), (), ())
    at = from_model(view, direction, 37.5)
    assert to_model(view, direction, at) == pytest.approx(37.5)
    low, high = direction.span(view.box)
    assert from_model(view, direction, 0.0) in (low, high)


def test_a_hole_has_its_axis_in_the_views_across_it() -> None:
    views = views_of("l-bracket")
    front, top, right = views
    marks = draw_centre_lines(views, PEN, 1)
    scale = (front.box[2] - front.box[0]) / 80.0
    strokes = [stroke for mark in marks for stroke in mark.strokes]

    def has_line(x0: float, y0: float, x1: float, y1: float) -> bool:
        wanted = np.array([x0, y0, x1, y1])
        return any(
            np.abs(np.array([*stroke.start, *stroke.end]) - wanted).max() < 0.01
            for stroke in strokes
        )

    reach = PEN.overshoot
    # The hole along z at x = 52 in the floor of 12 mm, seen from the front.
    x, y = front.box[0] + 52.0 * scale, front.box[3]
    assert has_line(x, y - 12.0 * scale - reach, x, y + reach)
    # The hole along x at z = 40 in the leg of 14 mm, seen from the front and from above.
    y = front.box[3] - 40.0 * scale
    assert has_line(front.box[0] - reach, y, front.box[0] + 14.0 * scale + reach, y)
    y = top.box[3] - 25.0 * scale
    assert has_line(top.box[0] - reach, y, top.box[0] + 14.0 * scale + reach, y)
    # And the same hole as a circle with two lines.
    x, y = right.box[0] + 25.0 * scale, right.box[3] - 40.0 * scale
    assert has_line(x - 7.0 * scale - reach, y, x + 7.0 * scale + reach, y)
    assert len(strokes) == 2 * 2 + 4


def test_a_shaft_has_one_axis_along_all_its_steps() -> None:
    views = views_of("stepped-shaft")
    marks = draw_centre_lines(views, PEN, 1)
    assert len(marks) == 3
    axes = [mark for mark in marks if len(mark.strokes) == 1]
    lengths = [mark.strokes[0].length for mark in axes]
    front = views[0].box
    assert lengths == pytest.approx([front[2] - front[0] + 2.0 * PEN.overshoot] * 2)


def test_parts_without_circles_have_none() -> None:
    assert draw_centre_lines(views_of("stepped-block"), PEN, 1) == []
