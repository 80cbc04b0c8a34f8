"""Titles of drawings: the name of a view, a section, a detail or a flat pattern, by words."""

import re
from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np

from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet_model.paper_sheet import PaperText
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView

_SMALL = "small"
"""Stands for what is a detail if it is small."""

PICTORIAL = "pictorial"
"""Name of a drawing that its title calls so."""

_SECTION = re.compile(
    r"^\W*(?:SECTION|SCHNITT|COUPE|CUT|SEZIONE|SECCIÓN|剖面|РАЗРЕЗ)?\s*"
    r"([A-ZА-Я])\s*[-–—]\s*\1\b|\bsection\b",
    re.IGNORECASE,
)
_DETAIL = re.compile(
    r"\b(?:DETAIL|EINZELHEIT|DÉTAIL|DETTAGLIO|DETALLE)\s+[A-ZА-Я]\b|局部", re.IGNORECASE
)
_SMALLER = re.compile(r"\bDETAIL|\bВИД\b|\bVIEW\s+[A-Z]\b|thread(?:ed)?\s+M", re.IGNORECASE)
"""Words beside what is a detail if it is small."""

_FLAT = re.compile(r"FLAT\s*PATTERN|ABWICKLUNG|\b(?:DOWN|UP)\s+\d+", re.IGNORECASE)
_NAMES = {
    Role.FRONT.value: (
        "front|front elevation|elevation|vorderansicht|ansicht von vorne?|face|frontale?|alzado"
        "|主视图?|正视图|前视图|вид спереди|главный вид"
    ),
    Role.TOP.value: (
        "top|plan|draufsicht|ansicht von oben|dessus|superiore?|planta|dall.alto"
        "|俯视图?|上视图|顶视图|вид сверху"
    ),
    Role.RIGHT.value: (
        "right|right side|right elevation|ansicht von rechts|droite|lateral derecha|da destra"
        "|右视图?|вид справа"
    ),
    Role.LEFT.value: (
        "left|left side|left elevation|ansicht von links|gauche|lateral izquierda|da sinistra"
        "|左视图?|вид слева"
    ),
    Role.BOTTOM.value: (
        "bottom|untersicht|unteransicht|ansicht von unten|dessous|inferiore?|dal basso"
        "|仰视图?|下视图|вид снизу"
    ),
    Role.REAR.value: (
        "rear|back|rear elevation|rückansicht|ansicht von hinten|arrière|posteriore?"
        "|后视图?|вид сзади"
    ),
    PICTORIAL: "isometric|trimetric|dimetric|iso",
}
"""What drawings are called, in small letters; ``view`` and its like may stand beside it."""

_BESIDE = r"(?:(?:view|vue|vista)(?: de| da)? )?(?:{names})(?: view| vista)?"

_PATTERNS = {
    name: re.compile(_BESIDE.format(names=names) + r"(?: ?\(?\d+ ?: ?\d+\)?)?")
    for name, names in _NAMES.items()
}

_REACH, _SIDEWAYS = 25.0, 2.0
"""mm from a title to its drawing at most, and how often those across count."""

_FAR = 1e6
"""mm that stand for an infinite distance."""

_NOT_HATCHED = 12.0
"""mm that a drawing without hatching is farther from the title of a section."""

_DETAIL_SIZE = 0.6
"""Size of a detail in that of the largest drawing at most."""


def with_titles(views: Sequence[DrawnView], texts: Sequence[PaperText]) -> list[DrawnView]:
    """The drawings, each with what its title says.

    A kind is that of the drawing nearest to its title.  The names of views are given to them
    together, as they stand above all of them or below all of them on one sheet.
    """
    found = list(views)
    largest = max((view.area for view in views), default=0.0)
    names: list[tuple[str, PaperText]] = []
    for text in texts:
        name = _named(text.text.strip())
        if isinstance(name, str) and name != _SMALL:
            names.append((name, text))
        elif name is not None:
            index = _nearest(text, found, is_section=name is DrawingKind.SECTION)
            if index is not None:
                found[index] = _titled(found[index], name, text.text.strip(), largest)
    for name, text, index in _given(names, found):
        found[index] = _with_name(found[index], name, text.text.strip())
    return found


