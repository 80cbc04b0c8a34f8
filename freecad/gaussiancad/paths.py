"""Where the addon's own files are."""

from pathlib import Path

ADDON_ROOT = Path(__file__).resolve().parents[2]
ICONS = ADDON_ROOT / "resources" / "icons"
TRANSLATIONS = ADDON_ROOT / "resources" / "translations"
UI = ADDON_ROOT / "resources" / "ui"
CORE = ADDON_ROOT / "core"


def icon(name: str) -> str:
    """Path of the SVG icon ``name`` (without suffix)."""
    return str(ICONS / f"{name}.svg")
