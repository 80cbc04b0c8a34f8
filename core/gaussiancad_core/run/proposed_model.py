"""A part that is put together of features where no solid has all lines, and drawn again."""

from functools import partial

from shapely.errors import GEOSException

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.labelling.part_model import MOST_STROKES
from gaussiancad_core.messages import Message
from gaussiancad_core.proposing.proposed_part import ProposedPart, proposed_part
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.put_together import drawn_again
from gaussiancad_core.solid.reasons import Reason
from gaussiancad_core.solid.search_trace import ModelKind
from gaussiancad_core.solid.verify import Verification
from gaussiancad_protocol.codes import Code


def proposed_result(views: DrawnViews, grid: float) -> tuple[ExactResult, ProposedPart] | None:
    """The part that is put together of what views show, drawn again, and how; None where there is
    none.

    Args:
        views: of the part, with what the sheet's numbers say.
        grid: mm within which lines are one.
    """
    if max(map(len, views.strokes.values())) > MOST_STROKES:
        return None
    try:
        found = proposed_part(views, grid)
    except (*KERNEL_FAILURES, GEOSException):
        return None
    if found is None or found.shape is None:
        return None
    reason = partial(_put_together, found)
    result = drawn_again(found.shape, found.carriers, views, ModelKind.FEATURES, reason)
    if result is None or any(code == Code.SOLID_UNSOUND for code, _ in result.reasons):
        # What is not closed is no part to go on with.
        return None
    return result, found


def _put_together(found: ProposedPart, verification: Verification) -> Reason:
    count = len(found.features)
    if verification.explains:
        return (
            Code.SKETCHED,
            Message(
                "this part, put together of {count} features, has all lines; nothing proves that "
                "no other part has them",
                case="features-all",
                count=count,
            ),
        )
    return (
        Code.SKETCHED,
        Message(
            "no solid has all lines as they were read: this part, put together of {count} "
            "features, explains them best, {percent} % of them",
            case="features",
            count=count,
            percent=round(100 * verification.share),
        ),
    )
