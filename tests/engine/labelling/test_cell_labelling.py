"""Labels that fulfil rules, and what is given up where they contradict each other."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations, pairwise, product
from math import inf

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.labelling import cell_labelling
from gaussiancad_core.labelling.cell_labelling import (
    Effort,
    Labelling,
    Labels,
    Others,
    Search,
)
from gaussiancad_core.labelling.counted_work import OVER, Deadline, Meter
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.labelling.solvers import relaxing_solver, solver_for
from gaussiancad_core.labelling.visibility_rules import Group, Rule, Transition, drawn_under
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

_CELLS: tuple[Cell, ...] = tuple((k, 1, 1, 0) for k in range(1, 5))
_EFFORT = Effort()

_PLACE: st.SearchStrategy[Cell | None] = st.sampled_from([None, *_CELLS])
_TRANSITION = st.tuples(_PLACE, _PLACE)


@st.composite
def _groups(draw: st.DrawFn) -> Group:
    pairs = tuple(draw(st.lists(st.tuples(_TRANSITION, _TRANSITION), max_size=2)))
    lone = tuple(draw(st.lists(_TRANSITION, max_size=2)))
    everything = (*(t for pair in pairs for t in pair), *lone)
    return Group(pairs, lone, tuple(dict.fromkeys(everything)))


_RULE = st.builds(
    Rule,
    st.lists(_groups(), min_size=1, max_size=3).map(tuple),
    st.sampled_from([None, Linetype.VISIBLE, Linetype.HIDDEN]),
    st.integers(1, 30).map(lambda tenths: tenths / 10.0),
    st.just(Role.FRONT),
    st.just((0.0, 0.0)),
)


def _best(rules: Sequence[Rule], effort: Effort = _EFFORT, *, relaxed: bool = True) -> Labelling:
    return Search(rules, effort).best(relaxed=relaxed)


def _others(
    rules: Sequence[Rule], found: Labelling, cells: Sequence[Cell], most: int = 40
) -> Others:
    return Search(rules, _EFFORT).others(found, cells, most)


def _broken(rules: Sequence[Rule], labels: Labels) -> list[Rule]:
    return [rule for rule in rules if drawn_under(rule, labels) is not rule.linetype]


def _all_labels() -> list[Labels]:
    return [
        dict(zip(_CELLS, bits, strict=True)) for bits in product((False, True), repeat=len(_CELLS))
    ]


@settings(max_examples=30)
@given(st.lists(_RULE, min_size=1, max_size=5))
def test_labels_are_found_where_there_are_any_and_they_hold(rules: list[Rule]) -> None:
    fitting = [labels for labels in _all_labels() if not _broken(rules, labels)]
    found = _best(rules, relaxed=False)
    assert found.complete
    assert (found.labels is not None) == bool(fitting)
    if found.labels is not None:
        assert found.given_up == () and _broken(rules, found.labels) == []


@settings(max_examples=15)
@given(st.lists(_RULE, min_size=2, max_size=5))
def test_what_is_given_up_is_told(rules: list[Rule]) -> None:
    found = _best(rules)
    assert found.labels is not None
    assert list(found.given_up) == _broken(rules, found.labels)
    heaviest = sum(rule.weight for rule in rules)
    assert sum(rule.weight for rule in found.given_up) <= heaviest


@settings(max_examples=12)
@given(st.lists(_RULE, min_size=1, max_size=3))
def test_all_others_are_enumerated(rules: list[Rule]) -> None:
    found = _best(rules, relaxed=False)
    if found.labels is None:
        return
    known = sorted(found.labels)
    fitting = {
        tuple(labels[cell] for cell in known)
        for labels in _all_labels()
        if not _broken(rules, labels)
    }
    others = _others(rules, found, known)
    assert others.complete
    stated = [tuple(labels[cell] for cell in known) for labels in (found.labels, *others.labels)]
    assert len(stated) == len(set(stated)) and set(stated) == fitting
    some = _others(rules, found, known, 1)
    assert len(some.labels) == min(1, len(fitting) - 1)
    assert some.complete == (len(fitting) == 1)


def _edge(one: Transition, linetype: Linetype | None, weight: float) -> Rule:
    return Rule((Group((), (one,), (one,)),), linetype, weight, Role.FRONT, (0.0, 0.0))


def test_the_lighter_of_two_rules_is_given_up() -> None:
    cell = _CELLS[0]
    kinds = ((None, Linetype.VISIBLE), (Linetype.VISIBLE, None))
    for (light, heavy), weight in product(kinds, (0.3, 1.5)):
        rules = [_edge((None, cell), light, weight), _edge((None, cell), heavy, 2.0)]
        found = _best(rules)
        assert found.given_up == (rules[0],)
        assert found.complete
        assert found.labels == {cell: heavy is not None}
        assert _best(rules, relaxed=False) == Labelling(None, (), True)


def test_of_labels_that_all_hold_those_with_fewest_surfaces_are_taken() -> None:
    # A view that shows the ends of a bar of four cells, and nothing of what is between.
    ends = [_edge((None, cell), Linetype.VISIBLE, 1.0) for cell in (_CELLS[0], _CELLS[3])]
    steps = tuple(pairwise(_CELLS))
    front = Group((), ((None, _CELLS[0]),), ((None, _CELLS[0]),))
    inside = Rule((front, Group((), steps, steps)), Linetype.VISIBLE, 1.0, Role.FRONT, (0.0, 0.0))
    found = _best([*ends, inside])
    assert found.labels == dict.fromkeys(_CELLS, True)


@given(st.lists(_RULE, min_size=1, max_size=6))
def test_what_is_given_up_weighs_least(rules: list[Rule]) -> None:
    found = _best(rules)
    assert found.labels is not None and found.complete

    def cost(labels: Labels) -> int:
        return sum(round(10.0 * rule.weight) for rule in _broken(rules, labels))

    every = (dict(zip(_CELLS, stated, strict=True)) for stated in product((False, True), repeat=4))
    assert cost(found.labels) == min(cost(labels) for labels in every)
    assert list(found.given_up) == _broken(rules, found.labels)


def test_others_may_give_up_a_little_more() -> None:
    one, two = _CELLS[:2]
    rules = [
        _edge((None, one), Linetype.VISIBLE, 20.0),
        _edge((None, one), None, 10.0),
        # Whether there is a second cell is told both ways, nearly alike.
        _edge((None, two), Linetype.VISIBLE, 5.0),
        _edge((None, two), None, 4.5),
    ]
    found = _best(rules)
    assert found.labels == {one: True, two: True}
    others = _others(rules, found, [one, two])
    assert others.labels == ({one: True, two: False},) and others.complete


def test_cells_that_do_not_count_make_no_others() -> None:
    rules = [_edge((None, _CELLS[0]), Linetype.VISIBLE, 1.0)]
    free = _edge((_CELLS[1], _CELLS[0]), Linetype.VISIBLE, 1.0)
    either = Rule(
        (Group((), ((_CELLS[2], _CELLS[0]), (None, _CELLS[2])), ()),),
        Linetype.VISIBLE,
        1.0,
        Role.FRONT,
        (0.0, 0.0),
    )
    rules += [free, either]
    found = _best(rules)
    all_cells = _others(rules, found, _CELLS)
    assert len(all_cells.labels) == 1 and all_cells.complete
    without = _others(rules, found, _CELLS[:2])
    assert without.labels == () and without.complete
    nothing = _others(rules, Labelling(None, (), True), _CELLS)
    assert nothing.labels == () and not nothing.complete


_NAMES = ("l-bracket", "counterbored-block")


@pytest.fixture(scope="module", params=_NAMES)
def rules(
    request: pytest.FixtureRequest, sample_views: Callable[[str], DrawnViews]
) -> tuple[Rule, ...]:
    return model_part(sample_views(request.param)).rules


def test_a_sound_drawing_needs_nothing_given_up(rules: tuple[Rule, ...]) -> None:
    found = _best(rules, relaxed=False)
    assert found.complete and found.labels is not None
    assert _broken(rules, found.labels) == []
    assert _best(rules) == found


def test_same_rules_same_labels(rules: tuple[Rule, ...]) -> None:
    assert _best(rules) == _best(rules)
    first = replace(rules[0], linetype=None if rules[0].linetype else Linetype.VISIBLE)
    contrary = (first, *rules)
    found = _best(contrary)
    assert found.given_up and found == _best(contrary)


@pytest.mark.parametrize("place", [0.1, 0.5, 0.9])
def test_one_wrong_line_is_given_up_and_only_that(rules: tuple[Rule, ...], place: float) -> None:
    truth = _best(rules).labels
    drawn = [i for i, rule in enumerate(rules) if rule.linetype is Linetype.VISIBLE]
    wrong = drawn[int(place * len(drawn))]
    # A speck of a line says nothing where there is one that all others speak of.
    flipped = replace(rules[wrong], linetype=None, weight=0.01)
    stated = [*rules[:wrong], flipped, *rules[wrong + 1 :]]
    if not _forced(rules, wrong):
        pytest.skip("the others do not tell this line")
    assert _best(stated, relaxed=False) == Labelling(None, (), True)
    found = _best(stated)
    assert found.given_up == (flipped,) and found.complete
    assert found.labels is not None and drawn_under(rules[wrong], found.labels) is not None
    assert _broken([r for i, r in enumerate(rules) if i != wrong], found.labels) == []
    assert truth is not None


def _forced(rules: tuple[Rule, ...], wrong: int) -> bool:
    flipped = replace(rules[wrong], linetype=None)
    stated = [*rules[:wrong], flipped, *rules[wrong + 1 :]]
    return _best(stated, relaxed=False).labels is None


def _more_than_places(places: int, weight: float) -> list[Rule]:
    """That each of some things is in one of fewer places, and no two in one: for clauses alone
    that is hard to refute."""
    solid = (0, 1, 1, 0)
    at = [[(thing + 1, place + 1, 1, 0) for place in range(places)] for thing in range(places + 1)]
    rules = [_edge((None, solid), Linetype.VISIBLE, weight)]
    for item in at:
        somewhere = Group((), tuple((None, cell) for cell in item), ())
        rules.append(replace(rules[0], groups=(somewhere,)))
    always = (None, solid)
    for place in range(places):
        for one, other in combinations([entry[place] for entry in at], 2):
            unless = Group((), (), ((one, solid),))
            here = Group((), ((None, other),), ((None, other),))
            behind = Group((), (), (always,)), Group((), (always,), (always,))
            groups = (unless, here, *behind)
            rules.append(replace(rules[0], groups=groups, linetype=Linetype.HIDDEN))
    return rules


def test_more_things_than_places_contradict_each_other() -> None:
    found = _best(_more_than_places(3, 1.0))
    assert found.complete and found.labels is not None
    assert len(found.given_up) == 1


def test_no_time_no_labels() -> None:
    rules = _more_than_places(9, 20.0)
    none = Effort(hard=1e-9, relaxed=1e-9, simplest=1e-9)
    found = _best(rules, none, relaxed=False)
    assert found == Labelling(None, (), False)
    assert not _best(rules, none).complete


def test_no_labels_after_the_deadline(rules: tuple[Rule, ...]) -> None:
    search, over = Search(rules, _EFFORT), OVER
    assert over.left == 0.0
    assert search.fulfilled(over) == Labelling(None, (), False)
    assert search.least(over) == Labelling(None, (), False)
    found = search.fulfilled()
    assert search.others(found, list(found.labels or {}), 4, deadline=over) == Others((), False)


def test_a_deadline_that_is_not_reached_changes_nothing(rules: tuple[Rule, ...]) -> None:
    late = Meter(guard=1e6).until(1e6)
    assert Search(rules, _EFFORT).fulfilled(late) == _best(rules)


def test_what_was_found_until_the_deadline_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    # Three light rules against three: more than the first search may give up.
    rules = [
        rule
        for cell in _CELLS[:3]
        for rule in (_edge((None, cell), None, 0.7), _edge((None, cell), Linetype.VISIBLE, 0.8))
    ]
    calls = []

    def solver(effort: float, deadline: Deadline) -> object:
        calls.append(effort)
        return relaxing_solver(effort, deadline if len(calls) == 1 else OVER)

    monkeypatch.setattr(cell_labelling, "relaxing_solver", solver)
    found = Search(rules, _EFFORT).least()
    assert len(calls) == 3
    assert not found.complete
    assert found.labels == dict.fromkeys(_CELLS[:3], True)
    assert list(found.given_up) == rules[::2]


def test_a_worse_answer_of_a_wider_search_is_not_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    # Rules too heavy for the narrow search to prove what it finds the least.
    rules = [_edge((None, cell), Linetype.VISIBLE, 5.0) for cell in _CELLS[:3]]
    rules += [_edge((None, cell), None, 4.0) for cell in _CELLS[:3]]
    search = Search(rules, replace(_EFFORT, simplest=1e-9))
    giving_up, weights = search._giving_up, []

    def interrupted(lightest: float, deadline: Deadline, most: float) -> object:
        weights.append(lightest)
        found, effort = giving_up(lightest, deadline, most)
        if lightest == inf and found is not None:
            worse = dict.fromkeys(_CELLS[:3], False)
            found = replace(found, labels=worse, cost=found.cost + 1)
        return found, effort

    monkeypatch.setattr(search, "_giving_up", interrupted)
    found = search.least()
    assert weights[-1] == inf
    assert found.labels == dict.fromkeys(_CELLS[:3], True)
    assert list(found.given_up) == rules[3:] and not found.complete


def test_what_takes_too_long_with_light_rules_is_not_tried_with_heavy_ones(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    rules = [_edge((None, cell), Linetype.VISIBLE, 5.0) for cell in _CELLS[:3]]
    rules += [_edge((None, cell), None, 4.0) for cell in _CELLS[:3]]
    search = Search(rules, _EFFORT)
    giving_up, weights = search._giving_up, []

    def unproved(lightest: float, deadline: Deadline, most: float) -> object:
        weights.append(lightest)
        found, _ = giving_up(lightest, deadline, most)
        return (None if found is None else replace(found, is_least=False, is_proved=False)), 2.0

    monkeypatch.setattr(search, "_giving_up", unproved)
    found = search.least()
    assert len(weights) == 2 and weights[-1] < inf
    assert found.effort == 2.0 * len(weights)
    assert list(found.given_up) == rules[3:] and not found.complete


def test_rules_that_contradict_each_other_without_some_are_told() -> None:
    one, two = _CELLS[:2]
    rules = [
        _edge((None, one), Linetype.VISIBLE, 3.0),
        _edge((None, one), None, 2.0),
        _edge((None, two), Linetype.VISIBLE, 1.0),
    ]
    search = Search(rules, _EFFORT)
    assert search.contradict([]) and search.contradict([2])
    assert not search.contradict([0]) and not search.contradict([1, 2])
    # Afterwards the least is found as ever.
    assert search.least() == _best(rules)


@pytest.mark.parametrize(("weight", "share"), [(3.0, 1.0), (9.0, 0.1)])
def test_where_much_is_given_up_the_simplest_labels_are_hardly_looked_for(
    weight: float, share: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    efforts = []

    def solver(effort: float, *_: object, **__: object) -> object:
        efforts.append(effort)
        return solver_for(effort)

    (one,) = _CELLS[:1]
    rules = [_edge((None, one), Linetype.VISIBLE, 20.0), _edge((None, one), None, weight)]
    search = Search(rules, _EFFORT)
    monkeypatch.setattr(cell_labelling, "solver_for", solver)
    assert search.least().given_up == (rules[1],)
    assert efforts == [share * _EFFORT.simplest]
