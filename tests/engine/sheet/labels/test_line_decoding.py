"""Part or annotation along a line."""

from collections.abc import Sequence
from itertools import product

import numpy as np
import pytest

from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.inked_shapes import InkedRun, InkedShape
from gaussiancad_core.sheet.labels import line_decoding
from gaussiancad_core.sheet.labels.ink_classes import Evidence, InkClass
from gaussiancad_core.sheet.labels.labels_network import InkLabels
from gaussiancad_core.sheet.labels.line_decoding import SharedInk, labelled_runs
from gaussiancad_core.sheet.tracing.ink_runs import Run

SIZE = 40, 300
NOWHERE = np.zeros(SIZE, bool)
MET = SharedInk(NOWHERE, ~NOWHERE)
"""Something ends at every point, and covers none."""

ALONE = SharedInk(NOWHERE, NOWHERE)


def labels_of(*pieces: tuple[int, InkClass, float]) -> InkLabels:
    """A sheet whose columns up to some px have a class with log-odds against all others."""
    log_p = np.full((len(InkClass), *SIZE), -9.0)
    start = 0
    for end, ink, odds in pieces:
        rest = (
            InkClass.DIMENSION if ink in (InkClass.VISIBLE, InkClass.HIDDEN) else InkClass.VISIBLE
        )
        log_p[ink, :, start:end] = -0.1
        log_p[rest, :, start:end] = -0.1 - odds
        start = end
    return InkLabels(log_p.astype(np.float16))


def line(*spans: tuple[float, float]) -> InkedShape:
    runs = tuple(InkedRun(Run(*span), 3.0) for span in spans)
    return InkedShape(Line((0.0, 20.0), (1.0, 0.0)), runs)


def test_a_line_is_parted_where_an_extension_line_goes_on() -> None:
    labels = labels_of((100, InkClass.VISIBLE, 4.0), (300, InkClass.DIMENSION, 4.0))
    edge, rest = labelled_runs(line((10.0, 200.0)), labels, MET)
    assert (edge.ink, rest.ink) == (InkClass.VISIBLE, InkClass.DIMENSION)
    assert edge.run.run.end == rest.run.run.start == pytest.approx(99.5, abs=1.0)
    assert (edge.run.run.start, rest.run.run.end) == (10.0, 200.0)
    assert edge.margin > 3.0 > -3.0 > rest.margin


def test_ink_that_runs_on_where_nothing_meets_it_is_of_one_kind() -> None:
    """An edge ends at edges: a stretch in its middle is no annotation, however sure."""
    labels = labels_of(
        (110, InkClass.VISIBLE, 4.0), (140, InkClass.DIMENSION, 4.0), (300, InkClass.VISIBLE, 4.0)
    )
    shape = line((10.0, 250.0))
    (edge,) = labelled_runs(shape, labels, ALONE)
    assert edge.is_part
    assert [piece.is_part for piece in labelled_runs(shape, labels, MET)] == [True, False, True]
    # Where another line ends at the edge, an extension line may go on.
    corner = NOWHERE.copy()
    corner[:, 107:113] = True
    labels = labels_of((110, InkClass.VISIBLE, 4.0), (300, InkClass.DIMENSION, 4.0))
    edge, rest = labelled_runs(shape, labels, SharedInk(NOWHERE, corner))
    assert (edge.is_part, rest.is_part) == (True, False)
    assert edge.run.run.end == pytest.approx(109.5, abs=1.0)


def test_a_short_doubt_parts_nothing() -> None:
    labels = labels_of(
        (100, InkClass.VISIBLE, 4.0), (112, InkClass.OTHER, 1.0), (300, InkClass.VISIBLE, 4.0)
    )
    (whole,) = labelled_runs(line((10.0, 200.0)), labels, MET)
    assert whole.is_part


def test_what_another_line_covers_says_nothing() -> None:
    labels = labels_of(
        (100, InkClass.DIMENSION, 4.0), (120, InkClass.VISIBLE, 4.0), (300, InkClass.DIMENSION, 4.0)
    )
    crossing = NOWHERE.copy()
    crossing[:, 98:122] = True
    (whole,) = labelled_runs(line((10.0, 200.0)), labels, SharedInk(crossing, ~NOWHERE))
    assert whole.ink is InkClass.DIMENSION
    assert len(labelled_runs(line((10.0, 200.0)), labels, MET)) == 3


def test_dashes_of_one_line_are_of_one_kind_where_they_are_in_doubt() -> None:
    labels = labels_of(
        (100, InkClass.HIDDEN, 4.0), (115, InkClass.CENTRE, 0.7), (300, InkClass.HIDDEN, 4.0)
    )
    found = labelled_runs(line((80.0, 92.0), (101.0, 113.0), (122.0, 134.0)), labels, MET)
    assert all(item.is_part for item in found)
    assert found[1].margin < 0.0
    assert [item.why for item in found] == [Evidence.NETWORK, Evidence.LINE, Evidence.NETWORK]
    # Turned alone, it would differ from both of its neighbours.
    assert found[1].support == pytest.approx(2 * 8.0 - 13 * 0.25 * 0.7**2 / 4.0, abs=0.1)


def test_a_pen_turns_a_doubt() -> None:
    labels = labels_of((300, InkClass.VISIBLE, 0.5))
    shape = line((10.0, 200.0))
    (plain,) = labelled_runs(shape, labels, MET)
    (thin,) = labelled_runs(
        shape, labels, MET, [lambda shape, run, log_p: np.full(len(log_p), -3.0)]
    )
    assert plain.is_part and plain.why is Evidence.NETWORK
    assert not thin.is_part and thin.why is Evidence.PEN
    assert (plain.otherwise(), thin.otherwise()) == (InkClass.DIMENSION, InkClass.VISIBLE)
    assert thin.turned().ink is InkClass.VISIBLE


def test_a_shape_without_ink_has_no_pieces() -> None:
    assert labelled_runs(line(), labels_of((300, InkClass.VISIBLE, 1.0)), MET) == []


def test_the_cheapest_assignment_is_the_best_of_all() -> None:
    random = np.random.default_rng(4)
    for _ in range(40):
        stated = random.normal(0.0, 2.0, 9)
        change = random.uniform(0.2, 3.0, 9)

        best = min(_cost(states, stated, change) for states in product((0, 1), repeat=9))
        found = line_decoding._cheapest(stated, change).astype(int)
        assert _cost(found, stated, change) == pytest.approx(best)


def _cost(states: Sequence[int], stated: np.ndarray, change: np.ndarray) -> float:
    turns = [change[k] for k in range(1, len(states)) if states[k] != states[k - 1]]
    return sum(turns) - sum(t * (s - 0.5) for t, s in zip(stated, states, strict=True))


def test_a_dash_is_what_the_others_of_its_row_are() -> None:
    """Something that looks otherwise crosses it; a line of another length after a gap is free."""
    assert line_decoding._rows([11.0, 12.0, 11.0, 11.0]).tolist() == [False, True, True, True]
    assert not line_decoding._rows([40.0, 38.0, 90.0]).any()
    labels = labels_of((100, InkClass.HIDDEN, 4.0), (300, InkClass.VISIBLE, 0.5))
    dashes = (62.0, 74.0), (82.0, 94.0), (102.0, 114.0)
    found = labelled_runs(line(*dashes), labels, MET)
    assert [item.ink for item in found] == [InkClass.HIDDEN] * 3
    alone = labelled_runs(line(dashes[-1]), labels, MET)
    assert [item.ink for item in alone] == [InkClass.VISIBLE]
