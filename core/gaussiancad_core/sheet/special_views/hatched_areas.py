"""Hatched areas of sections as polygons."""

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np

from gaussiancad_core.sheet.annotations.marks import Mask
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.reading import ReadView, Ring
from gaussiancad_core.sheet.special_views.kinds import SpecialKind

_CHORD = 0.7
"""px by which a polygon may run beside the edge of the pixels."""

_LEAST = 9.0
"""px^2 of an area, or of a hole in one, at least."""


def with_hatched_areas(
    drawn: Sequence[ReadView], layout: Layout, hatched: Mask | None
) -> tuple[ReadView, ...]:
    """The views, those that are full sections with what is hatched of them.

    Args:
        drawn: in the layout's order.
        layout: with the sections.
        hatched: (h, w) of the upright sheet; None where nothing is.
    """
    if hatched is None:
        return tuple(drawn)
    sections = {own.box for own in layout.special if own.kind is SpecialKind.SECTION and own.used}
    cut = {role for role, box in layout.boxes.items() if box in sections}
    return tuple(
        replace(view, hatched=rings_within(hatched, layout.boxes[view.role]))
        if view.role in cut
        else view
        for view in drawn
    )


def rings_within(hatched: Mask, box: tuple[float, float, float, float]) -> tuple[Ring, ...]:
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
