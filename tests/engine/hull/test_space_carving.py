"""The hull with its pockets: what carves it, and what it is not carved by."""

from collections.abc import Callable

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import views_as_read
from gaussiancad_core.hull.space_carving import CarvedHull, carved_hull, mesh_agreement
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.cameras import orthographic_camera, paper_camera
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.verify import verify
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import box, cut, cylinder, fuse

Viewed = Callable[..., ViewSet]
SIZE = (40.0, 30.0, 20.0)
BLOCK = box((0, 0, 0), SIZE)
POCKETED = cut(BLOCK, box((10, 8, 12), (30, 22, 21)))


def _result(
    views: ViewSet, shape: TopoDS_Shape | None, status: Status, *others: TopoDS_Shape
) -> ExactResult:
    verification = verify(shape, views_as_read(views, 0.02)) if shape is not None else None
    return ExactResult(status, shape, verification, others, (), {})


def _carved(views: ViewSet, result: ExactResult | None) -> CarvedHull:
    cameras = tuple(orthographic_camera(role, views.size, 64) for role in views.roles)
    return carved_hull(views, cameras, result)


def test_a_verified_solid_gives_the_hull_its_pockets_on_all_sides(viewed: Viewed) -> None:
    part = cut(
        POCKETED,
        box((4, 4, -1), (14, 26, 5)),
        cylinder(Axis.Y, (34, 10), 4, 22, 31),
        box((-1, 10, 6), (5, 20, 14)),
    )
    views = viewed(part)
    found = _carved(views, _result(views, part, Status.VERIFIED))
    assert (found.source, found.doubted, found.refused) == (Status.VERIFIED, 0, "")
    assert found.regions >= 4
    assert found.mesh.watertight
    assert found.mesh.volume == pytest.approx(volume(part), rel=0.005)


def test_a_boss_becomes_round(viewed: Viewed) -> None:
    boss = fuse(box((0, 0, 0), (40, 30, 6)), cylinder(Axis.Z, (20, 15), 8, 5, 20))
    views = viewed(boss)
    found = _carved(views, _result(views, boss, Status.VERIFIED))
    assert found.mesh.watertight
    assert found.mesh.volume == pytest.approx(volume(boss), rel=0.01)


def test_without_a_solid_the_hull_is_as_it_was(viewed: Viewed) -> None:
    views = viewed(POCKETED)
    for result in (None, _result(views, None, Status.FAILED)):
        found = _carved(views, result)
        assert (found.source, found.regions) == (None, 0)
        assert found.mesh.volume == pytest.approx(volume(BLOCK), rel=1e-3)


def test_a_solid_that_has_no_more_than_the_outlines_carves_nothing(viewed: Viewed) -> None:
    views = viewed(BLOCK)
    found = _carved(views, _result(views, BLOCK, Status.VERIFIED))
    assert (found.source, found.regions, found.doubted) == (None, 0, 0)


def test_the_cameras_of_the_paper_keep_the_plain_hull(viewed: Viewed) -> None:
    views = viewed(POCKETED)
    cameras = tuple(paper_camera(role, views.size) for role in views.roles)
    found = carved_hull(views, cameras, _result(views, POCKETED, Status.VERIFIED))
    assert found.source is None


def test_of_two_solids_only_what_both_leave_empty_is_carved(viewed: Viewed) -> None:
    views = viewed(POCKETED)
    deeper = cut(BLOCK, box((10, 8, 4), (30, 22, 21)))
    found = _carved(views, _result(views, POCKETED, Status.APPROXIMATE, deeper))
    assert found.source is Status.APPROXIMATE
    assert found.mesh.volume == pytest.approx(volume(POCKETED), rel=0.005)


def test_a_pocket_that_the_sheet_lacks_is_not_carved(viewed: Viewed) -> None:
    views = viewed(POCKETED)
    invented = cut(POCKETED, box((32, 4, 10), (38, 26, 21)))
    found = _carved(views, _result(views, invented, Status.APPROXIMATE))
    assert found.doubted >= 1
    assert found.mesh.volume == pytest.approx(volume(POCKETED), rel=0.005)


def test_a_carved_hull_that_lost_its_outline_is_dropped(viewed: Viewed) -> None:
    angle = cut(BLOCK, box((10, -1, 8), (41, 31, 21)))
    lower = cut(angle, box((-1, -1, 14), (11, 31, 21)))
    views = viewed(angle)
    found = _carved(views, _result(views, lower, Status.VERIFIED))
    assert (found.source, found.regions, found.refused) == (None, 0, "outline-lost")
    assert found.mesh.volume == pytest.approx(volume(angle), rel=2e-3)


def test_a_hull_agrees_better_with_the_lines_once_it_has_its_pocket(viewed: Viewed) -> None:
    views = viewed(POCKETED)
    plain = _carved(views, None)
    carved = _carved(views, _result(views, POCKETED, Status.VERIFIED))
    assert mesh_agreement(plain.mesh, views) < 0.9
    assert mesh_agreement(carved.mesh, views) > 0.97
