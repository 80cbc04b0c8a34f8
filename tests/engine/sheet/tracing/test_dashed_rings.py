"""The circles of a shaft's end view are told though their dashes melt."""

from typing import Any

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Circle
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.dashed_rings import with_rings
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import ViewShapes, find_shapes, view_rhythm

Sketch = Any
"""The class that the fixture gives."""

CENTRE, OUTER = (120.0, 130.0), 90.0
END = (28.0, 38.0, 213.0, 223.0)
SIDE = (28.0, 258.0, 213.0, 423.0)


def _dashed(drawn: Sketch, radius: float, phase: float = 0.0) -> None:
    """A circle of whole dashes of about 10 px and gaps of about 6 px, with a thin pen."""
    count = max(4, round(2.0 * np.pi * radius / 16.0))
    step = 2.0 * np.pi / count
    for k in range(count):
        drawn.arc(CENTRE, radius, 1.7, phase + k * step, 0.62 * step)


def _end_view(sketch: Sketch, radii: list[float], phase: float = 0.0) -> Sketch:
    drawn = sketch(240, 440).arc(CENTRE, OUTER, 2.7)
    for k, radius in enumerate(radii):
        _dashed(drawn, radius, k * phase)
    return drawn


def _views(drawn: Sketch, *roles: Role) -> dict[Role, ViewShapes]:
    boxes = {Role.TOP: END, Role.FRONT: SIDE}
    sheet = clean_sheet(drawn.grey)
    views = {role: find_shapes(sheet, boxes[role]) for role in roles}
    found = with_rings(views, {role: boxes[role] for role in roles})
    return dict(zip(roles, found, strict=True))


def _radii(view: ViewShapes, linetype: Linetype) -> list[float]:
    strokes = classify_strokes(view, view_rhythm([view], view.sheet.stroke_width))
    centre = np.array(CENTRE) + 0.5
    arcs = [stroke for stroke in strokes if isinstance(stroke, Arc) and stroke.linetype is linetype]
    assert all(np.hypot(*np.subtract(arc.centre, centre)) < 0.15 for arc in arcs)
    assert all(arc.sweep == pytest.approx(2.0 * np.pi) for arc in arcs)
    return sorted(arc.radius for arc in arcs)


@pytest.mark.parametrize("phase", [0.0, 0.17])
@pytest.mark.parametrize(
    "radii",
    [[21.3, 23.8, 26.2, 28.6, 33.3, 50.0, 52.3], [40.0, 42.6, 45.1, 62.0, 70.4, 72.8, 75.4]],
)
def test_melting_circles_are_all_read(sketch: Sketch, radii: list[float], phase: float) -> None:
    view = _views(_end_view(sketch, radii, phase), Role.TOP)[Role.TOP]
    assert _radii(view, Linetype.HIDDEN) == pytest.approx(radii, abs=0.25)
    assert _radii(view, Linetype.VISIBLE) == pytest.approx([OUTER], abs=0.1)


def test_a_circle_drawn_through_between_them_stays_visible(sketch: Sketch) -> None:
    radii = [60.0, 62.6, 68.4, 71.0]
    drawn = _end_view(sketch, radii).arc(CENTRE, 65.5, 2.7)
    view = _views(drawn, Role.TOP)[Role.TOP]
    assert _radii(view, Linetype.HIDDEN) == pytest.approx(radii, abs=0.25)
    assert _radii(view, Linetype.VISIBLE) == pytest.approx([65.5, OUTER], abs=0.15)


def test_radii_that_another_view_shows_part_what_is_one_ring(sketch: Sketch) -> None:
    """Of two circles 1.2 px apart the ink has one broad hill."""
    radii = [40.0, 42.6, 60.0, 61.2]
    drawn = _end_view(sketch, radii)
    alone = _radii(_views(drawn, Role.TOP)[Role.TOP], Linetype.HIDDEN)
    assert alone != pytest.approx(radii, abs=0.25)
    drawn.lines((30, 420), (30, 380), (210, 380), (210, 420), (30, 420), width=2.7)
    for level, radius in zip((350, 320, 290, 260), (61.2, 60.0, 42.6, 40.0), strict=True):
        left, right = CENTRE[0] - radius, CENTRE[0] + radius
        drawn.lines((left, level + 30), (left, level), (right, level), width=2.7)
        drawn.line((right, level), (right, level + 30), 2.7)
    view = _views(drawn, Role.TOP, Role.FRONT)[Role.TOP]
    assert _radii(view, Linetype.HIDDEN) == pytest.approx(radii, abs=0.35)


def test_circles_that_stand_apart_are_left_alone(sketch: Sketch) -> None:
    drawn = _end_view(sketch, [30.0, 45.0, 60.0])
    plain = find_shapes(clean_sheet(drawn.grey), END)
    view = _views(drawn, Role.TOP)[Role.TOP]
    assert [shape.geometry for shape in view.shapes] == [shape.geometry for shape in plain.shapes]
    assert sum(isinstance(shape.geometry, Circle) for shape in view.shapes) >= 4
