"""A sketched part, drawn again and compared with the sheet."""

from functools import partial

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.messages import Message
from gaussiancad_core.sketch.sketching import Sketch
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.put_together import drawn_again
from gaussiancad_core.solid.reasons import Reason
from gaussiancad_core.solid.search_trace import ModelKind
from gaussiancad_core.solid.verify import Verification
from gaussiancad_protocol.codes import Code


def checked(sketch: Sketch, views: DrawnViews) -> ExactResult | None:
    """What is known of a sketched part.

    Args:
        sketch: of the views.
        views: that it is compared with.

    Returns:
        None where the kernel made no part, or cannot draw it.
    """
    reason = partial(_sketched, sketch)
    return drawn_again(sketch.shape, sketch.carriers, views, ModelKind.SKETCH, reason)


def _sketched(sketch: Sketch, verification: Verification) -> Reason:
    if verification.explains:
        return (
            Code.SKETCHED,
            Message(
                "this part, slabs along {axis}, has all lines; it was sketched, and nothing "
                "proves that no other part has them",
                case="all",
                axis=sketch.axis.name.lower(),
            ),
        )
    return (
        Code.SKETCHED,
        Message(
            "no solid has all lines as they were read: this part, slabs along {axis}, explains "
            "them best, {percent} % of them",
            axis=sketch.axis.name.lower(),
            percent=round(100 * verification.share),
        ),
    )
