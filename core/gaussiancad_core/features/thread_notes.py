"""Threads that notes of the drawing tell of holes: their names and depths.

They are cosmetic: a hole keeps the diameter that the solid has, the thread's own one or that of its
core.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from gaussiancad_core.features.feature_model import Feature, Holes

_CORE = 0.75
"""Diameter of a thread's core as a share of the nominal one, at least (ISO 724)."""

_DIGITS = 4
"""Decimal places of mm within which diameters are one."""


@dataclass(frozen=True)
class ThreadNote:
    """What a note says of threaded holes.

    Attributes:
        name: as ``M6`` or ``M8x1``.
        diameter: mm, nominal.
        count: of holes.
        depth: mm of the thread; None where the note tells none.
    """

    name: str
    diameter: float
    count: int = 1
    depth: float | None = None


@dataclass(frozen=True)
class Thread:
    """The thread of a hole.

    Attributes:
        name: as ``M6`` or ``M8x1``.
        depth: mm from where the hole enters; None where the drawing tells none, or the hole goes
            through.
    """

    name: str
    depth: float | None = None


def threads_of(features: Sequence[Feature], notes: Sequence[ThreadNote]) -> dict[int, Thread]:
    """The threads of holes, by the features' places in the list; only those that are certain.

    A note speaks of the holes that its thread fits in, as many as it says, where there is one
    choice of them and no note of another thread makes the same choice.

    Args:
        features: of a part.
        notes: of its drawing.
    """
    by_name: dict[str, list[ThreadNote]] = {}
    for note in notes:
        by_name.setdefault(note.name, []).append(note)
    chosen = {name: _chosen(features, group) for name, group in by_name.items()}
    claims = [number for numbers in chosen.values() for number in numbers]
    found: dict[int, Thread] = {}
    for name, numbers in chosen.items():
        if any(claims.count(number) > 1 for number in numbers):
            continue
        depths = {note.depth for note in by_name[name]}
        depth = depths.pop() if len(depths) == 1 else None
        for number in numbers:
            found[number] = Thread(name, _within(features[number], depth))
    return found


def _chosen(features: Sequence[Feature], notes: Sequence[ThreadNote]) -> tuple[int, ...]:
    """The features whose holes all notes of a thread speak of together; none where that is not
    certain."""
    count = sum(note.count for note in notes)
    choices: set[tuple[int, ...]] = set()
    by_diameter: dict[float, list[int]] = {}
    for number, holes in enumerate(features):
        if isinstance(holes, Holes) and _fits(holes.diameter, notes[0].diameter):
            by_diameter.setdefault(round(holes.diameter, _DIGITS), []).append(number)
            choices.add((number,))
    choices.update(tuple(numbers) for numbers in by_diameter.values())
    fitting = [choice for choice in choices if _count(features, choice) == count]
    return fitting[0] if len(fitting) == 1 else ()


def _fits(drilled: float, nominal: float) -> bool:
    """Whether a hole is as wide as a thread, or as its core."""
    slack = 10.0**-_DIGITS
    return _CORE * nominal - slack <= drilled <= nominal + slack


def _count(features: Sequence[Feature], numbers: Sequence[int]) -> int:
    holes = (features[number] for number in numbers)
    return sum(len(each.centres) for each in holes if isinstance(each, Holes))


def _within(feature: Feature, depth: float | None) -> float | None:
    """A depth, if the hole is as deep."""
    deep = feature.depth if isinstance(feature, Holes) else None
    return depth if depth is None or deep is None or depth <= deep else deep
