"""Strokes are wrong as a whole, and lines are lacking from corner to corner."""

from collections.abc import Callable
from dataclasses import replace

from gaussiancad_core.axes import Role
from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.fewest_strokes import fewest_strokes
from gaussiancad_core.reasoning.labelling import Effort, Search
from gaussiancad_core.reasoning.part import model_part
from gaussiancad_core.views import Linetype, Segment

Views = Callable[[str], DrawnViews]


def test_all_rules_hold_of_a_drawing_that_is_right(sample_views: Views) -> None:
    part = model_part(sample_views("l-bracket"), lost_lines=True)
    found = fewest_strokes(part, Effort())
    assert found.complete and not found.given_up
    assert Search(part.rules, Effort()).fulfilled().labels is not None


def test_only_a_stray_stroke_and_a_line_that_is_lacking_are_given_up(sample_views: Views) -> None:
    views = sample_views("l-bracket")
    front = views.strokes[Role.FRONT]
    lost = max((s for s in front if isinstance(s, Segment)), key=lambda s: s.length)
    middle = tuple(extent / 2.0 for extent in views.size)
    stray = Segment((3.1, 2.3), (middle[0], 2.3), Linetype.VISIBLE)
    strokes = {**views.strokes, Role.FRONT: (*(s for s in front if s is not lost), stray)}
    part = model_part(replace(views, strokes=strokes), lost_lines=True)
    found = fewest_strokes(part, Effort())
    assert found.complete
    scale = part.supports.scale
    for rule in found.given_up:
        assert rule.role is Role.FRONT
        for piece in rule.pieces:
            x, y = (coordinate / scale for coordinate in piece.point)
            on_stray = abs(y - 2.3) < 1e-6
            between = min(lost.start[0], lost.end[0]) - 1e-6, max(lost.start[0], lost.end[0]) + 1e-6
            on_lost = between[0] <= x <= between[1]
            assert on_stray if piece.linetype else on_lost
