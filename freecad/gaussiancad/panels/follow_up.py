"""What a panel goes on with after a run that succeeded, while the result is in the document."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Success:
    """What a panel shows after a run that succeeded.

    Attributes:
        headline: one sentence.
        lines: details.
    """

    headline: str
    lines: tuple[str, ...] = ()


class FollowUp(ABC):
    """Work that can be cancelled; whatever comes of it, the run has succeeded."""

    @abstractmethod
    def start(self, done: Callable[[Success], None]) -> None:
        """Begin.

        Args:
            done: is called once, with what the panel shows at the end, also after :meth:`leave`.
        """

    @abstractmethod
    def cancel(self) -> None:
        """End soon, with what there is."""

    @abstractmethod
    def leave(self) -> None:
        """End soon, and touch no widget any more: the panel is gone."""
