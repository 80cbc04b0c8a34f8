"""What a person says of a reading, one operation after another."""

import json
from pathlib import Path

import msgspec
import pytest
from msgspec.structs import replace

from gaussiancad_core.readings.correcting import Ink, corrected
from gaussiancad_core.readings.correction_operations import (
    CORRECTIONS_SCHEMA,
    Corrections,
    ScaleOperation,
    TangentEdgesOperation,
)
from gaussiancad_core.readings.reading_schema import SheetReading
from gaussiancad_protocol.reading_kinds import StrokeKind, ViewRole

_FILE = Path(__file__).with_name("two_views.json")
_READING = msgspec.json.decode(_FILE.read_bytes(), type=SheetReading)


def _with(*operations: dict) -> tuple[SheetReading, tuple[int, ...]]:
    stated = msgspec.convert(
        {"schema": CORRECTIONS_SCHEMA, "sheet_sha256": "0", "ops": list(operations)}, Corrections
    )
    found = corrected(_READING, stated.ops)
    return found.reading, found.unmatched


def _kinds(reading: SheetReading) -> dict[str, tuple[str | None, str]]:
    return {stroke.id: (stroke.view, stroke.kind.value) for stroke in reading.strokes}


def test_what_is_taken_for_a_centre_line_becomes_a_hidden_one_of_the_view_around_it() -> None:
    found, unmatched = _with({"op": "kind", "target": {"id": "s3"}, "to": "hidden"})
    assert unmatched == ()
    assert _kinds(found)["s3"] == ("front", "hidden")
    assert _kinds(_READING)["s3"] == (None, "centre")


def test_a_target_is_found_by_its_place_where_ids_have_changed() -> None:
    entry = {"id": "s2", "line": [[11.0, 10.5], [109.0, 10.5]]}
    found, unmatched = _with({"op": "erase", "target": entry})
    assert unmatched == () and sorted(_kinds(found)) == ["s2", "s3", "s4"]
    gone = {"id": "s1", "line": [[10.0, 50.0], [110.0, 50.0]]}
    found, unmatched = _with({"op": "erase", "target": gone}, {"op": "unit", "value": "mm"})
    assert unmatched == (1,) and len(found.strokes) == 4


def test_a_line_that_is_drawn_twice_is_one_and_none_without_its_view() -> None:
    line = {"op": "draw", "view": "top", "kind": "visible", "line": [[10, 210], [110, 210]]}
    other = {**line, "line": [[10, 260], [110, 260]]}
    found, unmatched = _with(line, line, other, {**line, "view": "nowhere"})
    drawn = [stroke for stroke in found.strokes if stroke.source == "given"]
    assert [item.id for item in drawn] == ["p1", "p2"] and unmatched == (4,)


def test_a_box_with_a_role_is_a_view_with_the_lines_in_it() -> None:
    box = {"op": "view", "id": "lines-1", "role": "right", "box": [304, 14, 346, 56]}
    found, _ = _with(box)
    view = next(this_view for this_view in found.views if this_view.id == "lines-1")
    assert (view.role, view.used, view.source) == (ViewRole.RIGHT, True, "given")
    assert _kinds(found)["s4"] == ("lines-1", "visible")
    new = {"op": "view", "id": "mine", "role": "left", "box": [304, 14, 346, 56]}
    assert _kinds(_with(new)[0])["s4"] == ("mine", "visible")
    assert _with({"op": "view", "id": "mine", "role": "left"})[1] == (1,)


def test_another_projection_names_the_views_beside_the_front_anew() -> None:
    found, _ = _with({"op": "projection", "value": "first"})
    assert [view.role for view in found.views[:2]] == [ViewRole.FRONT, ViewRole.BOTTOM]
    assert found.projection.source == "given" and found.projection.alternatives == ()
    again = corrected(
        found,
        msgspec.convert(
            {
                "schema": CORRECTIONS_SCHEMA,
                "sheet_sha256": "0",
                "ops": [{"op": "projection", "value": "third"}],
            },
            Corrections,
        ).ops,
    ).reading
    assert [view.role for view in again.views] == [view.role for view in _READING.views]


