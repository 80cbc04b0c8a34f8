"""Thread symbols are told and taken off; plain circles about each other are none."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.reading import read_views
from gaussiancad_core.sheet.special_views.kinds import SpecialKind


def _threads(found) -> list:  # noqa: ANN001
    return [view for view in found.layout.special if view.kind is SpecialKind.THREAD]


@pytest.mark.parametrize(
    ("part", "style", "px"),
    [
        ("bored-plate", "clean", 2.0),
        ("bored-plate", "even", 2.0),
        ("bored-plate", "dimensioned", 2.0),
        ("stepped-shaft", "clean,centre-lines=on", 2.0),
        ("bored-plate", "scan", 6.0),
    ],
)
def test_each_symbol_is_told_where_it_stands(find, part: str, style: str, px: float) -> None:  # noqa: ANN001
    found = find(part, f"{style},threads=on")
    drawn = [
        (note.strokes[0].centre, note.strokes[0].radius)
        for note in found.drawn.annotations
        if note.kind is AnnotationKind.THREAD
    ]
    told = [found.stored(view.box) for view in _threads(found)]
    assert len(told) == len(drawn) > 0
    assert not any(view.used for view in _threads(found))
    for (x, y), radius in drawn:
        boxes = np.array([x - radius, y - radius, x + radius, y + radius]) - np.array(told)
        assert np.abs(boxes).max(axis=1).min() < px


@pytest.mark.parametrize(("part", "style"), [("bored-plate", "clean"), ("stepped-shaft", "clean")])
def test_what_is_left_are_the_lines_of_the_part(find, part: str, style: str) -> None:  # noqa: ANN001
    found = find(part, f"{style},threads=on")
    plain = find(part, style)
    views, bare = (
        {view.role: view for view in read_views(own.separated.part, own.layout)}
        for own in (found, plain)
    )
    for role, view in views.items():
        kinds = [
            sorted((type(stroke).__name__, stroke.linetype.value) for stroke in own.strokes)
            for own in (view, bare[role])
        ]
        assert kinds[0] == kinds[1], role


@pytest.mark.parametrize("style", ["clean", "even", "dimensioned", "photocopy", "ansi"])
@pytest.mark.parametrize("part", ["counterbored-block", "stepped-shaft", "pulley", "slotted-link"])
def test_plain_concentric_circles_are_no_threads(find, part: str, style: str) -> None:  # noqa: ANN001
    assert _threads(find(part, style)) == []
