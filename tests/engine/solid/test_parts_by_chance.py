"""Small parts by chance come back from the lines of their views, also from disturbed ones.

What stands between lines and solid may be anything: these tests know neither.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from random import Random

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import faces_of, volume
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.solid.exact import ExactResult, exact_solid
from gaussiancad_core.solid.same import same_solid
from gaussiancad_protocol.modes import Status
from sample_parts.classed import PartClass, classed_part

Draw = Callable[..., DrawnViews]
Iou = Callable[[TopoDS_Shape, TopoDS_Shape], float]
Change = Callable[[DrawnStroke], tuple[DrawnStroke, ...]]

F, T, R, L, B, H = Role.FRONT, Role.TOP, Role.RIGHT, Role.LEFT, Role.BOTTOM, Role.REAR

PARTS = [
    *((PartClass.PLANES, seed) for seed in (0, 1, 2, 3)),
    *((PartClass.HOLES, seed) for seed in (1, 2, 3)),
    *((PartClass.SLANTS, seed) for seed in (0, 1, 3)),
    *((PartClass.FILLETS, seed) for seed in (1, 2, 3)),
]
"""Classes and seeds of parts that have one solid under all of these views."""

_PX = 1.0 / 600.0
"""A pixel, as a share of a part's longest extent."""


@cache
def _part(kind: PartClass, seed: int) -> TopoDS_Shape:
    return classed_part(kind, seed, seed % 2)


def _codes(result: ExactResult) -> list[str]:
    return [code for code, _ in result.reasons]


def _changed(views: DrawnViews, change: Change, **more: float) -> DrawnViews:
    strokes = {
        role: tuple(other for stroke in drawn for other in change(stroke))
        for role, drawn in views.strokes.items()
    }
    return replace(views, strokes=strokes, **more)


@pytest.mark.parametrize("roles", [(F, T, R), (F, T, L), (H, B, L), (F, T, R, L)], ids=str)
@pytest.mark.parametrize(("kind", "seed"), PARTS)
def test_a_part_comes_back_from_any_sides(
    kind: PartClass, seed: int, roles: tuple[Role, ...], drawn: Draw
) -> None:
    truth = _part(kind, seed)
    found = exact_solid(drawn(truth, roles))
    assert found.status is Status.VERIFIED and found.reasons == ()
    assert found.shape is not None and same_solid(found.shape, truth)
    assert len(faces_of(found.shape)) == len(faces_of(truth))
    assert volume(found.shape) == pytest.approx(volume(truth), rel=1e-6)


@pytest.mark.parametrize(
    ("kind", "seed", "status"),
    [(PartClass.REVOLVED, 1, Status.VERIFIED), (PartClass.OBLIQUE, 1, None)],
)
def test_turned_and_oblique_parts_come_back(
    kind: PartClass, seed: int, status: Status | None, drawn: Draw
) -> None:
    truth = _part(kind, seed)
    found = exact_solid(drawn(truth))
    assert found.shape is not None and same_solid(found.shape, truth)
    assert found.status is (status or found.status)


@pytest.mark.parametrize(("kind", "seed"), PARTS)
def test_ends_too_long_or_short_by_two_pixels_change_nothing(
    kind: PartClass, seed: int, drawn: Draw
) -> None:
    truth = _part(kind, seed)
    views = drawn(truth)
    random, reach = np.random.default_rng(seed), 2.0 * _PX * max(views.size)

    def with_other_ends(stroke: DrawnStroke) -> tuple[DrawnStroke, ...]:
        if stroke.is_closed:
            return (stroke,)
        most = min(reach, 0.125 * stroke.length)
        low, high = random.uniform(-most, most, 2)
        return (stroke.part(float(low), stroke.length + float(high)),)

    found = exact_solid(_changed(views, with_other_ends, tolerance=reach))
    assert found.status is Status.VERIFIED
    assert found.shape is not None and same_solid(found.shape, truth)


@pytest.mark.parametrize(("kind", "seed"), PARTS)
def test_half_a_pixel_beside_is_the_part_but_for_measures(
    kind: PartClass, seed: int, drawn: Draw, iou: Iou
) -> None:
    truth = _part(kind, seed)
    views = drawn(truth)
    random, reach = np.random.default_rng(seed), 0.5 * _PX * max(views.size)

    def off(point: tuple[float, float]) -> tuple[float, float]:
        angle, far = random.uniform(0.0, 2.0 * np.pi), reach * random.uniform() ** 0.5
        return point[0] + far * float(np.cos(angle)), point[1] + far * float(np.sin(angle))

    def displaced(stroke: DrawnStroke) -> tuple[DrawnStroke, ...]:
        if isinstance(stroke, Arc):
            radius = stroke.radius + random.uniform(-reach, reach)
            return (replace(stroke, centre=off(stroke.centre), radius=radius),)
        assert isinstance(stroke, Segment)
        return (replace(stroke, start=off(stroke.start), end=off(stroke.end)),)

    found = exact_solid(_changed(views, displaced, tolerance=2.0 * reach, apart=reach))
    assert found.shape is not None and iou(found.shape, truth) > 0.995
    is_the_part = same_solid(found.shape, truth)
    assert is_the_part or found.status is Status.APPROXIMATE


@pytest.mark.parametrize(("kind", "seed"), PARTS)
def test_where_a_line_is_lost_the_part_is_found_and_the_line_is_told(
    kind: PartClass, seed: int, drawn: Draw
) -> None:
    truth = _part(kind, seed)
    views = drawn(truth)
    places = [(role, index) for role in views.roles for index in range(len(views.strokes[role]))]
    role, index = Random(seed).choice(places)
    strokes = list(views.strokes[role])
    del strokes[index]
    found = exact_solid(replace(views, strokes={**views.strokes, role: tuple(strokes)}))
    assert found.status is Status.APPROXIMATE
    assert "lines-unexplained" in _codes(found)
    assert found.shape is not None and same_solid(found.shape, truth)


@pytest.mark.parametrize(("kind", "seed"), PARTS[::2])
def test_the_order_the_pieces_and_the_direction_of_strokes_say_nothing(
    kind: PartClass, seed: int, drawn: Draw
) -> None:
    views, lot = drawn(_part(kind, seed)), Random(seed)

    def halves(stroke: DrawnStroke) -> tuple[DrawnStroke, ...]:
        if stroke.is_closed or not isinstance(stroke, Segment):
            return (stroke,)
        middle = tuple((np.array(stroke.start) + stroke.end) / 2.0)
        return replace(stroke, start=middle, end=stroke.start), replace(stroke, start=middle)

    split = _changed(views, halves)
    mixed = {role: tuple(lot.sample(item, len(item))) for role, item in split.strokes.items()}
    before, after = exact_solid(views), exact_solid(replace(split, strokes=mixed))
    assert (before.status, before.reasons) == (after.status, after.reasons)
    assert before.shape is not None and after.shape is not None
    assert same_solid(before.shape, after.shape)


@pytest.mark.parametrize(("kind", "seed"), [PARTS[1], PARTS[4], PARTS[8], PARTS[11]])
def test_without_hidden_lines_nothing_is_verified(kind: PartClass, seed: int, drawn: Draw) -> None:
    views = drawn(_part(kind, seed))
    visible = _changed(views, lambda s: (s,) if s.linetype is Linetype.VISIBLE else ())
    found = exact_solid(visible)
    assert found.status is Status.APPROXIMATE and found.shape is not None
    assert {"assumed", "ambiguous", "lines-unexplained"} & set(_codes(found))
