"""A page that shows which published drawings failed, by the first stage that went wrong."""

from collections.abc import Callable, Sequence
from html import escape
from pathlib import Path
from urllib.parse import quote

from benchmarks.run.workers import Row

PAGE = "index.html"

_ORDER = ("file", "views", "roles", "strokes", "scale", "time", "solid", "part", "")

_PICTURES = ("reading.png", "overlay.png", "preview.png")

_STYLE = """
body { font: 14px/1.4 sans-serif; margin: 2em } img { max-width: 24em; max-height: 18em }
td { vertical-align: top; padding: .4em; border-top: 1px solid #ccc }
"""


def write_page(folder: Path, rows: Sequence[Row], failed_at: Callable[[Row], str]) -> None:
    """Write the page into the folder that holds ``SOURCE/NAME/`` of each row."""
    ordered = sorted(rows, key=lambda row: _ORDER.index(failed_at(row)))
    lines = "".join(_line(folder, row, failed_at(row)) for row in ordered)
    page = "<!DOCTYPE html><meta charset=utf-8><title>Published drawings</title>"
    page += f"<style>{_STYLE}</style><table>{lines}</table>"
    (folder / PAGE).write_text(page, encoding="utf-8")


def _line(folder: Path, row: Row, stage: str) -> str:
    item = f"{row['source']}/{row['name']}"
    pictures = "".join(
        f'<td><a href="{quote(item)}/{name}"><img src="{quote(item)}/{name}" loading=lazy></a>'
        for name in _PICTURES
        if (folder / item / name).is_file()
    )
    facts = [
        f"views {', '.join(row.get('views', ())) or 'none'}",
        f"strokes {row['strokes'][0]:.3f} / {row['strokes'][1]:.3f}" if "strokes" in row else "",
        f"IoU {row['iou']:.4f}" if "iou" in row else "no solid",
        ", ".join(row.get("reasons", ())) or row.get("error", ""),
    ]
    stated = "<br>".join(escape(fact) for fact in facts if fact)
    return f"<tr><td><b>{escape(item)}</b><br>{stage or 'the part'}<td>{stated}{pictures}\n"
