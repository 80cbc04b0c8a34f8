"""What is drawn beside the views, and views with a piece left out."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.insets import cut_by_circle
from gaussiancad_core.drawing.sheet_style import Inset, parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from sample_parts import sample

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)


@pytest.fixture(scope="module")
def lines() -> PartLines:
    return part_lines(sample("l-bracket").build(), ROLES)


def _sheet(lines: PartLines, look: str) -> Sheet:
    return compose_sheet(lines, Projection.THIRD, parse_style(f"clean,{look}"))


@pytest.mark.parametrize("inset", Inset)
def test_an_inset_stands_beside_the_views(lines: PartLines, inset: Inset) -> None:
    sheet = _sheet(lines, f"inset={inset.value}")
    marks = [mark for mark in sheet.annotations if mark.kind.value == inset.value]
    assert marks
    for mark in marks:
        x0, y0, x1, y1 = mark.box
        for view in sheet.views:
            u0, v0, u1, v1 = view.box
            assert x1 < u0 or u1 < x0 or y1 < v0 or v1 < y0
        assert x0 > 0 and y0 > 0 and x1 < 1920 and y1 < 1080


def test_a_detail_is_as_large_as_its_ring(lines: PartLines) -> None:
    sheet = _sheet(lines, "inset=detail")
    shown, ring = [m for m in sheet.annotations if m.kind is AnnotationKind.DETAIL]
    (circle,) = ring.strokes
    points = np.concatenate([stroke.sample(1.0) for stroke in shown.strokes])
    away = np.hypot(*(points - np.array(circle.centre)).T)
    assert away.max() == pytest.approx(circle.radius, rel=2e-3)


def test_what_a_circle_cuts_out() -> None:
    strokes = (
        Segment((-10.0, 0.0), (10.0, 0.0), Linetype.VISIBLE),
        Segment((0.0, -10.0), (0.0, 10.0), Linetype.HIDDEN),
        Arc((0.0, 0.0), 3.0, 0.0, 2.0 * np.pi, Linetype.VISIBLE),
        Segment((8.0, 8.0), (9.0, 9.0), Linetype.VISIBLE),
    )
    cut = cut_by_circle(strokes, (0.0, 0.0), 5.0)
    lengths = sorted(stroke.length for stroke in cut)
    assert lengths == pytest.approx([10.0, 6.0 * np.pi], rel=0.02)


def test_a_broken_view_keeps_its_extent(lines: PartLines) -> None:
    broken, plain = _sheet(lines, "broken=front"), _sheet(lines, "picture=off")
    assert broken[Role.FRONT].box == plain[Role.FRONT].box
    assert broken[Role.TOP] == plain[Role.TOP]
    (note,) = broken.annotations
    assert (note.kind, len(note.strokes)) == (AnnotationKind.BREAK, 2)
    one, other = (np.array(stroke.points) for stroke in note.strokes)
    # The same line twice, moved along the view.
    assert np.ptp(other - one, axis=0) == pytest.approx([0.0, 0.0], abs=1e-9)
    x0, _, x1, _ = broken[Role.FRONT].box
    assert (other - one)[0, 0] == pytest.approx(0.07 * (x1 - x0))
    middle = 0.5 * (one + other)
    points = np.concatenate([stroke.sample(1.0) for stroke in broken[Role.FRONT].strokes])
    along = np.interp(points[:, 1], middle[:, 1], middle[:, 0])
    assert np.abs(points[:, 0] - along).min() > 0.03 * (x1 - x0)
