"""Several solids made one, cut from each other, or met: OpenCASCADE's Booleans at once."""

from collections.abc import Sequence

from OCP.BOPAlgo import BOPAlgo_GlueEnum
from OCP.BRepAlgoAPI import (
    BRepAlgoAPI_BooleanOperation,
    BRepAlgoAPI_Common,
    BRepAlgoAPI_Cut,
    BRepAlgoAPI_Fuse,
)
from OCP.collections import List_TopoDS_Shape
from OCP.ShapeUpgrade import ShapeUpgrade_UnifySameDomain
from OCP.TopoDS import TopoDS_Shape


def fused(shapes: Sequence[TopoDS_Shape], near: float = 0.0) -> TopoDS_Shape:
    """One at least, as one; faces that continue each other stay apart.

    Args:
        shapes: one at least.
        near: distance within which what almost touches touches.

    Raises:
        RuntimeError: the kernel fails.
    """
    first, *others = shapes
    return _combined(BRepAlgoAPI_Fuse(), first, others, near) if others else first


def without(shape: TopoDS_Shape, tools: Sequence[TopoDS_Shape], near: float = 0.0) -> TopoDS_Shape:
    """What is left of a shape that some are taken away from, one at least.

    Args:
        shape: to take from.
        tools: to take away.
        near: as of :func:`fused`.

    Raises:
        RuntimeError: the kernel fails.
    """
    return _combined(BRepAlgoAPI_Cut(), shape, tools, near)


def common(shape: TopoDS_Shape, tool: TopoDS_Shape, near: float = 0.0) -> TopoDS_Shape:
    """What two shapes share.

    Args:
        shape, tool: both.
        near: as of :func:`fused`.

    Raises:
        RuntimeError: the kernel fails.
    """
    return _combined(BRepAlgoAPI_Common(), shape, [tool], near)


def unified(
    shape: TopoDS_Shape, apart: float | None = None, askew: float | None = None
) -> TopoDS_Shape:
    """With faces, edges and curves that continue each other as one.

    Args:
        shape: solids or shells.
        apart: distance up to which they do; the kernel's own where it is None.
        askew: radians up to which they do; the kernel's own where it is None.

    Raises:
        RuntimeError: the kernel fails.
    """
    unify = ShapeUpgrade_UnifySameDomain(shape, True, True, True)
    if apart is not None:
        unify.SetLinearTolerance(apart)
    if askew is not None:
        unify.SetAngularTolerance(askew)
    unify.Build()
    return unify.Shape()


def _combined(
    operation: BRepAlgoAPI_BooleanOperation,
    shape: TopoDS_Shape,
    tools: Sequence[TopoDS_Shape],
    near: float,
) -> TopoDS_Shape:
    arguments, others = List_TopoDS_Shape(), List_TopoDS_Shape()
    arguments.Append(shape)
    for tool in tools:
        others.Append(tool)
    operation.SetArguments(arguments)
    operation.SetTools(others)
    if near:
        operation.SetFuzzyValue(near)
    operation.SetGlue(BOPAlgo_GlueEnum.BOPAlgo_GlueOff)
    operation.Build()
    return operation.Shape()
