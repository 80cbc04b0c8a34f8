"""Verdicts by reasons and by single changes, on drawings of solids with one thing wrong."""

from collections.abc import Callable
from dataclasses import replace

import cv2
import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.faceted_solids import faceted_shape
from gaussiancad_core.judging.sheet_ink import SheetInk, distance_to_ink
from gaussiancad_core.judging.sheet_judgement import SheetEvidence, SheetJudgement, judge_solid
from gaussiancad_core.judging.verdicts import Verdict
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.registration.view_registration import placement
from gaussiancad_protocol.codes import Code
from sample_parts.modelling import box, cut, cylinder, fuse

_SIZE = (60.0, 40.0, 30.0)
_BLOCK = box((0.0, 0.0, 0.0), _SIZE)
_STEP = box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0))


def _bore(x: float = 15.0, radius: float = 5.0) -> TopoDS_Shape:
    return cylinder(Axis.Z, (x, 12.0), radius, -1.0, 31.0)


_PART = cut(_BLOCK, _STEP, _bore())

_PX = 8.0
"""px of a mm."""

_BOXES = {Role.FRONT: (50, 450), Role.TOP: (50, 50), Role.RIGHT: (700, 450)}


def _evidence(views: DrawnViews) -> SheetEvidence:
    """The views with the ink of their lines on a sheet."""
    ink = np.zeros((800, 1200), np.uint8)
    places = {}
    for role, (x, y) in _BOXES.items():
        axes = role.frame.right_axis[0].value, role.frame.up_axis[0].value
        width, height = (_PX * _SIZE[axis] for axis in axes)
        places[role] = placement(role, (x, y, x + width, y + height), _SIZE)
        for stroke in views.strokes[role]:
            points = places[role].to_sheet(stroke.sample(0.2))
            cv2.polylines(ink, [np.rint(points).astype(np.int32)], False, 1, 3)
    return SheetEvidence(views, SheetInk(distance_to_ink(ink > 0), places), Projection.THIRD)


@pytest.fixture(scope="module")
def evidence(drawn: Callable[[TopoDS_Shape], DrawnViews]) -> SheetEvidence:
    return _evidence(drawn(_PART))


def _judged(part: TopoDS_Shape, evidence: SheetEvidence) -> SheetJudgement:
    return judge_solid(faceted_shape(part), [evidence])


def _codes(found: SheetJudgement) -> list[str]:
    return [reason.code for reason in found.judgement.reasons]


def test_the_part_itself_agrees_and_nothing_explains_the_sheet_better(
    evidence: SheetEvidence,
) -> None:
    found = _judged(_PART, evidence)
    assert found.judgement.verdict is Verdict.AGREES
    assert not found.differences
    assert not found.edits


def test_a_lacking_hole_is_to_be_drilled(evidence: SheetEvidence) -> None:
    found = _judged(cut(_BLOCK, _STEP), evidence)
    assert found.judgement.verdict is Verdict.DIFFERS
    assert _codes(found)[0] == Code.CIRCLE_MISSING
    assert found.edits[0].what == "drill"
    assert found.edits[0].end == pytest.approx((15.0, 12.0, 15.0), abs=0.1)


def test_a_hole_that_is_elsewhere_is_to_be_moved(evidence: SheetEvidence) -> None:
    found = _judged(cut(_BLOCK, _STEP, _bore(x=17.0)), evidence)
    assert found.judgement.verdict is Verdict.DIFFERS
    assert found.edits[0].what == "move"
    assert found.edits[0].start == pytest.approx((17.0, 12.0, 15.0), abs=0.1)
    assert found.edits[0].end == pytest.approx((15.0, 12.0, 15.0), abs=0.1)


def test_a_hole_that_is_not_drawn_is_to_be_filled(evidence: SheetEvidence) -> None:
    found = _judged(cut(_PART, cylinder(Axis.Z, (28.0, 28.0), 3.0, -1.0, 31.0)), evidence)
    assert Code.EDGE_NOT_DRAWN in _codes(found)
    assert found.edits[0].what == "fill"
    assert found.edits[0].start == pytest.approx((28.0, 28.0, 15.0), abs=0.1)


