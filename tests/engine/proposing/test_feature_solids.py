"""Solids of planned features: arcs for chords, and what the kernel is not believed."""

from collections.abc import Sequence

import pytest

from gaussiancad_core.coordinates.agreed_places import find_places
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import bounding_box, soundness, volume
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.proposing import feature_solids
from gaussiancad_core.proposing.edge_on_surfaces import SurfaceKind
from gaussiancad_core.proposing.feature_kernels import Operation
from gaussiancad_core.proposing.feature_solids import solid_of
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet, plane_sheet
from gaussiancad_core.proposing.loop_places import prism
from gaussiancad_core.proposing.loop_shapes import loops_of
from gaussiancad_core.proposing.plane_loops import Loop, LoopKind, PlaneLoops, plane_loops
from sample_parts.modelling import box


def _line(start: tuple[float, float], end: tuple[float, float]) -> Segment:
    return Segment(start, end, Linetype.VISIBLE)


def _front(
    strokes: Sequence[Segment | Arc], width: float, height: float
) -> tuple[PlaneSheet, PlaneLoops]:
    size = width, 10.0, height
    views = DrawnViews({Role.FRONT: tuple(strokes)}, size, 0.02)
    sheet = plane_sheet(views, find_places(views, views.tolerance))
    plane = plane_loops(sheet, Axis.Y)
    assert plane is not None
    return sheet, plane


def _disc_with_a_lug() -> tuple[PlaneSheet, PlaneLoops]:
    """A whole circle, and lines that touch it and go on to an end."""
    return _front(
        [
            Arc((17.5, 17.5), 17.5, 0.0, 6.2831853, Linetype.VISIBLE),
            _line((17.5, 0.0), (52.5, 0.0)),
            _line((17.5, 35.0), (52.5, 35.0)),
            _line((52.5, 0.0), (52.5, 35.0)),
        ],
        52.5,
        35.0,
    )


def _disc(sheet: PlaneSheet, plane: PlaneLoops) -> Loop:
    return next(
        loop
        for loop in loops_of(sheet, plane)
        if loop.polygon.bounds == pytest.approx((0.0, 0.0, 35.0, 35.0), abs=0.02)
        and loop.kind is not LoopKind.OUTLINE
    )


def test_a_line_that_touches_a_circle_takes_none_of_its_chords() -> None:
    sheet, plane = _disc_with_a_lug()
    disc = _disc(sheet, plane)
    kinds = {sheet.surfaces[int(number)].kind for number in disc.surfaces}
    assert kinds == {SurfaceKind.CYLINDER}
    made = solid_of([(Operation.ADD, prism(sheet, disc, 0.0, 10.0))], sheet, 0.0, lambda _: 0.0)
    assert made is not None
    assert bounding_box(made)[1].tolist() == pytest.approx([35.0, 10.0, 35.0], abs=1e-6)
    assert soundness(made).faces == 3


def test_most_of_a_circle_is_that_circle_s_arc() -> None:
    # Its ends are a hundredth of its width apart: they hardly tell where it is.
    sheet, plane = _front(
        [
            Arc((20.0, 20.0), 20.0, -1.5607963, 6.2631853, Linetype.VISIBLE),
            _line((19.8, 0.001), (20.2, 0.001)),
        ],
        40.0,
        40.0,
    )
    (outline,) = (each for each in loops_of(sheet, plane) if each.kind is LoopKind.OUTLINE)
    made = solid_of([(Operation.ADD, prism(sheet, outline, 0.0, 10.0))], sheet, 0.0, lambda _: 0.0)
    assert made is not None
    low, high = bounding_box(made)
    assert low.tolist() == pytest.approx([0.0, 0.0, 0.0], abs=0.02)
    assert high.tolist() == pytest.approx([40.0, 10.0, 40.0], abs=0.02)


def test_levels_move_no_corner_between_chords() -> None:
    # A level a hundredth beside the circle's extreme: its chords stay on the circle.
    sheet, plane = _disc_with_a_lug()
    disc = _disc(sheet, plane)
    away = [((x - 17.5) ** 2 + (z - 17.5) ** 2) ** 0.5 for x, z in disc.edges[:, :2]]
    assert away == pytest.approx([17.5] * len(away), abs=0.02)


def test_a_volume_that_does_not_add_up_is_not_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    sheet, plane = _disc_with_a_lug()
    disc = prism(sheet, _disc(sheet, plane), 0.0, 10.0)
    whole = box((0.0, 0.0, 0.0), (52.5, 10.0, 35.0))
    (outline,) = (each for each in loops_of(sheet, plane) if each.kind is LoopKind.OUTLINE)
    plate = prism(sheet, outline, 0.0, 10.0)
    tried = []

    def wrong_at_first(shape, operation, tools, near):  # type: ignore[no-untyped-def]  # noqa: ANN001, ANN202
        tried.append(near)
        return whole if near == 0.0 else real(shape, operation, tools, near)

    real = feature_solids._after
    monkeypatch.setattr(feature_solids, "_after", wrong_at_first)
    expected = plate.volume - disc.volume
    features = [(Operation.ADD, plate), (Operation.CUT, disc)]
    made = solid_of(features, sheet, 0.0, lambda shape: abs(volume(shape) - expected))
    assert made is not None
    assert volume(made) == pytest.approx(expected, rel=5e-3)
    assert len(set(tried)) == 2
