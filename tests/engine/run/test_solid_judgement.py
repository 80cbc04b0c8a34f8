"""The solid of a sheet against all of its ink, its notes and its lines."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.messages import boxes_of
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.hole_depths import HoleStep, NotedHole
from gaussiancad_core.model.views import Segment
from gaussiancad_core.recognition.sheet_views import sheet_views
from gaussiancad_core.run.exact_stage import ExactModel, find_exact
from gaussiancad_core.run.solid_judgement import counted_differences, judged_model
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import read_views, register_views
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.verify import Flaw
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import cut, cylinder

Read = tuple[ExactModel, OpenedSheet]

_LENGTH = 80.0


@pytest.fixture(scope="module")
def read(
    sample_solid: Callable[[str], TopoDS_Shape], tmp_path_factory: pytest.TempPathFactory
) -> Read:
    """The exact solid of a sheet, and the sheet."""
    path = tmp_path_factory.mktemp("judged") / "sheet.png"
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    sheet = draw_sheet(sample_solid("l-bracket"), roles, Projection.THIRD, parse_style("clean"), 0)
    write_image(sheet.image, path, 95, sheet.dpi)
    opened = OpenedSheet(read_sheet(path))
    seen = sheet_views(opened, projection=Projection.THIRD)
    options = ReadingOptions(projection=Projection.THIRD, lengths=((Axis.X, _LENGTH),))
    registered = register_views(read_views(seen.separated.part, seen.layout), options)
    return find_exact(ProjectedReading(registered, Projection.THIRD), None), opened


def _lacking(result: ExactResult) -> ExactResult:
    """The same, as if its lines and the sheet's disagreed."""
    return replace(
        result,
        status=Status.APPROXIMATE,
        verification=replace(result.checked, flaws=(Flaw(Role.FRONT, (0.0, 0.0), 9.0, False),)),
        reasons=((Code.LINES_UNEXPLAINED, "the solid shows a line that the view has not"),),
    )


def _without_longest(model: ExactModel) -> ExactModel:
    """The same read without the longest straight line of the front view."""
    registered = model.reading.registered
    views = registered.views.views
    front = next(view for view in views if view.role is Role.FRONT)
    longest = max(
        (stroke for stroke in front.strokes if isinstance(stroke, Segment)),
        key=lambda stroke: stroke.length,
    )
    rest = tuple(stroke for stroke in front.strokes if stroke is not longest)
    less = tuple(replace(view, strokes=rest) if view is front else view for view in views)
    sheet = replace(registered, views=replace(registered.views, views=less))
    return replace(model, reading=replace(model.reading, registered=sheet))


def test_a_verified_solid_on_its_sheet_stays_so(read: Read) -> None:
    model, sheet = read
    assert model.result.status is Status.VERIFIED
    assert judged_model(model, sheet).result is model.result


def test_a_note_that_is_not_kept_takes_the_certainty(read: Read) -> None:
    model, sheet = read
    hole = NotedHole(Role.TOP, (11.0, 11.0), (HoleStep(2.0),), "Ø2 THRU")
    noted = replace(model, reading=replace(model.reading, holes=(hole,)))
    found = judged_model(noted, sheet).result
    assert found.status is Status.APPROXIMATE
    assert [code for code, _ in found.reasons] == [Code.NOTE_NOT_KEPT]
    # Where other reasons were there before, it is the first.
    doubted = replace(noted, result=model.result.doubted((Code.ASSUMED, "something")))
    reasons = judged_model(doubted, sheet).result.reasons
    assert [code for code, _ in reasons] == [Code.NOTE_NOT_KEPT, Code.ASSUMED]


def test_an_edge_on_ink_that_was_not_read_is_none_that_the_sheet_lacks(read: Read) -> None:
    model, sheet = read
    poor = replace(_without_longest(model), result=_lacking(model.result))
    found = judged_model(poor, sheet)
    assert found.judged is not None
    assert found.judged.differences
    assert not counted_differences(found.judged)
    assert found.result.status is Status.APPROXIMATE
    ((code, message),) = found.result.reasons
    assert code == Code.LABELS_DOUBTFUL
    # A bore ends at that edge, too.
    low = min(y1 - y0 for _, y0, _, y1 in boxes_of(message))
    assert all(y1 - y0 == pytest.approx(low) for _, y0, _, y1 in boxes_of(message))


def test_an_edge_without_ink_stays_unexplained_and_has_its_place(read: Read) -> None:
    model, sheet = read
    drilled = cut(model.result.shape, cylinder(Axis.Y, (70.0, 5.0), 2.0, -1.0, 200.0))
    other = replace(model, result=_lacking(replace(model.result, shape=drilled)))
    ((code, message),) = judged_model(other, sheet).result.reasons
    assert code == Code.LINES_UNEXPLAINED
    assert message.args["case"] == "beyond"
    place = model.reading.registered.placements[Role.FRONT]
    ((x, y),) = place.to_sheet(np.array([[70.0, 5.0]])).tolist()
    assert any(x0 < x < x1 and y0 < y < y1 for x0, y0, x1, y1 in boxes_of(message))
