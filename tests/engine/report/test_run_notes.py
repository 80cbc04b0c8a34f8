"""What a run tells goes into its report, and warnings go out at once."""

import json
from typing import Any

import pytest

from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.processes.events import Progress
from gaussiancad_core.report.report_entries import Assumption
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.report.run_report import Report


class Heard:
    """A listener that keeps all events."""

    def __init__(self) -> None:
        self.events: list[tuple[str, dict[str, Any]]] = []

    def send(self, event: str, **fields: Any) -> None:  # noqa: ANN401
        self.events.append((event, fields))


@pytest.fixture
def heard() -> Heard:
    return Heard()


@pytest.fixture
def notes(heard: Heard) -> RunNotes:
    return RunNotes(Report("", {}), Progress(heard, 2))


def test_values_go_with_a_message_into_the_event_and_the_report(
    notes: RunNotes, heard: Heard
) -> None:
    notes.warn("lines-left-out", Message("{count} groups", count=2))
    notes.doubt("two-views", "two")
    notes.tell(assumptions=(Assumption("a", Message("{view}", view=Role.TOP), None, "b"),))
    stated = {"code": "lines-left-out", "message": "2 groups", "args": {"count": 2}}
    assert heard.events == [("warning", stated)]
    written = json.loads(json.dumps(notes.report.as_json()))
    assert written["warnings"] == [stated]
    assert written["reasons"] == [{"code": "two-views", "message": "two"}]
    assert written["assumptions"][0]["args"] == {"view": "top"}


def test_a_stage_that_breaks_off_is_named_and_not_timed(notes: RunNotes) -> None:
    with notes.stage("read"):
        pass
    with pytest.raises(ValueError, match="broken"), notes.stage("views"):
        raise ValueError("broken")
    assert notes.report.stage == "views"
    assert list(notes.progress.seconds) == ["read"]
