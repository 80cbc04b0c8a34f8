"""The exact solid of a sheet, under the reading of its projection that has one.

First and third angle are two readings of the same views.  Where neither the user nor a symbol says
which, the solid decides: the reading is right whose lines a solid has.  If both have one, and the
two differ, nobody can tell from the sheet which is meant.

Where no solid has all lines as they were read, the part is sketched: slabs that explain them best.
Where that leaves some unexplained it is put together of features, too, and the judge takes the
better of both.  Only where that leaves much unexplained, or a solid could be certain, are lines
given up, of the likelier reading, and for a short while: a solid that is found so takes its place
where it shows the sheet's lines better.  On a sheet without hidden lines nothing can be certain:
what was put together and has all lines is taken at once.  A sheet of one view is sketched alone.
"""

from dataclasses import dataclass, fields, replace
from functools import cached_property

from gaussiancad_core.errors import is_out_of_memory
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.misfits import solid_misfit
from gaussiancad_core.judging.sheet_judgement import SheetJudgement
from gaussiancad_core.labelling.cell_labelling import Effort
from gaussiancad_core.messages import Message
from gaussiancad_core.proposing.proposed_part import ProposedPart
from gaussiancad_core.run.proposed_model import proposed_result
from gaussiancad_core.sketch.projection_by_sketch import Weighed, weigh
from gaussiancad_core.sketch.sketch_check import checked
from gaussiancad_core.sketch.sketching import Sketch
from gaussiancad_core.solid.exact import ExactResult, exact_solid_and_model
from gaussiancad_core.solid.limits import Limits, Modelled
from gaussiancad_core.solid.reasons import UNBUILT, UNFINISHED, has_hidden_lines
from gaussiancad_core.solid.same import same_solid
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import SolidWay, Status

_UNSETTLED = (
    Code.SEARCH_UNFINISHED,
    Message(
        "whether the views fit a solid in the other projection as well is not certain: "
        "pass --projection",
        case="projection",
    ),
)

OPEN_ENDED = (Code.SEARCH_UNFINISHED,)
"""Codes of searches that a limit ended: there may be a solid."""

_KEPT = 0.9
"""Share of all lines, both ways, on which a solid must agree to be kept at all."""

_MORE_USUAL = 0.8
"""Share of what is unusual about one solid that there is about a clearly more usual one."""

_AMBIGUOUS = (
    Code.AMBIGUOUS,
    Message(
        "the views fit different solids in first and in third angle: pass --projection",
        case="projection",
    ),
)


_RELAXED = 0.25
"""Share of the work for a solid that does not have all lines."""

_BESIDE_FIRM = 0.1
"""The same beside a sketch that explains nearly all."""

_FIRM = 0.05
"""Share of the lines that a sketch leaves unexplained at most for little to be tried beside it, and
for nothing else to be put together."""

_CLEARLY = 0.6
"""Share of what a sketch leaves unexplained that something else leaves at most to take its
place."""

_ALIKE = 1e-3
"""Share of the lines within which two solids explain them alike."""

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
        made_of: the part's sketch, or its features, where the solid was put together.
        contradicted: whether the other reading fits clearly better than the symbol's.
        judged: its solid against the sheet, once the judge was asked.
    """

    reading: ProjectedReading
    result: ExactResult
    decided: bool
    made_of: Sketch | ProposedPart | None = None
    contradicted: bool = False
    judged: SheetJudgement | None = None

    @property
    def is_sketched(self) -> bool:
        """Whether the solid is a sketch's."""
        return isinstance(self.made_of, Sketch)


def find_exact(
    this_reading: ProjectedReading,
    other: ProjectedReading | None,
    limits: Limits | None = None,
    *,
    by_symbol: bool = False,
    way: SolidWay = SolidWay.ALL,
) -> ExactModel:
    """The exact solid of a sheet.

    Args:
        this_reading: the reading that was told, inferred or assumed.
        other: the other one, if it is possible.
        limits: of the search.
        by_symbol: whether the sheet's projection symbol tells the first: the other is tried only
            where lines contradict it, and taken only where they plainly do.
        way: the sketch alone, or all ways.
    """
    limits = limits or Limits()
    readings = _Readings(this_reading, other, by_symbol)
    if this_reading.is_alone or way is SolidWay.SKETCH:
        # Cells take two views.
        failed = ExactResult(Status.FAILED, None, None, (), (UNBUILT,), {})
        return readings.sketched or ExactModel(this_reading, failed, False)
    if not has_hidden_lines(this_reading.drawn):
        # Nothing can be certain of such a sheet.
        together = _best_sketch(readings) or _with_all_lines(readings)
        if together is not None:
            return together
    strict = replace(limits, relaxed=False)
    result, model = _solved(this_reading, strict)
    if result.explains and (other is None or by_symbol):
        return ExactModel(this_reading, result, by_symbol)
    contrary, model_of_other = _solved(other, strict) if other is not None else (None, None)
    if other is None or contrary is None or not (result.explains or contrary.explains):
        return _not_strictly(readings, limits, (model, model_of_other))
    if result.explains and contrary.explains:
        return _distinguished((this_reading, result), (other, contrary))
    # The reading that has no solid must have none for certain, for the other one to be.
    loser = contrary if result.explains else result
    reading, winner = (this_reading, result) if result.explains else (other, contrary)
    return ExactModel(reading, winner if loser.is_settled else winner.doubted(_UNSETTLED), True)


