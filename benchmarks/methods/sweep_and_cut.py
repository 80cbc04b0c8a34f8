"""A peer of the exact solid: the outlines' sweeps intersected, with the through features cut.

Each view's outline, with the through holes that hidden lines show (they are open in the masks), is
swept over the whole depth; what all sweeps have in common is the solid (Shum et al. 2001, the first
of their two stages).  It is a valid solid with planes and cylinders, but pockets, blind holes and
whatever no outline shows are filled.
"""

from dataclasses import replace

import numpy as np
from OCP.BOPAlgo import BOPAlgo_Builder
from OCP.BOPTools import BOPTools_AlgoTools3D
from OCP.BRep import BRep_Builder
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.collections import List_TopoDS_Shape
from OCP.gp import gp_Ax2, gp_Ax3, gp_Circ, gp_Dir, gp_Pln, gp_Pnt, gp_Pnt2d, gp_Vec
from OCP.IntTools import IntTools_Context
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Compound, TopoDS_Edge, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.coordinates.carriers import PartCarriers, find_carriers
from gaussiancad_core.evidence.drawn_views import views_as_read
from gaussiancad_core.geometry.whole_curves import Circle, LineOrCircle
from gaussiancad_core.kernel.brep import faces_of, soundness, subshapes, volume
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, UNITS, lifted, role_plane
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.solid.cell_outlines import Outline, outline_of, pieces_of, plane_grid

_MOST_STROKES = 500
"""Lines of a view up to which they are looked through for its outline."""

_FUZZY = 2e-5
"""Gap between an outline's ends that is closed, as a share of the longest extent."""

_FUZZY_COMMON = (0.0, 1e-6, 1e-5, 1e-4)
"""The same for faces of different sweeps; tried in turn until a sound solid comes out."""

_BEYOND = 0.1
"""By how much a plane reaches beyond the box, as a share of the longest extent."""

_LOOKS = 40
"""Lines of sight along the longest side of a plane that look whether the outline is filled."""

_FILLED = 0.99
"""Share of an outline that must be filled: views of which less is left contradict each other."""


def swept_solid(views: ViewSet, tolerance: float) -> TopoDS_Shape | None:
    """What the sweeps of all outlines have in common.

    Args:
        views: with masks whose through holes are open.
        tolerance: mm by which strokes may miss where they belong.

    Returns:
        One valid closed solid in mm that fills all outlines, or None if the sweeps have no such
        solid in common.
    """
    carriers = _supports(views, tolerance)
    outlines = {axis: outline_of(axis, carriers, views) for axis in Axis}
    try:
        sweeps = [_sweep(axis, outlines[axis], carriers) for axis in Axis]
    except (*KERNEL_FAILURES, RuntimeError):
        return None
    for fuzzy in _FUZZY_COMMON:
        solid = _largest_common(sweeps, fuzzy * max(views.size))
        if solid is None or not _is_sound(solid):
            continue
        if all(_fills(solid, axis, outlines[axis], carriers) for axis in Axis):
            return solid
    return None


def _supports(views: ViewSet, tolerance: float) -> PartCarriers:
    """The lines of the views, but for those of views that have too many.

    There are none at all where they contradict each other so much that they cannot be lined up.
    The outlines are those of the masks then.
    """
    drawn = views_as_read(views, tolerance)
    few = {
        role: stroke if len(stroke) <= _MOST_STROKES else ()
        for role, stroke in drawn.strokes.items()
    }
    try:
        return find_carriers(replace(drawn, strokes=few))
    except np.linalg.LinAlgError:
        pass
    scale = UNITS / max(views.size)
    x, y, z = (extent * scale for extent in views.size)
    return PartCarriers({}, {axis: () for axis in Axis}, (x, y, z), scale, tolerance * scale)


def _largest_common(sweeps: list[TopoDS_Shape], fuzzy: float) -> TopoDS_Shape | None:
    """The largest solid that all sweeps have in common; faces closer than ``fuzzy`` mm are one."""
    common = sweeps[0]
    try:
        for sweep in sweeps[1:]:
            operation = BRepAlgoAPI_Common()
            operation.SetArguments(_listed(common))
            operation.SetTools(_listed(sweep))
            operation.SetFuzzyValue(fuzzy)
            operation.Build()
            common = operation.Shape()
        solids = subshapes(common, TopAbs_ShapeEnum.TopAbs_SOLID)
        return _simplified(max(solids, key=volume)) if solids else None
    except (*KERNEL_FAILURES, RuntimeError):
        return None


def _listed(shape: TopoDS_Shape) -> List_TopoDS_Shape:
    shapes = List_TopoDS_Shape()
    shapes.Append(shape)
    return shapes


def _is_sound(solid: TopoDS_Shape) -> bool:
    facts = soundness(solid)
    return facts.valid and facts.closed and facts.solids == 1