def test_what_is_left_out_was_no_tangent_edge() -> None:
    (taken,) = (item for item in _READING.strokes if item.id == "s1")
    tangent = replace(taken, kind=StrokeKind.TANGENT, source="vector")
    person = replace(tangent, id="p1", source="given")
    outside = replace(tangent, id="s9", view=None)
    reading = replace(_READING, strokes=(tangent, person, outside))
    for value, kind in (("left-out", "visible"), ("drawn", "tangent"), ("thin", "tangent")):
        ops = {"ops": [{"op": "tangent_edges", "value": value}]}
        stated = msgspec.convert(
            {"schema": CORRECTIONS_SCHEMA, "sheet_sha256": "0", **ops}, Corrections
        )
        found = corrected(reading, stated.ops).reading
        assert (found.tangent_edges.policy, found.tangent_edges.source) == (value, "given")
        assert [item.kind.value for item in found.strokes] == [kind, "tangent", "tangent"]
    with pytest.raises(msgspec.ValidationError):
        msgspec.convert({"op": "tangent_edges", "value": "unknown"}, TangentEdgesOperation)


def test_another_projection_leaves_what_a_person_named() -> None:
    projection = {"op": "projection", "value": "first"}
    named = {"op": "view", "id": "top", "role": "top"}
    boxed = {"op": "view", "id": "lines-1", "role": "right", "box": [304, 14, 346, 56]}
    found, _ = _with(named, boxed, projection)
    roles = {view.id: view.role for view in found.views}
    assert (roles["top"], roles["lines-1"]) == (ViewRole.TOP, ViewRole.RIGHT)


def test_inches_make_all_lengths_longer_and_millimetres_make_them_what_they_were() -> None:
    found, _ = _with({"op": "unit", "value": "in"})
    (item,) = found.dimensions
    lengths = (item.value_mm, item.told_mm, item.digit_mm, found.scale.mm_per_px)
    assert lengths == pytest.approx((1270.0, 1270.0, 25.4, 12.7))
    back, _ = _with({"op": "unit", "value": "in"}, {"op": "unit", "value": "mm"})
    assert back.scale.mm_per_px == pytest.approx(0.5)
    assert back.dimensions[0].told_mm == pytest.approx(50.0)


@pytest.mark.parametrize(
    ("scale", "expected"),
    [
        ({"mm_per_px": 0.2}, (0.2, None, None)),
        ({"points": [[0, 0], [30, 40]], "length_mm": 5}, (0.1, None, 5.0)),
        ({"axis": "z", "length_mm": 80}, (None, "z", 80.0)),
    ],
)
def test_the_scale_is_told_in_three_ways(scale: dict, expected: tuple) -> None:
    this_scale = _with({"op": "scale", **scale})[0].scale
    assert (
        this_scale.mm_per_px,
        this_scale.axis,
        this_scale.length_mm,
    ) == expected and this_scale.source == "given"


@pytest.mark.parametrize(("axis", "known"), [("y", (0.5, "dimension")), ("z", (None, "given"))])
def test_an_extent_that_no_view_shows_leaves_the_scale(axis: str, known: tuple) -> None:
    lone = msgspec.structs.replace(_READING, views=(_READING.views[0], _READING.views[2]))
    stated = msgspec.convert({"op": "scale", "axis": axis, "length_mm": 4.0}, ScaleOperation)
    scale = corrected(lone, (stated,)).reading.scale
    assert (scale.mm_per_px, scale.source) == known
    assert (scale.axis, scale.length_mm) == (axis, 4.0)


@pytest.mark.parametrize(
    "scale", [{}, {"length_mm": 5}, {"points": [[3, 3], [3, 3]], "length_mm": 5}]
)
def test_a_scale_that_says_nothing_finds_no_place(scale: dict) -> None:
    found, unmatched = _with({"op": "scale", **scale})
    assert found == _READING and unmatched == (1,)


def test_a_number_is_put_right_and_measures_what_it_did() -> None:
    found, _ = _with({"op": "dimension", "id": "d1", "value_mm": 52.25})
    (item,) = found.dimensions
    assert (item.value_mm, item.told_mm, item.digit_mm) == (52.25, 52.25, pytest.approx(0.01))
    assert item.measures == _READING.dimensions[0].measures
    assert _with({"op": "dimension", "id": "d9", "value_mm": 1.0})[1] == (1,)


def test_all_within_a_polygon_is_ignored() -> None:
    polygon = [[0, 0], [200, 0], [200, 20], [0, 20]]
    found, _ = _with({"op": "region", "polygon": polygon, "kind": "ignore"})
    changed = [stroke.id for stroke in found.strokes if stroke.kind is StrokeKind.IGNORE]
    assert changed == ["s1"]


