"""Writing that a file draws as plotters do, line by line."""

import itertools
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pytest
from engine.recognition.labels_of_files import reading_of

from gaussiancad_core.errors import UsageError
from gaussiancad_core.files.vectors import StrokeRole, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.file_views import file_views
from gaussiancad_core.recognition.labelled_file import FileStrokes, strokes_of_file
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import read_sheet
from gaussiancad_core.writing.sheet_scale import ScaleSource, find_scale, read_texts

Point = tuple[float, float]
Chain = list[Point]

_ROUND = [(0.2, 0.0), (0.45, 0.0), (0.65, 0.3), (0.65, 0.7), (0.45, 1.0), (0.2, 1.0)]
_ROUND += [(0.0, 0.7), (0.0, 0.3), (0.2, 0.0)]
_GLYPHS: dict[str, Chain] = {
    "0": _ROUND,
    "1": [(0.2, 0.8), (0.35, 1.0), (0.35, 0.0)],
    "2": [(0.0, 0.75), (0.2, 1.0), (0.45, 1.0), (0.65, 0.75), (0.0, 0.0), (0.65, 0.0)],
    "4": [(0.45, 0.0), (0.45, 1.0), (0.0, 0.3), (0.65, 0.3)],
    ".": [(0.3, 0.0), (0.38, 0.0), (0.38, 0.08), (0.3, 0.08), (0.3, 0.0)],
}
"""Chains in a letter's height, from its lower left corner; each letter has the same space."""

_PITCH = 1.1


def _plotted(text: str, place: Point, height: float) -> list[Chain]:
    """The letters of a text, from its lower left corner, y down."""
    x, y = place
    return [
        [(x + (k * _PITCH + dx) * height, y - dy * height) for dx, dy in _GLYPHS[letter]]
        for k, letter in enumerate(text)
    ]


def _segments(chains: Iterable[Chain]) -> list[tuple[Point, Point]]:
    return [ends for chain in chains for ends in itertools.pairwise(chain)]


def _words(chains: list[Chain], edges: list[Chain]) -> list[tuple[float, ...]]:
    """px around what is taken for writing."""
    strokes = [VectorStroke(LineSegment(*ends), 2.0) for ends in _segments([*chains, *edges])]
    reading, scale = reading_of(strokes)
    return [tuple(scale * value for value in box) for box in reading.words]


@pytest.mark.parametrize("text", ["40.00", "2.11", ".140"])
def test_letters_of_equal_space_are_one_line(text: str) -> None:
    letters = _plotted(text, (100.0, 100.0), 20.0)
    points = np.array([point for chain in letters for point in chain])
    (box,) = _words(letters, [])
    assert box == pytest.approx((*points.min(axis=0), *points.max(axis=0)))


def test_numbers_beside_each_other_stay_two() -> None:
    letters = _plotted("402", (100.0, 100.0), 20.0) + _plotted("220", (220.0, 100.0), 20.0)
    assert len(_words(letters, [])) == 2


def test_long_lines_and_what_stands_on_an_edge_are_no_letters() -> None:
    line: Chain = [(100.0, 50.0), (400.0, 50.0)]
    ticks: list[Chain] = [[(x, 200.0), (x, 190.0)] for x in (100.0, 110.0, 120.0, 130.0)]
    assert _words([line, *ticks], [[(50.0, 200.0), (400.0, 200.0)]]) == []


def test_a_pen_that_writes_but_two_letters_does_not_write() -> None:
    letters = _plotted("20", (100.0, 100.0), 20.0)
    assert _words(letters, []) == []
    assert len(_words(letters + _plotted("42", (220.0, 300.0), 20.0), [])) == 2


@pytest.mark.parametrize("role", [StrokeRole.HIDDEN, StrokeRole.CENTRE, StrokeRole.HATCH])
def test_what_the_file_names_as_no_edge_that_is_seen_writes_nothing(role: StrokeRole) -> None:
    ends = _segments(_plotted("402", (100.0, 100.0), 20.0))
    named = [VectorStroke(LineSegment(*pair), 2.0, (), role) for pair in ends]
    assert not reading_of(named)[0].words


