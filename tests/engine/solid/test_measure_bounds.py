"""How well the measures of a solid are known."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.constrained_places import ConstrainedPlaces
from gaussiancad_core.evidence.dimension_constraints import DimensionConstraints, LengthDimension
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import faces_of, volume
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.known_faces import axes_of, is_known
from gaussiancad_core.solid.known_measures import DimensionEvidence
from gaussiancad_core.solid.measure_bounds import MeasureSource
from gaussiancad_protocol.modes import Status

Draw = Callable[..., DrawnViews]

_BOUND = 0.03


def _known(shape: TopoDS_Shape, *stated: tuple[float, ...], radii: tuple[float, ...] = ()) -> int:
    """How many faces follow from numbers along x, y and z."""
    places = ConstrainedPlaces(dict(zip(Axis, stated, strict=True)), radii, 0.05, 0.01)
    return sum(is_known(face, DimensionEvidence(places, 1e-3)) for face in faces_of(shape))


def test_told_sides_are_known() -> None:
    box = BRepPrimAPI_MakeBox(40.31, 30.17, 20.0).Solid()
    assert _known(box, (0.0, 40.31), (0.0, 30.17), (0.0, 20.0)) == 6
    assert _known(box, (0.0, 40.31), (0.0,), (0.0, 20.0)) == 5
    assert _known(box, (), (), ()) == 0


def test_a_bore_is_told_by_its_axis_and_radius() -> None:
    axis = gp_Ax2(gp_Pnt(20.3, 11.7, -1.0), gp_Dir(0.0, 0.0, 1.0))
    block = BRepPrimAPI_MakeBox(60.0, 40.0, 30.0).Solid()
    bored = BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(axis, 4.1, 50.0).Shape()).Shape()
    ends = (0.0, 60.0), (0.0, 40.0), (0.0, 30.0)
    for x, y, radius, known in (
        (20.3, 11.7, 4.1, 7),
        (20.4, 11.7, 4.1, 6),
        (20.3, 11.8, 4.1, 6),
        (20.3, 11.7, 4.2, 6),
    ):
        stated = (*ends[0], x), (*ends[1], y), ends[2]
        assert _known(bored, *stated, radii=(radius,)) == known
    wall = next(face for face in faces_of(bored) if sum(axes_of(face)) == 2)
    assert axes_of(wall) == (True, True, False)


def _picture(views: DrawnViews, bound: float = _BOUND) -> DrawnViews:
    return replace(views, tolerance=0.2, apart=0.3, noise=0.005, bound=bound)


def test_exact_lines_leave_nothing_in_doubt(drawn: Draw) -> None:
    block = BRepPrimAPI_MakeBox(60.417, 40.0, 24.0).Solid()
    found = exact_solid(drawn(block)).measures
    assert found.uncertainty == max(found.by_axis) == 1e-3
    assert found.source is MeasureSource.DRAWING


@pytest.mark.parametrize("bound", [0.03, 0.2])
def test_the_lines_of_a_picture_leave_as_much_in_doubt_as_its_grid(
    bound: float, drawn: Draw
) -> None:
    """Nothing is round here: the places are multiples of no likely step."""
    block = BRepPrimAPI_MakeBox(60.417, 41.173, 24.171).Solid()
    slot = BRepPrimAPI_MakeBox(gp_Pnt(12.137, -1.0, 11.333), 20.873, 60.0, 60.0).Solid()
    result = exact_solid(_picture(drawn(BRepAlgoAPI_Cut(block, slot).Shape()), bound))
    assert result.status is Status.VERIFIED
    assert result.measures.uncertainty == pytest.approx(bound)
    assert result.measures.source is MeasureSource.DRAWING


@pytest.mark.parametrize("numbered", [True, False])
def test_numbers_tell_measures_but_for_their_rounding(numbered: bool, drawn: Draw) -> None:
    block = BRepPrimAPI_MakeBox(60.41, 40.17, 24.17).Solid()
    slot = BRepPrimAPI_MakeBox(gp_Pnt(12.07, -1.0, 11.09), 21.66, 60.0, 60.0).Solid()
    solid = BRepAlgoAPI_Cut(block, slot).Shape()
    # A picture's lines: off by hundredths, for which the numbers make up.
    stated = [
        LengthDimension(axis, 0.01, value - 0.01, value)
        for axis, value in (
            (Axis.X, 12.07),
            (Axis.X, 33.73),
            (Axis.X, 60.41),
            (Axis.Y, 40.17),
            (Axis.Z, 11.09),
            (Axis.Z, 24.17),
        )
    ]
    numbers = DimensionConstraints(tuple(stated if numbered else stated[2:4]), 0.05, 0.004)
    result = exact_solid(replace(_picture(drawn(solid)), dimensions=numbers))
    assert volume(result.shape) == pytest.approx(volume(solid), rel=1e-9)
    assert (result.status, result.reasons) == (Status.VERIFIED, ())
    found = result.measures
    assert found.source is (MeasureSource.NUMBERS if numbered else MeasureSource.MIXED)
    assert found.uncertainty == pytest.approx(0.002 if numbered else _BOUND)
    assert found.by_axis[1] == pytest.approx(0.002)
    assert found.by_axis[2] == pytest.approx(0.002 if numbered else _BOUND)
