"""Which strokes of a reading an agent speaks of: those of a view, in a box, or by their ids."""

from collections.abc import Mapping, Sequence
from math import cos, pi, sin
from typing import Any

from gaussiancad import Reading
from gaussiancad.agent.tool_arguments import LookArguments
from gaussiancad_core.errors import UsageError
from gaussiancad_core.readings.correction_operations import (
    DimensionOperation,
    DrawOperation,
    EraseOperation,
    KindOperation,
    Operation,
    SectionOperation,
    TraceOperation,
    ViewOperation,
)
from gaussiancad_core.report.pointing import holds
from gaussiancad_protocol.codes import Code

_MARGIN = 0.03
"""Of a view, around it."""

_STEPS = 64
"""Places along a stroke."""

Box = tuple[float, float, float, float]
Values = Mapping[str, Any]


def selected_box(reading: Reading, asked: LookArguments) -> Box:
    """The part of the sheet that is asked for: a box, a view with a margin, or all of it."""
    if asked.box is not None:
        return asked.box
    if asked.view is not None:
        boxes = [view["box"] for view in _views(reading, asked.view)]
        x0, y0 = (min(box[index] for box in boxes) for index in (0, 1))
        x1, y1 = (max(box[index] for box in boxes) for index in (2, 3))
        margin = _MARGIN * max(x1 - x0, y1 - y0)
        return x0 - margin, y0 - margin, x1 + margin, y1 + margin
    width, height = reading.data["sheet"].get("size") or (1.0, 1.0)
    return 0.0, 0.0, float(width), float(height)


def selected_strokes(reading: Reading, asked: LookArguments) -> list[dict[str, Any]]:
    """The strokes that are asked for, in the order of the reading or of how sure they are.

    Raises:
        UsageError: ``unknown-view``.
    """
    views = {view["id"] for view in _views(reading, asked.view)} if asked.view else None
    kinds = {kind.value for kind in asked.kinds}
    found = [
        stroke
        for stroke in reading.data.get("strokes", ())
        if (views is None or stroke.get("view") in views)
        and (not kinds or stroke["kind"] in kinds)
        and (asked.box is None or _meets(stroke, asked.box))
    ]
    if asked.doubtful_first:
        found.sort(key=lambda stroke: float(stroke.get("confidence", 1.0)))
    return found


def check_ids(reading: Reading, operations: Sequence[Operation]) -> None:
    """Refuse operations that name what the reading has not.

    Raises:
        UsageError: ``unknown-id``.
    """
    strokes = {stroke["id"] for stroke in reading.data.get("strokes", ())}
    numbers = {entry["id"] for entry in reading.data.get("dimensions", ())}
    views = {view[name] for view in reading.data.get("views", ()) for name in ("id", "role")}
    for number, operation in enumerate(operations, start=1):
        if isinstance(operation, ViewOperation):
            if operation.box is None and operation.id not in views:
                raise _unknown(number, "view", operation.id, views)
            views |= {operation.id, operation.role.value}
        elif isinstance(operation, KindOperation | EraseOperation):
            target = operation.target
            if target.line is target.arc is target.ellipse is None and target.id not in strokes:
                raise _unknown(number, "stroke", target.id, strokes)
        elif isinstance(operation, DimensionOperation) and operation.id not in numbers:
            raise _unknown(number, "dimension", operation.id, numbers)
        elif isinstance(operation, DrawOperation | TraceOperation):
            if operation.view not in views:
                raise _unknown(number, "view", operation.view, views)
        elif isinstance(operation, SectionOperation):
            for name in (operation.id, operation.in_view):
                if name not in views:
                    raise _unknown(number, "view", name, views)


def _unknown(number: int, kind: str, name: str, known: set[str]) -> UsageError:
    some = ", ".join(sorted(known, key=lambda entry: (len(entry), entry))[:8]) or "none"
    return UsageError(
        Code.UNKNOWN_ID,
        "operation {number}: the reading has no {kind} {id}; it has {known}{more}: `look` lists "
        "strokes, the summary has the rest",
        number=number,
        kind=kind,
        id=repr(name[:100]),
        known=some,
        more=", ..." if len(known) > 8 else "",
    )


def _views(reading: Reading, name: str) -> list[Values]:
    """Views by their role, or the one of an id."""
    views = reading.data.get("views", ())
    found = [view for view in views if name in (view["id"], view["role"])]
    if not found:
        names = dict.fromkeys(str(view["role"]) for view in views)
        raise UsageError(
            Code.UNKNOWN_VIEW,
            "the sheet has no view {view}; it has: {known}",
            view=name[:100],
            known=", ".join(names) or "none",
        )
    return found


def _meets(stroke: Values, box: Box) -> bool:
    """Whether a stroke has a place in a box."""
    if stroke.get("box") is not None:
        x0, y0, x1, y1 = stroke["box"]
        return bool(x0 <= box[2] and x1 >= box[0] and y0 <= box[3] and y1 >= box[1])
    return any(holds(box, place) for place in _places(stroke))


def _places(stroke: Values) -> list[tuple[float, float]]:
    """Places along a stroke."""
    shares = [step / _STEPS for step in range(_STEPS + 1)]
    if stroke.get("line") is not None:
        (x0, y0), (x1, y1) = stroke["line"]
        return [(x0 + share * (x1 - x0), y0 + share * (y1 - y0)) for share in shares]
    if stroke.get("arc") is not None:
        x, y, radius, start, sweep = stroke["arc"]
        major, minor, turn = radius, radius, 0.0
    elif stroke.get("ellipse") is not None:
        x, y, major, minor, turn, start, sweep = stroke["ellipse"]
    else:
        return []
    found = []
    for share in shares:
        angle = min(start + share * sweep, start + 2.0 * pi)
        along, across = major * cos(angle), minor * sin(angle)
        found.append(
            (
                x + along * cos(turn) - across * sin(turn),
                y + along * sin(turn) + across * cos(turn),
            )
        )
    return found
