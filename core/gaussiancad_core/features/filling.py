"""A solid without some of its faces: the faces beside them are continued until they meet."""

from collections.abc import Sequence

from OCP.BRepAlgoAPI import BRepAlgoAPI_Defeaturing
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.booleans import unified
from gaussiancad_core.drawing.brep import is_valid, subshapes
from gaussiancad_core.drawing.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.features.solid_faces import SolidFace


def without_faces(
    shape: TopoDS_Shape, groups: Sequence[Sequence[SolidFace]]
) -> tuple[TopoDS_Shape, tuple[int, ...]]:
    """A solid without the faces of groups, all at once where that is possible, else one group
    after the other.

    Args:
        shape: one solid.
        groups: faces that go together.

    Returns:
        The solid, and the numbers of the groups that it is without.
    """
    if not groups:
        return shape, ()
    everything = [face for group in groups for face in group]
    found = _removed(shape, everything)
    if found is not None:
        return found, tuple(range(len(groups)))
    done: list[int] = []
    for number, group in enumerate(groups):
        tried = [*(face for k in done for face in groups[k]), *group]
        smaller = _removed(shape, tried)
        if smaller is not None:
            found = smaller
            done.append(number)
    return (shape if found is None else found), tuple(done)


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
