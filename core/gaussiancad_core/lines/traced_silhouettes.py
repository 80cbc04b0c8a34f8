"""Silhouettes of spline surfaces, traced on a grid of their parameters.

Along a silhouette the surface's normal is at right angles to the look direction.  The zeros of that
product are found by marching squares on a grid, put onto the surface exactly by Newton steps, and
refined until their chords follow the curve.  OpenCASCADE's own tracer loses some of them.
"""

import itertools
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_Shape, GeomAbs_SurfaceType
from OCP.gp import gp_Pnt2d
from OCP.IntTools import IntTools_FClass2d
from OCP.TopAbs import TopAbs_State
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.geometry.level_lines import zero_lines
from gaussiancad_core.geometry.tolerances import COMPUTED
from gaussiancad_core.kernel.brep import faces_of
from gaussiancad_core.kernel.surface_crossings import normal_at
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.axes import ViewFrame
from gaussiancad_core.model.views import Linetype

Array = npt.NDArray[np.float64]

_ELEMENTARY = (
    GeomAbs_SurfaceType.GeomAbs_Plane,
    GeomAbs_SurfaceType.GeomAbs_Cylinder,
    GeomAbs_SurfaceType.GeomAbs_Cone,
    GeomAbs_SurfaceType.GeomAbs_Sphere,
    GeomAbs_SurfaceType.GeomAbs_Torus,
)
_NODES_PER_SPAN = 8
_FEWEST_NODES, _MOST_NODES = 16, 160
_NEWTON_STEPS = 4
_CLOSE = 1.0 / 64.0
_DEEPEST = 7
_UV_TOLERANCE = 1e-9


@dataclass(frozen=True)
class _Grid:
    """A spline face on a grid of its parameters.

    Attributes:
        surface: the face's surface.
        inside: tells which parameters lie on the face.
        us, vs: (m,) and (n,) parameters.
        normals: (m, n, 3) unit normals; NaN where there is none.
    """

    surface: BRepAdaptor_Surface
    inside: IntTools_FClass2d
    us: Array
    vs: Array
    normals: Array


@dataclass(frozen=True)
class _Tracer:
    """One face and the direction in which it is looked at.

    Attributes:
        surface: the face's surface.
        inside: tells which parameters lie on the face.
        look: (3,) unit vector.
        plane: (2, 3) right and up of the view.
    """

    surface: BRepAdaptor_Surface
    inside: IntTools_FClass2d
    look: Array
    plane: Array

    @property
    def spans(self) -> tuple[float, float]:
        return (
            self.surface.LastUParameter() - self.surface.FirstUParameter(),
            self.surface.LastVParameter() - self.surface.FirstVParameter(),
        )

    def facing(self, at: Array) -> float:
        """Cosine between the normal at (2,) parameters and the look direction."""
        return float(normal_at(self.surface, at[0], at[1]) @ self.look)

    def seen_at(self, at: Array) -> Array:
        """(2,) place in the view's plane."""
        point = self.surface.Value(float(at[0]), float(at[1]))
        return self.plane @ np.array([point.X(), point.Y(), point.Z()])

    def holds(self, at: Array) -> bool:
        """Whether (2,) parameters lie on the face."""
        state = self.inside.Perform(gp_Pnt2d(float(at[0]), float(at[1])), True)
        return state in (TopAbs_State.TopAbs_IN, TopAbs_State.TopAbs_ON)

    def settled(self, at: Array) -> Array:
        """Parameters moved onto the nearest zero of :meth:`facing`, if there is one close by."""
        steps = 1e-5 * np.array(self.spans)
        origin = at
        for _ in range(_NEWTON_STEPS):
            value = self.facing(at)
            slope = np.array(
                [(self.facing(at + step) - self.facing(at - step)) / 2.0 for step in np.diag(steps)]
            )
            # In units of the steps, so that both parameters count alike.
            square = float(slope @ slope)
            if not np.isfinite(value) or square < 1e-30:
                break
            at = at - value * slope / square * steps
        # Beside a pole, where one parameter hardly matters, the steps lead anywhere.
        return at if np.all(np.abs(at - origin) <= _CLOSE * np.array(self.spans)) else origin


