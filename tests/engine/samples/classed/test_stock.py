import numpy as np
import pytest

from gaussiancad_core.kernel.brep import soundness, volume
from gaussiancad_core.model.axes import Axis
from sample_parts.classed.outlines import extruded, rectangle
from sample_parts.classed.stock import Change, Fill, Stock
from sample_parts.modelling import box


@pytest.fixture
def channel() -> Stock:
    """Two cheeks of 10 mm on a floor of 8 mm: 60 x 40 x 50."""
    stock = Stock((60, 40, 50))
    for lower, upper in (
        ((0, 0, 0), (60, 40, 8)),
        ((0, 0, 0), (10, 40, 50)),
        ((50, 0, 0), (60, 40, 50)),
    ):
        stock.apply(Change.ADD, box(lower, upper))
        stock.mark_box(lower, upper, Fill.FULL)
    return stock


def test_a_site_tells_level_depth_and_what_lies_behind(channel: Stock) -> None:
    cheek = channel.site(Axis.X, 1, (10, 20), (20, 30))
    assert (cheek.level, cheek.depth, cheek.runs) == (60.0, 10.0, 2)
    floor = channel.site(Axis.Z, 1, (20, 10), (40, 30))
    assert (floor.level, floor.depth, floor.runs) == (8.0, 8.0, 1)
    below = channel.site(Axis.Z, -1, (20, 10), (40, 30))
    assert (below.level, below.depth, below.runs) == (0.0, 8.0, 1)
    assert below.span(2.0, -8.0) == (-2.0, 8.0)
    assert floor.centre == (30.0, 20.0)


def test_steps_and_borders_are_no_sites(channel: Stock) -> None:
    assert channel.site(Axis.Z, 1, (6, 10), (30, 30)) is None
    # A wall of one cell has to stay.
    assert channel.site(Axis.Z, 1, (10, 10), (30, 30)) is None
    assert channel.site(Axis.Z, 1, (12, 10), (30, 30)) is not None
    assert channel.site(Axis.X, 1, (0, 10), (20, 30)) is None


def test_round_tools_leave_mixed_cells(channel: Stock) -> None:
    outline = rectangle((12, 12), (28, 28), 8.0)
    channel.apply(Change.CUT, extruded(Axis.X, outline, 40.0, 62.0))
    channel.mark(Axis.X, outline, (50.0, 60.0), Fill.EMPTY)
    # Through the first cheek the second one can be seen, but only inside of the hole.
    seen = channel.site(Axis.X, 1, (18, 18), (22, 22))
    assert (seen.level, seen.depth) == (10.0, 10.0)
    assert channel.site(Axis.X, 1, (12, 12), (20, 20)) is None
    assert not channel.full((50, 10, 10), (60, 20, 20))
    assert channel.full((0, 10, 10), (10, 20, 20))


def test_operations_are_carried_out_in_order() -> None:
    stock = Stock((20, 20, 10))
    stock.apply(Change.ADD, box((0, 0, 0), (20, 20, 10)))
    stock.apply(Change.CUT, box((4, 4, 4), (16, 16, 12)))
    stock.apply(Change.ADD, box((8, 8, 2), (12, 12, 10)))
    stock.apply(Change.CUT, box((9, 9, -1), (11, 11, 11)))
    solid = stock.solid()
    assert volume(solid) == pytest.approx(4000 - 144 * 6 + 16 * 6 - 4 * 10)
    assert (soundness(solid).solids, soundness(solid).faces) == (1, 20)


def test_a_slanted_outline_is_mixed_along_its_border_only() -> None:
    stock = Stock((40, 10, 40))
    corners = [(0.0, 0.0, 0.0), (40.0, 0.0, 0.0), (0.0, 40.0, 0.0)]
    stock.mark(Axis.Y, corners, (0.0, 10.0), Fill.FULL)
    assert stock.full((0, 0, 0), (18, 10, 18))
    assert not stock.full((0, 0, 0), (20, 10, 22))
    floor = stock.site(Axis.Z, -1, (4, 4), (8, 6))
    assert floor.level == 0.0
    # The cell beside it is the last that counts: there the slant is 30 mm high and above.
    assert floor.depth == 30.0
    assert np.prod(floor.extent) == 8.0
