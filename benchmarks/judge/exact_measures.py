"""How close a solid is to the truth, by OpenCASCADE's Booleans and by those of meshes."""

from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
import numpy.typing as npt
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Trsf
from OCP.TopoDS import TopoDS_Shape
from scipy.spatial import cKDTree

from gaussiancad_core.comparison.sampling import random_streams, sample_surface
from gaussiancad_core.kernel.brep import (
    bounding_box,
    faces_of,
    moved_to_origin,
    soundness,
    tessellate,
    volume,
)
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

EXACT_IOU = 0.999
"""From here on a solid is the truth."""

_FINE = 2e-4
"""Distance of a mesh from its solid as a share of the longest extent."""

_AGREE = 3e-3
"""Difference of the two IoU up to which the Boolean of the solids is believed."""

_SAME_BOX = 0.02
"""Share of the longest extent by which boxes may differ to be compared at all."""

_SIGHT_LINES = 150
"""Lines of sight along each side of a box through which a volume is measured."""

_OFF_MIDDLE = 0.4567
"""Where they lie in their squares: not where edges of round measures do."""

_SURFACE_POINTS = 4000
"""Points on each of two surfaces that are compared where a mesh bounds no solid."""

Floats = npt.NDArray[np.float64]
Size = tuple[float, float, float]


@dataclass(frozen=True)
class Closeness:
    """A solid beside the truth.

    Attributes:
        valid: one valid closed solid of positive volume.
        iou: of volumes, by OpenCASCADE; by meshes where its Boolean is not plausible, or by lines
            of sight where a mesh bounds no solid.
        mesh_iou: by manifold3d; None where a mesh bounds no solid.
        faces, true_faces: numbers.
        placing: how the truth was turned, scaled or mirrored; empty where it was not.
    """

    valid: bool
    iou: float
    mesh_iou: float | None
    faces: int
    true_faces: int
    placing: str = ""

    @property
    def exact(self) -> bool:
        """Whether the solid is the truth."""
        return self.valid and self.iou >= EXACT_IOU


def closeness(shape: TopoDS_Shape, truth: TopoDS_Shape, placing: str = "") -> Closeness:
    """Compare two solids where they are."""
    facts = soundness(shape)
    valid = facts.valid and facts.closed and facts.solids == 1
    by_mesh = mesh_iou(fine_mesh(shape), fine_mesh(truth))
    by_solids = solid_iou(shape, truth) if facts.volume_mm3 > 0.0 else None
    neighbour = sight_iou(shape, truth) if by_mesh is None else by_mesh
    iou = neighbour if by_solids is None or abs(by_solids - neighbour) > _AGREE else by_solids
    true_faces = len(faces_of(truth))
    return Closeness(valid, iou, by_mesh, facts.faces, true_faces, placing)


def size_of(shape: TopoDS_Shape) -> Size:
    """The extents of a solid, mm."""
    x, y, z = (float(extent) for extent in np.ptp(bounding_box(shape), axis=0))
    return x, y, z


def closeness_at_one_size(
    shape: TopoDS_Shape, truth: TopoDS_Shape
) -> tuple[Closeness, TopoDS_Shape]:
    """Compare a solid with the truth at the solid's size, in the best of 24 orientations.

    Returns:
        how close it is, and the truth as it was placed.
    """
    fitted, _ = registered(fine_mesh(shape), truth, size_of(shape))
    return closeness(shape, fitted), fitted


def solid_iou(one: TopoDS_Shape, other: TopoDS_Shape) -> float | None:
    """Common volume by united volume, or nothing where the Boolean fails or cannot be true."""
    volumes = volume(one), volume(other)
    if min(volumes) <= 0.0:
        return None
    try:
        common = volume(BRepAlgoAPI_Common(one, other).Shape())
    except KERNEL_FAILURES:
        return None
    if not 0.0 <= common <= min(volumes) * (1.0 + 1e-6):
        return None
    return common / (sum(volumes) - common)


def fine_mesh(shape: TopoDS_Shape) -> TriangleMesh:
    """A mesh close enough to its solid to measure an IoU of .999."""
    extent = float(np.ptp(bounding_box(shape), axis=0).max())
    return make_mesh(*tessellate(shape, _FINE * extent, 0.1))


def mesh_iou(one: TriangleMesh, other: TriangleMesh) -> float | None:
    """Common volume by united volume, or nothing where a mesh bounds no solid."""
    import manifold3d

    solids = []
    for mesh in (one, other):
        solid = manifold3d.Manifold(
            manifold3d.Mesh64(mesh.vertices, mesh.triangles.astype(np.uint64))
        )
        if solid.status() != manifold3d.Error.NoError or solid.volume() <= 0.0:
            return None
        solids.append(solid)
    united = (solids[0] + solids[1]).volume()
    return float((solids[0] ^ solids[1]).volume() / united) if united > 0.0 else None


