"""The fonts of the writing: OpenCV's own, and those that the system has."""

import random
import re
from dataclasses import dataclass
from functools import cache, lru_cache
from pathlib import Path

import cv2
from PIL import ImageFont

_FOLDERS = (
    Path("/usr/share/fonts"),
    Path("/usr/local/share/fonts"),
    Path.home() / ".fonts",
    Path.home() / ".local/share/fonts",
    Path("/Library/Fonts"),
    Path("C:/Windows/Fonts"),
)
"""Where systems keep their fonts."""

_SUFFIXES = (".ttf", ".otf", ".ttc")
"""Of their files."""

_NO_LETTERS = re.compile(
    "symbol|dingbat|emoji|icon|awesome|math|cmex|cmsy|cmmi|msam|msbm|rsfs|wasy|stmary|esint|"
    "braille|barcode|music|mathjax",
    re.IGNORECASE,
)
"""Names of fonts in which a letter's place has something else."""

_HAN = re.compile("cjk|hansans|hanserif|simhei|simsun|wqy|noto.*sc", re.IGNORECASE)
"""Names of fonts with Chinese characters."""

HERSHEY = (
    cv2.FONT_HERSHEY_SIMPLEX,
    cv2.FONT_HERSHEY_SIMPLEX,
    cv2.FONT_HERSHEY_PLAIN,
    cv2.FONT_HERSHEY_DUPLEX,
    cv2.FONT_HERSHEY_COMPLEX_SMALL,
)
"""OpenCV's, those of single lines more often, as on drawings."""

_PROBE_PX = 24
"""Size in which it is looked what a font has."""


@dataclass(frozen=True)
class Fonts:
    """TrueType fonts.

    Attributes:
        plain: files of fonts with Latin letters.
        han: files of fonts with Chinese characters, too.
    """

    plain: tuple[Path, ...]
    han: tuple[Path, ...]

    def any(self, chance: random.Random) -> Path | None:
        """One of the plain ones, or none where there are none."""
        return chance.choice(self.plain) if self.plain else None


@cache
def system_fonts() -> Fonts:
    """The fonts of this system, in the order of their paths."""
    files = [
        path
        for folder in _FOLDERS
        if folder.is_dir()
        for path in sorted(folder.rglob("*"))
        if path.suffix.lower() in _SUFFIXES and not _NO_LETTERS.search(path.name)
    ]
    lettered = [path for path in files if _has_letters(path)]
    return Fonts(
        tuple(path for path in lettered if not _HAN.search(path.name)),
        tuple(path for path in lettered if _HAN.search(path.name)),
    )


def font_names() -> tuple[str, ...]:
    """Names of the fonts that sheets are lettered in on this system."""
    found = system_fonts()
    return ("Hershey", *sorted({path.stem for path in (*found.plain, *found.han)}))


@lru_cache(maxsize=200)
def opened(path: Path, px: int) -> ImageFont.FreeTypeFont:
    """A font in a size."""
    return ImageFont.truetype(str(path), px)


@lru_cache(maxsize=4000)
def has(path: Path, character: str) -> bool:
    """Whether a font has a character: those that it lacks all look alike."""
    font = opened(path, _PROBE_PX)
    return bytes(font.getmask(character)) != bytes(font.getmask("\U0010fffd"))


def _has_letters(path: Path) -> bool:
    try:
        font = opened(path, _PROBE_PX)
        looks = {bytes(font.getmask(character)) for character in "AB17"}
    except (OSError, ValueError):
        return False
    return len(looks) == 4 and all(any(look) for look in looks)