@dataclass(frozen=True, eq=False)
class _PutTogether:
    """A part that was put together.

    Attributes:
        model: of it.
        misfit: mm of line that it leaves unexplained.
        drawn: mm of all lines.
    """

    model: ExactModel
    misfit: float
    drawn: float

    @property
    def share(self) -> float:
        """The misfit as a share of the lines."""
        return self.misfit / self.drawn if self.drawn else 1.0


@dataclass(frozen=True, eq=False)
class _Readings:
    """The readings of a sheet.

    Attributes:
        assumed: the one that was told, inferred or assumed.
        other: the other one, if it is possible.
        by_symbol: whether a projection symbol tells the first.
    """

    assumed: ProjectedReading
    other: ProjectedReading | None
    by_symbol: bool

    @cached_property
    def weighed(self) -> Weighed:
        """How well they are sketched."""
        return weigh((self.assumed,) if self.other is None else (self.assumed, self.other))

    @property
    def likelier(self) -> int:
        """Number of the one that is taken, where no solid has all lines."""
        weighed = self.weighed
        return 0 if self.by_symbol and not weighed.is_plain else weighed.likelier

    @property
    def is_contradicted(self) -> bool:
        """Whether the other one fits clearly better than the symbol's."""
        return self.by_symbol and self.weighed.is_clear and self.weighed.likelier == 1

    @property
    def is_decided(self) -> bool:
        """Whether sketches tell the one that is taken."""
        return self.weighed.is_clear and self.likelier == self.weighed.likelier

    @property
    def taken(self) -> ProjectedReading:
        """The one that is taken, where no solid has all lines."""
        return self.assumed if self.likelier == 0 or self.other is None else self.other

    @cached_property
    def sketched(self) -> ExactModel | None:
        """The sketch of that, drawn again; None where there is none."""
        return self.sketch_of(self.likelier)

    @property
    def is_told(self) -> bool:
        """Whether it is known which reading is right."""
        return self.other is None or self.by_symbol or self.is_decided

    @cached_property
    def put_together(self) -> _PutTogether | None:
        """What explains more of the reading that is taken: its sketch, or what is put together of
        features where the sketch leaves some unexplained."""
        found, sketched, reading = None, self.sketched, self.taken
        if sketched is not None:
            misfit = solid_misfit(sketched.result.shape, reading.drawn)
            found = _PutTogether(sketched, misfit.cost, misfit.drawn)
        if (found is not None and found.share <= _FIRM) or reading.is_alone:
            return found
        proposed = proposed_result(reading.numbered, reading.grid)
        if proposed is None:
            return found
        result, part = proposed
        if found is not None and part.cost > _CLEARLY * found.misfit:
            return found
        model = ExactModel(
            reading, result, self.is_decided, part, contradicted=self.is_contradicted
        )
        return _PutTogether(model, part.cost, drawn_sheet(reading.numbered).length)

    def sketch_of(self, number: int) -> ExactModel | None:
        """The sketch of a reading, drawn again; None where there is none."""
        sketch = self.weighed.sketches[number]
        reading = self.assumed if number == 0 or self.other is None else self.other
        result = checked(sketch, reading.drawn) if sketch is not None else None
        if result is None:
            return None
        return ExactModel(reading, result, self.is_decided, sketch, self.is_contradicted)


def _best_sketch(readings: _Readings) -> ExactModel | None:
    """A sketch that has all lines, and, where nothing tells the reading, that of the other one
    beside it; None where no sketch has."""
    sketched = readings.sketched
    if readings.other is None or readings.by_symbol or readings.is_decided:
        if sketched is None or not sketched.result.explains:
            return None
        return replace(sketched, decided=sketched.decided or readings.by_symbol)
    contrary = readings.sketch_of(1 - readings.likelier)
    found = [model for model in (sketched, contrary) if model is not None and model.result.explains]
    if len(found) < 2:
        # The other one has lines that nothing explains, if it was sketched at all.
        is_told = sketched is not None and contrary is not None
        return replace(found[0], decided=is_told) if found else None
    first, second = ((model.reading, model.result) for model in found)
    return replace(_with_other(first, second), made_of=found[0].made_of)


