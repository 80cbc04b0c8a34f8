"""Tell the kind of a file by its first bytes; its name counts only where they say nothing."""

import codecs
import re
from enum import Enum

from gaussiancad_protocol.codes import Code

HEAD_BYTES = 4096
"""How much of a file :func:`detect` wants to see."""


GZIP_MAGIC = b"\x1f\x8b"
"""Of the compressed files that sheets are read from, only SVG ones exist."""


class FileKind(Enum):
    """Formats that sheets are read from."""

    RASTER = "raster"
    PDF = "pdf"
    SVG = "svg"
    DXF = "dxf"

    @property
    def damaged(self) -> str:
        """Code of the error of a file that is broken."""
        return Code.DAMAGED_IMAGE if self is FileKind.RASTER else f"damaged-{self.value}"


VECTOR_SUFFIXES = {
    ".pdf": FileKind.PDF,
    ".svg": FileKind.SVG,
    ".svgz": FileKind.SVG,
    ".dxf": FileKind.DXF,
}

_RASTER_MAGIC = (
    b"\x89PNG\r\n\x1a\n",
    b"\xff\xd8\xff",
    b"II*\0",
    b"MM\0*",
    b"II+\0",
    b"MM\0+",
    b"BM",
)

_SVG_TAG = re.compile(r"<(?:\w+:)?svg[\s>]")

_UNSUPPORTED = (
    (b"AC10", "DWG", "save it as DXF"),
    (b"%!PS", "PostScript", "save it as PDF"),
    (b"GIF8", "GIF", "save it as PNG"),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "Office or CAD part", "export the drawing as PDF"),
    (b"PK\x03\x04", "ZIP or Office", "take the drawing out of it"),
    (b"ISO-10303-21", "STEP", "draw a sheet of it with `gaussiancad draw`"),
)
"""First bytes, name and advice of formats that people try."""


def detect(head: bytes, suffix: str) -> FileKind:
    """The kind of a file.

    Args:
        head: its first bytes.
        suffix: of its name, with the dot, in any case; decides only where the bytes do not.
    """
    text = _as_text(head).lstrip()
    if head.startswith(_RASTER_MAGIC) or (head[:4] == b"RIFF" and head[8:12] == b"WEBP"):
        return FileKind.RASTER
    if b"%PDF-" in head[:1024]:
        return FileKind.PDF
    if head.startswith(GZIP_MAGIC) or (text.startswith("<") and _SVG_TAG.search(text)):
        return FileKind.SVG
    if head.startswith(b"AutoCAD Binary DXF") or _starts_like_dxf(text):
        return FileKind.DXF
    return VECTOR_SUFFIXES.get(suffix.lower(), FileKind.RASTER)


def unsupported(head: bytes) -> tuple[str, str] | None:
    """Name of a known format that is not read, and what to do instead; None for any other file."""
    for magic, name, advice in _UNSUPPORTED:
        if head.startswith(magic):
            return name, advice
    if head[4:12] in (b"ftypheic", b"ftypheix", b"ftypmif1", b"ftypavif"):
        return "HEIC or AVIF", "save it as PNG"
    return None


def is_freecad_document(head: bytes) -> bool:
    """Whether a file is a document of FreeCAD: an archive that begins with its ``Document.xml``."""
    return head.startswith(b"PK\x03\x04") and head[30:42] == b"Document.xml"


def _as_text(head: bytes) -> str:
    if head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return head.decode("utf-16", errors="replace")
    return head.removeprefix(codecs.BOM_UTF8).decode("latin-1")


def _starts_like_dxf(text: str) -> bool:
    """Whether the first tags are comments and the start of a section."""
    lines = [line.strip() for line in text.split("\n")[:200]]
    index = 0
    while index + 1 < len(lines) and lines[index] == "999":
        index += 2
    return lines[index : index + 2] == ["0", "SECTION"]
