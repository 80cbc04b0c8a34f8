"""How a drawing leaves lines out, and the reading of exact lines that were drawn so."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from gaussiancad_core.evidence.drawn_views import EXACT_TOLERANCE
from gaussiancad_core.evidence.projected_reading import ProjectedReading
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Linetype, View, ViewSet
from gaussiancad_core.sheet.registration.stroke_precision import StrokesSource, tolerance_px
from gaussiancad_core.sheet.registration.view_masks import Outline
from gaussiancad_core.sheet.registration.view_registration import AxisExtents
from gaussiancad_core.sheet.sheet_stages import ReadView, RegisteredSheet

Size = tuple[float, float, float]
Drawing = Mapping[Role, tuple[DrawnStroke, ...]]

_F, _T, _R, _L, _B, _H = (
    Role.FRONT,
    Role.TOP,
    Role.RIGHT,
    Role.LEFT,
    Role.BOTTOM,
    Role.REAR,
)

IN_FIRST = {_F: _F, _T: _B, _R: _L, _L: _R, _B: _T, _H: _H}
"""What a view of a third-angle sheet shows where that is read in first angle."""

_ALIKE = 2e-4
"""Share of the longest extent within which the lines of two drawings are the same."""

_STEP = 0.01
"""Distance of the points of a line, as a share of it, by which drawings are compared."""


@dataclass(frozen=True)
class Policy:
    """How a part is drawn.

    Attributes:
        name: in tables.
        roles: the views, the front view first.
        hidden: those of them whose hidden lines are drawn.
        tangent: whether smooth edges are drawn.
        stated: whether first or third angle is.
    """

    name: str
    roles: tuple[Role, ...] = (_F, _T, _R)
    hidden: frozenset[Role] = frozenset(Role)
    tangent: bool = False
    stated: bool = True


POLICIES = (
    Policy("all hidden lines"),
    Policy("projection not told", stated=False),
    Policy("smooth edges", tangent=True),
    Policy("no hidden lines", hidden=frozenset()),
    Policy("hidden lines in front only", hidden=frozenset({_F})),
    Policy("hidden lines in top only", hidden=frozenset({_T})),
    Policy("none hidden in front", hidden=frozenset({_T, _R})),
    Policy("none hidden, not told", hidden=frozenset(), stated=False),
    Policy("two views", roles=(_F, _T)),
    Policy("two views, no hidden lines", roles=(_F, _R), hidden=frozenset()),
    Policy("four views", roles=(_F, _T, _R, _L)),
    Policy("four views, no hidden lines", roles=(_F, _T, _R, _B), hidden=frozenset()),
    Policy("left view", roles=(_F, _T, _L)),
)


def as_drawn(lines: Drawing, policy: Policy) -> dict[Role, tuple[DrawnStroke, ...]]:
    """Of all lines of a part those that a policy has."""
    return {
        role: tuple(
            item
            for item in lines[role]
            if role in policy.hidden or item.linetype is not Linetype.HIDDEN
        )
        for role in policy.roles
    }


def readings(
    drawn: Drawing, size: Size, policy: Policy
) -> tuple[ProjectedReading, ProjectedReading | None]:
    """A drawing of exact lines in third angle, as it is read; and in first angle, if not told."""
    reading = _reading(drawn, size, Projection.THIRD)
    if policy.stated:
        return reading, None
    return reading, _reading(in_first(drawn, size), size, Projection.FIRST)


def in_first(drawn: Drawing, size: Size) -> dict[Role, tuple[DrawnStroke, ...]]:
    """The views of a third-angle sheet as they are in first angle.

    The part's box starts at the origin in either, so that views from the other side are moved.
    """
    found = {}
    for role, strokes in drawn.items():
        other = IN_FIRST[role]
        moved = (
            _least(other.frame.right, size) - _least(role.frame.right, size),
            _least(other.frame.up, size) - _least(role.frame.up, size),
        )
        found[other] = tuple(stroke.mapped(Similarity(offset=moved)) for stroke in strokes)
    return found


def _least(direction: tuple[int, int, int], size: Size) -> float:
    """The least coordinate along a view's direction."""
    return sum(min(0.0, way * extent) for way, extent in zip(direction, size, strict=True))


def _reading(drawn: Drawing, size: Size, projection: Projection) -> ProjectedReading:
    """Exact lines as those of a vector file: known to a share of the longest extent."""
    pixel = EXACT_TOLERANCE * max(size) / tolerance_px(StrokesSource.VECTOR, 0.0)
    nothing = np.zeros((2, 2), bool)
    blank = Outline(nothing.astype(np.float32), (), 1, (0.0, 0.0))
    box = (0.0, 0.0, 1.0, 1.0)
    views = tuple(
        View(role, box, item, nothing, np.zeros((2, 2, 3), np.uint8), (0.0, 0.0), pixel)
        for role, item in drawn.items()
    )
    read = tuple(
        ReadView(view.role, box, view.strokes, blank, StrokesSource.VECTOR) for view in views
    )
    registered = RegisteredSheet(ViewSet(views, size), {}, read, pixel, AxisExtents({}, {}), 0)
    return ProjectedReading(registered, projection)


def same_drawing(one: Drawing, other: Drawing, extent: float) -> bool:
    """Whether two drawings have the same lines, visible and hidden ones, in each view."""
    return all(
        _same_lines(_of_kind(one[role], kind), _of_kind(other[role], kind), extent)
        for role in one
        for kind in Linetype
    )


def _of_kind(strokes: Iterable[DrawnStroke], kind: Linetype) -> list[DrawnStroke]:
    return [stroke for stroke in strokes if stroke.linetype is kind]


def _same_lines(one: list[DrawnStroke], other: list[DrawnStroke], extent: float) -> bool:
    if not one or not other:
        return not one and not other
    return _covered(one, other, extent) and _covered(other, one, extent)


def _covered(one: list[DrawnStroke], other: list[DrawnStroke], extent: float) -> bool:
    """Whether the one lines run along the other ones everywhere."""
    step = _STEP * extent
    points = np.concatenate([item.sample(step) for item in one])
    # Chords between points of a curve lie beside it by less than the step's square.
    fine = np.concatenate([item.sample(step / 8.0) for item in other])
    tree = cKDTree(fine)
    distances, nearest = tree.query(points)
    return bool((distances <= step / 16.0 + _ALIKE * extent).all() and len(nearest) > 0)
