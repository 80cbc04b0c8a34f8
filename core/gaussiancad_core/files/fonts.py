"""A font to draw texts with: the first of a few common ones that is installed.

One known font keeps the drawing the same wherever it is installed, and spares reading all others.
"""

import os
from functools import cache
from pathlib import Path

_FONTS = {
    "DejaVuSans.ttf": "DejaVu Sans",
    "LiberationSans-Regular.ttf": "Liberation Sans",
    "arial.ttf": "Arial",
    "NotoSans-Regular.ttf": "Noto Sans",
    "FreeSans.ttf": "FreeSans",
    "FreeSans.otf": "FreeSans",
    "Ubuntu-R.ttf": "Ubuntu",
    "Verdana.ttf": "Verdana",
}
"""File names and the families in them, the preferred one first."""


def _folders() -> list[Path]:
    home = Path.home()
    windows = Path(os.environ.get("WINDIR", r"C:\Windows")) / "Fonts"
    return [
        Path("/usr/share/fonts"),
        Path("/usr/local/share/fonts"),
        home / ".local/share/fonts",
        home / ".fonts",
        Path("/System/Library/Fonts"),
        Path("/Library/Fonts"),
        windows,
    ]


@cache
def known_font() -> tuple[str, str] | None:
    """File and family of a font; None if no known one is installed."""
    rank = {name.casefold(): index for index, name in enumerate(_FONTS)}
    found: dict[int, str] = {}
    for folder in _folders():
        for parent, _, names in os.walk(folder):
            for name in names:
                if name.casefold() in rank:
                    found.setdefault(rank[name.casefold()], str(Path(parent) / name))
    if not found:
        return None
    best = min(found)
    return found[best], list(_FONTS.values())[best]
