"""Names of the folders that the sheets of a batch get: safe on all file systems, each its own."""

import hashlib
import os
import re
import unicodedata
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

_UNSAFE = re.compile(r'[\x00-\x1f\x7f-\x9f\ud800-\udfff<>:"/\\|?*]')
"""Characters that some file system or shell does not take, and what is no text."""

_DEVICES = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\.|$)", re.IGNORECASE)
"""Names that Windows keeps for devices, with any suffix."""

_OWN = (".csv", ".html", ".json", ".sqlite", ".fcstd", ".step", ".stl")
"""Suffixes of the files that a batch writes beside the folders."""

_LONGEST = 100
"""Bytes of a name at most, without what makes it unique: file systems take 255."""

_DIGITS = (8, 16, 64)
"""Hexadecimal digits of a path's hash; more where names are still one."""


def folder_names(sheets: Sequence[Path]) -> list[str]:
    """A name for each sheet: a safe form of its stem, which leads out of no folder.

    Where names are one, but for case or the way accents are written, the hash of the path follows;
    the order of the sheets does not matter.  The stem is that of :func:`os.path.splitext`, the same
    in every Python (that of ``pathlib`` is another one for ``...png`` from 3.14 on).

    Args:
        sheets: different ones.
    """
    stems = [safe_name(os.path.splitext(sheet.name)[0]) for sheet in sheets]
    names = stems
    for digits in _DIGITS:
        count = Counter(map(_folded, names))
        names = [
            name if count[_folded(name)] == 1 else f"{stem}-{_hash(sheet, digits)}"
            for name, stem, sheet in zip(names, stems, sheets, strict=True)
        ]
    return names


def safe_name(stem: str) -> str:
    """The stem without what is not safe: never empty, hidden, an option, or a way elsewhere."""
    name = _UNSAFE.sub("_", unicodedata.normalize("NFC", stem))
    name = name.encode("utf-8")[:_LONGEST].decode("utf-8", "ignore").rstrip(" .")
    if not name or name[0] in ".-~ " or _DEVICES.match(name):
        name = f"_{name.lstrip(' .')}"
    return f"{name}_" if name.casefold().endswith(_OWN) else name


def _folded(name: str) -> str:
    return unicodedata.normalize("NFC", name.casefold())


def _hash(sheet: Path, digits: int) -> str:
    path = os.fsencode(os.path.abspath(sheet))
    return hashlib.sha256(path).hexdigest()[:digits]
