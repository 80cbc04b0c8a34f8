"""SVG files: drawn by resvg at 200 dpi of the drawing's size, and the exact curves of its shapes.

A size in px, or none but a view box, is taken as CSS does, 96 px an inch; what that is on paper is
then not known.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element, tostring

import numpy as np

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.files.content import (
    CSS_DPI,
    VECTOR_DPI,
    FileContent,
    Note,
    check_pixels,
    page_missing,
)
from gaussiancad_core.files.far_strokes import far_strokes_left_out, near_numbers
from gaussiancad_core.files.painting import paint, render_svg
from gaussiancad_core.files.shown import shown_strokes
from gaussiancad_core.files.sizing import Sizing, notes_on, paper_dpi, size_without_unit
from gaussiancad_core.files.svg_safety import SafeSvg, load_svg
from gaussiancad_core.files.svg_shapes import svg_elements, svg_strokes, svg_texts
from gaussiancad_core.files.vectors import VectorDrawing, VectorStroke
from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.geometry.points import Box
from gaussiancad_core.messages import Message
from gaussiancad_core.model.length_units import MM_PER_INCH
from gaussiancad_protocol.codes import Code

_PHYSICAL = {
    "mm": CSS_DPI / MM_PER_INCH,
    "cm": CSS_DPI / 2.54,
    "in": CSS_DPI,
    "pt": CSS_DPI / 72.0,
    "pc": CSS_DPI / 6.0,
    "q": CSS_DPI / 101.6,
}
"""CSS px."""

_MOST_BESIDE = 0.1
"""px by which lines may be drawn beside their places."""

_MARGIN = 0.05
"""Blank border before a drawing that has no size and begins beyond the origin, as a share of its
longest side."""

_RELATIVE = {"": 1.0, "px": 1.0, "em": 16.0, "ex": 8.0}

_LENGTH = re.compile(r"\s*([+]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-zA-Z]*)\s*$")


@dataclass(frozen=True)
class _Size:
    """Width and height in CSS px, and whether the file gives them in units of paper."""

    width: float
    height: float
    physical: bool


def read_svg(path: Path, page: int) -> FileContent:
    """Read an SVG file, plain or compressed.

    Raises:
        UnreadableError: ``damaged-svg``, ``svg-entities``, ``external-content``,
            ``empty-drawing``, ``page-missing``, ``image-too-large``, ``image-too-small``.
        LimitError: ``too-many-elements``, ``drawing-file-too-large``.
    """
    if page != 1:
        raise page_missing(path, 1, page)
    safe = load_svg(path)
    try:
        return _read_tree(path, safe)
    except UnreadableError:
        raise
    except (ValueError, TypeError, KeyError, IndexError, AttributeError, ArithmeticError) as error:
        # What svgelements and resvg raise on values that no drawing has.
        raise UnreadableError(
            Code.DAMAGED_SVG,
            "{path} cannot be drawn ({reason}): export the drawing again",
            path=path,
            reason=error,
        ) from error


def _read_tree(path: Path, safe: SafeSvg) -> FileContent:
    size, far = _size(safe.root), 0
    if size is None:
        size, far = _size_of_content(path, safe)
    if size.physical:
        inches = size.width / CSS_DPI, size.height / CSS_DPI
        check_pixels(path, *(side * VECTOR_DPI for side in inches))
        dpi = paper_dpi(*inches)
        sizing = Sizing(dpi / CSS_DPI, dpi, on_paper=True)
    else:
        sizing = size_without_unit(size.width, size.height, (1.0 / CSS_DPI,))
    scale = sizing.scale
    pixels = size.width * scale, size.height * scale
    check_pixels(path, *pixels)
    width, height = (int(np.ceil(side - 1e-3)) for side in pixels)
    _set_size(safe.root, size)
    # Parsing takes as long as all that follows: once.
    elements = svg_elements(safe.root)
    strokes, texts = svg_strokes(elements, scale), svg_texts(elements, scale)
    if safe.external and not (strokes or texts or safe.pictures):
        raise UnreadableError(
            Code.EXTERNAL_CONTENT,
            "{path} only refers to other files, which are never opened: embed the drawing in it",
            path=path,
        )
    if _is_far(safe.root, scale * size.width):
        grey = paint(VectorDrawing(tuple(strokes), tuple(texts)), width, height)
    else:
        grey = render_svg(tostring(safe.root, encoding="unicode"), width, height, scale)
    shown = shown_strokes(strokes, grey)
    if not (texts or safe.pictures) and _are_off(strokes, width, height):
        raise UnreadableError(
            Code.EMPTY_DRAWING,
            "{path} has {count} line(s), and none of them lies on its page: set its viewBox around "
            "the drawing, or export it again",
            path=path,
            count=len(strokes),
        )
    vectors = VectorDrawing(
        shown, tuple(texts), not safe.pictures, unit_px=None if sizing.pixels_per_inch else scale
    )
    notes = (*_notes(path, safe), *far_strokes_left_out(path, far), *notes_on(path, sizing))
    return FileContent(grey, sizing.pixels_per_inch, vectors if shown or texts else None, notes)


def _notes(path: Path, safe: SafeSvg) -> tuple[Note, ...]:
    notes = []
    if safe.external:
        notes.append(
            Note(
                Code.EXTERNAL_LEFT_OUT,
                Message(
                    "{name} refers to {count} other file(s), which are never opened: what they "
                    "hold is missing",
                    name=path.name,
                    count=safe.external,
                ),
            )
        )
    return tuple(notes)


def _length(text: str | None) -> tuple[float, bool] | None:
    """CSS px, and whether the unit is one of paper; None if not given, or in per cent."""
    match = _LENGTH.match(text or "")
    if not match:
        return None
    value, unit = float(match[1]), match[2].lower()
    if unit in _PHYSICAL:
        pixels = value * _PHYSICAL[unit]
    elif unit in _RELATIVE:
        pixels = value * _RELATIVE[unit]
    else:
        return None
    return (pixels, unit in _PHYSICAL) if 0.0 < pixels < 1e9 else None


def _view_box(root: Element) -> Box | None:
    """Corner, width and height of the root's view box."""
    try:
        x, y, width, height = (
            float(part) for part in (root.get("viewBox") or "").replace(",", " ").split()
        )
    except ValueError:
        return None
    return (x, y, width, height) if 0.0 < width < 1e9 and 0.0 < height < 1e9 else None


