"""Vectors to pixels: curves are written as SVG and drawn by resvg, a strip of the sheet at a time.

A strip bounds the memory: resvg paints in four bytes a pixel and hands the picture over as PNG.
"""

from collections.abc import Iterable
from html import escape
from io import BytesIO
from typing import Any

import cv2
import numpy as np
import resvg_py
from PIL import Image

from gaussiancad_core.files.content import MOST_WORKED_ON, Grey
from gaussiancad_core.files.file_curves import STRAIGHT
from gaussiancad_core.files.fonts import known_font
from gaussiancad_core.files.vectors import (
    StrokeKind,
    StrokeRole,
    VectorDrawing,
    VectorStroke,
    VectorText,
)
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve

_DEFAULT_WIDTH = 2.0
"""px, of edges whose width the file does not say: a quarter of a millimetre at 200 dpi."""

_THINNEST = 1.4
"""px: thinner lines fade to grey.  Other lines than edges are as thin if the file does not say."""

_PARTS = (StrokeKind.GEOMETRY, StrokeKind.BLOCK)

_CELL = 64
"""px of the squares of a sheet that strokes are told apart by."""

_FINEST_DASH = 2.0
"""px: dashes and gaps that are shorter run together, and are drawn longer."""


_Block = tuple[int, int, int, int]
"""x0, y0, x1, y1 in px."""

_Strokes = tuple[VectorStroke, ...]


