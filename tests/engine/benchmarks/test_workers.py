"""The seconds of child processes."""

import os
import time
from collections.abc import Iterator

import pytest

from benchmarks.run import workers
from benchmarks.run.workers import _Watch


@pytest.mark.parametrize(
    ("clock", "worked", "spent"),
    [
        (10.0, 10.0, 10.0),
        (10.0, 4.0, 4.0),
        (10.0, 25.0, 10.0),
        (10.0, 0.5, 2.5),
        (10.0, float("inf"), 10.0),
    ],
)
def test_work_counts_and_waiting_a_quarter(
    monkeypatch: pytest.MonkeyPatch, clock: float, worked: float, spent: float
) -> None:
    clocks: Iterator[float] = iter([100.0, 100.0 + clock])
    work: Iterator[float] = iter([7.0, 7.0 + worked])
    monkeypatch.setattr(workers.time, "monotonic", lambda: next(clocks))
    monkeypatch.setattr(_Watch, "_worked", lambda _: next(work))
    assert _Watch(os.getpid()).spent() == pytest.approx(spent)


def test_the_processors_seconds_are_seen() -> None:
    watch = _Watch(os.getpid())
    before, started = watch._worked(), time.process_time()
    while time.process_time() < started + 0.1:
        pass
    assert 0.05 < watch._worked() - before < float("inf")
