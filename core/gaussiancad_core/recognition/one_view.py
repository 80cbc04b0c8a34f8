"""Sheets of one view: a plate by its thickness, a turned part by its diameters.

What the view does not show is how far the part reaches along the axis that it looks along.  A
thickness tells it, or that the part is turned.  What the part is then tells the sketch
(:mod:`gaussiancad_core.sketch`).
"""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.near_points import pairs_between
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.report.run_notes import RunNotes
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.writing.callouts import NoteKind
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.note_texts import SheetNote
from gaussiancad_core.writing.numbers import Sign
from gaussiancad_core.writing.sheet_scale import SheetScale
from gaussiancad_protocol.codes import Code

_ALIKE = 0.97
"""Share of a view that its mirror image has, if it is a turned part's: of its lines, or, of a half
section, of what its outline encloses."""

_NEAR_PX = 1.5
"""px between points along lines; those within two of these are one."""

_PLATE = Message(
    "the sheet has one view and a thickness: that all of the part is as thick, and that what is "
    "drawn inside goes through, was assumed",
    case="plate",
)
_TURNED = Message(
    "the sheet has one view, alike on both sides of its axis, with diameters: a turned part was "
    "assumed; if it is none, another view is needed",
    case="turned",
)


def shown_extents(drawn: Sequence[ReadView]) -> dict[Axis, float]:
    """px of the part along each axis that views show, of the first view that shows it."""
    extents: dict[Axis, float] = {}
    for view in drawn:
        x0, y0, x1, y1 = view.box
        extents.setdefault(view.role.frame.right_axis[0], x1 - x0)
        extents.setdefault(view.role.frame.up_axis[0], y1 - y0)
    return extents


def unseen_extent_of(
    drawn: Sequence[ReadView],
    scale: SheetScale | None,
    notes: Sequence[SheetNote],
    options: ReadingOptions,
    run: RunNotes,
) -> Unseen | None:
    """What is known of the axis that the only view of a sheet does not show; None of more views.

    Args:
        drawn: the views.
        scale: of the sheet, with its dimensions; None where nobody asked.
        notes: of the sheet.
        options: what the user says, with the scale that is taken.
        run: told what is assumed.

    Raises:
        NoModelError: ``one-view`` where nothing tells it, with the axis; its case is ``scale``
            where the thickness is known, and the size of what the view shows is not.
    """
    if len(drawn) != 1:
        return None
    (view,) = drawn
    axis = view.role.frame.look_axis[0]
    about = _turned_about(view, scale) if scale is not None else None
    thickness = _thickness(axis, notes, options)
    if about is not None and options.length_along(axis) is None:
        run.doubt(Code.SECOND_VIEW_ASSUMED, _TURNED)
        return Unseen(axis, about=about)
    if thickness is not None and _is_scaled(axis, options):
        run.doubt(Code.SECOND_VIEW_ASSUMED, _PLATE)
        return Unseen(axis, thickness)
    if thickness is not None:
        raise NoModelError(
            Code.ONE_VIEW,
            "the sheet has one view and a thickness, and nothing tells its scale: pass --length "
            "AXIS=MM along an axis that the view shows, or --mm-per-pixel",
            boxes=[view.box],
            axis=axis.name.lower(),
            case="scale",
        )
    raise NoModelError(
        Code.ONE_VIEW,
        "only one view was found, at {places} px, and neither diameters across an axis nor a "
        "thickness give the part: a model needs two orthogonal views or more, or --length "
        "{axis}=MM for its thickness",
        boxes=[view.box],
        axis=axis.name.lower(),
        places="({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*view.box),
    )


def _thickness(axis: Axis, notes: Sequence[SheetNote], options: ReadingOptions) -> float | None:
    """mm that the user says, else a note."""
    if said := options.length_along(axis):
        return said
    noted = (note.value_mm for note in notes if note.callout.kind is NoteKind.THICKNESS)
    return next((value for value in noted if value), None)


def _is_scaled(axis: Axis, options: ReadingOptions) -> bool:
    """Whether anything tells the scale of what the view shows."""
    shown = [this_axis for this_axis in Axis if this_axis is not axis]
    return options.scaling_length(shown) is not None or options.mm_per_pixel is not None


def _turned_about(view: ReadView, scale: SheetScale) -> Axis | None:
    """The axis of the view that a diameter is written across (ISO 129-1), if the view is alike on
    both sides of it."""
    frame = view.role.frame
    for across, axis in ((1, frame.right_axis[0]), (0, frame.up_axis[0])):
        if _has_diameter(scale, across) and _is_alike(view, across):
            return axis
    return None


def _has_diameter(scale: SheetScale, across: int) -> bool:
    """Whether a diameter is written at a width along a coordinate of the sheet."""
    return any(
        dimension.sign is Sign.DIAMETER
        and isinstance(dimension.place, Span)
        and dimension.place.level is (across == 0)
        for dimension in scale.dimensions
    )


def _is_alike(view: ReadView, across: int) -> bool:
    """Whether a view is its own image, mirrored along a coordinate of the sheet."""
    if view.opened and view.outline is not None:
        # A half section shows something else on either side.
        mask = view.outline.mask
        rows, columns = np.nonzero(mask)
        inside = mask[rows.min() : rows.max() + 1, columns.min() : columns.max() + 1]
        image = np.flip(inside, axis=1 - across)
        return bool((inside & image).sum() >= _ALIKE * (inside | image).sum())
    points = np.concatenate([stroke.sample(_NEAR_PX) for stroke in view.strokes])
    images = points.copy()
    images[:, across] = view.box[across] + view.box[across + 2] - images[:, across]
    met = np.unique(pairs_between(images, points, 2.0 * _NEAR_PX)[:, 0])
    return len(met) >= _ALIKE * len(images)
