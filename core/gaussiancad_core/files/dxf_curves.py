"""Simple DXF entities as curves, seen from above: LINE, ARC, CIRCLE, ELLIPSE, SPLINE, faces."""

from collections.abc import Iterator, Sequence
from dataclasses import astuple

import numpy as np
import numpy.typing as npt
from ezdxf.entities import Hatch
from ezdxf.entities.arc import Arc
from ezdxf.entities.circle import Circle
from ezdxf.entities.dxfgfx import DXFGraphic
from ezdxf.entities.ellipse import Ellipse
from ezdxf.entities.line import Line as DxfLine
from ezdxf.entities.solid import Face3d, Solid
from ezdxf.entities.spline import Spline
from ezdxf.math import Vec3
from ezdxf.path import Path as BoundaryPath
from ezdxf.path import from_hatch
from ezdxf.render.hatching import HatchingError, hatch_entity

from gaussiancad_core.files.file_curves import affine_arc, polygon_curves
from gaussiancad_core.files.splines import Spline as PlaneSpline
from gaussiancad_core.files.splines import spline_curves
from gaussiancad_core.geometry.chains import Chain, LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.points import FULL_TURN, to_point

_FLATNESS = 5e-6
"""Share of a free curve's own size by which its chain may leave it."""


def entity_curves(entity: DXFGraphic) -> list[Curve]:
    """The curves of an entity in its drawing's units, y up; none if it has no size.

    Chains always follow smooth curves.

    Raises:
        NotImplementedError: of a kind that has no curves that are known.
        ValueError: a coordinate is no finite number.
        Exception: others of :data:`.BROKEN` over what is broken besides.
    """
    return _sized(_curves(entity))


def fill_outline(entity: DXFGraphic) -> list[Curve]:
    """The outline of a SOLID or TRACE entity.

    Raises:
        ValueError: a coordinate is no finite number.
    """
    corners = entity.wcs_vertices(close=True) if isinstance(entity, Solid) else []
    return _sized([Chain(tuple((p.x, p.y) for p in corners))] if len(corners) > 3 else [])


def hatch_outlines(hatch: Hatch) -> list[Curve]:
    """The outlines of a filled hatch.

    Raises:
        ValueError: a coordinate is no finite number.
    """
    loops = [np.array([(p.x, p.y) for p in _flattened(path)]) for path in from_hatch(hatch)]
    return _sized(
        [Chain(tuple(to_point(p) for p in (*loop, loop[0]))) for loop in loops if len(loop) > 2]
    )


def hatch_lines(hatch: Hatch) -> Iterator[Curve | None]:
    """The lines of a hatch's pattern; None at the end if it cannot be drawn whole."""
    if not Vec3(hatch.dxf.extrusion).isclose((0.0, 0.0, 1.0)):
        yield None
        return
    try:
        for start, end in hatch_entity(hatch):
            if not start.isclose(end):
                yield LineSegment((start.x, start.y), (end.x, end.y))
    except HatchingError:
        # The pattern is too dense, or the outline does not close.
        yield None


def _flattened(path: BoundaryPath) -> Iterator[Vec3]:
    corners = [Vec3(path.start), *path.control_vertices(), path.end]
    _check_finite(np.array([(corner.x, corner.y) for corner in corners]))
    size = max((corner - corners[0]).magnitude for corner in corners)
    return path.flattening(max(size, 1e-9) * _FLATNESS)


def _curves(entity: DXFGraphic) -> list[Curve]:
    if isinstance(entity, DxfLine):
        start, end = entity.dxf.start, entity.dxf.end
        return _polygon([start, end])
    if isinstance(entity, Circle):
        return [_circle(entity)]
    if isinstance(entity, Ellipse):
        low, high = float(entity.dxf.start_param), float(entity.dxf.end_param)
        return [
            affine_arc(
                _flat(entity.dxf.center),
                _flat(entity.dxf.major_axis),
                _flat(entity.minor_axis),
                low,
                _sweep(low, high),
            )
        ]
    if isinstance(entity, Spline):
        return _spline(entity)
    if isinstance(entity, Face3d):
        return _polygon(entity.wcs_vertices(close=True))
    raise NotImplementedError(entity.dxftype())


def _polygon(corners: Sequence[Vec3]) -> list[Curve]:
    points = np.array([(corner.x, corner.y) for corner in corners])
    _check_finite(points)
    return polygon_curves(points)


def _flat(value: Vec3) -> npt.NDArray[np.float64]:
    return np.array([value.x, value.y])


def _sweep(low: float, high: float) -> float:
    """From one angle on to the next, a whole turn where they are the same."""
    sweep = float(np.mod(high - low, FULL_TURN))
    return sweep if sweep > 1e-12 else FULL_TURN


def _circle(entity: Circle) -> Curve:
    """A circle or arc; one in a tilted plane is seen as an ellipse."""
    ocs = entity.ocs()
    radius = abs(float(entity.dxf.radius))
    centre = _flat(ocs.to_wcs(entity.dxf.center))
    u, v = (_flat(ocs.to_wcs(Vec3(axis))) * radius for axis in ((1, 0, 0), (0, 1, 0)))
    low, sweep = 0.0, FULL_TURN
    if isinstance(entity, Arc):
        low, high = np.radians(entity.dxf.start_angle), np.radians(entity.dxf.end_angle)
        sweep = _sweep(low, high)
    return affine_arc(centre, u, v, float(low), sweep)


def _spline(spline: Spline) -> list[Curve]:
    tool = spline.construction_tool()
    corners = np.array([(p.x, p.y) for p in tool.control_points])
    weights = np.array(tool.weights()) if tool.is_rational else None
    return spline_curves(PlaneSpline(corners, np.array(tool.knots()), tool.degree, weights))


def _sized(curves: Sequence[Curve]) -> list[Curve]:
    """Those of some curves that have a size."""
    sized = []
    for curve in curves:
        if isinstance(curve, LineSegment):
            points = np.array((curve.start, curve.end))
        elif isinstance(curve, Chain):
            points = np.array(curve.points)
        else:
            _check_finite(np.array(astuple(curve)[1:]))
            points = curve.vertices(np.inf)
        _check_finite(points)
        if np.ptp(points, axis=0).max() > 0.0:
            sized.append(curve)
    return sized


def _check_finite(points: npt.NDArray[np.float64]) -> None:
    """Refuse points of which a coordinate is no finite number."""
    if not np.isfinite(points).all():
        raise ValueError("a coordinate is no finite number")
