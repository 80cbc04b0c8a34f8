"""Sections that stand beside a plain view of the same direction."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.hatched_areas import cut_open
from gaussiancad_core.sheet.special_views.view_kinds import SECTIONS, SpecialView
from gaussiancad_core.sheet.views.sheet_layout import Layout, alignment_tolerance

Read = Callable[[Layout], tuple[ReadView, ...]]
"""Reads the views of a layout."""


def adjacent_sections_of(
    layout: Layout,
    named: Sequence[tuple[Box, Role | None]],
    hatched: Mask | None,
    read: Read,
) -> tuple[Layout, tuple[ReadView, ...]]:
    """The sections of a sheet that stand for no view, and the layout with these as used.

    A section belongs to the direction that its arrows tell, and else to the only one along which
    the part is as wide and high.

    Args:
        layout: of the views.
        named: boxes of sections with titles, and the role that the arrows of each tell, if any.
        hatched: (h, w) of the upright sheet; None where nothing is.
        read: strokes.
    """
    if hatched is None:
        return layout, ()
    special: list[SpecialView] = []
    found: list[ReadView] = []
    for special_view in layout.special:
        role = None
        if special_view.kind in SECTIONS and not special_view.used:
            looks = next((looks for box, looks in named if overlap(box, special_view.box)), None)
            role = _role_of(special_view.box, looks, layout)
        if role is None:
            special.append(special_view)
            continue
        (view,) = read(replace(layout, boxes={role: special_view.box}))
        found.append(cut_open(view, special_view, hatched))
        special.append(replace(special_view, used=True, adjacent=True))
    return replace(layout, special=tuple(special)), tuple(found)


def _role_of(box: Box, looks: Role | None, layout: Layout) -> Role | None:
    extents = _extents(layout)
    wide, high = box[2] - box[0], box[3] - box[1]
    fitting = [
        role
        for role in Role
        if _same(extents.get(role.frame.right_axis[0]), wide)
        and _same(extents.get(role.frame.up_axis[0]), high)
    ]
    if looks is not None:
        return looks if looks in fitting else None
    if len({role.frame.look_axis[0] for role in fitting}) != 1:
        return None
    return next((role for role in fitting if role in layout.boxes), fitting[0])


def _extents(layout: Layout) -> dict[Axis, float]:
    """px of the part along each axis that a view shows."""
    found: dict[Axis, float] = {}
    for role, (x0, y0, x1, y1) in layout.boxes.items():
        found.setdefault(role.frame.right_axis[0], x1 - x0)
        found.setdefault(role.frame.up_axis[0], y1 - y0)
    return found


def _same(one: float | None, other: float) -> bool:
    return one is not None and abs(one - other) <= alignment_tolerance(max(one, other))


def overlap(one: Box, other: Box) -> bool:
    """Whether two boxes have some area in common."""
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
