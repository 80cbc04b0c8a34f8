"""How far the search for a solid goes, and what it has to work on."""

from dataclasses import dataclass, field, replace

from gaussiancad_core.reasoning.drawn_views import DrawnViews
from gaussiancad_core.reasoning.edge_breaks import EdgeBreak
from gaussiancad_core.reasoning.labelling import Effort, Labelling, Search
from gaussiancad_core.reasoning.part import PartModel
from gaussiancad_core.reasoning.work import Counted, Meter
from gaussiancad_core.solid.trace import Attempt, Journal, ModelKind, Outcome, cells_of

OTHERWISE = 0.55
"""Share of the work after which no further model of the drawing is made."""


@dataclass(frozen=True)
class Limits:
    """How far the search goes.

    Attributes:
        effort: of the labelling, deterministic.
        alternatives: solids looked at beside the first.
        relaxed: whether lines may be given up where all together fit no solid.
        work: units, counted, after which nothing further is begun.
        conflict: deterministic time for telling which lines contradict each other, where no solid
            has all of them, lines may be given up, and a quarter of ``work`` is not done.
        guard: s of the clock after which the search ends whatever was done by then.
    """

    effort: Effort = field(default_factory=Effort)
    alternatives: int = 8
    relaxed: bool = True
    work: float = 60.0
    conflict: float = 2.0
    guard: float = 900.0


@dataclass(frozen=True)
class Finish:
    """What is done to a solid that was found from views without the chamfers of its faces.

    Attributes:
        breaks: the chamfers.
        drawn: the views with them.
    """

    breaks: tuple[EdgeBreak, ...]
    drawn: DrawnViews


@dataclass(frozen=True)
class Work:
    """What candidates are made from.

    Attributes:
        part, views: that are explained.
        search: for labels of the part.
        meter: of all that is done.
        journal: of what was tried.
        kind: how the drawing was understood.
        fewest: whether the labels are those by which the fewest strokes are wrong or lacking.
        loose: whether places are one that are farther apart than the tolerance.
        finish: of the solid; None where the views are as drawn.
    """

    part: PartModel
    views: DrawnViews
    search: Search
    meter: Meter
    journal: Journal
    kind: ModelKind = ModelKind.AS_DRAWN
    fewest: bool = False
    loose: bool = False
    finish: Finish | None = None

    @property
    def drawn(self) -> DrawnViews:
        """The views that a solid is compared with."""
        if self.finish is None:
            return self.views
        return replace(self.finish.drawn, undrawn=self.views.undrawn)

    def failed(self, labelling: Labelling) -> None:
        """Note that the model has no labels for all lines."""
        outcome = Outcome.CONTRADICTORY if labelling.complete else Outcome.UNFINISHED
        rules = self.part.rules
        size = len(rules), cells_of(rules)
        self.journal.add(Attempt(self.kind, outcome, *size, work=self.meter.spent))

    @property
    def slim(self) -> float:
        """Units of thickness up to which cells lie between lines that may be one: a solid that
        differs in such cells only is no other one."""
        return self.views.indistinct * self.part.supports.scale

    def allows_another(self, limits: Limits, times: float = 1.0) -> bool:
        """Whether work is left for a model that takes some times as much as the first one did."""
        return self.meter.spent + times * self.meter.work["model"] < OTHERWISE * limits.work


def search_for(part: PartModel, limits: Limits, meter: Meter) -> Search:
    """The search for labels of a part; its clauses are counted."""
    meter.count(Counted.CROSSING, sum(len(rule.groups) for rule in part.rules))
    return Search(part.rules, limits.effort, part.usual)
