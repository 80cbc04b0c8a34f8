"""What features stand on, and that they go with it when a number is another."""

from collections.abc import Sequence
from dataclasses import replace
from math import pi

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.as_json import solid_values
from gaussiancad_core.features.build123d_script import script_of
from gaussiancad_core.features.constraints import Numbers
from gaussiancad_core.features.feature_model import (
    Extrusion,
    Feature,
    FeatureList,
    Holes,
    Sketch,
    Turning,
)
from gaussiancad_core.features.feature_search import features_of
from gaussiancad_core.features.frames import MAIN_FRAMES
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.supported_features import Side, Standing, Support, standing
from gaussiancad_core.features.supporting_faces import beginning_on_faces, standing_of
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.model.axes import Axis
from sample_parts import SAMPLES, sample
from sample_parts.modelling import box, cut, cylinder, revolved

_XY, _XZ, _YZ = MAIN_FRAMES


def _outline(*points: tuple[float, float]) -> Loop:
    return tuple(
        OutlineEdge(start, end) for start, end in zip(points, (*points[1:], points[0]), strict=True)
    )


def _rectangle(x0: float, y0: float, x1: float, y1: float) -> Loop:
    return _outline((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def _slab(
    low: tuple[float, float], high: tuple[float, float], start: float, length: float
) -> Extrusion:
    return Extrusion(Sketch(_XY, start, (_rectangle(*low, *high),)), length, True)


def _pocket(
    low: tuple[float, float], high: tuple[float, float], start: float, length: float
) -> Extrusion:
    return replace(_slab(low, high, start, length), adds=False)


def _drilled(height: float, centre: tuple[float, float], depth: float | None = None) -> Holes:
    return Holes(_XY, height, (centre,), True, 6.0, depth)


def _begins(*features: Feature) -> Support | None:
    return standing_of(features)[-1].begins


def _ends(*features: Feature) -> Support | None:
    return standing_of(features)[-1].ends


_PLATE = _slab((0, 0), (60, 40), 0.0, 10.0)
_BOSS = _slab((10, 10), (30, 30), 10.0, 20.0)


def test_a_hole_begins_where_the_pad_under_it_ends() -> None:
    assert _begins(_PLATE, _drilled(10.0, (50, 20))) == Support(0, Side.END)
    assert _begins(_PLATE, _BOSS) == Support(0, Side.END)
    assert _begins(_PLATE, _BOSS, _drilled(30.0, (20, 20))) == Support(1, Side.END)
    upward = replace(_drilled(0.0, (50, 20)), is_downward=False)
    assert _begins(_PLATE, upward) == Support(0, Side.START)
    assert _begins(_PLATE, _drilled(9.0, (50, 20))) is None
    assert standing_of([_PLATE]) == (Standing(),)


def test_the_earliest_face_that_is_there_counts_then_the_first_pad() -> None:
    neighbour = _slab((60, 0), (90, 40), 0.0, 10.0)
    assert _begins(_PLATE, neighbour, _drilled(10.0, (70, 20))) == Support(1, Side.END)
    assert _begins(_PLATE, neighbour, _drilled(10.0, (60, 20))) == Support(0, Side.END)
    assert _begins(_PLATE, _BOSS, _drilled(10.0, (200, 20))) == Support(0, Side.END)
    assert _begins(_PLATE, _BOSS, _drilled(30.0, (50, 20))) is None


def test_walls_of_a_pad_across_and_of_a_turned_body() -> None:
    corner = _outline((0, 0), (80, 0), (80, 12), (14, 12), (14, 60), (0, 60))
    bracket = Extrusion(Sketch(_XZ, 0.0, (corner,)), -50.0, True)
    assert _begins(bracket, _drilled(12.0, (50, 25))) == Support(0, Side.WALL, 2)
    across = replace(_drilled(14.0, (25, 40)), frame=_YZ)
    assert _begins(bracket, across) == Support(0, Side.WALL, 3)
    # The plane of the lower wall is within the upright one.
    assert _begins(bracket, _drilled(12.0, (5, 25))) is None
    shaft = Turning(Sketch(_XZ, 0.0, (_rectangle(0, 0, 9, 40),)), (0.0, 0.0), (0.0, 1.0), True)
    assert _begins(shaft, _drilled(40.0, (0, 0))) == Support(0, Side.WALL, 2)
    # What is parallel to the axis sweeps no plane.
    assert _begins(shaft, replace(across, height=9.0, centres=((0.0, 20.0),))) is None


def test_far_ends_of_pockets_and_holes() -> None:
    through = _pocket((5, 5), (9, 9), 0.0, 10.0)
    assert standing_of([_PLATE, through])[1] == Standing(
        Support(0, Side.START), Support(0, Side.END)
    )
    assert _ends(_PLATE, _pocket((5, 5), (9, 9), 10.0, -4.0)) is None
    # Into the pad, as deep as the boss is high: there is material behind.
    assert _ends(_PLATE, _BOSS, _drilled(30.0, (20, 20), 20.0)) is None
    under = _pocket((12, 12), (28, 28), 0.0, 6.0)
    assert _ends(_PLATE, under, _drilled(10.0, (20, 20), 4.0)) == Support(1, Side.END)
    tipped = replace(_drilled(10.0, (20, 20), 4.0), tip=118.0)
    assert _ends(_PLATE, under, tipped) is None


def test_a_pocket_goes_on_past_a_step() -> None:
    stepped = _outline((0, 0), (90, 0), (90, 15), (30, 15), (30, 50), (0, 50))
    block = Extrusion(Sketch(_XZ, 0.0, (stepped,)), -40.0, True)
    notch = _pocket((60, 10), (90, 30), 0.0, 50.0)
    assert _ends(block, notch) == Support(0, Side.WALL, 4)
    higher = _slab((0, 0), (20, 20), 50.0, 5.0)
    assert _ends(block, higher, notch) is None


def test_pads_that_are_as_high_by_chance_have_their_own_lengths() -> None:
    other = _slab((40, 10), (55, 30), 10.0, 20.0)
    assert _ends(_PLATE, _BOSS, other) is None
    assert _ends(_PLATE, _BOSS, replace(other, sketch=_BOSS.sketch)) == Support(1, Side.END)


def test_pockets_begin_at_their_mouths_and_pads_where_they_touch() -> None:
    pocket = _pocket((5, 5), (9, 9), 6.0, 4.0)
    plate, turned = beginning_on_faces([_PLATE, pocket])
    assert plate is _PLATE
    assert (turned.sketch.height, turned.length) == (10.0, -4.0)
    assert turned.sketch.loops == pocket.sketch.loops
    leg = _slab((0, 0), (9, 9), 0.0, 20.0)
    high = replace(_PLATE, sketch=replace(_PLATE.sketch, height=20.0))
    assert beginning_on_faces([high, leg])[1] is leg
    assert _ends(high, leg) == Support(0, Side.START)
    ear = _slab((50, 0), (80, 40), 4.0, 6.0)
    assert beginning_on_faces([_PLATE, ear])[1].length == -6.0
    # It is no mouth where the plate's face is level with the floor.
    hollow = _pocket((12, 12), (28, 28), 14.0, -4.0)
    assert beginning_on_faces([_PLATE, _BOSS, hollow])[2] is hollow
    kept = [_PLATE, _BOSS, _pocket((5, 5), (9, 9), 0.0, 10.0), _drilled(10.0, (50, 20))]
    assert beginning_on_faces(kept) == tuple(kept)


def test_features_go_with_what_they_stand_on() -> None:
    features = [_PLATE, _BOSS, _pocket((5, 5), (9, 9), 0.0, 10.0), _drilled(30.0, (20, 20), 8.0)]
    where = standing_of(features)
    assert standing(features, where) == tuple(features)
    thicker = [replace(_PLATE, length=12.0), *features[1:]]
    _, boss, pocket, hole = standing(thicker, where)
    assert (boss.sketch.height, boss.length) == (12.0, 20.0)
    assert (pocket.sketch.height, pocket.length) == (0.0, 12.0)
    assert (hole.height, hole.depth) == (32.0, 8.0)


def _longer(found: FeatureList, factor: float) -> tuple[TopoDS_Shape, TopoDS_Shape, float]:
    """A part with its first pad as many times as long, and how much less than that pad it is: then
    and before, mm3."""
    from benchmarks.tasks.feature_changes import Number, changed, rebuilt

    def alone(features: Sequence[Feature]) -> float:
        pad = rebuilt([features[0]], None)
        assert pad is not None
        return volume(pad)

    part = rebuilt(found.features, found.base)
    features = changed(found.features, Number(0, "length", "length"), factor)
    made = rebuilt(features, found.base)
    assert part is not None and made is not None
    return made, alone(features) - volume(made), alone(found.features) - volume(part)


@pytest.mark.parametrize("factor", [0.8, 1.03, 1.2])
@pytest.mark.parametrize(
    ("name", "goes_along"),
    [
        ("bored-plate", True),
        ("pocket-block", False),
        ("stepped-block", False),
        ("l-bracket", False),
        ("u-bracket", False),
        ("slotted-link", True),
        ("chamfered-block", False),
    ],
)
def test_samples_with_a_longer_pad(name: str, goes_along: bool, factor: float) -> None:
    _, gone, before = _longer(features_of(sample(name).build()), factor)
    if name == "chamfered-block":
        # Holes along the length, edges across it.
        assert gone > before * min(factor, 1.0) - 1e-6
    else:
        assert gone == pytest.approx(before * (factor if goes_along else 1.0))


def test_a_blind_hole_keeps_its_depth_and_a_counterbore_too() -> None:
    block = box((0, 0, 0), (60, 40, 20))
    blind = cut(block, cylinder(Axis.Z, (30, 20), 4.0, 8.0, 20.0))
    _, gone, before = _longer(features_of(blind), 1.2)
    assert gone == pytest.approx(before)
    bored = cut(
        block,
        cylinder(Axis.Z, (30, 20), 4.0, 0.0, 20.0),
        cylinder(Axis.Z, (30, 20), 8.0, 15.0, 20.0),
    )
    _, gone, before = _longer(features_of(bored), 1.2)
    assert gone == pytest.approx(before + pi * 16.0 * 4.0)


def test_walls_are_told_by_dimensions() -> None:
    values = solid_values(features_of(sample("l-bracket").build()), Numbers(), None)["features"]
    pad, first, second = values
    assert (pad["stands_on"], pad["ends_at"]) == (None, None)
    for hole in (first, second):
        support = hole["stands_on"]
        assert (support["feature"], support["side"]) == ("Pad1", "wall")
        (name,) = support["dimensions"]
        assert support["dimensions"][name] == 1
        dimensions = [each for each in pad["sketch"]["constraints"] if "name" in each]
        known = {each["name"]: each["value"] for each in dimensions}
        assert known[name] == hole["plane"]["offset"]
    profile = [(0, 0), (0, 10), (15, 10), (20, 7), (30, 7), (30, 0)]
    turned = revolved(profile, Axis.Z, (10, 10))
    drilled = cut(turned, cylinder(Axis.Z, (10, 10), 3.0, 20.0, 30.0))
    found = solid_values(features_of(drilled), Numbers(), None)["features"]
    support = found[-1]["stands_on"]
    assert (support["feature"], support["side"]) == ("Revolution1", "wall")
    assert list(support["dimensions"].values()) == [1]


def _script(*features: Feature) -> list[str]:
    return script_of([solid_values(FeatureList(features), Numbers(), None)]).splitlines()


def test_offsets_of_the_script_are_sums_of_its_numbers() -> None:
    lines = _script(
        _PLATE, _BOSS, _pocket((5, 5), (9, 9), 0.0, 10.0), _drilled(30.0, (20, 20), 8.0)
    )
    planes = [line.partition("plane(")[2] for line in lines if "_plane =" in line]
    planes = [line.partition(", (")[0] for line in planes]
    assert planes == ["0", "PAD1_LENGTH", "0", "PAD1_LENGTH + PAD2_LENGTH"]
    assert "part -= extrude(pocket1_plane.location * pocket1, PAD1_LENGTH)" in lines
    apart = replace(_PLATE, sketch=replace(_PLATE.sketch, height=-5.0), length=-10.0)
    upward = replace(_drilled(-15.0, (50, 20)), is_downward=False)
    lines = _script(apart, upward, _pocket((5, 5), (9, 9), -15.0, 10.0))
    assert "PAD1_OFFSET = 5.0" in lines
    (plane,) = [line for line in lines if line.startswith("hole1_plane")]
    assert plane.startswith("hole1_plane = plane(PAD1_OFFSET + PAD1_LENGTH, ")
    assert "part -= extrude(pocket1_plane.location * pocket1, PAD1_LENGTH)" in lines


def test_a_wall_in_the_script() -> None:
    corner = _outline((0, 0), (80, 0), (80, 12), (14, 12), (14, 60), (0, 60))
    bracket = Extrusion(Sketch(_YZ, 0.0, (corner,)), 50.0, True)
    back = Holes(_XZ, -80.0, ((25.0, 6.0),), False, 6.0, None)
    lines = _script(bracket, back, _drilled(12.0, (20, 50)))
    planes = [line for line in lines if line.startswith("hole")]
    assert planes[0].startswith("hole1_plane = plane(PAD1_WIDTH, ")
    assert planes[1].startswith("hole2_plane = plane(PAD1_DISTANCE_Y, ")


@pytest.mark.parametrize("part", SAMPLES, ids=lambda part: part.name)
def test_what_stands_on_something_is_in_its_plane(part) -> None:  # noqa: ANN001
    features = features_of(part.build()).features
    placed = standing(features, standing_of(features))
    for before, after in zip(features, placed, strict=True):
        if isinstance(before, Holes):
            assert after.height == pytest.approx(before.height)
        elif isinstance(before, Extrusion):
            assert after.sketch.height == pytest.approx(before.sketch.height)
            assert after.length == pytest.approx(before.length)