def _sweep(axis: Axis, outline: Outline, carriers: PartCarriers) -> TopoDS_Shape:
    """Solids in mm over what an outline encloses, over the whole depth of the box."""
    builder, compound = BRep_Builder(), TopoDS_Compound()
    builder.MakeCompound(compound)
    along = gp_Vec(*lifted(axis, 0.0, 0.0, carriers.size[axis.value] / carriers.scale))
    for face in _faces(axis, outline, carriers):
        builder.Add(compound, BRepPrimAPI_MakePrism(face, along).Shape())
    return compound


def _faces(axis: Axis, outline: Outline, carriers: PartCarriers) -> list[TopoDS_Face]:
    """The covered parts of a plane at depth 0, which the outline's lines divide."""
    scale = carriers.scale
    longest = UNITS / scale
    first, second = (carriers.size[index] / scale for index in IN_PLANE[axis])
    beyond = _BEYOND * longest
    normal, right = _directions(axis)
    plane = gp_Pln(gp_Ax3(gp_Pnt(0.0, 0.0, 0.0), normal, right))
    # The plane's second axis runs against the model's where that makes it right-handed.
    ends = (-beyond, second + beyond) if axis is not Axis.Y else (-second - beyond, beyond)
    whole = BRepBuilderAPI_MakeFace(plane, -beyond, first + beyond, *ends).Face()
    fuse = BOPAlgo_Builder()
    fuse.AddArgument(whole)
    for index, low, high in pieces_of(outline.arrangement):
        curve = outline.arrangement.carriers[index].curve
        fuse.AddArgument(_edge(axis, curve, (low, high), scale))
    fuse.SetRunParallel(False)
    fuse.SetFuzzyValue(_FUZZY * longest)
    fuse.Perform()
    context = IntTools_Context()
    found = []
    for face in faces_of(fuse.Shape()):
        point, parameters = gp_Pnt(), gp_Pnt2d()
        if BOPTools_AlgoTools3D.PointInFace_s(face, point, parameters, context) != 0:
            continue
        place = (point.X(), point.Y(), point.Z())
        a, b = (place[index] * scale for index in IN_PLANE[axis])
        if outline.arrangement.locate(a, b) in outline.material:
            found.append(face)
    return found


def _directions(axis: Axis) -> tuple[gp_Dir, gp_Dir]:
    """A plane's normal, first axis times second, and its first axis."""
    first, second = (np.eye(3)[index] for index in IN_PLANE[axis])
    normal = np.cross(first, second) if axis is not Axis.Y else np.eye(3)[1]
    return gp_Dir(*map(float, normal)), gp_Dir(*map(float, first))


def _edge(axis: Axis, curve: LineOrCircle, ends: tuple[float, float], scale: float) -> TopoDS_Edge:
    """A piece of a curve at depth 0, mm."""
    if isinstance(curve, Circle):
        first, second = (np.eye(3)[index] for index in IN_PLANE[axis])
        centre = gp_Pnt(*lifted(axis, curve.centre[0] / scale, curve.centre[1] / scale, 0.0))
        # About first times second, so that angles run from the first axis to the second.
        normal = gp_Dir(*map(float, np.cross(first, second)))
        frame = gp_Ax2(centre, normal, gp_Dir(*map(float, first)))
        circle = gp_Circ(frame, curve.radius / scale)
        return BRepBuilderAPI_MakeEdge(circle, *ends).Edge()
    points = ((a / scale, b / scale) for a, b in (curve.at(end) for end in ends))
    return BRepBuilderAPI_MakeEdge(*(gp_Pnt(*lifted(axis, a, b, 0.0)) for a, b in points)).Edge()


def _simplified(solid: TopoDS_Shape) -> TopoDS_Shape:
    """The solid with as few faces as it can have, if that leaves it valid."""
    unify = ShapeUpgrade_UnifySameDomain(solid, True, True, False)
    unify.Build()
    solids = subshapes(unify.Shape(), TopAbs_ShapeEnum.TopAbs_SOLID)
    return solids[0] if len(solids) == 1 and soundness(solids[0]).valid else solid


def _fills(solid: TopoDS_Shape, axis: Axis, outline: Outline, carriers: PartCarriers) -> bool:
    """Whether there is material behind nearly all of an outline."""
    first, second = (carriers.size[index] for index in IN_PLANE[axis])
    covered = [
        (a, b)
        for a, b in plane_grid(first, second, UNITS / _LOOKS)
        if outline.arrangement.locate(float(a), float(b)) in outline.material
    ]
    if not covered:
        return False
    role = next(role for role in Role if role_plane(role).normal is axis)
    points = np.array(covered) / carriers.scale * np.array(role_plane(role).signs)
    sight = SolidRays(solid, role.frame, 1e-6 * UNITS / carriers.scale)
    filled = [len(column.depth) > 0 for column in sight.crossings_at(points)]
    return float(np.mean(filled)) >= _FILLED
