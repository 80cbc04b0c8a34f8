from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from gaussiancad_core.drawing.draw_command import draw_file, write_image
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle
from gaussiancad_core.errors import UnreadableError, UsageError
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Projection, Role
from sample_parts import sample

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
SMALL = SheetStyle(width=480, height=360, margin=20.0, view_gap=30.0)


@pytest.fixture(scope="module")
def solid(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("solids") / "梯 block.step"
    write_step(sample("stepped-block").build(), path)
    return path


@pytest.mark.parametrize("suffix", [".png", ".JPG", ".jpeg", ".tif", ".tiff", ".bmp", ".webp"])
def test_the_suffix_is_the_format(solid: Path, tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"图 纸{suffix}"
    drawn = draw_file(solid, path, ROLES, Projection.THIRD, SMALL)
    with Image.open(path) as image:
        assert image.size == (480, 360)
        pixels = np.asarray(image.convert("RGB")).astype(int)
    lossless = suffix not in (".JPG", ".jpeg", ".webp")
    worst, mean = np.abs(pixels - drawn.image).max(), np.abs(pixels - drawn.image).mean()
    assert worst == 0 if lossless else mean < 2.0
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize(
    ("roles", "code"),
    [
        ((Role.FRONT, Role.TOP, Role.REAR), "views-not-orthogonal"),
        ((Role.LEFT, Role.RIGHT, Role.TOP), "views-not-orthogonal"),
        ((Role.FRONT, Role.TOP, Role.TOP), "views-repeat"),
        ((Role.FRONT,), "views-count"),
    ],
)
def test_sets_of_views_that_show_too_little_are_told(
    solid: Path, tmp_path: Path, roles: tuple[Role, ...], code: str
) -> None:
    with pytest.raises(UsageError) as caught:
        draw_file(solid, tmp_path / "a.png", roles, Projection.THIRD, SMALL)
    assert caught.value.code == code
    assert not list(tmp_path.iterdir())


def test_a_dimensioned_sheet_names_its_title_and_its_resolution(
    solid: Path, tmp_path: Path
) -> None:
    path = tmp_path / "a.png"
    drawn = draw_file(solid, path, ROLES, Projection.THIRD, PRESETS["dimensioned"])
    texts = {mark.label.text for mark in drawn.annotations if mark.label is not None}
    assert "? block" in texts
    with Image.open(path) as image:
        assert image.info["dpi"] == pytest.approx((drawn.dpi, drawn.dpi), abs=0.02)
        np.testing.assert_array_equal(np.asarray(image), drawn.image)
    plain = tmp_path / "b.png"
    draw_file(solid, plain, ROLES, Projection.THIRD, SMALL)
    with Image.open(plain) as image:
        assert "dpi" not in image.info


def test_two_views_are_enough(solid: Path, tmp_path: Path) -> None:
    drawn = draw_file(solid, tmp_path / "a.png", (Role.FRONT, Role.LEFT), Projection.FIRST, SMALL)
    assert [view.role for view in drawn.views] == [Role.FRONT, Role.LEFT]


def test_an_unknown_suffix_is_told_before_any_work(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        draw_file(tmp_path / "none.step", tmp_path / "a.gif", ROLES, Projection.THIRD, SMALL)
    assert caught.value.code == "sheet-suffix-unknown"


def test_a_missing_solid_is_told(tmp_path: Path) -> None:
    with pytest.raises(UnreadableError) as caught:
        draw_file(tmp_path / "none.step", tmp_path / "a.png", ROLES, Projection.THIRD, SMALL)
    assert caught.value.code == "file-missing"


def test_an_old_image_stays_where_a_new_one_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(UsageError) as caught:
        write_image(np.zeros((4, 4, 3), np.uint8), tmp_path / "none" / "a.png")
    assert caught.value.code == "output-not-writable"
