"""Exact solids: what they consist of, their measures, whether they are sound, their triangles.

Shapes are OpenCASCADE's ``TopoDS_Shape`` in millimetres.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Builder, BRep_Tool
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.BRepTools import BRepTools
from OCP.gp import gp_Trsf, gp_Vec
from OCP.GProp import GProp_GProps
from OCP.IMeshTools import IMeshTools_Parameters
from OCP.Message import Message_ProgressRange
from OCP.TopAbs import TopAbs_Orientation, TopAbs_ShapeEnum
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS, TopoDS_Compound, TopoDS_Edge, TopoDS_Face, TopoDS_Shape


@dataclass(frozen=True)
class Soundness:
    """What is known about a shape as a solid.

    Attributes:
        valid: OpenCASCADE's own check finds nothing, and the volume is positive.
        closed: every edge bounds exactly two face sides, so no shell has a border.
        solids: number of solids.
        faces: number of distinct faces.
        volume_mm3: enclosed volume.
    """

    valid: bool
    closed: bool
    solids: int
    faces: int
    volume_mm3: float


def compound_of(shapes: Sequence[TopoDS_Shape]) -> TopoDS_Compound:
    """Shapes as one."""
    builder, compound = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(compound)
    for shape in shapes:
        builder.Add(compound, shape)
    return compound


class ShapeTable:
    """Numbers sub-shapes so that both orientations of one entity get the same number."""

    def __init__(self) -> None:
        self.shapes: list[TopoDS_Shape] = []
        self._numbers: dict[int, list[int]] = {}

    def number(self, shape: TopoDS_Shape) -> int:
        """The number of an entity, counted from 0; an unknown one is added."""
        # Shapes have a hash but compare by identity in Python, so a plain dict does not do.
        bucket = self._numbers.setdefault(hash(shape), [])
        for number in bucket:
            if self.shapes[number].IsSame(shape):
                return number
        bucket.append(len(self.shapes))
        self.shapes.append(shape)
        return bucket[-1]


def explore(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> Iterator[TopoDS_Shape]:
    """All occurrences of sub-shapes of a kind; shared ones come once a use."""
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def subshapes(shape: TopoDS_Shape, kind: TopAbs_ShapeEnum) -> list[TopoDS_Shape]:
    """The distinct sub-shapes of a kind, in the order of OpenCASCADE's explorer."""
    table = ShapeTable()
    for current in explore(shape, kind):
        table.number(current)
    return table.shapes


def faces_of(shape: TopoDS_Shape) -> list[TopoDS_Face]:
    """The distinct faces."""
    return [TopoDS.Face(face) for face in subshapes(shape, TopAbs_ShapeEnum.TopAbs_FACE)]


def edges_of(shape: TopoDS_Shape) -> list[TopoDS_Edge]:
    """The distinct edges, degenerated ones (a cone's apex) included."""
    return [TopoDS.Edge(edge) for edge in subshapes(shape, TopAbs_ShapeEnum.TopAbs_EDGE)]


def bounding_box(shape: TopoDS_Shape) -> npt.NDArray[np.float64]:
    """(2, 3) lower and upper corner in mm, exact to about 1e-7 and without tolerances added."""
    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape, box, False, False)
    box.SetGap(0.0)
    lower, upper = box.CornerMin(), box.CornerMax()
    return np.array([[lower.X(), lower.Y(), lower.Z()], [upper.X(), upper.Y(), upper.Z()]])


def moved_to_origin(shape: TopoDS_Shape) -> TopoDS_Shape:
    """A copy whose bounding box starts at the origin; the shape itself where it does already."""
    lower, upper = bounding_box(shape)
    if np.abs(lower).max() <= 1e-7 * float((upper - lower).max()):
        return shape
    motion = gp_Trsf()
    motion.SetTranslation(gp_Vec(*(-float(value) for value in lower)))
    return BRepBuilderAPI_Transform(shape, motion, True).Shape()


def volume(shape: TopoDS_Shape) -> float:
    """Enclosed volume in mm3; negative where the faces point inwards."""
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties)
    return float(properties.Mass())


_VOLUME_ERROR = 1e-7
"""Share of a volume that integrating it face by face may miss at most: a tenth of what solids may
differ by."""


def exact_volume(shape: TopoDS_Shape) -> float:
    """The same as :func:`volume`, integrated until its error is small.

    The plain integral takes as many points of a face as its surface asks for; where the edges of
    the face are curves of another kind it may miss a thousandth of the volume.
    """
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties, _VOLUME_ERROR, False, False)
    return float(properties.Mass())


