"""Sheets with other drawings than the principal views on them, and how they are read."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path

import cv2
import pytest

from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.recognition.picture_views import picture_views
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.views.sheet_layout import Layout
from sample_parts import sample


@dataclass(frozen=True)
class Found:
    """A drawn sheet, and the views on it.

    Attributes:
        drawn: with the true boxes, in px of the sheet as stored.
        clean: upright.
        separated: without annotations.
        layout: in px of the upright sheet.
    """

    drawn: Sheet
    clean: CleanSheet
    separated: SeparatedSheet
    layout: Layout

    def stored(self, box: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
        """A box of the layout on the sheet as stored."""
        return self.clean.turn.box_to_stored(box)


@cache
def _lines(part: str, roles: str) -> PartLines:
    named = tuple(Role(role) for role in roles.split(","))
    cuts = tuple((role, kind) for role in named[:1] for kind in SectionKind)
    return part_lines(sample(part).build(), named, picture=True, sections=cuts)


@lru_cache(maxsize=8)
def _found(part: str, style: str, roles: str, projection: str) -> Found:
    look = parse_style(f"{style},width=1440,height=900")
    drawn = compose_sheet(_lines(part, roles), Projection(projection), look)
    grey = cv2.cvtColor(drawn.image, cv2.COLOR_RGB2GRAY)
    sheet = OpenedSheet(SheetImage(Path("sheet.png"), grey, ""))
    seen = picture_views(sheet, {}, Projection(projection))
    return Found(drawn, sheet.clean, seen.separated, seen.layout)


@pytest.fixture(scope="session")
def find() -> Callable[..., Found]:
    """Draws a sample part in a style and finds the views, the last ones kept."""

    def found(
        part: str, style: str, roles: str = "front,top,right", projection: str = "third"
    ) -> Found:
        return _found(part, style, roles, projection)

    return found
