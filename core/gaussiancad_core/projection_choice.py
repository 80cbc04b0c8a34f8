"""First or third angle: the reading under which the sheet's lines fit together.

Where exact solids do not tell (:mod:`.exact_stage`), the lines do.  Under the other reading each
view beside the front is its opposite, and the part is mirrored.  The outlines do not tell the two
apart, but what hides what does: the visual hull of either reading is drawn again, and its visible
and hidden lines are matched with those of the sheet.  A hull has no pockets, so that a small
difference may be due to what it lacks: an unusual reading needs a larger one.
"""

from dataclasses import dataclass, replace

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.layout import is_unusual
from gaussiancad_core.sheet.options import ReadingOptions
from gaussiancad_core.sheet.reading import ReadView, RegisteredSheet, register_views

_CELLS = 96
"""Grid cells of the hulls that are compared."""

_PIXELS = 420
"""Longest side in px of their drawings."""

_TOLERANCE = 2.5
"""px of those drawings within which lines agree."""

_CLEAR = 0.02
"""Difference of the two agreements from which one reading is better."""

_CLEAR_UNUSUAL = 0.05
"""The same for a reading with a view from below, where the other one has it from above."""

_TELLING = 0.4
"""Agreement of the better one at least: less is due to the few lines that any hull has."""


@dataclass(frozen=True)
class Choice:
    """How well either reading fits.

    Attributes:
        registered: the views as read under the better one, or the one that was assumed.
        other: as read under the other one; None where the views contradict each other then.
        projection: that reading.
        inferred: whether it is clearly better than the other.
        scores: of the assumed one and the other: share of the lines that agree, 0 to 1.
    """

    registered: RegisteredSheet
    other: RegisteredSheet | None
    projection: Projection
    inferred: bool
    scores: tuple[float, float]

    def told(self, projection: Projection) -> "Choice":
        """The choice where a reading is told from elsewhere; unchanged if that cannot be."""
        if projection is self.projection:
            return replace(self, inferred=True)
        if self.other is None:
            return self
        return Choice(self.other, self.registered, projection, True, self.scores[::-1])


def both_readings(
    drawn: tuple[ReadView, ...], options: ReadingOptions
) -> tuple[RegisteredSheet, RegisteredSheet | None]:
    """Views on shared axes, as they are named and as the other projection names them.

    Args:
        drawn: views with the roles that they have under the assumed projection.
        options: of the registration.

    Returns:
        The two; None for the other one where the views contradict each other then.

    Raises:
        NoModelError: the views contradict each other as they are named.
    """
    registered = register_views(drawn, options)
    mirrored = tuple(replace(view, role=opposite(view.role)) for view in drawn)
    try:
        return registered, register_views(mirrored, options)
    except NoModelError:
        return registered, None


def choose_projection(
    registered: RegisteredSheet, other: RegisteredSheet | None, assumed: Projection
) -> Choice:
    """Decide between two readings of the same views.

    Args:
        registered: the views under the assumed projection.
        other: under the other one; None where that is not possible.
        assumed: what to take where nothing tells.
    """
    if other is None:
        return Choice(registered, None, assumed, True, (1.0, 0.0))
    scores = _agreement(registered), _agreement(other)
    contrary = scores[1] > scores[0]
    better = {view.role for view in (other if contrary else registered).drawn}
    least = _CLEAR_UNUSUAL if is_unusual(better) else _CLEAR
    clear = abs(scores[0] - scores[1]) > least and max(scores) >= _TELLING
    if clear and contrary:
        return Choice(other, registered, assumed.other, True, scores)
    return Choice(registered, other, assumed, clear, scores)


def opposite(role: Role) -> Role:
    """The role of a view beside the front under the other projection."""
    return _OPPOSITES.get(role, role)


_OPPOSITES = {
    Role.TOP: Role.BOTTOM,
    Role.BOTTOM: Role.TOP,
    Role.LEFT: Role.RIGHT,
    Role.RIGHT: Role.LEFT,
}


def _agreement(registered: RegisteredSheet) -> float:
    """Share of the sheet's lines that its hull shows, visible as visible and hidden as hidden."""
    from gaussiancad_core.cameras import orthographic_camera
    from gaussiancad_core.hull import visual_hull
    from gaussiancad_core.verification.agreement import match_lines
    from gaussiancad_core.verification.redraw import RedrawSettings, redraw_mesh

    views = registered.views
    cameras = tuple(orthographic_camera(role, views.size, _PIXELS) for role in views.roles)
    try:
        hull = visual_hull(views, cameras, cells=_CELLS)
    except NoModelError:
        return 0.0
    pitch = max(views.size) / _PIXELS
    found = total = 0.0
    for view in views.views:
        lines = redraw_mesh(hull, view.role, pitch, RedrawSettings(most_pixels=_PIXELS))
        matched = match_lines(view.strokes, lines, _TOLERANCE * pitch)
        for points, near in (
            (matched.sheet.visible, matched.visible_found),
            (matched.sheet.hidden, matched.hidden_found),
        ):
            found += float(points.lengths[near].sum())
            total += float(points.lengths.sum())
    return found / total if total else 0.0
