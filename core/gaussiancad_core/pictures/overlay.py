"""The sheet with a result's lines over it: what agrees is blue, what disagrees stands out.

The colours are those of Okabe and Ito (2008), which colour-blind people can tell apart.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.labelling.conflict_lines import ConflictLine
from gaussiancad_core.lines.line_agreement import MatchedLines
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import View
from gaussiancad_core.pictures.picture_letters import put_text, text_image
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.special_views.view_kinds import SpecialView

Image = npt.NDArray[np.uint8]
Points = npt.NDArray[np.float64]
Colour = tuple[int, int, int]

_VISIBLE = (0, 114, 178)
_HIDDEN = (86, 180, 233)
_MISSING = (213, 94, 0)
_EXTRA = (204, 51, 153)
_FRAME = (150, 150, 150)
_CONFLICT = (240, 228, 66)
_BORDER = (0, 0, 0)

_CONFLICT_LABEL = "contradict each other"
_SUSPECT_LABEL = "probably wrong or missing"

_LEGEND = (
    (_VISIBLE, "agrees, visible"),
    (_HIDDEN, "agrees, hidden"),
    (_MISSING, "on the sheet only"),
    (_EXTRA, "in the result only"),
)

_LAYERS = (("hidden", _HIDDEN), ("visible", _VISIBLE), ("extra", _EXTRA), ("missing", _MISSING))
"""Lines in the order in which they are drawn, and their colours."""

_MARKS = {
    "frame, title block": (
        (150, 150, 150),
        (AnnotationKind.FRAME, AnnotationKind.TITLE_BLOCK, AnnotationKind.SYMBOL),
    ),
    "writing": ((127, 96, 170), (AnnotationKind.TEXT,)),
    "dimensions": (
        (128, 128, 0),
        (AnnotationKind.DIMENSION, AnnotationKind.EXTENSION, AnnotationKind.LEADER),
    ),
    "centre lines": (
        (0, 158, 115),
        (AnnotationKind.CENTRE_LINE, AnnotationKind.CENTRE_MARK),
    ),
    "hatching": ((230, 159, 0), (AnnotationKind.HATCHING,)),
}
"""What is not the part, in groups that share a colour."""

_SPECIAL = (90, 60, 160)
"""Other drawings than the principal views."""

_INK = 0.32
"""How much of the sheet's own contrast remains."""


@dataclass(frozen=True, eq=False)
class OverlaidLines:
    """Points along the lines of a view and of a result, (n, 2) mm in the view's plane.

    Attributes:
        visible, hidden: of the result's lines, where they agree with the sheet.
        missing: of what the sheet has and the result has not, or has otherwise.
        extra: of what the result has and the sheet has not.
    """

    visible: Points
    hidden: Points
    missing: Points
    extra: Points


