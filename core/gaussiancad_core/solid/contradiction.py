"""A contradiction of the drawing in words, with its places."""

import numpy as np

from gaussiancad_core.labelling.conflict_lines import Conflict, ConflictLine
from gaussiancad_core.messages import Message
from gaussiancad_core.model.views import Linetype
from gaussiancad_protocol.codes import Code

CODE = Code.LINES_CONTRADICT

_MOST = 4
"""Lines that are named; the others are counted."""


def conflict_reason(conflict: Conflict) -> tuple[str, str]:
    """Code and sentence: which lines contradict each other, and which may be wrong."""
    shown = conflict.suspects or conflict.lines
    named = "; ".join(_described(line) for line in shown[:_MOST])
    if len(shown) > _MOST:
        named += f"; and {len(shown) - _MOST} more"
    if conflict.suspects:
        one = len(conflict.suspects) == 1
        start = "the lines, as they were read, contradict each other, and would agree but for one: "
        return CODE, Message(
            start + ("{lines}" if one else "any of these: {lines}"),
            boxes=(),
            lines=named,
            suspects=len(conflict.suspects),
            **(_wanted(conflict.suspects[0]) if one else {}),
        )
    if len(conflict.lines) == 1:
        return CODE, Message(
            "no solid with the surfaces that are supported has this line next to what is blank "
            "around it: {lines}",
            lines=named,
            count=1,
        )
    few = "the fewest lines of which this is known" if conflict.minimal else "not all are needed"
    return (
        CODE,
        Message(
            "{count} lines, as they were read, contradict each other ({few}): {lines}",
            count=len(conflict.lines),
            few=few,
            lines=named,
        ),
    )


def _described(line: ConflictLine) -> str:
    view = line.role.value
    where = _where(line)
    if not line.suspect:
        kind = f"{line.drawn.value} line" if line.drawn else "blank"
        return f"{kind} in the {view} view {where}"
    if line.drawn is None:
        kind = line.fitting.value if line.fitting else "visible"
        return f"a {kind} line is missing in the {view} view {where}"
    instead = {
        None: "should not be there",
        Linetype.VISIBLE: "should be visible",
        Linetype.HIDDEN: "should be hidden",
    }[line.fitting]
    return f"the {line.drawn.value} line in the {view} view {where} {instead}"


def _wanted(line: ConflictLine) -> dict[str, object]:
    """Values for the only line that is in doubt: what would have to be, and where."""
    if line.drawn is None:
        return {"case": "missing", "view": line.role, "linetype": line.fitting or Linetype.VISIBLE}
    if line.fitting is None:
        return {"case": "surplus", "view": line.role, "linetype": line.drawn}
    return {"case": "kind", "view": line.role, "linetype": line.fitting}


def _where(line: ConflictLine) -> str:
    first, last = line.points[0], line.points[-1]
    low, high = line.points.min(axis=0), line.points.max(axis=0)
    if np.hypot(*(last - first)) > 0.1 * np.hypot(*(high - low)):
        return f"from {_place(first)} to {_place(last)} mm"
    return f"around {_place((low + high) / 2.0)} mm"


def _place(point: np.ndarray) -> str:
    # Adding nothing makes zero of what is printed as minus zero.
    x, y = np.round(point, 1) + 0.0
    return f"({x:.1f}, {y:.1f})"
