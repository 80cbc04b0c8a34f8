"""The exact solid of a sheet, under the reading of its projection that has one.

First and third angle are two readings of the same views.  Where neither the user nor a symbol says
which, the solid decides: the reading is right whose lines a solid has.  If both have one, and the
two differ, nobody can tell from the sheet which is meant.

Where there is none, what the outlines' sweeps have in common is a solid that is told to be no more.
"""

from collections.abc import Callable
from dataclasses import dataclass, fields, replace

from gaussiancad_core.messages import Message
from gaussiancad_core.modes import Status
from gaussiancad_core.projected_reading import Reading
from gaussiancad_core.reasoning.labelling import Effort
from gaussiancad_core.solid.exact import ExactResult, exact_solid
from gaussiancad_core.solid.limits import Limits
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.sweep import swept_solid
from gaussiancad_core.solid.verify import verify

_UNSETTLED = (
    "search-unfinished",
    Message(
        "whether the views fit a solid in the other projection as well is not certain: "
        "tell --projection",
        case="projection",
    ),
)

OPEN_ENDED = ("search-unfinished", "part-too-complex")
"""Codes of searches that a limit ended: there may be a solid."""

_KEPT = 0.9
"""Share of all lines, both ways, on which a solid must agree to be kept at all."""

_MORE_USUAL = 0.8
"""Share of what is unusual about one solid that there is about a clearly more usual one."""

_AMBIGUOUS = (
    "ambiguous",
    Message(
        "the views fit different solids in first and in third angle: tell --projection",
        case="projection",
    ),
)


_SWEPT = (
    "outlines-swept",
    "no exact solid was found: this one fills all that the outlines and the through holes leave, "
    "so that pockets, blind holes and whatever else no outline shows are missing",
)

_BRIEF = 0.25
"""Share of the usual effort for what carves the hull alone: a few seconds on usual parts."""

_BRIEF_ALTERNATIVES = 2
_BRIEF_WORK = 10.0
"""Solids that are looked at beside the first then, and units of work after which none is begun."""

_MOST_BRIEF = 300
"""Lines of all views up to which such a search is cheap enough."""


@dataclass(frozen=True, eq=False)
class ExactModel:
    """The solid of a sheet.

    Attributes:
        reading: under which it was found.
        result: the solid; its shape is None if there is none worth keeping.
        decided: whether the solids tell which reading is right.
        swept: whether the solid is only what the outlines' sweeps have in common.
    """

    reading: Reading
    result: ExactResult
    decided: bool
    swept: bool = False


def find_exact(
    own: Reading,
    other: Reading | None,
    limits: Limits | None = None,
    likelier: Callable[[], Reading] | None = None,
    *,
    by_symbol: bool = False,
) -> ExactModel:
    """The exact solid of a sheet.

    Args:
        own: the reading that was told, inferred or assumed.
        other: the other one, if it is possible.
        limits: of the search.
        likelier: tells which of the two is likelier; asked only where the solids do not tell.
        by_symbol: whether the sheet's projection symbol tells the first: the other is tried only
            where lines contradict it.
    """
    limits = limits or Limits()
    result = _solved(own, limits)
    if other is None:
        return ExactModel(own, result, False)
    if by_symbol and result.explains and not result.relaxed:
        return ExactModel(own, result, True)
    strict = replace(limits, relaxed=False)
    contrary = _solved(other, strict)
    if not contrary.explains and (result.relaxed or not result.explains):
        # What was given up for the one reading may be given up for the other.
        contrary = _solved(other, limits)
    if contrary.explains and not result.explains:
        # The reading that was likelier must have no solid either, for this one to be certain.
        if not _solved(own, strict).is_settled:
            contrary = contrary.doubted(_UNSETTLED)
        return ExactModel(other, contrary, True)
    if contrary.explains is result.explains and _is_likelier(contrary, result, other, likelier):
        own, result, contrary = other, contrary, result
    if not contrary.explains:
        if not contrary.is_settled:
            result = result.doubted(_UNSETTLED)
        return ExactModel(own, result, result.explains)
    indistinct = own.drawn.indistinct
    further = [
        (shape, share)
        for shape, share in zip(
            (contrary.shape, *contrary.alternatives),
            (contrary.verification.share, *contrary.agreements),
            strict=True,
        )
        if not same_solid(shape, result.shape, indistinct)
    ]
    if not further:
        return ExactModel(own, result, False)
    result = replace(
        result,
        alternatives=(*result.alternatives, *(shape for shape, _ in further)),
        agreements=(*result.agreements, *(share for _, share in further)),
        contrary=len(further),
    )
    return ExactModel(own, result.doubted(_AMBIGUOUS), False)


def _is_likelier(
    contrary: ExactResult,
    result: ExactResult,
    other: Reading,
    likelier: Callable[[], Reading] | None,
) -> bool:
    """Whether the other reading of two that fit alike is to be taken: whose solid is clearly more
    usual, where hidden lines are left out; else what the hull's lines tell."""
    if result.unusual is not None and contrary.unusual is not None:
        if contrary.unusual < _MORE_USUAL * result.unusual:
            return True
        if result.unusual < _MORE_USUAL * contrary.unusual:
            return False
    return likelier is not None and likelier() is other


def find_for_hull(own: Reading, other: Reading | None) -> ExactModel | None:
    """The exact solid as far as it is found quickly, for the depths of its surfaces alone.

    Returns:
        What :func:`find_exact` finds with a quarter of the effort; None for sheets of many lines.
    """
    strokes = sum(len(view.strokes) for view in own.registered.views.views)
    if strokes > _MOST_BRIEF:
        return None
    usual = Effort()
    times = [field.name for field in fields(usual) if field.name != "workers"]
    effort = replace(usual, **{name: _BRIEF * getattr(usual, name) for name in times})
    limits = Limits(
        effort,
        alternatives=_BRIEF_ALTERNATIVES,
        work=_BRIEF_WORK,
        conflict=_BRIEF * Limits().conflict,
    )
    return find_exact(own, other, limits)


def with_fallback(model: ExactModel) -> ExactModel:
    """The same where it has a solid; else with what the sweeps of its outlines have in common.

    Such a solid is never verified.  Where the sweeps have no such solid, nothing changes.
    """
    if model.result.shape is not None:
        return model
    drawn = model.reading.drawn
    shape = swept_solid(model.reading.registered.views, drawn.tolerance)
    if shape is None:
        return model
    result = replace(
        model.result,
        status=Status.APPROXIMATE,
        shape=shape,
        verification=verify(shape, drawn),
        alternatives=(),
        agreements=(),
        reasons=(*model.result.reasons, _SWEPT),
    )
    return replace(model, result=result, swept=True)


def _solved(reading: Reading, limits: Limits) -> ExactResult:
    result = exact_solid(reading.drawn, limits)
    if result.verification is None:
        return result
    share = result.verification.share
    if share >= _KEPT and result.verification.sound:
        return result
    reason = (
        "no-exact-solid",
        Message(
            "the exact solid that fits best agrees with {percent} % of the lines only and was not "
            "kept: lines were misread, or the part has surfaces that are not supported yet",
            case="refused",
            percent=round(100 * share),
        ),
    )
    return replace(
        result,
        status=Status.FAILED,
        shape=None,
        alternatives=(),
        agreements=(),
        reasons=(reason,),
    )
