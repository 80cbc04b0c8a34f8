"""``lines.dxf`` and ``lines.svg``: the lines that were read, clean, for other programs.

A view is a block of its own whose origin is the lower left corner of its box, and stands where it
does on the sheet.  Centre lines, and others that are no edges, go with the view in whose box their
middle lies; what belongs to no view is left out.  Arcs stay arcs.  Lengths are millimetres of
the part, or px of the sheet where its scale is not known, which the file says.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import cos, degrees, hypot, pi, sin
from xml.etree import ElementTree

from gaussiancad_core.geometry.points import FULL_TURN
from gaussiancad_core.model.axes import Role
from gaussiancad_core.readings.dxf_blocks import DxfBlock, DxfEntity, dxf_file, place_tags
from gaussiancad_core.readings.reading_schema import SheetReading, StrokeEntry, ViewEntry
from gaussiancad_core.readings.stroke_anchors import points_of
from gaussiancad_protocol.reading_kinds import DRAWN, StrokeKind

DXF_FILE = "lines.dxf"
SVG_FILE = "lines.svg"

UNKNOWN_SIZE = "lengths are px of the sheet: its scale is not known"

_WHOLE = 1e-6
"""Radians that a whole turn may lack."""

_DECIMALS = 6


@dataclass(frozen=True)
class _Look:
    """How a kind of line is drawn.

    Attributes:
        layer: its name in DXF, in small letters its class in SVG.
        rgb: of SVG.
        dashes: lengths in line widths; empty of solid lines.
    """

    layer: str
    rgb: str
    dashes: tuple[int, ...] = ()


_LOOKS = {
    StrokeKind.VISIBLE: _Look("VISIBLE", "#000000"),
    StrokeKind.HIDDEN: _Look("HIDDEN", "#1f5fbf", (8, 4)),
    StrokeKind.CENTRE: _Look("CENTRE", "#bf3f1f", (16, 4, 4, 4)),
    StrokeKind.TANGENT: _Look("TANGENT", "#808080"),
    StrokeKind.CUT: _Look("CUT", "#9f1f9f", (16, 4, 1, 4)),
}


@dataclass(frozen=True)
class _View:
    """A view to write: its name, its lower left corner in px, and its lines."""

    name: str
    corner: tuple[float, float]
    strokes: tuple[StrokeEntry, ...]


@dataclass(frozen=True)
class _Sheet:
    """What is written, and the length of a px."""

    views: tuple[_View, ...]
    unit: float
    height: float
    is_mm: bool

    def place(self, view: _View) -> tuple[float, float]:
        """Where a view's corner stands, y up."""
        return self.unit * view.corner[0], self.unit * (self.height - view.corner[1])


def lines_dxf(reading: SheetReading) -> bytes:
    """The lines of a reading as a DXF file (R2000), the same bytes for the same reading."""
    sheet = _sheet(reading)
    blocks = [
        DxfBlock(
            view.name,
            sheet.place(view),
            tuple(_drawn(stroke, view.corner, sheet.unit) for stroke in view.strokes),
        )
        for view in sheet.views
    ]
    note = (
        (100, "AcDbText"),
        *place_tags(0.0, -20.0),
        (40, 10.0),
        (1, UNKNOWN_SIZE),
        (100, "AcDbText"),
    )
    notes = [] if sheet.is_mm else [DxfEntity("TEXT", "0", note)]
    return dxf_file(blocks, notes, is_mm=sheet.is_mm)


def lines_svg(reading: SheetReading) -> bytes:
    """The same to look at, as an SVG file in millimetres."""
    sheet = _sheet(reading)
    width, height = (sheet.unit * side for side in _size(reading))
    size = {"width": f"{width:g}", "height": f"{height:g}"}
    if sheet.is_mm:
        size = {name: f"{value}mm" for name, value in size.items()}
    root = ElementTree.Element(
        "svg",
        {"xmlns": "http://www.w3.org/2000/svg", "viewBox": f"0 0 {width:g} {height:g}", **size},
    )
    if not sheet.is_mm:
        ElementTree.SubElement(root, "desc").text = UNKNOWN_SIZE
    thick = max(width, height) / 1000.0
    for view in sheet.views:
        group = ElementTree.SubElement(root, "g", {"id": view.name, "fill": "none"})
        for stroke in view.strokes:
            look = _LOOKS[stroke.kind]
            line = {
                "class": look.layer.lower(),
                "d": _path(stroke, sheet.unit),
                "stroke": look.rgb,
                "stroke-width": f"{thick:g}",
            }
            if look.dashes:
                line["stroke-dasharray"] = " ".join(f"{dash * thick:g}" for dash in look.dashes)
            ElementTree.SubElement(group, "path", line)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"


def mm_per_px(reading: SheetReading) -> float | None:
    """The part's length of a px; None where the sheet does not tell, or nobody said."""
    scale = reading.scale
    if scale.source == "default":
        return None
    if scale.mm_per_px is not None:
        return scale.mm_per_px
    if scale.axis is None or scale.length_mm is None:
        return None
    extents = (
        side
        for view in reading.views
        if view.used
        for role in Role
        if role.value == view.role.value
        for (axis, _), side in (
            (role.frame.right_axis, view.box[2] - view.box[0]),
            (role.frame.up_axis, view.box[3] - view.box[1]),
        )
        if axis.name.lower() == scale.axis and side > 0.0
    )
    extent = next(extents, None)
    return None if extent is None else scale.length_mm / extent


