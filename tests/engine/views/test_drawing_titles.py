"""A title names the drawing nearest to it."""

import itertools

import pytest
from engine.recognition.labels_of_files import reading_of

from gaussiancad_core.files.vectors import VectorStroke, VectorText
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.views.drawn_groups import DrawingKind


def _box(x: float, y: float, w: float, h: float) -> list[VectorStroke]:
    corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)]
    return [VectorStroke(LineSegment(a, b), 4.0) for a, b in itertools.pairwise(corners)]


def _kinds(title: str) -> tuple[DrawingKind, DrawingKind, str, str]:
    """Of a large and a small drawing, with the title under the small one."""
    text = VectorText(title, (600.0, 420.0, 700.0, 440.0))
    reading, _ = reading_of([*_box(100, 300, 300, 200), *_box(600, 300, 100, 100)], text)
    large, small = reading.views
    return large.kind, small.kind, large.name, small.name


@pytest.mark.parametrize("title", ["DETAIL B - SCALE 5:1", "Einzelheit A", "VIEW C", "局部"])
def test_details(title: str) -> None:
    assert _kinds(title)[:2] == (DrawingKind.PLAIN, DrawingKind.DETAIL)


@pytest.mark.parametrize("title", ["FLAT PATTERN", "DOWN 90"])
def test_flat_patterns(title: str) -> None:
    assert _kinds(title)[:2] == (DrawingKind.PLAIN, DrawingKind.FLAT_PATTERN)


@pytest.mark.parametrize(
    ("title", "name"), [("TOP VIEW", "top"), ("左视", "left"), ("FRONT", "front")]
)
def test_names_of_views(title: str, name: str) -> None:
    assert _kinds(title)[2:] == ("", name)


def test_a_section_needs_hatching_and_a_sentence_names_nothing() -> None:
    assert _kinds("SECTION A-A")[1] is DrawingKind.PLAIN
    assert _kinds("break all edges at the top of the part")[2:] == ("", "")


def test_names_stand_above_all_views_or_below_all_of_them() -> None:
    """The name of the lower view is nearer to the upper one."""
    views = [*_box(100, 100, 300, 200), *_box(100, 420, 300, 100)]
    names = [
        VectorText("FRONT VIEW", (200.0, 60.0, 300.0, 80.0)),
        VectorText("TOP VIEW", (200.0, 320.0, 300.0, 340.0)),
    ]
    reading, _ = reading_of(views, *names)
    assert [view.name for view in reading.views] == ["front", "top"]
