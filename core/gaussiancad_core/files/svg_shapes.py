"""The shapes of an SVG tree as exact curves, through svgelements' styles and transforms."""

from collections.abc import Iterator, Sequence
from functools import partial
from io import BytesIO
from xml.etree.ElementTree import Element, tostring

import numpy as np
import numpy.typing as npt
import svgelements

from gaussiancad_core.files.beziers import curves_from_path
from gaussiancad_core.files.content import CSS_DPI, PAPER_LEVEL
from gaussiancad_core.files.file_curves import affine_arc
from gaussiancad_core.files.file_grid import WrittenPath, line_ends, with_steps
from gaussiancad_core.files.file_linetypes import role_by_dashes, role_by_name
from gaussiancad_core.files.vectors import StrokeKind, StrokeRole, VectorStroke, VectorText
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN, to_point

_LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"

_SAME_ARC = 1e-3
"""Share of the radius within which the centres and sizes of two arcs are the same."""

_LETTER_WIDTH = 0.55
_ASCENT, _DESCENT = 0.75, 0.2
"""Over the font's size, for boxes of text."""


SvgElements = Sequence[svgelements.SVGElement]


def svg_strokes(elements: SvgElements, scale: float) -> list[VectorStroke]:
    """Stroked and filled shapes.

    Args:
        elements: of an SVG tree.
        scale: sheet px per CSS px.
    """
    shapes = (element for element in elements if isinstance(element, svgelements.Shape))
    return list(with_steps([_path(shape, scale) for shape in shapes if _is_visible(shape)]))


def _path(shape: svgelements.Shape, scale: float) -> WrittenPath:
    rounds = svgelements.Circle | svgelements.Ellipse
    drawn = _is_painted(shape.stroke) and not isinstance(shape, rounds)
    lines = [
        piece
        for segment in (_segments(shape) if drawn else ())
        if isinstance(segment, svgelements.Line | svgelements.Close)
        and (piece := _piece(segment, np.eye(2, 3))) is not None
    ]
    strokes = partial(_shape_strokes, shape, scale)
    return WrittenPath(strokes, line_ends(lines), _matrix(shape, scale))


def svg_texts(elements: SvgElements, scale: float) -> list[VectorText]:
    """Lines of text, their boxes estimated from the font's size."""
    return [
        text
        for item in elements
        if isinstance(item, svgelements.Text) and _is_visible(item)
        for text in _text(item, scale)
    ]


def svg_elements(root: Element) -> SvgElements:
    """All elements of an SVG tree with its ``width`` and ``height`` in CSS px, styles and matrices
    resolved."""
    tree = svgelements.SVG.parse(
        BytesIO(tostring(root, encoding="utf-8")), reify=False, ppi=CSS_DPI
    )
    return list(tree.elements()) if isinstance(tree, svgelements.SVG) else []


def _is_visible(item: svgelements.SVGElement) -> bool:
    return item.values.get("visibility", "visible") not in ("hidden", "collapse")


def _matrix(item: svgelements.Transformable, scale: float) -> npt.NDArray[np.float64]:
    """(2, 3) from the item's own coordinates to sheet px."""
    m = item.transform
    return scale * np.array([[m.a, m.c, m.e], [m.b, m.d, m.f]], dtype=np.float64)


