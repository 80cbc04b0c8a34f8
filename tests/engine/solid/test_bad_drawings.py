"""Drawings that are wrong: each ends with the right status and the place of the trouble.

Lines that miss or are too many are told by name; views that are another part's, mirrored or swapped
are never verified, and lines of theirs are told that contradict each other.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.hypotheses.open_outlines import find_gaps
from gaussiancad_core.labelling.cell_labelling import Effort
from gaussiancad_core.labelling.conflict_lines import ConflictLine
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.solid.contradiction import conflict_reason
from gaussiancad_core.solid.exact import ExactResult, exact_solid
from gaussiancad_core.solid.limits import Limits
from gaussiancad_core.solid.reasons import ASSUMED
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.search_trace import ModelKind
from gaussiancad_protocol.modes import Status

Views = Callable[[str], DrawnViews]

_LIMITS = Limits(Effort(hard=2.0), alternatives=2, work=1e6)
"""Ended by deterministic efforts only: on a busy machine, conflicts are looked for too."""

_NAMES = ("l-bracket", "stepped-block", "wedge-block")


def _solved(views: DrawnViews) -> ExactResult:
    """The result, consistent in itself: never verified, and with a reason."""
    result = exact_solid(views, _LIMITS)
    assert result.status is not Status.VERIFIED
    assert result.reasons
    assert (result.shape is None) == (result.status is Status.FAILED)
    return result


def _told(result: ExactResult) -> bool:
    """Whether lines are told that contradict each other, or that are not the solid's."""
    flawed = result.verification is not None and bool(result.verification.flaws)
    return flawed or bool(result.conflict and result.conflict.lines)


def _changed(views: DrawnViews, role: Role, strokes: list) -> DrawnViews:
    return replace(views, strokes={**views.strokes, role: tuple(strokes)})


def _stroke_of(line: ConflictLine, views: DrawnViews, index: int) -> bool:
    stroke = views.strokes[line.role][index]
    ends = np.array([line.points[0], line.points[-1]])
    item = np.array([stroke.start, stroke.end])
    return bool(np.allclose(ends, item, atol=1e-3) or np.allclose(ends, item[::-1], atol=1e-3))


def _within(line: ConflictLine, stroke: Segment) -> bool:
    start, end = np.array(stroke.start), np.array(stroke.end)
    along = (end - start) / stroke.length
    away = line.points - start
    sideways = away @ np.array([-along[1], along[0]])
    inside = (away @ along > -1e-3) & (away @ along < stroke.length + 1e-3)
    return bool(inside.all() and np.abs(sideways).max() < 1e-3)


@pytest.mark.parametrize("name", _NAMES)
def test_a_missing_line_is_named(name: str, sample_views: Views) -> None:
    views = sample_views(name)
    places = [
        (role, index)
        for role, strokes in views.strokes.items()
        for index, stroke in enumerate(strokes)
        if isinstance(stroke, Segment)
    ]
    # Some from each view.
    for role, index in places[::4]:
        strokes = list(views.strokes[role])
        lost = strokes.pop(index)
        result = _solved(_changed(views, role, strokes))
        if ModelKind.UNDRAWN_LINES in [item.model for item in result.trace if item.taken]:
            # Hidden lines that were left out may explain it as well, which is said.
            assert ASSUMED in [code for code, _ in result.reasons]
            continue
        assert result.conflict is not None
        (suspect,) = result.conflict.suspects
        assert (suspect.role, suspect.drawn, suspect.fitting) == (role, None, lost.linetype)
        # Another solid may lack only some of it.
        assert _within(suspect, lost)
        code, sentence = conflict_reason(result.conflict)
        assert code == "lines-contradict"
        assert f"a {lost.linetype.value} line is missing in the {role.value} view" in sentence


@pytest.mark.parametrize("name", _NAMES)
@pytest.mark.parametrize("role", [Role.FRONT, Role.TOP, Role.RIGHT])
def test_where_an_outline_is_open_the_part_is_found_and_never_verified(
    name: str,
    role: Role,
    sample_views: Views,
    sample_solid: Callable[[str], TopoDS_Shape],
) -> None:
    views = sample_views(name)
    strokes = list(views.strokes[role])
    number = next(
        number
        for number in range(len(strokes))
        if find_gaps(_changed(views, role, [*strokes[:number], *strokes[number + 1 :]]))
    )
    lost = strokes.pop(number)
    result = _solved(_changed(views, role, strokes))
    assert result.status is Status.APPROXIMATE
    assert result.shape is not None and result.verification is not None
    assert same_solid(result.shape, sample_solid(name))
    assert [code for code, _ in result.reasons] == ["lines-unexplained"]
    assert not any(flaw.missing for flaw in result.verification.flaws)
    assert sum(flaw.length for flaw in result.verification.flaws) <= lost.length * 1.01
    assert result.conflict is not None and len(result.conflict.suspects) == 1


