"""Make the pictures of the tutorial and of the README in FreeCAD's window, on a virtual screen.

    make tutorial

What happens in the window is in ``tutorial_window.py``, and how it is started in
``freecad_window.py``.
"""

import shutil
import sys
import tempfile
from pathlib import Path

from freecad_window import ADDON, run_in_window
from PIL import Image

WINDOW = ADDON / "scripts" / "tutorial_window.py"
SHEETS = ("1-whole", "2-lines-missing", "3-views-moved")

TIME_LIMIT_SECONDS = 540

_OF_README = ("canvas.png", "film-strip.png")

FRAME_WIDTH = 700
"""px of a picture of the film strip."""


def take_pictures(profile: Path, pictures: Path) -> int:
    """Have the window write its pictures into a folder; the exit status of FreeCAD.

    Args:
        profile: an empty folder for FreeCAD's settings.
        pictures: an empty folder; the sheets are copied into one at its side.
    """
    sheets = pictures.with_name("sheets")
    sheets.mkdir()
    for name in SHEETS:
        shutil.copy(ADDON / "docs" / "tutorial" / f"{name}.png", sheets)
    variables = {"GAUSSIANCAD_PICTURES": str(pictures), "GAUSSIANCAD_SHEETS": str(sheets)}
    return run_in_window(WINDOW, profile, variables, TIME_LIMIT_SECONDS)


def film_strip(pictures: list[Path]) -> Image.Image:
    """Pictures in rows of two, in the order of their names, from left to right."""
    frames = [Image.open(path).convert("RGB") for path in pictures]
    height = round(FRAME_WIDTH * frames[0].height / frames[0].width)
    gap = 8
    rows = (len(frames) + 1) // 2
    strip = Image.new("RGB", (2 * FRAME_WIDTH + gap, rows * (height + gap) - gap), "white")
    for number, frame in enumerate(frames):
        row, column = divmod(number, 2)
        small = frame.resize((FRAME_WIDTH, height), Image.Resampling.LANCZOS)
        strip.paste(small, (column * (FRAME_WIDTH + gap), row * (height + gap)))
    return strip


def main() -> int:
    """Make the pictures and put them, small, into the documentation."""
    with tempfile.TemporaryDirectory(prefix="gaussiancad-tutorial-") as folder:
        profile, pictures = Path(folder) / "profile", Path(folder) / "pictures"
        profile.mkdir()
        pictures.mkdir()
        status = take_pictures(profile, pictures)
        strip = sorted(pictures.glob("film-*.png"))
        if strip:
            film_strip(strip).save(pictures / "film-strip.png")
        for path in sorted(set(pictures.glob("*.png")) - set(strip)):
            place = "images" if path.name in _OF_README else "tutorial"
            target = ADDON / "docs" / place / path.name
            Image.open(path).convert("RGB").save(target, optimize=True)
            print(f"{target.relative_to(ADDON)}: {target.stat().st_size // 1024} KB", flush=True)
    return status


if __name__ == "__main__":
    sys.exit(main())
