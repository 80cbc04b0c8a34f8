"""The views that captions name, and the projection that they tell.

A caption stands above or below its view.  Which of both is the same all over a sheet, so that the
captions of all views are given to figures together.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations

from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.reading_options import Box

_MOST_FIGURES = 7
"""Figures that captions are given to at most, the nearest first."""


@dataclass(frozen=True)
class Caption:
    """The name of a view.

    Attributes:
        role: that it names.
        box: around the text, px of the upright sheet.
    """

    role: Role
    box: Box


def captioned(captions: Sequence[Caption], figures: Sequence[Box]) -> dict[Role, Box]:
    """The figures that captions name: those for which the captions, all above or all below their
    views, lie nearest together.

    Args:
        captions: of one sheet.
        figures: boxes of groups of lines.
    """
    best: dict[Role, Box] = {}
    least = float("inf")
    for above in (True, False):
        away = [[_away(caption, box, above) for box in figures] for caption in captions]
        found = _assigned(away)
        if found is None:
            continue
        total = sum(away[k][figure] for k, figure in enumerate(found))
        if total < least:
            least = total
            best = {caption.role: figures[k] for caption, k in zip(captions, found, strict=True)}
    return best


def projection_named(views: dict[Role, Box]) -> Projection | None:
    """The projection under which views with known roles stand as they do; None where they tell
    none, or both."""
    front = views.get(Role.FRONT)
    if front is None:
        return None
    projections = set()
    for role, box in views.items():
        across = (box[0] + box[2] - front[0] - front[2]) / 2.0
        up = (front[1] + front[3] - box[1] - box[3]) / 2.0
        column, row = role.slot(Projection.THIRD)
        if role in (Role.LEFT, Role.RIGHT, Role.TOP, Role.BOTTOM):
            side = column * across if column else row * up
            projections.add(Projection.THIRD if side > 0.0 else Projection.FIRST)
    return projections.pop() if len(projections) == 1 else None


def _away(caption: Caption, box: Box, above: bool) -> float:
    """Px between a caption and a figure below it, or above; infinite where it is not there."""
    x0, y0, x1, y1 = caption.box
    offset = max(box[0] - x1, x0 - box[2], 0.0)
    gap = box[1] - y1 if above else y0 - box[3]
    height = y1 - y0
    if gap < -height or offset > 0.0:
        return float("inf")
    middle = abs((x0 + x1) - (box[0] + box[2])) / 2.0
    return max(gap, 0.0) + middle


def _assigned(away: list[list[float]]) -> tuple[int, ...] | None:
    """The figure of each caption, each another, at the least distance in all."""
    if not away or not away[0]:
        return None
    near = sorted(range(len(away[0])), key=lambda k: min(items[k] for items in away))[
        :_MOST_FIGURES
    ]
    if len(near) < len(away):
        return None
    ways = (
        (sum(items[k] for items, k in zip(away, chosen, strict=True)), chosen)
        for chosen in permutations(near, len(away))
    )
    total, chosen = min(ways)
    return chosen if total < float("inf") else None
