"""From strokes to views in millimetres: extents, scales, masks, through holes."""

from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.evidence.section_evidence import cuts_of
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet, upright_sheet
from gaussiancad_core.sheet.image.colouring import coloured
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import read_views, register_views
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.writing.section_titles import NamedSection, Trace
from gaussiancad_core.writing.titles import Title, TitleKind

THROUGH_HOLES = {
    "l-bracket": 2,
    "bored-plate": 5,
    "three-axis-block": 3,
    "u-bracket": 2,
    "counterbored-block": 2,
    "boss-plate": 3,
    "pulley": 1,
    "pocket-block": 0,
    "stepped-block": 0,
    "vee-block": 0,
}


@pytest.mark.parametrize(("name", "holes"), THROUGH_HOLES.items())
def test_exactly_the_through_holes_are_opened(read, name: str, holes: int) -> None:  # noqa: ANN001
    assert read(name).registered.opened == holes


def test_the_longest_edge_is_100_mm_where_no_one_tells(read) -> None:  # noqa: ANN001
    registered = read("l-bracket").registered
    assert registered.views.size == pytest.approx((100.0, 62.5, 75.0), abs=0.02)


def test_a_length_or_a_scale_sets_the_size(read) -> None:  # noqa: ANN001
    case = read("l-bracket")
    by_length = register_views(case.views, ReadingOptions(lengths=((Axis.Z, 60.0),)))
    assert by_length.views.size == pytest.approx((80.0, 50.0, 60.0), abs=0.02)
    scale = ReadingOptions(mm_per_pixel=case.drawn.mm_per_pixel)
    assert register_views(case.views, scale).views.size == pytest.approx((80, 50, 60), abs=0.02)


def test_masks_have_the_area_of_the_silhouettes(read) -> None:  # noqa: ANN001
    options = ReadingOptions(lengths=((Axis.X, 80.0),))
    views = register_views(read("l-bracket").views, options).views
    areas = {view.role: view.mask.sum() * view.mm_per_pixel**2 for view in views.views}
    assert areas[Role.FRONT] == pytest.approx(80 * 12 + 14 * 48, rel=0.005)
    assert areas[Role.TOP] == pytest.approx(80 * 50 - np.pi * 10**2, rel=0.005)
    assert areas[Role.RIGHT] == pytest.approx(50 * 60 - np.pi * 7**2, rel=0.005)


def test_filled_masks_have_no_holes(read) -> None:  # noqa: ANN001
    registered = register_views(read("l-bracket").views, ReadingOptions(open_holes=False))
    top = registered.views[Role.TOP]
    assert registered.opened == 0
    assert top.mask.sum() * top.mm_per_pixel**2 == pytest.approx(100 * 62.5, rel=0.005)


def test_strokes_lie_on_the_part_in_millimetres(read) -> None:  # noqa: ANN001
    options = ReadingOptions(lengths=((Axis.X, 80.0),))
    case = read("l-bracket", "clean", "front,bottom,left")
    views = register_views(case.views, options).views
    left = np.concatenate([s.sample(1.0) for s in views[Role.LEFT].strokes])
    # The left view's right is -Y: its plane runs from -50 to 0.
    assert left.min(0) == pytest.approx([-50, 0], abs=0.05)
    assert left.max(0) == pytest.approx([0, 60], abs=0.05)
    bottom = np.concatenate([s.sample(1.0) for s in views[Role.BOTTOM].strokes])
    assert bottom.min(0) == pytest.approx([0, -50], abs=0.05)


def test_colour_is_inside_the_mask_only(read) -> None:  # noqa: ANN001
    views = register_views(read("l-bracket").views, ReadingOptions()).views
    for view in coloured(views, (10, 200, 30)).views:
        assert (view.colour[~view.mask] == 255).all()
        inside = view.colour[view.mask]
        assert (inside == (10, 200, 30)).all(axis=1).mean() > 0.8


def test_views_that_contradict_each_other_make_no_model(read) -> None:  # noqa: ANN001
    views = read("l-bracket").views
    x0, y0, x1, y1 = views[0].box
    stretched = replace(views[0], box=(x0, y0, x1, y1 + 0.2 * (y1 - y0)))
    with pytest.raises(NoModelError, match="along Z") as caught:
        register_views((stretched, *views[1:]), ReadingOptions())
    assert caught.value.code == "views-contradict"


