from collections import defaultdict
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.drawn_dimensions import value_text
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import PRESETS, TextPlace
from gaussiancad_core.model.axes import Projection, Role
from sample_parts import SAMPLES, sample
from sample_parts.random_parts import random_part

STYLE = PRESETS["dimensioned"]
THIRD = (Role.FRONT, Role.TOP, Role.RIGHT)
NAMES = ("u-bracket", "stepped-block", "pulley", "wedge-block", "counterbored-block", "boss-plate")


ABOVE, INLINE = TextPlace


@cache
def _lines(name: str) -> PartLines:
    known = {part.name for part in SAMPLES}
    shape = sample(name).build() if name in known else random_part(int(name))
    return part_lines(shape, THIRD)


@cache
def dimensioned(name: str, place: TextPlace = ABOVE) -> Sheet:
    return compose_sheet(_lines(name), Projection.THIRD, replace(STYLE, text_place=place))


def notes(sheet: Sheet) -> list[dict[AnnotationKind, list[Annotation]]]:
    """The dimensions of a sheet, each with its lines and text by kind."""
    groups: dict[int, dict[AnnotationKind, list[Annotation]]] = defaultdict(
        lambda: defaultdict(list)
    )
    for mark in sheet.annotations:
        groups[mark.group][mark.kind].append(mark)
    return [group for group in groups.values() if AnnotationKind.DIMENSION in group]


@pytest.mark.parametrize("place", list(TextPlace))
@pytest.mark.parametrize("name", [*NAMES, "1", "7"])
def test_every_dimension_says_how_far_its_extension_lines_are_apart(
    name: str, place: TextPlace
) -> None:
    sheet = dimensioned(name, place)
    found = notes(sheet)
    assert len(found) >= 3
    for note in found:
        (line,), (text,) = note[AnnotationKind.DIMENSION], note[AnnotationKind.TEXT]
        first, second = (mark.strokes[0] for mark in note[AnnotationKind.EXTENSION])
        way = np.subtract(first.end, first.start)
        between = np.subtract(second.start, first.start)
        apart = abs(way[0] * between[1] - way[1] * between[0]) / np.hypot(*way)
        assert float(text.label.text) == line.value_mm
        assert line.value_mm == pytest.approx(apart * sheet.mm_per_pixel, abs=0.00501)
        # The arrowheads touch the extension lines.
        tips = [np.array(arrow[0]) for arrow in line.arrows]
        assert np.hypot(*(tips[0] - tips[1])) == pytest.approx(apart)


@pytest.mark.parametrize("place", list(TextPlace))
@pytest.mark.parametrize("name", [*NAMES, "1", "7"])
def test_dimensions_stay_out_of_the_views_and_apart(name: str, place: TextPlace) -> None:
    sheet = dimensioned(name, place)
    views = [view.box for view in sheet.views]
    texts = []
    for note in notes(sheet):
        (line,), (text,) = note[AnnotationKind.DIMENSION], note[AnnotationKind.TEXT]
        for box in (line.box, text.box):
            assert not any(_overlap(box, view) for view in views)
        texts.append(text.box)
    for index, one in enumerate(texts):
        assert not any(_overlap(one, other) for other in texts[:index])


@pytest.mark.parametrize("place", list(TextPlace))
@pytest.mark.parametrize("name", [*NAMES, "1", "7"])
def test_no_line_strikes_a_text_through(name: str, place: TextPlace) -> None:
    sheet = dimensioned(name, place)
    found = notes(sheet)
    for note in found:
        box = note[AnnotationKind.TEXT][0].box
        for other in found:
            for mark in (*other[AnnotationKind.EXTENSION], *other[AnnotationKind.DIMENSION]):
                for stroke in mark.strokes:
                    points = stroke.sample(1.0)
                    inside = (
                        (points[:, 0] > box[0])
                        & (points[:, 0] < box[2])
                        & (points[:, 1] > box[1])
                        & (points[:, 1] < box[3])
                    )
                    assert not inside.any()


def _overlap(one: tuple, other: tuple) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def test_the_extents_are_said_once() -> None:
    values = [
        note[AnnotationKind.DIMENSION][0].value_mm for note in notes(dimensioned("u-bracket"))
    ]
    assert sorted(values) == [12.0, 14.0, 20.0, 36.0, 38.0, 40.0, 55.0, 58.0, 72.0]


def test_what_is_round_has_a_diameter_instead() -> None:
    values = [note[AnnotationKind.DIMENSION][0].value_mm for note in notes(dimensioned("pulley"))]
    # The wheel's width of 42 and its steps, neither its diameter of 76 nor its radius.
    assert sorted(values) == [6.0, 12.0, 30.0, 36.0, 42.0]


def test_upright_dimensions_are_read_from_the_right() -> None:
    for note in notes(dimensioned("u-bracket")):
        (line,), (text,) = note[AnnotationKind.DIMENSION], note[AnnotationKind.TEXT]
        upright = line.strokes[0].start[0] == line.strokes[0].end[0]
        assert text.label.angle == pytest.approx(-np.pi / 2.0 if upright else 0.0)
        # The text stands above its line, seen along it.
        neighbour = 0 if upright else 1
        assert text.label.centre[neighbour] < line.strokes[0].start[neighbour]


def test_inline_texts_are_level_and_interrupt_their_lines() -> None:
    interrupted = 0
    for note in notes(dimensioned("u-bracket", INLINE)):
        (line,), (text,) = note[AnnotationKind.DIMENSION], note[AnnotationKind.TEXT]
        assert text.label.angle == 0.0
        first = line.strokes[0]
        upright = first.start[0] == first.end[0]
        across, along = (0, 1) if upright else (1, 0)
        assert text.label.centre[across] == pytest.approx(first.start[across])
        interrupted += len(line.strokes) == 2
        if len(line.strokes) == 2:
            before, after = (stroke.start[along] for stroke in line.strokes)
            assert before < text.label.centre[along] < after
    assert interrupted >= 5


@pytest.mark.parametrize(
    ("value", "text"), [(12.0, "12"), (12.5, "12.5"), (0.333, "0.33"), (100.0, "100"), (7.1, "7.1")]
)
def test_numbers_have_no_idle_zeros(value: float, text: str) -> None:
    assert value_text(value) == text
