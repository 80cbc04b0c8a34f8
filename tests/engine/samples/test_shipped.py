"""The sheets and solids in resources/samples are what the parts are drawn as today."""

import numpy as np
import pytest
from PIL import Image
from sample_sheets import ROLES, SAMPLES, SHIPPED

from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.kernel.brep import soundness
from gaussiancad_core.kernel.brep_files import read_solid
from gaussiancad_core.model.axes import Projection
from sample_parts import sample


@pytest.mark.parametrize("name", SHIPPED)
def test_a_shipped_sheet_shows_its_part(name: str) -> None:
    part = sample(name).build()
    drawn = draw_sheet(part, ROLES, Projection.THIRD, PRESETS["clean"])
    with Image.open(SAMPLES / f"{name}.png") as image:
        assert image.size == (1920, 1080)
        shipped = np.asarray(image.convert("RGB")).astype(int)
    assert np.abs(shipped - drawn.image).max() <= 1
    solid = soundness(read_solid(SAMPLES / f"{name}.step"))
    assert solid.valid
    assert solid.volume_mm3 == pytest.approx(soundness(part).volume_mm3, rel=1e-12)


def test_nothing_else_is_shipped() -> None:
    expected = {f"{name}.{suffix}" for name in SHIPPED for suffix in ("png", "step")}
    assert {entry.name for entry in SAMPLES.iterdir()} == expected