def test_a_reading_comes_back_from_its_file() -> None:
    content = msgspec.json.encode(_READING)
    assert msgspec.json.decode(content, type=SheetReading) == _READING
    # What is not known is left out.
    assert "ellipse" not in json.loads(content)["strokes"][0]
    assert replace(_READING, engine="1") != _READING


_CIRCLE = [60.0, 230.0, 12.0]


def test_a_hole_is_told_once() -> None:
    through = {"op": "note", "circle": _CIRCLE, "through": True}
    deep = {"op": "note", "circle": _CIRCLE, "depth_mm": 7.5}
    found, unmatched = _with(through, deep, {"op": "note", "circle": _CIRCLE}, {**deep, **through})
    assert unmatched == (3, 4)
    (item,) = found.notes
    assert (item.circle, item.depth_mm, item.through) == (tuple(_CIRCLE), 7.5, False)
    assert item.box == (48.0, 218.0, 72.0, 242.0)


@pytest.mark.parametrize(
    ("role", "in_view", "way"),
    [
        ("front", "top", (0.0, -1.0)),
        ("top", "front", (0.0, 1.0)),
        ("right", "front", (-1.0, 0.0)),
        ("left", "top", (1.0, 0.0)),
    ],
)
def test_a_section_looks_as_its_role_says(
    role: str, in_view: str, way: tuple[float, float]
) -> None:
    section = {"op": "view", "id": "cut", "role": role, "box": [200, 10, 260, 60]}
    shown = {"op": "view", "id": "shown", "role": in_view, "box": [10, 10, 110, 60]}
    line = [[10, 230], [60, 230], [60, 240], [110, 240]]
    plane = {"op": "section", "id": "cut", "in_view": "shown", "line": line}
    found, unmatched = _with(section, shown, plane)
    assert unmatched == ()
    (item,) = found.sections
    assert item.way == pytest.approx(way)
    assert item.in_view.value == in_view and item.looks.value == role
    assert not item.straight and item.line == ((10.0, 230.0), (110.0, 240.0))
    again, _ = _with(section, shown, plane, {**plane, "line": line[:1] + line[-1:]})
    assert len(again.sections) == 1 and again.sections[0].straight


def test_a_plane_is_not_seen_where_the_section_looks() -> None:
    front = {"op": "view", "id": "cut", "role": "rear", "box": [200, 10, 260, 60]}
    plane = {"op": "section", "id": "cut", "in_view": "front", "line": [[10, 30], [110, 30]]}
    assert _with(front, plane)[1] == (2,)
    assert _with({**plane, "in_view": "nowhere"})[1] == (1,)


def test_what_was_corrected_is_counted() -> None:
    gone = {"op": "erase", "target": {"id": "s99"}}
    found, unmatched = _with({"op": "unit", "value": "mm"}, gone, {"op": "unit", "value": "in"})
    assert (found.corrected, unmatched) == (2, (2,))


def test_ink_is_traced_in_its_view_alone() -> None:
    stated = msgspec.convert(
        {
            "schema": CORRECTIONS_SCHEMA,
            "sheet_sha256": "0",
            "ops": [
                {"op": "trace", "view": "top", "at": [60, 230], "kind": "hidden"},
                {"op": "trace", "view": "nowhere", "at": [60, 230], "kind": "hidden"},
                {"op": "trace", "view": "front", "at": [60, 30], "kind": "visible"},
            ],
        },
        Corrections,
    )
    asked = []

    def trace(at: tuple[float, float], box: tuple[float, ...]) -> dict | None:
        asked.append((at, box))
        return {"line": ((10.0, 230.0), (110.0, 230.0))} if at[1] > 100 else None

    found = corrected(_READING, stated.ops, Ink(trace=trace))
    assert found.unmatched == (2, 3)
    assert asked == [((60.0, 230.0), (10, 210, 110, 260)), ((60.0, 30.0), (10, 10, 110, 60))]
    stroke = found.reading.strokes[-1]
    assert (stroke.view, stroke.kind.value, stroke.source) == ("top", "hidden", "given")


def test_lines_that_a_boxed_view_takes_in_are_left_out_no_more() -> None:
    box = {"op": "view", "id": "right", "role": "right", "box": [295, 5, 355, 65]}
    found, _ = _with(box)
    assert "lines-1" not in {view.id for view in found.views}
    found, _ = _with({**box, "box": [295, 5, 330, 65]})
    assert "lines-1" in {view.id for view in found.views}
    # A box that was cut out of the group tells as well where the view is.
    found, _ = _with({**box, "box": [310, 20, 340, 50]})
    assert "lines-1" not in {view.id for view in found.views}
