"""When a solid that is called verified is not the part.

``verified`` speaks of the shape; how well its measures are known is said beside it, as a bound that
95 % of all faces' places keep.  So the verdict on a solid is

- ``false``, if it is not one valid closed solid; if any of the points inside the faces of either
  solid lies farther than :data:`FAR` bounds from the other one; or if the volumes have an IoU of
  less than .999 and the numbers of faces differ.  A bound that one face in twenty may exceed is
  exceeded by three times, with errors that are normal, by one in 10^8: what lies farther beside is
  no error of measure.  A face that only one of the solids has lies beside the other by the size of
  the step, pocket or boss that it belongs to, and each face is asked, however small.
- ``false`` as well, if another part has the same drawing, whichever of them it is: nobody can tell;
- ``right`` otherwise.

How many faces of a single solid lie within the bound tells nothing: its measures are off together,
where the end is that they are counted from.  Of all solids of one kind together 95 % have to.
"""

from dataclasses import dataclass

from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.displacements import displacements
from benchmarks.judge.exact_measures import solid_iou
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import faces_of, soundness
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.same import same_solid
from gaussiancad_protocol.modes import Status

FAR = 3.0
"""Bounds beyond which a face is another one."""

EXACT_IOU = 0.999

_EXACT = 5.0
"""Tolerances of exact lines by which faces may be off at least."""


@dataclass(frozen=True)
class Verdict:
    """What is to be said of a solid that was called verified.

    Attributes:
        why: it is false; empty if it is right.
        within, faces: how many faces of both solids lie within the bound, of how many.
        bound: mm.
        farthest: mm from a face of one solid to the other one.
    """

    why: str
    within: int = 0
    faces: int = 0
    bound: float = 0.0
    farthest: float = 0.0


def verdict(
    result: ExactResult, truth: TopoDS_Shape, views: DrawnViews, *, unique: bool = True
) -> Verdict | None:
    """Whether a result that is called verified is the part; None if it is not called so.

    Args:
        result: of a drawing.
        truth: the part that was drawn, mm, in place.
        views: the drawing's lines.
        unique: whether no other part has the drawing.
    """
    if result.status is not Status.VERIFIED:
        return None
    bound = bound_mm(result, views)
    if result.shape is None:
        return Verdict("no solid", bound=bound)
    return judgement(result.shape, truth, bound, unique=unique)


def judgement(
    shape: TopoDS_Shape, truth: TopoDS_Shape, bound: float, *, unique: bool = True
) -> Verdict:
    """Whether a solid that is called verified is the part.

    Args:
        shape, truth: mm, in place.
        bound: mm that 95 % of all faces' places are said to keep.
        unique: whether no other part has the drawing.
    """
    facts = soundness(shape)
    if not (facts.valid and facts.closed and facts.solids == 1):
        return Verdict("unsound", bound=bound)
    if not unique:
        return Verdict("another part has this drawing", bound=bound)
    count = facts.faces + len(faces_of(truth))
    if 2 * facts.faces == count and same_solid(shape, truth):
        # Their volumes and centres are the same to a share of 10^-5: nothing is displaced.
        return Verdict("", count, count, bound)
    neighbour = displacements(shape, truth)
    within = int((neighbour.medians <= bound).sum())
    stated = within, count, bound, neighbour.farthest
    if neighbour.farthest > FAR * bound:
        return Verdict(f"off by {neighbour.farthest:.3g} mm, bound {bound:.3g} mm", *stated)
    iou = solid_iou(shape, truth)
    if (iou is None or iou < EXACT_IOU) and facts.faces != len(faces_of(truth)):
        return Verdict("other faces and volume", *stated)
    return Verdict("", *stated)


def bound_mm(result: ExactResult, views: DrawnViews) -> float:
    """mm within which 95 % of the faces of a result are said to lie, as far as lines are known."""
    least = _EXACT * views.tolerance if views.apart is None else 0.0
    return max(least, result.measures.uncertainty if result.measures is not None else 0.0)
