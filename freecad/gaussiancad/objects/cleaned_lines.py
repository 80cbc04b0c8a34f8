"""The cleaned lines of a ``reading.json``: each view's on its plane, in millimetres of the part.

Which lines go with a view, and how long a px is, is as in the engine's ``lines.dxf``; a test holds
the two together.  A sheet that lies turned is turned back.  Axes are those of :mod:`.placing`: the
part's box starts at the origin, and a line's two coordinates are the part's own along the view's
right and up, so that the views share their axes.
"""

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from freecad.gaussiancad.engine.report import ViewReport
from freecad.gaussiancad.engine.wording import worded
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.placing import (
    FRAMES,
    GAP_SHARE,
    Triple,
    part_size,
    plane_corner,
)
from freecad.gaussiancad.objects.plane_shapes import (
    Point,
    Shape,
    as_circle,
    box_of,
    on_plane,
    turned,
)

EDGES = ("visible",)
"""Kinds of strokes that become geometry."""

HELPERS = ("hidden", "centre", "tangent", "cut")
"""Kinds of strokes that become construction geometry."""

UNKNOWN_LENGTH_MM = 100.0
"""Longest extent of a part whose size the sheet does not tell, as the engine makes it."""

_DRAWN = ("visible", "hidden")
_SECTION = "section"
_BESIDE = "front"
"""The plane of sections of which nobody knows where they look."""

Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class CleanedView:
    """A view's lines on its plane.

    Attributes:
        role: of the principal view whose plane it is.
        section: the letters of a section, empty where it has none; None of a principal view.
        adjacent: whether it stands beside the part, as nobody knows where it looks.
        edges: what is visible, mm, y up.
        helpers: all other lines.
    """

    role: str
    section: str | None
    adjacent: bool
    edges: tuple[Shape, ...]
    helpers: tuple[Shape, ...]


@dataclass(frozen=True)
class CleanedSheet:
    """The lines of a sheet.

    Attributes:
        views: that have some.
        size: (x, y, z) extent of the part in mm; 0 along an axis that no view shows.
        mm_per_px: of the sheet as stored.
        knows_size: whether the sheet tells it, or a person did.
        doubts: what is in doubt with what was read, in the user's words.
    """

    views: tuple[CleanedView, ...]
    size: Triple
    mm_per_px: float
    knows_size: bool
    doubts: tuple[str, ...] = ()

    @property
    def roles(self) -> set[str]:
        """Roles of the views, and where the sections look."""
        return {view.role for view in self.views if not view.adjacent}

    @property
    def count(self) -> int:
        """Number of all lines."""
        return sum(len(view.edges) + len(view.helpers) for view in self.views)


@dataclass(frozen=True)
class _Found:
    """A view of the reading with its strokes, upright px."""

    entry: dict[str, Any]
    role: str
    strokes: tuple[tuple[str, Shape], ...]
    box: Box


def read_cleaned(path: Path) -> CleanedSheet:
    """The lines in a ``reading.json``.

    Raises:
        WorkbenchError: the file cannot be read, or no view has lines.
    """
    try:
        sheet = cleaned_sheet(json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError, TypeError, LookupError, AttributeError) as error:
        text = translate(
            "GaussianCAD",
            "What was read of the drawing, {path}, cannot be used ({reason}). Read the drawing "
            "again; if that does not help, choose GaussianCAD > Check Engine.",
        )
        raise WorkbenchError(
            ErrorCode.RESULT_UNREADABLE, text.format(path=path, reason=error)
        ) from error
    if not sheet.views:
        raise WorkbenchError(ErrorCode.NO_VIEWS, worded("no-views", ""))
    return sheet


def cleaned_sheet(reading: dict[str, Any]) -> CleanedSheet:
    """The lines in a reading's JSON."""
    found = _with_strokes(reading)
    known = mm_per_px(reading)
    unit = known or _assumed_mm_per_px(found)
    size = part_size((ViewReport(item.role, item.box, {}) for item in found), unit)
    views = tuple(_placed(found, reading, unit, size))
    doubts = (*_own_doubts(known is not None, views), *_doubts(reading))
    return CleanedSheet(views, size, unit, known is not None, doubts)


def mm_per_px(reading: dict[str, Any]) -> float | None:
    """The part's length of a px; None where the sheet does not tell, or nobody said."""
    scale = reading.get("scale", {})
    if scale.get("source", "default") == "default":
        return None
    if scale.get("mm_per_px") is not None:
        return float(scale["mm_per_px"])
    axis, length = scale.get("axis"), scale.get("length_mm")
    if axis is None or length is None:
        return None
    views = [item for item in reading.get("views", ()) if item.get("used", True)]
    size = part_size((ViewReport(view["role"], tuple(view["box"]), {}) for view in views), 1.0)
    extent = size["xyz".index(axis)]
    return float(length) / extent if extent > 0.0 else None


