from dataclasses import replace

import cv2
import numpy as np
import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Trsf, gp_Vec

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import Sheet, compose_sheet, draw_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle, parse_style
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.errors import UsageError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Linetype
from sample_parts import sample

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
SMALL = SheetStyle(width=640, height=480, margin=30.0, view_gap=40.0)


@pytest.fixture(scope="module")
def bracket() -> object:
    return sample("l-bracket").build()


@pytest.fixture(scope="module")
def sheet(bracket: object) -> Sheet:
    return draw_sheet(bracket, ROLES, Projection.THIRD, SMALL)


def test_the_boxes_have_the_part_s_proportions(sheet: Sheet) -> None:
    size = {Role.FRONT: (80, 60), Role.TOP: (80, 50), Role.RIGHT: (50, 60)}
    for view in sheet.views:
        x0, y0, x1, y1 = view.box
        np.testing.assert_allclose(
            np.array([x1 - x0, y1 - y0]) * sheet.mm_per_pixel, size[view.role], rtol=1e-9
        )
    front, top, right = (sheet[role].box for role in ROLES)
    assert (front[0], front[2]) == pytest.approx((top[0], top[2]), abs=1e-9)
    assert (front[1], front[3]) == pytest.approx((right[1], right[3]), abs=1e-9)


def test_the_ink_lies_where_the_boxes_say() -> None:
    sheet = draw_sheet(sample("pocket-block").build(), ROLES, Projection.THIRD, SMALL)
    dark = 255.0 - sheet.image[..., 0].astype(np.float64)
    for view in sheet.views:
        x0, y0, x1, y1 = view.box
        row = int(0.62 * y0 + 0.38 * y1)
        column = int(0.62 * x0 + 0.38 * x1)
        for at, profile in (
            (x0, dark[row]),
            (x1, dark[row]),
            (y0, dark[:, column]),
            (y1, dark[:, column]),
        ):
            near = slice(int(at) - 4, int(at) + 5)
            centres = np.arange(len(profile))[near] + 0.5
            assert profile[near] @ centres / profile[near].sum() == pytest.approx(at, abs=0.05)


def test_plane_strokes_and_sheet_strokes_are_the_same_lines(sheet: Sheet) -> None:
    for view in sheet.views:
        for drawn, plane in zip(view.strokes, view.plane_strokes, strict=True):
            assert drawn.length * sheet.mm_per_pixel == pytest.approx(plane.length)
            assert drawn.linetype is plane.linetype


def test_the_position_of_the_solid_does_not_matter(bracket: object, sheet: Sheet) -> None:
    motion = gp_Trsf()
    motion.SetTranslation(gp_Vec(-13.0, 250.0, 7.7))
    moved = BRepBuilderAPI_Transform(bracket, motion, True).Shape()
    again = draw_sheet(moved, ROLES, Projection.THIRD, SMALL)
    assert np.abs(again.image.astype(int) - sheet.image).max() <= 1


def test_colours_and_switches(bracket: object) -> None:
    style = replace(SMALL, ink=(255, 255, 255), paper=(24, 58, 120), antialiasing=False)
    image = draw_sheet(bracket, ROLES, Projection.FIRST, style).image
    assert {tuple(colour) for colour in np.unique(image.reshape(-1, 3), axis=0)} == {
        (255, 255, 255),
        (24, 58, 120),
    }


def test_noise_comes_from_the_seed_alone(bracket: object) -> None:
    style = replace(SMALL, noise=5.0, blur=0.8)
    one, same, other = (
        draw_sheet(bracket, ROLES, Projection.THIRD, style, seed=seed).image for seed in (1, 1, 2)
    )
    np.testing.assert_array_equal(one, same)
    assert (one != other).mean() > 0.3


def test_a_skewed_drawing_turns_counter_clockwise(bracket: object, sheet: Sheet) -> None:
    skewed = draw_sheet(bracket, ROLES, Projection.THIRD, replace(SMALL, skew=2.0))
    bottom = max(skewed[Role.FRONT].strokes[:6], key=lambda stroke: stroke.start[1] + stroke.end[1])
    run, rise = np.abs(np.array(bottom.end) - np.array(bottom.start))
    assert np.degrees(np.arctan2(rise, run)) == pytest.approx(2.0)
    low, high = sorted((bottom.start, bottom.end))
    assert low[1] > high[1]
    assert skewed[Role.FRONT].box[2] - skewed[Role.FRONT].box[0] > (
        sheet[Role.FRONT].box[2] - sheet[Role.FRONT].box[0]
    )