def render_svg(
    body: str, width: int, height: int, scale: float = 1.0, corner: tuple[int, int] = (0, 0)
) -> Grey:
    """(height, width) grey picture of SVG elements on white paper.

    Args:
        body: elements, in user units, the origin at the sheet's upper left corner.
        width, height: px.
        scale: px per user unit.
        corner: px from the sheet's upper left corner to the picture's.

    Raises:
        ValueError: resvg cannot draw them.
    """
    sheet = np.empty((height, width), dtype=np.uint8)
    rows = max(1, MOST_WORKED_ON // width)
    for top in range(0, height, rows):
        strip = sheet[top : top + rows]
        left, upper = corner[0] / scale, (corner[1] + top) / scale
        box = f"{left!r} {upper!r} {width / scale!r} {len(strip) / scale!r}"
        text = (
            '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
            f'width="{width}" height="{len(strip)}" viewBox="{box}" preserveAspectRatio="none">'
            f"{body}</svg>"
        )
        picture = resvg_py.svg_to_bytes(svg_string=text, background="#ffffff", **_font_options())
        with Image.open(BytesIO(bytes(picture)), formats=("PNG",)) as image:
            strip[:] = np.asarray(image.convert("L"))
    return sheet


def _font_options() -> dict[str, Any]:
    """Texts are drawn in one known font, whatever they ask for, and not at all without it."""
    font = known_font()
    if font is None:
        return {"skip_system_fonts": True}
    file, family = font
    families = ("font_family", "serif_family", "sans_serif_family", "monospace_family")
    return {"skip_system_fonts": True, "font_files": [file], **dict.fromkeys(families, family)}


def paint(drawing: VectorDrawing, width: int, height: int) -> Grey:
    """(height, width) grey picture of a drawing, black on white.

    Paper beyond what is drawn is not painted: pictures are packed and unpacked on their way.
    """
    sheet = np.full((height, width), 255, dtype=np.uint8)
    for (x0, y0, x1, y1), strokes in _blocks(drawing, width, height):
        parts = ['<g fill="none" stroke="#000" stroke-linecap="round" stroke-linejoin="round">']
        parts += [_element(stroke) for stroke in strokes]
        parts.append('</g><g font-family="sans-serif">')
        parts += [_text(text) for text in drawing.texts]
        parts.append("</g>")
        painted = render_svg("".join(parts), x1 - x0, y1 - y0, corner=(x0, y0))
        np.minimum(sheet[y0:y1, x0:x1], painted, out=sheet[y0:y1, x0:x1])
    return sheet


def _blocks(drawing: VectorDrawing, width: int, height: int) -> list[tuple[_Block, _Strokes]]:
    """Parts of a sheet that strokes apart from all others lie in, with these: what is painted.

    All of it is one where there are texts: their letters are as wide as a font makes them.
    """
    sheet = 0, 0, width, height
    strokes = drawing.strokes
    boxes = np.array([stroke.curve.box for stroke in strokes], dtype=float).reshape(-1, 4)
    if drawing.texts or not np.isfinite(boxes).all():
        return [(sheet, strokes)]
    # As far as the ends of the widest line reach, and the smooth edge around it.
    reach = 1.0 + max(_DEFAULT_WIDTH, *(stroke.width or 0.0 for stroke in strokes), 0.0)
    low = np.clip(np.floor(boxes[:, :2] - reach), 0, (width, height)).astype(int)
    high = np.clip(np.ceil(boxes[:, 2:] + reach), 0, (width, height)).astype(int)
    shown = np.flatnonzero((low < high).all(axis=1))
    if not len(shown):
        return []
    taken = np.zeros((height // _CELL + 1, width // _CELL + 1), np.uint8)
    for (x0, y0), (x1, y1) in zip(low[shown] // _CELL, (high[shown] - 1) // _CELL, strict=True):
        taken[y0 : y1 + 1, x0 : x1 + 1] = 1
    _, groups = cv2.connectedComponents(taken, connectivity=8)
    columns, rows = low[shown].T // _CELL
    of = groups[rows, columns]
    found = [
        ((*low[item].min(axis=0).tolist(), *high[item].max(axis=0).tolist()), item)
        for item in (shown[of == number] for number in np.unique(of))
    ]
    together = (*low[shown].min(axis=0).tolist(), *high[shown].max(axis=0).tolist())
    # A frame goes around all that lies apart from it.
    if sum(_area(block) for block, _ in found) >= _area(together):
        found = [(together, shown)]
    return [(block, tuple(strokes[number] for number in item)) for block, item in found]


def _area(block: _Block) -> int:
    return (block[2] - block[0]) * (block[3] - block[1])


def _element(stroke: VectorStroke) -> str:
    path = f'<path d="{_path(stroke.curve)}"'
    if stroke.kind is StrokeKind.FILL:
        return f'{path} fill="#000" stroke="none"/>'
    edge = stroke.role in (StrokeRole.VISIBLE, StrokeRole.UNKNOWN)
    default = _DEFAULT_WIDTH if edge and stroke.kind in _PARTS else _THINNEST
    width = default if stroke.width is None else max(stroke.width, _THINNEST)
    text = f'{path} stroke-width="{width:.3f}"'
    if stroke.dashes:
        lengths = " ".join(f"{value:.3f}" for value in _legible(stroke.dashes, width))
        text += f' stroke-linecap="butt" stroke-dasharray="{lengths}"'
    return text + "/>"


def _legible(dashes: tuple[float, ...], width: float) -> tuple[float, ...]:
    """Dashes stretched so far that the gaps show, with dots as long as the line is wide."""
    gaps = [gap for gap in dashes[1::2] if gap > 0.0]
    least = width + _FINEST_DASH
    factor = max(1.0, least / min(gaps)) if gaps else 1.0
    return tuple(max(value * factor, width) for value in dashes)


def _path(curve: Curve) -> str:
    """A curve in chords: resvg's own arcs lie a tenth of a pixel beside the circle."""
    if isinstance(curve, LineSegment):
        return _polygon((curve.start, curve.end))
    if isinstance(curve, Chain):
        points = np.array(curve.points)
    else:
        radius = curve.radius if isinstance(curve, CircularArc) else curve.semi_major
        points = curve.vertices(np.sqrt(8.0 * radius * STRAIGHT))
    return _polygon(points[:-1]) + "Z" if curve.is_closed else _polygon(points)


def _polygon(points: Iterable[tuple[float, float]]) -> str:
    return "M" + "L".join(f"{x:.5f} {y:.5f}" for x, y in points)


def _text(text: VectorText) -> str:
    """Text squeezed into its box; a turned one is as long as the box's diagonal at most."""
    x0, y0, x1, y1 = text.box
    centre = ((x0 + x1) / 2.0, (y0 + y1) / 2.0)
    length, height = unturned_size(text)
    return (
        f'<text transform="translate({centre[0]:.3f} {centre[1]:.3f}) '
        f'rotate({np.degrees(text.angle):.4f})" x="0" y="{0.36 * height:.3f}" '
        f'text-anchor="middle" font-size="{height:.3f}" textLength="{length:.3f}" '
        f'lengthAdjust="spacingAndGlyphs">{escape(_printable(text.text))}</text>'
    )


def unturned_size(text: VectorText) -> tuple[float, float]:
    """Length and height in px of a line of text before it was turned into its box."""
    width, height = text.box[2] - text.box[0], text.box[3] - text.box[1]
    c, s = abs(np.cos(text.angle)), abs(np.sin(text.angle))
    across = c * c - s * s
    if abs(across) < 0.2:
        # Near 45 degrees the box tells only the sum of both.
        total = (width + height) / (c + s)
        share = 1.0 / (1.0 + 0.6 * max(len(text.text), 1))
        return float(total * (1.0 - share)), float(total * share)
    return (
        float(max((width * c - height * s) / across, 1.0)),
        float(max((height * c - width * s) / across, 1.0)),
    )


def _printable(text: str) -> str:
    """Without the control characters that XML does not allow."""
    return "".join(char for char in text if char >= " " and char not in "\ufffe\uffff")
