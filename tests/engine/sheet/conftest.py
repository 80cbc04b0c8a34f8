"""Sheets with known lines, drawn by the engine itself, and how they are read."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import cv2
import numpy as np
import numpy.typing as npt
import pytest

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.drawing.sheet import Sheet, draw_sheet
from gaussiancad_core.drawing.style import PRESETS
from gaussiancad_core.samples import sample
from gaussiancad_core.sheet.clean import CleanSheet, clean_sheet
from gaussiancad_core.sheet.layout import Layout, find_layout
from gaussiancad_core.sheet.options import ReadingOptions
from gaussiancad_core.sheet.reading import (
    ReadView,
    RegisteredSheet,
    read_views,
    register_views,
)

Grey = npt.NDArray[np.uint8]


@dataclass(frozen=True)
class ReadCase:
    """A drawn sheet and every stage of its reading."""

    drawn: Sheet
    clean: CleanSheet
    layout: Layout
    views: tuple[ReadView, ...]
    registered: RegisteredSheet

    def __getitem__(self, role: Role) -> ReadView:
        return next(view for view in self.views if view.role is role)


def _grey(image: npt.NDArray[np.uint8]) -> Grey:
    grey = cv2.cvtColor(image, cv2.COLOR_RGB2GRAY)
    return 255 - grey if np.median(grey) < 128 else grey


@cache
def _drawn(part: str, style: str, views: str, projection: str) -> Sheet:
    # Smaller than the styles' own sheet: quicker to read.
    look = replace(PRESETS[style], width=1280, height=720, margin=40.0, view_gap=60.0)
    roles = tuple(Role(name) for name in views.split(","))
    return draw_sheet(sample(part).build(), roles, Projection(projection), look)


@cache
def _read(part: str, style: str, views: str, projection: str) -> ReadCase:
    sheet = _drawn(part, style, views, projection)
    clean = clean_sheet(_grey(sheet.image))
    layout = find_layout(clean.ink, {}, sheet.projection)
    found = read_views(clean, layout)
    return ReadCase(sheet, clean, layout, found, register_views(found, ReadingOptions()))


@pytest.fixture(scope="session")
def draw() -> Callable[..., Sheet]:
    """Draws a sample part, each sheet once a session."""

    def drawn(
        part: str, style: str = "clean", views: str = "front,top,right", projection: str = "third"
    ) -> Sheet:
        return _drawn(part, style, views, projection)

    return drawn


@pytest.fixture(scope="session")
def read() -> Callable[..., ReadCase]:
    """Draws a sample part and reads the sheet, each once a session."""

    def case(
        part: str, style: str = "clean", views: str = "front,top,right", projection: str = "third"
    ) -> ReadCase:
        return _read(part, style, views, projection)

    return case


@pytest.fixture(scope="session")
def grey() -> Callable[[npt.NDArray[np.uint8]], Grey]:
    """(h, w, 3) RGB -> (h, w) dark ink on light paper."""
    return _grey
