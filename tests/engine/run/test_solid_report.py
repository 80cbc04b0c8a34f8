"""What the report says of other solids, and of lines that contradict each other."""

import numpy as np
import pytest
from engine.run.stroke_sheets import chain, reading, rectangle

from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Segment
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.run.solid_report import with_solid_facts
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.sheet_stages import StrokesSource

_BOX = (100.0, 200.0, 500.0, 600.0)
_LEVEL = Turn(0.0, (300.0, 300.0))


def _sheet(projection: Projection, strokes: dict[Role, list[Segment]]) -> ProjectedReading:
    return reading(strokes, projection, StrokesSource.VECTOR, _BOX)


def _step(*top: Segment) -> ProjectedReading:
    profile = chain((0, 0), (30, 0), (30, 20), (12, 20), (12, 8), (0, 8), (0, 0))
    return _sheet(
        Projection.THIRD,
        {
            Role.FRONT: rectangle(40, 20) + chain((0, 8), (40, 8)),
            Role.TOP: [*rectangle(40, 30), *top],
            Role.RIGHT: profile,
        },
    )


def test_alternatives_are_told_with_the_projection_that_they_are_read_in() -> None:
    outlines = {Role.FRONT: rectangle(40, 20)}
    third = outlines | {
        Role.TOP: rectangle(40, 30),
        Role.RIGHT: chain((0, 0), (30, 0), (30, 20), (0, 0)),
    }
    first = outlines | {
        Role.BOTTOM: rectangle(40, 30, y=-30),
        Role.LEFT: chain((-30, 0), (0, 0), (0, 20), (-30, 0)),
    }
    model = find_exact(_sheet(Projection.THIRD, third), _sheet(Projection.FIRST, first))
    report = with_solid_facts(Report("", {}), model, _LEVEL)
    (other,) = report.as_json()["alternatives"]
    assert other["volume_mm3"] == pytest.approx(40 * 30 * 20 / 2)
    del other["volume_mm3"]
    expected = {"file": "alternatives/1.step", "projection": "first", "faces": 5, "agreement": 1.0}
    assert other == expected
    assert report.conflict == () and report.reasons == ()


def test_a_drawing_that_agrees_has_nothing_to_tell() -> None:
    report = with_solid_facts(
        Report("", {}), find_exact(_step(*chain((0, 12), (40, 12))), None), _LEVEL
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
