"""Which of a sheet's lines are views: those that belong together.

What is left of annotations may stick out of a view and make it larger than it is: where views do
not belong together with it, they are asked for without.
"""

from dataclasses import replace

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import mutually_orthogonal
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.registration.view_registration import axis_extents
from gaussiancad_core.sheet.special_views.principal_views import LayoutRequest, find_named_layout
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.sheet.votes import HALF
from gaussiancad_protocol.codes import Code

_LARGEST_LEFT_OUT = 10.0
"""Size of a figure that is no view, in that of all views, at most."""

STUB = 1.8
"""Width of a line that sticks out of a view at most, in stroke widths."""


def with_symbol(
    separated: SeparatedSheet, layout: Layout, symbol: ProjectionSymbol | None
) -> tuple[SeparatedSheet, Layout]:
    """The same with what the projection symbol says, where there is one."""
    if symbol is None:
        return separated, layout
    separated = replace(separated, marks=(*separated.marks, symbol.mark))
    alternatives = (symbol.projection.other,)
    return separated, replace(
        layout, symbol=symbol.projection, source="inferred", alternatives=alternatives
    )


def arranged(
    sheet: OpenedSheet, separated: SeparatedSheet, request: LayoutRequest
) -> tuple[SeparatedSheet, Layout]:
    """The views, without what sticks out of them where that alone makes them belong together."""
    given = request.given
    failed: NoModelError | None = None
    found: tuple[SeparatedSheet, Layout] | None = None
    for figures in (False, True):
        try:
            pair = find_named_layout(sheet, separated, replace(request, figures=figures))
            if not given:
                _require_largest(pair[1])
        except NoModelError as error:
            failed = failed or error
            continue
        whole = _is_whole(pair[1])
        if given or (whole and not _leaves_views(pair[1])):
            return pair
        if found is None or (whole and _has_more(pair[1], found[1])):
            found = pair
    if found is None:
        # Without a layout both tries failed.
        assert failed is not None
        raise failed
    return found


def lone_view(
    sheet: OpenedSheet, separated: SeparatedSheet, request: LayoutRequest
) -> tuple[SeparatedSheet, Layout] | None:
    """The only view of a sheet; None where it has more, or none."""
    try:
        pair = find_named_layout(sheet, separated, replace(request, lone=True))
    except NoModelError:
        return None
    return pair if len(pair[1].boxes) == 1 else None


def _has_more(whole: Layout, other: Layout) -> bool:
    """Whether a whole layout is more than another one."""
    return not _is_whole(other) or len(whole.boxes) > len(other.boxes)


def _leaves_views(layout: Layout) -> bool:
    """Whether a figure was left out that is as large as a view."""
    least = min(_area(box) for box in layout.boxes.values())
    return any(_area(box) >= HALF * least for box in layout.left_out)


def _require_largest(layout: Layout) -> None:
    """Refuse slivers as views beside a figure that is much larger than all of them."""
    figure = max(layout.left_out, key=_area, default=None)
    if figure is not None and _area(figure) > _LARGEST_LEFT_OUT * _size(layout):
        x0, y0, x1, y1 = (round(value) for value in figure)
        raise NoModelError(
            Code.VIEWS_NOT_ALIGNED,
            "the largest figure on the sheet, from {place} px, has no aligned neighbour: name the "
            "views with --view ROLE=X0,Y0,X1,Y1",
            boxes=[figure],
            place=f"({x0}, {y0}) to ({x1}, {y1})",
        )


def _is_whole(layout: Layout) -> bool:
    """Whether there are views along all three axes, which belong together."""
    return mutually_orthogonal(tuple(layout.boxes)) and _belong_together(layout)


def _belong_together(layout: Layout) -> bool:
    """Whether the views show one extent of each axis, as far as they show one twice."""
    try:
        axis_extents(dict(layout.boxes))
    except NoModelError:
        return False
    return True


def _size(layout: Layout) -> float:
    """px^2 that the views take."""
    return sum(_area(box) for box in layout.boxes.values())


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])
