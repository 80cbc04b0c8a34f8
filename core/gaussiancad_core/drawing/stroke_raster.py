"""Strokes to pixels: every pixel gets the share of its surroundings that the stroke covers.

Pixel (column j, row i) covers ``[j, j + 1] x [i, i + 1]``, so its centre lies at .5.  A stroke is
filtered across and along with a tent two pixels wide and not with the pixel's own square: a tent
keeps the centre of mass of whatever it filters, so that a line's ink lies exactly where the line
does, while the square would move it by up to a sixteenth of a pixel.  Strokes unite (the larger
coverage wins), so that crossings are no darker than lines.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.dash_rhythm import dash_intervals
from gaussiancad_core.drawing.sheet_style import Cap, SheetStyle
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment

Coverage = npt.NDArray[np.float32]

_REACH = 1.5
"""Pixels beyond a stroke's border up to which centres are looked at."""

_CHORD = 0.01
"""Pixels beside an ellipse at which its chords may lie."""


def rasterise(strokes: tuple[DrawnStroke, ...], style: SheetStyle) -> Coverage:
    """(height, width) share of ink, 0 to 1, of strokes given in sheet pixels (y down)."""
    ink = np.zeros((style.height, style.width), dtype=np.float32)
    for stroke in strokes:
        if stroke.linetype is Linetype.VISIBLE:
            draw_stroke(ink, stroke, style.visible_width, style.cap)
        else:
            for piece in dashed(stroke, style):
                draw_stroke(ink, piece, style.hidden_width, Cap.BUTT)
    if not style.antialiasing:
        ink = (ink >= 0.5).astype(np.float32)
    return ink


def dashed(stroke: DrawnStroke, style: SheetStyle) -> list[DrawnStroke]:
    """The dashes of a hidden stroke as strokes in sheet pixels.

    The first and the last one reach half a line's width beyond the stroke's ends, so that hidden
    lines that meet at a corner fill it.
    """
    closed = stroke.is_closed
    dashes = dash_intervals(stroke.length, style.dash, style.gap, closed)
    if not closed:
        reach = style.hidden_width / 2.0
        dashes[0] = (dashes[0][0] - reach, dashes[0][1])
        dashes[-1] = (dashes[-1][0], dashes[-1][1] + reach)
    return [stroke.part(low, high) for low, high in dashes]


def draw_stroke(ink: Coverage, stroke: DrawnStroke, width: float, cap: Cap) -> None:
    """Draw a stroke without interruption into ``ink``, in place.

    Args:
        ink: (height, width) share of ink, 0 to 1.
        stroke: in sheet px.
        width: px.
        cap: of both ends.
    """
    if isinstance(stroke, Segment):
        ends = np.array([stroke.start, stroke.end])
        _draw_segment(ink, ends, width, (cap, cap))
    elif isinstance(stroke, Arc):
        _draw_arc(ink, stroke, width, cap)
    elif isinstance(stroke, Ellipse):
        _draw_chain(ink, stroke.chords(_CHORD), width, Cap.ROUND if stroke.is_closed else cap)
    else:
        _draw_chain(ink, np.array(stroke.points), width, Cap.ROUND if stroke.is_closed else cap)


def _draw_chain(ink: Coverage, points: npt.NDArray[np.float64], width: float, outer: Cap) -> None:
    last = len(points) - 2
    for index in range(last + 1):
        # Chords meet round, which leaves neither notch nor lighter joint.
        caps = (outer if index == 0 else Cap.ROUND, outer if index == last else Cap.ROUND)
        _draw_segment(ink, points[index : index + 2], width, caps)


def _window(
    ink: Coverage,
    low: npt.NDArray[np.float64],
    high: npt.NDArray[np.float64],
    reach: float,
) -> tuple[slice, slice, npt.NDArray[np.float64], npt.NDArray[np.float64]] | None:
    """Rows, columns, and the centres (x as a row, y as a column) of the pixels within reach."""
    height, width = ink.shape
    x0, y0 = (max(0, int(np.floor(value - reach))) for value in low)
    x1 = min(width, int(np.ceil(high[0] + reach)) + 1)
    y1 = min(height, int(np.ceil(high[1] + reach)) + 1)
    if x0 >= x1 or y0 >= y1:
        return None
    return (
        slice(y0, y1),
        slice(x0, x1),
        np.arange(x0, x1)[None, :] + 0.5,
        np.arange(y0, y1)[:, None] + 0.5,
    )


def _unite(ink: Coverage, rows: slice, columns: slice, coverage: npt.NDArray[np.float64]) -> None:
    area = ink[rows, columns]
    np.maximum(area, coverage.astype(np.float32), out=area)


def _draw_segment(
    ink: Coverage, ends: npt.NDArray[np.float64], width: float, caps: tuple[Cap, Cap]
) -> None:
    """Draw from ``ends[0]`` to ``ends[1]``, with a cap at each."""
    window = _window(ink, ends.min(axis=0), ends.max(axis=0), width / 2.0 + _REACH)
    if window is None:
        return
    rows, columns, x, y = window
    start, way = ends[0], ends[1] - ends[0]
    length = float(np.hypot(*way))
    direction = way / length if length > 0.0 else np.array([1.0, 0.0])
    along = (x - start[0]) * direction[0] + (y - start[1]) * direction[1]
    distance = np.abs((x - start[0]) * -direction[1] + (y - start[1]) * direction[0])
    share = np.ones_like(distance)
    for cap, inside in zip(caps, (along, length - along), strict=True):
        if cap is Cap.ROUND:
            distance = np.hypot(distance, np.minimum(inside, 0.0))
        else:
            share = share * _within(inside)
    _unite(ink, rows, columns, share * _band(distance, width / 2.0))


def _within(depth: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Share of a tent two pixels wide that lies on the ink's side of a border ``depth`` away."""
    inside = np.clip(depth, -1.0, 1.0)
    return 0.5 + inside - 0.5 * inside * np.abs(inside)


def _band(distance: npt.NDArray[np.float64], half: float) -> npt.NDArray[np.float64]:
    """The same for a band of half a width on both sides of a line ``distance`` away."""
    return _within(half - distance) + _within(half + distance) - 1.0


def _draw_arc(ink: Coverage, arc: Arc, width: float, cap: Cap) -> None:
    centre = np.array(arc.centre)
    window = _window(ink, centre - arc.radius, centre + arc.radius, width / 2.0 + _REACH)
    if window is None:
        return
    rows, columns, x, y = window
    dx, dy = x - centre[0], y - centre[1]
    radial = np.hypot(dx, dy)
    coverage = _band(radial - arc.radius, width / 2.0)
    if not arc.is_closed:
        # Signed length along the circle from the arc's middle, less half the arc's length.
        middle = arc.start_angle + arc.sweep / 2.0
        turn = np.mod(np.arctan2(dy, dx) - middle + np.pi, 2.0 * np.pi) - np.pi
        beyond = (np.abs(turn) - arc.sweep / 2.0) * arc.radius
        coverage = coverage * _within(-beyond)
    _unite(ink, rows, columns, coverage)
    if cap is Cap.ROUND and not arc.is_closed:
        for point in arc.extremes()[:2]:
            _draw_segment(ink, np.stack([point, point]), width, (Cap.ROUND, Cap.ROUND))
