"""Which lines contradict each other: a smallest set of strokes that no solid can have together.

Where no labels fulfil all rules, the drawing contradicts itself, or shows what cells cannot
express.  Every rule belongs to a stroke, or to a line of the view on which nothing is drawn.  A
core of them is found by CP-SAT and made minimal by deletion (Bakker et al., 1993; groups as in
Nadel, 2010): it contradicts itself, and no longer does without any one of its members.  A member
without which all *other* lines of the drawing agree is a suspect.  Since a solid that has all right
lines fulfils their rules, every core has a wrong line in it, or a place where one is missing.  An
outline that is open contradicts everything; there the gap is told.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
from ortools.sat.python import cp_model

from gaussiancad_core.cells.edge_fragments import SHARE, Piece
from gaussiancad_core.coordinates.stroke_finder import StrokeFinder
from gaussiancad_core.errors import LimitError
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.hypotheses.open_outlines import find_gaps
from gaussiancad_core.labelling.cell_labelling import SLIGHT
from gaussiancad_core.labelling.clauses import Labels, Model, every
from gaussiancad_core.labelling.conflict_lines import Conflict, ConflictLine
from gaussiancad_core.labelling.part_model import PartModel, model_part
from gaussiancad_core.labelling.solvers import FOUND, solver_for
from gaussiancad_core.labelling.visibility_rules import Rule, drawn_under
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.projection_planes import role_plane
from gaussiancad_core.model.views import Linetype, Segment

_ORDERS = 3
"""Orders in which members are tried; the smallest core of all is kept."""

_SMALL = 3
"""Members of a core that needs no other order."""

_PLACES = 3
"""Decimals of units that tell lines without strokes apart."""

_LONGEST_CORE = 60
"""Members up to which a core is made minimal: longer ones tell nobody anything."""

_CLOSINGS = 4
"""Lines that would close an outline that are tried: each is a whole new part."""

_FEW_RULES = 1000
"""Rules of a part up to which they are."""

_LEAST_EFFORT = 0.1
"""Deterministic time for seeing whether all lines agree, at least."""

_LEAST_COST = 0.02
"""Deterministic time that each question counts at least: the solver does not count all it does."""

Key = tuple[Role, bool, tuple[float, ...]]
"""A stroke of a view by its number (drawn), or a line of it by direction and place (blank)."""


def find_conflict(part: PartModel, views: DrawnViews, effort: float) -> Conflict | None:
    """A smallest set of lines that contradict each other.

    Args:
        part: cells and rules of the views.
        views: whose strokes are told.
        effort: deterministic time of the search.

    Returns:
        None if the lines do not contradict each other, or it is not known in time.
    """
    rules = [rule for rule in part.rules if rule.weight >= SLIGHT]
    grouped = _by_line(rules, views, part.carriers.scale)
    search = _Cores(rules, grouped, effort)
    core = search.core(list(grouped))
    if core is None:
        return None
    members, minimal = search.smallest(core)
    lines = []
    for key in members:
        labels = search.labels_without(key)
        lines.append(_line(key, grouped[key], views, part.carriers.scale, labels))
    lines.sort(key=lambda line: not line.suspect)
    found = Conflict(tuple(lines), minimal)
    if found.suspects:
        return found
    return _open_outlines(views, search.left, tried=len(rules) <= _FEW_RULES) or found


def _open_outlines(views: DrawnViews, effort: float, *, tried: bool) -> Conflict | None:
    """The lines that would close the outlines of open views, if ``tried`` as others agree."""
    gaps = find_gaps(views)
    lines = [
        ConflictLine(gap.role, gap.closing[0], None, suspect=True, fitting=Linetype.VISIBLE)
        for gap in gaps
    ]
    if tried and len(gaps) == 1 and len(gaps[0].closing) > 1:
        # The other views tell which of them is meant.
        fitting = (
            ends
            for ends in gaps[0].closing[:_CLOSINGS]
            if _agree_with(views, gaps[0].role, ends, effort)
        )
        lines = [replace(lines[0], points=next(fitting, gaps[0].closing[0]))]
    return Conflict(tuple(lines), minimal=False) if lines else None


def _agree_with(
    views: DrawnViews, role: Role, ends: npt.NDArray[np.float64], effort: float
) -> bool:
    """Whether all lines agree once there is a further visible one."""
    start, end = ends.tolist()
    strokes = (*views.strokes[role], Segment(tuple(start), tuple(end), Linetype.VISIBLE))
    closed = replace(views, strokes={**views.strokes, role: strokes})
    try:
        part = model_part(closed)
    except LimitError:
        return False
    rules = [rule for rule in part.rules if rule.weight >= SLIGHT]
    model = Model(rules)
    return solver_for(max(effort, _LEAST_EFFORT)).solve(model.model) in FOUND


@dataclass(frozen=True)
class _Member:
    """What a rule says at one piece of a line."""

    number: int
    rule: Rule
    piece: Piece


def _by_line(
    rules: Sequence[Rule], views: DrawnViews, scale: float
) -> dict[Key, tuple[_Member, ...]]:
    finders = {role: StrokeFinder(views.strokes[role]) for role in views.roles}
    grouped: dict[Key, list[_Member]] = {}
    for number, rule in enumerate(rules):
        for piece in rule.pieces:
            if piece.linetype is None:
                key = _blank_key(piece)
            else:
                place = np.array(piece.point) * role_plane(piece.role).signs / scale
                found = finders[piece.role].nearest(place, piece.linetype)
                key = _blank_key(piece) if found is None else (piece.role, True, (float(found),))
            grouped.setdefault(key, []).append(_Member(number, rule, piece))
    return {key: tuple(members) for key, members in grouped.items()}


def _blank_key(piece: Piece) -> Key:
    """Pieces of one straight line have one key; those of a circle have one each."""
    (a, b), (da, db) = piece.point, piece.across
    offset = a * da + b * db
    if offset < 0.0:
        da, db, offset = -da, -db, -offset
    line = (da, db, offset)
    return piece.role, False, tuple(round(value, _PLACES) + 0.0 for value in line)


class _Cores:
    """Looks for sets of lines that contradict each other, within one deterministic time.

    Args:
        rules: of the part.
        grouped: members of each line.
        effort: deterministic time.

    Attributes:
        left: of that time.
    """

    def __init__(
        self, rules: Sequence[Rule], grouped: Mapping[Key, tuple[_Member, ...]], effort: float
    ) -> None:
        self._rules = rules
        self._grouped = grouped
        self.left = effort
        self._whole = _Switched(rules, grouped)

    def core(self, keys: Sequence[Key]) -> list[Key] | None:
        """Lines among some that contradict each other; None if they agree or time is over."""
        status, core, _ = self._solve(self._whole, keys)
        return core if status == cp_model.INFEASIBLE else None

    def smallest(self, core: list[Key]) -> tuple[list[Key], bool]:
        """The smallest set within a core that is found; whether none of it can be left out."""
        numbers = sorted({member.number for key in core for member in self._grouped[key]})
        place = {number: index for index, number in enumerate(numbers)}
        within = {
            key: tuple(
                _Member(place[member.number], member.rule, member.piece)
                for member in self._grouped[key]
            )
            for key in core
        }
        small = _Switched([self._rules[number] for number in numbers], within)
        best, minimal = core, False
        random = np.random.default_rng(0)
        for order in range(_ORDERS):
            if order == 0:
                # Long lines are given up first: what is left is short, and easily looked at.
                tried = sorted(core, key=lambda key: -self._length(key))
            else:
                tried = [core[i] for i in random.permutation(len(core))]
            found, proved = self._reduced(small, tried)
            if (not proved, len(found)) < (not minimal, len(best)):
                best, minimal = found, proved
            if minimal and len(best) <= _SMALL:
                break
        return best, minimal

    def labels_without(self, key: Key) -> Labels | None:
        """Labels that fulfil all lines but one, and most of that; None if there are none."""
        others = [other for other in self._grouped if other != key]
        status, _, labels = self._solve(self._whole, others, least=key)
        return labels if status in FOUND else None

    def _length(self, key: Key) -> float:
        return sum(member.piece.length for member in self._grouped[key])

    def _reduced(self, model: "_Switched", core: list[Key]) -> tuple[list[Key], bool]:
        """Without whatever is not needed for the contradiction."""
        needed: list[Key] = []
        open_ = list(core)
        proved = len(core) <= _LONGEST_CORE
        while open_ and proved:
            tried, *rest = open_
            status, smaller, _ = self._solve(model, [*needed, *rest])
            if status == cp_model.INFEASIBLE:
                kept = set(smaller)
                open_ = [key for key in rest if key in kept]
                continue
            proved = status in FOUND
            needed.append(tried)
            open_ = rest
        return [*needed, *open_], proved

    def _solve(
        self, model: "_Switched", on: Sequence[Key], least: Key | None = None
    ) -> tuple[cp_model.CpSolverStatus, list[Key], Labels | None]:
        """Status, a core of what is on, and labels."""
        if self.left <= 0.0:
            return cp_model.UNKNOWN, list(on), None
        solver = solver_for(self.left)
        status, core = model.solve(solver, on, least)
        self.left -= max(solver.response_proto.deterministic_time, _LEAST_COST)
        return status, core, model.labels(solver) if status in FOUND else None


class _Switched:
    """Rules as clauses, with a switch for each line.

    Args:
        rules: of the lines.
        grouped: members of each line, numbered as the rules are.
    """

    def __init__(self, rules: Sequence[Rule], grouped: Mapping[Key, Iterable[_Member]]) -> None:
        self._model = Model(rules, every)
        self._switches: dict[Key, cp_model.IntVar] = {}
        self._numbers = {key: {m.number for m in members} for key, members in grouped.items()}
        for key, numbers in self._numbers.items():
            switch = self._model.model.new_bool_var("")
            self._switches[key] = switch
            for number in sorted(numbers & self._model.given_up.keys()):
                self._model.model.add_implication(switch, ~self._model.given_up[number])

    def solve(
        self, solver: cp_model.CpSolver, on: Sequence[Key], least: Key | None
    ) -> tuple[cp_model.CpSolverStatus, list[Key]]:
        """Fulfil the lines that are on, and as much as can be of one that is not."""
        model = self._model.model
        model.clear_assumptions()
        model.clear_objective()
        model.add_assumptions([self._switches[key] for key in on])
        if least is not None:
            given_up = self._model.given_up
            model.minimize(sum(given_up[n] for n in sorted(self._numbers[least] & given_up.keys())))
        status = solver.solve(model)
        if status != cp_model.INFEASIBLE:
            return status, []
        by_index = {self._switches[key].index: key for key in on}
        found = solver.sufficient_assumptions_for_infeasibility()
        return status, [by_index[index] for index in found if index in by_index] or list(on)

    def labels(self, solver: cp_model.CpSolver) -> Labels:
        """The labels of a solution."""
        return self._model.labels(solver)


def _line(
    key: Key,
    members: Sequence[_Member],
    views: DrawnViews,
    scale: float,
    labels: Labels | None,
) -> ConflictLine:
    """What is shown of a line; of a suspect, how it would be drawn instead."""
    role, drawn, place = key
    stroke = views.strokes[role][int(place[0])] if drawn else None
    linetype = stroke.linetype if stroke is not None else None
    fitting, wrong = linetype, []
    if labels is not None:
        would_be = [(drawn_under(member.rule, labels), member) for member in members]
        wrong = [(found, member) for found, member in would_be if found is not linetype]
        if wrong:
            fitting = max(wrong, key=lambda pair: pair[1].piece.length)[0]
    if stroke is not None:
        points = stroke.sample(max(stroke.length / 32.0, 1e-9))
    else:
        shown = [member for _, member in wrong] or members
        points = _extent([m.piece for m in shown]) * role_plane(role).signs / scale
    return ConflictLine(role, points, linetype, labels is not None, fitting)


def _extent(pieces: Sequence[Piece]) -> npt.NDArray[np.float64]:
    """(2, 2) both ends of pieces of one line, in plane units."""
    ends = np.array([end for piece in pieces for end in _ends(piece)])
    along = ends @ _direction(pieces[0])
    return ends[[int(along.argmin()), int(along.argmax())]]


def _ends(piece: Piece) -> tuple[Point, Point]:
    da, db = _direction(piece)
    low = piece.point[0] - SHARE * piece.length * da, piece.point[1] - SHARE * piece.length * db
    return low, (low[0] + piece.length * da, low[1] + piece.length * db)


def _direction(piece: Piece) -> npt.NDArray[np.float64]:
    """(2,) along a piece, towards larger coordinates."""
    along = np.array([-piece.across[1], piece.across[0]])
    return along if (along[0], along[1]) > (-along[0], -along[1]) else -along
