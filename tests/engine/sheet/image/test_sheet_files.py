from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import gaussiancad_core.sheet.image.sheet_files as reading
from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.sheet.image.sheet_files import read_sheet


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


def test_folders_are_told(tmp_path: Path) -> None:
    with pytest.raises(UnreadableError) as caught:
        read_sheet(tmp_path)
    assert caught.value.code == "not-a-file"


SVG = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="2in" height="1in" viewBox="0 0 200 100">'
    '<circle cx="100" cy="50" r="30" fill="none" stroke="black"/></svg>'
)


@pytest.mark.parametrize("name", ["a.svg", "a", "a.png", "图 b.pdf"])
def test_the_content_tells_the_kind(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text(SVG)
    sheet = read_sheet(path)
    assert sheet.grey.shape == (200, 400)
    assert sheet.pixels_per_inch == 200.0
    (stroke,) = sheet.vectors.strokes
    assert stroke.curve == CircularArc((200.0, 100.0), 60.0, 0.0, 2 * np.pi)
    assert len(sheet.sha256) == 64


def test_dark_vector_drawings_are_inverted(tmp_path: Path) -> None:
    dark = SVG.replace("<circle", '<rect width="200" height="100" fill="#013"/><circle')
    (tmp_path / "a.svg").write_text(dark.replace('stroke="black"', 'stroke="white"'))
    sheet = read_sheet(tmp_path / "a.svg")
    assert sheet.grey[0, 0] > 200
    assert sheet.grey[100, 140] < 60


def test_images_have_no_vectors(tmp_path: Path, picture: Image.Image) -> None:
    picture.save(tmp_path / "a.png")
    sheet = read_sheet(tmp_path / "a.png")
    assert sheet.vectors is None
    assert sheet.notes == ()


def test_what_was_left_out_is_noted(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text(SVG.replace("<circle", '<image href="b.png"/><circle'))
    assert [note.code for note in read_sheet(tmp_path / "a.svg").notes] == ["external-left-out"]


@pytest.mark.parametrize(
    ("name", "data", "code"),
    [
        ("a.pdf", b"%PDF-1.7", "damaged-pdf"),
        ("a.pdf", b"hello", "damaged-pdf"),
        ("a.svg", b"hello", "damaged-svg"),
        ("a.dxf", b"hello", "damaged-dxf"),
        ("a.dwg", b"AC1032 hello", "format-not-supported"),
        ("a.png", b"AC1032 hello", "format-not-supported"),
        ("a.pdf", b"", "empty-file"),
    ],
)
def test_bad_vector_files(tmp_path: Path, name: str, data: bytes, code: str) -> None:
    (tmp_path / name).write_bytes(data)
    with pytest.raises(UnreadableError) as caught:
        read_sheet(tmp_path / name)
    assert caught.value.code == code
    assert str(tmp_path / name) in caught.value.message


@pytest.mark.parametrize("mode", ["L", "RGBA"])
def test_a_large_picture_is_read_smaller_and_told(
    mode: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "MOST_WORKED_ON", 100_000)
    image = Image.new(mode, (800, 500), "white")
    image.paste("black", (200, 100, 400, 300))
    image.save(tmp_path / "large.png", dpi=(200, 200))
    found = read_sheet(tmp_path / "large.png")
    assert found.grey.shape == (250, 400) and found.reduction == 2.0
    assert found.pixels_per_inch == pytest.approx(100.0, rel=1e-3)
    assert [note.code for note in found.notes] == ["resolution-lowered"]
    assert (found.grey[50:150, 100:200] == 0).all() and found.grey.mean() > 200