def sight_iou(one: TopoDS_Shape, other: TopoDS_Shape) -> float:
    """Common volume by united volume along lines of sight, which ask for no Boolean.

    Where a surface touches itself, a mesh bounds no solid, and Booleans with a solid that is
    nearly the same find nothing in common.
    """
    frame = Role.TOP.frame
    boxes = np.array([bounding_box(one), bounding_box(other)])
    low, high = boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)
    steps = (np.arange(_SIGHT_LINES) + _OFF_MIDDLE) / _SIGHT_LINES
    points = (
        low[:2] + np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2) * (high - low)[:2]
    )
    tolerance = _FINE * float((high - low).max())
    columns = [SolidRays(shape, frame, tolerance).crossings_at(points) for shape in (one, other)]
    common = united = 0.0
    for first, second in zip(*columns, strict=True):
        if first.sound and second.sound:
            depths = np.concatenate([first.depth, second.depth])
            entering = np.concatenate([_alternating(first.depth), _alternating(second.depth)])
            order = np.argsort(depths, kind="stable")
            inside = np.cumsum(entering[order])[:-1]
            lengths = np.diff(depths[order])
            common += float(lengths[inside == 2].sum())
            united += float(lengths[inside >= 1].sum())
    return common / united if united > 0.0 else 0.0


def _alternating(depths: Floats) -> npt.NDArray[np.int64]:
    """(k,) 1 where a line of sight enters, -1 where it leaves."""
    return 1 - 2 * (np.arange(len(depths)) % 2)


def surface_gap(one: TriangleMesh, other: TriangleMesh) -> float:
    """Mean distance in mm between points on two surfaces, both ways."""
    first, second = (
        sample_surface(mesh, _SURFACE_POINTS, random)
        for mesh, random in zip((one, other), random_streams(0, 2), strict=True)
    )
    there, back = cKDTree(second).query(first)[0], cKDTree(first).query(second)[0]
    return float(there.mean() + back.mean()) / 2.0


def mirrored_alike(shape: TopoDS_Shape, truth: TopoDS_Shape) -> str:
    """The axis along which the truth has to be mirrored to be the solid; empty if none."""
    mesh = fine_mesh(shape)
    for index, name in enumerate("xyz"):
        matrix = np.eye(3)
        matrix[index, index] = -1.0
        iou = mesh_iou(mesh, fine_mesh(placed(truth, matrix)))
        if iou is not None and iou >= EXACT_IOU:
            return name
    return ""


def placed(shape: TopoDS_Shape, matrix: Floats, scale: float = 1.0) -> TopoDS_Shape:
    """A copy turned or mirrored by a (3, 3) matrix of 0 and 1, scaled, and moved to the origin."""
    motion = gp_Trsf()
    rows = [(*(scale * row), 0.0) for row in matrix]
    motion.SetValues(*(float(value) for row in rows for value in row))
    return moved_to_origin(BRepBuilderAPI_Transform(shape, motion, True).Shape())


def rotations() -> list[Floats]:
    """The 24 rotations that take axes to axes, the identity first."""
    found = []
    for order in permutations(range(3)):
        for signs in product((1.0, -1.0), repeat=3):
            matrix = np.zeros((3, 3))
            matrix[range(3), order] = signs
            if np.linalg.det(matrix) > 0.0:
                found.append(matrix)
    return found


def registered(mesh: TriangleMesh, truth: TopoDS_Shape, size: Size) -> tuple[TopoDS_Shape, str]:
    """The truth scaled to a box and turned so that it is most like a mesh.

    Args:
        mesh: of what was made of the drawing.
        truth: in another scale, and perhaps along other axes.
        size: (3,) mm of the box that the drawing has.

    Returns:
        The truth in place, and how it was turned and scaled.
    """
    extents = np.ptp(bounding_box(truth), axis=0)
    scale = max(size) / float(extents.max())
    coarse = fine_mesh(truth)
    best, best_matrix = -1.0, np.eye(3)
    for matrix in rotations():
        turned = np.abs(matrix) @ extents * scale
        if np.abs(turned - np.array(size)).max() > _SAME_BOX * max(size):
            continue
        points = scale * coarse.vertices @ matrix.T
        moved = make_mesh(points - points.min(axis=0), coarse.triangles)
        likeness = mesh_iou(mesh, moved)
        # Faces that touch along a line leave a mesh that bounds no solid: its surface tells.
        likeness = 1.0 / (1.0 + surface_gap(mesh, moved)) if likeness is None else likeness
        if likeness > best:
            best, best_matrix = likeness, matrix
    return placed(truth, best_matrix, scale), f"{_name(best_matrix)} x{scale:.4g}"


def _name(matrix: Floats) -> str:
    """What the axes of the truth became, as in ``+x+z-y``."""
    return "".join(
        ("+" if row[np.abs(row).argmax()] > 0 else "-") + "xyz"[int(np.abs(row).argmax())]
        for row in matrix
    )