@pytest.mark.parametrize("level", [14.0, 22.0])
def test_a_step_at_another_level_is_to_be_shifted(evidence: SheetEvidence, level: float) -> None:
    step = box((40.0, -1.0, level), (61.0, 41.0, 31.0))
    found = _judged(cut(_BLOCK, step, _bore()), evidence)
    assert found.judgement.verdict is Verdict.DIFFERS
    assert found.edits[0].what == "shift"
    assert found.edits[0].start is not None
    assert found.edits[0].start[2] == pytest.approx(level)
    assert found.edits[0].end is not None
    assert found.edits[0].end[2] == pytest.approx(18.0)


def test_the_mirror_image_is_told(evidence: SheetEvidence) -> None:
    step = box((-1.0, -1.0, 18.0), (20.0, 41.0, 31.0))
    found = _judged(cut(_BLOCK, step, _bore(x=45.0)), evidence)
    assert found.judgement.verdict is Verdict.DIFFERS
    assert found.edits[0].what == "mirror"


def test_a_longer_part_differs_by_its_extent(evidence: SheetEvidence) -> None:
    longer = fuse(_PART, box((59.0, 0.0, 0.0), (61.5, 40.0, 18.0)))
    assert _codes(_judged(longer, evidence))[0] == Code.EXTENTS_DIFFER


def test_an_edge_on_ink_that_no_stroke_took_is_no_reason(
    drawn: Callable[[TopoDS_Shape], DrawnViews],
) -> None:
    whole = _evidence(drawn(_PART))
    # The reading lost the circle and what is hidden of it: the ink is still there.
    poor = replace(whole, views=drawn(cut(_BLOCK, _STEP)))
    found = _judged(_PART, poor)
    assert Code.EDGE_NOT_DRAWN not in _codes(found)
    assert "fill" not in {edit.what for edit in found.edits}


def test_what_hardly_fits_cannot_be_told(evidence: SheetEvidence) -> None:
    noise = {
        role: (*strokes, *evidence.views.strokes[Role.RIGHT][:3])
        for role, strokes in evidence.views.strokes.items()
    }
    muddled = replace(evidence, views=replace(evidence.views, strokes=noise))
    found = _judged(_PART, muddled)
    assert found.laid is not None
    assert found.laid.misfit.share > 0.1
    assert found.judgement.verdict is Verdict.CANNOT_TELL


@pytest.mark.parametrize(
    ("step", "text", "verdict"),
    [
        (HoleStep(10.0), "Ø10 THRU", Verdict.AGREES),
        (HoleStep(10.0, 8.0), "Ø10 DEEP 8", Verdict.DIFFERS),
        # Of the second no circle was read: it may be missing in the reading.
        (HoleStep(10.0), "2x Ø10 THRU", Verdict.CANNOT_TELL),
    ],
)
def test_a_part_does_not_agree_whose_holes_are_not_as_noted(
    evidence: SheetEvidence, step: HoleStep, text: str, verdict: Verdict
) -> None:
    hole = NotedHole(Role.TOP, (15.0, 12.0), (step,), text)
    found = _judged(_PART, replace(evidence, views=replace(evidence.views, holes=(hole,))))
    assert found.judgement.verdict is verdict
    assert _codes(found) == [Code.NOTE_NOT_KEPT] * (verdict is not Verdict.AGREES)


def test_what_no_view_tells_is_named(drawn: Callable[[TopoDS_Shape], DrawnViews]) -> None:
    def visible(part: TopoDS_Shape) -> DrawnViews:
        views = drawn(part)
        strokes = {
            role: tuple(s for s in lines if s.linetype is Linetype.VISIBLE)
            for role, lines in views.strokes.items()
        }
        return replace(views, strokes=strokes)

    blind = cut(_PART, cylinder(Axis.Z, (28.0, 28.0), 3.0, -1.0, 9.0))
    found = judge_solid(faceted_shape(blind), [_evidence(visible(_PART))])
    assert found.judgement.verdict is Verdict.AGREES
    # It opens downwards, where no view looks from.
    assert "hole of 6 mm" in {edit.feature for edit in found.silent}
    assert "hole of 10 mm" not in {edit.feature for edit in found.silent}
