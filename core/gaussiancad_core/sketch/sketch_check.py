"""A sketched part, drawn again and compared with the sheet: it is never more than approximate."""

from dataclasses import replace

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import is_valid, soundness
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.messages import Message
from gaussiancad_core.sketch.sketching import Sketch
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.measure_bounds import measures_of
from gaussiancad_core.solid.reasons import Reason, has_hidden_lines, reasons_of
from gaussiancad_core.solid.search_trace import Attempt, ModelKind, Outcome
from gaussiancad_core.solid.verify import Verification, verify
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Status


def checked(sketch: Sketch, views: DrawnViews) -> ExactResult | None:
    """What is known of a sketched part.

    Args:
        sketch: of the views.
        views: that it is compared with.

    Returns:
        None where the kernel made no part, or cannot draw it.
    """
    # Drawing what is not valid may end the process.
    if sketch.shape is None or not is_valid(sketch.shape):
        return None
    if not has_hidden_lines(views):
        # What no view draws hidden is not to be found hidden.
        views = replace(views, undrawn=views.roles)
    try:
        verification = verify(sketch.shape, views)
        measures = measures_of(sketch.shape, sketch.carriers, views, verification)
    except KERNEL_FAILURES:
        return None
    facts = soundness(sketch.shape)
    is_one_body = facts.solids == 1
    if not facts.solids:
        return None
    reasons = [_sketched(sketch, verification)]
    if facts.valid and facts.closed and not is_one_body:
        reasons.append(
            (Code.SEVERAL_BODIES, Message("the part is {count} bodies", count=facts.solids))
        )
    stated_reasons = reasons_of(verification, 1, True, views)
    reasons += [pair for pair in stated_reasons if is_one_body or pair[0] != Code.SOLID_UNSOUND]
    outcome = Outcome.ALL_LINES if verification.explains else Outcome.DEVIATES
    attempt = Attempt(
        ModelKind.SKETCH,
        outcome,
        faces=facts.faces,
        share=verification.share,
        flaws=len(verification.flaws),
    )
    return ExactResult(
        Status.APPROXIMATE,
        sketch.shape,
        verification,
        (),
        tuple(reasons),
        {},
        relaxed=True,
        measures=measures,
        trace=(attempt,),
    )


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
