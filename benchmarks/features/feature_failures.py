"""Why features do not make up a solid: which mechanism fails, and at which faces."""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.gp import gp_Pnt
from OCP.TopoDS import TopoDS_Shape
from ortools.sat.python import cp_model

from gaussiancad_core.features.blends import blends_of
from gaussiancad_core.features.body_cover import Choice, offered
from gaussiancad_core.features.decomposing import Decomposition, decomposed
from gaussiancad_core.features.defeaturing import without_faces, without_holes
from gaussiancad_core.features.difference import Difference, difference
from gaussiancad_core.features.dressing import breaks_of, dressed
from gaussiancad_core.features.drilling import body_of_holes
from gaussiancad_core.features.feature_building import combined
from gaussiancad_core.features.feature_model import EdgeBreak, Holes
from gaussiancad_core.features.frames import MAIN_FRAMES, Frame, frame_across
from gaussiancad_core.features.inside_rays import Rays
from gaussiancad_core.features.prisms import prism_plane, prisms_of
from gaussiancad_core.features.sample_points import Samples, joined
from gaussiancad_core.features.solid_faces import Kind, SolidFace, solid_faces
from gaussiancad_core.features.turned_bodies import turned_planes, turned_sweeps
from gaussiancad_core.features.unit_scaling import scaled_shape
from gaussiancad_core.kernel.booleans import without
from gaussiancad_core.kernel.brep import bounding_box, edges_of
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.projection_planes import UNITS

Points = npt.NDArray[np.float64]

_PARALLEL = 1e-6
_MOST_POINTS = 40
"""Points whose nearest face is looked for."""

_EFFORT = 10.0
"""Deterministic seconds of the solver."""


@dataclass(frozen=True)
class Reason:
    """Why a solid is not made of features.

    Attributes:
        cause: the mechanism, one word or two.
        details: counts by what they count: kinds of faces, and what was left.
        share: volume by which the best try differs, of the solid's; None without a try.
    """

    cause: str
    details: dict[str, int]
    share: float | None = None


def reason_of(shape: TopoDS_Shape) -> Reason:
    """The first mechanism that fails for a solid without holes and edge breaks."""
    box = bounding_box(shape)
    solid = scaled_shape(shape, UNITS / float((box[1] - box[0]).max()))
    reach = 4.0 * float(np.abs(bounding_box(solid)).max() + 1.0)
    filled, holes = without_holes(solid, reach)
    groups = blends_of(filled, solid_faces(filled))
    body, kept = without_faces(filled, [[blend.face for blend in group] for group in groups])
    faces = solid_faces(body)
    left = _blends_left(groups, kept)
    free = Counter(_surface(face) for face in faces if face.kind is Kind.OTHER)
    if free:
        return Reason("free-form faces", {**free, **left})
    found = decomposed(body)
    if found is None or not found.difference.is_none:
        return _uncovered(body, faces, found, left)
    breaks = breaks_of([blend for k in kept for blend in groups[k]], body)
    dressing = _undressed(body, found, breaks, filled, left)
    return dressing or _undrilled(dressed(combined(found.bodies), breaks), holes, solid, left)


def _undressed(
    body: TopoDS_Shape,
    found: Decomposition,
    breaks: Sequence[EdgeBreak],
    filled: TopoDS_Shape,
    left: dict[str, int],
) -> Reason | None:
    """What goes wrong with fillets and chamfers; None if nothing does."""
    made = dressed(body, breaks)
    if made is None:
        return Reason("dressing fails", dict(left), 0.0)
    apart = difference(filled, made)
    if not apart.is_none:
        return Reason("dressing differs", _apart(apart, solid_faces(filled), left), apart.share)
    if dressed(combined(found.bodies), breaks) is None:
        return Reason("dressing of features fails", dict(left), 0.0)
    return None


def _undrilled(
    rough: TopoDS_Shape | None,
    holes: Sequence[Holes],
    solid: TopoDS_Shape,
    left: dict[str, int],
) -> Reason:
    """What goes wrong with holes."""
    assert rough is not None
    reach = 4.0 * float(np.abs(bounding_box(solid)).max() + 1.0)
    try:
        drilled = without(rough, [body_of_holes(each, reach) for each in holes]) if holes else rough
    except KERNEL_FAILURES:
        return Reason("drilling fails", dict(left), 0.0)
    apart = difference(solid, drilled)
    return Reason("drilling differs", _apart(apart, solid_faces(solid), left), apart.share)


def _blends_left(groups: Sequence[Sequence[object]], kept: Sequence[int]) -> dict[str, int]:
    lost = sum(len(group) for k, group in enumerate(groups) if k not in kept)
    return {"edge breaks that stay": lost} if lost else {}


def _surface(face: SolidFace) -> str:
    name = BRepAdaptor_Surface(face.face).GetType().name
    return name.removeprefix("GeomAbs_")


