"""What of a sheet is at a place, or near enough at the zoom in which it is seen."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot

from freecad.gaussiancad.canvas.handles import box_between, corners_of
from freecad.gaussiancad.canvas.scene import handle_places
from freecad.gaussiancad.canvas.sheet import Number, Point, Sheet, Stroke, View, distance
from freecad.gaussiancad.canvas.snapping import snapped

_SNAP = 10.0
"""px of the screen within which a place snaps to another."""

_CLICK = 6.0
"""px of the screen by which a stroke, a frame or a handle may be missed."""


@dataclass(frozen=True)
class HitTest:
    """A sheet under the mouse; places are px of the sheet.

    Attributes:
        sheet: what is shown.
        chosen: ids of strokes, or of a view, that are selected.
        zoom: px of the screen per px of the sheet.
    """

    sheet: Sheet
    chosen: frozenset[str]
    zoom: float

    @property
    def selected(self) -> list[Stroke]:
        """The strokes that are selected."""
        return [stroke for stroke in self.sheet.strokes if stroke.id in self.chosen]

    @property
    def selected_view(self) -> View | None:
        """The view that is selected alone."""
        return next((view for view in self.sheet.views if self.chosen == {view.id}), None)

    @property
    def view_meant(self) -> View | None:
        """The view that is selected alone, or the one that all selected strokes are of."""
        views = {stroke.view for stroke in self.sheet.strokes if stroke.id in self.chosen}
        of_strokes = (view for view in self.sheet.views if views == {view.id})
        return self.selected_view or next(of_strokes, None)

    def stroke_at(self, at: Point) -> Stroke | None:
        """The stroke nearest to a place, those of the part first."""
        return self.sheet.stroke_at(at, _CLICK / self.zoom)

    def view_at(self, at: Point) -> View | None:
        """The view whose frame is at a place."""
        for view in self.sheet.views:
            corners = corners_of(view.frame)
            if distance([*corners, corners[0]], at) <= _CLICK / self.zoom:
                return view
        return None

    def number_at(self, at: Point) -> Number | None:
        """The dimension whose text is at a place."""
        for number in self.sheet.numbers:
            x0, y0, x1, y1 = number.box
            if x0 <= at[0] <= x1 and y0 <= at[1] <= y1:
                return number
        return None

    def handle_at(self, at: Point) -> int | None:
        """Which handle of what is selected is at a place."""
        for index, (x, y) in enumerate(handle_places(self.sheet, self.chosen)):
            if hypot(x - at[0], y - at[1]) <= _CLICK / self.zoom:
                return index
        return None

    def strokes_in(self, start: Point, end: Point) -> frozenset[str]:
        """Ids of strokes in a rubber band; drawn to the left, also of those that it touches."""
        x0, y0, x1, y1 = box_between(start, end)
        touching = end[0] < start[0]
        found = set()
        for stroke in self.sheet.strokes:
            inside = [x0 <= x <= x1 and y0 <= y <= y1 for x, y in stroke.points()]
            if all(inside) or (touching and any(inside)):
                found.add(stroke.id)
        return frozenset(found)

    def snapped(self, at: Point, start: Point | None = None) -> Point:
        """Where a place snaps to; ``start`` is of a line that ends there."""
        return snapped(self.sheet, at, _SNAP / self.zoom, start)
