"""Patterns as plain values: the list ``patterns`` of ``features.json``."""

from collections.abc import Sequence
from typing import Any

from gaussiancad_core.features.constraints import Numbers
from gaussiancad_core.features.pattern_model import Circle, Pattern, Row


def pattern_values(
    patterns: Sequence[Pattern], names: Sequence[str], numbers: Numbers
) -> list[dict[str, Any]]:
    """Patterns as plain values; each number with where it is from.

    Args:
        patterns: of a solid.
        names: of its features, in order.
        numbers: of the drawing.
    """
    found = []
    for count, pattern in enumerate(patterns, 1):
        members = [[names[member.feature], member.centre] for member in pattern.members]
        values = {"kind": _kind(pattern), "name": f"Pattern{count}", "members": members}
        found.append(values | _numbers(pattern, numbers))
    return found


def _kind(pattern: Pattern) -> str:
    if isinstance(pattern, Row):
        return "linear" if len(pattern.steps) == 1 else "grid"
    return "circular" if isinstance(pattern, Circle) else "mirror"


def _numbers(pattern: Pattern, numbers: Numbers) -> dict[str, Any]:
    def sources(**values: float) -> dict[str, str]:
        return {name: numbers.source_of(value).value for name, value in values.items()}

    if isinstance(pattern, Row):
        steps = [
            {
                "direction": list(step.direction),
                "count": step.count,
                "distance": step.distance,
                "sources": sources(distance=step.distance),
            }
            for step in pattern.steps
        ]
        return {"steps": steps}
    if isinstance(pattern, Circle):
        axis = {"point": list(pattern.point), "direction": list(pattern.direction)}
        return {
            "axis": axis,
            "count": len(pattern.members),
            "angle": pattern.angle,
            "diameter": pattern.diameter,
            "sources": sources(diameter=pattern.diameter),
        }
    plane = {"normal": list(pattern.frame.normal), "offset": pattern.height}
    return {"plane": plane, "sources": sources(offset=pattern.height)}
