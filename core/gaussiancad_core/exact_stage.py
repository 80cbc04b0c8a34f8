"""The exact solid of a sheet, under the reading of its projection that has one.

First and third angle are two readings of the same views.  Where neither the user nor a symbol says
which, the solid decides: the reading is right whose lines a solid has.  If both have one, and the
two differ, nobody can tell from the sheet which is meant.

Where there is none, what the outlines' sweeps have in common is a solid that is told to be no more.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.cuts import Cut, SectionRole
from gaussiancad_core.holes import NotedHole
from gaussiancad_core.line_noise import bound_of_seen_px, noise_px
from gaussiancad_core.messages import Message
from gaussiancad_core.modes import Status
from gaussiancad_core.reasoning.drawn_views import DrawnViews, views_as_read
from gaussiancad_core.reasoning.labelling import Effort
from gaussiancad_core.sections_stage import SectionBeside
from gaussiancad_core.sheet.precision import StrokesSource
from gaussiancad_core.sheet.reading import RegisteredSheet
from gaussiancad_core.sheet.scale.estimate import Measure
from gaussiancad_core.solid.exact import ExactResult, exact_solid
from gaussiancad_core.solid.limits import Limits
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.sweep import swept_solid
from gaussiancad_core.solid.verify import verify
from gaussiancad_core.told_measures import told_numbers

_ROUGH_PX = 1.0
"""Tolerance of strokes that were read from a picture."""

APART_PX = 0.3
"""px from which the coordinates of such strokes are different ones: lines are read to a twentieth
of a pixel, and what is one over the views has been made equal."""

TOLERANCE_PX = {
    StrokesSource.RASTER: 1.0,
    StrokesSource.COARSE: 1.0,
    StrokesSource.PLOT: 0.3,
    StrokesSource.VECTOR: 0.05,
}
"""px by which lines of a sheet may miss where they belong, by where they come from."""

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
class Reading:
    """The views of a sheet under a projection.

    Attributes:
        registered: on shared axes.
        projection: first or third angle.
        measures: what the sheet's dimensions say.
        cuts: views that are sections.
        beside: sections beside plain views.
        holes: of which notes speak.
    """

    registered: RegisteredSheet
    projection: Projection
    measures: tuple[Measure, ...] = ()
    cuts: Mapping[Role, Cut] = field(default_factory=dict)
    beside: Mapping[SectionRole, SectionBeside] = field(default_factory=dict)
    holes: tuple[NotedHole, ...] = ()

    @property
    def drawn(self) -> DrawnViews:
        """The lines of the views, as the reasoning takes them."""
        plain = drawn_views(self.registered, self.measures)
        beside = self.beside.items()
        return replace(
            plain,
            strokes={**plain.strokes, **{role: own.strokes for role, own in beside}},
            cuts={**self.cuts, **{role: own.cut for role, own in beside}},
            holes=self.holes,
        )


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


def drawn_views(registered: RegisteredSheet, measures: Sequence[Measure] = ()) -> DrawnViews:
    """The lines of a sheet's views, with the tolerance of the view that is known least exactly.

    Args:
        registered: the views.
        measures: what the sheet's dimensions say; lines of a file are more exact than these.
    """
    tolerance = max(TOLERANCE_PX[view.source] for view in registered.drawn)
    pixel = registered.mm_per_pixel
    if tolerance < _ROUGH_PX:
        exact = views_as_read(registered.views, tolerance * pixel)
        return replace(exact, bound=bound_of_seen_px(registered) * pixel)
    noise, bound = noise_px(registered)
    dashes = [view.dash * pixel for view in registered.drawn if view.dash is not None]
    drawn = views_as_read(
        registered.views,
        tolerance * pixel,
        APART_PX * pixel,
        noise * pixel,
        max(dashes, default=None),
    )
    numbers = told_numbers(registered, measures, noise)
    return replace(drawn, bound=bound * pixel, told=numbers, known=registered.told)


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
