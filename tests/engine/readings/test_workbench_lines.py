"""The workbench takes the same lines of a reading, at the same scale, as ``lines.dxf`` has."""

import io
import json
import sys
from math import cos, degrees, sin, tau
from pathlib import Path

import ezdxf
import msgspec
import pytest
from ezdxf.entities import DXFEntity

sys.path.insert(0, str(Path(__file__).resolve().parents[3]))

from freecad.gaussiancad.objects import cleaned_lines
from freecad.gaussiancad.objects.plane_shapes import Shape, is_whole
from gaussiancad_core.readings.cleaned_lines import lines_dxf, mm_per_px
from gaussiancad_core.readings.reading_schema import SheetReading

_BOXES = {"front": [100.0, 160.0, 500.0, 300.0], "left": [600.0, 160.0, 700.0, 300.0]}


def _reading(scale: dict) -> SheetReading:
    shapes = [
        *(
            {"view": role, "kind": "visible", "line": [item[:2], item[2:]]}
            for role, item in _BOXES.items()
        ),
        {"view": "front", "kind": "hidden", "arc": [300.0, 220.0, 50.0, 0.3, 2.0]},
        {"view": "front", "kind": "visible", "arc": [300.0, 220.0, 20.0, 0.3, tau]},
        {"view": "left", "kind": "tangent", "ellipse": [650.0, 200.0, 30.0, 10.0, 0.4, 0.2, 2.0]},
        {"view": "left", "kind": "visible", "ellipse": [650.0, 200.0, 30.0, 10.0, -0.4, 0.2, tau]},
        {"view": "left", "kind": "dimension", "line": [[600.0, 140.0], [700.0, 140.0]]},
        {"view": None, "kind": "visible", "line": [[120.0, 180.0], [130.0, 180.0]]},
        {"view": None, "kind": "centre", "line": [[90.0, 230.0], [510.0, 230.0]]},
        {"view": None, "kind": "cut", "line": [[640.0, 150.0], [640.0, 310.0]]},
        {"view": None, "kind": "centre", "line": [[0.0, 0.0], [9.0, 9.0]]},
    ]
    values = {
        "schema": "gaussiancad-reading/1",
        "sheet": {"sha256": "0", "size": [800, 600]},
        "projection": {"value": "first", "source": "given"},
        "unit": {},
        "scale": scale,
        "views": [{"id": role, "role": role, "box": item} for role, item in _BOXES.items()],
        "strokes": [{"id": f"s{n}", **shape} for n, shape in enumerate(shapes)],
    }
    return msgspec.convert(values, SheetReading)


def _values(reading: SheetReading) -> dict:
    return json.loads(msgspec.json.encode(reading))


@pytest.mark.parametrize(
    "scale",
    [
        {"source": "default"},
        {"source": "default", "mm_per_px": 0.5},
        {"source": "dimension", "mm_per_px": 0.125},
        {"source": "given", "axis": "y", "length_mm": 12.5},
        {"source": "given", "axis": "z", "length_mm": 14.0},
        {"source": "given", "axis": "z", "length_mm": 14.0, "mm_per_px": 0.3},
        {"source": "sheet"},
    ],
)
def test_both_know_the_same_scale(scale: dict) -> None:
    reading = _reading(scale)
    assert cleaned_lines.mm_per_px(_values(reading)) == mm_per_px(reading)


def test_each_view_has_the_same_lines() -> None:
    reading = _reading({"source": "dimension", "mm_per_px": 0.125})
    drawing = ezdxf.read(io.StringIO(lines_dxf(reading).decode("utf-8")))
    sheet = cleaned_lines.cleaned_sheet(_values(reading))
    assert [this_view.role for this_view in sheet.views] == [*_BOXES]
    for view in sheet.views:
        block = list(drawing.blocks.get(view.role.upper()))
        for layers, mine in (
            (("VISIBLE",), view.edges),
            (("HIDDEN", "CENTRE", "TANGENT", "CUT"), view.helpers),
        ):
            theirs = [item for item in block if item.dxf.layer in layers]
            # The left view's right is -Y: its lines lie where Y is from 0 to the part's depth.
            moved = sheet.size[1] if view.role == "left" else 0.0
            assert len(mine) == len(theirs) > 0
            for shape, entity in zip(mine, theirs, strict=True):
                assert _facts(shape, moved) == pytest.approx(_told(entity), abs=1e-5)


def _facts(shape: Shape, moved: float) -> list[float]:
    """Numbers of a shape as DXF has them, its place moved to the right."""
    name, numbers = shape
    if name == "line":
        return [value for x, y in numbers for value in (x + moved, y)]
    x, y, *sizes = numbers
    first, sweep = sizes[-2:]
    if name == "arc":
        ends = [] if is_whole(shape) else [degrees(item) % 360.0 for item in (first, first + sweep)]
        return [x + moved, y, sizes[0], *ends]
    major, minor, rotation = sizes[:3]
    # DXF tells of a whole ellipse that it begins at its axis.
    first, last = (0.0, tau) if is_whole(shape) else (first, first + sweep)
    way = [major * cos(rotation), major * sin(rotation)]
    return [x + moved, y, *way, minor / major, first % tau, last % tau]


def _told(entity: DXFEntity) -> list[float]:
    dxf = entity.dxf
    if entity.dxftype() == "LINE":
        return [dxf.start.x, dxf.start.y, dxf.end.x, dxf.end.y]
    place = [dxf.center.x, dxf.center.y]
    if entity.dxftype() == "CIRCLE":
        return [*place, dxf.radius]
    if entity.dxftype() == "ARC":
        return [*place, dxf.radius, dxf.start_angle % 360.0, dxf.end_angle % 360.0]
    way = dxf.major_axis
    ends = [dxf.start_param % tau, dxf.end_param % tau]
    return [*place, way.x, way.y, dxf.ratio, *ends]
