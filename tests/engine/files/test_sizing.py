from pathlib import Path

import pytest

from gaussiancad_core.files.content import MOST_WORKED_ON
from gaussiancad_core.files.sizing import notes_on, size_drawing, size_without_unit


@pytest.mark.parametrize(
    ("width", "height", "inches", "scale", "dpi"),
    [
        (297.0, 210.0, 1 / 25.4, 200 / 25.4, 200.0),
        (11.0, 8.5, 1.0, 200.0, 200.0),
        (594.0, 420.0, 1 / 25.4, 200 / 25.4, 200.0),
    ],
)
def test_papers_have_200_dpi(
    width: float, height: float, inches: float, scale: float, dpi: float
) -> None:
    for sides in ((width, height), (height, width)):
        sizing = size_drawing(*sides, inches)
        assert sizing.scale == pytest.approx(scale)
        assert sizing.pixels_per_inch == dpi
        assert sizing.on_paper


@pytest.mark.parametrize(
    ("width", "height", "inches", "scale"),
    [
        # Too small and too large for paper, and more pixels than are read.
        (1.8, 1.0, 1 / 25.4, 3000 / 1.8),
        (1e4, 5e3, 1.0, 0.3),
        (100.0, 100.0, 1.0, 30.0),
    ],
)
def test_what_is_no_paper_keeps_its_unit(
    width: float, height: float, inches: float, scale: float
) -> None:
    for sides in ((width, height), (height, width)):
        sizing = size_drawing(*sides, inches)
        assert sizing.scale == pytest.approx(scale)
        assert sizing.pixels_per_inch * inches == pytest.approx(scale)
        assert not sizing.on_paper
        assert notes_on(Path("a.dxf"), sizing) == ()


def test_what_says_no_unit_is_drawn_as_paper_where_that_may_be() -> None:
    metric, imperial, none = (size_without_unit(size, size) for size in (200.0, 20.0, 1e6))
    assert (metric.scale, imperial.scale) == pytest.approx((200 / 25.4, 200.0))
    assert none.scale == pytest.approx(0.003)
    for sizing in (metric, imperial, none):
        assert sizing.pixels_per_inch is None
        assert [note.code for note in notes_on(Path("a.dxf"), sizing)] == ["paper-size-unknown"]


@pytest.mark.parametrize(("width", "height"), [(1189.0, 841.0), (2378.0, 841.0)])
def test_large_papers_have_as_many_pixels_as_memory_suffices_for(
    width: float, height: float
) -> None:
    sizing = size_drawing(width, height, 1 / 25.4)
    assert width * height * sizing.scale**2 == pytest.approx(MOST_WORKED_ON)
    assert sizing.scale == pytest.approx(sizing.pixels_per_inch / 25.4)
    (note,) = notes_on(Path("a.pdf"), sizing)
    assert note.code == "resolution-lowered"
    assert f"{sizing.pixels_per_inch:.0f} dpi" in note.message
