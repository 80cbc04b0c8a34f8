"""Captions that name a view ("Front View", "Draufsicht") among the texts of a sheet."""

import re
from collections.abc import Iterable

from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet.views.captioned_views import Caption
from gaussiancad_core.writing.sheet_texts import SheetText

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
    roles = [caption.role for caption in found]
    return tuple(caption for caption in found if roles.count(caption.role) == 1)
