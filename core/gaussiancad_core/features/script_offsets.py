"""Offsets in the script as sums of its parameters: ``PAD1_OFFSET + PAD1_LENGTH``."""

from collections.abc import Iterable
from typing import Any

from gaussiancad_core.features.frames import Frame
from gaussiancad_core.features.supported_features import along

Terms = tuple[tuple[int, str], ...]
"""Names of parameters, each with 1 or -1: a sum; nothing is 0."""


def less(terms: Terms, others: Terms) -> Terms:
    """A sum without another one; what is in both is gone."""
    left = list(terms)
    for sign, name in others:
        if (sign, name) in left:
            left.remove((sign, name))
        else:
            left.append((-sign, name))
    return tuple(left)


def turned(terms: Terms) -> Terms:
    """A sum with the other sign."""
    return tuple((-sign, name) for sign, name in terms)


def written(terms: Iterable[tuple[int, str]]) -> str:
    """A sum as an expression, what counts first."""
    ordered = sorted(terms, key=lambda term: -term[0])
    text = " ".join(f"{'+' if sign > 0 else '-'} {name}" for sign, name in ordered) or "0"
    return f"-{text[2:]}" if text.startswith("-") else text.removeprefix("+ ")


def edge_place(
    sketch: dict[str, Any], edge: int, normal: Iterable[float]
) -> tuple[str, float, int]:
    """Where a straight edge of a sketch, across a normal, lies along it: the letter of its
    coordinate, that in mm, and -1 where the normal runs against it."""
    plane = sketch["plane"]
    right, up, items = (tuple(plane[key]) for key in ("right", "up", "normal"))
    axis, way = along(Frame("", right, up, items), tuple(normal)) or (0, 1.0)
    return "XY"[axis], float(sketch["geometry"][edge]["start"][axis]), int(way)
