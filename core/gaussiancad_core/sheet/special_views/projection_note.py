"""First or third angle as the words of a sheet say it, beside or instead of the symbol."""

import re
import unicodedata

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol

_WORDS = {
    Projection.FIRST: re.compile(
        r"\b(?:FIRST|1ST)[ -]?ANGLE\b|\bPREMIER DIEDRE\b|\bPRIMER DIEDRO\b|第一角|第1角"
    ),
    Projection.THIRD: re.compile(
        r"\b(?:THIRD|3RD)[ -]?ANGLE\b|\bTROISIEME DIEDRE\b|\bTERCER DIEDRO\b|第三角|第3角"
    ),
}
"""Names of the methods in notes and title blocks, in capitals and without accents."""


def noted_projection(sheet: OpenedSheet) -> ProjectionSymbol | None:
    """What the texts of a file say of the projection; nothing where they name none, or both."""
    drawing = sheet.image.vectors
    if drawing is None:
        return None
    found = [
        (projection, text)
        for text in drawing.texts
        if (projection := projection_in(text.text)) is not None
    ]
    if len({projection for projection, _ in found}) != 1:
        return None
    projection, text = found[0]
    mark = Mark(AnnotationKind.TEXT, sheet.turn.box_to_upright(text.box))
    return ProjectionSymbol(projection, mark)


def projection_in(text: str) -> Projection | None:
    """The projection that a text names; nothing where it names both, as a choice to be ticked."""
    plain = " ".join(_without_accents(text).upper().split())
    named = [projection for projection, words in _WORDS.items() if words.search(plain)]
    return named[0] if len(named) == 1 else None


def _without_accents(text: str) -> str:
    parts = unicodedata.normalize("NFKD", text)
    return "".join(part for part in parts if not unicodedata.combining(part))