def _assumed_mm_per_px(found: list[_Found]) -> float:
    longest = max(
        part_size((ViewReport(item.role, item.box, {}) for item in found), 1.0), default=0.0
    )
    if not longest:
        sides = [max(x1 - x0, y1 - y0) for x0, y0, x1, y1 in (item.box for item in found)]
        longest = max(sides, default=0.0)
    return UNKNOWN_LENGTH_MM / longest if longest > 0.0 else 1.0


def _with_strokes(reading: dict[str, Any]) -> list[_Found]:
    """Principal views, then sections, each with the lines that are its."""
    angle = -float(reading["sheet"].get("turn", 0.0))
    names = ("line", "arc", "ellipse")
    shaped = [
        (item, (name, _tuples(item[name])))
        for item in reading.get("strokes", ())
        for name in names
        if item.get("kind") in (*EDGES, *HELPERS) and item.get(name) is not None
    ]
    found = []
    for view in reading.get("views", ()):
        mine = [(item, shape) for item, shape in shaped if _is_of(item, shape, view)]
        role, is_section = view["role"], view["role"] == _SECTION
        if not any(item.get("view") == view["id"] for item, _ in mine):
            continue
        if not is_section and (role not in FRAMES or not view.get("used", True)):
            continue
        strokes = tuple((item["kind"], turned(shape, angle)) for item, shape in mine)
        looks = view.get("looks") or "" if is_section else role
        found.append(_Found(view, looks, strokes, _extent(strokes)))
    # The part's size is told by the principal views, where there are any.
    return sorted(found, key=lambda item: item.entry["role"] == _SECTION)


def _is_of(stroke: dict[str, Any], shape: Shape, view: dict[str, Any]) -> bool:
    if stroke.get("view") is not None:
        return stroke["view"] == view["id"]
    x0, y0, x1, y1 = view["box"]
    left, top, right, bottom = box_of(shape)
    x, y = (left + right) / 2.0, (top + bottom) / 2.0
    return stroke["kind"] not in _DRAWN and x0 <= x <= x1 and y0 <= y <= y1


def _extent(strokes: Iterable[tuple[str, Shape]]) -> Box:
    """The box around the lines of the part, or around all where there is none of these."""
    strokes = tuple(strokes)
    drawn = [shape for kind, shape in strokes if kind in _DRAWN]
    boxes = [box_of(item) for item in drawn or [shape for _, shape in strokes]]
    return (
        min(box[0] for box in boxes),
        min(box[1] for box in boxes),
        max(box[2] for box in boxes),
        max(box[3] for box in boxes),
    )


def _placed(
    found: list[_Found], reading: dict[str, Any], unit: float, size: Triple
) -> Iterator[CleanedView]:
    right = size[0]
    for item in found:
        x0, y0, x1, y1 = item.box
        is_section, neighbour = item.entry["role"] == _SECTION, item.role not in FRAMES
        at = (0.0, 0.0) if neighbour else plane_corner(item.role, size)
        if neighbour:
            gap = GAP_SHARE * (max(size) or unit * max(x1 - x0, y1 - y0))
            at = (right + gap, 0.0)
            right = at[0] + unit * (x1 - x0)
        yield CleanedView(
            _BESIDE if neighbour else item.role,
            _letters(item.entry, reading) if is_section else None,
            neighbour,
            _on_plane(item, EDGES, unit, at),
            _on_plane(item, HELPERS, unit, at),
        )


def _on_plane(found: _Found, kinds: tuple[str, ...], unit: float, at: Point) -> tuple[Shape, ...]:
    corner = found.box[0], found.box[3]
    return tuple(
        as_circle(on_plane(shape, corner, unit, at))
        for kind, shape in found.strokes
        if kind in kinds
    )


def _letters(view: dict[str, Any], reading: dict[str, Any]) -> str:
    """The letters that the sheet gives a section."""
    x0, y0, x1, y1 = view["box"]
    for item in reading.get("sections", ()):
        left, top, right, bottom = item["box"]
        if x0 <= (left + right) / 2.0 <= x1 and y0 <= (top + bottom) / 2.0 <= y1:
            return str(item["label"])
    return ""


def _own_doubts(knows_size: bool, views: Iterable[CleanedView]) -> Iterator[str]:
    if not knows_size:
        yield translate(
            "GaussianCAD",
            "The size is not known: the longest extent of the part was made 100 mm. Tell a length "
            "in Correct Sheet (key M).",
        )
    if any(view.adjacent for view in views):
        yield translate(
            "GaussianCAD",
            "It is not known where a section looks: it stands beside the front view.",
        )


def _doubts(reading: dict[str, Any]) -> Iterator[str]:
    """What the engine found to be in doubt, each once; the unknown size is told already."""
    wordeds = (
        worded(item["code"], item["message"], item.get("args"))
        for item in reading.get("problems", ())
        if item["code"] != "scale-assumed"
    )
    yield from dict.fromkeys(wordeds)


def _tuples(numbers: list) -> tuple:
    return tuple(tuple(number) if isinstance(number, list) else number for number in numbers)
