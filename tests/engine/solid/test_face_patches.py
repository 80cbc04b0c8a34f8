"""Patches cover the surface of a labelled part."""

from collections.abc import Callable
from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.solid.face_patches import (
    PlanePatch,
    Rectangle,
    SweptPatch,
    find_patches,
    united,
)
from gaussiancad_core.solid.labelled_cells import LabelledComplex

Labelled = Callable[[str], tuple[object, LabelledComplex]]

_SPAN = st.tuples(st.integers(0, 40), st.integers(1, 8)).map(lambda p: (p[0], p[0] + p[1]))
_RECTANGLE = st.tuples(_SPAN, _SPAN).map(lambda p: (*map(float, p[0]), *map(float, p[1])))


def _touch(one: Rectangle, other: Rectangle) -> bool:
    across = one[0] <= other[1] and other[0] <= one[1]
    return across and one[2] <= other[3] and other[2] <= one[3]


@given(st.lists(_RECTANGLE, max_size=12))
def test_united_rectangles_cover_all_and_lie_apart(rectangles: list[Rectangle]) -> None:
    found = united(rectangles)
    for r in rectangles:
        assert any(f[0] <= r[0] and r[1] <= f[1] and f[2] <= r[2] and r[3] <= f[3] for f in found)
    assert not any(_touch(one, other) for k, one in enumerate(found) for other in found[:k])
    if rectangles:
        assert min(f[0] for f in found) == min(r[0] for r in rectangles)
        assert max(f[3] for f in found) == max(r[3] for r in rectangles)


@given(st.lists(_RECTANGLE, max_size=8), st.randoms(use_true_random=False))
def test_the_order_of_rectangles_does_not_matter(
    rectangles: list[Rectangle], random: object
) -> None:
    shuffled = list(rectangles)
    random.shuffle(shuffled)
    assert sorted(united(rectangles)) == sorted(united(shuffled))


def test_the_patches_of_planes_are_where_the_part_ends(labelled: Labelled) -> None:
    _, space = labelled("l-bracket")
    patches = find_patches(space)
    ends = {(axis, end) for axis in Axis for end in (0.0, round(space.space.values[axis][-1], 6))}
    stated = {(p.axis, round(abs(p.value), 6)) for p in patches if isinstance(p, PlanePatch)}
    assert ends <= stated
    for axis, end in ends:
        (outer,) = (
            p
            for p in patches
            if isinstance(p, PlanePatch) and p.axis is axis and abs(p.value - end) < 1e-5
        )
        low_a, high_a, low_b, high_b = outer.rectangle
        assert low_a < high_a and low_b < high_b


@pytest.mark.parametrize("name", ["bored-plate", "wedge-block"])
def test_every_change_of_labels_lies_on_a_patch(name: str, labelled: Labelled) -> None:
    _, space = labelled(name)
    patches = find_patches(space)
    rng = np.random.default_rng(3)
    checked = 0
    for normal in Axis:
        first, second = IN_PLANE[normal]
        ends = [space.space.values[Axis(index)][-1] for index in (first, second)]
        for a, b in rng.uniform(0.0, 1.0, (40, 2)) * ends:
            for stretch in space.stretches(normal, float(a), float(b)):
                for depth in stretch:
                    point = np.zeros(3)
                    point[first], point[second], point[normal.value] = a, b, depth
                    assert any(_covers(patch, point) for patch in patches)
                    checked += 1
    assert checked > 100


def _covers(patch: PlanePatch | SweptPatch, point: np.ndarray) -> bool:
    first, second = IN_PLANE[patch.axis]
    low_a, high_a, low_b, high_b = patch.rectangle
    along = float(point[patch.axis.value])
    slack = 1e-4
    if isinstance(patch, PlanePatch):
        inside = low_a - slack <= point[first] <= high_a + slack
        return abs(along - patch.value) < slack and bool(
            inside and low_b - slack <= point[second] <= high_b + slack
        )
    flat = float(point[first]), float(point[second])
    at = patch.curve.parameter(flat)
    inside = any(low_a - slack <= at + turn <= high_a + slack for turn in (0.0, 2.0 * np.pi))
    return (
        patch.curve.distance(flat) < slack and inside and low_b - slack <= along <= high_b + slack
    )


def test_swept_patches_are_those_of_slants_and_circles(labelled: Labelled) -> None:
    _, plate = labelled("bored-plate")
    assert all(p.curve.axis is None for p in find_patches(plate) if isinstance(p, SweptPatch))
    _, bracket = labelled("stepped-block")
    assert not any(isinstance(p, SweptPatch) for p in find_patches(bracket))


def test_a_round_end_is_one_patch_wherever_its_angle_begins_again(labelled: Labelled) -> None:
    # Both ends of the link are half rounds, one of them across the angle zero.
    _, link = labelled("slotted-link")
    patches = [p for p in find_patches(link) if isinstance(p, SweptPatch)]
    outer = max(p.curve.radius for p in patches)
    ends = [p.rectangle[:2] for p in patches if p.curve.radius == outer]
    assert sorted(low for low, _ in ends) == pytest.approx([-pi / 2.0, pi / 2.0])
    assert [high - low for low, high in ends] == pytest.approx([pi, pi])
