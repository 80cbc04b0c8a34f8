"""What a piece of a line says about the labels of the cells on both sides of it.

A ray on either side of the line crosses cells.  A crossing is a surface of the part if the labels
before and after it differ.  Crossings of both rays at one depth with parallel normals are partners;
how the line is drawn then follows from the labels by the rule of
:mod:`gaussiancad_core.lines.two_rays`.
"""

from collections.abc import Callable, Collection, Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from math import inf
from typing import TypeVar

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.cells.cell_complex import Cell, CellComplex, Crossing, parallel
from gaussiancad_core.cells.crossing_kernels import CLEAR, GROUP
from gaussiancad_core.cells.edge_fragments import Piece
from gaussiancad_core.cells.sight_lines import Keys, SightLines
from gaussiancad_core.coordinates.ambiguous_linetypes import is_unsure
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.tolerances import ASIDE
from gaussiancad_core.lines.two_rays import linetype_between
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.projection_planes import role_plane
from gaussiancad_core.model.views import Linetype

_KIND = 0.03
_MOST_KIND = 0.9
"""Weight of the linetype of a line that may be of either, as a share of the line's and at most."""

Transition = tuple[Cell | None, Cell | None]
"""From one cell into another; None is void by itself."""


@dataclass(frozen=True)
class Group:
    """Crossings at one depth.

    Attributes:
        pairs: transitions of one column and of the other through the same surface.
        lone: transitions without partner.
        all: every transition of the group.
    """

    pairs: tuple[tuple[Transition, Transition], ...]
    lone: tuple[Transition, ...]
    all: tuple[Transition, ...]


class Says(Enum):
    """What a rule says of its pieces: how they look; that a line is there; of which linetype it
    most likely is; that nothing is visible there, be there hidden lines or not."""

    ALL = "all"
    DRAWN = "drawn"
    KIND = "kind"
    UNSEEN = "unseen"


@dataclass(frozen=True)
class Rule:
    """What has to hold for one or more pieces to look as they do.

    Attributes:
        groups: from the viewer on.
        linetype: how the pieces are drawn; None if they are blank.
        weight: length of the pieces, in units, by confidence.
        role, point: of one of the pieces.
        pieces: all of them.
        says: what of it.
    """

    groups: tuple[Group, ...]
    linetype: Linetype | None
    weight: float
    role: Role
    point: Point
    pieces: tuple[Piece, ...] = field(default=(), compare=False, repr=False)
    says: Says = Says.ALL


Columns = Sequence[tuple[Crossing, ...]]
Seen = Callable[[Role, Sequence[Point], Columns], Columns | None]
"""Which crossings of columns at places of a view that shows; None where it says nothing of them."""


def rules_of(
    space: CellComplex,
    pieces: Iterable[Piece],
    cut: Collection[Role] = (),
    seen: Seen | None = None,
) -> list[Rule]:
    """Rules of pieces; those that say the same become one.

    Args:
        space: the cells.
        pieces: of all views.
        cut: views that do not show whole columns.
        seen: what these show of a column.
    """
    lines = SightLines(space)
    pieces = list(pieces)
    plain = [piece for piece in pieces if piece.role not in cut]
    rest = [piece for piece in pieces if piece.role in cut]
    if lines.fit:
        rules = _merged(lines.said(plain), _Decoder(lines.keys).groups)
    else:
        rules = _merged(_informative(space, plain), _as_they_are)
    return rules + _merged(_informative(space, rest, seen), _as_they_are)


Groups = tuple[Group, ...]

_Said = TypeVar("_Said", bound=Hashable)
"""Groups, or what tells them."""


def _informative(
    space: CellComplex, pieces: Sequence[Piece], seen: Seen | None = None
) -> Iterator[tuple[Piece, Groups]]:
    """Pieces that say something, and what: the plain way, for cells without keys and for columns
    that are cut."""
    for piece in pieces:
        groups = groups_at(space, piece, seen)
        if groups is not None:
            yield piece, groups


def _as_they_are(groups: Groups) -> Groups:
    return groups


