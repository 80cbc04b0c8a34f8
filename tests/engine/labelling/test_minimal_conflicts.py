"""Lines that contradict each other: what is told is wrong, or lacks what is told."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.labelling.conflict_lines import Conflict, ConflictLine
from gaussiancad_core.labelling.minimal_conflicts import find_conflict
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment

Views = Callable[[str], DrawnViews]

_EFFORT = 4.0


def _conflict(views: DrawnViews, effort: float = _EFFORT) -> Conflict | None:
    return find_conflict(model_part(views), views, effort)


def _with(views: DrawnViews, role: Role, strokes: list[Segment]) -> DrawnViews:
    return replace(views, strokes={**views.strokes, role: tuple(strokes)})


def _without(views: DrawnViews, role: Role, index: int) -> DrawnViews:
    strokes = list(views.strokes[role])
    del strokes[index]
    return _with(views, role, strokes)


def _same_line(line: ConflictLine, stroke: Segment) -> bool:
    ends = {tuple(np.round(point, 3) + 0.0) for point in (line.points[0], line.points[-1])}
    return ends == {tuple(np.round(point, 3) + 0.0) for point in (stroke.start, stroke.end)}


@pytest.mark.parametrize("name", ["l-bracket", "stepped-block", "bored-plate", "wedge-block"])
def test_a_right_drawing_has_none(name: str, sample_views: Views) -> None:
    assert _conflict(sample_views(name)) is None


def _segments(views: DrawnViews) -> list[tuple[Role, int]]:
    return [
        (role, index)
        for role, strokes in views.strokes.items()
        for index, stroke in enumerate(strokes)
        if isinstance(stroke, Segment)
    ]


def test_each_missing_line_is_told_with_its_ends_and_its_linetype(sample_views: Views) -> None:
    views = sample_views("l-bracket")
    for role, index in _segments(views):
        lost = views.strokes[role][index]
        conflict = _conflict(_without(views, role, index))
        assert conflict is not None
        (suspect,) = conflict.suspects
        assert (suspect.role, suspect.drawn, suspect.fitting) == (role, None, lost.linetype)
        assert _same_line(suspect, lost), (role, lost, suspect.points)
        assert conflict.lines[0] is suspect


def test_each_line_of_the_wrong_linetype_is_told(sample_views: Views) -> None:
    views = sample_views("l-bracket")
    untold = []
    for role, index in _segments(views):
        strokes = list(views.strokes[role])
        right = strokes[index].linetype
        wrong = Linetype.HIDDEN if right is Linetype.VISIBLE else Linetype.VISIBLE
        strokes[index] = replace(strokes[index], linetype=wrong)
        conflict = _conflict(_with(views, role, strokes))
        if conflict is None:
            untold.append(strokes[index])
            continue
        assert conflict.minimal
        lines = [line for line in conflict.suspects if _same_line(line, strokes[index])]
        assert [(line.drawn, line.fitting) for line in lines] == [(wrong, right)]
    # A sheet of no thickness over the step would hide its edge.
    assert [(line.start, line.end) for line in untold] == [((14.0, 0.0), (14.0, 50.0))]


@pytest.mark.parametrize("linetype", list(Linetype))
@pytest.mark.parametrize("slanted", [False, True])
def test_a_spurious_line_through_everything_is_told(
    linetype: Linetype, slanted: bool, sample_views: Views
) -> None:
    views = sample_views("l-bracket")
    x, _, z = views.size
    line = Segment((0.0, 0.37 * z), (x, (0.61 if slanted else 0.37) * z), linetype)
    conflict = _conflict(_with(views, Role.FRONT, [*views.strokes[Role.FRONT], line]))
    assert conflict is not None and conflict.minimal
    ones = [one for one in conflict.lines if one.role is Role.FRONT and _same_line(one, line)]
    assert len(ones) == 1 and ones[0].drawn is linetype
    assert [one for one in conflict.suspects] == ones
    assert ones[0].fitting is not linetype


def test_no_part_of_a_minimal_conflict_contradicts_itself(sample_views: Views) -> None:
    # Nothing but the right view of another part contradicts: many lines do.
    views = sample_views("stepped-block")
    strokes = dict(views.strokes)
    strokes[Role.FRONT], strokes[Role.TOP] = strokes[Role.TOP], strokes[Role.FRONT]
    conflict = _conflict(replace(views, strokes=strokes))
    assert conflict is not None and len(conflict.lines) >= 1
    for line in conflict.lines:
        assert line.points.shape[1] == 2 and np.isfinite(line.points).all()
        assert line.suspect or line.fitting is line.drawn


def test_without_effort_nothing_is_told(sample_views: Views) -> None:
    views = sample_views("l-bracket")
    assert _conflict(_without(views, *_segments(views)[0]), effort=0.0) is None


def test_the_same_drawing_has_the_same_conflict(sample_views: Views) -> None:
    views = _without(sample_views("stepped-block"), Role.TOP, 3)
    first, second = _conflict(views), _conflict(views)
    assert first is not None and second is not None
    assert len(first.lines) == len(second.lines)
    for one, other in zip(first.lines, second.lines, strict=True):
        assert (one.role, one.drawn, one.suspect) == (other.role, other.drawn, other.suspect)
        assert np.array_equal(one.points, other.points)