def _named(text: str) -> DrawingKind | str | None:
    """The kind or the name that a text gives to a drawing; nothing where it gives none."""
    plain = " ".join(text.lower().replace(".", " ").replace("-", " ").split())
    for name, pattern in _PATTERNS.items():
        if pattern.fullmatch(plain):
            return name
    if _SECTION.search(text):
        return DrawingKind.SECTION
    if _DETAIL.search(text):
        return DrawingKind.DETAIL
    if _SMALLER.search(text):
        return _SMALL
    return DrawingKind.FLAT_PATTERN if _FLAT.search(text) else None


def _given(
    names: Sequence[tuple[str, PaperText]], views: Sequence[DrawnView]
) -> list[tuple[str, PaperText, int]]:
    """Names with the numbers of their drawings: most of them, all above or all below, as near as
    can be; else each of those that are left anyhow."""
    if not names or not views:
        return []
    # It takes long to load, and few sheets name their views.
    from scipy.optimize import linear_sum_assignment

    tried = []
    for side in (-1.0, 1.0, 0.0):
        away = np.array([[_away(text, view, side) for view in views] for _, text in names])
        rows, columns = linear_sum_assignment(np.minimum(away, _FAR))
        # Several names, all on one side of their drawings, are no matter of distance.
        together = side != 0.0 and len(names) > 1 and bool((away[rows, columns] < inf).all())
        reach = inf if together and len(rows) == len(names) else _REACH
        pairs = [(r, c) for r, c in zip(rows, columns, strict=True) if away[r, c] < reach]
        total = sum(float(away[pair]) for pair in pairs)
        tried.append((-len(pairs), side == 0.0, total, pairs))
    pairs = min(tried)[-1]
    return [(*names[row], int(column)) for row, column in pairs]


def _away(text: PaperText, view: DrawnView, side: float) -> float:
    """mm from a title to a drawing, those across counted more; infinite on the wrong side of it.

    Args:
        text: the title.
        view: the drawing.
        side: -1 of a title above its drawing, 1 of one below, 0 anywhere.
    """
    if view.kind is DrawingKind.SCRAP:
        return inf
    x, y = (text.box[0] + text.box[2]) / 2.0, (text.box[1] + text.box[3]) / 2.0
    x0, y0, x1, y1 = view.box
    across, down = max(x0 - x, x - x1, 0.0), max(y0 - y, y - y1, 0.0)
    if (side < 0.0 and y > y0) or (side > 0.0 and y < y1):
        return inf
    return float(np.hypot(_SIDEWAYS * across, down))


def _nearest(text: PaperText, views: Sequence[DrawnView], *, is_section: bool) -> int | None:
    """Number of the drawing that a title stands at."""
    best, number = _REACH, None
    for index, view in enumerate(views):
        away = _away(text, view, 0.0)
        away += _NOT_HATCHED if is_section and not view.hatching else 0.0
        if away < best:
            best, number = away, index
    return number


def _titled(view: DrawnView, kind: DrawingKind | str, title: str, largest: float) -> DrawnView:
    if kind is DrawingKind.SECTION:
        # A title tells a section where there is hatching.
        kind = DrawingKind.SECTION if view.hatching else view.kind
    elif kind == _SMALL:
        if view.area >= _DETAIL_SIZE * largest:
            return view
        kind = DrawingKind.DETAIL
    return replace(view, kind=DrawingKind(kind), title=title)


def _with_name(view: DrawnView, name: str, title: str) -> DrawnView:
    if name == PICTORIAL:
        return replace(view, kind=DrawingKind.PICTORIAL, name=name, title=title)
    return view if view.name else replace(view, name=name, title=view.title or title)
