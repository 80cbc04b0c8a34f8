"""Which of a sheet's lines are views, tried in several ways: by line widths, by form, as it is.

Annotations that were not told make views larger than they are, or tie them to others; edges that
were told as annotations leave holes.  The way counts that leads to views that belong together.
"""

from collections.abc import Callable
from dataclasses import replace

from gaussiancad_core.axes import Projection, Role, mutually_orthogonal
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.annotations.separate import SeparatedSheet, separate_annotations
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.registration import axis_extents
from gaussiancad_core.sheet.special_views.finding import LayoutRequest, find_named_layout
from gaussiancad_core.sheet.special_views.symbol import ProjectionSymbol, find_symbol

_TINY = 0.02
"""Share of the sheet that its views take together at least, to be relied on at once."""

_LARGEST_LEFT_OUT = 10.0
"""Size of a figure that is no view, in that of all views, at most."""

STUB = 1.8
"""Width of a line that sticks out of a view at most, in stroke widths."""

_LIKE_A_VIEW = 0.5
"""Area of a figure that may be a view at least, as a share of the smallest one."""

_LEAST_WHOLE = 0.4
"""Size of views along all three axes, as a share of that of two views, at least."""

_MUCH_LARGER = 2.0
"""Factor by which other views must be larger to be preferred."""


def find_views(
    sheet: CleanSheet,
    given: dict[Role, Box],
    projection: Projection | None,
    by_weight: bool = True,
) -> tuple[SeparatedSheet, Layout]:
    """Take the annotations off a sheet and find the views on it.

    Where the widths of the lines lead to no views, or to tiny ones, they are not relied on.

    Args:
        sheet: upright.
        given: boxes that the user named, in px of the upright sheet.
        projection: as told by the user, or nothing: then the sheet's symbol is looked for.
        by_weight: whether narrow lines may be told from wide ones; a file may know better.

    Raises:
        NoModelError: see :func:`gaussiancad_core.sheet.special_views.finding.find_named_layout`.
        UsageError: a given box holds no ink.
    """
    symbol = find_symbol(sheet) if projection is None else None
    told = symbol.projection if symbol else projection
    return with_symbol(*_separated_views(sheet, given, told, by_weight), symbol)


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


def _separated_views(
    sheet: CleanSheet, given: dict[Role, Box], projection: Projection | None, by_weight: bool
) -> tuple[SeparatedSheet, Layout]:
    """Without relying on line widths, or on annotations at all, where that leads to more.

    Where the widths leave two views only, outlines may have been taken for annotations.
    """
    separated = separate_annotations(sheet, by_weight)
    ways: list[Callable[[], SeparatedSheet]] = [lambda: separated]
    if separated.by_weight:
        ways.append(lambda: separate_annotations(sheet, by_weight=False))
    if sheet.plotted:
        ways.append(lambda: separate_annotations(sheet, by_weight=False, closed=False))
    if separated.marks:
        ways.append(lambda: SeparatedSheet(sheet, (), False))
    best: tuple[SeparatedSheet, Layout] | None = None
    first: NoModelError | None = None
    for way in ways:
        tried = way()
        try:
            stub = STUB * tried.part.stroke_width
            tried, layout = arranged(sheet, tried, LayoutRequest(given, projection, stub))
        except NoModelError as error:
            first = first or error
            continue
        if best is None or _is_better(layout, best[1]):
            best = tried, layout
        doubtful = (tried.by_weight or tried.closed) and not _is_whole(layout)
        if not doubtful and _size(best[1]) > _TINY * sheet.ink.size:
            return best
    if best is None and first.code == "one-view" and not given:
        stub = STUB * separated.part.stroke_width
        best = lone_view(sheet, separated, LayoutRequest({}, projection, stub))
    if best is None:
        raise first
    return best


def arranged(
    sheet: CleanSheet, separated: SeparatedSheet, request: LayoutRequest
) -> tuple[SeparatedSheet, Layout]:
    """The views, without what sticks out of them where that alone makes them belong together."""
    given = request.given
    failed: NoModelError | None = None
    found: tuple[SeparatedSheet, Layout] | None = None
    for figures in (False, True):
        try:
            own = find_named_layout(sheet, separated, replace(request, figures=figures))
            if not given:
                _require_largest(own[1])
        except NoModelError as error:
            failed = failed or error
            continue
        whole = _is_whole(own[1])
        if given or (whole and not _leaves_views(own[1])):
            return own
        if found is None or (whole and _has_more(own[1], found[1])):
            found = own
    if found is None:
        raise failed
    return found


def lone_view(
    sheet: CleanSheet, separated: SeparatedSheet, request: LayoutRequest
) -> tuple[SeparatedSheet, Layout] | None:
    """The only view of a sheet; None where it has more, or none."""
    try:
        own = find_named_layout(sheet, separated, replace(request, lone=True))
    except NoModelError:
        return None
    return own if len(own[1].boxes) == 1 else None


def _has_more(whole: Layout, other: Layout) -> bool:
    """Whether a whole layout is more than another one."""
    return not _is_whole(other) or len(whole.boxes) > len(other.boxes)


def _leaves_views(layout: Layout) -> bool:
    """Whether a figure was left out that is as large as a view."""
    least = min(_area(box) for box in layout.boxes.values())
    return any(_area(box) >= _LIKE_A_VIEW * least for box in layout.left_out)


def _require_largest(layout: Layout) -> None:
    """Refuse slivers as views beside a figure that is much larger than all of them."""
    figure = max(layout.left_out, key=_area, default=None)
    if figure is not None and _area(figure) > _LARGEST_LEFT_OUT * _size(layout):
        x0, y0, x1, y1 = (round(value) for value in figure)
        raise NoModelError(
            "views-not-aligned",
            "the largest figure on the sheet, from {place} px, has no aligned neighbour: name the "
            "views with --view ROLE=X0,Y0,X1,Y1",
            boxes=[figure],
            place=f"({x0}, {y0}) to ({x1}, {y1})",
        )


def _is_better(layout: Layout, other: Layout) -> bool:
    """Whether views are much larger than others, and belong together unless those do not either;
    or are whole and larger than those that are not.  Where those lack a view, they may be larger:
    dimensions that stayed lose one, and add to the others."""
    size = _size(other)
    least = size if mutually_orthogonal(tuple(other.boxes)) else _LEAST_WHOLE * size
    if _is_whole(layout) and not _is_whole(other) and _size(layout) > least:
        return True
    larger = _size(layout) > _MUCH_LARGER * size
    return larger and (_belong_together(layout) or not _belong_together(other))


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
