"""Numbers of features that are changed, and sketches that are solved again."""

from itertools import pairwise

import pytest
from OCP.TopoDS import TopoDS_Shape

from benchmarks.tasks.feature_changes import changed, numbers_of, outlines, rebuilt
from benchmarks.tasks.feature_sketches import Freedom, UnsolvedError, freedom, solved
from gaussiancad_core.features.constraints import Constraint, Kind, Numbers, constraints_of
from gaussiancad_core.features.feature_search import features_of
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.sketch_geometry import Reference
from gaussiancad_core.geometry.outline_edges import OutlineEdge, enclosed_area
from gaussiancad_core.kernel.brep import bounding_box, volume
from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder

_PLATE: Loop = tuple(
    OutlineEdge(*ends)
    for ends in pairwise([(0.0, 0.0), (60.0, 0.0), (60.0, 40.0), (0.0, 40.0), (0.0, 0.0)])
)


def _part() -> TopoDS_Shape:
    return cut(box((0, 0, 0), (60, 40, 12)), cylinder(Axis.Z, (20, 15), 4.0, 5.0, 12.0))


def test_what_a_constraint_fixes_is_free_without_it() -> None:
    found = constraints_of([_PLATE], Numbers())
    assert freedom([_PLATE], found) == Freedom(0, 0)
    assert freedom([_PLATE], found[1:]).left > 0
    assert freedom([_PLATE], [*found, found[0]]).redundant > 0
    assert freedom([_PLATE], []) == Freedom(16, 0)


def test_a_sketch_is_solved_for_another_dimension() -> None:
    found = [
        Constraint(each.kind, each.of, 75.0) if each.value == 60.0 else each
        for each in constraints_of([_PLATE], Numbers())
    ]
    (loop,) = solved([_PLATE], found)
    assert enclosed_area(loop) == pytest.approx(75.0 * 40.0)


def test_a_sketch_that_contradicts_itself_is_not_solved() -> None:
    found = [
        *constraints_of([_PLATE], Numbers()),
        Constraint(Kind.DISTANCE_X, (Reference(0),), 9.0),
    ]
    with pytest.raises(UnsolvedError):
        solved([_PLATE], found)


def test_each_number_changes_the_solid() -> None:
    features = features_of(_part()).features
    numbers = list(numbers_of(features))
    kinds = sorted(number.kind for number in numbers)
    assert kinds == [
        "depth",
        "diameter",
        "distance",
        "distance",
        "distance",
        "distance",
        "length",
    ]
    before = rebuilt(features, None)
    assert before is not None and volume(before) == pytest.approx(volume(_part()))
    for number in numbers:
        after = rebuilt(changed(features, number, 1.1), None)
        assert after is not None
        low, high = bounding_box(after)
        moved = [changed(features, number, 1.1)[k] != features[k] for k in range(len(features))]
        # The hole begins where the pad ends, wherever that is.
        assert moved.count(True) == (2 if number.kind == "length" else 1)
        if number.kind in ("length", "depth", "diameter"):
            assert volume(after) != pytest.approx(volume(before), rel=1e-4)
        assert (high - low > 0.0).all()


def test_the_circles_of_holes_are_their_outlines() -> None:
    hole = features_of(_part()).features[1]
    ((circle,),) = outlines(hole)
    assert circle.is_circle and circle.circle.radius == pytest.approx(4.0)
    assert circle.circle.centre == pytest.approx((20.0, 15.0))
