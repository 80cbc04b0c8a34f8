"""Curves in which surfaces meet, read from a picture as arcs and straight lines."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.point_chains import chain_distances, single_runs
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import moved_to_origin, soundness
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import box, cut, cylinder, fuse, revolved

_PIXEL = 0.06
"""mm."""

_FLAT = 0.6
"""px of rise below which a curve is read as a straight line."""


def _read(curve: DrawnStroke) -> list[DrawnStroke]:
    """Curves that are neither segments nor arcs as those through both ends and the middle.

    What runs out and back along one way is drawn once.
    """
    if isinstance(curve, Segment | Arc):
        return [curve]
    points = curve.sample(curve.length / 256.0)
    return [stroke for run in single_runs(points, 0.01) for stroke in _parts(np.array(run), curve)]


def _parts(points: np.ndarray, curve: DrawnStroke) -> list[DrawnStroke]:
    """As few halves, quarters and so on as follow points to a pixel."""
    fitted = _fitted(points, curve.linetype)
    off = chain_distances(fitted.sample(fitted.length / 256.0), points).max()
    if off < _PIXEL:
        return [fitted]
    half = len(points) // 2
    return [*_parts(points[: half + 1], curve), *_parts(points[half:], curve)]


def _fitted(points: np.ndarray, linetype: Linetype) -> DrawnStroke:
    """The arc, or line, through both ends and the middle of points."""
    (ax, ay), (bx, by), (cx, cy) = (points[k].tolist() for k in (0, len(points) // 2, -1))
    rise = abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / np.hypot(cx - ax, cy - ay)
    if rise < _FLAT * _PIXEL:
        return Segment((ax, ay), (cx, cy), linetype)
    rows = np.array([[bx - ax, by - ay], [cx - ax, cy - ay]])
    squares = np.array([bx**2 + by**2 - ax**2 - ay**2, cx**2 + cy**2 - ax**2 - ay**2])
    x, y = np.linalg.solve(2.0 * rows, squares)
    angles = np.arctan2([ay - y, by - y, cy - y], [ax - x, bx - x, cx - x])
    to_middle, to_end = (angles[1:] - angles[0]) % (2.0 * np.pi)
    start, sweep = angles[0], to_end
    if to_middle > to_end:
        start, sweep = angles[2], 2.0 * np.pi - to_end
    return Arc((x, y), float(np.hypot(ax - x, ay - y)), start, sweep, linetype)


def _rods() -> TopoDS_Shape:
    """A rod through a thicker one."""
    return fuse(cylinder(Axis.Z, (0, 0), 10, -30, 30), cylinder(Axis.X, (0, 0), 6, -30, 30))


def _open_bore() -> TopoDS_Shape:
    """A rod with half of a bore across its end."""
    return cut(cylinder(Axis.Z, (0, 0), 10, 0, 60), cylinder(Axis.X, (0, 60), 8, -30, 30))


def _cone() -> TopoDS_Shape:
    return revolved([(0, 0), (0, 20), (50, 8), (50, 0)], Axis.Z, (0, 0))


def _slotted_cone() -> TopoDS_Shape:
    return cut(_cone(), box((-3, -40, 30), (3, 40, 60)))


@pytest.mark.parametrize(
    ("part", "faces"),
    [(_rods, 7), (_open_bore, 5), (_slotted_cone, 7)],
)
def test_no_slivers_stay_between_a_curve_and_what_it_was_read_as(
    part: Callable[[], TopoDS_Shape],
    faces: int,
    drawn: Callable[[TopoDS_Shape], DrawnViews],
    iou: Callable[[TopoDS_Shape, TopoDS_Shape], float],
) -> None:
    solid = moved_to_origin(part())
    views = drawn(solid)
    strokes = {
        role: tuple(read for stroke in this_stroke for read in _read(stroke))
        for role, this_stroke in views.strokes.items()
    }
    assert strokes != dict(views.strokes)
    read = replace(views, strokes=strokes, tolerance=_PIXEL, apart=0.3 * _PIXEL)
    result = exact_solid(read)
    assert result.shape is not None
    assert result.status in (Status.VERIFIED, Status.APPROXIMATE)
    assert not {"lines-unexplained", "faces-thin"} & {code for code, _ in result.reasons}
    assert soundness(result.shape).faces == faces
    assert iou(result.shape, solid) > 0.9999
