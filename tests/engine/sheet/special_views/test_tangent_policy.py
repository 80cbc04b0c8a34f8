"""What a sheet does with tangent edges, by the places at which a view would show them."""

import numpy as np
import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.tangent_edges import TangentEdges, without_tangent_edges
from gaussiancad_core.sheet.special_views.tangent_policy import SheetTangents, inferred_policy

VISIBLE = Linetype.VISIBLE
DRAWN, THIN = TangentPolicy.DRAWN, TangentPolicy.THIN
LEFT_OUT, UNKNOWN = TangentPolicy.LEFT_OUT, TangentPolicy.UNKNOWN


def _line(x0: float, y0: float, x1: float, y1: float) -> Segment:
    return Segment((x0, y0), (x1, y1), VISIBLE)


def _rounded(x0: float, y0: float, x1: float, y1: float, radius: float) -> list[Stroke]:
    """A rectangle, px with y down, with its two lower corners round."""
    return [
        _line(x0, y0, x1, y0),
        _line(x1, y0, x1, y1 - radius),
        Arc((x1 - radius, y1 - radius), radius, 0.0, np.pi / 2.0, VISIBLE),
        _line(x1 - radius, y1, x0 + radius, y1),
        Arc((x0 + radius, y1 - radius), radius, np.pi / 2.0, np.pi / 2.0, VISIBLE),
        _line(x0, y1 - radius, x0, y0),
    ]


def _box(x0: float, y0: float, x1: float, y1: float) -> list[Stroke]:
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
    pairs = zip(corners, corners[1:] + corners[:1], strict=True)
    return [Segment(one, other, VISIBLE) for one, other in pairs]


SEAMS = _line(80.0, 300.0, 80.0, 340.0), _line(220.0, 300.0, 220.0, 340.0)
"""Lines of the front view where the round corners of the plan begin."""


def _views(*seams: Stroke, plan: list[Stroke] | None = None) -> list[ReadView]:
    """A plate from the front, with these lines, above it its plan, whose front corners are
    round."""
    front = (*_box(50.0, 300.0, 250.0, 340.0), *seams)
    top = tuple(plan or _rounded(50.0, 100.0, 250.0, 200.0, 30.0))
    source = StrokesSource.VECTOR
    return [
        ReadView(Role.FRONT, (50.0, 300.0, 250.0, 340.0), front, None, source),
        ReadView(Role.TOP, (50.0, 100.0, 250.0, 200.0), top, None, source),
    ]


def _counts(found: TangentEdges) -> tuple[int, int, int]:
    return found.sheet.drawn, found.sheet.thin, found.sheet.left_out


def test_lines_at_all_places_are_drawn_ones_and_taken_off() -> None:
    found = without_tangent_edges(_views(*SEAMS))
    assert found.sheet == SheetTangents(DRAWN, "inferred", drawn=2)
    assert found.views[0].tangents == SEAMS and len(found.views[0].strokes) == 4


def test_no_line_at_any_place_leaves_them_out() -> None:
    found = without_tangent_edges(_views())
    assert found.sheet == SheetTangents(LEFT_OUT, "inferred", left_out=2)
    assert found.views[0].tangents == ()


def test_lines_of_a_thinner_pen_are_thin_ones() -> None:
    found = without_tangent_edges(_views(), {Role.FRONT: SEAMS})
    assert (found.sheet.policy, _counts(found)) == (THIN, (0, 2, 0))
    assert found.views[0].tangents == SEAMS and len(found.views[0].strokes) == 4
    in_view = without_tangent_edges(_views(*SEAMS), is_thin=lambda _, line: line in SEAMS)
    assert (in_view.sheet, in_view.views[0].tangents) == (found.sheet, SEAMS)


def test_a_thin_line_elsewhere_is_no_tangent_edge() -> None:
    other = _line(150.0, 300.0, 150.0, 340.0)
    found = without_tangent_edges(_views(), {Role.FRONT: [other]})
    assert found.sheet.policy is LEFT_OUT and found.views[0].tangents == ()


def test_half_of_the_places_tell_nothing_and_keep_their_lines() -> None:
    found = without_tangent_edges(_views(SEAMS[0]))
    assert (found.sheet.policy, found.sheet.source) == (UNKNOWN, "default")
    assert SEAMS[0] in found.views[0].strokes