def area(shape: TopoDS_Shape) -> float:
    """Area of all faces in mm2."""
    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(shape, properties)
    return float(properties.Mass())


def edge_length(edge: TopoDS_Shape) -> float:
    """Length of an edge, or of all edges of a shape, in mm; seams count twice."""
    properties = GProp_GProps()
    BRepGProp.LinearProperties_s(edge, properties)
    return float(properties.Mass())


def is_valid(shape: TopoDS_Shape) -> bool:
    """Whether the kernel finds nothing wrong with a shape; an empty one is none."""
    return not shape.IsNull() and bool(BRepCheck_Analyzer(shape).IsValid())


def soundness(shape: TopoDS_Shape) -> Soundness:
    """Check a shape as a solid."""
    enclosed = volume(shape)
    return Soundness(
        is_valid(shape) and enclosed > 0.0,
        _closed(shape),
        len(subshapes(shape, TopAbs_ShapeEnum.TopAbs_SOLID)),
        len(faces_of(shape)),
        enclosed,
    )


def _closed(shape: TopoDS_Shape) -> bool:
    table = ShapeTable()
    sides: list[int] = []
    for face in faces_of(shape):
        for edge in explore(face, TopAbs_ShapeEnum.TopAbs_EDGE):
            if not BRep_Tool.Degenerated_s(TopoDS.Edge(edge)):
                sides.append(table.number(edge))
    # Where bodies touch along an edge it has four sides, which is still closed.
    return bool(sides) and bool(np.all(np.bincount(sides) % 2 == 0))


def tessellate(
    shape: TopoDS_Shape, deflection: float, angle: float = 0.3, *, strict: bool = False
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """Triangles of a shape.

    The triangulation that OpenCASCADE stores on the faces is replaced.

    Args:
        shape: the solid.
        deflection: largest distance in mm between a triangle and its surface.
        angle: largest angle in radians between neighbouring chords of a curve.
        strict: whether free-form faces keep the deflection away from their edges, too, which
            OpenCASCADE exceeds several times else; costs twice the triangles.

    Returns:
        (n, 3) vertices in mm, shared between faces, and (m, 3) indices, counter-clockwise seen from
        outside.
    """
    return tessellate_faces(shape, deflection, angle, strict=strict)[:2]


def tessellate_faces(
    shape: TopoDS_Shape, deflection: float, angle: float = 0.3, *, strict: bool = False
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    """The same as of :func:`tessellate`, and (m,) the number of each triangle's face in the order
    of :func:`faces_of`."""
    BRepTools.Clean_s(shape)
    parameters = IMeshTools_Parameters()
    parameters.Deflection, parameters.Angle = deflection, angle
    parameters.ForceFaceDeflection = strict
    BRepMesh_IncrementalMesh(shape, parameters, Message_ProgressRange())
    points: list[npt.NDArray[np.float64]] = []
    triangles: list[npt.NDArray[np.int64]] = []
    offset = 0
    for face in faces_of(shape):
        values, indices = _face_triangles(face)
        points.append(values)
        triangles.append(indices + offset)
        offset += len(values)
    numbers = np.repeat(np.arange(len(triangles)), [len(each) for each in triangles])
    stacked = np.concatenate(points) if points else np.zeros((0, 3))
    # Neighbouring faces sample their common edge at the very same points.
    vertices, inverse = np.unique(np.round(stacked, 9), axis=0, return_inverse=True)
    faces = inverse.reshape(-1)[np.concatenate(triangles)] if triangles else np.zeros((0, 3), int)
    distinct = (
        (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 0] != faces[:, 2])
    )
    return vertices, faces[distinct].astype(np.int64), numbers[distinct]


def _face_triangles(
    face: TopoDS_Face,
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    location = TopLoc_Location()
    mesh = BRep_Tool.Triangulation_s(face, location)
    if mesh is None:
        return np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64)
    motion = location.Transformation()
    points = np.empty((mesh.NbNodes(), 3))
    for index in range(mesh.NbNodes()):
        point = mesh.Node(index + 1).Transformed(motion)
        points[index] = point.X(), point.Y(), point.Z()
    indices = np.array(
        [mesh.Triangle(index + 1).Get() for index in range(mesh.NbTriangles())],
        dtype=np.int64,
    ).reshape(-1, 3)
    if face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED:
        indices = indices[:, ::-1]
    return points, indices - 1
