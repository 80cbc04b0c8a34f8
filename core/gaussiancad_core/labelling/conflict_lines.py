"""Lines that contradict each other, as data."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype


@dataclass(frozen=True, eq=False)
class ConflictLine:
    """A line that takes part in a contradiction.

    Attributes:
        role: the view.
        points: (n, 2) mm of the view's plane (right, up), along the line.
        drawn: how the view draws it; None if nothing is drawn there.
        suspect: whether all other lines of the drawing agree without it.
        fitting: how a suspect would be drawn for all lines to agree; None for not at all.
    """

    role: Role
    points: npt.NDArray[np.float64]
    drawn: Linetype | None
    suspect: bool = False
    fitting: Linetype | None = None


@dataclass(frozen=True, eq=False)
class Conflict:
    """Lines that contradict each other.

    Attributes:
        lines: the suspects first.
        minimal: whether it is proved that none can be left out.
    """

    lines: tuple[ConflictLine, ...]
    minimal: bool

    @property
    def suspects(self) -> tuple[ConflictLine, ...]:
        """The lines each of which may be the only wrong one."""
        return tuple(line for line in self.lines if line.suspect)
