"""Half views: what is left of a view, and the marks at its centre line."""

import numpy as np
import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Segment
from sample_parts import sample

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)


def test_a_half_view_ends_at_its_centre_line() -> None:
    lines = part_lines(sample("bored-plate").build(), ROLES)
    sheets = [
        compose_sheet(lines, Projection.THIRD, parse_style(text)) for text in ("clean", "half=top")
    ]
    whole, half = (sheet[Role.TOP] for sheet in sheets)
    middle = 0.5 * (whole.box[0] + whole.box[2])
    points = np.concatenate([stroke.sample(1.0) for stroke in half.strokes])
    assert points[:, 0].max() == pytest.approx(middle, abs=1e-6)
    # Half of the length is left: nothing runs along the middle.
    lengths = [sum(stroke.length for stroke in view.strokes) for view in (whole, half)]
    assert lengths[1] == pytest.approx(0.5 * lengths[0], rel=1e-3)
    # The other views are as they were.
    assert sheets[0][Role.FRONT] == sheets[1][Role.FRONT]
    centre, marks = sheets[1].annotations
    assert (centre.kind, marks.kind) == (AnnotationKind.CENTRE_LINE, AnnotationKind.SYMMETRY)
    (line,) = centre.strokes
    assert (line.start[0], line.end[0]) == pytest.approx((middle, middle))
    assert line.start[1] < whole.box[1] and line.end[1] > whole.box[3]
    assert len(marks.strokes) == 4
    for mark in marks.strokes:
        assert isinstance(mark, Segment)
        assert mark.start[1] == mark.end[1]
        assert 0.5 * (mark.start[0] + mark.end[0]) == pytest.approx(middle)
        assert not whole.box[1] <= mark.start[1] <= whole.box[3]
