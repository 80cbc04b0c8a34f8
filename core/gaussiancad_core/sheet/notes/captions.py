"""Captions that name a view ("Front View", "Draufsicht"), and the projection that they tell.

A caption stands above or below its view.  Which of both is the same all over a sheet, so that the
captions of all views are given to figures together.
"""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import permutations

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.scale.texts import SheetText

_NAMES = {
    Role.FRONT: (
        "front|front elevation|elevation|vorderansicht|ansicht von vorne?|face|frontale?|alzado"
        "|主视图|正视图|前视图|вид спереди|главный вид"
    ),
    Role.TOP: (
        "top|plan|draufsicht|ansicht von oben|dessus|superiore?|planta|dall.alto"
        "|俯视图|上视图|顶视图|вид сверху"
    ),
    Role.RIGHT: (
        "right|right side|right elevation|ansicht von rechts|droite|lateral derecha|da destra"
        "|右视图|вид справа"
    ),
    Role.LEFT: (
        "left|left side|left elevation|ansicht von links|gauche|lateral izquierda|da sinistra"
        "|左视图|вид слева"
    ),
    Role.BOTTOM: (
        "bottom|untersicht|unteransicht|ansicht von unten|dessous|inferiore?|dal basso"
        "|仰视图|下视图|вид снизу"
    ),
    Role.REAR: (
        "rear|back|rear elevation|rückansicht|ansicht von hinten|arrière|posteriore?"
        "|后视图|вид сзади"
    ),
}
"""What views are called, in small letters; ``view`` and its like may stand beside it."""

_BESIDE = r"(?:(?:view|vue|vista)(?: de| da)? )?(?:{names})(?: view| vista)?"

_PATTERNS = {
    role: re.compile(_BESIDE.format(names=names) + r"(?: ?\(?\d+ ?: ?\d+\)?)?")
    for role, names in _NAMES.items()
}

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


def caption_role(text: str) -> Role | None:
    """The view that a text names; None where it is no caption."""
    plain = " ".join(text.lower().replace(".", " ").replace("-", " ").split())
    for role, pattern in _PATTERNS.items():
        if pattern.fullmatch(plain):
            return role
    return None


def captions_of(texts: Iterable[SheetText]) -> tuple[Caption, ...]:
    """The captions among the texts of a sheet; none that names a view that another one names."""
    found = [
        Caption(role, text.box)
        for text in texts
        if text.level and not text.field
        for role in [caption_role(text.text)]
        if role is not None
    ]
    roles = [own.role for own in found]
    return tuple(own for own in found if roles.count(own.role) == 1)


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
        away = [[_away(own, box, above) for box in figures] for own in captions]
        found = _assigned(away)
        if found is None:
            continue
        total = sum(away[k][figure] for k, figure in enumerate(found))
        if total < least:
            least = total
            best = {own.role: figures[k] for own, k in zip(captions, found, strict=True)}
    return best


def told_projection(views: dict[Role, Box]) -> Projection | None:
    """The projection under which views with known roles stand as they do; None where they tell
    none, or both."""
    front = views.get(Role.FRONT)
    if front is None:
        return None
    told = set()
    for role, box in views.items():
        across = (box[0] + box[2] - front[0] - front[2]) / 2.0
        up = (front[1] + front[3] - box[1] - box[3]) / 2.0
        column, row = role.slot(Projection.THIRD)
        if role in (Role.LEFT, Role.RIGHT, Role.TOP, Role.BOTTOM):
            side = column * across if column else row * up
            told.add(Projection.THIRD if side > 0.0 else Projection.FIRST)
    return told.pop() if len(told) == 1 else None


def _away(caption: Caption, box: Box, above: bool) -> float:
    """Px between a caption and a figure below it, or above; infinite where it is not there."""
    x0, y0, x1, y1 = caption.box
    beside = max(box[0] - x1, x0 - box[2], 0.0)
    gap = box[1] - y1 if above else y0 - box[3]
    height = y1 - y0
    if gap < -height or beside > 0.0:
        return float("inf")
    middle = abs((x0 + x1) - (box[0] + box[2])) / 2.0
    return max(gap, 0.0) + middle


def _assigned(away: list[list[float]]) -> tuple[int, ...] | None:
    """The figure of each caption, each another, at the least distance in all."""
    if not away or not away[0]:
        return None
    near = sorted(range(len(away[0])), key=lambda k: min(own[k] for own in away))[:_MOST_FIGURES]
    if len(near) < len(away):
        return None
    ways = (
        (sum(own[k] for own, k in zip(away, chosen, strict=True)), chosen)
        for chosen in permutations(near, len(away))
    )
    total, chosen = min(ways)
    return chosen if total < float("inf") else None
