"""Whether files of a batch are whole: not links, not cut off, not damaged."""

import json
import zipfile
import zlib
from pathlib import Path
from xml.etree import ElementTree

_DOCUMENT = "Document.xml"

_REPORT = "ReportJson"
"""Property of a reconstruction that holds the engine's report as it was written."""

_STEP_END = b"END-ISO-10303-21;"

_STL_HEAD, _STL_FACET = 84, 50
"""Bytes before the triangles of a binary STL file, the last four their number; of a triangle."""

_TAIL = 256
"""Bytes in which the end of a text file is looked for."""

_DAMAGED = (
    OSError,
    EOFError,
    ValueError,
    LookupError,
    RuntimeError,
    zipfile.BadZipFile,
    zlib.error,
    ElementTree.ParseError,
)


def is_whole_document(path: Path, report: str) -> bool:
    """Whether every part of a document has its checksum, and a reconstruction in it this report.

    What people have added to it does not matter.

    Args:
        path: of an FCStd file.
        report: the engine's ``report.json`` as text.
    """
    if not _is_file(path):
        return False
    try:
        with zipfile.ZipFile(path) as archive:
            if archive.testzip() is not None:
                return False
            root = ElementTree.fromstring(archive.read(_DOCUMENT))
        values = root.iterfind(f".//Property[@name='{_REPORT}']/String")
        wanted = json.loads(report)
        return any(json.loads(value.get("value", "")) == wanted for value in values)
    except _DAMAGED:
        return False


def has_body(path: Path) -> bool:
    """Whether a document has a body of PartDesign."""
    try:
        with zipfile.ZipFile(path) as archive:
            root = ElementTree.fromstring(archive.read(_DOCUMENT))
    except _DAMAGED:
        return False
    return root.find(".//Object[@type='PartDesign::Body']") is not None


def is_whole_step(path: Path) -> bool:
    """Whether a STEP file has its end."""
    return _is_file(path) and _STEP_END in _tail(path)


def is_whole_stl(path: Path) -> bool:
    """Whether an STL file, binary or text, has all of its triangles."""
    if not _is_file(path):
        return False
    with path.open("rb") as file:
        head = file.read(_STL_HEAD)
    count = int.from_bytes(head[80:], "little")
    if len(head) == _STL_HEAD and path.stat().st_size == _STL_HEAD + _STL_FACET * count:
        return count > 0
    return head.startswith(b"solid") and b"endsolid" in _tail(path)


def _is_file(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()


def _tail(path: Path) -> bytes:
    with path.open("rb") as file:
        file.seek(max(path.stat().st_size - _TAIL, 0))
        return file.read()
