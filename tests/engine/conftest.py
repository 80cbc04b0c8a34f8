"""The same examples in every run: a check that fails can be repeated.  Drawn sample parts."""

from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING

import pytest
from hypothesis import HealthCheck, settings

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Shape

    from gaussiancad_core.axes import Role
    from gaussiancad_core.reasoning.drawn_views import DrawnViews

# No clock decides: a busy machine is no failure.
settings.register_profile(
    "repeatable", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("repeatable")


@pytest.fixture(scope="session")
def sample_solid() -> "Callable[[str], TopoDS_Shape]":
    """Builds the sample part of a name, its bounding box starting at the origin."""
    from gaussiancad_core.samples import sample

    return cache(lambda name: sample(name).build())


@pytest.fixture(scope="session")
def drawn() -> "Callable[[TopoDS_Shape, tuple[Role, ...]], DrawnViews]":
    """Draws the exact lines of a solid in the views of some roles."""
    from gaussiancad_core.axes import Role
    from gaussiancad_core.drawing.brep import bounding_box
    from gaussiancad_core.drawing.hlr import LineDrawing
    from gaussiancad_core.reasoning.drawn_views import exact_views

    three = (Role.FRONT, Role.TOP, Role.RIGHT)

    def draw(solid: "TopoDS_Shape", roles: "tuple[Role, ...]" = three) -> "DrawnViews":
        low, high = bounding_box(solid)
        drawing = LineDrawing(solid)
        size = tuple(float(extent) for extent in high - low)
        return exact_views({role: drawing.view(role) for role in roles}, size)

    return draw


@pytest.fixture(scope="session")
def sample_views(
    sample_solid: "Callable[[str], TopoDS_Shape]", drawn: "Callable[..., DrawnViews]"
) -> "Callable[[str], DrawnViews]":
    """The exact front, top and right view of the sample part of a name, drawn once."""
    return cache(lambda name: drawn(sample_solid(name)))
