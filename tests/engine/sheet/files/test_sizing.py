import pytest

from gaussiancad_core.sheet.files.sizing import size_drawing


@pytest.mark.parametrize(
    ("width", "height", "inches", "scale", "dpi"),
    [
        (297.0, 210.0, 1 / 25.4, 200 / 25.4, 200.0),
        (11.0, 8.5, 1.0, 200.0, 200.0),
        (1189.0, 841.0, 1 / 25.4, 200 / 25.4, 200.0),
        # Too small and too large for paper, and more pixels than are read.
        (1.8, 1.0, 1 / 25.4, 3000 / 1.8, None),
        (1e4, 5e3, 1.0, 0.3, None),
        (100.0, 100.0, 1.0, 30.0, None),
    ],
)
def test_papers_have_200_dpi(
    width: float, height: float, inches: float, scale: float, dpi: float | None
) -> None:
    for sides in ((width, height), (height, width)):
        sizing = size_drawing(*sides, inches)
        assert sizing.scale == pytest.approx(scale)
        assert sizing.pixels_per_inch == dpi
