from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.files.raster_files import read_raster


@pytest.fixture
def picture() -> Image.Image:
    grey = np.full((900, 1200), 255, np.uint8)
    grey[300:303, 200:900] = 0
    grey[400:700, 300] = 128
    return Image.fromarray(grey)


@pytest.mark.parametrize(
    ("dpi", "found"),
    [
        ((200, 200), 200.0),
        ((300, 300), 300.0),
        ((150, 150), 150.0),
        # Mere defaults, too unequal, too small a sheet, too large a one, and none at all.
        ((72, 72), None),
        ((96, 96), None),
        ((300, 100), None),
        ((600, 600), None),
        ((1, 1), None),
        (None, None),
    ],
)
@pytest.mark.parametrize("suffix", ["png", "tif", "jpg"])
def test_believable_resolutions(
    tmp_path: Path, picture: Image.Image, suffix: str, dpi: tuple | None, found: float | None
) -> None:
    path = tmp_path / f"a.{suffix}"
    picture.save(path, **({"dpi": dpi} if dpi else {}))
    read = read_raster(path, 1)
    assert read.pixels_per_inch == (pytest.approx(found, abs=0.02) if found else None)
    assert read.vectors is None


@pytest.mark.parametrize("top", [1.0, 255.0])
def test_floating_point_images(tmp_path: Path, picture: Image.Image, top: float) -> None:
    values = np.asarray(picture).astype(np.float32) * (top / 255.0)
    Image.fromarray(values).save(tmp_path / "a.tif")
    assert np.array_equal(read_raster(tmp_path / "a.tif", 1).grey, np.asarray(picture))


def test_dark_sixteen_bit_images_stay_dark(tmp_path: Path, picture: Image.Image) -> None:
    Image.fromarray(np.asarray(picture).astype(np.uint16)).save(tmp_path / "a.png")
    assert read_raster(tmp_path / "a.png", 1).grey.max() <= 1


def test_wide_integers_are_scaled_to_grey(tmp_path: Path, picture: Image.Image) -> None:
    Image.fromarray(np.asarray(picture).astype(np.int32) * 257).save(tmp_path / "a.tif")
    assert np.array_equal(read_raster(tmp_path / "a.tif", 1).grey, np.asarray(picture))


def _lightness(picture: Image.Image) -> Image.Image:
    return Image.merge("LAB", [picture, *[Image.new("L", picture.size, 128)] * 2])


@pytest.mark.parametrize(
    ("name", "convert"),
    [
        ("a.png", lambda picture: picture.convert("LA")),
        ("a.tif", lambda picture: picture.convert("YCbCr")),
        ("a.tif", _lightness),
        ("a.png", lambda picture: picture.convert("RGBA").quantize()),
    ],
)
def test_rare_modes(
    tmp_path: Path, picture: Image.Image, name: str, convert: Callable[[Image.Image], Image.Image]
) -> None:
    convert(picture).save(tmp_path / name)
    difference = read_raster(tmp_path / name, 1).grey.astype(int) - np.asarray(picture)
    assert np.abs(difference).max() <= 2


def test_many_pages_are_not_walked_through(
    tmp_path: Path, picture: Image.Image, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("gaussiancad_core.files.raster_files.MAX_PAGES", 2)
    pages = [picture] * 2
    picture.save(tmp_path / "a.tif", save_all=True, append_images=pages)
    assert read_raster(tmp_path / "a.tif", 2).grey.shape == (900, 1200)
    for page, code in ((3, "too-many-pages"), (0, "page-missing")):
        with pytest.raises(UnreadableError) as caught:
            read_raster(tmp_path / "a.tif", page)
        assert caught.value.code == code
    picture.save(tmp_path / "a.png")
    with pytest.raises(UnreadableError) as caught:
        read_raster(tmp_path / "a.png", 999_999)
    assert caught.value.code == "page-missing"


def test_truncated_headers_are_damage(save: Callable, tmp_path: Path) -> None:
    Image.new("L", (300, 300)).save(tmp_path / "a.tif", compression="tiff_lzw")
    data = (tmp_path / "a.tif").read_bytes()
    for length in (12, len(data) // 3, len(data) - 20):
        with pytest.raises(UnreadableError) as caught:
            read_raster(save("b.tif", data[:length]), 1)
        assert caught.value.code in ("damaged-image", "not-an-image")


@pytest.mark.parametrize("shade", [(0.0, 0.0), (0.12, 0.0), (0.0, 0.25)])
@pytest.mark.parametrize("paper", [(255, 255, 255), (214, 196, 150), (150, 160, 190)])
def test_ink_has_its_colour_on_paper_of_any_colour(
    tmp_path: Path, paper: tuple[int, int, int], shade: tuple[float, float]
) -> None:
    across, down = (1.0 - item * np.linspace(0.0, 1.0, 1200) for item in shade)
    light = np.array(paper) * (across[None, :] * down[:, None])[..., None]
    passed = np.ones_like(light)
    inks = {200: (0.1, 0.1, 0.1), 500: (0.9, 0.1, 0.1), 800: (0.15, 0.25, 0.95)}
    for row, ink in inks.items():
        passed[row : row + 5, 100:1100] = ink
    noise = np.random.default_rng(7).normal(0.0, 4.0, light.shape)
    picture = np.clip(light * passed + noise, 0.0, 255.0).astype(np.uint8)
    Image.fromarray(picture).save(tmp_path / "a.png")
    tint = read_raster(tmp_path / "a.png", 1).tint
    rest = tint.copy()
    for row, hue in {500: 0, 800: 116}.items():
        entry = tint[row : row + 5, 100:1100].astype(int) - 1
        # Hues are a circle of 180.
        assert (np.abs((entry - hue + 90) % 180 - 90) <= 8).mean() > 0.99
        rest[row : row + 5, 100:1100] = 0
    assert (rest > 0).mean() < 1e-4


@pytest.mark.parametrize("dpi", [(204, 98), (204, 391), (98, 204), (200, 100)])
@pytest.mark.parametrize("turned", [False, True])
def test_unequal_pixels_are_made_square(tmp_path: Path, dpi: tuple[int, int], turned: bool) -> None:
    """A square of two inches is drawn, as a scanner of such pixels sees it."""
    across, down = dpi
    grey = np.full((5 * down, 5 * across), 255, np.uint8)
    grey[down : 3 * down, across : 3 * across] = 0
    path = tmp_path / "a.tif"
    # The sixth of EXIF's orientations is a quarter turn.
    orientation = {"tiffinfo": {274: 6}, "compression": "tiff_lzw"} if turned else {}
    Image.fromarray(grey).save(path, dpi=dpi, **orientation)
    read = read_raster(path, 1)
    most = max(dpi)
    assert read.grey.shape == (5 * most, 5 * most)
    assert read.pixels_per_inch == pytest.approx(most, abs=0.02)
    assert [note.code for note in read.notes] == ["pixels-made-square"]
    rows, columns = np.nonzero(read.grey < 128)
    assert np.ptp(rows) + 1 == pytest.approx(2 * most, abs=2)
    assert np.ptp(columns) + 1 == pytest.approx(2 * most, abs=2)
