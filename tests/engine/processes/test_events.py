"""How a run is stopped."""

import contextlib
import signal
import time
from collections.abc import Iterator

import pytest

from gaussiancad_core.errors import CancelledError
from gaussiancad_core.processes import events
from gaussiancad_core.processes.events import Cancellation

_SIGNALS = (signal.SIGINT, signal.SIGTERM)


@pytest.fixture
def cancellation(monkeypatch: pytest.MonkeyPatch) -> Iterator[Cancellation]:
    monkeypatch.setattr(events, "_AGAIN_S", 0.1)
    before = [signal.getsignal(name) for name in _SIGNALS]
    made = Cancellation()
    yield made
    made.end()
    for name, handler in zip(_SIGNALS, before, strict=True):
        signal.signal(name, handler)


@pytest.mark.parametrize("name", _SIGNALS)
def test_a_signal_stops_the_run_with_its_name(
    name: signal.Signals, cancellation: Cancellation
) -> None:
    with pytest.raises(CancelledError, match=name.name):
        signal.raise_signal(name)


def test_what_was_lost_is_raised_again(cancellation: Cancellation) -> None:
    with contextlib.suppress(CancelledError):
        signal.raise_signal(signal.SIGTERM)
    # Meanwhile further signals change nothing.
    signal.raise_signal(signal.SIGTERM)
    with pytest.raises(CancelledError):
        time.sleep(60.0)


def test_after_the_end_nothing_is_raised(cancellation: Cancellation) -> None:
    cancellation.end()
    for name in _SIGNALS:
        signal.raise_signal(name)


def test_a_compiled_function_that_was_interrupted_stands_for_the_cancellation() -> None:
    cancelled = CancelledError("cancelled", "cancelled by SIGTERM")
    error = SystemError("returned a result with an exception set")
    error.__cause__ = cancelled
    assert events.cancellation_behind(error) is cancelled
    assert events.cancellation_behind(cancelled) is cancelled
    assert events.cancellation_behind(SystemError("of its own")) is None