def _uncovered(
    body: TopoDS_Shape,
    faces: Sequence[SolidFace],
    found: Decomposition | None,
    left: dict[str, int],
) -> Reason:
    """What of a body no pads and pockets make."""
    round_left = Counter(
        f"{face.kind.value} left" for face in faces if face.kind in (Kind.TORUS, Kind.SPHERE)
    )
    if found is not None:
        apart = found.difference
        cause = "cover differs" if len(apart.points) or apart.share > 1e-6 else "faces differ"
        if not np.isfinite(apart.share):
            cause = "no single valid body"
        return Reason(cause, {**_apart(apart, faces, left), **round_left}, apart.share)
    choice, samples, busy = _offer(body, faces)
    if choice is None:
        return Reason("too many curves", {**left, **busy})
    near = _nearest_kinds(_missed(choice, samples), faces)
    cause = "no cover" if near else "open outlines"
    return Reason(cause, {**near, **left, **busy, **round_left})


def _apart(apart: Difference, faces: Sequence[SolidFace], left: dict[str, int]) -> dict[str, int]:
    found = dict(left)
    if apart.faces:
        found["more faces" if apart.faces > 0 else "fewer faces"] = abs(apart.faces)
    return {**found, **_nearest_kinds(apart.points, faces)}


def _offer(
    body: TopoDS_Shape, faces: Sequence[SolidFace]
) -> tuple[Choice | None, Samples, dict[str, int]]:
    """The bodies that are offered for a solid, and how many planes have too many curves."""
    box = bounding_box(body)
    rays = Rays(body, 4.0 * float(np.abs(box).max() + 1.0))
    corners = np.array(np.meshgrid(*box.T)).reshape(3, -1).T
    flat, busy = [], 0
    for frame in _frames(faces):
        seen = frame.project(corners)
        found = prism_plane(
            edges_of(body), faces, frame, (seen.min(axis=0), seen.max(axis=0)), rays
        )
        if found is None:
            busy += 1
            continue
        flat.append(found)
    stated = {"planes with too many curves": busy} if busy else {}
    turned = list(turned_planes(faces, box, rays))
    if not [*flat, *turned]:
        return None, Samples(np.zeros((0, 3)), np.zeros(0, dtype=bool)), stated
    planes = [found.plane for found, _ in [*flat, *turned]]
    everywhere = joined([looked for _, looked in [*flat, *turned]])
    sweeps = []
    for number, (found, _) in enumerate(flat):
        sweeps += prisms_of(found, number, everywhere)
    for number, (found, _) in enumerate(turned, len(flat)):
        sweeps += turned_sweeps(found, number, everywhere)
    return offered(sweeps, planes, everywhere), everywhere, stated


def _frames(faces: Sequence[SolidFace]) -> list[Frame]:
    found = dict.fromkeys(
        frame_across(tuple(np.round(face.direction, 9).tolist()))
        for face in faces
        if face.kind is Kind.PLANE
    )
    return [*MAIN_FRAMES, *[frame for frame in found if frame not in MAIN_FRAMES][:12]]


def _missed(choice: Choice, samples: Samples) -> Points:
    """Points that are wrong in the cover that is wrong at the fewest."""
    model = cp_model.CpModel()
    taken = [model.new_bool_var("") for _ in choice.sweeps]
    adds = np.array([sweep.adds for sweep in choice.sweeps], dtype=bool)
    columns = np.vstack([choice.covers, samples.is_inside[None]]).T
    _, first, counts = np.unique(columns, axis=0, return_index=True, return_counts=True)
    wrong = [model.new_bool_var("") for _ in first]
    for number, miss in zip(first, wrong, strict=True):
        covered = choice.covers[:, number]
        pads = [taken[k] for k in np.flatnonzero(covered & adds)]
        pockets = [taken[k] for k in np.flatnonzero(covered & ~adds)]
        if samples.is_inside[number]:
            model.add_bool_or([*pads, miss])
        else:
            for pad in pads:
                model.add_bool_or([~pad, *pockets, miss])
    model.minimize(sum(int(n) * miss for n, miss in zip(counts, wrong, strict=True)))
    solver = cp_model.CpSolver()
    solver.parameters.max_deterministic_time = _EFFORT
    solver.parameters.num_workers = 1
    if solver.solve(model) not in (cp_model.OPTIMAL, cp_model.FEASIBLE):
        return np.zeros((0, 3))
    return samples.points[[k for k, miss in zip(first, wrong, strict=True) if solver.value(miss)]]


def _nearest_kinds(points: Points, faces: Sequence[SolidFace]) -> dict[str, int]:
    """How many points are nearest to which kind of face."""
    found: Counter[str] = Counter()
    for point in points[:_MOST_POINTS]:
        found[_told(_nearest(point, faces))] += 1
    return {f"near {name}": count for name, count in found.most_common()}


def _nearest(point: Points, faces: Iterable[SolidFace]) -> SolidFace:
    vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*point.tolist())).Vertex()
    return min(faces, key=lambda face: BRepExtrema_DistShapeShape(vertex, face.face).Value())


def _told(face: SolidFace) -> str:
    """What a face is, and how it lies."""
    along = float(np.abs(face.direction).max(initial=0.0))
    across = float(np.abs(face.direction).min(initial=0.0))
    lean = "" if along > 1.0 - _PARALLEL else "leaning " if across < _PARALLEL else "skew "
    side = " inside" if face.is_concave else ""
    return f"{lean}{face.kind.value}{side}"
