"""Strokes to pixels: every pixel gets the share of it that the stroke covers.

Pixel (column j, row i) covers ``[j, j + 1] x [i, i + 1]``, so its centre lies at .5.  The coverage
of a stroke of width w at distance d from a pixel's centre is ``clip(w / 2 + 1 / 2 - d, 0, 1)``:
exact for strokes along the axes, and for all others a filter that is symmetric about the centre
line, so that the line's centre of mass lies where the line does.  Strokes unite (the larger
coverage wins), so that crossings are no darker than lines.
"""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.dashes import dash_intervals
from gaussiancad_core.drawing.strokes import FULL_TURN, DrawnStroke, is_closed, part
from gaussiancad_core.drawing.style import Cap, SheetStyle
from gaussiancad_core.views import Arc, Linetype, Segment

Coverage = npt.NDArray[np.float32]


def rasterise(strokes: tuple[DrawnStroke, ...], style: SheetStyle) -> Coverage:
    """(height, width) share of ink, 0 to 1, of strokes given in sheet pixels (y down)."""
    ink = np.zeros((style.height, style.width), dtype=np.float32)
    for stroke in strokes:
        if stroke.linetype is Linetype.VISIBLE:
            _draw(ink, stroke, style.visible_width, style.cap)
        else:
            for piece in dashed(stroke, style):
                _draw(ink, piece, style.hidden_width, Cap.BUTT)
    if not style.antialiasing:
        ink = (ink >= 0.5).astype(np.float32)
    return ink


def dashed(stroke: DrawnStroke, style: SheetStyle) -> list[DrawnStroke]:
    """The dashes of a hidden stroke as strokes in sheet pixels.

    The first and the last one reach half a line's width beyond the stroke's ends, so that hidden
    lines that meet at a corner fill it.
    """
    closed = is_closed(stroke)
    dashes = dash_intervals(stroke.length, style.dash, style.gap, closed)
    if not closed:
        reach = style.hidden_width / 2.0
        dashes[0] = (dashes[0][0] - reach, dashes[0][1])
        dashes[-1] = (dashes[-1][0], dashes[-1][1] + reach)
    return [part(stroke, low, high) for low, high in dashes]


def _draw(ink: Coverage, stroke: DrawnStroke, width: float, cap: Cap) -> None:
    if isinstance(stroke, Segment):
        _draw_segment(ink, np.array(stroke.start), np.array(stroke.end), width, cap)
    elif isinstance(stroke, Arc):
        _draw_arc(ink, stroke, width, cap)
    else:
        _draw_chain(ink, np.array(stroke.points), width, cap)


def _draw_chain(ink: Coverage, points: npt.NDArray[np.float64], width: float, cap: Cap) -> None:
    """Chords meet at angles so small that their flat ends leave no notch: they overlap a little."""
    for index in range(len(points) - 1):
        start, end = points[index], points[index + 1]
        chord = end - start
        length = float(np.hypot(*chord))
        if length == 0.0:
            continue
        reach = 0.5 * chord / length
        before = start if index == 0 else start - reach
        after = end if index == len(points) - 2 else end + reach
        _draw_segment(ink, before, after, width, Cap.BUTT)
    if cap is Cap.ROUND:
        for point in (points[0], points[-1]):
            _draw_segment(ink, point, point, width, Cap.ROUND)


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
    ink: Coverage,
    start: npt.NDArray[np.float64],
    end: npt.NDArray[np.float64],
    width: float,
    cap: Cap,
) -> None:
    window = _window(ink, np.minimum(start, end), np.maximum(start, end), width / 2.0 + 1.0)
    if window is None:
        return
    rows, columns, x, y = window
    length = float(np.hypot(*(end - start)))
    direction = (end - start) / length if length > 0.0 else np.array([1.0, 0.0])
    along = (x - start[0]) * direction[0] + (y - start[1]) * direction[1]
    across = (x - start[0]) * -direction[1] + (y - start[1]) * direction[0]
    beyond = np.maximum(-along, along - length)
    if cap is Cap.ROUND:
        distance = np.hypot(across, np.maximum(beyond, 0.0))
        coverage = np.clip(width / 2.0 + 0.5 - distance, 0.0, 1.0)
    else:
        coverage = _band(across, width / 2.0) * np.clip(0.5 - beyond, 0.0, 1.0)
    _unite(ink, rows, columns, coverage)


def _band(distance: npt.NDArray[np.float64], half: float) -> npt.NDArray[np.float64]:
    """Share of a unit interval at ``distance`` from a band's middle that the band covers."""
    apart = np.abs(distance)
    return np.clip(np.minimum(half + 0.5 - apart, 2.0 * half), 0.0, 1.0)


def _draw_arc(ink: Coverage, arc: Arc, width: float, cap: Cap) -> None:
    centre = np.array(arc.centre)
    window = _window(ink, centre - arc.radius, centre + arc.radius, width / 2.0 + 1.0)
    if window is None:
        return
    rows, columns, x, y = window
    dx, dy = x - centre[0], y - centre[1]
    radial = np.hypot(dx, dy)
    coverage = _band(radial - arc.radius, width / 2.0)
    if arc.sweep < FULL_TURN:
        # Signed length along the circle from the arc's middle, less half the arc's length.
        middle = arc.start_angle + arc.sweep / 2.0
        turn = np.mod(np.arctan2(dy, dx) - middle + np.pi, 2.0 * np.pi) - np.pi
        beyond = (np.abs(turn) - arc.sweep / 2.0) * arc.radius
        coverage = coverage * np.clip(0.5 - beyond, 0.0, 1.0)
    _unite(ink, rows, columns, coverage)
    if cap is Cap.ROUND and arc.sweep < FULL_TURN:
        for angle in (arc.start_angle, arc.start_angle + arc.sweep):
            point = centre + arc.radius * np.array([np.cos(angle), np.sin(angle)])
            _draw_segment(ink, point, point, width, Cap.ROUND)
