"""A part that was put together, drawn again and compared with the sheet: never more than
approximate."""

from collections.abc import Callable
from dataclasses import replace

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.coordinates.carriers import PartCarriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import is_valid, soundness
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.messages import Message
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.measure_bounds import measures_of
from gaussiancad_core.solid.reasons import Reason, has_hidden_lines, reasons_of
from gaussiancad_core.solid.search_trace import Attempt, ModelKind, Outcome
from gaussiancad_core.solid.verify import Verification, verify
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Status


def drawn_again(
    shape: TopoDS_Shape | None,
    carriers: PartCarriers,
    views: DrawnViews,
    kind: ModelKind,
    reason: Callable[[Verification], Reason],
) -> ExactResult | None:
    """What is known of a part that was put together.

    Args:
        shape: of it, mm; None where the kernel made none.
        carriers: of the views: where their lines may lie.
        views: that it is compared with.
        kind: of what it was put together.
        reason: why it is not certain, once it is known how it agrees.

    Returns:
        None where the kernel made no part, or cannot draw it.
    """
    # Drawing what is not valid may end the process.
    if shape is None or not is_valid(shape):
        return None
    if not has_hidden_lines(views):
        # What no view draws hidden is not to be found hidden.
        views = replace(views, undrawn=views.roles)
    try:
        verification = verify(shape, views)
        measures = measures_of(shape, carriers, views, verification)
    except KERNEL_FAILURES:
        return None
    facts = soundness(shape)
    is_one_body = facts.solids == 1
    if not facts.solids:
        return None
    reasons = [reason(verification)]
    if facts.valid and facts.closed and not is_one_body:
        reasons.append(
            (Code.SEVERAL_BODIES, Message("the part is {count} bodies", count=facts.solids))
        )
    stated_reasons = reasons_of(verification, 1, True, views)
    reasons += [pair for pair in stated_reasons if is_one_body or pair[0] != Code.SOLID_UNSOUND]
    outcome = Outcome.ALL_LINES if verification.explains else Outcome.DEVIATES
    attempt = Attempt(
        kind,
        outcome,
        faces=facts.faces,
        share=verification.share,
        flaws=len(verification.flaws),
        taken=True,
    )
    return ExactResult(
        Status.APPROXIMATE,
        shape,
        verification,
        (),
        tuple(reasons),
        {},
        relaxed=True,
        measures=measures,
        trace=(attempt,),
    )
