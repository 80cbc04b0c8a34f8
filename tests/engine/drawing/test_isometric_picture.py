from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.distance import pdist

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.frame import block_box, border
from gaussiancad_core.drawing.isometric_picture import ISOMETRIC
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.samples import sample
from gaussiancad_core.samples.modelling import box

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
STYLE = replace(PRESETS["dimensioned"], picture=True)


@pytest.fixture(scope="module")
def bracket() -> PartLines:
    return part_lines(sample("l-bracket").build(), ROLES, picture=True)


@pytest.fixture(scope="module")
def sheet(bracket: PartLines) -> Sheet:
    return compose_sheet(bracket, Projection.THIRD, STYLE)


def test_the_frame_is_orthonormal_and_foreshortens_all_axes_alike() -> None:
    right, up, look = (np.array(v) for v in (ISOMETRIC.right, ISOMETRIC.up, ISOMETRIC.look))
    np.testing.assert_allclose(np.cross(up, right), look, atol=1e-15)
    matrix = np.stack([right, up, look])
    np.testing.assert_allclose(matrix @ matrix.T, np.eye(3), atol=1e-15)
    lengths = np.hypot(*np.stack([right, up]))
    np.testing.assert_allclose(lengths, np.sqrt(2.0 / 3.0))


def test_a_block_shows_nine_edges_and_hides_three() -> None:
    strokes = LineDrawing(box((0, 0, 0), (30, 20, 10))).seen(ISOMETRIC)
    kinds = [stroke.linetype for stroke in strokes]
    assert (kinds.count(Linetype.VISIBLE), kinds.count(Linetype.HIDDEN)) == (9, 3)
    # The corner towards the viewer joins three visible edges, the far one the hidden ones.
    plane = np.array([ISOMETRIC.right, ISOMETRIC.up])
    near, far = plane @ (30.0, 0.0, 10.0), plane @ (0.0, 20.0, 0.0)
    for corner, kind in ((near, Linetype.VISIBLE), (far, Linetype.HIDDEN)):
        meeting = [
            stroke.linetype
            for stroke in strokes
            if min(np.hypot(*(np.array(end) - corner)) for end in (stroke.start, stroke.end)) < 1e-6
        ]
        assert meeting == [kind] * 3


def test_circles_are_seen_as_ellipses(bracket: PartLines) -> None:
    chains = [stroke for stroke in bracket.picture if isinstance(stroke, Polyline)]
    rims = [np.array(c.points) for c in chains if np.allclose(c.points[0], c.points[-1])]
    # The rims of both holes on the faces towards the viewer; an ellipse is as long as its circle
    # is wide, and in this projection as narrow as that over the square root of three.
    sizes = sorted((float(pdist(rim).max()), _narrowest(rim)) for rim in rims)
    expected = [(14.0, 14.0 / np.sqrt(3.0)), (20.0, 20.0 / np.sqrt(3.0))]
    for size in expected:
        assert any(size == pytest.approx(found, rel=1e-3) for found in sizes)


def _narrowest(points: np.ndarray) -> float:
    """Least width of a set of points over all directions."""
    angles = np.linspace(0.0, np.pi, 721)
    across = points @ np.stack([np.cos(angles), np.sin(angles)])
    return float(np.ptp(across, axis=0).min())


def test_the_picture_stands_alone_in_a_corner(sheet: Sheet) -> None:
    (picture,) = [mark for mark in sheet.annotations if mark.kind is AnnotationKind.PICTURE]
    x0, y0, x1, y1 = picture.box
    frame = border(STYLE)
    assert frame[0] < x0 and frame[1] < y0 and x1 < frame[2] and y1 < frame[3]
    others = [view.box for view in sheet.views] + [block_box(STYLE)]
    others += [
        mark.box
        for mark in sheet.annotations
        if mark.kind not in (AnnotationKind.FRAME, AnnotationKind.PICTURE)
    ]
    for u0, v0, u1, v1 in others:
        assert x1 < u0 or u1 < x0 or y1 < v0 or v1 < y0
    assert max(x1 - x0, y1 - y0) > 0.2 * STYLE.height


def test_the_picture_shows_visible_lines_only(bracket: PartLines, sheet: Sheet) -> None:
    (picture,) = [mark for mark in sheet.annotations if mark.kind is AnnotationKind.PICTURE]
    visible = [stroke for stroke in bracket.picture if stroke.linetype is Linetype.VISIBLE]
    assert len(picture.strokes) == len(visible) < len(bracket.picture)
    scale = {
        round(drawn.length / plane.length, 9)
        for drawn, plane in zip(picture.strokes, visible, strict=True)
    }
    assert len(scale) == 1


def test_without_room_there_is_no_picture(bracket: PartLines) -> None:
    tight = replace(STYLE, width=900, height=760, margin=80.0, view_gap=100.0, text_height=10.0)
    drawn = compose_sheet(bracket, Projection.THIRD, replace(tight, frame=False))
    crowded = compose_sheet(bracket, Projection.THIRD, replace(tight, margin=60, text_height=40.0))
    kinds = [{mark.kind for mark in sheet.annotations} for sheet in (drawn, crowded)]
    assert AnnotationKind.PICTURE in kinds[0]
    assert AnnotationKind.PICTURE not in kinds[1]


def test_a_style_that_asks_for_none_draws_none(bracket: PartLines) -> None:
    marks = compose_sheet(bracket, Projection.THIRD, PRESETS["dimensioned"]).annotations
    assert AnnotationKind.PICTURE not in {mark.kind for mark in marks}