def _is_far(root: Element, width: float) -> bool:
    """Whether a page lies so far from the origin that resvg, which counts in single precision,
    would draw it beside its place.

    Args:
        root: with its view box, if any.
        width: of the page, px.
    """
    box = _view_box(root)
    if box is None:
        return False
    farthest = float(np.abs(box[:2]).max())
    return bool(farthest * np.finfo(np.float32).eps * width > _MOST_BESIDE * box[2])


def _are_off(strokes: Sequence[VectorStroke], width: int, height: int) -> bool:
    """Whether there are strokes, and all of them lie beside the page of so many px."""
    boxes = np.array([stroke.curve.box for stroke in strokes]).reshape(-1, 4)
    is_on = (boxes[:, 2:] >= 0.0).all(axis=1) & (boxes[:, :2] <= (width, height)).all(axis=1)
    return bool(len(boxes)) and not is_on.any()


def _size(root: Element) -> _Size | None:
    """The drawing's size; None if the file does not give it."""
    width, height = _length(root.get("width")), _length(root.get("height"))
    box = _view_box(root)
    if width and height:
        return _Size(width[0], height[0], width[1] and height[1])
    if box is None:
        return None
    if width:
        return _Size(width[0], width[0] * box[3] / box[2], width[1])
    if height:
        return _Size(height[0] * box[2] / box[3], height[0], height[1])
    return _Size(box[2], box[3], physical=False)


def _size_of_content(path: Path, safe: SafeSvg) -> tuple[_Size, int]:
    """The size that holds all shapes, with as much space after them as before, and how many strokes
    lie too far from all others to be among them.

    A drawing that does not begin near the origin gets a view box.
    """
    _set_size(safe.root, _Size(1e6, 1e6, physical=False))
    curves = [stroke.curve for stroke in svg_strokes(svg_elements(safe.root), 1.0)]
    near = [curves[number] for number in near_numbers(curves).tolist()]
    low, high = np.array(bounds(near) if near else (0.0,) * 4).reshape(2, 2)
    if not (high > low).any():
        raise UnreadableError(
            Code.EMPTY_DRAWING,
            "{path} has no lines and no size: export the drawing again",
            path=path,
        )
    longest = (high - low).max()
    space = np.where(low < 0.0, _MARGIN * longest, np.minimum(low, longest))
    x, y = (low - space).tolist()
    width, height = (high - low + 2.0 * space).tolist()
    if x or y:
        safe.root.set("viewBox", f"{x!r} {y!r} {width!r} {height!r}")
    return _Size(width, height, physical=False), len(curves) - len(near)


def _set_size(root: Element, size: _Size) -> None:
    """State the size in CSS px, which means the same at the root and inside another drawing."""
    root.set("width", repr(float(size.width)))
    root.set("height", repr(float(size.height)))
    for name in ("x", "y"):
        root.attrib.pop(name, None)
    # The sheet ends where the drawing does; a clip would cost more time than all of its lines.
    root.set("overflow", "visible")
