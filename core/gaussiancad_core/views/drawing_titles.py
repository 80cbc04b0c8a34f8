"""Titles of drawings: the name of a view, a section, a detail or a flat pattern, by words."""

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

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
    "front": re.compile(r"\bfront\b|主视|ВИД СПЕРЕДИ", re.IGNORECASE),
    "top": re.compile(r"\btop\b|俯视|\bplan\b", re.IGNORECASE),
    "right": re.compile(r"\bright\b", re.IGNORECASE),
    "left": re.compile(r"\bleft\b|左视", re.IGNORECASE),
    "bottom": re.compile(r"\bbottom\b|仰视", re.IGNORECASE),
    "rear": re.compile(r"\b(?:rear|back)\b", re.IGNORECASE),
    PICTORIAL: re.compile(r"isometric|trimetric|dimetric|\biso\b", re.IGNORECASE),
}

_LONGEST_NAME = 24
"""Letters of a view's name at most: more are a sentence."""

_REACH, _SIDEWAYS = 25.0, 2.0
"""mm from a title to its drawing at most, and how often those across count."""

_NOT_HATCHED = 12.0
"""mm that a drawing without hatching is farther from the title of a section."""

_DETAIL_SIZE = 0.6
"""Size of a detail in that of the largest drawing at most."""


def with_titles(views: Sequence[DrawnView], texts: Sequence[PaperText]) -> list[DrawnView]:
    """The drawings, each with what the title nearest to it says."""
    found = list(views)
    largest = max((view.area for view in views), default=0.0)
    for text in texts:
        name = _named(text.text.strip())
        if name is None:
            continue
        index = _nearest(text, found, is_section=name is DrawingKind.SECTION)
        if index is not None:
            found[index] = _titled(found[index], name, text.text.strip(), largest)
    return found


def _named(text: str) -> DrawingKind | str | None:
    """The kind or the name that a text gives to a drawing; nothing where it gives none."""
    if _SECTION.search(text):
        return DrawingKind.SECTION
    if _DETAIL.search(text):
        return DrawingKind.DETAIL
    if _SMALLER.search(text):
        return _SMALL
    if _FLAT.search(text):
        return DrawingKind.FLAT_PATTERN
    if len(text) > _LONGEST_NAME:
        return None
    return next((name for name, words in _NAMES.items() if words.search(text)), None)


def _nearest(text: PaperText, views: Sequence[DrawnView], *, is_section: bool) -> int | None:
    """Number of the drawing that a title stands at."""
    x, y = (text.box[0] + text.box[2]) / 2.0, (text.box[1] + text.box[3]) / 2.0
    best, number = _REACH, None
    for index, view in enumerate(views):
        if view.kind is DrawingKind.SCRAP:
            continue
        x0, y0, x1, y1 = view.box
        across, down = max(x0 - x, x - x1, 0.0), max(y0 - y, y - y1, 0.0)
        away = float(np.hypot(_SIDEWAYS * across, down))
        away += _NOT_HATCHED if is_section and not view.hatching else 0.0
        if away < best:
            best, number = away, index
    return number


def _titled(view: DrawnView, name: DrawingKind | str, title: str, largest: float) -> DrawnView:
    if name is DrawingKind.SECTION:
        # A title tells a section where there is hatching.
        kind = DrawingKind.SECTION if view.hatching else view.kind
        return replace(view, kind=kind, title=title)
    if name is DrawingKind.DETAIL:
        return replace(view, kind=name, title=title)
    if name == _SMALL:
        is_small = view.area < _DETAIL_SIZE * largest
        return replace(view, kind=DrawingKind.DETAIL, title=title) if is_small else view
    if name is DrawingKind.FLAT_PATTERN:
        return replace(view, kind=DrawingKind.FLAT_PATTERN, title=title)
    if name == PICTORIAL:
        return replace(view, kind=DrawingKind.PICTORIAL, name=PICTORIAL, title=title)
    return view if view.name else replace(view, name=str(name), title=view.title or title)