_OUT, _FLAT = 4.0, 1.0
"""mm of arrowheads."""


def _box(place: Point, width: float, height: float) -> Chain:
    x, y = place
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]


def _measured(x0: float, x1: float, y: float, edge: float, text: str) -> list[Chain]:
    """A dimension below an edge."""
    lines: list[Chain] = [[(x, edge + 1.0), (x, y + 2.0)] for x in (x0, x1)]
    middle = (x0 + x1) / 2.0
    for end, way in ((x0, 1.0), (x1, -1.0)):
        foot = end + way * _OUT
        lines.append([(end, y), (foot, y - _FLAT), (foot, y + _FLAT), (end, y)])
        lines.append([(end, y), (middle - way * 12.0, y)])
    return lines + _plotted(text, (middle - 10.0, y + 2.0), 4.0)


def _sheet(path: Path, more: str = "") -> Path:
    """A block of 140 x 100 x 20 mm at 1:2, in third angle, on a sheet of 200 x 150 mm."""
    part = [_box((40.0, 80.0), 70.0, 10.0), _box((40.0, 15.0), 70.0, 50.0)]
    part.append(_box((130.0, 80.0), 50.0, 10.0))
    thin = _measured(40.0, 110.0, 105.0, 90.0, "140.0")
    thin += _measured(130.0, 180.0, 105.0, 90.0, "100.0")
    drawn = [
        '<polyline points="{}" fill="none" stroke="black" stroke-width="{}"/>'.format(
            " ".join(f"{x:.3f},{y:.3f}" for x, y in chain), width
        )
        for chains, width in ((part, 0.7), (thin, 0.25))
        for chain in chains
    ]
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="150mm" '
        'viewBox="0 0 200 150">' + "".join(drawn) + more + "</svg>",
        encoding="utf-8",
    )
    return path


def _strokes(sheet: OpenedSheet) -> FileStrokes:
    found = strokes_of_file(sheet)
    assert found is not None
    return found


def test_plotted_dimensions_give_the_scale(tmp_path: Path) -> None:
    image = read_sheet(_sheet(tmp_path / "plotted.svg"))
    sheet = OpenedSheet(image)
    assert image.vectors is not None and not image.vectors.texts
    views = file_views(_strokes(sheet), {}, Projection.THIRD, None)
    assert views is not None and len(views.layout.boxes) == 3
    found = find_scale(sheet, views.separated.marks, ())
    assert sorted(dimension.text for dimension in found.dimensions if dimension.used) == [
        "100.0",
        "140.0",
    ]
    assert found.source is ScaleSource.DIMENSION
    assert image.pixels_per_inch is not None
    assert found.mm_per_pixel == pytest.approx(2.0 * 25.4 / image.pixels_per_inch, rel=1e-3)


@pytest.mark.parametrize("numbers", [False, True])
def test_drawn_numbers_are_read_unless_the_file_has_as_many_as_texts(
    tmp_path: Path, numbers: bool
) -> None:
    words = ["STEEL", *(["7", "8", "9", "11", "12", "13"] if numbers else [])]
    notes = [
        f'<text x="{20 + 25 * index}" y="140" font-size="5">{word}</text>'
        for index, word in enumerate(words)
    ]
    image = read_sheet(_sheet(tmp_path / "noted.svg", "".join(notes)))
    sheet = OpenedSheet(image)
    assert image.vectors is not None and image.vectors.texts
    views = file_views(_strokes(sheet), {}, Projection.THIRD, None)
    assert views is not None
    read = {text.text for text in read_texts(sheet, views.separated.marks)}
    assert set(words) <= read
    assert ("100.0" in read) is not numbers


def test_a_box_without_lines_is_told_in_the_users_own_px(tmp_path: Path) -> None:
    image = read_sheet(_sheet(tmp_path / "plain.svg"))
    assert image.vectors is not None
    given = {Role.FRONT: (1.0, 1.0, 2.0, 2.0)}
    with pytest.raises(UsageError, match="in the box 1,1,2,2"):
        file_views(_strokes(OpenedSheet(image)), given, None, None)
