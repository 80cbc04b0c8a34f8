"""What a sheet shows beside its views, or does not draw, takes the word from a solid."""

from collections.abc import Iterable
from pathlib import Path

import pytest
import shapely

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.processes.events import Silence
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.run_report import Report
from gaussiancad_core.run.pipeline import reconstruct
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_protocol.modes import ResultKind, Status

Line = tuple[float, float, float, float]

_WIDTH, _DEPTH, _HEIGHT, _PX = 80.0, 40.0, 50.0, 5.0


class _Sheet:
    """An SVG sheet in third angle; lines in mm from a view's lower left corner."""

    def __init__(self) -> None:
        self._lines: list[str] = []

    def draw(self, origin: tuple[float, float], lines: Iterable[Line], *, more: str = "") -> None:
        for x0, y0, x1, y1 in lines:
            ends = [origin[0] + x0 * _PX, origin[1] - y0 * _PX]
            ends += [origin[0] + x1 * _PX, origin[1] - y1 * _PX]
            names = zip(("x1", "y1", "x2", "y2"), ends, strict=True)
            places = " ".join(f'{name}="{value:.3f}"' for name, value in names)
            self._lines.append(f'<line {places} stroke="black" stroke-width="2" {more}/>')

    def write(self, path: Path) -> None:
        path.write_text(
            '<svg xmlns="http://www.w3.org/2000/svg" width="1500px" height="800px" '
            'viewBox="0 0 1500 800">' + "".join(self._lines) + "</svg>",
            encoding="utf-8",
        )


def _outline(width: float, height: float) -> list[Line]:
    corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
    return [(*corners[k - 1], *corners[k]) for k in range(4)]


def _bore(hidden: bool) -> dict[str, list[Line]]:
    """A square pocket of 20 mm in the bottom, 15 mm deep, that only hidden lines show."""
    if not hidden:
        return {"front": [], "top": [], "right": []}
    front = [(30.0, 0.0, 30.0, 15.0), (30.0, 15.0, 50.0, 15.0), (50.0, 0.0, 50.0, 15.0)]
    top = [(30.0, 10.0, 50.0, 10.0), (50.0, 10.0, 50.0, 30.0)]
    top += [(50.0, 30.0, 30.0, 30.0), (30.0, 30.0, 30.0, 10.0)]
    right = [(10.0, 0.0, 10.0, 15.0), (10.0, 15.0, 30.0, 15.0), (30.0, 0.0, 30.0, 15.0)]
    return {"front": front, "top": top, "right": right}


def _section(scale: float) -> list[Line]:
    """The front view cut in the middle, with its hatching at 45 degrees, in a scale."""
    lines = [*_outline(_WIDTH, _HEIGHT), *_bore(True)["front"]]
    cut = shapely.box(0.0, 0.0, _WIDTH, _HEIGHT) - shapely.box(30.0, 0.0, 50.0, 15.0)
    for start in range(-45, 80, 5):
        line = shapely.LineString([(start, 0.0), (start + _HEIGHT, _HEIGHT)])
        for piece in shapely.get_parts(line.intersection(cut)):
            if piece.length > 0.1:
                (x0, y0), (x1, y1) = piece.coords
                lines.append((x0, y0, x1, y1))
    return [tuple(scale * item for item in line) for line in lines]


@pytest.fixture
def run(tmp_path: Path):  # noqa: ANN201
    """Draws such a block and reconstructs its solid."""

    def made(*, hidden: bool, section: float) -> Report:
        sheet = _Sheet()
        pocket = _bore(hidden)
        for name, origin, size in (
            ("front", (100.0, 650.0), (_WIDTH, _HEIGHT)),
            ("top", (100.0, 300.0), (_WIDTH, _DEPTH)),
            ("right", (600.0, 650.0), (_DEPTH, _HEIGHT)),
        ):
            sheet.draw(origin, _outline(*size))
            sheet.draw(origin, pocket[name], more='stroke-dasharray="12 6"')
        if section:
            sheet.draw((1000.0, 650.0), _section(section))
        sheet.write(tmp_path / "sheet.svg")
        reading = ReadingOptions(lengths=((Axis.X, _WIDTH),))
        job = Job(
            tmp_path / "sheet.svg", tmp_path / "out", reading=reading, result=ResultKind.SOLID
        )
        return reconstruct(job, Silence())

    return made


def test_a_section_beside_leaves_nothing_in_doubt(run) -> None:  # noqa: ANN001
    report = run(hidden=True, section=1.0)
    assert not report.unused
    assert [reason.code for reason in report.reasons] == []
    assert report.status is Status.VERIFIED
    (item,) = report.sections
    assert item.area_agreement > 0.95
    assert report.solid.volume_mm3 == pytest.approx(80 * 40 * 50 - 20 * 20 * 15)


def test_a_section_that_was_not_used_is_a_reason(run) -> None:  # noqa: ANN001
    report = run(hidden=True, section=0.5)
    assert report.status is Status.APPROXIMATE
    assert [reason.code for reason in report.reasons] == ["unused-view"]
    assert [item.kind for item in report.unused] == ["section"]
    assert report.solid.volume_mm3 == pytest.approx(80 * 40 * 50 - 20 * 20 * 15)


def test_without_hidden_lines_nothing_proves_that_there_is_nothing_inside(run) -> None:  # noqa: ANN001
    report = run(hidden=False, section=0.0)
    assert report.status is Status.APPROXIMATE
    assert [reason.code for reason in report.reasons] == ["sketched", "assumed"]
    assert [assumption.code for assumption in report.assumptions] == ["nothing-hidden"]
    assert {view.hidden_lines for view in report.views.values()} == {"none"}


def test_with_them_and_nothing_else_on_the_sheet_it_is_verified(run) -> None:  # noqa: ANN001
    report = run(hidden=True, section=0.0)
    assert (report.status, report.reasons, report.unused) == (Status.VERIFIED, (), ())
    assert {view.hidden_lines for view in report.views.values()} == {"drawn"}
    assert report.measures is not None and report.measures.uncertainty_mm <= 0.01
