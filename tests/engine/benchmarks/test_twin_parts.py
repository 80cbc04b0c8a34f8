"""Parts that hardly differ, and under which policies they look alike."""

import itertools

import numpy as np
import pytest

from benchmarks.parts.twin_parts import FAMILIES, twins
from benchmarks.sheets.sheet_policies import POLICIES, Policy, in_first
from benchmarks.tasks.verified_sources import Page
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.model.axes import Role
from gaussiancad_core.solid.same import same_solid

_POLICIES = {policy.name: policy for policy in POLICIES}


@pytest.mark.parametrize("odd", [False, True])
@pytest.mark.parametrize("family", FAMILIES)
def test_variants_are_different_parts_of_one_size(family: str, odd: bool) -> None:
    variants = twins(family, 3, odd=odd)
    assert len(variants) >= 3
    assert not any(same_solid(*pair) for pair in itertools.combinations(variants, 2))
    boxes = np.array([bounding_box(shape) for shape in variants])
    assert np.abs(boxes - boxes[0]).max() < 1e-6


def test_cavities_are_told_by_hidden_lines_alone() -> None:
    pages = [Page(shape) for shape in twins("cavities", 0)]
    plain, bare = _POLICIES["all hidden lines"], _POLICIES["no hidden lines"]
    for one, other in itertools.combinations(pages, 2):
        assert one.looks_like(other, bare)
        assert not one.looks_like(other, plain)


def test_a_slant_a_step_and_a_hollow_are_alike_in_two_views() -> None:
    slant, step, hollow, rounded = (Page(shape) for shape in twins("profiles", 5))
    names = (Role.FRONT, Role.TOP), (Role.FRONT, Role.RIGHT), (Role.TOP, Role.RIGHT)
    policies = [Policy("two", roles) for roles in names]
    # In one pair of views the edge that is cut off runs across both.
    for other in (step, hollow):
        assert sum(slant.looks_like(other, policy) for policy in policies) == 1
    # A round has no edges.
    assert not any(slant.looks_like(rounded, policy) for policy in policies)


def test_first_angle_moves_the_views_from_the_other_side() -> None:
    page = Page(twins("steps", 1)[0])
    drawn = page.drawn(_POLICIES["all hidden lines"])
    moved = in_first(drawn, page.size)
    assert set(moved) == {Role.FRONT, Role.BOTTOM, Role.LEFT}
    points = np.concatenate([item.sample(1.0) for item in moved[Role.LEFT]])
    assert points[:, 0].min() == pytest.approx(-page.size[1])
    assert points[:, 0].max() == pytest.approx(0.0)