def _shape_strokes(shape: svgelements.Shape, scale: float, step: float) -> list[VectorStroke]:
    """What a shape draws, px of the sheet.

    Args:
        shape: with its style and matrix.
        scale: sheet px per CSS px.
        step: px to which its places were rounded.
    """
    matrix = _matrix(shape, scale)
    layer = str(shape.values.get(_LABEL, ""))
    if _is_painted(shape.stroke):
        growth = float(np.sqrt(abs(np.linalg.det(matrix[:, :2]))))
        if shape.values.get("vector-effect") == "non-scaling-stroke":
            growth = scale
        width = _number(shape.stroke_width, 1.0) * growth
        dashes = tuple(value * growth for value in _dashes(shape))
        names = (layer, shape.values.get("class", ""), shape.values.get("id", ""))
        named = next((role for name in names if (role := role_by_name(str(name or "")))), None)
        role = role_by_dashes(dashes) if dashes else named or StrokeRole.UNKNOWN
        colour = _channels(shape.stroke)
        return [
            VectorStroke(curve, width, dashes, role, layer, colour=colour)
            for curve in _curves(shape, matrix, step)
        ]
    if _is_painted(shape.fill) and min(_channels(shape.fill)) < PAPER_LEVEL:
        return [
            VectorStroke(
                outline, None, (), StrokeRole.UNKNOWN, layer, StrokeKind.FILL, _channels(shape.fill)
            )
            for outline in _outlines(shape, matrix, step)
        ]
    return []


def _is_painted(colour: svgelements.Color | None) -> bool:
    return colour is not None and colour.value is not None and colour.alpha != 0


def _channels(colour: svgelements.Color) -> tuple[int, int, int]:
    return colour.red, colour.green, colour.blue


def _number(value: object, default: float) -> float:
    try:
        number = float(svgelements.Length(value).value(ppi=CSS_DPI))
    except (TypeError, ValueError):
        return default
    return number if np.isfinite(number) else default


def _dashes(shape: svgelements.Shape) -> list[float]:
    text = str(shape.values.get("stroke-dasharray") or "none")
    if text.strip().lower() in ("none", "inherit", ""):
        return []
    lengths = [_number(part, -1.0) for part in text.replace(",", " ").split()]
    if any(length < 0.0 for length in lengths) or sum(lengths) <= 0.0:
        return []
    if len(lengths) % 2:
        # SVG 2, 13.5.6: an odd list is gone through twice.
        lengths += lengths
    return lengths if sum(lengths[1::2]) > 0.0 else []


def _curves(shape: svgelements.Shape, matrix: npt.NDArray[np.float64], step: float) -> list[Curve]:
    if isinstance(shape, svgelements.Circle | svgelements.Ellipse):
        centre = np.array([_number(shape.cx, 0.0), _number(shape.cy, 0.0)])
        axes = np.diag([_number(shape.rx, 0.0), _number(shape.ry, 0.0)])
        if axes.min(initial=np.inf, where=np.eye(2, dtype=bool)) <= 0.0:
            return []
        return [_mapped_arc(matrix, centre, axes, 0.0, FULL_TURN)]
    curves: list[Curve] = []
    run: list[npt.NDArray[np.float64]] = []
    arcs: list[svgelements.Arc] = []
    for segment in _segments(shape):
        is_arc = isinstance(segment, svgelements.Arc) and min(segment.rx, segment.ry) > 0.0
        if arcs and not (is_arc and _continues(arcs[-1], segment)):
            curves.append(_joined_arc(arcs, matrix))
            arcs = []
        if is_arc:
            curves += curves_from_path(run, step)
            run = []
            arcs.append(segment)
            continue
        piece = _piece(segment, matrix)
        if piece is None:
            curves += curves_from_path(run, step)
            run = []
        else:
            run.append(piece)
    if arcs:
        curves.append(_joined_arc(arcs, matrix))
    return curves + curves_from_path(run, step)


def _segments(shape: svgelements.Shape) -> list[svgelements.PathSegment]:
    return [segment for segment in shape.segments(transformed=False) if segment.end is not None]


def _piece(
    segment: svgelements.PathSegment, matrix: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64] | None:
    """Two or four points in sheet px; None where the pen is lifted."""
    if isinstance(segment, svgelements.Move) or segment.start is None:
        return None
    if isinstance(segment, svgelements.CubicBezier):
        points = [segment.start, segment.control1, segment.control2, segment.end]
    elif isinstance(segment, svgelements.QuadraticBezier):
        start, control, end = (
            np.array([p.x, p.y]) for p in (segment.start, segment.control, segment.end)
        )
        cubic = np.array([start, (start + 2 * control) / 3, (end + 2 * control) / 3, end])
        return cubic @ matrix[:, :2].T + matrix[:, 2]
    else:
        points = [segment.start, segment.end]
    return np.array([(p.x, p.y) for p in points]) @ matrix[:, :2].T + matrix[:, 2]


