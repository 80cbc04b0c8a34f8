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
from gaussiancad_core.drawing.style import PRESETS, SheetStyle
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

USUAL = (Role.FRONT, Role.TOP, Role.RIGHT)


@dataclass(frozen=True)
class Reading:
    """A drawn sheet and every stage of its reading."""

    sheet: Sheet
    clean: CleanSheet
    layout: Layout
    drawn: tuple[ReadView, ...]
    registered: RegisteredSheet

    def view(self, role: Role) -> ReadView:
        return next(view for view in self.drawn if view.role is role)


def grey_of(image: npt.NDArray[np.uint8]) -> npt.NDArray[np.uint8]:
    return cv2.cvtColor(image, cv2.COLOR_RGB2GRAY)


def small_style(name: str) -> SheetStyle:
    """A named style on a sheet that is quick to read."""
    return replace(PRESETS[name], width=1280, height=720, margin=40.0, view_gap=60.0)


@cache
def drawn_sheet(
    part: str,
    style: str = "clean",
    roles: tuple[Role, ...] = USUAL,
    projection: Projection = Projection.THIRD,
) -> Sheet:
    return draw_sheet(sample(part).build(), roles, projection, small_style(style))


@cache
def read_drawing(
    part: str,
    style: str = "clean",
    roles: tuple[Role, ...] = USUAL,
    projection: Projection = Projection.THIRD,
) -> Reading:
    sheet = drawn_sheet(part, style, roles, projection)
    clean = clean_sheet(grey_of(sheet.image))
    layout = find_layout(clean.ink, {}, projection)
    drawn = read_views(clean, layout)
    return Reading(sheet, clean, layout, drawn, register_views(drawn, ReadingOptions()))


@pytest.fixture(scope="session")
def draw() -> Callable[..., Sheet]:
    """Draws a sample part: name, style, roles, projection; each sheet once a session."""
    return drawn_sheet


@pytest.fixture(scope="session")
def reading() -> Callable[..., Reading]:
    """Draws and reads a sample part: name, style, roles, projection; each once a session."""
    return read_drawing


@pytest.fixture(scope="session")
def grey() -> Callable[[npt.NDArray[np.uint8]], npt.NDArray[np.uint8]]:
    """(h, w, 3) RGB -> (h, w) luminance."""
    return grey_of
