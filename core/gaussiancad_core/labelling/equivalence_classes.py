"""Equivalence classes: what rules that have to hold imply before any solver is asked.

Nothing is drawn where two columns pass the same surfaces: of two crossings that are one surface
either both are the part's or none is.  With 1 for material and 0 for void that is one linear
equation over GF(2) of the labels before and after both crossings; a crossing that has no partner is
none of the part's, so that the labels around it are equal.  Where such rules cannot be given up
their equations are solved first.  The label of each cell then is a sum (exclusive or) of the labels
of a few free cells, its *form*; cells of one form are one block, those of form 0 are void.

What rules that are left say is said in forms, too.  Those that say nothing any more vanish, and
those that say the same become one.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.labelling.visibility_rules import Group, Rule, Says, Transition
from gaussiancad_core.model.views import Linetype

Form = int
"""A sum modulo 2 of labels of free cells: bit k stands for the k-th of them; 0 is void."""


@dataclass(frozen=True)
class EquivalenceClasses:
    """The labels that are left to choose, and what all others follow from.

    Attributes:
        free: cells whose labels may be chosen, each by itself.
        forms: of all cells that rules speak of, and of None, which is void.
        surfaces: how many different pairs of neighbours differ if a form is 1; none of form 0.
        halves: of forms of surfaces, and of differences between two surfaces, two forms whose sum
            they are: of cells, and of surfaces.
    """

    free: tuple[Cell, ...]
    forms: dict[Cell | None, Form]
    surfaces: dict[Form, int]
    halves: dict[Form, tuple[Form, Form]]

    def surface(self, transition: Transition) -> Form:
        """Which is 1 where a transition is a surface of the part."""
        return self.forms[transition[0]] ^ self.forms[transition[1]]


def find_blocks(rules: Sequence[Rule], must_hold: Callable[[Rule], bool]) -> EquivalenceClasses:
    """The forms of the cells of rules, some of which have to hold.

    Args:
        rules: of the part.
        must_hold: whether a rule may not be given up; those that say that nothing is drawn are
            equations.
    """
    # Groups that are equal are mostly the same object, and there are far fewer of these.
    groups = {id(group): group for rule in rules for group in rule.groups}
    equal = {
        id(group): group
        for rule in rules
        if rule.linetype is None and rule.says is Says.ALL and must_hold(rule)
        for group in rule.groups
    }
    pairs: dict[tuple[Transition, Transition], None] = {}
    met: dict[Transition, None] = {}
    for group in groups.values():
        pairs.update(dict.fromkeys(group.pairs))
        met.update(dict.fromkeys(group.lone))
        met.update(dict.fromkeys(group.all))
    met.update((one, None) for pair in pairs for one in pair)
    numbers: dict[Cell, int] = {}
    for transition in met:
        for cell in transition:
            if cell is not None:
                numbers.setdefault(cell, len(numbers))
    single: dict[Cell | None, int] = {cell: 1 << number for cell, number in numbers.items()}
    single[None] = 0
    free, solved = eliminated(_equations(equal.values(), single), len(numbers))
    forms: dict[Cell | None, Form] = dict(zip(numbers, solved, strict=True))
    forms[None] = 0
    cells = tuple(numbers)
    return EquivalenceClasses(
        tuple(cells[number] for number in free),
        forms,
        _surfaces(met, forms),
        _halves(met, pairs, forms),
    )


def _equations(groups: Iterable[Group], single: dict[Cell | None, int]) -> Iterator[int]:
    """Sums of labels, a bit a cell, that are 0 where nothing differs."""
    for group in groups:
        for (a, b), (c, d) in group.pairs:
            yield single[a] ^ single[b] ^ single[c] ^ single[d]
        for a, b in group.lone:
            yield single[a] ^ single[b]


def _surfaces(met: Iterable[Transition], forms: dict[Cell | None, Form]) -> dict[Form, int]:
    both_ways = {frozenset(transition) for transition in met}
    found: Counter[Form] = Counter()
    for neighbours in both_ways:
        if len(neighbours) > 1:
            one, other = neighbours
            found[forms[one] ^ forms[other]] += 1
    del found[0]
    return dict(sorted(found.items()))


def _halves(
    met: Iterable[Transition],
    pairs: Iterable[tuple[Transition, Transition]],
    forms: dict[Cell | None, Form],
) -> dict[Form, tuple[Form, Form]]:
    single = set(forms.values())
    found: dict[Form, tuple[Form, Form]] = {}
    surfaces: dict[Transition, Form] = {}
    for transition in met:
        one, other = forms[transition[0]], forms[transition[1]]
        surfaces[transition] = form = one ^ other
        if form not in single:
            found.setdefault(form, (one, other))
    for transitions in pairs:
        one, other = surfaces[transitions[0]], surfaces[transitions[1]]
        form = one ^ other
        if form not in single:
            found.setdefault(form, (one, other))
    return found


def eliminated(equations: Iterable[int], count: int) -> tuple[list[int], list[Form]]:
    """Solve homogeneous linear equations over GF(2).

    Args:
        equations: sums that are 0, bit i standing for the i-th variable.
        count: of variables.

    Returns:
        The variables that stay free, ascending, and the form of each variable over these.
    """
    leading: dict[int, int] = {}
    for equation in sorted(set(equations), key=_length):
        rest = _rest(equation, leading)
        if rest:
            leading[rest.bit_length() - 1] = rest
    free: list[int] = []
    forms: list[Form] = []
    for number in range(count):
        leader = leading.get(number)
        if leader is None:
            forms.append(1 << len(free))
            free.append(number)
            continue
        form = 0
        for lower in _bits(leader ^ 1 << number):
            form ^= forms[lower]
        forms.append(form)
    return free, forms


def _bits(number: int) -> Iterator[int]:
    """Places of the ones of a number, ascending."""
    while number:
        lowest = number & -number
        yield lowest.bit_length() - 1
        number ^= lowest


def independent(forms: Iterable[Form]) -> list[Form]:
    """Some of the forms, the shortest ones, that all the others are sums of."""
    leading: dict[int, int] = {}
    kept = []
    for form in sorted(set(forms), key=_length):
        rest = _rest(form, leading)
        if rest:
            leading[rest.bit_length() - 1] = rest
            kept.append(form)
    return kept


def _length(number: int) -> tuple[int, int]:
    return number.bit_count(), number


def _rest(number: int, leading: dict[int, int]) -> int:
    """A sum without the highest bits of others, which are known by these."""
    while number and (other := leading.get(number.bit_length() - 1)) is not None:
        number ^= other
    return number


class Look(Enum):
    """How pieces of lines look."""

    BLANK = "blank"
    UNSEEN = "unseen"
    DRAWN = "drawn"
    VISIBLE = "visible"
    HIDDEN = "hidden"


@dataclass(frozen=True)
class Place:
    """What a rule says of one depth.

    Attributes:
        differs: forms of which one is 1 where both columns differ there.
        covers: forms of which one is 1 where that depth hides what lies behind it; those that
            nearer places name are left out.
    """

    differs: tuple[Form, ...]
    covers: tuple[Form, ...]


@dataclass(frozen=True)
class NormalisedConstraint:
    """What a rule says, in forms.  Rules with equal sayings hold under the same labels.

    Attributes:
        look: of its pieces.
        places: from the viewer on; where linetypes do not matter, a single one that covers nothing.
        kind: whether it only tells the likelier linetype.
    """

    look: Look
    places: tuple[Place, ...]
    kind: bool = False

    @property
    def is_trivial(self) -> bool:
        """Whether it holds under all labels."""
        return self.look in (Look.BLANK, Look.UNSEEN) and not self.places


class NormalisedConstraints:
    """What rules say, in forms.

    Args:
        blocks: of the rules.
    """

    def __init__(self, blocks: EquivalenceClasses) -> None:
        self._blocks = blocks
        # By the identities of groups, which are kept as well: few are equal and not the same.
        self._places: dict[int, tuple[Place, Group]] = {}

    def of(self, rule: Rule) -> NormalisedConstraint:
        """What a rule says of blocks."""
        stated_places = [self._place(group) for group in rule.groups]
        blank = rule.linetype is None and rule.says is not Says.UNSEEN
        if blank or rule.says is Says.DRAWN:
            every = tuple(dict.fromkeys(form for place in stated_places for form in place.differs))
            look = Look.BLANK if blank else Look.DRAWN
            return NormalisedConstraint(look, (Place(every, ()),) if every else ())
        places: list[Place] = []
        last = 0
        covering: set[Form] = set()
        for place in stated_places:
            new = tuple(form for form in place.covers if form not in covering)
            covering.update(new)
            if place.differs or new:
                places.append(Place(place.differs, new))
            if place.differs:
                last = len(places)
        # Behind the last difference nothing is to be hidden.
        places = [*places[: last - 1], Place(places[last - 1].differs, ())] if last else []
        look = Look.UNSEEN
        if rule.linetype is not None:
            look = Look.VISIBLE if rule.linetype is Linetype.VISIBLE else Look.HIDDEN
        return NormalisedConstraint(look, tuple(places), rule.says is Says.KIND)

    def _place(self, group: Group) -> Place:
        known = self._places.get(id(group))
        if known is None:
            surface = self._blocks.surface
            differs = [surface(one) ^ surface(other) for one, other in group.pairs]
            differs += map(surface, group.lone)
            place = Place(_known(differs), _known(map(surface, group.all)))
            known = self._places[id(group)] = place, group
        return known[0]


def _known(forms: Iterable[Form]) -> tuple[Form, ...]:
    """Different forms but that of void."""
    return tuple(form for form in dict.fromkeys(forms) if form)
