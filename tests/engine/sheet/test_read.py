from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.sheet.read import read_sheet


@pytest.fixture
def picture() -> Image.Image:
    grey = np.full((120, 200), 255, np.uint8)
    grey[30:33, 20:150] = 0
    return Image.fromarray(grey)


@pytest.mark.parametrize("suffix", ["png", "tif", "bmp", "webp", "jpg", "JPEG"])
def test_formats(tmp_path: Path, picture: Image.Image, suffix: str) -> None:
    path = tmp_path / f"图 a sheet.{suffix}"
    picture.save(path, **({"lossless": True} if suffix == "webp" else {}))
    read = read_sheet(path).grey
    assert read.shape == (120, 200)
    assert np.abs(read.astype(int) - np.asarray(picture).astype(int)).mean() < 3


@pytest.mark.parametrize("mode", ["1", "P", "RGB", "RGBA", "CMYK", "I;16"])
def test_colour_modes(tmp_path: Path, picture: Image.Image, mode: str) -> None:
    path = tmp_path / ("sheet.tif" if mode == "CMYK" else "sheet.png")
    if mode == "I;16":
        image = Image.fromarray(np.asarray(picture).astype(np.uint16) * 257)
    else:
        image = picture.convert(mode)
    image.save(path)
    assert np.array_equal(read_sheet(path).grey, np.asarray(picture))


def test_transparent_paper_is_white(tmp_path: Path, picture: Image.Image) -> None:
    ink = Image.new("RGBA", picture.size, (0, 0, 0, 0))
    ink.putalpha(picture.point(lambda value: 255 - value))
    ink.save(tmp_path / "sheet.png")
    assert np.array_equal(read_sheet(tmp_path / "sheet.png").grey, np.asarray(picture))


def test_exif_rotation_is_applied(tmp_path: Path, picture: Image.Image) -> None:
    exif = Image.Exif()
    exif[0x0112] = 6
    picture.rotate(90, expand=True).save(tmp_path / "a.png", exif=exif)
    assert np.array_equal(read_sheet(tmp_path / "a.png").grey, np.asarray(picture))


def test_blueprints_are_turned_to_dark_on_light(tmp_path: Path, picture: Image.Image) -> None:
    picture.point(lambda value: 255 - value).save(tmp_path / "blue.png")
    assert np.array_equal(read_sheet(tmp_path / "blue.png").grey, np.asarray(picture))


def test_pages_count_from_one(tmp_path: Path, picture: Image.Image) -> None:
    path = tmp_path / "pages.tif"
    blank = Image.new("L", picture.size, 255)
    blank.save(path, save_all=True, append_images=[picture])
    assert np.array_equal(read_sheet(path, 2).grey, np.asarray(picture))
    with pytest.raises(UnreadableError, match="2 page") as caught:
        read_sheet(path, 3)
    assert caught.value.code == "page-missing"


def _broken(path: Path, code: str, picture: Image.Image) -> None:
    picture.save(path)
    whole = path.read_bytes()
    if code == "damaged-image":
        path.write_bytes(whole[: len(whole) // 2])
    elif code == "not-an-image":
        path.write_text("this is text")
    elif code == "empty-file":
        path.write_bytes(b"")
    elif code == "image-too-small":
        picture.resize((40, 30)).save(path)
    elif code == "image-too-large":
        Image.new("1", (30_000, 30_000), 1).save(path)
    elif code == "file-missing":
        path.unlink()


@pytest.mark.parametrize(
    "code",
    [
        "damaged-image",
        "not-an-image",
        "empty-file",
        "image-too-small",
        "image-too-large",
        "file-missing",
    ],
)
def test_unreadable_files(tmp_path: Path, picture: Image.Image, code: str) -> None:
    path = tmp_path / "sheet.png"
    _broken(path, code, picture)
    with pytest.raises(UnreadableError) as caught:
        read_sheet(path)
    assert caught.value.code == code
    assert str(path) in caught.value.message


def test_folders_and_vector_files_are_told_apart(tmp_path: Path) -> None:
    (tmp_path / "a.pdf").write_bytes(b"%PDF-1.7")
    for path, code in ((tmp_path, "not-a-file"), (tmp_path / "a.pdf", "format-not-supported")):
        with pytest.raises(UnreadableError) as caught:
            read_sheet(path)
        assert caught.value.code == code
