"""Hatched areas of sections as polygons, and the regions of views that are cut open."""

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np

from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView, Ring
from gaussiancad_core.sheet.special_views.cut_views import hatched_box
from gaussiancad_core.sheet.special_views.drawing_names import inside
from gaussiancad_core.sheet.special_views.view_kinds import SECTIONS, SpecialKind, SpecialView
from gaussiancad_core.sheet.views.sheet_layout import Layout

_MOST_PX = 25
"""px by which an area is led to the middle of the lines around it at most."""

_CHORD = 0.7
"""px by which a polygon may run beside the edge of the pixels."""

_LEAST = 9.0
"""px^2 of an area, or of a hole in one, at least."""


def with_hatched_areas(
    drawn: Sequence[ReadView], layout: Layout, hatched: Mask | None
) -> tuple[ReadView, ...]:
    """The views, those that are sections with what is hatched and where they are cut open.

    Args:
        drawn: in the layout's order.
        layout: with the sections.
        hatched: (h, w) of the upright sheet; None where nothing is.
    """
    if hatched is None:
        return tuple(drawn)
    sections = {
        special_view.box: special_view
        for special_view in layout.special
        if special_view.kind in SECTIONS and special_view.used
    }
    found = []
    for view in drawn:
        section = sections.get(layout.boxes[view.role])
        found.append(view if section is None else cut_open(view, section, hatched))
    return tuple(found)


def with_named_sections(
    drawn: Sequence[ReadView], layout: Layout, named: Sequence[Box], hatched: Mask | None
) -> tuple[tuple[ReadView, ...], Layout]:
    """The views and the layout, where views that the sheet names as sections are sections, however
    little of them is hatched.

    Args:
        drawn: in the layout's order.
        layout: of the views.
        named: boxes of sections with titles.
        hatched: (h, w) of the upright sheet; None where nothing is.
    """
    if hatched is None:
        return tuple(drawn), layout
    known = {special_view.box for special_view in layout.special}
    found = []
    for view in drawn:
        box = layout.boxes[view.role]
        is_named = box not in known and any(inside(box, pair) for pair in named)
        x0, y0, x1, y1 = (round(value) for value in box)
        if not is_named or not hatched[y0:y1, x0:x1].any():
            found.append(view)
            continue
        section = SpecialView(SpecialKind.SECTION, box, True, hatched_box(hatched, box))
        found.append(cut_open(view, section, hatched))
        layout = replace(layout, special=(*layout.special, section))
    return tuple(found), layout


def cut_open(view: ReadView, section: SpecialView, hatched: Mask) -> ReadView:
    """A view that is a section, with what is hatched and where it is cut open."""
    rings = rings_within(hatched, section.box)
    return replace(view, hatched=rings, opened=opened_region(section, rings))


def opened_region(section: SpecialView, rings: Sequence[Ring]) -> Ring:
    """The region of a view that is cut open, px; empty for all of it.

    Of a half section that is the half with the hatching.  Of a broken-out section nothing but the
    hatching and its break line tell: it is taken to be convex.
    """
    if section.kind is SpecialKind.SECTION or section.cut is None:
        return ()
    if section.kind is SpecialKind.PARTIAL_SECTION:
        points = np.array([point for ring in rings for point in ring], dtype=np.float32)
        if len(points) < 3:
            return ()
        hull = cv2.convexHull(points)[:, 0].tolist()
        return tuple((float(x), float(y)) for x, y in hull)
    x0, y0, x1, y1 = _half(section.box, section.cut)
    return ((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def _half(box: Box, cut: Box) -> Box:
    """The half of a box that its hatching keeps to."""
    x0, y0, x1, y1 = box
    middle = (0.5 * (x0 + x1), 0.5 * (y0 + y1))
    # The direction in which the hatching keeps to one side.
    off_x = abs(0.5 * (cut[0] + cut[2]) - middle[0]) / (x1 - x0)
    off_y = abs(0.5 * (cut[1] + cut[3]) - middle[1]) / (y1 - y0)
    if off_x >= off_y:
        right = cut[2] - middle[0] > middle[0] - cut[0]
        return (middle[0], y0, x1, y1) if right else (x0, y0, middle[0], y1)
    below = cut[3] - middle[1] > middle[1] - cut[1]
    return (x0, middle[1], x1, y1) if below else (x0, y0, x1, middle[1])


def to_middles(hatched: Mask | None, width: float) -> Mask | None:
    """Hatched areas as far as the middles of the lines around them.

    Args:
        hatched: (h, w), between the lines.
        width: of the lines, px.
    """
    if hatched is None:
        return None
    side = min(2 * round(width / 2.0) + 1, _MOST_PX)
    kernel = cv2.getStructuringElement(cv2.MORPH_RECT, (side, side))
    return cv2.dilate(hatched.astype(np.uint8), kernel) > 0


def rings_within(hatched: Mask, box: Box) -> tuple[Ring, ...]:
    """Outlines of hatched areas in a box, and of the holes in them, px of the sheet: an odd number
    of them surrounds what is hatched."""
    x0, y0, x1, y1 = (round(value) for value in box)
    window = np.ascontiguousarray(hatched[max(y0, 0) : y1, max(x0, 0) : x1]).astype(np.uint8)
    # Between its pixels' middles runs a contour: on a finer grid it is the areas' own edge.
    fine = cv2.resize(window, None, fx=2.0, fy=2.0, interpolation=cv2.INTER_NEAREST)
    contours, _ = cv2.findContours(fine, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    found = []
    for contour in contours:
        smooth = cv2.approxPolyDP(contour, 2.0 * _CHORD, closed=True)[:, 0]
        if len(smooth) >= 3 and cv2.contourArea(contour) >= 4.0 * _LEAST:
            places = (smooth + 0.5) / 2.0 + (max(x0, 0), max(y0, 0))
            found.append(tuple((float(x), float(y)) for x, y in places))
    return tuple(found)
