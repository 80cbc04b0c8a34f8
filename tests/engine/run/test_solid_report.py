"""What the report says of other solids, and of lines that contradict each other."""

import itertools
from types import SimpleNamespace

import numpy as np
import pytest

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Linetype, Segment, View, ViewSet
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.run.solid_report import with_solid_facts
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.registration.view_registration import AxisExtents
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, StrokesSource

_SIZE = (40.0, 30.0, 20.0)
_BOX = (100.0, 200.0, 500.0, 600.0)
_LEVEL = Turn(0.0, (300.0, 300.0))


def _chain(*points: tuple[float, float]) -> list[Segment]:
    return [Segment(a, b, Linetype.VISIBLE) for a, b in itertools.pairwise(points)]


def _rectangle(x: float, y: float, width: float, height: float) -> list[Segment]:
    return _chain((x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y))


def _reading(projection: Projection, strokes: dict[Role, list[Segment]]) -> ProjectedReading:
    mask, colour = np.zeros((2, 2), bool), np.zeros((2, 2, 3), np.uint8)
    views = tuple(
        View(role, _BOX, tuple(stroke), mask, colour, (0.0, 0.0), 1.0)
        for role, stroke in strokes.items()
    )
    drawn = tuple(SimpleNamespace(source=StrokesSource.VECTOR, step=0.0) for _ in views)
    registered = RegisteredSheet(ViewSet(views, _SIZE), {}, drawn, 0.02, AxisExtents({}, {}), 0)
    return ProjectedReading(registered, projection)


def _step(*top: Segment) -> ProjectedReading:
    profile = _chain((0, 0), (30, 0), (30, 20), (12, 20), (12, 8), (0, 8), (0, 0))
    return _reading(
        Projection.THIRD,
        {
            Role.FRONT: _rectangle(0, 0, 40, 20) + _chain((0, 8), (40, 8)),
            Role.TOP: [*_rectangle(0, 0, 40, 30), *top],
            Role.RIGHT: profile,
        },
    )


def test_alternatives_are_told_with_the_projection_that_they_are_read_in() -> None:
    outlines = {Role.FRONT: _rectangle(0, 0, 40, 20)}
    third = outlines | {
        Role.TOP: _rectangle(0, 0, 40, 30),
        Role.RIGHT: _chain((0, 0), (30, 0), (30, 20), (0, 0)),
    }
    first = outlines | {
        Role.BOTTOM: _rectangle(0, -30, 40, 30),
        Role.LEFT: _chain((-30, 0), (0, 0), (0, 20), (-30, 0)),
    }
    model = find_exact(_reading(Projection.THIRD, third), _reading(Projection.FIRST, first))
    report = with_solid_facts(Report("", {}), model, _LEVEL)
    (other,) = report.as_json()["alternatives"]
    assert other["volume_mm3"] == pytest.approx(40 * 30 * 20 / 2)
    del other["volume_mm3"]
    expected = {"file": "alternatives/1.step", "projection": "first", "faces": 5, "agreement": 1.0}
    assert other == expected
    assert report.conflict == () and report.reasons == ()


def test_a_drawing_that_agrees_has_nothing_to_tell() -> None:
    report = with_solid_facts(
        Report("", {}), find_exact(_step(*_chain((0, 12), (40, 12))), None), _LEVEL
    )
    assert (report.alternatives, report.conflict, report.reasons) == ((), (), ())


@pytest.mark.parametrize("angle", [0.0, 0.05])
def test_a_missing_line_is_told_with_its_box_on_the_sheet_as_stored(angle: float) -> None:
    turn = Turn(angle, (300.0, 300.0))
    report = with_solid_facts(Report("", {}), find_exact(_step(), None), turn)
    assert [reason.code for reason in report.reasons] == ["lines-contradict"]
    assert "a visible line is missing in the top view" in report.reasons[0].message
    missing = report.as_json()["conflict"][0]
    assert (missing["view"], missing["drawn"], missing["suspect"]) == ("top", None, True)
    assert missing["fitting"] == "visible"
    # 12 of 30 mm above the lower border of a box of 400 px, from side to side.
    ends = turn.to_stored(np.array([[100.0, 440.0], [500.0, 440.0]]))
    expected = [*ends.min(axis=0), *ends.max(axis=0)]
    assert missing["box"] == pytest.approx(expected, abs=0.1)
    assert all(line["suspect"] is False for line in report.as_json()["conflict"][1:])
