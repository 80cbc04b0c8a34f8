"""A solid without its round holes, or without other faces: what lies beside them is continued until
it meets."""

from collections.abc import Sequence

import numpy as np
from OCP.BRepAlgoAPI import BRepAlgoAPI_Defeaturing
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.drilling import body_of_holes, holes_of
from gaussiancad_core.features.feature_model import Holes
from gaussiancad_core.features.inside_rays import Rays
from gaussiancad_core.features.round_holes import Bore, around_bore, bores_of
from gaussiancad_core.features.solid_faces import SolidFace, solid_faces
from gaussiancad_core.kernel.booleans import unified, without
from gaussiancad_core.kernel.brep import exact_volume, is_valid, subshapes
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

_EXACT = 1e-5
"""Share of a solid's volume by which it may differ once its holes are drilled again."""


def without_holes(solid: TopoDS_Shape, reach: float) -> tuple[TopoDS_Shape, tuple[Holes, ...]]:
    """A solid without its round holes, and the holes.

    Where holes meet, the kernel may close them wrongly all at once; they are closed one after the
    other then.

    Args:
        solid: one solid.
        reach: length of what goes through it.
    """
    bores = bores_of(solid_faces(solid), Rays(solid, reach))
    filled, done = without_faces(solid, [bore.faces for bore in bores])
    closed = [bores[k] for k in done]
    if _is_as_drilled(filled, closed, solid, reach):
        return filled, holes_of(closed)
    current, closed = solid, []
    given_up, is_smaller = 0, False
    bores = bores_of(solid_faces(current), Rays(current, reach))
    while given_up < len(bores) or is_smaller:
        if given_up == len(bores):
            # What met one that is closed may be closed now.
            given_up, is_smaller = 0, False
            continue
        bore = bores[given_up]
        smaller = _removed(current, bore.faces)
        if smaller is not None and _is_as_drilled(smaller, [bore], current, reach):
            current, is_smaller = smaller, True
            closed.append(bore)
            bores = bores_of(solid_faces(current), Rays(current, reach))
        else:
            given_up += 1
    return current, holes_of(closed)


def _is_as_drilled(
    filled: TopoDS_Shape, bores: Sequence[Bore], solid: TopoDS_Shape, reach: float
) -> bool:
    """Whether a solid has material where bores were, and the volume of another one once they are
    drilled."""
    if not bores:
        return True
    rays = Rays(filled, reach)
    if not all(_is_closed(bore, rays) for bore in bores):
        return False
    try:
        tools = [body_of_holes(holes, reach) for holes in holes_of(bores)]
        drilled = exact_volume(without(filled, tools))
    except KERNEL_FAILURES:
        return False
    return bool(np.isclose(drilled, exact_volume(solid), rtol=_EXACT))


def _is_closed(bore: Bore, rays: Rays) -> bool:
    """Whether there is material in the middle of each section of a bore."""
    for section in bore.sections:
        radius = 0.5 * min(section.at_low, section.at_high)
        middle = (section.low + section.high) / 2.0
        for base in around_bore(bore.point, bore.direction, radius):
            stretches = rays.inside(base, bore.direction)
            if stretches is None:
                continue
            if not bool(((stretches[:, 0] < middle) & (stretches[:, 1] > middle)).any()):
                return False
    return True


def without_faces(
    shape: TopoDS_Shape, groups: Sequence[Sequence[SolidFace]]
) -> tuple[TopoDS_Shape, tuple[int, ...]]:
    """A solid without the faces of groups, all at once where that is possible, else the halves of
    them, and so on down to the groups that cannot be removed.

    Args:
        shape: one solid.
        groups: faces that go together.

    Returns:
        The solid, and the numbers of the groups that it is without.
    """
    found, done = shape, list[int]()
    runs = [list(range(len(groups)))] if groups else []
    while runs:
        run = runs.pop()
        smaller = _removed(shape, [face for k in (*done, *run) for face in groups[k]])
        if smaller is not None:
            found = smaller
            done += run
        elif len(run) > 1:
            middle = len(run) // 2
            runs += [run[middle:], run[:middle]]
    return found, tuple(done)


def _removed(shape: TopoDS_Shape, faces: Sequence[SolidFace]) -> TopoDS_Shape | None:
    try:
        operation = BRepAlgoAPI_Defeaturing()
        operation.SetShape(shape)
        for face in faces:
            operation.AddFaceToRemove(face.face)
        operation.Build()
        if not operation.IsDone():
            return None
        found = unified(operation.Shape())
    except KERNEL_FAILURES:
        return None
    solids = subshapes(found, TopAbs_ShapeEnum.TopAbs_SOLID)
    return solids[0] if len(solids) == 1 and is_valid(solids[0]) else None