@pytest.mark.parametrize("name", ["dimensioned", "photocopy", "ansi"])
def test_under_skew_the_truth_is_the_level_one_turned(bracket: object, name: str) -> None:
    lines = part_lines(bracket, ROLES)
    style = replace(PRESETS[name], skew=0.0)
    level = compose_sheet(lines, Projection.THIRD, style)
    skewed = compose_sheet(lines, Projection.THIRD, replace(style, skew=3.0))
    angle, centre = -np.radians(3.0), np.array([style.width / 2.0, style.height / 2.0])
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    pairs = [
        (one, other)
        for first, second in (
            *zip(level.views, skewed.views, strict=True),
            *zip(level.annotations, skewed.annotations, strict=True),
        )
        for one, other in zip(first.strokes, second.strokes, strict=True)
    ]
    assert len(pairs) > 20
    for one, other in pairs:
        # Steps that no rounding makes one more or less.
        step = one.length / 7.5
        expected = (one.sample(step) - centre) @ turn.T + centre
        np.testing.assert_allclose(other.sample(step), expected, atol=1e-9)
    # The image shows what the truth says: ink lies under every visible line.
    dark = 255 - skewed.image[..., 0].astype(int)
    for view in skewed.views:
        for stroke in view.strokes:
            if stroke.linetype is Linetype.VISIBLE:
                x, y = np.floor(stroke.sample(1.0)).astype(int).T
                assert np.median(dark[y, x]) > 120


@pytest.mark.parametrize("name", ["dimensioned", "photocopy"])
def test_a_sheet_comes_from_its_seed(bracket: object, name: str) -> None:
    lines = part_lines(bracket, ROLES)
    one, same = (compose_sheet(lines, Projection.THIRD, PRESETS[name], seed=4) for _ in range(2))
    assert one.image.tobytes() == same.image.tobytes()
    assert one.annotations == same.annotations


def test_without_annotations_there_is_nothing_but_the_views(bracket: object) -> None:
    style = replace(SMALL, noise=3.0, blur=0.7)
    sheet = draw_sheet(bracket, ROLES, Projection.THIRD, style, seed=9)
    ink = rasterise(tuple(stroke for view in sheet.views for stroke in view.strokes), style)
    ink = cv2.GaussianBlur(ink, (0, 0), style.blur)
    noise = np.random.default_rng(9).standard_normal(ink.shape, dtype=np.float32)
    expected = 255.0 - 255.0 * ink + np.float32(style.noise) * noise
    assert sheet.annotations == ()
    np.testing.assert_array_equal(
        sheet.image, np.repeat(np.clip(np.rint(expected), 0, 255)[..., None], 3, axis=2)
    )


def test_lines_drawn_once_serve_every_style(bracket: object, sheet: Sheet) -> None:
    lines = part_lines(bracket, ROLES)
    again = compose_sheet(lines, Projection.THIRD, SMALL)
    np.testing.assert_array_equal(again.image, sheet.image)
    assert again.views == sheet.views


def test_tangent_edges_are_drawn_on_request() -> None:
    part = sample("filleted-block").build()
    plain = draw_sheet(part, ROLES, Projection.THIRD, SMALL)
    tangent = draw_sheet(
        part, ROLES, Projection.THIRD, replace(SMALL, tangent_edges=TangentPolicy.DRAWN)
    )
    front = {stroke.start[0] for stroke in plain[Role.FRONT].plane_strokes}
    assert not {12.0, 68.0} & {round(x, 6) for x in front}
    added = {
        (round(stroke.start[0], 6), stroke.linetype.value)
        for stroke in tangent[Role.FRONT].plane_strokes
    }
    assert {(12.0, "visible"), (68.0, "visible")} <= added


def test_thin_tangent_edges_are_the_visible_ones_and_no_strokes_of_views() -> None:
    part = sample("filleted-block").build()
    plain = draw_sheet(part, ROLES, Projection.THIRD, SMALL)
    style = parse_style("clean,tangent-edges=thin,width=640,height=480,margin=30")
    thin = draw_sheet(
        part, ROLES, Projection.THIRD, replace(SMALL, tangent_edges=style.tangent_edges)
    )
    assert style.tangent_edges is TangentPolicy.THIN
    assert thin.views == plain.views
    assert {mark.kind for mark in thin.annotations} == {AnnotationKind.TANGENT_EDGE}
    assert {mark.width for mark in thin.annotations} == {SMALL.annotation_width}
    x0, y0, x1, _ = thin[Role.FRONT].box
    in_front = sorted(
        stroke.start[0]
        for mark in thin.annotations
        for stroke in mark.strokes
        if x0 < stroke.start[0] < x1 and min(stroke.start[1], stroke.end[1]) >= y0 - 1e-6
    )
    px = (x1 - x0) / 80.0
    assert in_front == pytest.approx([x0 + 12.0 * px, x0 + 68.0 * px])


def test_a_view_that_is_cut_has_no_thin_tangent_edges() -> None:
    part = sample("filleted-block").build()
    style = replace(SMALL, tangent_edges=TangentPolicy.THIN, section=Role.FRONT)
    marks = draw_sheet(part, ROLES, Projection.THIRD, style).annotations
    thin = [mark for mark in marks if mark.kind is AnnotationKind.TANGENT_EDGE]
    assert [len(mark.strokes) for mark in thin] == [2]


def test_named_styles_draw_the_same_boxes_where_they_share_the_layout(bracket: object) -> None:
    boxes = {
        name: draw_sheet(
            bracket, ROLES, Projection.THIRD, parse_style(f"{name},width=640,height=480,margin=30")
        )[Role.TOP].box
        for name in ("clean", "thick", "blueprint")
    }
    assert len(set(boxes.values())) == 1


def test_repeated_views_are_told(bracket: object) -> None:
    with pytest.raises(UsageError):
        draw_sheet(bracket, (Role.FRONT, Role.FRONT), Projection.THIRD, SMALL)
