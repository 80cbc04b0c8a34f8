"""Labels that explain all of a drawing but the fewest strokes, and leave out the fewest lines.

A stroke that is not the part's is none along its whole length, and a line that a view lacks is
lacking from corner to corner, however long.  So rules are given up together: those of one stroke,
and those of one blank line between the places where strokes end.  Beyond some length none of these
counts for more than another.  That is far fewer choices than rules, and proved best far sooner.
"""

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Hashable, Sequence

from ortools.sat.python import cp_model

from gaussiancad_core.axes import Role
from gaussiancad_core.reasoning.clauses import Model, every, points_of
from gaussiancad_core.reasoning.curves import CircleCurve, Point
from gaussiancad_core.reasoning.labelling import Effort, Labelling
from gaussiancad_core.reasoning.part import PartModel
from gaussiancad_core.reasoning.pieces import Piece
from gaussiancad_core.reasoning.planes import role_plane
from gaussiancad_core.reasoning.rules import Says, holds
from gaussiancad_core.reasoning.solvers import FOUND, relaxing_solver, solver_for
from gaussiancad_core.reasoning.work import NEVER, Deadline

_MOST = 8.0
"""Units of line from which strokes, and lines that a view lacks, count alike."""

_ON = 1e-5
"""Units within which a piece lies on a support."""

_SAME = 1e-3
"""Units within which ends of strokes are at one place, and lines are one."""

_SURFACES = 0.1
"""Share of the time in which the simplest of such labels are looked for."""


def fewest_strokes(part: PartModel, effort: Effort, deadline: Deadline = NEVER) -> Labelling:
    """Labels under which as few strokes as possible are wrong and as few lines are lacking.

    Args:
        part: whose rules contradict each other.
        effort: deterministic time.
        deadline: by which the search ends.

    Returns:
        The labels; they are complete where no others give up less.
    """
    model = Model(part.rules, every)
    cost = _cost(model, part)
    model.model.minimize(cost)
    solver = relaxing_solver(effort.relaxed, deadline)
    status = solver.solve(model.model)
    spent = float(solver.response_proto.deterministic_time)
    if status not in FOUND:
        return Labelling(None, (), False, spent)
    labels, least = model.labels(solver), round(solver.objective_value)
    model.model.add(cost <= least)
    model.hint(labels)
    model.model.minimize(model.surfaces)
    simplest = solver_for(_SURFACES * effort.simplest, deadline=deadline)
    if simplest.solve(model.model) in FOUND:
        labels = model.labels(simplest)
    given_up = tuple(rule for rule in part.rules if not holds(rule, labels))
    return Labelling(labels, given_up, status == cp_model.OPTIMAL, spent)


def _cost(model: Model, part: PartModel) -> cp_model.LinearExpr:
    """What strokes and lacking lines that are given up weigh; rules are, if all theirs are."""
    lines = _Lines(part)
    weights: dict[Hashable, float] = defaultdict(float)
    literals: dict[Hashable, cp_model.IntVar] = {}
    for number, rule in enumerate(part.rules):
        escape = model.given_up.get(number)
        if escape is None:
            continue
        keys = {lines.of(piece) for piece in rule.pieces}
        if keys == {None} or rule.says is Says.KIND:
            literals[number] = escape
            weights[number] = rule.weight
            continue
        for piece in rule.pieces:
            weights[lines.of(piece)] += piece.length * piece.confidence
        for key in keys - {None}:
            if key not in literals:
                literals[key] = model.model.new_bool_var("")
            model.model.add_implication(escape, literals[key])
    return sum(points_of(min(weights[key], _MOST)) * literal for key, literal in literals.items())


class _Lines:
    """The strokes, and the blank lines between ends of strokes, that pieces lie on.

    Args:
        part: whose pieces are asked for.
    """

    def __init__(self, part: PartModel) -> None:
        self._planes = part.supports.planes
        self._ends = {
            role: _ends(part, role) for plane in self._planes.values() for role in plane.roles
        }
        self._on_line: dict[Hashable, list[float]] = {}
        self._known: dict[Piece, Hashable] = {}

    def of(self, piece: Piece) -> Hashable:
        """What tells the line of a piece from others; None if it lies on none."""
        if piece not in self._known:
            drawn = piece.linetype is not None
            self._known[piece] = self._stroke(piece) if drawn else self._blank(piece)
        return self._known[piece]

    def _stroke(self, piece: Piece) -> Hashable:
        for number, support in enumerate(self._planes[role_plane(piece.role).normal].supports):
            if support.curve.distance(piece.point) > _ON:
                continue
            at = support.curve.parameter(piece.point)
            for place, span in enumerate(support.spans.get(piece.role, ())):
                shows = span.confidence > 0.0 and span.linetype is piece.linetype
                if shows and span.low - _ON <= at <= span.high + _ON:
                    return piece.role, number, place
        return None

    def _blank(self, piece: Piece) -> Hashable:
        """Of a line parallel to an axis the stretch between two ends of strokes."""
        if min(map(abs, piece.across)) > 0.0:
            return None
        coordinate = 0 if piece.across[0] else 1
        value = piece.point[coordinate]
        line = piece.role, coordinate, round(value / _SAME)
        if line not in self._on_line:
            ends = self._ends[piece.role]
            on_line = (end for end in ends if abs(end[coordinate] - value) < _SAME)
            self._on_line[line] = sorted(end[1 - coordinate] for end in on_line)
        between = bisect_right(self._on_line[line], piece.point[1 - coordinate])
        return *line, between


def _ends(part: PartModel, role: Role) -> Sequence[Point]:
    """Where strokes of a view end, and the extremes of its circles."""
    found: list[Point] = []
    for support in part.supports.planes[role_plane(role).normal].supports:
        for span in support.spans.get(role, ()):
            if span.confidence > 0.0:
                found += [support.curve.at(span.low), support.curve.at(span.high)]
                if isinstance(support.curve, CircleCurve):
                    (x, y), radius = support.curve.centre, support.curve.radius
                    found += [(x + radius, y), (x - radius, y), (x, y + radius), (x, y - radius)]
    return found