class _Decoder:
    """What the kernels tell of pieces, as groups.  Equal ones are the same objects.

    Args:
        keys: of the cells.
    """

    def __init__(self, keys: Keys) -> None:
        self._keys = keys
        self._transitions: dict[tuple[int, int], Transition] = {}
        self._groups: dict[tuple[int, ...], Group] = {}

    def groups(self, content: bytes) -> Groups:
        """The groups of a piece."""
        numbers = memoryview(content).cast("q").tolist()
        found = []
        start = 0
        while start < len(numbers):
            pairs, lone, every = numbers[start : start + 3]
            end = start + 3 + 4 * pairs + 2 * (lone + every)
            items = tuple(numbers[start:end])
            group = self._groups.get(items)
            if group is None:
                group = self._groups[items] = self._group(items)
            found.append(group)
            start = end
        return tuple(found)

    def _group(self, numbers: tuple[int, ...]) -> Group:
        pairs, lone, _ = numbers[:3]
        every = [
            self._transition(one, other)
            for one, other in zip(numbers[3::2], numbers[4::2], strict=True)
        ]
        both, rest = every[: 2 * pairs], every[2 * pairs :]
        return Group(
            tuple(zip(both[::2], both[1::2], strict=True)), tuple(rest[:lone]), tuple(rest[lone:])
        )

    def _transition(self, one: int, other: int) -> Transition:
        found = self._transitions.get((one, other))
        if found is None:
            found = self._keys.cell(one), self._keys.cell(other)
            self._transitions[one, other] = found
        return found


def _merged(said: Iterable[tuple[Piece, _Said]], decoded: Callable[[_Said], Groups]) -> list[Rule]:
    found: dict[tuple[_Said, Linetype | None, bool], list[Piece]] = {}
    for piece, stated in said:
        unsure = piece.linetype is not None and is_unsure(piece)
        found.setdefault((stated, piece.linetype, unsure), []).append(piece)
    rules = []
    for (given, linetype, unsure), pieces in found.items():
        groups = decoded(given)
        place = pieces[0].role, pieces[0].point, tuple(pieces)
        if unsure:
            length = sum(piece.length for piece in pieces)
            kind = min(_MOST_KIND, _KIND * length)
            rules.append(Rule(groups, linetype, length, *place, Says.DRAWN))
            rules.append(Rule(groups, linetype, kind, *place, Says.KIND))
        else:
            weight = sum(piece.length * piece.confidence for piece in pieces)
            rules.append(Rule(groups, linetype, weight, *place))
    return rules


def groups_at(
    space: CellComplex, piece: Piece, seen: Seen | None = None
) -> tuple[Group, ...] | None:
    """Groups from the viewer on; None if the piece says nothing.

    The plain reference of what :mod:`gaussiancad_core.cells.sight_lines` does with many pieces at
    once.
    """
    plane = role_plane(piece.role)
    (a, b), (da, db) = piece.point, piece.across
    arrangement = space.planes[plane.normal]
    sides = [(a + way * da, b + way * db) for way in (-ASIDE, ASIDE)]
    blank = piece.linetype is None and all(arrangement.locate(*side) == 0 for side in sides)
    if blank or not _is_clear(arrangement, piece):
        return None
    one, other = (space.column(plane.normal, *side) for side in sides)
    if seen is not None:
        kept = seen(piece.role, sides, (one, other))
        if kept is None:
            return None
        one, other = kept
    pairs = _aligned(one, other)
    if pairs is not None:
        # Nearly all columns beside a line that is not drawn are alike.
        if piece.linetype is None and all(set(pair) == set(others) for pair, others in pairs):
            return None
        groups = [Group((pair,), (), tuple(dict.fromkeys(pair))) for pair in pairs]
    else:
        groups = []
        for members in _by_depth(one, other):
            group, doubtful = _group(*members)
            if doubtful and piece.linetype is not None:
                # Surfaces that pass smoothly into each other: a line may be drawn there or not.
                return None
            groups.append(group)
        if piece.linetype is None and all(_is_trivial(group) for group in groups):
            return None
    return tuple(groups if plane.looks_up else reversed(groups))


def _is_clear(arrangement: Arrangement, piece: Piece) -> bool:
    """Whether both sides of a piece are each one region around its point."""
    (a, b), (da, db) = piece.point, piece.across
    for way in (-CLEAR, CLEAR):
        here = arrangement.locate(a + 0.01 * way * da, b + 0.01 * way * db)
        for along in (-CLEAR, 0.0, CLEAR):
            at = a + way * da - along * db, b + way * db + along * da
            if arrangement.locate(*at) != here:
                return False
    return True


