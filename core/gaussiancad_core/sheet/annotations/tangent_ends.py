"""Extension lines that go on from an edge which ends where a rounding leaves it.

There the two are as wide together as the edge is, and farther out as wide apart: by its width the
extension line begins somewhere in between, and a sliver of it would stay beside the rounding.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.erase import Told, masked
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.shapes import refit_circle

_OFF, _FITTED = 1.0, 0.3
"""Distance of a line from a circle that it touches at most, in stroke widths: as it was found, and
fitted to what is drawn of it away from the line."""

_GOES_ON_PX = 1.0
"""px between an extension line and the edge that it goes on from at most."""

_SLACK_PX = 3.0
"""px by which the ink of a line and that of a circle seem to part later than they do."""

_FRINGE_PX = 0.75
"""px of pale ink beside a stroke."""


@dataclass(frozen=True)
class _Sliver:
    """What an extension line adds to the ink of an edge's rounding.

    Attributes:
        line: of both.
        start, end: px along it.
        circle: the rounding.
        width: px of its ink.
    """

    line: Line
    start: float
    end: float
    circle: Circle
    width: float


def without_slivers(part: CleanSheet, told: Told, sheet: CleanSheet) -> CleanSheet:
    """The part's ink without what extension lines leave of themselves beside roundings.

    Args:
        part: without what is told.
        told: lines and circles, cut where their width changes, and what each is.
        sheet: with all ink.
    """
    gone = np.zeros(part.ink.shape, bool)
    circles = [shape for shape in told.shapes if isinstance(shape.geometry, Circle)]
    for shape, own in zip(told.shapes, told.kinds, strict=True):
        if isinstance(shape.geometry, Line) and AnnotationKind.EXTENSION in own:
            for sliver in _slivers(shape, own, circles, sheet):
                _cover(sliver, gone, sheet.stroke_width)
    return masked(part, ~gone) if gone.any() else part


def _slivers(
    shape: InkedShape,
    own: Sequence[AnnotationKind | None],
    circles: Sequence[InkedShape],
    sheet: CleanSheet,
) -> Iterator[_Sliver]:
    for k in range(len(own) - 1):
        one, other = shape.runs[k], shape.runs[k + 1]
        if {own[k], own[k + 1]} != {None, AnnotationKind.EXTENSION}:
            continue
        if other.run.start - one.run.end > _GOES_ON_PX:
            continue
        way = 1.0 if own[k] is AnnotationKind.EXTENSION else -1.0
        border, edge = (one.run.end, other) if way > 0.0 else (other.run.start, one)
        for rounding in circles:
            found = _sliver(shape.geometry, (border, way), edge, rounding, sheet)
            if found is not None:
                yield found
                break


def _sliver(
    line: Line,
    onward: tuple[float, float],
    edge: InkedRun,
    rounding: InkedShape,
    sheet: CleanSheet,
) -> _Sliver | None:
    """What there is where a circle, drawn there, touches a line a little on from a border."""
    border, way = onward
    circle = rounding.geometry
    # Two strokes whose axes are as far apart as they are wide just touch.
    reach = float(np.sqrt(2.0 * circle.radius * sheet.stroke_width)) + _SLACK_PX
    if _touch(line, circle, onward, reach, _OFF * sheet.stroke_width) is None:
        return None
    # The arc leaves its tangent towards the extension line; near that its own ink is not known.
    spans = [(own.run.start + reach, own.run.end - reach) for own in rounding.runs]
    circle = refit_circle(sheet, circle, [span for span in spans if span[1] > span[0]])
    at = _touch(line, circle, onward, reach, _FITTED * sheet.stroke_width)
    if at is None or abs(at - border) > edge.run.length:
        return None
    out = np.array(line.at(at - way * reach)) - np.array(circle.centre)
    place = float(np.arctan2(out[1], out[0])) * circle.radius
    if not any((place - own.run.start) % circle.around <= own.run.length for own in rounding.runs):
        return None
    start, end = sorted((border - way * reach, at))
    return _Sliver(line, start, end, circle, edge.width or sheet.stroke_width)


def _touch(
    line: Line, circle: Circle, onward: tuple[float, float], reach: float, off: float
) -> float | None:
    """Where a circle touches a line not far on from a border, one way."""
    border, way = onward
    (along,), (across,) = line.coordinates(np.array([circle.centre]))
    touches = abs(abs(float(across)) - circle.radius) <= off
    return float(along) if touches and 0.0 < way * (float(along) - border) <= reach else None


def _cover(sliver: _Sliver, gone: Mask, stroke_width: float) -> None:
    """Mark the pixels about a line that are none of its circle's, in place."""
    ends = np.array([sliver.line.at(sliver.start), sliver.line.at(sliver.end)])
    low = np.maximum(np.floor(ends.min(axis=0) - stroke_width).astype(int), 0)
    high = np.ceil(ends.max(axis=0) + stroke_width).astype(int) + 1
    rows, columns = np.mgrid[low[1] : high[1], low[0] : high[0]]
    points = np.stack([columns.ravel(), rows.ravel()], axis=1).astype(float)
    along, across = sliver.line.coordinates(points)
    about = (np.abs(across) <= stroke_width) & (along >= sliver.start) & (along <= sliver.end)
    apart: npt.NDArray[np.float64] = np.hypot(*(points - np.array(sliver.circle.centre)).T)
    beside = np.abs(apart - sliver.circle.radius) > 0.5 * sliver.width + _FRINGE_PX
    pixels = points[about & beside].astype(int)
    inside = (pixels[:, 0] < gone.shape[1]) & (pixels[:, 1] < gone.shape[0])
    gone[pixels[inside, 1], pixels[inside, 0]] = True