def _continues(last: svgelements.Arc, arc: svgelements.Arc) -> bool:
    """Whether two arcs are one curve."""
    tolerance = _SAME_ARC * max(last.rx, last.ry)
    apart = abs(complex(last.center) - complex(arc.center))
    turned = abs(np.sin(float(last.get_rotation()) - float(arc.get_rotation())))
    same_axes = abs(last.rx - last.ry) <= tolerance or turned <= _SAME_ARC
    return bool(
        apart <= tolerance
        and abs(last.rx - arc.rx) <= tolerance
        and abs(last.ry - arc.ry) <= tolerance
        and same_axes
        and last.sweep * arc.sweep > 0.0
    )


def _joined_arc(arcs: list[svgelements.Arc], matrix: npt.NDArray[np.float64]) -> Curve:
    """One curve for arcs that continue each other."""
    first = arcs[0]
    centre = np.mean([(arc.center.x, arc.center.y) for arc in arcs], axis=0)
    axes = np.array(
        [
            (first.prx.x - first.center.x, first.prx.y - first.center.y),
            (first.pry.x - first.center.x, first.pry.y - first.center.y),
        ]
    )
    sweep = sum(float(arc.sweep) for arc in arcs)
    if abs(complex(arcs[-1].end) - complex(first.start)) <= _SAME_ARC * min(first.rx, first.ry):
        sweep = np.copysign(FULL_TURN, sweep)
    return _mapped_arc(matrix, centre, axes, float(first.get_start_t()), float(sweep))


def _mapped_arc(
    matrix: npt.NDArray[np.float64],
    centre: npt.NDArray[np.float64],
    axes: npt.NDArray[np.float64],
    start: float,
    sweep: float,
) -> Curve:
    linear = matrix[:, :2]
    return affine_arc(
        linear @ centre + matrix[:, 2], linear @ axes[0], linear @ axes[1], start, sweep
    )


def _outlines(
    shape: svgelements.Shape, matrix: npt.NDArray[np.float64], step: float
) -> list[Curve]:
    """The closed chains around a filled area."""
    loops: list[list[tuple[float, float]]] = [[]]
    for curve in _curves(shape, matrix, step):
        # Straight pieces need no points between their ends.
        apart = np.inf if isinstance(curve, LineSegment) else 2.0
        points = curve.points if isinstance(curve, Chain) else curve.vertices(apart)
        if loops[-1] and np.hypot(*(np.array(points[0]) - loops[-1][-1])) > 1e-6:
            loops.append([])
        loops[-1] += [to_point(point) for point in np.asarray(points)]
    return [Chain((*loop, loop[0])) for loop in loops if len(loop) > 2]


def _text(item: svgelements.Text, scale: float) -> Iterator[VectorText]:
    content = (item.text or "").strip()
    size = _number(item.values.get("font-size", item.font_size), 16.0)
    if not content or size <= 0.0:
        return
    matrix = _matrix(item, scale)
    length = _LETTER_WIDTH * size * len(content)
    anchor = {"middle": 0.5, "end": 1.0}.get(str(item.values.get("text-anchor")), 0.0)
    x, y = _number(item.x, 0.0) - anchor * length, _number(item.y, 0.0)
    x, y = (x + _number(item.values.get("dx"), 0.0), y + _number(item.values.get("dy"), 0.0))
    low, high = y - _ASCENT * size, y + _DESCENT * size
    corners = np.array([(x, low), (x + length, low), (x + length, high), (x, high)])
    mapped = corners @ matrix[:, :2].T + matrix[:, 2]
    (x0, y0), (x1, y1) = mapped.min(axis=0), mapped.max(axis=0)
    box = (float(x0), float(y0), float(x1), float(y1))
    yield VectorText(content, box, float(np.arctan2(matrix[1, 0], matrix[0, 0])))