def _with_all_lines(readings: _Readings) -> ExactModel | None:
    """What was put together, where it is known which reading is right and it has all lines."""
    found = readings.put_together if readings.is_told else None
    if found is None or not found.model.result.explains:
        return None
    return replace(found.model, decided=found.model.decided or readings.by_symbol)


def _distinguished(
    first: tuple[ProjectedReading, ExactResult], second: tuple[ProjectedReading, ExactResult]
) -> ExactModel:
    """Where both readings have a solid: the likelier one, and the other beside it."""
    return _with_other(second, first) if _is_likelier(second, first) else _with_other(first, second)


def _with_other(
    first: tuple[ProjectedReading, ExactResult], second: tuple[ProjectedReading, ExactResult]
) -> ExactModel:
    """A solid, and that of the other reading beside it, if it is another one."""
    (reading, result), (_, contrary) = first, second
    indistinct = reading.drawn.indistinct
    further = [
        (shape, share)
        for shape, share in zip(
            (contrary.shape, *contrary.alternatives),
            (contrary.checked.share, *contrary.agreements),
            strict=True,
        )
        if not same_solid(shape, result.shape, indistinct)
    ]
    if not further:
        return ExactModel(reading, result, False)
    result = replace(
        result,
        alternatives=(*result.alternatives, *(shape for shape, _ in further)),
        agreements=(*result.agreements, *(share for _, share in further)),
        contrary=len(further),
    )
    return ExactModel(reading, result.doubted(_AMBIGUOUS), False)


def _is_likelier(
    other: tuple[ProjectedReading, ExactResult], pair: tuple[ProjectedReading, ExactResult]
) -> bool:
    """Whether the other reading of two that fit alike is to be taken: whose solid is clearly more
    usual, where hidden lines are left out; else whose sketch explains more."""
    result, contrary = pair[1], other[1]
    if result.unusual is not None and contrary.unusual is not None:
        if contrary.unusual < _MORE_USUAL * result.unusual:
            return True
        if result.unusual < _MORE_USUAL * contrary.unusual:
            return False
    return weigh((pair[0], other[0])).likelier == 1


def _not_strictly(
    readings: _Readings, limits: Limits, models: tuple[Modelled | None, Modelled | None]
) -> ExactModel:
    """Where no reading has a solid that has all lines: what was put together, or what has more.

    Args:
        readings: of the sheet.
        limits: of the search.
        models: of both readings, as the search for such solids made them.
    """
    found, reading = readings.put_together, readings.taken
    is_firm = found is not None and found.share <= _FIRM
    share = _BESIDE_FIRM if is_firm else _RELAXED
    less = replace(limits, work=share * limits.work)
    relaxed, _ = _solved(reading, less, models[readings.likelier])
    stated = readings.is_decided, None, readings.is_contradicted
    if found is None or relaxed.status is Status.VERIFIED:
        return ExactModel(reading, relaxed, *stated)
    result = found.model.result
    if relaxed.shape is not None:
        other = solid_misfit(relaxed.shape, reading.drawn)
        if other.cost < found.misfit - _ALIKE * found.drawn or (
            relaxed.explains and not result.explains
        ):
            return ExactModel(reading, relaxed, *stated)
    result = replace(
        result,
        conflict=relaxed.conflict,
        trace=(*(replace(each, taken=False) for each in relaxed.trace), *result.trace),
        seconds=relaxed.seconds,
    )
    return replace(found.model, result=result)


def find_for_hull(reading: ProjectedReading, other: ProjectedReading | None) -> ExactModel | None:
    """The exact solid as far as it is found quickly, for the depths of its surfaces alone.

    Returns:
        What :func:`find_exact` finds with a quarter of the effort; None for sheets of many lines.
    """
    strokes = sum(map(len, reading.drawn.strokes.values()))
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
    return find_exact(reading, other, limits)


def _solved(
    reading: ProjectedReading, limits: Limits, model: Modelled | None = None
) -> tuple[ExactResult, Modelled | None]:
    """The solid of a reading as far as it is worth keeping, and the model of its drawing; none of
    either where that takes more memory than there is."""
    try:
        result, model = exact_solid_and_model(reading.drawn, limits, model)
    except Exception as error:
        if not is_out_of_memory(error):
            raise
        return ExactResult(Status.FAILED, None, None, (), (UNFINISHED,), {}), None
    return _kept(result), model


def _kept(result: ExactResult) -> ExactResult:
    """A result without its solid where that agrees with too few of the lines."""
    if result.verification is None:
        return result
    share = result.verification.share
    if share >= _KEPT and result.verification.sound:
        return result
    reason = (
        Code.NO_EXACT_SOLID,
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
