"""Cut views: what is removed, what is hatched, where the hatching lies."""

from dataclasses import replace

import numpy as np
import pytest
import shapely

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS, parse_style
from gaussiancad_core.errors import UsageError
from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.lines.cut_solids import SectionView, openings_of, section_view
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.model.views import Linetype
from sample_parts import sample

# A block of 80 x 44 x 28 with two holes of diameter 12 that are bored to 22 down to 10.
PART = "counterbored-block"
_KINDS = (SectionKind.FULL, SectionKind.HALF, SectionKind.BROKEN_OUT)


@pytest.fixture(scope="module")
def solid():  # noqa: ANN201
    return sample(PART).build()


def _cut(solid, kind: SectionKind) -> SectionView:  # noqa: ANN001
    return section_view(solid, Role.FRONT, openings_of(solid, Role.FRONT, kind))


def test_a_full_section_is_the_part_without_its_holes(solid) -> None:  # noqa: ANN001
    cut = _cut(solid, SectionKind.FULL)
    x0, y0, x1, y1 = cut.areas.bounds
    assert (x1 - x0) * (y1 - y0) == pytest.approx(80 * 28, rel=1e-6)
    assert cut.areas.area == pytest.approx(80 * 28 - 2 * (22 * 10 + 12 * 18), rel=1e-6)
    assert {stroke.linetype for stroke in cut.strokes} == {Linetype.VISIBLE}
    assert bounds(cut.strokes) == pytest.approx((0, 0, 80, 28))


def test_half_a_section_is_hatched_on_one_side_and_a_broken_out_one_in_a_corner(solid) -> None:  # noqa: ANN001
    full, half, part = (_cut(solid, kind) for kind in _KINDS)
    assert half.areas.area == pytest.approx(full.areas.area / 2, rel=1e-6)
    assert half.areas.bounds[0] == pytest.approx(40.0)
    assert bounds(half.strokes) == pytest.approx((0, 0, 80, 28))
    assert 0.1 < part.areas.area / full.areas.area < 0.35
    assert full.areas.buffer(1e-6).covers(part.areas)


@pytest.mark.parametrize("degrees", [45.0, 135.0, 30.0])
def test_hatching_fills_the_area_at_one_pitch(solid, degrees: float) -> None:  # noqa: ANN001
    cut = _cut(solid, SectionKind.FULL)
    lines = cut.hatching(2.0, degrees)
    way = np.radians(degrees)
    normal = np.array([-np.sin(way), np.cos(way)])
    for line in lines:
        assert cut.areas.buffer(1e-6).covers(shapely.LineString([line.start, line.end]))
        assert np.subtract(line.end, line.start) @ normal == pytest.approx(0.0, abs=1e-9)
    offsets = np.unique(np.round([np.array(line.start) @ normal for line in lines], 6))
    assert np.diff(offsets) == pytest.approx(2.0)
    # Their length times their distance is the area.
    assert 2.0 * sum(line.length for line in lines) == pytest.approx(cut.areas.area, rel=0.03)


def test_a_style_cuts_the_view_that_it_names(solid) -> None:  # noqa: ANN001
    style = parse_style("clean,section=front,section-kind=half,hatch-pitch=20")
    roles = (Role.FRONT, Role.TOP)
    drawn = draw_sheet(solid, roles, Projection.THIRD, style)
    plain = draw_sheet(solid, roles, Projection.THIRD, replace(style, section=None))
    (hatching,) = drawn.annotations
    assert hatching.kind is AnnotationKind.HATCHING
    assert hatching.width == PRESETS["clean"].annotation_width
    assert plain.annotations == ()
    assert drawn[Role.FRONT].box == pytest.approx(plain[Role.FRONT].box)
    assert drawn[Role.TOP] == plain[Role.TOP]
    x0, _, x1, _ = hatching.box
    assert x0 >= 0.5 * (drawn[Role.FRONT].box[0] + x1) - 0.01


def test_a_section_of_a_view_that_is_not_drawn_is_refused(solid) -> None:  # noqa: ANN001
    style = parse_style("clean,section=right")
    with pytest.raises(UsageError, match="section=right"):
        draw_sheet(solid, (Role.FRONT, Role.TOP), Projection.THIRD, style)


def test_hidden_lines_can_be_left_out(solid) -> None:  # noqa: ANN001
    roles = (Role.FRONT, Role.TOP, Role.RIGHT)
    style = parse_style("clean,hidden=off")
    drawn = draw_sheet(solid, roles, Projection.THIRD, style)
    whole = draw_sheet(solid, roles, Projection.THIRD, parse_style("clean"))
    for role in roles:
        visible = [stroke for stroke in whole[role].strokes if stroke.linetype is Linetype.VISIBLE]
        assert list(drawn[role].strokes) == visible
    assert any(len(drawn[role].strokes) < len(whole[role].strokes) for role in roles)
