"""Blocks keep exactly the labels that rules allow, and what giving rules up costs."""

from collections.abc import Iterator, Sequence
from itertools import product

from hypothesis import given, settings
from hypothesis import strategies as st
from ortools.sat.python import cp_model

from gaussiancad_core.cells.cell_complex import Cell
from gaussiancad_core.labelling.clauses import SURFACES, Labels, Model, every, lighter, points
from gaussiancad_core.labelling.equivalence_classes import (
    Form,
    Look,
    NormalisedConstraint,
    NormalisedConstraints,
    eliminated,
    find_blocks,
    independent,
)
from gaussiancad_core.labelling.solvers import relaxing_solver, solver_for
from gaussiancad_core.labelling.visibility_rules import (
    Group,
    Rule,
    Says,
    Transition,
    drawn_under,
    holds,
)
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype

_CELLS: tuple[Cell, ...] = tuple((k, 1, 1, 0) for k in range(1, 9))
_PLACE: st.SearchStrategy[Cell | None] = st.sampled_from([None, *_CELLS])
_TRANSITION = st.tuples(_PLACE, _PLACE)


@st.composite
def _groups(draw: st.DrawFn) -> Group:
    pairs = tuple(draw(st.lists(st.tuples(_TRANSITION, _TRANSITION), max_size=2)))
    lone = tuple(draw(st.lists(_TRANSITION, max_size=1)))
    through = (*(t for pair in pairs for t in pair), *lone)
    return Group(pairs, lone, tuple(dict.fromkeys(through)))


_RULE = st.builds(
    Rule,
    st.lists(_groups(), min_size=1, max_size=3).map(tuple),
    st.sampled_from([None, None, Linetype.VISIBLE, Linetype.HIDDEN]),
    st.integers(1, 30).map(lambda tenths: tenths / 10.0),
    st.just(Role.FRONT),
    st.just((0.0, 0.0)),
    says=st.sampled_from([Says.ALL, Says.ALL, Says.DRAWN, Says.KIND]),
).map(lambda rule: rule if rule.linetype else _whole(rule))
_RULES = st.lists(_RULE, min_size=1, max_size=8)


def _whole(rule: Rule) -> Rule:
    """Where nothing is drawn: blank, or only not visible."""
    says = Says.UNSEEN if rule.says is Says.KIND else Says.ALL
    return Rule(rule.groups, None, rule.weight, rule.role, rule.point, says=says)


def _cells_of(rules: Sequence[Rule]) -> list[Cell]:
    through = (t for r in rules for g in r.groups for t in (*sum(g.pairs, ()), *g.lone, *g.all))
    return sorted({cell for transition in through for cell in transition if cell is not None})


def _all_labels(cells: Sequence[Cell]) -> Iterator[Labels]:
    for stated in product((False, True), repeat=len(cells)):
        yield dict(zip(cells, stated, strict=True))


def _sum(form: Form, chosen: int) -> bool:
    return (form & chosen).bit_count() % 2 == 1


@given(st.integers(1, 9), st.data())
def test_forms_are_all_solutions_of_the_equations(count: int, data: st.DataObject) -> None:
    equations = data.draw(st.lists(st.integers(0, 2**count - 1), max_size=12))
    free, forms = eliminated(equations, count)
    assert [forms[number] for number in free] == [1 << k for k in range(len(free))]
    solutions = {
        tuple(bool(x >> number & 1) for number in range(count))
        for x in range(2**count)
        if not any(_sum(equation, x) for equation in equations)
    }
    stated = [tuple(_sum(f, chosen) for f in forms) for chosen in range(2 ** len(free))]
    assert len(set(stated)) == len(stated) and set(stated) == solutions


@given(st.lists(st.integers(0, 2**8 - 1), max_size=12))
def test_all_forms_are_sums_of_the_independent_ones(forms: list[Form]) -> None:
    kept = independent(forms)
    sums = {0}
    for form in kept:
        more = {form ^ other for other in sums}
        assert not more & sums
        sums |= more
    assert set(forms) <= sums and set(kept) <= set(forms)


@given(_RULES, st.floats(0.0, 3.5))
def test_blocks_are_all_labels_under_which_blank_rules_hold(
    rules: list[Rule], lightest: float
) -> None:
    hard = [rule for rule in rules if rule.weight >= lightest]
    blocks = find_blocks(rules, lambda rule: rule.weight >= lightest)
    cells = _cells_of(rules)
    assert set(blocks.forms) == {None, *cells} and blocks.forms[None] == 0
    fitting = [
        labels
        for labels in _all_labels(cells)
        if all(holds(rule, labels) for rule in hard if _is_blank(rule))
    ]
    stated = [
        {cell: _sum(blocks.forms[cell], chosen) for cell in cells}
        for chosen in range(2 ** len(blocks.free))
    ]
    assert sorted(stated, key=_order) == sorted(fitting, key=_order)


def _is_blank(rule: Rule) -> bool:
    return rule.linetype is None and rule.says is Says.ALL


def _order(labels: Labels) -> list[tuple[Cell, bool]]:
    return sorted(labels.items())


