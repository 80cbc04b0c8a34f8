"""What the server keeps by the ids that it gave: where the latest readings and parts lie."""

import threading
from collections import OrderedDict
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar

from gaussiancad import Reading, Result
from gaussiancad_core.errors import UsageError
from gaussiancad_protocol.codes import Code

MOST_KEPT = 100
"""Readings, and parts, that have an id at a time."""

Value = TypeVar("Value")


class Kept(Generic[Value]):
    """Values by their ids; beyond a number of them the oldest are dropped.

    Args:
        kind: of value, as in a sentence: ``reading``.
        advice: what to do where an id is not known.
        most: values that are kept.
    """

    def __init__(self, kind: str, advice: str, most: int = MOST_KEPT) -> None:
        self._kind, self._advice, self._most = kind, advice, most
        self._values: OrderedDict[str, Value] = OrderedDict()
        self._lock = threading.Lock()

    def __contains__(self, name: str) -> bool:
        with self._lock:
            return name in self._values

    def keep(self, name: str, value: Value) -> None:
        """Keep a value; one of the same id is replaced."""
        with self._lock:
            self._values.pop(name, None)
            self._values[name] = value
            while len(self._values) > self._most:
                self._values.popitem(last=False)

    def find(self, name: str) -> Value:
        """The value of an id.

        Raises:
            UsageError: ``unknown-id``.
        """
        with self._lock:
            if name in self._values:
                return self._values[name]
            latest = ", ".join(list(self._values)[-3:])
        raise UsageError(
            Code.UNKNOWN_ID,
            "{id} is the id of no {kind} that is kept ({known}): {advice}",
            id=name[:100],
            kind=self._kind,
            known=f"the latest: {latest}" if latest else "there is none yet",
            advice=self._advice,
        )


@dataclass(frozen=True)
class KeptReading:
    """Where a reading lies; its file is opened each time, so that many take no memory.

    Attributes:
        folder: of ``reading.json`` and its pictures.
        sheet: the file that was read.
    """

    folder: Path
    sheet: Path

    def load(self) -> Reading:
        """The reading.

        Raises:
            UsageError: ``unknown-id``, its file is gone or was changed.
        """
        try:
            return Reading.load(self.folder / "reading.json", self.sheet)
        except (OSError, ValueError, AttributeError, TypeError) as error:
            raise _gone("reading.json", self.folder, "read the sheet again") from error


@dataclass(frozen=True)
class KeptResult:
    """Where a part lies.

    Attributes:
        folder: of its report and its models.
    """

    folder: Path

    def load(self) -> Result:
        """The part.

        Raises:
            UsageError: ``unknown-id``, its report is gone or was changed.
        """
        try:
            return Result(self.folder)
        except (OSError, ValueError, TypeError) as error:
            raise _gone("report.json", self.folder, "reconstruct it again") from error


def _gone(file: str, folder: Path, advice: str) -> UsageError:
    return UsageError(
        Code.UNKNOWN_ID,
        "{file} in {folder} is gone or was changed: {advice}",
        file=file,
        folder=folder,
        advice=advice,
    )
