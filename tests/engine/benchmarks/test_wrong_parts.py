"""Parts with one thing wrong: each is another part than the one that it was made of."""

import numpy as np
import pytest

from benchmarks.parts.wrong_parts import KINDS, wrong_parts
from gaussiancad_core.evidence.drawn_views import exact_views
from gaussiancad_core.judging.drawn_lines import drawn_sheet
from gaussiancad_core.judging.misfits import Judge
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Axis, Role
from sample_parts.modelling import box, cut, cylinder

_PART = cut(
    box((0.0, 0.0, 0.0), (60.0, 40.0, 30.0)),
    box((40.0, -1.0, 18.0), (61.0, 41.0, 31.0)),
    cylinder(Axis.Z, (15.0, 12.0), 5.0, -1.0, 31.0),
)


def test_each_kind_is_made_and_costs_more_than_the_part() -> None:
    drawing = LineDrawing(_PART)
    roles = Role.FRONT, Role.TOP, Role.RIGHT
    views = exact_views({role: drawing.view(role) for role in roles}, (60.0, 40.0, 30.0))
    judge = Judge(drawn_sheet(views))
    found = dict(wrong_parts(_PART))
    assert set(found) == set(KINDS)
    for kind, solid in found.items():
        assert judge.misfit(solid).share > 0.01, kind
    assert found["stretched"].extent == pytest.approx([60.0, 41.2, 30.0])
    assert found["mirrored"].box[:, 0] == pytest.approx([-60.0, 0.0])
    assert np.ptp(found["block"].vertices, axis=0).max() >= 60.0
