"""Work is counted; the clock only guards."""

from math import inf

import pytest
from ortools.sat.python import cp_model

from gaussiancad_core.labelling.counted_work import NEVER, OVER, Counted, Meter
from gaussiancad_core.labelling.solvers import FOUND, solver_for


def test_work_ends_where_it_was_counted_to() -> None:
    meter = Meter()
    deadline = meter.until(2.0)
    assert deadline.left == 2.0
    deadline.count(Counted.PIECE, round(1.0 / Counted.PIECE.value))
    assert meter.spent == pytest.approx(1.0, rel=1e-3)
    assert deadline.left == pytest.approx(1.0, rel=1e-3)
    deadline.add(3.0)
    assert deadline.left == 0.0 and meter.until(inf).left == inf


def test_steps_have_what_was_done_since_the_last() -> None:
    meter = Meter()
    meter.add(1.0)
    meter.lap("model")
    meter.add(2.0)
    meter.lap("label")
    meter.add(0.5)
    meter.lap("model")
    assert meter.work == pytest.approx({"model": 1.5, "label": 2.0})
    assert set(meter.seconds) == {"model", "label"}
    assert sum(meter.work.values()) == pytest.approx(meter.spent)


def test_the_guard_ends_everything_and_is_told() -> None:
    meter = Meter(guard=0.0)
    assert meter.until(inf).left == 0.0
    assert meter.is_overrun
    assert not Meter(guard=1e6).is_overrun


def test_what_is_neither_counted_nor_ended() -> None:
    NEVER.add(1e9)
    NEVER.count(Counted.EDGE, 10)
    assert (NEVER.left, NEVER.seconds_left, OVER.left) == (inf, inf, 0.0)


def _queens(count: int) -> cp_model.CpModel:
    model = cp_model.CpModel()
    places = [model.new_int_var(0, count - 1, "") for _ in range(count)]
    model.add_all_different(places)
    for way in (1, -1):
        model.add_all_different([place + way * row for row, place in enumerate(places)])
    return model


def test_what_a_solver_does_counts_and_is_the_same_each_time() -> None:
    spent = []
    for _ in range(2):
        meter = Meter()
        assert solver_for(10.0, deadline=meter.until(100.0)).solve(_queens(12)) in FOUND
        spent.append(meter.spent)
    assert spent[0] == spent[1] > 0.0


def test_a_solver_has_no_more_than_is_left() -> None:
    meter = Meter()
    meter.add(7.0)
    solver = solver_for(10.0, deadline=meter.until(7.5))
    assert solver.parameters.max_deterministic_time == 0.5
    assert solver.parameters.max_time_in_seconds == inf
    guarded = solver_for(10.0, deadline=Meter(guard=50.0).until(3.0))
    assert guarded.parameters.max_time_in_seconds <= 50.0
