"""Make the pictures of the tutorial and of the README in FreeCAD's window, on a virtual screen.

    make tutorial

FreeCAD starts with a profile of its own, so that a user's does not count.  What happens in its
window is in ``tutorial_window.py``.  The engine is that in ``.venv``, or GAUSSIANCAD_PYTHON's.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

ADDON = Path(__file__).resolve().parents[1]
WINDOW = ADDON / "scripts" / "tutorial_window.py"
SHEETS = ("1-whole", "2-lines-missing", "3-views-moved")

WIDTH, HEIGHT = 1400, 860
"""px of the screen, which the window fills."""

TIME_LIMIT_SECONDS = 540

_OF_README = ("canvas.png", "film-strip.png")

FRAME_WIDTH = 700
"""px of a picture of the film strip."""

_SETTINGS = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters>
  <FCParamGroup Name="Root">
    <FCParamGroup Name="BaseApp">
      <FCParamGroup Name="Preferences">
        <FCParamGroup Name="General">
          <FCText Name="AutoloadModule">PartWorkbench</FCText>
          <FCText Name="Language">English</FCText>
          <FCBool Name="ShowSplasher" Value="0"/>
        </FCParamGroup>
        <FCParamGroup Name="Mod">
          <FCParamGroup Name="Start">
            <FCBool Name="ShowOnStartup" Value="0"/>
          </FCParamGroup>
        </FCParamGroup>
        <FCParamGroup Name="OutputWindow">
          <FCBool Name="checkShowReportViewOnError" Value="0"/>
          <FCBool Name="checkShowReportViewOnWarning" Value="0"/>
        </FCParamGroup>
      </FCParamGroup>
    </FCParamGroup>
  </FCParamGroup>
</FCParameters>
"""
"""No start page, and no report view that opens by itself."""


def take_pictures(profile: Path, pictures: Path) -> int:
    """Have the window write its pictures into a folder; the exit status of FreeCAD.

    Args:
        profile: an empty folder for FreeCAD's settings and the sheets.
        pictures: an empty folder.
    """
    (profile / "Mod").mkdir()
    (profile / "Mod" / "GaussianCAD").symlink_to(ADDON, target_is_directory=True)
    (profile / "user.cfg").write_text(_SETTINGS, encoding="utf-8")
    sheets = profile / "sheets"
    sheets.mkdir()
    for name in SHEETS:
        shutil.copy(ADDON / "docs" / "tutorial" / f"{name}.png", sheets)
    engine = os.environ.get("GAUSSIANCAD_PYTHON") or str(ADDON / ".venv" / "bin" / "python")
    variables = {
        **os.environ,
        "FREECAD_USER_HOME": str(profile),
        "GAUSSIANCAD_PYTHON": engine,
        "GAUSSIANCAD_PICTURES": str(pictures),
        "GAUSSIANCAD_SHEETS": str(sheets),
        "LC_ALL": "C.UTF-8",
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    screen = ("xvfb-run", "-a", "-s", f"-screen 0 {WIDTH}x{HEIGHT}x24")
    ended = subprocess.run(
        [*screen, "freecad", str(WINDOW)],
        env=variables,
        stdin=subprocess.DEVNULL,
        timeout=TIME_LIMIT_SECONDS,
        check=False,
    )
    return ended.returncode


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