@pytest.mark.parametrize("name", _NAMES)
@pytest.mark.parametrize("share", [0.37, 0.61])
def test_a_spurious_line_through_everything_is_named(
    name: str, share: float, sample_views: Views
) -> None:
    views = sample_views(name)
    x, _, z = views.size
    line = Segment((0.0, 0.37 * z), (x, share * z), Linetype.VISIBLE)
    spoilt = _changed(views, Role.FRONT, [*views.strokes[Role.FRONT], line])
    result = _solved(spoilt)
    assert result.conflict is not None
    index = len(spoilt.strokes[Role.FRONT]) - 1
    marked = [one for one in result.conflict.lines if one.role is Role.FRONT]
    assert any(_stroke_of(one, spoilt, index) for one in marked)
    _, sentence = conflict_reason(result.conflict)
    assert "the visible line in the front view" in sentence and "should not be there" in sentence


def _mirrored(views: DrawnViews, role: Role) -> DrawnViews:
    strokes = views.strokes[role]
    ends = np.array([(s.start, s.end) for s in strokes])
    turn = ends[..., 0].min() + ends[..., 0].max()
    return _changed(
        views,
        role,
        [
            replace(s, start=(turn - s.start[0], s.start[1]), end=(turn - s.end[0], s.end[1]))
            for s in strokes
        ],
    )


@pytest.mark.parametrize("name", ["l-bracket", "stepped-block"])
def test_a_mirrored_view_is_told(name: str, sample_views: Views) -> None:
    views = sample_views(name)
    assert _told(_solved(_mirrored(views, Role.FRONT)))


@pytest.mark.parametrize("pair", [(Role.FRONT, Role.TOP), (Role.TOP, Role.RIGHT)])
def test_swapped_views_are_told(pair: tuple[Role, Role], sample_views: Views) -> None:
    views = sample_views("stepped-block")
    one, other = pair
    strokes = {**views.strokes, one: views.strokes[other], other: views.strokes[one]}
    assert _told(_solved(replace(views, strokes=strokes)))


def test_the_view_of_another_part_is_told(
    sample_solid: Callable[[str], TopoDS_Shape], drawn: Callable[..., DrawnViews]
) -> None:
    views, other = drawn(sample_solid("l-bracket")), drawn(sample_solid("wedge-block"))
    factors = [
        views.size[axis.value] / other.size[axis.value]
        for axis in (Role.RIGHT.frame.right_axis[0], Role.RIGHT.frame.up_axis[0])
    ]
    stretched = [
        replace(
            s,
            start=(s.start[0] * factors[0], s.start[1] * factors[1]),
            end=(s.end[0] * factors[0], s.end[1] * factors[1]),
        )
        for s in other.strokes[Role.RIGHT]
        if isinstance(s, Segment)
    ]
    assert _told(_solved(_changed(views, Role.RIGHT, stretched)))


def test_a_thousand_strokes_come_to_an_end() -> None:
    rng = np.random.default_rng(5)
    corners = ((0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (0.0, 100.0))
    strokes = {}
    for role in (Role.FRONT, Role.TOP, Role.RIGHT):
        lines = [Segment(corners[k - 1], corners[k], Linetype.VISIBLE) for k in range(4)]
        for k in range(334):
            a, b, length = rng.uniform(0.0, 100.0), rng.uniform(0.0, 100.0), rng.uniform(2.0, 30.0)
            end = (min(100.0, a + length), b) if k % 2 else (a, min(100.0, b + length))
            lines.append(Segment((a, b), end, Linetype.HIDDEN if k % 3 else Linetype.VISIBLE))
        strokes[role] = tuple(lines)
    result = _solved(exact_views(strokes, (100.0, 100.0, 100.0)))
    assert result.status is Status.FAILED
    assert [code for code, _ in result.reasons] == ["part-too-complex"]


def test_a_right_drawing_has_no_conflict(sample_views: Views) -> None:
    result = exact_solid(sample_views("l-bracket"), _LIMITS)
    assert (result.status, result.conflict) == (Status.VERIFIED, None)
