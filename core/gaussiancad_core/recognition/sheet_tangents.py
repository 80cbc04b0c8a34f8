"""Tangent edges taken off the views of a sheet, a file or a picture."""

from dataclasses import dataclass, replace

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.model.views import Segment
from gaussiancad_core.recognition.sheet_views import SheetViews
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.inked_widths import InkedWidths
from gaussiancad_core.sheet.special_views.tangent_edges import without_tangent_edges
from gaussiancad_core.sheet.special_views.tangent_policy import SheetTangents

_MARGIN = 1.0
"""px by which a line may reach beyond the box of its view."""


@dataclass(frozen=True, eq=False)
class SheetWithoutTangents:
    """A sheet whose views have no tangent edges among their strokes.

    Attributes:
        found: what was found on it; lines in other pens that are tangent edges are no others.
        drawn: the views, each with its tangent edges apart.
        tangents: what the sheet does with tangent edges.
    """

    found: SheetViews
    drawn: tuple[ReadView, ...]
    tangents: SheetTangents


def sheet_without_tangents(found: SheetViews, drawn: tuple[ReadView, ...]) -> SheetWithoutTangents:
    """The views of a sheet without their tangent edges.

    Args:
        found: on the sheet, before its lines were read.
        drawn: the views with their strokes, px of the upright sheet.
    """
    thin = {
        view.role: [stroke for stroke in found.others if _holds(view.box, stroke.box)]
        for view in drawn
    }
    widths = InkedWidths(found.separated.part, drawn)
    edges = without_tangent_edges(drawn, thin, widths.is_thin)
    known = {
        (line.start, line.end)
        for view in edges.views
        for line in view.tangents
        if isinstance(line, Segment)
    }
    marks = tuple(mark for mark in found.separated.marks if mark.line not in known)
    others = tuple(line for line in found.other_pens if (line.start, line.end) not in known)
    separated = replace(found.separated, marks=marks)
    found = replace(found, separated=separated, other_pens=others)
    return SheetWithoutTangents(found, edges.views, edges.sheet)


def _holds(box: Box, other: Box) -> bool:
    x0, y0, x1, y1 = box
    return (
        x0 - _MARGIN <= other[0]
        and y0 - _MARGIN <= other[1]
        and other[2] <= x1 + _MARGIN
        and other[3] <= y1 + _MARGIN
    )