def _sheet(reading: SheetReading) -> _Sheet:
    unit = mm_per_px(reading)
    views = tuple(_views(reading))
    return _Sheet(views, unit or 1.0, _size(reading)[1], unit is not None)


def _size(reading: SheetReading) -> tuple[float, float]:
    """px across and down the sheet."""
    if reading.sheet.size is not None:
        width, height = reading.sheet.size
        return float(width), float(height)
    far = [view.box[2:] for view in reading.views] or [(1.0, 1.0)]
    return max(pair[0] for pair in far), max(pair[1] for pair in far)


def _views(reading: SheetReading) -> Iterator[_View]:
    names: set[str] = set()
    shaped = [
        stroke for stroke in reading.strokes if stroke.kind in _LOOKS and len(points_of(stroke))
    ]
    owned = {
        view.id
        for view in reading.views
        if any(stroke_entry.view == view.id for stroke_entry in shaped)
    }
    for view in reading.views:
        strokes = tuple(
            stroke_entry
            for stroke_entry in shaped
            if view.id in owned and _is_of(stroke_entry, view)
        )
        if strokes:
            name = _name(view, names)
            names.add(name)
            yield _View(name, (view.box[0], view.box[3]), strokes)


def _is_of(stroke: StrokeEntry, view: ViewEntry) -> bool:
    if stroke.view is not None:
        return stroke.view == view.id
    x0, y0, x1, y1 = view.box
    low, high = points_of(stroke).min(axis=0), points_of(stroke).max(axis=0)
    x, y = (low + high) / 2.0
    return stroke.kind not in DRAWN and bool(x0 <= x <= x1 and y0 <= y <= y1)


def _name(view: ViewEntry, taken: set[str]) -> str:
    name = view.role.value.upper()
    number = 2
    while name in taken:
        name = f"{view.role.value.upper()}-{number}"
        number += 1
    return name


def _drawn(stroke: StrokeEntry, corner: tuple[float, float], unit: float) -> DxfEntity:
    """A stroke of a block whose origin is a corner; y runs up, and angles the other way."""

    def place(x: float, y: float) -> tuple[float, float]:
        return round(unit * (x - corner[0]), _DECIMALS), round(unit * (corner[1] - y), _DECIMALS)

    layer = _LOOKS[stroke.kind].layer
    if stroke.line is not None:
        first, last = (place(*end) for end in stroke.line)
        ends = *place_tags(*first), *place_tags(*last, 1)
        return DxfEntity("LINE", layer, ((100, "AcDbLine"), *ends))
    if stroke.arc is not None:
        x, y, radius, start, sweep = stroke.arc
        circle = (
            (100, "AcDbCircle"),
            *place_tags(*place(x, y)),
            (40, round(unit * radius, _DECIMALS)),
        )
        if sweep >= FULL_TURN - _WHOLE:
            return DxfEntity("CIRCLE", layer, circle)
        low, high = degrees(-start - sweep) % 360.0, degrees(-start) % 360.0
        return DxfEntity("ARC", layer, (*circle, (100, "AcDbArc"), (50, low), (51, high)))
    assert stroke.ellipse is not None
    x, y, major, minor, rotation, start, sweep = stroke.ellipse
    way = unit * major * cos(rotation), -unit * major * sin(rotation)
    low, high = -start - sweep, -start
    if sweep >= FULL_TURN - _WHOLE:
        low, high = 0.0, FULL_TURN
    sides = *place_tags(*place(x, y)), *place_tags(*way, 1), (40, minor / major)
    return DxfEntity("ELLIPSE", layer, ((100, "AcDbEllipse"), *sides, (41, low), (42, high)))


def _path(stroke: StrokeEntry, unit: float) -> str:
    """A stroke as SVG's path data."""
    points = unit * points_of(stroke)
    (x0, y0), (x1, y1) = points[0], points[-1]
    if stroke.line is not None:
        return f"M {_number(x0)} {_number(y0)} L {_number(x1)} {_number(y1)}"
    if stroke.arc is not None:
        radii, turned, sweep = (stroke.arc[2], stroke.arc[2]), 0.0, stroke.arc[4]
    else:
        assert stroke.ellipse is not None
        _, _, major, minor, turned, _, sweep = stroke.ellipse
        radii = major, minor
    shape = f"A {_number(unit * radii[0])} {_number(unit * radii[1])} {_number(degrees(turned))}"
    if hypot(x1 - x0, y1 - y0) < _WHOLE * unit or sweep >= FULL_TURN - _WHOLE:
        # A whole turn has no ends: SVG draws a little less than half of it, and then the rest.
        x, y = points[(len(points) - 1) // 2]
        less = f"{shape} 0 1 {_number(x)} {_number(y)}"
        return f"M {_number(x0)} {_number(y0)} {less} {shape} 1 1 {_number(x0)} {_number(y0)}"
    large = int(sweep > pi)
    return f"M {_number(x0)} {_number(y0)} {shape} {large} 1 {_number(x1)} {_number(y1)}"


def _number(value: float) -> str:
    return f"{round(float(value), _DECIMALS):g}" if abs(value) < 1e-4 else f"{value:.{_DECIMALS}f}"
