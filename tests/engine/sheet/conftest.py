"""Sheets with known lines, drawn by the engine itself, and how they are read."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import cycle, pairwise

import cv2
import numpy as np
import numpy.typing as npt
import pytest
from engine.sheet.layouts_drawn import drawn_layout
from scipy.spatial import cKDTree

from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.drawn_sheet import Sheet, draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS, Cap, SheetStyle
from gaussiancad_core.drawing.stroke_raster import draw_stroke, rasterise
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.reading_options import Box, ReadingOptions
from gaussiancad_core.sheet.sheet_stages import (
    ReadView,
    RegisteredSheet,
    read_views,
    register_views,
)
from gaussiancad_core.sheet.views.sheet_layout import Layout
from sample_parts import sample

Point = tuple[float, float]
Grey = npt.NDArray[np.uint8]


def _apart(one: Stroke, other: Stroke) -> float:
    """px between two strokes where they are farthest apart; endless between different kinds."""
    if type(one) is not type(other) or one.linetype is not other.linetype:
        return float("inf")
    points, others = one.sample(0.1), other.sample(0.1)
    return max(float(cKDTree(b).query(a)[0].max()) for a, b in ((points, others), (others, points)))


def _differences(drawn: Iterable[Stroke], read: Iterable[Stroke], within: float) -> list[str]:
    left, unknown = list(drawn), []
    for stroke in read:
        found = min(left, key=lambda other: _apart(stroke, other), default=None)
        if found is None or _apart(stroke, found) > within:
            unknown.append(stroke)
        else:
            left.remove(found)
    return [f"not read: {stroke}" for stroke in left] + [f"not drawn: {item}" for item in unknown]


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


class Sketch:
    """Ink on a small sheet, as exact as pixels can be; (x, y) px count from the centre of the first
    pixel.

    Attributes:
        weight: (h, w) float32 share of ink, 0 to 1.
        drawn: what the ink shows, in px whose corners are at integers, as strokes have them.
    """

    def __init__(self, width: int = 200, height: int = 160) -> None:
        self.weight = np.zeros((height, width), np.float32)
        self.drawn: list[Stroke] = []

    def line(self, start: Point, end: Point, width: float = 3.0) -> "Sketch":
        """A straight stroke, cut off square at its ends."""
        self.drawn.append(self._dash(start, end, width))
        return self

    def _dash(self, start: Point, end: Point, width: float) -> Segment:
        ends = [(x + 0.5, y + 0.5) for x, y in (start, end)]
        stroke = Segment(*ends, Linetype.VISIBLE)
        draw_stroke(self.weight, stroke, width, Cap.BUTT)
        return stroke

    def box(
        self, left: float, top: float, right: float, bottom: float, width: float = 3.0
    ) -> "Sketch":
        """Four straight strokes."""
        corners = (left, top), (right, top), (right, bottom), (left, bottom), (left, top)
        return self.lines(*corners, width=width)

    def lines(self, *corners: Point, width: float = 3.0) -> "Sketch":
        """Straight strokes from corner to corner."""
        for start, end in pairwise(corners):
            self.line(start, end, width)
        return self

    def broken(
        self, start: Point, end: Point, lengths: Sequence[float], width: float = 2.0
    ) -> "Sketch":
        """A stroke of dashes and gaps, whose lengths take turns; it ends with a whole dash."""
        ends = [(x + 0.5, y + 0.5) for x, y in (start, end)]
        self.drawn.append(Segment(*ends, Linetype.HIDDEN))
        whole = float(np.hypot(end[0] - start[0], end[1] - start[1]))
        way = ((end[0] - start[0]) / whole, (end[1] - start[1]) / whole)
        at = 0.0
        for index, length in enumerate(cycle(lengths)):
            if at + length > whole + 1e-9:
                return self
            if index % 2 == 0:
                near = (start[0] + at * way[0], start[1] + at * way[1])
                far = (near[0] + length * way[0], near[1] + length * way[1])
                self._dash(near, far, width)
            at += length

    def arc(
        self,
        centre: Point,
        radius: float,
        width: float = 3.0,
        start: float = 0.0,
        sweep: float = 2.0 * np.pi,
    ) -> "Sketch":
        """A circle or a piece of one; angles in radians from x to y."""
        middle = (centre[0] + 0.5, centre[1] + 0.5)
        arc = Arc(middle, radius, start, sweep, Linetype.VISIBLE)
        draw_stroke(self.weight, arc, width, Cap.BUTT)
        self.drawn.append(arc)
        return self

    def inked(
        self, *strokes: Stroke, width: float = 3.0, hidden: float = 2.0, dash: Point = (12.0, 6.0)
    ) -> "Sketch":
        """Strokes as sheets have them: round ends, and hidden ones that end with whole dashes."""
        height, across = self.weight.shape
        style = SheetStyle(width=across, height=height, visible_width=width, hidden_width=hidden)
        style = replace(style, dash=dash[0], gap=dash[1])
        self.weight = np.maximum(self.weight, rasterise(strokes, style))
        self.drawn += strokes
        return self

    def filled(self, *corners: Point) -> "Sketch":
        """A polygon full of ink, its border not smoothed."""
        points = np.rint(16.0 * np.array(corners)).astype(np.int32)
        cv2.fillPoly(self.weight, [points], 1.0, shift=4)
        return self

    def ink(self, *corners: Point, width: float = 3.0) -> "Sketch":
        """Straight strokes that show nothing by themselves, as of a curve or a single dash."""
        for start, end in pairwise(corners):
            self._dash(start, end, width)
        return self

    def shows(self, *strokes: Stroke) -> "Sketch":
        """What the ink shows as well."""
        self.drawn += strokes
        return self

    @property
    def grey(self) -> Grey:
        """(h, w) uint8, dark ink on white paper."""
        return np.rint(255.0 * (1.0 - self.weight)).astype(np.uint8)

    def copied(self, style: str) -> Grey:
        """(h, w) uint8, as of a style that blurs and stains."""
        height, width = self.weight.shape
        look = replace(PRESETS[style], width=width, height=height, skew=0.0)
        image = finished(self.weight, look, 0)
        return (image.mean(axis=2) if image.ndim == 3 else image).astype(np.uint8)

    def view(self, style: str = "") -> ReadView:
        """What is read as one view."""
        sheet = clean_sheet(self.copied(style) if style else self.grey)
        rows, columns = np.nonzero(sheet.ink)
        low, high = (columns.min(), rows.min()), (columns.max() + 1, rows.max() + 1)
        return view_of(sheet, (*map(float, low), *map(float, high)))

    def strokes(self, style: str = "") -> tuple[Stroke, ...]:
        """The strokes of the view."""
        return self.view(style).strokes

    def misread(self, within: float = 0.5, style: str = "") -> list[str]:
        """What was drawn and is not read within some px, and what is read and was not drawn."""
        return _differences(self.drawn, self.strokes(style), within)


def view_of(sheet: CleanSheet, box: Box) -> ReadView:
    """The only view of a sheet."""
    layout = Layout({Role.FRONT: box}, Projection.THIRD, "given", (), ())
    return read_views(sheet, layout)[0]


@pytest.fixture(scope="session")
def read_view() -> Callable[[CleanSheet, Box], ReadView]:
    """Reads a box of a sheet as its only view."""
    return view_of


@pytest.fixture(scope="session")
def differences() -> Callable[[Iterable[Stroke], Iterable[Stroke], float], list[str]]:
    """Of strokes drawn and strokes read, which are to lie within some px: what is missing."""
    return _differences


@pytest.fixture(scope="session")
def sketch() -> type[Sketch]:
    """The class to draw small sheets with."""
    return Sketch


def _grey(image: npt.NDArray[np.uint8]) -> Grey:
    grey = cv2.cvtColor(image, cv2.COLOR_RGB2GRAY)
    return 255 - grey if np.median(grey) < 128 else grey


@lru_cache(maxsize=32)
def _drawn(part: str, style: str, views: str, projection: str) -> Sheet:
    # Smaller than the styles' own sheet: quicker to read.
    look = replace(PRESETS[style], width=1280, height=720, margin=40.0, view_gap=60.0)
    roles = tuple(Role(name) for name in views.split(","))
    return draw_sheet(sample(part).build(), roles, Projection(projection), look)


@lru_cache(maxsize=16)
def _read(part: str, style: str, views: str, projection: str) -> ReadCase:
    sheet = _drawn(part, style, views, projection)
    clean = clean_sheet(_grey(sheet.image))
    layout = drawn_layout(sheet, clean)
    found = read_views(clean, layout)
    return ReadCase(sheet, clean, layout, found, register_views(found, ReadingOptions()))


@pytest.fixture(scope="session")
def draw() -> Callable[..., Sheet]:
    """Draws a sample part, the last ones kept."""

    def drawn(
        part: str, style: str = "clean", views: str = "front,top,right", projection: str = "third"
    ) -> Sheet:
        return _drawn(part, style, views, projection)

    return drawn


@pytest.fixture(scope="session")
def read() -> Callable[..., ReadCase]:
    """Draws a sample part and reads the sheet, the last ones kept."""

    def case(
        part: str, style: str = "clean", views: str = "front,top,right", projection: str = "third"
    ) -> ReadCase:
        return _read(part, style, views, projection)

    return case


@pytest.fixture(scope="session")
def grey() -> Callable[[npt.NDArray[np.uint8]], Grey]:
    """(h, w, 3) RGB -> (h, w) dark ink on light paper."""
    return _grey
