"""Pads and pockets: the fewest and simplest that make up a solid."""

from collections.abc import Callable, Iterable

import numpy as np
import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features import decomposing
from gaussiancad_core.features.body_cover import Choice, cheapest_cover
from gaussiancad_core.features.feature_building import combined
from gaussiancad_core.features.feature_model import Extrusion, Feature, FeatureList
from gaussiancad_core.features.frames import MAIN_FRAMES
from gaussiancad_core.features.sample_points import Samples, joined
from gaussiancad_core.features.sweeps import Sweep
from gaussiancad_core.kernel.brep import subshapes
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, fuse, prism, slot

Find = Callable[[TopoDS_Shape], tuple[FeatureList, list[str]]]

_ELL = [(0.0, 0.0), (40.0, 0.0), (40.0, 8.0), (10.0, 8.0), (10.0, 30.0), (0.0, 30.0)]


def _turned(shape: TopoDS_Shape, axis: tuple[float, float, float], degrees: float) -> TopoDS_Shape:
    motion = gp_Trsf()
    motion.SetRotation(gp_Ax1(gp_Pnt(3.0, -7.0, 11.0), gp_Dir(*axis)), np.radians(degrees))
    return BRepBuilderAPI_Transform(shape, motion, True).Shape()


@pytest.mark.parametrize("axis", list(Axis))
def test_an_l_profile_is_one_pad(
    axis: Axis, found: Find, edges_in: Callable[[Feature], list[int]]
) -> None:
    features, kinds = found(prism(axis, _ELL, 5.0, 25.0))
    (pad,) = features.features
    assert features.is_whole and kinds == ["pad"]
    assert edges_in(pad) == [6]
    assert isinstance(pad, Extrusion) and abs(pad.length) == pytest.approx(20.0)
    assert pad.sketch.frame in MAIN_FRAMES
    # The end nearer to the origin has the sketch.
    assert abs(pad.sketch.height) == pytest.approx(5.0)


def test_a_plate_with_a_boss_is_two_pads_the_larger_first(found: Find) -> None:
    features, kinds = found(fuse(box((0, 0, 0), (60, 40, 8)), box((10, 10, 8), (30, 30, 20))))
    plate, boss = features.features
    assert features.is_whole and kinds == ["pad", "pad"]
    assert isinstance(plate, Extrusion) and isinstance(boss, Extrusion)
    # A sketch on an origin plane, through what is there, needs no offset.
    assert (plate.length, boss.length) == pytest.approx((8.0, 20.0))
    assert (plate.sketch.height, boss.sketch.height) == pytest.approx((0.0, 0.0))


def test_a_blind_pocket_is_a_pad_less_a_pocket(
    found: Find, edges_in: Callable[[Feature], list[int]]
) -> None:
    features, kinds = found(cut(box((0, 0, 0), (60, 40, 20)), box((10, 10, 12), (50, 30, 20))))
    assert features.is_whole and kinds == ["pad", "pocket"]
    assert [edges_in(feature) for feature in features.features] == [[4], [4]]


def test_a_window_is_an_outline_of_its_pad(
    found: Find, edges_in: Callable[[Feature], list[int]]
) -> None:
    features, kinds = found(cut(box((0, 0, 0), (60, 40, 8)), box((10, 10, 0), (50, 30, 8))))
    assert kinds == ["pad"]
    assert edges_in(features.features[0]) == [4, 4]


def test_a_slanted_pocket_is_on_an_oblique_plane(found: Find) -> None:
    tool = slot(Axis.Z, ((20, 20), (36, 20)), 6.0, 14.0, 60.0)
    tool = _turned(tool, (0.0, 1.0, 0.0), 20.0)
    features, kinds = found(cut(box((0, 0, 0), (60, 40, 30)), tool))
    assert features.is_whole and kinds == ["pad", "pocket"]
    pocket = features.features[1]
    assert isinstance(pocket, Extrusion)
    assert pocket.sketch.frame not in MAIN_FRAMES
    lean = np.array([np.sin(np.radians(20.0)), 0.0, np.cos(np.radians(20.0))])
    assert abs(lean @ np.array(pocket.sketch.frame.normal)) == pytest.approx(1.0, abs=1e-7)


@pytest.mark.parametrize("axis", [(1.0, 2.0, 3.0), (-2.0, 1.0, 0.5)])
def test_a_part_that_lies_askew_has_the_same_features(
    axis: tuple[float, float, float], found: Find
) -> None:
    part = cut(prism(Axis.Y, _ELL, 0.0, 20.0), box((20, 6, 2), (32, 14, 8)))
    assert found(_turned(part, axis, 33.0))[1] == found(part)[1]


@pytest.mark.parametrize("scale", [0.02, 40.0])
def test_small_and_large_parts_have_the_same_features(scale: float, found: Find) -> None:
    ell = [(x * scale, y * scale) for x, y in _ELL]
    tool = box(*[tuple(scale * part for part in corner) for corner in ((20, 6, 2), (32, 14, 8))])
    features, kinds = found(cut(prism(Axis.Y, ell, 0.0, 20.0 * scale), tool))
    assert features.is_whole and kinds == ["pad", "pocket"]


def test_pads_touch_what_is_there(found: Find) -> None:
    """A tower of three: the top one is larger than the middle one that it stands on."""
    tower = fuse(
        box((0, 0, 0), (60, 40, 8)),
        prism(Axis.Z, [(20, 10), (30, 10), (25, 25)], 8.0, 20.0),
        prism(Axis.X, [(5, 20), (35, 20), (20, 38)], 15.0, 45.0),
    )
    features, kinds = found(tower)
    assert features.is_whole and set(kinds) == {"pad"}
    for count in range(1, len(kinds) + 1):
        made = combined(features.features[:count])
        assert len(subshapes(made, TopAbs_ShapeEnum.TopAbs_SOLID)) == 1


def test_a_cover_that_is_wrong_somewhere_is_mended(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where only points in the material are known at first, the pocket is filled; the difference
    tells the point that says otherwise."""
    tried = []

    def blind(parts: Iterable[Samples]) -> Samples:
        found = joined(parts)
        return Samples(found.points[found.is_inside], found.is_inside[found.is_inside])

    def counted(choice: Choice, samples: Samples) -> tuple[Sweep, ...] | None:
        tried.append(len(samples.points))
        return cheapest_cover(choice, samples)

    monkeypatch.setattr(decomposing, "joined", blind)
    monkeypatch.setattr(decomposing, "cheapest_cover", counted)
    part = cut(box((0, 0, 0), (60, 40, 20)), box((10, 10, 12), (50, 30, 20)))
    found = decomposing.decomposed(part)
    assert found is not None and found.difference.is_none
    assert [body.adds for body in found.bodies] == [True, False]
    assert len(tried) == 2 and tried[1] == tried[0] + 1
