"""How far the faces of a solid lie beside those of another one, face by face.

Points inside each face are taken to the nearest point of the other solid's whole surface: where a
plane or a cylinder was displaced, that is by how much; where a face is one that the other solid
does not have, it is by how much the shapes differ.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np
import numpy.typing as npt
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Pnt, gp_Pnt2d
from OCP.IntTools import IntTools_FClass2d
from OCP.TopAbs import TopAbs_State
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import area, faces_of, tessellate

POINTS = 20
"""Points of a face, as a rule."""

_TRIED = 2
"""Points that are tried for each of them."""

_DEFLECTION = 1e-3
"""Distance of the triangles that tell where a face is, as a share of the longest extent; points
are taken on the surface itself."""

_UV_TOLERANCE = 1e-7
"""Parameters of a surface within which a point is on a face's border."""

_ALONG = 1e-6
"""Components of a unit normal across an axis, at most, of planes across it."""

_KINDS = {
    GeomAbs_SurfaceType.GeomAbs_Plane: "plane",
    GeomAbs_SurfaceType.GeomAbs_Cylinder: "cylinder",
    GeomAbs_SurfaceType.GeomAbs_Cone: "cone",
    GeomAbs_SurfaceType.GeomAbs_Sphere: "sphere",
    GeomAbs_SurfaceType.GeomAbs_Torus: "torus",
}

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Displacement:
    """A face beside another solid's surface.

    Attributes:
        kind: of surface.
        axis: across which a plane lies, 0 to 2; None for all else.
        place: mm along that axis.
        area: mm2.
        median, largest: mm from the face's points to the other surface.
        shift: mm along the axis from the other surface to the plane, in the median; 0 for all else.
    """

    kind: str
    axis: int | None
    place: float
    area: float
    median: float
    largest: float
    shift: float


@dataclass(frozen=True)
class Displacements:
    """Two solids beside each other.

    Attributes:
        moved: of each face of the one.
        other: of each face of the other.
    """

    moved: tuple[Displacement, ...]
    other: tuple[Displacement, ...]

    @property
    def medians(self) -> Floats:
        """(n,) mm of the one's faces and the other's."""
        return np.array([face.median for face in (*self.moved, *self.other)])

    @property
    def farthest(self) -> float:
        """mm by which any point lies beside the other solid: a Hausdorff distance, by points."""
        return max(face.largest for face in (*self.moved, *self.other))

    def within(self, bound: float) -> float:
        """Share of all faces that are displaced by no more than ``bound`` mm."""
        return float((self.medians <= bound).mean())


def displacements(shape: TopoDS_Shape, truth: TopoDS_Shape, points: int = POINTS) -> Displacements:
    """Each face of two solids beside the other solid.

    Args:
        shape, truth: mm, in place.
        points: of each face.
    """
    one, other = _Faces(shape), _Faces(truth)
    return Displacements(one.offsets(other, points), other.offsets(one, points))


class _Faces:
    """The faces of a solid, and the boxes that they lie in."""

    def __init__(self, shape: TopoDS_Shape) -> None:
        extent = Bnd_Box()
        BRepBndLib.Add_s(shape, extent)
        tessellate(shape, _DEFLECTION * float(np.sqrt(extent.SquareExtent())))
        self._faces = faces_of(shape)
        self._boxes = np.array([_box(face) for face in self._faces]).reshape(-1, 2, 3)

    def offsets(self, other: "_Faces", points: int) -> tuple[Displacement, ...]:
        """Each face beside another solid's."""
        random = np.random.default_rng(0)
        return tuple(_displacement(face, other, points, random) for face in self._faces)

    def nearest(self, point: Floats) -> tuple[float, Floats]:
        """mm to the nearest point of all faces, and (3,) that point."""
        low, high = self._boxes[:, 0], self._boxes[:, 1]
        away = np.linalg.norm(np.maximum(low - point, 0.0) + np.maximum(point - high, 0.0), axis=1)
        vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*point.tolist())).Vertex()
        best, place = np.inf, point
        for number in np.argsort(away, kind="stable"):
            if away[number] >= best:
                break
            found = BRepExtrema_DistShapeShape(vertex, self._faces[number])
            if found.IsDone() and found.Value() < best:
                best, on = found.Value(), found.PointOnShape2(1)
                place = np.array([on.X(), on.Y(), on.Z()])
        return float(best), place


def _displacement(
    face: TopoDS_Face, other: _Faces, points: int, random: np.random.Generator
) -> Displacement:
    surface = BRepAdaptor_Surface(face)
    kind = _KINDS.get(surface.GetType(), "other")
    inside = points_inside(face, points, random)
    found = [other.nearest(point) for point in inside]
    distances = np.array([distance for distance, _ in found])
    axis = _axis_across(surface) if kind == "plane" else None
    if axis is None:
        place = shift = 0.0
    else:
        place = float(inside[0, axis])
        neighbours: Sequence[float] = [
            point[axis] - on[axis] for point, (_, on) in zip(inside, found, strict=True)
        ]
        shift = float(np.median(neighbours))
    return Displacement(
        kind,
        axis,
        place,
        area(face),
        float(np.median(distances)),
        float(distances.max()),
        shift,
    )


def points_inside(face: TopoDS_Face, count: int, random: np.random.Generator) -> Floats:
    """(n, 3) mm of up to ``count`` points on a face that has been triangulated, evenly by area.

    Triangles reach out of a face where its border is hollow: such points are left out.  There is
    one point at least, be it outside.
    """
    mesh = BRep_Tool.Triangulation_s(face, TopLoc_Location())
    indices = np.array([mesh.Triangle(n + 1).Get() for n in range(mesh.NbTriangles())]) - 1
    nodes = np.array([[*mesh.Node(n + 1).Coord()] for n in range(mesh.NbNodes())])
    flat = np.array([[*mesh.UVNode(n + 1).Coord()] for n in range(mesh.NbNodes())])
    corners = nodes[indices]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(normals, axis=1)
    tried = _TRIED * count
    chosen = random.choice(len(areas), tried, p=areas / areas.sum())
    # Even in a triangle: a parallelogram folded along its diagonal.
    one, two = random.random((2, tried))
    one, two = np.where(one + two > 1.0, [1.0 - one, 1.0 - two], [one, two])
    shares = np.stack([1.0 - one - two, one, two], axis=1)
    places = np.einsum("nk,nkd->nd", shares, flat[indices[chosen]]).tolist()
    border = IntTools_FClass2d(face, _UV_TOLERANCE)
    inside = (at for at in places if border.Perform(gp_Pnt2d(*at)) == TopAbs_State.TopAbs_IN)
    kept = list(islice(inside, count)) or places[:1]
    surface = BRepAdaptor_Surface(face)
    return np.array([[*surface.Value(u, v).Coord()] for u, v in kept])


def _box(face: TopoDS_Face) -> Floats:
    """(2, 3) mm of a box around a face."""
    box = Bnd_Box()
    BRepBndLib.Add_s(face, box, False)
    low, high = box.CornerMin(), box.CornerMax()
    return np.array([[*low.Coord()], [*high.Coord()]])


def _axis_across(surface: BRepAdaptor_Surface) -> int | None:
    """The axis that a plane lies across."""
    normal = np.abs(np.array([*surface.Plane().Axis().Direction().Coord()]))
    axis = int(normal.argmax())
    return axis if np.delete(normal, axis).max() <= _ALONG else None
