"""What a drawing on a sheet is that is no principal view."""

from dataclasses import dataclass
from enum import Enum

from gaussiancad_core.sheet.reading_options import Box


class SpecialKind(Enum):
    """Names of ISO 128-3 and ISO 5456-3; the value is the one in the report."""

    SECTION = "section"
    HALF_SECTION = "half-section"
    PARTIAL_SECTION = "partial-section"
    PICTORIAL = "pictorial"
    DETAIL = "detail"
    AUXILIARY = "auxiliary-view"
    OTHER_PART = "other-part"
    BROKEN = "broken-view"
    HALF = "half-view"
    THREAD = "thread"


SECTIONS = (SpecialKind.SECTION, SpecialKind.HALF_SECTION, SpecialKind.PARTIAL_SECTION)
"""Views that are cut open."""


@dataclass(frozen=True)
class SpecialView:
    """A drawing that is no plain principal view.

    Attributes:
        kind: what it is.
        box: around it, px of the upright sheet.
        used: whether it stands for a principal view all the same, or beside one.
        cut: around the hatching of a section, px of the upright sheet.
        adjacent: whether it is a section that is used beside a plain view of its direction.
    """

    kind: SpecialKind
    box: Box
    used: bool = False
    cut: Box | None = None
    adjacent: bool = False
