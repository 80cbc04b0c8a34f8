"""Whether the numbers of a body can be changed: each is, alone, on a copy that nobody sees."""

import time
from collections.abc import Sequence
from dataclasses import dataclass
from types import TracebackType

import FreeCAD
import Part

from freecad.gaussiancad.objects.body_numbers import DrivingNumber, set_value

FACTOR = 1.03
"""By which each number is changed: what a person may do to a part without making another one."""

MOST_SECONDS = 20.0
"""That the trials of a body may take; one recompute is not interrupted."""

_SAME = 1e-6
"""Share by which volume and area of two equal bodies differ."""


@dataclass(frozen=True)
class TrialOutcome:
    """What is known of the numbers of a body.

    Attributes:
        tried: how many numbers were changed.
        breaking: of these, the ones with which there is no longer one valid solid, or that do not
            lead back to the body.
        untried: how many were left when the time was up, or somebody stopped.
    """

    tried: int = 0
    breaking: tuple[DrivingNumber, ...] = ()
    untried: int = 0


class NumberTrials:
    """Changes one number after the other, on a copy in a hidden document: the body stays untouched.

    Args:
        body: as it was made.
        numbers: of it; those of the drawing are tried first.
        most_seconds: after which the rest is left untried.
    """

    def __init__(
        self,
        body: FreeCAD.DocumentObject,
        numbers: Sequence[DrivingNumber],
        most_seconds: float = MOST_SECONDS,
    ) -> None:
        self._body = body
        self._left = sorted(numbers, key=lambda number: not number.on_sheet)
        self._count = len(self._left)
        self._most_seconds, self._seconds = most_seconds, 0.0
        self._factor = FACTOR
        self._breaking: list[DrivingNumber] = []
        self._copy: _Copy | None = None

    def __enter__(self) -> "NumberTrials":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    @property
    def fraction(self) -> float:
        """How much is done."""
        return 1.0 - len(self._left) / self._count if self._count else 1.0

    @property
    def outcome(self) -> TrialOutcome:
        """What is known so far."""
        tried = self._count - len(self._left)
        return TrialOutcome(tried, tuple(self._breaking), len(self._left))

    def step(self) -> bool:
        """Try the next number, and set it back.

        Returns:
            Whether there are more, and there is time for them.
        """
        if not self._left:
            return False
        began = time.monotonic()
        if self._copy is None:
            self._copy = _Copy(self._body)
        number = self._left.pop(0)
        if not self._copy.survives(number, self._factor):
            self._breaking.append(number)
        if not self._copy.comes_back(number):
            if number not in self._breaking:
                self._breaking.append(number)
            self.close()
        self._seconds += time.monotonic() - began
        return bool(self._left) and self._seconds < self._most_seconds

    def run(self) -> TrialOutcome:
        """Try all of them at once."""
        while self.step():
            pass
        return self.outcome

    def close(self) -> None:
        """Leave the copy."""
        if self._copy is not None:
            self._copy.close()
            self._copy = None


class _Copy:
    """A copy of a body in a document of its own, which no window shows."""

    def __init__(self, body: FreeCAD.DocumentObject) -> None:
        self._document = FreeCAD.newDocument("Trial", hidden=True, temp=True)
        self._document.UndoMode = 0
        self._document.copyObject(body, True)
        self._body = next(
            each for each in self._document.Objects if each.TypeId == "PartDesign::Body"
        )
        # A copy has names of its own; the order is the same.
        names = (each.Name for each in body.Group)
        self._features = dict(zip(names, self._body.Group, strict=True))
        self._before = _measures(body.Shape)

    def survives(self, number: DrivingNumber, factor: float) -> bool:
        """Whether there is one valid solid when a number is as many times as large."""
        return self._set(number, number.value * factor) and self._is_whole()

    def comes_back(self, number: DrivingNumber) -> bool:
        """Set a number back; whether the body is what it was."""
        return self._set(number, number.value) and self._is_whole() and self._is_as_before()

    def close(self) -> None:
        """Remove the document."""
        FreeCAD.closeDocument(self._document.Name)

    def _set(self, number: DrivingNumber, value: float) -> bool:
        try:
            set_value(self._features[number.feature], number.name, value)
            self._document.recompute()
        except Exception:  # FreeCAD raises its own types, which differ between versions
            return False
        return True

    def _is_whole(self) -> bool:
        shape = self._body.Shape
        # A feature that fails leaves the shape of before.
        computed = all(each.isValid() for each in (*self._body.Group, self._body))
        one = computed and not shape.isNull() and len(shape.Solids) == 1
        return one and shape.isValid() and shape.Volume > 0.0

    def _is_as_before(self) -> bool:
        now = _measures(self._body.Shape)
        pairs = zip(self._before, now, strict=True)
        return all(abs(after - before) <= _SAME * abs(before) for before, after in pairs)


def _measures(shape: Part.Shape) -> tuple[float, float, float]:
    """Volume, area and number of faces."""
    return shape.Volume, shape.Area, float(len(shape.Faces))
