"""The part that is proposed for a sheet: found among features, built, and judged again."""

from dataclasses import dataclass

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.agreed_places import Places
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.faceted_solids import faceted_shape
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.proposing.feature_kernels import Operation
from gaussiancad_core.proposing.feature_solids import solid_of
from gaussiancad_core.proposing.part_features import Feature
from gaussiancad_core.proposing.part_search import PartSearch

WORK = 2.4e8
"""Steps of the search's kernels: about ten seconds of a processor."""


@dataclass(frozen=True, eq=False)
class ProposedPart:
    """A part as it was put together.

    Attributes:
        features: in order.
        shape: mm; None where the kernel made none.
        planned: share of the lines that it leaves unexplained as it was planned.
        cost: mm of line that its solid does; infinite without one.
    """

    features: tuple[tuple[Operation, Feature], ...]
    shape: TopoDS_Shape | None
    planned: float
    cost: float


def proposed_part(views: DrawnViews, places: Places, work: float = WORK) -> ProposedPart | None:
    """The part that explains views best among those that are put together of what they show.

    Args:
        views: of the part, with what the sheet's numbers say.
        places: where their lines belong.
        work: steps of the search's kernels at most.

    Returns:
        None where nothing tells a start.
    """
    search = PartSearch(views, places, work)
    part = search.best()
    if part is None:
        return None
    judge = Judge(drawn_sheet(views))

    def share(shape: TopoDS_Shape) -> float:
        return judge.misfit(faceted_shape(shape)).share

    features = tuple(part.features)
    shape = solid_of(features, search.sheet, part.share, share)
    cost = judge.misfit(faceted_shape(shape)).cost if shape is not None else float("inf")
    return ProposedPart(features, shape, part.share, cost)
