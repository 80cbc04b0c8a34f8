import zipfile
from pathlib import Path

import pytest

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.files.file_kinds import FileKind, detect, is_freecad_document, unsupported
from gaussiancad_core.files.file_opening import head_of

SVG = '<?xml version="1.0"?>\n<!-- x -->\n<svg xmlns="http://www.w3.org/2000/svg"/>'


@pytest.mark.parametrize(
    ("head", "kind"),
    [
        (b"\x89PNG\r\n\x1a\n...", FileKind.RASTER),
        (b"\xff\xd8\xff\xe0", FileKind.RASTER),
        (b"II*\0....", FileKind.RASTER),
        (b"MM\0+....", FileKind.RASTER),
        (b"BM......", FileKind.RASTER),
        (b"RIFF....WEBPVP8 ", FileKind.RASTER),
        (b"%PDF-1.4", FileKind.PDF),
        (b"\n\n  %PDF-1.4", FileKind.PDF),
        (SVG.encode(), FileKind.SVG),
        (b"\xef\xbb\xbf" + SVG.encode(), FileKind.SVG),
        (SVG.encode("utf-16"), FileKind.SVG),
        (b"<s:svg xmlns:s='http://www.w3.org/2000/svg'>", FileKind.SVG),
        (b"\x1f\x8b\x08", FileKind.SVG),
        (b"  0\r\nSECTION\r\n  2\r\nHEADER", FileKind.DXF),
        (b"999\nmade by hand\n0\nSECTION\n", FileKind.DXF),
        (b"AutoCAD Binary DXF\r\n\x1a\x00", FileKind.DXF),
        (b"plain text", FileKind.RASTER),
    ],
)
@pytest.mark.parametrize("suffix", ["", ".png", ".JPG"])
def test_the_content_decides(head: bytes, kind: FileKind, suffix: str) -> None:
    assert detect(head, suffix) is kind


@pytest.mark.parametrize(
    ("suffix", "kind"),
    [
        (".pdf", FileKind.PDF),
        (".SVG", FileKind.SVG),
        (".svgz", FileKind.SVG),
        (".dxf", FileKind.DXF),
        (".txt", FileKind.RASTER),
    ],
)
def test_the_name_decides_where_the_content_does_not(suffix: str, kind: FileKind) -> None:
    assert detect(b"what is this?", suffix) is kind


def test_formats_that_people_try() -> None:
    assert unsupported(b"AC1032....") == ("DWG", "save it as DXF")
    assert unsupported(b"%!PS-Adobe-3.0")[0] == "PostScript"
    assert unsupported(b"....ftypheic")[0] == "HEIC or AVIF"
    assert unsupported(b"\x89PNG\r\n\x1a\n") is None


def test_a_freecad_document_is_no_other_archive(tmp_path: Path) -> None:
    for names, is_one in (
        (("Document.xml", "PartShape.brp"), True),
        (("word/document.xml",), False),
        (("PartShape.brp", "Document.xml"), False),
    ):
        path = tmp_path / "a.FCStd"
        with zipfile.ZipFile(path, "w") as archive:
            for name in names:
                archive.writestr(name, "<Document/>")
        head = path.read_bytes()
        assert is_freecad_document(head) is is_one
        with pytest.raises(UnreadableError) as caught:
            head_of(path)
        assert caught.value.code == ("freecad-document" if is_one else "format-not-supported")
