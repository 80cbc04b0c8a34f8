"""The exact solid of a sheet, under the reading of its projection that has one.

First and third angle are two readings of the same views.  Where neither the user nor a symbol says
which, the solid decides: the reading is right whose lines a solid has.  If both have one, and the
two differ, nobody can tell from the sheet which is meant.

Where no solid has all lines as they were read, the part is sketched: slabs that explain them best.
Only where that leaves much unexplained, or a solid could be certain, are lines given up, of the
likelier reading, and for a short while: a solid that is found so takes the sketch's place where it
has so many more lines that this outweighs how unusual it is.
"""

from dataclasses import dataclass, fields, replace

from gaussiancad_core.messages import Message
from gaussiancad_core.modes import Status
from gaussiancad_core.projected_reading import Reading
from gaussiancad_core.reasoning.labelling import Effort
from gaussiancad_core.sketch.checking import checked
from gaussiancad_core.sketch.occupancy import energy_as_slabs
from gaussiancad_core.sketch.sketching import Sketch
from gaussiancad_core.sketched_readings import weigh
from gaussiancad_core.solid.exact import ExactResult, exact_solid
from gaussiancad_core.solid.limits import Limits
from gaussiancad_core.solid.reasons import has_hidden_lines
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.verify import Verification

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


_RELAXED = 0.25
"""Share of the work for a solid that does not have all lines."""

_FIRM = 0.03
"""Share of the lines' length that a sketch costs at most to stay: lines were misread then."""

_POOR = 0.25
"""The same from which it is no measure of what is usual: the part is none of slabs."""

_UNUSUAL = 0.5
"""What counts of how unusual such a solid is: what it has beside slabs is no line of theirs."""

_WRONG = 0.5
"""Share of the sketch's wrong lines that such a solid has at most, to take its place."""

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
        decided: whether the solids, or the sketches, tell which reading is right.
        sketched: the part's sketch, where the solid is that.
        contradicted: whether the other reading fits clearly better than the symbol's.
    """

    reading: Reading
    result: ExactResult
    decided: bool
    sketched: Sketch | None = None
    contradicted: bool = False


def find_exact(
    own: Reading, other: Reading | None, limits: Limits | None = None, *, by_symbol: bool = False
) -> ExactModel:
    """The exact solid of a sheet.

    Args:
        own: the reading that was told, inferred or assumed.
        other: the other one, if it is possible.
        limits: of the search.
        by_symbol: whether the sheet's projection symbol tells the first: the other is tried only
            where lines contradict it, and taken only where they plainly do.
    """
    limits = limits or Limits()
    strict = replace(limits, relaxed=False)
    result = _solved(own, strict)
    if result.explains and (other is None or by_symbol):
        return ExactModel(own, result, by_symbol)
    contrary = _solved(other, strict) if other is not None else None
    if contrary is None or not (result.explains or contrary.explains):
        return _sketched(own, other, limits, by_symbol=by_symbol)
    if result.explains and contrary.explains:
        return _told_apart((own, result), (other, contrary))
    # The reading that has no solid must have none for certain, for the other one to be.
    loser = contrary if result.explains else result
    reading, winner = (own, result) if result.explains else (other, contrary)
    return ExactModel(reading, winner if loser.is_settled else winner.doubted(_UNSETTLED), True)


def _told_apart(
    first: tuple[Reading, ExactResult], second: tuple[Reading, ExactResult]
) -> ExactModel:
    """Where both readings have a solid: the likelier one, and the other beside it."""
    if _is_likelier(second, first):
        first, second = second, first
    (own, result), (_, contrary) = first, second
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


def _is_likelier(other: tuple[Reading, ExactResult], own: tuple[Reading, ExactResult]) -> bool:
    """Whether the other reading of two that fit alike is to be taken: whose solid is clearly more
    usual, where hidden lines are left out; else whose sketch explains more."""
    result, contrary = own[1], other[1]
    if result.unusual is not None and contrary.unusual is not None:
        if contrary.unusual < _MORE_USUAL * result.unusual:
            return True
        if result.unusual < _MORE_USUAL * contrary.unusual:
            return False
    return weigh((own[0], other[0])).likelier == 1


def _sketched(
    own: Reading, other: Reading | None, limits: Limits, *, by_symbol: bool
) -> ExactModel:
    """Where no reading has a solid that has all lines: the sketch, or what has more of them."""
    readings = (own,) if other is None else (own, other)
    weighed = weigh(readings)
    contradicted = by_symbol and weighed.is_clear and weighed.likelier == 1
    number = 0 if by_symbol and not weighed.is_plain else weighed.likelier
    reading, sketch = readings[number], weighed.sketches[number]
    decided = weighed.is_clear and number == weighed.likelier
    result = checked(sketch, reading.drawn) if sketch is not None else None
    is_firm = result is not None and (result.explains or _costs(sketch, reading) <= _FIRM)
    if result is not None and result.explains and not has_hidden_lines(reading.drawn):
        return ExactModel(reading, result, decided, sketch, contradicted)
    relaxed = _solved(reading, replace(limits, work=_RELAXED * limits.work))
    model = ExactModel(reading, relaxed, decided, contradicted=contradicted)
    if result is None or relaxed.status is Status.VERIFIED:
        return model
    if relaxed.explains and not result.explains:
        return model
    is_poor = _costs(sketch, reading) > _POOR
    if not is_firm and _is_better(relaxed, result, None if is_poor else sketch):
        return model
    result = replace(
        result,
        conflict=relaxed.conflict,
        trace=(*(replace(each, taken=False) for each in relaxed.trace), *result.trace),
        seconds=relaxed.seconds,
    )
    return replace(model, result=result, sketched=sketch)


def _costs(sketch: Sketch, reading: Reading) -> float:
    """What a sketch costs as a share of the lines' length."""
    drawn = sum(own.length for strokes in reading.drawn.strokes.values() for own in strokes)
    return sketch.energy / drawn


def _is_better(relaxed: ExactResult, result: ExactResult, sketch: Sketch | None) -> bool:
    """Whether a solid that gives lines up has so many more than the sketch that this outweighs how
    unusual it is; None for a sketch that is no measure of that."""
    if relaxed.shape is None:
        return False
    wrong, worse = _wrong(relaxed.verification), _wrong(result.verification)
    if wrong > _WRONG * worse:
        return False
    if sketch is None:
        return True
    more = energy_as_slabs(relaxed.shape, sketch.choice.plan) - sketch.energy
    return worse - wrong > _UNUSUAL * more


def _wrong(verification: Verification) -> float:
    """mm of line in which a solid and the sheet differ."""
    return sum(flaw.length for flaw in verification.flaws)


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
        verification=None,
        alternatives=(),
        agreements=(),
        reasons=(reason,),
    )
