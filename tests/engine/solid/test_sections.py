"""Full sections with a known plane: what they show in place of a plain view."""

from collections.abc import Callable
from dataclasses import replace

import pytest
import shapely
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.lines.cut_solids import section_view
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.section_planes import Cut, CutRegion, SectionRole
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.solid.exact import exact_solid
from gaussiancad_core.solid.verify import verify
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import box, cut, cylinder

Iou = Callable[[TopoDS_Shape, TopoDS_Shape], float]

_BLOCK = box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0))


def _bore(radius: float, low: float, high: float) -> TopoDS_Shape:
    return cylinder(Axis.Z, (30.0, 20.0), radius, low, high)


_PARTS = {
    "blind bore": cut(_BLOCK, _bore(8.0, 12.0, 31.0)),
    "through bore": cut(_BLOCK, _bore(8.0, -1.0, 31.0)),
    "counterbore": cut(_BLOCK, _bore(5.0, -1.0, 31.0), _bore(10.0, 18.0, 31.0)),
}

_GROOVE = cut(_BLOCK, _bore(6.0, -1.0, 31.0), _bore(9.0, 10.0, 16.0))


def _drawn(shape: TopoDS_Shape, plain: tuple[Role, ...], section: Role) -> DrawnViews:
    """Views without hidden lines, and one through the middle that is cut."""
    low, high = bounding_box(shape)
    size = tuple(float(item) for item in high - low)
    drawing = LineDrawing(shape)
    at = size[section.frame.look_axis[0].value] / 2.0
    this_section_view = section_view(shape, section, (CutRegion(at),))
    strokes = {
        role: tuple(s for s in drawing.view(role) if s.linetype is Linetype.VISIBLE)
        for role in plain
    }
    views = exact_views({**strokes, section: this_section_view.strokes}, size)
    return replace(views, cuts={section: Cut((CutRegion(at),), this_section_view.areas)})


@pytest.mark.parametrize("section", [Role.FRONT, Role.RIGHT, Role.LEFT])
@pytest.mark.parametrize("name", _PARTS)
def test_a_plan_and_a_section_tell_a_bore(name: str, section: Role, iou: Iou) -> None:
    part = _PARTS[name]
    found = exact_solid(_drawn(part, (Role.TOP,), section))
    assert found.shape is not None
    assert found.explains
    assert found.status is Status.APPROXIMATE
    assert iou(found.shape, part) == pytest.approx(1.0, abs=1e-6)


def test_a_groove_that_the_section_shows_runs_all_around(iou: Iou) -> None:
    found = exact_solid(_drawn(_GROOVE, (Role.TOP,), Role.FRONT))
    assert found.shape is not None
    assert found.explains
    assert iou(found.shape, _GROOVE) == pytest.approx(1.0, abs=1e-6)


def test_a_solid_is_cut_to_be_compared() -> None:
    part = _PARTS["blind bore"]
    views = _drawn(part, (Role.TOP,), Role.FRONT)
    assert verify(part, views).explains
    # Seen from above both are one.
    other = _PARTS["through bore"]
    flaws = verify(other, views).flaws
    assert {flaw.role for flaw in flaws} == {Role.FRONT}


def test_hatching_where_nothing_is_cut_is_told() -> None:
    part = _PARTS["through bore"]
    views = _drawn(part, (Role.TOP,), Role.FRONT)
    cut_open = views.cuts[Role.FRONT]
    filled = replace(views, cuts={Role.FRONT: Cut(cut_open.openings, cut_open.areas.convex_hull)})
    (flaw,) = verify(part, filled).flaws
    assert flaw.missing
    assert flaw.role is Role.FRONT
    assert 22.0 < flaw.place[0] < 38.0


def _beside(
    shape: TopoDS_Shape, plain: tuple[Role, ...], openings: tuple[CutRegion, ...]
) -> DrawnViews:
    """Views without hidden lines, and a section beside the front view."""
    low, high = bounding_box(shape)
    size = tuple(float(item) for item in high - low)
    drawing = LineDrawing(shape)
    key = SectionRole(Role.FRONT, "A")
    this_section_view = section_view(shape, key, openings)
    strokes = {
        role: tuple(s for s in drawing.view(role) if s.linetype is Linetype.VISIBLE)
        for role in plain
    }
    views = exact_views({**strokes, key: this_section_view.strokes}, size)
    return replace(views, cuts={key: Cut(openings, this_section_view.areas)})


_OFFSET = cut(
    _BLOCK,
    cylinder(Axis.Z, (15.0, 10.0), 5.0, 12.0, 31.0),
    cylinder(Axis.Z, (45.0, 28.0), 6.0, 20.0, 31.0),
)


def test_a_section_beside_tells_what_plain_views_do_not(iou: Iou) -> None:
    part = _PARTS["blind bore"]
    views = _beside(part, (Role.FRONT, Role.TOP, Role.RIGHT), (CutRegion(20.0),))
    found = exact_solid(views)
    assert found.shape is not None
    assert found.explains
    assert iou(found.shape, part) == pytest.approx(1.0, abs=1e-6)


def test_an_offset_section_cuts_at_several_depths(iou: Iou) -> None:
    openings = (
        CutRegion(10.0, shapely.box(-1e3, -1e3, 30.0, 1e3)),
        CutRegion(28.0, shapely.box(30.0, -1e3, 1e3, 1e3)),
    )
    found = exact_solid(_beside(_OFFSET, (Role.FRONT, Role.TOP), openings))
    assert found.shape is not None
    assert found.explains
    assert iou(found.shape, _OFFSET) == pytest.approx(1.0, abs=1e-6)


def test_half_of_a_view_is_cut(iou: Iou) -> None:
    part = _PARTS["counterbore"]
    openings = (CutRegion(20.0, shapely.box(30.0, -1e3, 1e3, 1e3)),)
    this_section_view = section_view(part, Role.FRONT, openings)
    plain = _drawn(part, (Role.TOP,), Role.FRONT)
    views = replace(
        plain,
        strokes={**plain.strokes, Role.FRONT: this_section_view.strokes},
        cuts={Role.FRONT: Cut(openings, this_section_view.areas)},
    )
    found = exact_solid(views)
    assert found.shape is not None
    assert found.explains
    assert iou(found.shape, part) == pytest.approx(1.0, abs=1e-6)
