"""The solid of the outlines' sweeps: exact where outlines say all, sound where they do not."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.axes import Axis, Role
from gaussiancad_core.drawing.brep import faces_of, soundness, volume
from gaussiancad_core.samples.modelling import box, cut, cylinder, fuse
from gaussiancad_core.solid.same import same_solid
from gaussiancad_core.solid.sweep import swept_solid
from gaussiancad_core.views import Linetype, Segment, ViewSet

Viewed = Callable[..., ViewSet]
THREE = (Role.FRONT, Role.TOP, Role.RIGHT)


def _bracket() -> TopoDS_Shape:
    """An angle with a hole through each leg: its outlines and through holes say all."""
    angle = cut(box((0, 0, 0), (40, 30, 25)), box((10, -1, 8), (41, 31, 26)))
    return cut(angle, cylinder(Axis.Z, (25, 15), 6, -1, 9), cylinder(Axis.X, (15, 17), 4, -1, 11))


def test_a_part_that_its_outlines_tell_is_exact(viewed: Viewed) -> None:
    bracket = _bracket()
    found = swept_solid(viewed(bracket), 0.02)
    assert found is not None
    facts = soundness(found)
    assert facts.valid and facts.closed and facts.solids == 1
    assert facts.faces == len(faces_of(bracket)) == 10
    assert same_solid(found, bracket)


def test_the_same_from_views_of_the_other_sides(viewed: Viewed) -> None:
    bracket = _bracket()
    found = swept_solid(viewed(bracket, (Role.REAR, Role.BOTTOM, Role.LEFT)), 0.02)
    assert found is not None and same_solid(found, bracket)


def test_blind_pockets_are_filled(viewed: Viewed) -> None:
    block = box((0, 0, 0), (40, 30, 20))
    found = swept_solid(viewed(cut(block, box((10, 8, 12), (30, 22, 21)))), 0.02)
    assert found is not None and same_solid(found, block)


def test_two_views_end_at_the_box(viewed: Viewed) -> None:
    plate = cut(box((0, 0, 0), (40, 30, 6)), cylinder(Axis.Z, (15, 15), 7, -1, 7))
    found = swept_solid(viewed(plate, (Role.FRONT, Role.TOP)), 0.02)
    assert found is not None and same_solid(found, plate)


def test_opposite_views_share_a_plane(viewed: Viewed) -> None:
    bracket = _bracket()
    found = swept_solid(viewed(bracket, (*THREE, Role.LEFT, Role.REAR)), 0.02)
    assert found is not None and same_solid(found, bracket)


def test_masks_without_lines_give_polygons(viewed: Viewed) -> None:
    boss = fuse(box((0, 0, 0), (40, 30, 6)), cylinder(Axis.Z, (20, 15), 8, 5, 18))
    found = swept_solid(viewed(boss, lines=False), 0.02)
    assert found is not None
    facts = soundness(found)
    assert facts.valid and facts.closed and facts.solids == 1
    # The boss is square: no outline shows it round.
    assert facts.volume_mm3 == pytest.approx(40 * 30 * 6 + 16 * 16 * 12, rel=0.01)


def test_a_line_that_is_missing_does_not_open_the_outline(viewed: Viewed) -> None:
    views = viewed(_bracket())
    front = views[Role.FRONT]
    longest = max((s for s in front.strokes if isinstance(s, Segment)), key=lambda s: s.length)
    rest = tuple(stroke for stroke in front.strokes if stroke is not longest)
    torn = replace(front, strokes=rest)
    found = swept_solid(ViewSet((torn, *views.views[1:]), views.size), 0.02)
    assert found is not None and soundness(found).valid
    assert volume(found) == pytest.approx(volume(_bracket()), rel=0.005)


def test_a_line_through_everything_changes_nothing(viewed: Viewed) -> None:
    views = viewed(_bracket())
    front = views[Role.FRONT]
    spurious = Segment((0.0, 3.0), (40.0, 22.0), Linetype.VISIBLE)
    crossed = replace(front, strokes=(*front.strokes, spurious))
    found = swept_solid(ViewSet((crossed, *views.views[1:]), views.size), 0.02)
    assert found is not None and same_solid(found, _bracket())


def test_scribbles_without_end_leave_the_masks_contours(viewed: Viewed) -> None:
    views = viewed(_bracket())
    front = views[Role.FRONT]
    scribbles = tuple(
        Segment((0.07 * k, 25.0), (40.0 - 0.05 * k, 0.0), Linetype.VISIBLE) for k in range(520)
    )
    scribbled = replace(front, strokes=(*front.strokes, *scribbles))
    found = swept_solid(ViewSet((scribbled, *views.views[1:]), views.size), 0.02)
    assert found is not None
    facts = soundness(found)
    assert facts.valid and facts.closed and facts.solids == 1
    assert facts.volume_mm3 == pytest.approx(volume(_bracket()), rel=0.01)


def test_views_whose_outlines_no_solid_fills_have_none(viewed: Viewed) -> None:
    whole = box((0, 0, 0), (40, 30, 25))
    # The angle's upright leg must lie where the top shows nothing but a rim, and the right side
    # shows nothing upright on that rim.
    angle = cut(whole, box((10, -1, 8), (41, 31, 26)))
    rim = cut(whole, box((-1, 3, -1), (10, 31, 26)))
    step = cut(whole, box((-1, -1, 8), (41, 3, 26)))
    views = tuple(
        viewed(shape)[role] for shape, role in zip((angle, rim, step), THREE, strict=True)
    )
    assert swept_solid(ViewSet(views, (40.0, 30.0, 25.0)), 0.02) is None