def _aligned(
    one: tuple[Crossing, ...], other: tuple[Crossing, ...]
) -> list[tuple[Transition, Transition]] | None:
    """The transitions of both columns, where they cross the same surfaces well apart."""
    if len(one) != len(other):
        return None
    last = -inf
    pairs = []
    for this, that in zip(one, other, strict=True):
        near, far = this.depth, that.depth
        if near > far:
            near, far = far, near
        if (
            this.surface != that.surface
            or far - near > GROUP
            or near - last <= GROUP
            or not parallel(this.normal, that.normal)
        ):
            return None
        pairs.append(((this.before, this.after), (that.before, that.after)))
        last = far
    return pairs


def _by_depth(
    one: tuple[Crossing, ...], other: tuple[Crossing, ...]
) -> list[tuple[list[Crossing], list[Crossing]]]:
    events = sorted(
        [(c.depth, 0, i) for i, c in enumerate(one)]
        + [(c.depth, 1, i) for i, c in enumerate(other)]
    )
    groups: list[tuple[list[Crossing], list[Crossing]]] = []
    last: float | None = None
    for depth, side, index in events:
        if last is None or depth - last > GROUP:
            groups.append(([], []))
        groups[-1][side].append((one, other)[side][index])
        last = depth
    return groups


def _group(one: list[Crossing], other: list[Crossing]) -> tuple[Group, bool]:
    """Partners within a group, and whether different surfaces are partners.

    Where a surface touches another one, as a cone the plane that its outline sweeps, both are met
    at nearly the same depth: each is its own partner, and the nearer one only where it has none.
    """
    if len(one) == len(other) == 1:
        (this,), (that,) = one, other
        # Nearly all groups are of this kind.
        if this.surface == that.surface and parallel(this.normal, that.normal):
            pair = _transition(this), _transition(that)
            return Group((pair,), (), tuple(dict.fromkeys(pair))), False
    free = list(range(len(other)))
    pairs: list[tuple[Transition, Transition]] = []
    left = []
    for crossing in one:
        same = [
            j
            for j in free
            if other[j].surface == crossing.surface and parallel(crossing.normal, other[j].normal)
        ]
        if same:
            best = _nearest(crossing, other, same)
            free.remove(best)
            pairs.append((_transition(crossing), _transition(other[best])))
        else:
            left.append(crossing)
    lone = []
    doubtful = False
    for crossing in left:
        partners = [j for j in free if parallel(crossing.normal, other[j].normal)]
        if not partners:
            lone.append(_transition(crossing))
            continue
        best = _nearest(crossing, other, partners)
        free.remove(best)
        pairs.append((_transition(crossing), _transition(other[best])))
        doubtful = True
    lone += [_transition(other[j]) for j in free]
    everything = [_transition(crossing) for crossing in (*one, *other)]
    return Group(tuple(pairs), tuple(lone), tuple(dict.fromkeys(everything))), doubtful


def _nearest(crossing: Crossing, others: list[Crossing], places: list[int]) -> int:
    return min(places, key=lambda j: abs(others[j].depth - crossing.depth))


def _transition(crossing: Crossing) -> Transition:
    return crossing.before, crossing.after


def _is_trivial(group: Group) -> bool:
    """Whether both columns do the same whatever the labels are."""
    return not group.lone and all(set(one) == set(other) for one, other in group.pairs)


def without_hidden(rules: Iterable[Rule], roles: Collection[Role]) -> tuple[Rule, ...]:
    """The rules where some views draw no hidden lines: what is blank there is only not visible."""
    return tuple(
        replace(rule, says=Says.UNSEEN)
        if rule.linetype is None and all(piece.role in roles for piece in rule.pieces)
        else rule
        for rule in rules
    )


def drawn_under(rule: Rule, labels: dict[Cell, bool]) -> Linetype | None:
    """What would be drawn at a rule's pieces if cells had these labels."""

    def solid(cell: Cell | None) -> bool:
        return cell is not None and labels.get(cell, False)

    def surface(transition: Transition) -> bool:
        return solid(transition[0]) != solid(transition[1])

    def differs(group: Group) -> bool:
        return any(surface(one) != surface(other) for one, other in group.pairs) or any(
            surface(transition) for transition in group.lone
        )

    return linetype_between(
        (differs(group), any(surface(transition) for transition in group.all))
        for group in rule.groups
    )


def holds(rule: Rule, labels: dict[Cell, bool]) -> bool:
    """Whether labels fulfil a rule."""
    drawn = drawn_under(rule, labels)
    if rule.says is Says.UNSEEN:
        return drawn is not Linetype.VISIBLE
    return drawn is not None if rule.says is Says.DRAWN else drawn is rule.linetype
