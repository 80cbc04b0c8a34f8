import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind
from gaussiancad_core.drawing.drawn_notes import features
from gaussiancad_core.drawing.drawn_sheet import Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.samples import sample

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
VISIBLE = Linetype.VISIBLE


def _circle(x: float, radius: float, sweep: float = 2.0 * np.pi, start: float = 0.0) -> Arc:
    return Arc((x, 50.0), radius, start, sweep, VISIBLE)


def _said(sheet: Sheet) -> dict[str, tuple[Annotation, Annotation]]:
    leaders = [mark for mark in sheet.annotations if mark.kind is AnnotationKind.LEADER]
    texts = {mark.group: mark for mark in sheet.annotations if mark.kind is AnnotationKind.TEXT}
    return {texts[leader.group].label.text: (leader, texts[leader.group]) for leader in leaders}


def test_equal_circles_are_counted_and_arcs_have_radii() -> None:
    strokes = (
        _circle(50, 10),
        _circle(100, 10),
        _circle(150, 20),
        _circle(200, 8, np.pi / 2.0),
        # A circle in two pieces is one circle.
        _circle(250, 30, np.pi),
        _circle(250, 30, np.pi, np.pi),
        Arc((300.0, 50.0), 5.0, 0.0, 2.0 * np.pi, Linetype.HIDDEN),
    )
    view = DrawnView(Role.TOP, (0.0, 0.0, 400.0, 100.0), strokes, ())
    found = features(view, 0.5)
    assert [feature.text for feature in found] == ["Ø30", "Ø20", "2x Ø10", "R4"]
    assert [feature.value_mm for feature in found] == [30.0, 20.0, 10.0, 4.0]


@pytest.fixture(scope="module")
def plate() -> Sheet:
    lines = part_lines(sample("boss-plate").build(), ROLES)
    return compose_sheet(lines, Projection.THIRD, PRESETS["dimensioned"])


def test_every_size_is_said_once(plate: Sheet) -> None:
    assert sorted(_said(plate)) == ["2x Ø10", "Ø18", "Ø36"]


def test_leaders_end_on_the_circles_that_they_mean(plate: Sheet) -> None:
    top = plate[Role.TOP]
    circles = [stroke for stroke in top.strokes if isinstance(stroke, Arc)]
    for leader, _ in _said(plate).values():
        tip, radius = np.array(leader.arrows[0][0]), leader.value_mm / 2.0 / plate.mm_per_pixel
        away = [
            abs(np.hypot(*(tip - circle.centre)) - circle.radius)
            for circle in circles
            if circle.radius == pytest.approx(radius, abs=1e-6)
        ]
        assert min(away) < 1e-9
        np.testing.assert_allclose(leader.strokes[0].start, tip)


def test_texts_of_leaders_stand_in_the_open(plate: Sheet) -> None:
    boxes = [text.box for _, text in _said(plate).values()]
    others = [view.box for view in plate.views] + [
        mark.box
        for mark in plate.annotations
        if mark.kind in (AnnotationKind.DIMENSION, AnnotationKind.TITLE_BLOCK)
    ]
    for index, one in enumerate(boxes):
        for other in (*boxes[:index], *others):
            assert (
                one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
            )


def test_leaders_enter_their_own_view_only(plate: Sheet) -> None:
    for leader, _ in _said(plate).values():
        entered = {
            view.role
            for view in plate.views
            for stroke in leader.strokes
            for x, y in stroke.sample(1.0)
            if view.box[0] <= x <= view.box[2] and view.box[1] <= y <= view.box[3]
        }
        assert entered == {Role.TOP}
