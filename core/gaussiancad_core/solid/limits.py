"""How far the search for a solid goes, and what it has to work on."""

from dataclasses import dataclass, field

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.labelling.cell_labelling import Effort, Labelling, Search
from gaussiancad_core.labelling.counted_work import Counted, Meter
from gaussiancad_core.labelling.part_model import PartModel
from gaussiancad_core.solid.search_trace import Attempt, Journal, ModelKind, Outcome, cells_of

OTHERWISE = 0.55
"""Share of the work after which no further model of the drawing is made."""

_FURTHER = 8.0
"""Units of work after which none is made, either: a drawing of which one model takes as long is
asked for once."""


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


@dataclass(frozen=True, eq=False)
class Modelled:
    """The model of a drawing as it is.

    Attributes:
        part: cells and rules.
        took: units of work.
    """

    part: PartModel
    took: float


@dataclass(frozen=True)
class Work:
    """What candidates are made from.

    Attributes:
        part, views: that are explained.
        took: units of work that the model of the drawing as it is took.
        search: for labels of the part.
        meter: of all that is done.
        journal: of what was tried.
        kind: how the drawing was understood.
    """

    part: PartModel
    took: float
    views: DrawnViews
    search: Search
    meter: Meter
    journal: Journal
    kind: ModelKind = ModelKind.AS_DRAWN

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
        return self.views.indistinct * self.part.carriers.scale

    def allows_another(self, limits: Limits) -> bool:
        """Whether work is left for a model that takes as much as the first one did."""
        return self.meter.spent + self.took < min(_FURTHER, OTHERWISE * limits.work)


def search_for(part: PartModel, limits: Limits, meter: Meter) -> Search:
    """The search for labels of a part; its clauses are counted."""
    meter.count(Counted.CROSSING, sum(len(rule.groups) for rule in part.rules))
    return Search(part.rules, limits.effort, part.usual)
