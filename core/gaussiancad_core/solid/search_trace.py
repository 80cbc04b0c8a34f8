"""What was tried for a solid, in order: models, what each cost and gave up, and why it lost."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from enum import Enum

from gaussiancad_core.geometry.points import Point
from gaussiancad_core.labelling.visibility_rules import Rule
from gaussiancad_core.model.axes import Role, Vector
from gaussiancad_core.model.projection_planes import role_plane
from gaussiancad_core.model.views import Linetype

_MOST_PLACES = 12
"""Places that an attempt names at most, the longest lines first."""


class ModelKind(Enum):
    """How the drawing was understood."""

    AS_DRAWN = "as-drawn"
    SKETCH = "sketch"
    FEATURES = "features"
    OPEN_LINETYPES = "open-linetypes"
    CLOSED_OUTLINE = "closed-outline"
    LONE_BODIES = "lone-bodies"
    SMOOTH_ARCS = "without-rough-arcs"
    FOLLOWED_CURVES = "followed-curves"
    UNDRAWN_LINES = "undrawn-lines"
    LIKELY_MEASURES = "likely-measures"


class Outcome(Enum):
    """What became of a model."""

    ALL_LINES = "all-lines"
    DEVIATES = "deviates"
    UNSOUND = "unsound"
    OPEN = "faces-open"
    NOTHING = "no-material"
    CONTRADICTORY = "contradictory"
    UNFINISHED = "unfinished"
    TOO_LARGE = "too-large"


@dataclass(frozen=True)
class GivenUp:
    """A stretch of a view that the labels do not have as it is drawn.

    Attributes:
        role: the view.
        place: (right, up) mm in it.
        length: mm.
        drawn: its linetype; None where nothing is drawn.
    """

    role: Role
    place: Point
    length: float
    drawn: Linetype | None


@dataclass(frozen=True)
class Attempt:
    """One model of the drawing, and what came of it.

    Attributes:
        model: how the drawing was understood.
        outcome: what came of it.
        rules, cells: its size; 0 where it was too large to be made.
        work: units spent on it.
        cost: mm of line, drawn or blank, that the labels give up.
        given_up: where, longest first; not all of them.
        faces: of the solid; 0 if there is none.
        share: of all lines, both ways, that agree.
        flaws: places where the solid's lines and the sheet's differ.
        others: labels that were built beside the first, as they explain as much.
        open_at: mm, edges that bound one face only, where the faces do not close.
        taken: whether this is the solid that was delivered.
    """

    model: ModelKind
    outcome: Outcome
    rules: int = 0
    cells: int = 0
    work: float = 0.0
    cost: float = 0.0
    given_up: tuple[GivenUp, ...] = ()
    faces: int = 0
    share: float = 0.0
    flaws: int = 0
    others: int = 0
    open_at: tuple[Vector, ...] = field(default=(), repr=False)
    taken: bool = False


def given_up_places(rules: Sequence[Rule], scale: float) -> tuple[GivenUp, ...]:
    """Where labels break rules, longest first.

    Args:
        rules: that do not hold.
        scale: units per mm.
    """
    found = [
        GivenUp(
            rule.role,
            _in_view(rule.role, rule.point, scale),
            sum(piece.length for piece in rule.pieces) / scale,
            rule.linetype,
        )
        for rule in rules
    ]
    return tuple(sorted(found, key=lambda given_up: -given_up.length)[:_MOST_PLACES])


def cells_of(rules: Sequence[Rule]) -> int:
    """How many cells rules speak of."""
    cells = {
        cell
        for rule in rules
        for group in rule.groups
        for transition in group.all
        for cell in transition
    }
    return len(cells - {None})


def _in_view(role: Role, point: Point, scale: float) -> Point:
    right, up = role_plane(role).signs
    return point[0] * right / scale, point[1] * up / scale


class Journal:
    """The attempts of a search so far."""

    def __init__(self) -> None:
        self.attempts: list[Attempt] = []

    def add(self, attempt: Attempt) -> None:
        """One more attempt; its work is all that was done so far."""
        self.attempts.append(attempt)

    def finished(self, taken: int) -> tuple[Attempt, ...]:
        """The attempts, with the work that each took itself.

        Args:
            taken: number of the one whose solid was delivered.
        """
        starts = (0.0, *(attempt.work for attempt in self.attempts))
        return tuple(
            replace(attempt, work=attempt.work - start, taken=number == taken)
            for number, (attempt, start) in enumerate(zip(self.attempts, starts, strict=False))
        )