@dataclass(frozen=True, eq=False)
class ViewOverlay:
    """One view of the sheet and what was drawn over it.

    Attributes:
        view: with its box on the sheet.
        size: (3,) extent of the part in mm.
        lines: of the sheet and of the result.
        conflict: those that contradict other lines of the sheet.
    """

    view: View
    size: tuple[float, float, float]
    lines: OverlaidLines
    conflict: tuple[ConflictLine, ...] = ()

    def to_sheet(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """(n, 2) mm of the view's plane -> (n, 2) px of the sheet as stored."""
        return view_to_sheet(self.view, self.size, points)


def view_to_sheet(
    view: View, size: tuple[float, float, float], points: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """(n, 2) mm of a view's plane -> (n, 2) px of the sheet that its box is on.

    Args:
        view: with its box.
        size: (3,) extent of the part in mm.
        points: (right, up).
    """
    frame = view.role.frame
    x0, y0, x1, y1 = view.box
    left, right = _range(frame.right_axis, size)
    bottom, top = _range(frame.up_axis, size)
    return np.stack(
        [
            x0 + (points[:, 0] - left) / (right - left) * (x1 - x0),
            y1 + (points[:, 1] - bottom) / (top - bottom) * (y0 - y1),
        ],
        axis=1,
    )


def draw_overlay(
    sheet: Image,
    views: Sequence[ViewOverlay],
    marks: Sequence[Mark] = (),
    special: Sequence[SpecialView] = (),
) -> Image:
    """Draw the views' lines over the sheet, and what was taken off it.

    Args:
        sheet: (h, w) grey or (h, w, 3) RGB, upright.
        views: whose boxes are in pixels of that sheet.
        marks: annotations in pixels of that sheet.
        special: drawings that are no plain principal views, in pixels of that sheet.

    Returns:
        (h2, w2, 3) RGB with a legend below; larger sheets are reduced to 4000 px.
    """
    import cv2

    grey = sheet if sheet.ndim == 2 else cv2.cvtColor(sheet, cv2.COLOR_RGB2GRAY)
    scale = min(1.0, 4000 / max(grey.shape))
    if scale < 1.0:
        grey = cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    faded = 255.0 - (255.0 - grey.astype(np.float32)) * _INK
    picture = np.repeat(np.rint(faded).astype(np.uint8)[..., None], 3, axis=2)

    width = max(1, round(max(picture.shape) / 900))
    letters = max(12, round(max(picture.shape) / 90))
    legend = list(_LEGEND)
    for label, (colour, kinds) in _MARKS.items():
        this_marks = [mark for mark in marks if mark.kind in kinds]
        _draw_marks(picture, this_marks, scale, colour)
        legend += [(colour, label)] if this_marks else []
    _draw_special(picture, special, scale, letters)
    legend += [(_SPECIAL, "other drawings")] if special else []
    legend += _draw_conflict(picture, views, scale, width)
    for name, colour in _LAYERS:
        strong = width + (1 if colour in (_MISSING, _EXTRA) else 0)
        for view in views:
            points = getattr(view.lines, name)
            _paint(picture, view.to_sheet(points) * scale, colour, strong)
    for view in views:
        _frame(picture, view.view, scale, letters)
    return _with_legend(picture, legend, letters)


def _draw_conflict(
    picture: Image, views: Sequence[ViewOverlay], scale: float, width: int
) -> list[tuple[Colour, str]]:
    """Lines that contradict each other as with a marker pen, suspects with a border."""
    import cv2

    legend: dict[str, Colour] = {}
    pen = 9 * width
    for view in views:
        for line in sorted(view.conflict, key=lambda line: line.suspect):
            points = np.rint(view.to_sheet(line.points) * scale).astype(np.int32)
            if line.suspect:
                cv2.polylines(picture, [points], False, _BORDER, pen + 2 * max(2, width))
            cv2.polylines(picture, [points], False, _CONFLICT, pen)
            legend[_SUSPECT_LABEL if line.suspect else _CONFLICT_LABEL] = _CONFLICT
    return [(colour, label) for label, colour in legend.items()]


def _range(axis: tuple[Axis, int], size: tuple[float, float, float]) -> tuple[float, float]:
    """Least and greatest coordinate of a part along a signed axis of a view."""
    extent = size[axis[0].value]
    return (0.0, extent) if axis[1] > 0 else (-extent, 0.0)


def matched_overlay(matched: MatchedLines) -> OverlaidLines:
    """Lines that were matched with each other point by point."""
    sheet, result = matched.sheet, matched.result
    missing = (
        sheet.visible.points[~matched.visible_found],
        sheet.hidden.points[~matched.hidden_found],
    )
    extra = (
        result.visible.points[~matched.visible_explained],
        result.hidden.points[~matched.hidden_explained],
    )
    return OverlaidLines(
        result.visible.points[matched.visible_explained],
        result.hidden.points[matched.hidden_explained],
        np.concatenate(missing),
        np.concatenate(extra),
    )


def _paint(picture: Image, pixels: npt.NDArray[np.float64], colour: Colour, width: int) -> None:
    """Colour what lies within half a width of the points."""
    import cv2

    if not len(pixels):
        return
    height, across = picture.shape[:2]
    mask = np.zeros((height, across), dtype=np.uint8)
    columns, rows = np.floor(pixels).astype(np.int64).T
    within = (columns >= 0) & (columns < across) & (rows >= 0) & (rows < height)
    mask[rows[within], columns[within]] = 1
    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (width + 1, width + 1))
    picture[cv2.dilate(mask, kernel) > 0] = colour


def _frame(picture: Image, view: View, scale: float, letters: int) -> None:
    """A thin box around a view, with the name of its role above its left corner."""
    import cv2

    gap = letters / 2
    x0, y0, x1, y1 = (value * scale for value in view.box)
    start, end = (round(x0 - gap), round(y0 - gap)), (round(x1 + gap), round(y1 + gap))
    cv2.rectangle(picture, start, end, _FRAME, 1)
    name = text_image(view.role.value, letters)
    put_text(picture, name, start[0], start[1] - name.shape[0] - 2)


def _draw_marks(picture: Image, marks: Sequence[Mark], scale: float, colour: Colour) -> None:
    """Lines as lines, all else as boxes."""
    import cv2

    for mark in marks:
        x0, y0, x1, y1 = mark.box
        start, end = mark.line or ((x0, y0), (x1, y1))
        ends = [(round(x * scale), round(y * scale)) for x, y in (start, end)]
        draw = cv2.line if mark.line else cv2.rectangle
        draw(picture, ends[0], ends[1], colour, 1)


def _draw_special(
    picture: Image, special: Sequence[SpecialView], scale: float, letters: int
) -> None:
    """Boxes with what is in them below their left corner."""
    import cv2

    gap = letters
    for view in special:
        x0, y0, x1, y1 = (value * scale for value in view.box)
        start, end = (round(x0 - gap), round(y0 - gap)), (round(x1 + gap), round(y1 + gap))
        cv2.rectangle(picture, start, end, _SPECIAL, 2)
        put_text(picture, text_image(view.kind.value, letters), start[0], end[1] + 4)


def _with_legend(picture: Image, legend: Sequence[tuple[Colour, str]], letters: int) -> Image:
    """The picture with a strip below it that names the colours."""
    entries = [(colour, label, text_image(label, letters)) for colour, label in legend]
    gap, sample = letters, 2 * letters
    needed = sum(sample + gap // 2 + text.shape[1] + 2 * gap for _, _, text in entries)
    width = max(picture.shape[1], needed)
    strip = np.full((3 * letters, width, 3), 255, dtype=np.uint8)
    strip[0] = _FRAME
    x, middle = gap, strip.shape[0] // 2
    for colour, label, text in entries:
        half = max(1, letters // 8)
        if colour == _CONFLICT:
            half *= 3
        if label == _SUSPECT_LABEL:
            strip[middle - half - 2 : middle + half + 3, x - 2 : x + sample + 2] = _BORDER
        strip[middle - half : middle + half + 1, x : x + sample] = colour
        x += sample + gap // 2
        put_text(strip, text, x, middle - text.shape[0] // 2)
        x += text.shape[1] + 2 * gap
    blank = np.full((picture.shape[0], width - picture.shape[1], 3), 255, dtype=np.uint8)
    return np.vstack([np.hstack([picture, blank]), strip])
