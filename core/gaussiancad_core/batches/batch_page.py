"""``index.html``: the sheets of a batch with their pictures, for a browser without a network."""

from collections import Counter
from collections.abc import Sequence
from html import escape
from pathlib import Path
from urllib.parse import quote

from gaussiancad_core.batches.batch_table import BatchRow

PAGE_FILE = "index.html"

_POLICY = "default-src 'none'; img-src 'self' file:; style-src 'unsafe-inline'"

_KINDS = ("verified", "approximate", "failed")

_STYLE = """
body { font: 15px/1.4 sans-serif; margin: 2em; color: #222; background: #fff }
table { border-collapse: collapse; width: 100% }
th, td { text-align: left; vertical-align: top; padding: .4em .6em; border-top: 1px solid #ccc }
img { max-width: 15em; max-height: 10em }
label { margin-right: 1.5em }
.verified b { color: #1a7f37 } .approximate b { color: #9a6700 } .failed b { color: #b42318 }
@media (prefers-color-scheme: dark) { body { color: #ddd; background: #1b1b1b } }
"""


def page_bytes(rows: Sequence[BatchRow]) -> bytes:
    """The page, UTF-8.

    Args:
        rows: of the batch; their pictures are beside the page, in the folders of their names.
    """
    counts = Counter(row.status for row in rows)
    hidden = "".join(
        f"#no-{kind}:not(:checked) ~ table .{kind} {{ display: none }}\n" for kind in _KINDS
    )
    boxes = "".join(
        f'<input type="checkbox" id="no-{kind}" checked>'
        f'<label for="no-{kind}">{counts[kind]} {kind}</label>'
        for kind in _KINDS
    )
    seconds = sum(row.seconds for row in rows)
    page = f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{_POLICY}">
<title>GaussianCAD batch: {len(rows)} sheets</title>
<style>{_STYLE}{hidden}</style></head><body>
<h1>{len(rows)} sheets</h1>
<p>{seconds:.0f} s of work in all. Status speaks of the shape; measures are how well its faces'
places are known.</p>
{boxes}
<table><thead><tr><th>sheet</th><th>status</th><th>measures</th><th>model</th>
<th>on the sheet</th></tr></thead>
<tbody>
{"".join(map(_line, rows))}</tbody></table></body></html>
"""
    return page.encode("utf-8", "backslashreplace")


def _line(row: BatchRow) -> str:
    kind = row.status if row.status in _KINDS else "failed"
    measures = f"to ±{row.measures_mm} mm" if row.measures_mm else ""
    message = f"<br>{escape(row.message)}" if row.message else ""
    pictures = "".join(f"<td>{_picture(row, name)}</td>" for name in ("preview.png", "overlay.png"))
    folder = quote(row.name)
    return (
        f'<tr class="{kind}"><td><a href="{folder}/">{escape(row.name)}</a><br>'
        f"<small>{escape(row.sheet)}</small></td><td><b>{escape(row.status)}</b>{message}</td>"
        f"<td>{escape(measures)}</td>{pictures}</tr>\n"
    )


def _picture(row: BatchRow, name: str) -> str:
    if row.exit_code or not (Path(row.folder) / name).is_file():
        return ""
    path = f"{quote(row.name)}/{name}"
    return f'<a href="{path}"><img src="{path}" loading="lazy" alt="{escape(row.name)}"></a>'
