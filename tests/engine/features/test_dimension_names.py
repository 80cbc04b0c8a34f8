"""Names of dimensions: what an engineer would call them, each its own in its sketch."""

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


def test_what_spans_a_sketch_is_its_width_and_its_height() -> None:
    assert _names(_polygon((0, 0), (60, 0), (60, 40), (0, 40))) == {"Width": 60.0, "Height": 40.0}
    profile = _polygon((0, 0), (60, 0), (60, 10), (15, 10), (15, 30), (0, 30))
    names = {"Width": 60.0, "Height": 30.0, "DistanceX": 15.0, "DistanceY": 10.0}
    assert _names(profile) == names


def test_what_leads_to_a_sketch_from_the_origin_is_an_offset() -> None:
    names = {"Diameter": 10.0, "OffsetX": 52.0, "OffsetY": 25.0}
    assert _names(_circle(52.0, 25.0, 5.0)) == names


def test_what_there_is_several_times_has_a_number() -> None:
    names = _names(_circle(10.0, 10.0, 3.0), _circle(30.0, 10.0, 2.0))
    assert names == {
        "Diameter1": 6.0,
        "Diameter2": 4.0,
        "OffsetX1": 10.0,
        "OffsetX2": 30.0,
        "OffsetY": 10.0,
    }


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
