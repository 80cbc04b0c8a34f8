"""Revolutions and grooves."""

from collections.abc import Callable

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.feature_building import body_of
from gaussiancad_core.features.feature_model import FeatureList, Turning
from gaussiancad_core.kernel.brep import bounding_box, volume
from gaussiancad_core.model.axes import Axis
from sample_parts import sample
from sample_parts.modelling import box, cut, fuse, revolved, sphere

Find = Callable[[TopoDS_Shape], tuple[FeatureList, list[str]]]

_SHAFT = [(0, 0), (0, 10), (15, 10), (15, 16), (30, 12), (30, 8), (50, 8), (50, 0)]
"""(along, radius) of a shaft with a step and a cone."""


@pytest.mark.parametrize("axis", list(Axis))
def test_a_stepped_shaft_is_one_revolution(axis: Axis, found: Find) -> None:
    shaft = revolved(_SHAFT, axis, (12.0, -5.0))
    features, kinds = found(shaft)
    (turning,) = features.features
    assert features.is_whole and kinds == ["revolution"]
    assert isinstance(turning, Turning)
    assert [len(loop) for loop in turning.sketch.loops] == [8]
    body = body_of(turning)
    assert volume(body) == pytest.approx(volume(shaft))
    np.testing.assert_allclose(bounding_box(body), bounding_box(shaft), atol=1e-5)


def test_a_round_notch_in_a_block_is_a_groove(found: Find) -> None:
    notch = revolved([(10, 10), (16, 14), (10, 18)], Axis.Z, (30.0, 20.0))
    features, kinds = found(cut(box((0, 0, 0), (60, 40, 16)), notch))
    assert features.is_whole
    assert kinds == ["pad", "groove"]
    groove = features.features[1]
    assert isinstance(groove, Turning) and not groove.adds


def test_a_ball_on_a_block_is_turned(found: Find) -> None:
    features, kinds = found(fuse(box((0, 0, 0), (40, 40, 10)), sphere((20, 20, 12), 9.0)))
    assert features.is_whole and len(kinds) == 2
    turning = next(feature for feature in features.features if isinstance(feature, Turning))
    radii = [edge.circle.radius for loop in turning.sketch.loops for edge in loop if edge.circle]
    assert radii == pytest.approx([9.0])


@pytest.mark.parametrize("name", ["stepped-shaft", "pulley", "ball-knob"])
def test_turned_samples_are_one_revolution_but_for_their_holes(name: str, found: Find) -> None:
    features, kinds = found(sample(name).build())
    assert features.is_whole
    assert [kind for kind in kinds if kind != "hole"] == ["revolution"]


def test_a_plain_cylinder_is_a_pad(found: Find) -> None:
    features, kinds = found(revolved([(0, 0), (0, 9), (30, 9), (30, 0)], Axis.Y, (0.0, 0.0)))
    (pad,) = features.features
    assert kinds == ["pad"]
    assert [edge.is_circle for loop in pad.sketch.loops for edge in loop] == [True]