def test_small_disagreement_is_averaged(read) -> None:  # noqa: ANN001
    views = read("l-bracket").views
    x0, y0, x1, y1 = views[0].box
    stretched = replace(views[0], box=(x0, y0, x1, y1 + 6.0))
    registered = register_views((stretched, *views[1:]), ReadingOptions())
    assert registered.extents.disagreeing == (Axis.Z,)
    assert registered.extents.spread[Axis.Z] == pytest.approx(6.0, abs=0.1)
    assert registered.extents.extents[Axis.Z] == pytest.approx(y1 - y0 + 3.0, abs=0.1)


def test_an_outline_with_a_gap_is_taken_to_be_straight_there(read) -> None:  # noqa: ANN001
    views = read("l-bracket").views
    whole = register_views(views, ReadingOptions())
    assert not whole.gaps
    longest = max(views[0].strokes, key=lambda stroke: np.ptp(stroke.sample(1.0), axis=0).max())
    less = tuple(stroke for stroke in views[0].strokes if stroke is not longest)
    gap = replace(views[0], strokes=less, outline=None)
    found = register_views((gap, *views[1:]), ReadingOptions())
    assert [view.role for view in found.gaps] == [views[0].role]
    assert found.views.size == pytest.approx(whole.views.size, rel=0.01)
    filled, mask = (each.views.views[0].mask for each in (found, whole))
    assert filled.mean() == pytest.approx(mask.mean(), abs=0.3)
    assert filled[mask].mean() > 0.95


def test_a_view_whose_strokes_enclose_nothing_is_refused(read) -> None:  # noqa: ANN001
    views = read("l-bracket").views
    x0, y0, x1, y1 = views[0].box
    diagonal = Segment((x0, y0), (x1, y1), Linetype.VISIBLE)
    for strokes in ((), (diagonal,)):
        nothing = replace(views[0], strokes=strokes, outline=None)
        with pytest.raises(NoModelError, match="encloses nothing") as caught:
            register_views((nothing, *views[1:]), ReadingOptions())
        assert caught.value.code == "open-outline"


def test_a_cutting_line_whose_steps_are_not_known_tells_no_plane(read) -> None:  # noqa: ANN001
    front, top, *rest = read("l-bracket").views
    x0, y0, x1, y1 = front.box
    hatched = replace(front, hatched=(((x0, y0), (x1, y0), (x1, y1), (x0, y1)),))
    registered = register_views((hatched, top, *rest), ReadingOptions())
    a0, b0, a1, b1 = top.box
    ends = (a0, (b0 + b1) / 2.0), (a1, (b0 + b1) / 2.0)
    stepped = NamedSection(Title(TitleKind.SECTION, "A"), front.box, Trace("A", ends, (0.0, -1.0)))
    (cut,), (assumed,) = (
        cuts_of(registered, sections)[Role.FRONT].openings for sections in ([stepped], [])
    )
    assert (cut.at, cut.source) == (assumed.at, assumed.source)


def test_a_view_that_is_one_line_is_told_by_place() -> None:
    # Two edges nearer to each other than the pen is wide.
    grey = np.full((300, 300), 255, np.uint8)
    grey[60:240, 140:147] = 0
    clean = upright_sheet(clean_sheet(grey, 0))
    layout = Layout({Role.FRONT: (136.0, 56.0, 151.0, 244.0)}, Projection.THIRD, "given", (), ())
    with pytest.raises(NoModelError) as error:
        register_views(read_views(clean, layout), ReadingOptions())
    assert error.value.code == "open-outline"
    assert "front view at (144, 60)-(144, 240) px encloses nothing" in str(error.value)


@pytest.mark.parametrize("role", [Role.FRONT, Role.TOP])
def test_a_view_alone_is_as_deep_as_is_known(read, role: Role) -> None:  # noqa: ANN001
    (view,) = (this_view for this_view in read("bored-plate").views if this_view.role is role)
    x0, _, x1, _ = view.box
    axis = role.frame.look_axis[0]
    along, up = role.frame.right_axis[0], role.frame.up_axis[0]
    plate = register_views((view,), ReadingOptions(mm_per_pixel=0.5), Unseen(axis, 7.0))
    assert plate.views.size[axis.value] == pytest.approx(7.0)
    assert plate.views.size[along.value] == pytest.approx((x1 - x0) / 2.0, abs=0.1)
    assert plate.extents.extents[axis] == pytest.approx(14.0)
    shaft = register_views(
        (view,), ReadingOptions(lengths=((along, 60.0),)), Unseen(axis, about=along)
    )
    assert shaft.views.size[along.value] == pytest.approx(60.0)
    assert shaft.views.size[axis.value] == shaft.views.size[up.value]
    with pytest.raises(NoModelError) as error:
        register_views((view,), ReadingOptions())
    assert error.value.code == "views-parallel"
