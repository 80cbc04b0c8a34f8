"""A picture's outline along three slanted axes is a pictorial's, if it is not a hexagon's."""

from itertools import pairwise

import numpy as np
import shapely

from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import to_point
from gaussiancad_core.sheet_model.paper_sheet import PaperStroke
from gaussiancad_core.structure.shaded_pictures import PICTURE
from gaussiancad_core.views.drawing_kinds import with_kinds
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView


def _kind(corners: np.ndarray) -> DrawingKind:
    ends = pairwise(np.concatenate([corners, corners[:1]]))
    edges = tuple(PaperStroke(LineSegment(to_point(a), to_point(b)), PICTURE) for a, b in ends)
    outline = shapely.Polygon(corners)
    (view,) = with_kinds([DrawnView(outline.bounds, edges, outline)], ())
    return view.kind


def test_a_hexagon_with_broken_corners_is_no_pictorial() -> None:
    angles = np.radians(np.arange(0.0, 360.0, 60.0)[:, None] + [-3.0, 3.0]).ravel()
    assert _kind(30.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)) is DrawingKind.PLAIN


def test_a_bracket_seen_askew_is_a_pictorial() -> None:
    right, left, up = (np.array(way) for way in ((0.866, 0.5), (-0.866, 0.5), (0.0, -1.0)))
    steps = [40 * right, 30 * left, 10 * up, -20 * left, 30 * up, -10 * left]
    steps += [-10 * right, 5 * up, -30 * right]
    corners = np.cumsum([np.zeros(2), *steps], axis=0)
    assert _kind(corners) is DrawingKind.PICTORIAL
