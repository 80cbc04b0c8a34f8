"""What a run says of itself: the report as it fills, and the events that go with it."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

from gaussiancad_core.messages import event_fields
from gaussiancad_core.processes.events import Progress
from gaussiancad_core.report.run_report import Report


class RunNotes:
    """The report of a run in progress.

    Args:
        report: as it is at the start.
        progress: of the run's stages.

    Attributes:
        report: with all that was told so far.
        progress: as given.
    """

    def __init__(self, report: Report, progress: Progress) -> None:
        self.report = report
        self.progress = progress

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Announce and time a stage; a report that breaks off names it."""
        self.tell(stage=name)
        with self.progress.stage(name):
            yield

    def tell(self, **fields: Any) -> None:  # noqa: ANN401
        """Put fields of :class:`Report` into the report."""
        self.report = replace(self.report, **fields)

    def warn(self, code: str, message: str) -> None:
        """Put a warning into the report, and send it; a :class:`.Message` with its values."""
        self.report = self.report.warned(code, message)
        self.progress.listener.send("warning", **event_fields(code, message))

    def doubt(self, code: str, message: str) -> None:
        """Put a reason into the report why its result is not sure; values as of :meth:`warn`."""
        self.report = self.report.doubted(code, message)
