"""Views that are sections carry what is hatched of them."""

import numpy as np
import pytest

from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.hatched_areas import with_named_sections
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind
from gaussiancad_core.sheet.views.sheet_layout import Layout

_FRONT, _RIGHT = (20.0, 20.0, 120.0, 80.0), (200.0, 20.0, 260.0, 80.0)


@pytest.mark.parametrize("is_hatched", [False, True])
def test_a_view_that_the_sheet_names_as_a_section_is_one_however_little_is_hatched(
    is_hatched: bool,
) -> None:
    boxes = {Role.FRONT: _FRONT, Role.RIGHT: _RIGHT}
    layout = Layout(boxes, Projection.THIRD, "given", (), ())
    drawn = [ReadView(role, box, (), None) for role, box in boxes.items()]
    hatched = np.zeros((100, 300), dtype=bool)
    hatched[30:70, 204:208] = is_hatched
    named = (198.0, 18.0, 262.0, 82.0)
    views, found = with_named_sections(drawn, layout, [named], hatched)
    assert views[0] == drawn[0]
    assert bool(views[1].hatched) is is_hatched
    assert [(item.kind, item.box, item.used) for item in found.special] == (
        [(SpecialKind.SECTION, _RIGHT, True)] if is_hatched else []
    )
    again, same = with_named_sections(views, found, [named], hatched)
    assert (again, same) == (views, found)
    assert with_named_sections(drawn, layout, [named], None) == (tuple(drawn), layout)