@given(_RULES, st.floats(0.0, 3.5), st.data())
def test_what_is_said_of_blocks_is_what_rules_say(
    rules: list[Rule], lightest: float, data: st.DataObject
) -> None:
    blocks = find_blocks(rules, lambda rule: rule.weight >= lightest)
    chosen = data.draw(st.integers(0, 2 ** len(blocks.free) - 1))
    cells = _cells_of(rules)
    labels = {cell: _sum(blocks.forms[cell], chosen) for cell in cells}
    sayings = NormalisedConstraints(blocks)
    stated = [(sayings.of(rule), rule) for rule in rules]
    for said, rule in stated:
        assert _holds(said, chosen) == holds(rule, labels)
        if rule.weight >= lightest and _is_blank(rule):
            assert said.is_trivial
        assert not (said.is_trivial and not holds(rule, labels))
    pairs = {frozenset(t) for r in rules for g in r.groups for t in (*g.all, *g.lone)}
    solid = {None: False, **labels}
    differing = sum(len({solid[cell] for cell in pair}) == 2 for pair in pairs)
    assert differing == sum(n for form, n in blocks.surfaces.items() if _sum(form, chosen))


def _holds(said: NormalisedConstraint, chosen: int) -> bool:
    covered = False
    for place in said.places:
        if any(_sum(form, chosen) for form in place.differs):
            hidden = said.look in (Look.HIDDEN, Look.UNSEEN)
            return said.look is Look.DRAWN or (said.look is not Look.BLANK and hidden == covered)
        covered |= any(_sum(form, chosen) for form in place.covers)
    return said.look in (Look.BLANK, Look.UNSEEN)


@settings(max_examples=60)
@given(_RULES, st.floats(0.0, 3.5))
def test_models_have_the_labels_that_rules_allow(rules: list[Rule], lightest: float) -> None:
    hard = [rule for rule in rules if rule.weight >= lightest]
    cells = _cells_of(rules)
    fitting = [x for x in _all_labels(cells) if all(holds(rule, x) for rule in hard)]
    model = Model(rules, lighter(lightest))
    assert sorted(model.cells) == cells
    model.model.minimize(model.cost)
    solver = relaxing_solver(10.0)
    status = solver.solve(model.model)
    assert status == (cp_model.OPTIMAL if fitting else cp_model.INFEASIBLE)
    if not fitting:
        return

    def cost(labels: Labels) -> int:
        return sum(SURFACES * points(rule) for rule in rules if not holds(rule, labels))

    labels = model.labels(solver)
    assert labels in fitting
    least = min(map(cost, fitting))
    assert cost(labels) == least == round(solver.objective_value)
    known = {number for number, rule in enumerate(rules) if not holds(rule, labels)}
    assert known <= set(model.given_up)
    assert all(rules[number].weight < lightest for number in model.given_up)
    assert {n for n, literal in model.given_up.items() if solver.value(literal)} == known


@settings(max_examples=40)
@given(st.lists(_RULE, min_size=1, max_size=6), st.data())
def test_forbidden_labels_do_not_come_again(rules: list[Rule], data: st.DataObject) -> None:
    cells = _cells_of(rules)
    counting = data.draw(st.lists(st.sampled_from(cells), unique=True)) if cells else []
    fitting = {
        tuple(labels[cell] for cell in counting)
        for labels in _all_labels(cells)
        if all(holds(rule, labels) for rule in rules)
    }
    model = Model(rules)
    found = []
    while (solver := solver_for(10.0)).solve(model.model) == cp_model.OPTIMAL:
        labels = model.labels(solver)
        assert all(holds(rule, labels) for rule in rules)
        found.append(tuple(labels[cell] for cell in counting))
        model.forbid(labels, counting)
    assert len(found) == len(set(found)) and set(found) == fitting


def _lone(transition: Transition, linetype: Linetype | None, weight: float = 1.0) -> Rule:
    group = Group((), (transition,), (transition,))
    return Rule((group,), linetype, weight, Role.FRONT, (0.0, 0.0))


def test_cells_of_one_block_make_one_clause() -> None:
    one, two, three = _CELLS[:3]
    edges = [_lone((None, cell), Linetype.VISIBLE, 0.5) for cell in (one, two, three)]
    rules = [_lone((one, two), None, 4.0), _lone((three, two), None, 4.0), *edges]
    blocks = find_blocks(rules, lambda rule: rule.weight > 1.0)
    assert blocks.free == (one,)
    assert len(set(map(NormalisedConstraints(blocks).of, edges))) == 1
    model = Model(rules, lighter(1.0))
    assert set(model.given_up) == {2, 3, 4}
    assert len({literal.index for literal in model.given_up.values()}) == 1
    model.model.minimize(model.cost)
    solver = solver_for(1.0)
    assert solver.solve(model.model) == cp_model.OPTIMAL
    assert model.labels(solver) == dict.fromkeys((one, two, three), True)


def test_rules_that_may_all_be_given_up_make_no_blocks() -> None:
    one, two = _CELLS[:2]
    rules = [_lone((one, two), None), _lone((None, one), None), _lone((None, two), Linetype.HIDDEN)]
    assert find_blocks(rules, lambda _: False).free == (one, two)
    assert set(Model(rules, every).given_up) == {0, 1, 2}
    assert drawn_under(rules[2], {one: True, two: True}) is Linetype.VISIBLE
