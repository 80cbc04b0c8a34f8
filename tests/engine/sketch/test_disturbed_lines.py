"""The sketch is the part though strokes are missing, others are not its own, and ends are off."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sketch.sketch_check import checked
from gaussiancad_core.sketch.sketching import sketch
from sample_parts.classed import PartClass, classed_part

Draw = Callable[[TopoDS_Shape], DrawnViews]
Iou = Callable[[TopoDS_Shape, TopoDS_Shape], float]
Line = tuple[Role, tuple[float, float], tuple[float, float]]


def _disturbed(views: DrawnViews, lost: list[Line], stray: list[Line]) -> DrawnViews:
    strokes = {role: list(stroke) for role, stroke in views.strokes.items()}
    for role, *ends in lost:
        strokes[role] = [s for s in strokes[role] if not _is(s, ends)]
        assert len(strokes[role]) < len(views.strokes[role])
    for role, start, end in stray:
        strokes[role].append(Segment(start, end, Linetype.VISIBLE))
    return replace(views, strokes={role: tuple(stroke) for role, stroke in strokes.items()})


def _is(stroke: object, ends: list[tuple[float, float]]) -> bool:
    return isinstance(stroke, Segment) and {
        tuple(round(x, 3) for x in end) for end in (stroke.start, stroke.end)
    } == set(ends)


@pytest.mark.parametrize(
    ("seed", "lost", "stray"),
    [
        (
            1,
            [(Role.TOP, (0.0, 32.0), (16.0, 32.0)), (Role.TOP, (4.0, 10.0), (4.0, 26.0))],
            [(Role.RIGHT, (4.6, 22.8), (12.8, 22.8))],
        ),
        (
            8,
            [(Role.TOP, (32.0, 28.0), (32.0, 40.0)), (Role.FRONT, (8.0, 14.0), (32.0, 14.0))],
            [(Role.RIGHT, (19.8, 59.9), (19.8, 76.0))],
        ),
    ],
    ids=["an open outline", "a line within"],
)
def test_missing_and_stray_strokes_make_no_other_part(
    seed: int, lost: list[Line], stray: list[Line], drawn: Draw, iou: Iou
) -> None:
    truth = classed_part(PartClass.PLANES, seed, 1)
    views = _disturbed(drawn(truth), lost, stray)
    found = sketch(views, _pixel(views))
    assert iou(found.shape, truth) > 0.99
    assert "lines-unexplained" in [code for code, _ in checked(found, views).reasons]


def _pixel(views: DrawnViews) -> float:
    """mm of a pixel where the part is 600 of them long."""
    return max(views.size) / 600.0


def _aside(views: DrawnViews, reach: float, seed: int) -> DrawnViews:
    """With every end, centre and radius off by up to ``reach`` mm, which is told as tolerance."""
    random = np.random.default_rng(seed)

    def off(point: tuple[float, float]) -> tuple[float, float]:
        angle, far = random.uniform(0.0, 2.0 * np.pi), reach * random.uniform() ** 0.5
        return point[0] + far * float(np.cos(angle)), point[1] + far * float(np.sin(angle))

    def moved(stroke: Segment | Arc) -> Segment | Arc:
        if isinstance(stroke, Arc):
            radius = stroke.radius + random.uniform(-reach, reach)
            return replace(stroke, centre=off(stroke.centre), radius=radius)
        return replace(stroke, start=off(stroke.start), end=off(stroke.end))

    strokes = {role: tuple(map(moved, stroke)) for role, stroke in views.strokes.items()}
    return replace(views, strokes=strokes, tolerance=reach)


@pytest.mark.parametrize("seed", [0, 1, 2, 3])
def test_lines_that_miss_each_other_by_pixels_are_taken_to_meet(
    seed: int, drawn: Draw, iou: Iou
) -> None:
    truth = classed_part(PartClass.PLANES, seed, 0)
    views = drawn(truth)
    views = _aside(views, _pixel(views), seed)
    assert iou(sketch(views, _pixel(views)).shape, truth) > 0.985
