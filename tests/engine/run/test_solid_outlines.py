"""Masks that an open outline spoils are filled by the exact solid, others stay as they are."""

from collections.abc import Callable
from dataclasses import replace

import cv2
import numpy as np
import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import views_as_read
from gaussiancad_core.hull.space_carving import carved_hull
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.cameras import orthographic_camera
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.run.solid_outlines import PlacedInk, with_solid_outlines
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.registration.view_registration import Placement
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.verify import verify
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import box, cut, cylinder

Viewed = Callable[..., ViewSet]
PLATE = cut(
    box((0, 0, 0), (40, 30, 20)),
    cylinder(Axis.Z, (12, 15), 6, -1, 21),
    box((24, 8, 12), (36, 22, 21)),
)


def _result(views: ViewSet, shape: TopoDS_Shape | None, status: Status) -> ExactResult:
    verification = verify(shape, views_as_read(views, 0.02)) if shape is not None else None
    return ExactResult(status, shape, verification, (), (), {})


def _broken(views: ViewSet) -> ViewSet:
    """The views of a sheet whose top view lost its outline, but for what the hole encloses."""
    top = views[Role.TOP]
    hole = np.zeros_like(top.mask)
    rows, columns = hole.shape
    hole[rows // 3 : rows // 2, columns // 5 : columns // 3] = True
    spoilt = replace(top, mask=hole)
    return replace(views, views=tuple(spoilt if v is top else v for v in views.views))


def test_an_outline_that_is_open_becomes_that_of_the_solid(viewed: Viewed) -> None:
    views = viewed(PLATE)
    found = with_solid_outlines(_broken(views), _result(views, PLATE, Status.VERIFIED))
    assert found.closed == (Role.TOP,)
    mask, drawn = found.views[Role.TOP].mask, views[Role.TOP].mask
    assert (mask ^ drawn).sum() <= 0.01 * drawn.sum()
    cameras = tuple(orthographic_camera(role, views.size, 64) for role in views.roles)
    hull = carved_hull(found.views, cameras, _result(views, PLATE, Status.VERIFIED))
    assert hull.mesh.volume == pytest.approx(volume(PLATE), rel=0.01)


def test_outlines_that_are_whole_stay_as_the_sheet_has_them(viewed: Viewed) -> None:
    views = viewed(PLATE)
    found = with_solid_outlines(views, _result(views, PLATE, Status.VERIFIED))
    assert found.closed == ()
    assert all(view is given for view, given in zip(found.views.views, views.views, strict=True))


def test_a_solid_with_other_lines_than_the_sheet_knows_no_better(viewed: Viewed) -> None:
    views = viewed(PLATE)
    other = cut(PLATE, box((-1, -1, 10), (5, 31, 21)))
    for result in (None, _result(views, None, Status.FAILED), _result(views, other, Status.FAILED)):
        found = with_solid_outlines(_broken(views), result)
        assert found.closed == ()


def _inked(views: ViewSet, *, without: Role | None = None) -> PlacedInk:
    """A sheet on which the outlines of views are drawn, one beside the other."""
    border, x, placements = 10, 10, {}
    height = max(view.mask.shape[0] for view in views.views) + 2 * border
    width = sum(view.mask.shape[1] + border for view in views.views) + border
    ink = np.zeros((height, width), np.uint8)
    for view in views.views:
        rows, columns = view.mask.shape
        (left, top), pitch = view.origin, view.mm_per_pixel
        placements[view.role] = Placement(
            view.role,
            (x, border, x + columns, border + rows),
            (left, left + columns * pitch),
            (top - rows * pitch, top),
        )
        if view.role is not without:
            contours, _ = cv2.findContours(
                view.mask.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE
            )
            cv2.drawContours(ink, contours, -1, 1, 3, offset=(x, border))
        x += columns + border
    weight = ink.astype(np.float32)
    sheet = CleanSheet(ink > 0, weight, 3.0, Turn(0.0, (0.0, 0.0)))
    return PlacedInk(sheet, placements)


def test_an_outline_along_ink_counts_though_other_lines_do_not_agree(viewed: Viewed) -> None:
    views = viewed(PLATE)
    other = cut(PLATE, box((-1, -1, 10), (5, 31, 21)))
    result = _result(views, other, Status.FAILED)
    assert not result.explains
    found = with_solid_outlines(_broken(views), result, _inked(views))
    # Its front view is another one.
    assert found.closed == (Role.TOP,)
    mask, drawn = found.views[Role.TOP].mask, views[Role.TOP].mask
    assert (mask ^ drawn).sum() <= 0.01 * drawn.sum()
    bare = with_solid_outlines(_broken(views), result, _inked(views, without=Role.TOP))
    assert bare.closed == ()
