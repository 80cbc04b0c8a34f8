from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.frame import block_box, border
from gaussiancad_core.drawing.isometric_picture import ISOMETRIC
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.model.axes import Projection, Role
from sample_parts import sample

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


def test_without_room_there_is_no_picture(bracket: PartLines) -> None:
    tight = replace(STYLE, width=900, height=760, margin=80.0, view_gap=100.0, text_height=10.0)
    drawn = compose_sheet(bracket, Projection.THIRD, replace(tight, frame=False))
    crowded = compose_sheet(bracket, Projection.THIRD, replace(tight, margin=60, text_height=40.0))
    kinds = [{mark.kind for mark in sheet.annotations} for sheet in (drawn, crowded)]
    assert AnnotationKind.PICTURE in kinds[0]
    assert AnnotationKind.PICTURE not in kinds[1]
