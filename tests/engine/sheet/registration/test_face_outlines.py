"""The outline of a view by the faces that its strokes enclose."""

import numpy as np
import pytest

from gaussiancad_core.sheet.registration.face_outlines import outline_of_strokes


def _square(x: float, y: float, side: float) -> np.ndarray:
    return np.array([(x, y), (x + side, y), (x + side, y + side), (x, y + side), (x, y)])


def test_regions_know_what_goes_around_them_the_innermost_first() -> None:
    rings = [(0, 0, 100), (10, 10, 60), (20, 20, 20), (24, 24, 5), (80, 80, 10)]
    line = np.array([(70.0, 70.0), (100.0, 70.0)])
    curves = [*(_square(*map(float, ring)) for ring in rings), line]
    outline = outline_of_strokes(curves, (0.0, 0.0, 100.0, 100.0), 3)
    assert outline is not None
    sides = [round((region.box[2] - region.box[0]) / 3.0) for region in outline.regions]
    parents = [[sides[number] for number in region.parents] for region in outline.regions]
    assert dict(zip(sides, parents, strict=True)) == {
        100: [],
        60: [100],
        20: [60, 100],
        10: [100],
        5: [20, 60, 100],
    }


def test_regions_that_share_an_edge_do_not_go_around_each_other() -> None:
    curves = [_square(0.0, 0.0, 50.0), np.array([(25.0, 0.0), (25.0, 50.0)])]
    outline = outline_of_strokes(curves, (0.0, 0.0, 50.0, 50.0), 3)
    assert outline is not None
    assert [region.parents for region in outline.regions] == [(), ()]
    assert outline.box == pytest.approx((0.0, 0.0, 50.0, 50.0), abs=0.4)
