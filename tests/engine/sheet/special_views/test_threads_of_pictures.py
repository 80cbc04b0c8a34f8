"""Thread symbols are told and taken off; plain circles about each other are none."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet.sheet_stages import ReadView, read_views
from gaussiancad_core.sheet.special_views.thread_symbols import arcs_of, without_threads
from gaussiancad_core.sheet.special_views.view_kinds import SpecialView


def _views(found) -> tuple[tuple[ReadView, ...], tuple[SpecialView, ...]]:  # noqa: ANN001
    """The views without their threads, and these."""
    drawn = read_views(found.separated.part, found.layout)
    return without_threads(drawn, arcs_of(found.separated.strokes_known))


def _threads(found) -> tuple[SpecialView, ...]:  # noqa: ANN001
    return _views(found)[1]


@pytest.mark.parametrize(
    ("part", "style", "px"),
    [
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
    threads = _threads(found)
    storeds = [found.stored(view.box) for view in threads]
    assert len(storeds) == len(drawn) > 0
    assert not any(view.used for view in threads)
    for (x, y), radius in drawn:
        boxes = np.array([x - radius, y - radius, x + radius, y + radius]) - np.array(storeds)
        assert np.abs(boxes).max(axis=1).min() < px


@pytest.mark.parametrize("part", ["bored-plate", "stepped-shaft"])
def test_what_is_left_are_the_lines_of_the_part(find, part: str) -> None:  # noqa: ANN001
    found = find(part, "clean,threads=on")
    plain = find(part, "clean")
    views, bare = ({view.role: view for view in _views(item)[0]} for item in (found, plain))
    for role, view in views.items():
        kinds = [
            sorted((type(stroke).__name__, stroke.linetype.value) for stroke in item.strokes)
            for item in (view, bare[role])
        ]
        assert kinds[0] == kinds[1], role


@pytest.mark.parametrize(
    ("part", "style"),
    [
        ("counterbored-block", "photocopy"),
        ("stepped-shaft", "clean"),
        ("pulley", "even"),
        ("slotted-link", "ansi"),
        ("pulley", "dimensioned"),
    ],
)
def test_plain_sheets_have_no_threads_and_no_halves(find, part: str, style: str) -> None:  # noqa: ANN001
    found = find(part, style)
    assert _threads(found) == ()
    assert found.layout.special == ()
    assert set(found.layout.boxes) == {Role.FRONT, Role.TOP, Role.RIGHT}
