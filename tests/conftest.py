"""Which tests are slow, in which order they run, and what was skipped.

``durations.json`` has the seconds of each test that took :data:`KEPT_S` or more when they were last
recorded (``make durations``).  Tests that took :data:`SLOW_S` or more are marked ``slow``; a test
that nobody has recorded counts as quick.  Files with the most seconds begin first, so that
processes side by side end at about the same time.
"""

import json
from collections import defaultdict
from pathlib import Path

import pytest

DURATIONS = Path(__file__).with_name("durations.json")

SLOW_S = 0.5
"""Seconds from which a test is none to run after each change."""

KEPT_S = 0.1
"""Seconds of the quickest tests that are recorded."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--record-durations", action="store_true", help="into tests/durations.json")
    parser.addoption("--skipped-to", type=Path, help="file for what was skipped, and why")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(_Recorder(), "gaussiancad-recorder")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    seconds: dict[str, float] = json.loads(DURATIONS.read_text(encoding="utf-8"))
    of_file: dict[str, float] = defaultdict(float)
    for item in items:
        spent = seconds.get(item.nodeid, 0.0)
        of_file[_file(item)] += spent
        if spent >= SLOW_S:
            item.add_marker(pytest.mark.slow)
    items.sort(key=lambda item: (-of_file[_file(item)], _file(item)))


def _file(item: pytest.Item) -> str:
    return item.nodeid.partition("::")[0]


class _Recorder:
    """Seconds of each test, its fixtures among them, and why tests were skipped."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self.skipped: dict[str, str] = {}

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[report.nodeid] += report.duration
        if report.skipped and isinstance(report.longrepr, tuple):
            self.skipped[report.nodeid] = report.longrepr[2].removeprefix("Skipped: ")

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if hasattr(session.config, "workerinput"):
            return
        path: Path | None = session.config.getoption("skipped_to")
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            lines = (f"{name}: {why}\n" for name, why in sorted(self.skipped.items()))
            path.write_text("".join(lines), encoding="utf-8")
        if session.config.getoption("record_durations"):
            kept = {name: round(s, 2) for name, s in sorted(self.seconds.items()) if s >= KEPT_S}
            DURATIONS.write_text(json.dumps(kept, indent=0) + "\n", encoding="utf-8")