def test_a_sheet_without_round_corners_tells_nothing() -> None:
    found = without_tangent_edges(_views(*SEAMS, plan=_box(50.0, 100.0, 250.0, 200.0)))
    assert found.sheet == SheetTangents() and found.views[0].tangents == ()


def test_corners_at_the_rear_ask_for_no_visible_line() -> None:
    # The plan mirrored: from the front its round corners lie behind the plate.
    plan = _rounded(50.0, 100.0, 250.0, 200.0, 30.0)
    mirrored = [
        Segment((s.start[0], 300.0 - s.start[1]), (s.end[0], 300.0 - s.end[1]), VISIBLE)
        if isinstance(s, Segment)
        else Arc(
            (s.centre[0], 300.0 - s.centre[1]), s.radius, -s.start_angle - s.sweep, s.sweep, VISIBLE
        )
        for s in plan
    ]
    assert without_tangent_edges(_views(plan=mirrored)).sheet == SheetTangents()
    hidden = [Segment(seam.start, seam.end, Linetype.HIDDEN) for seam in SEAMS]
    found = without_tangent_edges(_views(*hidden, plan=mirrored))
    assert found.sheet.policy is DRAWN and found.views[0].tangents == tuple(hidden)


def test_what_a_person_says_goes_before_what_the_places_tell() -> None:
    given = without_tangent_edges(_views(SEAMS[0]), given=DRAWN)
    assert (given.sheet.policy, given.sheet.source) == (DRAWN, "given")
    assert given.views[0].tangents == SEAMS[:1]
    left_out = without_tangent_edges(_views(*SEAMS), given=LEFT_OUT)
    assert left_out.sheet.policy is LEFT_OUT and left_out.views[0].tangents == ()


def test_the_rim_of_a_round_foot_is_none_and_its_shaft_is_one() -> None:
    # A shaft of 40 px on a plate with a rounding of 20: from above two circles.
    front = [
        *(_line(50.0, 340.0, 250.0, 340.0), _line(50.0, 320.0, 50.0, 340.0)),
        *(_line(250.0, 320.0, 250.0, 340.0), _line(50.0, 320.0, 110.0, 320.0)),
        *(_line(190.0, 320.0, 250.0, 320.0), _line(130.0, 300.0, 130.0, 240.0)),
        *(_line(170.0, 300.0, 170.0, 240.0), _line(130.0, 240.0, 170.0, 240.0)),
        Arc((110.0, 300.0), 20.0, 0.0, np.pi / 2.0, VISIBLE),
        Arc((190.0, 300.0), 20.0, np.pi / 2.0, np.pi / 2.0, VISIBLE),
    ]
    shaft, rim = (Arc((150.0, 150.0), r, 0.0, 2.0 * np.pi, VISIBLE) for r in (20.0, 40.0))
    top = [*_box(50.0, 100.0, 250.0, 200.0), shaft, rim]
    source = StrokesSource.VECTOR
    views = [
        ReadView(Role.FRONT, (50.0, 240.0, 250.0, 340.0), tuple(front), None, source),
        ReadView(Role.TOP, (50.0, 100.0, 250.0, 200.0), tuple(top), None, source),
    ]
    found = without_tangent_edges(views, given=DRAWN)
    assert found.views[1].tangents == (rim,) and shaft in found.views[1].strokes


@pytest.mark.parametrize(
    ("counts", "policy"),
    [
        ((0, 0, 0), UNKNOWN),
        ((3, 0, 0), DRAWN),
        ((1, 2, 0), THIN),
        ((1, 1, 0), DRAWN),
        ((2, 0, 1), DRAWN),
        ((3, 0, 2), UNKNOWN),
        ((2, 0, 3), UNKNOWN),
        ((1, 0, 2), LEFT_OUT),
    ],
)
def test_most_places_tell_the_policy(counts: tuple[int, int, int], policy: TangentPolicy) -> None:
    found = inferred_policy(*counts)
    assert (found.policy, found.drawn, found.thin, found.left_out) == (policy, *counts)
    assert found.source == ("default" if policy is UNKNOWN else "inferred")
