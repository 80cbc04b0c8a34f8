"""A solid is doubted where the ink runs beside one of its lines."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.views import Arc
from gaussiancad_core.recognition.sheet_views import sheet_views
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.run.ink_stage import compared_with_ink
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet, read_views, register_views
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_protocol.modes import Status

Read = tuple[ExactResult, RegisteredSheet, OpenedSheet]

_LENGTH = 80.0


@pytest.fixture(scope="module")
def read(
    sample_solid: Callable[[str], TopoDS_Shape], tmp_path_factory: pytest.TempPathFactory
) -> Read:
    """The exact solid of a sheet with holes, and the sheet."""
    path = tmp_path_factory.mktemp("ink") / "sheet.png"
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    sheet = draw_sheet(sample_solid("l-bracket"), roles, Projection.THIRD, parse_style("clean"), 0)
    write_image(sheet.image, path, 95, sheet.dpi)
    opened = OpenedSheet(read_sheet(path))
    seen = sheet_views(opened, projection=Projection.THIRD)
    options = ReadingOptions(projection=Projection.THIRD, lengths=((Axis.X, _LENGTH),))
    registered = register_views(read_views(seen.separated.part, seen.layout), options)
    return (
        find_exact(ProjectedReading(registered, Projection.THIRD), None).result,
        registered,
        opened,
    )


def _with_radii(result: ExactResult, mm: float) -> ExactResult:
    """The same with arcs that are larger by mm."""
    verification = result.verification
    lines = {
        role: tuple(
            replace(item, radius=item.radius + mm) if isinstance(item, Arc) else item
            for item in drawn
        )
        for role, drawn in verification.lines.items()
    }
    return replace(result, verification=replace(verification, lines=lines))


def test_a_solid_on_its_ink_stays_verified(read: Read) -> None:
    result, registered, opened = read
    assert result.status is Status.VERIFIED
    assert compared_with_ink(result, registered, opened) is result


@pytest.mark.parametrize("more", [-0.6, 0.6])
def test_an_arc_beside_its_ink_is_doubted(read: Read, more: float) -> None:
    result, registered, opened = read
    mm = more * registered.mm_per_pixel
    doubted = compared_with_ink(_with_radii(result, mm), registered, opened)
    assert doubted.status is Status.APPROXIMATE
    ((code, message),) = doubted.reasons
    assert code == "lines-apart"
    said = float(message.split(" mm off")[0].rsplit(" ", 1)[1])
    assert said == pytest.approx(abs(mm), rel=0.25)


def test_lines_of_a_file_are_not_asked(read: Read) -> None:
    result, registered, opened = read
    drawn = tuple(replace(view, source=StrokesSource.VECTOR) for view in registered.drawn)
    moved = _with_radii(result, 0.6 * registered.mm_per_pixel)
    assert compared_with_ink(moved, replace(registered, drawn=drawn), opened) is moved
