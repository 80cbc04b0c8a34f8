"""Make the sheets of the tutorial from the sample sheet: one lacks two lines, and on one the views
do not line up.

    .venv/bin/python scripts/tutorial_sheets.py docs/tutorial
"""

import sys
from pathlib import Path

from PIL import Image, ImageDraw

SAMPLE = Path(__file__).resolve().parents[1] / "resources" / "samples" / "l-bracket.png"

FRONT, TOP, RIGHT = (424, 547, 1029, 1001), (424, 79, 1029, 458), (1118, 547, 1496, 1001)
"""Where the sample's views are, px."""

MISSING = ((741, 913, 741, 996), (892, 913, 892, 996))
"""The hidden lines of the hole in the foot, in the front view."""

MOVED = ((FRONT, (0, 0)), (TOP, (130, -20)), (RIGHT, (80, -170)))
"""The views, and by how much each is moved."""

_AROUND = 6
"""px of white around lines."""


def without_lines(sheet: Image.Image) -> Image.Image:
    """The sheet without the lines in ``MISSING``."""
    found = sheet.copy()
    pen = ImageDraw.Draw(found)
    for x0, y0, x1, y1 in MISSING:
        pen.rectangle((x0 - _AROUND, y0, x1 + _AROUND, y1), fill=255)
    return found


def with_moved_views(sheet: Image.Image) -> Image.Image:
    """The sheet with its views where ``MOVED`` puts them."""
    found = Image.new("L", sheet.size, 255)
    for (x0, y0, x1, y1), (right, down) in MOVED:
        box = x0 - _AROUND, y0 - _AROUND, x1 + _AROUND, y1 + _AROUND
        found.paste(sheet.crop(box), (box[0] + right, box[1] + down))
    return found


def main() -> None:
    """Write the sheets into the folder that the argument names."""
    folder = Path(sys.argv[1])
    sheet = Image.open(SAMPLE).convert("L")
    for name, item in (
        ("1-whole", sheet),
        ("2-lines-missing", without_lines(sheet)),
        ("3-views-moved", with_moved_views(sheet)),
    ):
        item.save(folder / f"{name}.png", optimize=True)


if __name__ == "__main__":
    main()