class SplineSilhouettes:
    """The spline faces of a solid, whose normals are sampled once for all views.

    Args:
        shape: solid in mm.
    """

    def __init__(self, shape: TopoDS_Shape) -> None:
        self._grids = []
        for face in faces_of(shape):
            surface = BRepAdaptor_Surface(face)
            if surface.GetType() not in _ELEMENTARY:
                self._grids.append(_grid(face, surface))

    def view(self, frame: ViewFrame, chord: float) -> list[Polyline]:
        """The silhouettes inside the faces, in a view's plane.

        Args:
            frame: the view.
            chord: largest distance in mm between a silhouette and its chain.
        """
        look = np.array(frame.look, dtype=np.float64)
        plane = np.array([frame.right, frame.up], dtype=np.float64)
        return [
            chain
            for grid in self._grids
            for contour in _contours(grid, look)
            for chain in _chains(_Tracer(grid.surface, grid.inside, look, plane), contour, chord)
        ]


def _grid(face: TopoDS_Face, surface: BRepAdaptor_Surface) -> _Grid:
    us = np.linspace(
        surface.FirstUParameter(),
        surface.LastUParameter(),
        _nodes(surface.NbUIntervals(GeomAbs_Shape.GeomAbs_C2)),
    )
    vs = np.linspace(
        surface.FirstVParameter(),
        surface.LastVParameter(),
        _nodes(surface.NbVIntervals(GeomAbs_Shape.GeomAbs_C2)),
    )
    # At a pole there is no normal, but just beside it there is.
    centre = np.array([us.mean(), vs.mean()])
    normals = np.array(
        [
            [
                normal
                if np.isfinite(normal := normal_at(surface, u, v)).all()
                else normal_at(surface, *(np.array([u, v]) + COMPUTED * (centre - [u, v])))
                for v in vs
            ]
            for u in us
        ]
    )
    return _Grid(surface, IntTools_FClass2d(face, _UV_TOLERANCE), us, vs, normals)


def _contours(grid: _Grid, look: Array) -> list[Array]:
    """(n, 2) parameters along each zero of normal times look."""
    values = grid.normals @ look
    known = values[np.isfinite(values)]
    # Seen edge-on all over, a face shows its borders only.
    if not len(known) or np.abs(known).max() < COMPUTED:
        return []
    # Rounding must not change signs where part of a face is seen edge-on.
    values[np.abs(values) < COMPUTED**2] = COMPUTED**2
    return [
        np.stack(
            [
                np.interp(found[:, axis], np.arange(len(ticks)), ticks)
                for axis, ticks in enumerate((grid.us, grid.vs))
            ],
            axis=1,
        )
        for found in zero_lines(values)
    ]


def _nodes(spans: int) -> int:
    return int(np.clip(_NODES_PER_SPAN * spans, _FEWEST_NODES, _MOST_NODES))


def _chains(tracer: _Tracer, contour: Array, chord: float) -> list[Polyline]:
    """The parts of a contour that lie on the face, as fine chains."""
    places = [tracer.settled(at) for at in contour]
    runs: list[list[Array]] = []
    previous: Array | None = None
    was_inside = False
    for place in places:
        is_inside = tracer.holds(place)
        if is_inside and not was_inside:
            runs.append([] if previous is None else [_border(tracer, previous, place)])
        if is_inside:
            runs[-1].append(place)
        elif was_inside and previous is not None:
            runs[-1].append(_border(tracer, place, previous))
        previous, was_inside = place, is_inside
    return [
        Polyline(tuple((float(x), float(y)) for x, y in points), Linetype.VISIBLE)
        for run in runs
        if len(points := _refined(tracer, run, chord)) > 1
    ]


def _border(tracer: _Tracer, outside: Array, inside: Array) -> Array:
    """Where the way between two places crosses the face's border, on the silhouette."""
    for _ in range(16):
        middle = tracer.settled((outside + inside) / 2.0)
        if tracer.holds(middle):
            inside = middle
        else:
            outside = middle
    return inside


def _refined(tracer: _Tracer, run: list[Array], chord: float) -> list[Array]:
    """(2,) places in the plane, as many as the chord asks for, none twice in a row."""
    points = [tracer.seen_at(run[0])]

    def walk(start: Array, end: Array, depth: int) -> None:
        middle = tracer.settled((start + end) / 2.0)
        first, seen, last = (tracer.seen_at(place) for place in (start, middle, end))
        if depth and np.abs(seen - (first + last) / 2.0).max() > chord:
            walk(start, middle, depth - 1)
            walk(middle, end, depth - 1)
        elif np.abs(last - points[-1]).max() > 1e-3 * chord:
            points.append(last)

    for start, end in itertools.pairwise(run):
        walk(start, end, _DEEPEST)
    return points
