"""Views that are drawn of a solid, and whether a sketch is that solid again."""

import numpy as np
import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.brep import bounding_box, soundness, volume
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sketch.sketching import Sketch

GRID = 0.1
ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)


def drawn(shape: TopoDS_Shape, roles: tuple[Role, ...] = ROLES, *, hidden: bool) -> DrawnViews:
    """Views of a shape in the corner of its axes, with or without hidden lines."""
    drawing = LineDrawing(shape)
    strokes = {
        role: tuple(
            item for item in drawing.view(role) if hidden or item.linetype is Linetype.VISIBLE
        )
        for role in roles
    }
    size = tuple(np.ptp(bounding_box(shape), axis=0).tolist())
    return DrawnViews(strokes, size, 1e-4)


def check(found: Sketch | None, truth: TopoDS_Shape) -> None:
    facts, expected = soundness(found.shape), soundness(truth)
    assert (facts.valid, facts.closed, facts.solids) == (True, True, 1)
    left = sum(
        volume(BRepAlgoAPI_Cut(*pair).Shape())
        for pair in ((found.shape, truth), (truth, found.shape))
    )
    assert left == pytest.approx(0.0, abs=2e-4 * volume(truth))
    assert facts.faces == expected.faces
