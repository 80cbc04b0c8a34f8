"""A solid as triangles that know which surface they lie on: what lines of sight are sent through.

An exact solid and a mesh become the same.  Two faces on one plane, or on one cylinder, lie on one
surface; surfaces that pass smoothly into each other are one to the eye.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.GCPnts import GCPnts_TangentialDeflection
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import ShapeTable, faces_of, tessellate_faces
from gaussiancad_core.kernel.solid_edges import edge_facts
from gaussiancad_core.model.meshes import TriangleMesh

Floats = npt.NDArray[np.float64]
Numbers = npt.NDArray[np.int64]

_DEFLECTION = 1e-4
"""Distance of the triangles from their surface, as a share of the longest extent: a quarter of how
far beside a stroke the judge looks."""

_ANGLE = 0.2
"""Radians between neighbouring chords of a curve."""

_SAME = 2e-5
"""Share of the longest extent within which two faces lie on one surface."""

_FLAT = 0.44
"""Radians between two triangles of a mesh from which they lie on two surfaces: meshes of round
faces are rarely coarser than 16 sides."""


@dataclass(frozen=True, eq=False)
class FacetedSolid:
    """A solid as lines of sight meet it.

    Attributes:
        vertices: (n, 3) mm.
        triangles: (m, 3) indices of vertices.
        surfaces: (m,) number of the surface that a triangle lies on.
        smooth: (k,) of each surface, the number of the first of those that it passes into smoothly.
        sharp: (e, 2, 3) mm, ends of chords of the edges at which surfaces meet at an angle.
        edges: (e,) number of the edge that a chord belongs to.
    """

    vertices: Floats
    triangles: Numbers
    surfaces: Numbers
    smooth: Numbers
    sharp: Floats
    edges: Numbers

    @property
    def box(self) -> Floats:
        """(2, 3) mm, the least and the greatest coordinates."""
        return np.stack([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    @property
    def extent(self) -> Floats:
        """(3,) mm."""
        return np.ptp(self.vertices, axis=0)

    @property
    def is_closed(self) -> bool:
        """Whether triangles bound a body: along each side of one lies another."""
        sides = np.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        _, counts = np.unique(sides, axis=0, return_counts=True)
        return bool((counts % 2 == 0).all())

    def mapped(self, matrix: Floats, offset: Floats) -> "FacetedSolid":
        """The same with each point x at ``matrix @ x + offset``."""
        return replace(
            self,
            vertices=self.vertices @ matrix.T + offset,
            sharp=self.sharp @ matrix.T + offset,
        )


def faceted_shape(shape: TopoDS_Shape) -> FacetedSolid:
    """An exact solid, or several, as triangles; none of a shape without faces.

    Args:
        shape: mm; its stored triangulation is replaced.
    """
    faces = faces_of(shape)
    table = ShapeTable()
    for face in faces:
        table.number(face)
    vertices, triangles, numbers = tessellate_faces(shape, 1.0, 0.5)
    longest = float(np.ptp(vertices, axis=0).max()) if len(vertices) else 1.0
    vertices, triangles, numbers = tessellate_faces(shape, _DEFLECTION * longest, _ANGLE)
    surface_of = _surfaces(faces, _SAME * longest)
    joined = _Groups(int(surface_of.max()) + 1 if len(surface_of) else 0)
    chords, edges = [], []
    for number, facts in enumerate(edge_facts(shape)):
        if facts.smooth and len(facts.faces) == 2:
            joined.join(*(int(surface_of[table.number(face)]) for face in facts.faces))
        elif not facts.seam:
            points = _edge_points(facts.edge, _DEFLECTION * longest)
            chords.append(np.stack([points[:-1], points[1:]], axis=1))
            edges.append(np.full(len(points) - 1, number))
    return FacetedSolid(
        vertices,
        triangles,
        surface_of[numbers],
        joined.roots(),
        np.concatenate(chords) if chords else np.zeros((0, 2, 3)),
        np.concatenate(edges) if edges else np.zeros(0, int),
    )


def faceted_mesh(mesh: TriangleMesh) -> FacetedSolid:
    """A mesh whose triangles lie on one surface where they meet at little of an angle."""
    normals = mesh.area_vectors / np.maximum(mesh.areas, 1e-300)[:, None]
    pairs, ends = mesh.shared_edges
    cosines = np.einsum("ij,ij->i", normals[pairs[:, 0]], normals[pairs[:, 1]])
    joined = _Groups(len(mesh.triangles))
    is_flat = cosines > np.cos(_FLAT)
    for one, other in pairs[is_flat].tolist():
        joined.join(one, other)
    surfaces = np.unique(joined.roots(), return_inverse=True)[1].reshape(-1)
    sharp = mesh.vertices[ends[~is_flat]]
    return FacetedSolid(
        mesh.vertices,
        mesh.triangles,
        surfaces,
        np.arange(int(surfaces.max()) + 1 if len(surfaces) else 0),
        sharp,
        np.arange(len(sharp)),
    )


class _Groups:
    """Numbers that are joined to groups."""

    def __init__(self, count: int) -> None:
        self._parent = list(range(count))

    def root(self, number: int) -> int:
        """The least number of a group."""
        while self._parent[number] != number:
            number = self._parent[number]
        return number

    def join(self, one: int, other: int) -> None:
        """Make two groups one."""
        first, second = sorted((self.root(one), self.root(other)))
        self._parent[second] = first

    def roots(self) -> Numbers:
        """The root of each number."""
        return np.array([self.root(number) for number in range(len(self._parent))], dtype=np.int64)


def _surfaces(faces: Sequence[TopoDS_Face], same: float) -> Numbers:
    """(faces,) the number of the surface that each face lies on; ``same`` in mm."""
    known: dict[GeomAbs_SurfaceType, list[tuple[Floats, int]]] = {}
    numbers: list[int] = []
    count = 0
    for face in faces:
        kind, values = _described(face)
        found = next(
            (
                number
                for other, number in known.get(kind, ())
                if values is not None and np.abs(other - values).max() <= same
            ),
            None,
        )
        if found is None:
            found, count = count, count + 1
            if values is not None:
                known.setdefault(kind, []).append((values, found))
        numbers.append(found)
    return np.array(numbers, dtype=np.int64)


_UNIT = 100.0
"""mm for which a direction counts: two planes that lean by a micron over it are two."""


def _described(face: TopoDS_Face) -> tuple[GeomAbs_SurfaceType, Floats | None]:
    """The kind of a face's surface, and its values in mm; None where nothing equals it."""
    surface = BRepAdaptor_Surface(face)
    kind = surface.GetType()
    if kind == GeomAbs_SurfaceType.GeomAbs_Plane:
        plane = surface.Plane()
        way = _way(plane.Axis().Direction())
        return kind, np.array([*(_UNIT * way), float(way @ _point(plane.Location()))])
    if kind == GeomAbs_SurfaceType.GeomAbs_Cylinder:
        axis = surface.Cylinder().Axis()
        radius = surface.Cylinder().Radius()
    elif kind == GeomAbs_SurfaceType.GeomAbs_Cone:
        apex = surface.Cone().Apex()
        way = _way(surface.Cone().Axis().Direction())
        angle = abs(surface.Cone().SemiAngle())
        return kind, np.array([*(_UNIT * way), *_point(apex), _UNIT * angle])
    elif kind == GeomAbs_SurfaceType.GeomAbs_Sphere:
        ball = surface.Sphere()
        return kind, np.array([*_point(ball.Location()), ball.Radius()])
    elif kind == GeomAbs_SurfaceType.GeomAbs_Torus:
        torus = surface.Torus()
        way = _way(torus.Axis().Direction())
        radii = torus.MajorRadius(), torus.MinorRadius()
        return kind, np.array([*(_UNIT * way), *_point(torus.Location()), *radii])
    else:
        return kind, None
    way = _way(axis.Direction())
    point = _point(axis.Location())
    return kind, np.array([*(_UNIT * way), *(point - (point @ way) * way), radius])


def _way(direction: gp_Dir) -> Floats:
    """(3,) of a direction and its opposite, the one whose first component is positive."""
    way = np.array([direction.X(), direction.Y(), direction.Z()])
    first = way[np.abs(way) > 1e-9][0]
    return way if first > 0.0 else -way


def _point(point: gp_Pnt) -> Floats:
    return np.array([point.X(), point.Y(), point.Z()])


def _edge_points(edge: TopoDS_Edge, deflection: float) -> Floats:
    """(n, 3) points along an edge, from end to end; its chords are within mm of it."""
    curve = BRepAdaptor_Curve(edge)
    found = GCPnts_TangentialDeflection(curve, _ANGLE, deflection)
    return np.array([_point(found.Value(number + 1)) for number in range(found.NbPoints())])
