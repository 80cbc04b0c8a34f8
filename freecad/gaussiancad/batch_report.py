"""One report over all documents of a batch, beside the engine's over all sheets."""

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from freecad.gaussiancad.engine.protocol import Event
from freecad.gaussiancad.staging import put_in_place, staging

SCHEMA = 2

_FAILED = "failed"

_STOPPED = "the batch was stopped before its document was made: go on with --resume"


@dataclass(frozen=True)
class BodyOutcome:
    """What became of the body of a document.

    Attributes:
        lacking: why there is none, a sentence; empty where there is one.
        breaking: its numbers that break it when they are changed.
        untried: how many of its numbers were not tried for that.
    """

    lacking: str = ""
    breaking: tuple[str, ...] = ()
    untried: int = 0

    @property
    def words(self) -> str:
        """The same for people; empty where there is nothing to say."""
        stated = [self.lacking] if self.lacking else []
        if self.breaking:
            stated.append(
                f"The body breaks when one of these is changed: {', '.join(self.breaking)}."
            )
        if self.untried:
            stated.append(f"Numbers of the body that were not tried: {self.untried}.")
        return " ".join(stated)


@dataclass(frozen=True)
class SheetRow:
    """What became of a sheet.

    Attributes:
        name: of its results.
        sheet: its path.
        folder: of the engine's files.
        status: verified, approximate or failed; it speaks of the shape.
        measures_mm: bound that 95 % of the faces' places keep; empty where it is not known.
        exit_code: of the engine.
        code: kebab-case code of the error, or empty.
        message: a sentence about the error, or empty.
        seconds: of the engine.
        body: why the document has no body, where one was asked for: a sentence, or empty.
        body_breaking: numbers of the body that break it when they are changed.
        body_untried: how many of its numbers were not tried for that.
    """

    name: str
    sheet: str
    folder: str
    status: str
    measures_mm: str
    exit_code: int
    code: str
    message: str
    seconds: float
    body: str = ""
    body_breaking: tuple[str, ...] = ()
    body_untried: int = 0

    @classmethod
    def of(cls, event: Event) -> "SheetRow":
        """The row that the engine tells of a sheet."""
        words = ("name", "sheet", "folder", "status", "measures_mm", "code", "message")
        return cls(
            **{word: event.text(word) for word in words},
            exit_code=int(event.number("exit_code") or 0),
            seconds=event.number("seconds") or 0.0,
        )

    @property
    def failed(self) -> bool:
        """Whether there is no document."""
        return self.status == _FAILED

    @property
    def outcome(self) -> str:
        """What became of it, for people."""
        said = self.message or self.status
        words = BodyOutcome(self.body, self.body_breaking, self.body_untried).words
        return f"{said}. {words}" if words else said

    def with_body(self, body: BodyOutcome) -> "SheetRow":
        """The row with what became of the body."""
        return replace(
            self, body=body.lacking, body_breaking=body.breaking, body_untried=body.untried
        )

    def without_document(self, code: str, message: str) -> "SheetRow":
        """The row of a sheet of which the engine made a model, and FreeCAD no document."""
        return replace(self, status=_FAILED, code=code, message=message)

    def stopped(self) -> "SheetRow":
        """The row of a sheet of which no document was made any more."""
        return self if self.failed else self.without_document("cancelled", _STOPPED)


def write_report(rows: Sequence[SheetRow], folder: Path) -> None:
    """Write ``report.json``; it appears whole or not at all.

    Raises:
        OSError: it cannot be written.
    """
    values = {"schema": SCHEMA, "sheets": [asdict(row) for row in rows]}
    text = json.dumps(values, indent=2, ensure_ascii=False) + "\n"
    with staging(folder) as scratch:
        staged = scratch / "report.json"
        # What is no text, as in a name of bytes, is written as JSON writes it.
        staged.write_bytes(text.encode("utf-8", "backslashreplace"))
        put_in_place(staged, folder / staged.name)
