"""Names of dimensions: what an engineer would call them, each its own in its sketch."""

import pytest

from gaussiancad_core.features.constraints import Numbers, constraints_of
from gaussiancad_core.features.dimension_names import dimension_names
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.geometry.outline_edges import OutlineEdge, whole_circle
from gaussiancad_core.geometry.whole_curves import Circle


def _polygon(*points: tuple[float, float]) -> Loop:
    return tuple(OutlineEdge(a, b) for a, b in zip(points, (*points[1:], points[0]), strict=True))


def _circle(x: float, y: float, radius: float) -> Loop:
    return (whole_circle(Circle((x, y), radius)),)


def _names(*loops: Loop) -> dict[str, float]:
    found = constraints_of(loops, Numbers())
    names = dimension_names(found, [edge for loop in loops for edge in loop])
    assert [name is None for name in names] == [each.value is None for each in found]
    return {
        name: each.value
        for name, each in zip(names, found, strict=True)
        if name is not None and each.value is not None
    }


@pytest.mark.parametrize(
    ("loops", "names"),
    [
        # What spans a sketch, and what is between its edges.
        ([_polygon((0, 0), (60, 0), (60, 40), (0, 40))], {"Width": 60.0, "Height": 40.0}),
        (
            [_polygon((0, 0), (60, 0), (60, 10), (15, 10), (15, 30), (0, 30))],
            {"Width": 60.0, "Height": 30.0, "DistanceX": 15.0, "DistanceY": 10.0},
        ),
        # What leads to it from the origin, and what there is several times.
        ([_circle(52.0, 25.0, 5.0)], {"Diameter": 10.0, "OffsetX": 52.0, "OffsetY": 25.0}),
        (
            [_circle(10.0, 10.0, 3.0), _circle(30.0, 10.0, 2.0)],
            {"Diameter1": 6.0, "Diameter2": 4.0}
            | {"OffsetX1": 10.0, "OffsetX2": 30.0, "OffsetY": 10.0},
        ),
    ],
)
def test_dimensions_are_called_what_they_measure(loops: list[Loop], names: dict) -> None:
    assert _names(*loops) == names


def test_a_distance_between_centres_is_no_width() -> None:
    ends = ((5.0, 0.0), (25.0, 0.0), (25.0, 10.0), (5.0, 10.0))
    slot = (
        OutlineEdge(ends[0], ends[1]),
        OutlineEdge(ends[1], ends[2], Circle((25.0, 5.0), 5.0)),
        OutlineEdge(ends[2], ends[3]),
        OutlineEdge(ends[3], ends[0], Circle((5.0, 5.0), 5.0)),
    )
    names = _names(slot)
    assert "Width" not in names
    assert names["Radius"] == 5.0
