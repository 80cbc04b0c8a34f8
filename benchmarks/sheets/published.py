"""Published sheets with their true parts, in a folder for each source."""

from pathlib import Path

SUFFIXES = (".pdf", ".png", ".jpg", ".dxf")

SAME_IOU = 0.99
"""Volumes of which this share is common are one part, drawn to some hundredths of a millimetre."""


def sheets_of(folder: Path) -> list[Path]:
    """Sheets that have their part beside them, by source and name."""
    return sorted(
        path
        for path in folder.glob("*/*")
        if path.suffix.lower() in SUFFIXES and path.with_suffix(".step").is_file()
    )
