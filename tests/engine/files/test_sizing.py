from pathlib import Path

import pytest

from gaussiancad_core.files.content import MOST_WORKED_ON
from gaussiancad_core.files.sizing import notes_on, size_drawing


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
