"""``comparison.html``: one page that opens offline and needs nothing beside itself.

Its tables, histogram and picture are plain HTML and SVG; a script of its own turns the picture into
a view that can be turned.  A content security policy forbids it to load anything.
"""

import base64
import json
import platform
from dataclasses import dataclass
from html import escape
from importlib.resources import files
from pathlib import Path

from gaussiancad_core import __version__
from gaussiancad_core.comparison.comparison_report import Comparison
from gaussiancad_core.comparison.deviation import Deviation
from gaussiancad_core.comparison.page_geometry import page_geometry
from gaussiancad_core.comparison.page_tables import (
    deepcad_table,
    engineering_table,
    facts_table,
    histogram_svg,
    legend_html,
    millimetres,
    paper_table,
    worst_table,
)
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.storage.plain_files import plain_bytes

_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"

_WIDEST_OVERLAY = 1800
_OVERLAY_QUALITY = 88
_MOST_PIXELS = 150_000_000

_VIEWS = ("home", "front", "top", "right", "rear", "left", "bottom")


@dataclass(frozen=True, eq=False)
class PageParts:
    """What the page shows beside the numbers.

    Attributes:
        names: of the result and the reference.
        reference: its mesh, in its own coordinates.
        picture: PNG of the coloured result, for readers without a script or on paper.
        overlay: a picture with its MIME type, the sheet with the result's lines over it, or None.
    """

    names: tuple[str, str]
    reference: TriangleMesh
    picture: bytes
    overlay: tuple[str, bytes] | None = None


def comparison_page(comparison: Comparison, deviation: Deviation, parts: PageParts) -> bytes:
    """The whole page, UTF-8."""
    geometry = page_geometry(deviation, parts.reference)
    title = f"{parts.names[0]} against {parts.names[1]}"
    # In JSON "<" can only stand in a string, of which there is none.
    data = json.dumps(geometry.as_json(deviation), separators=(",", ":"), allow_nan=False)
    facts = comparison.deviation
    sections = [
        f"<h1>{escape(title)}</h1>",
        f"<p>{escape(_summary(comparison))}</p>",
        _warnings(comparison),
        "<h2>Deviation</h2>",
        _stage(comparison, parts.picture),
        _controls(),
        f'<p class="note">{escape(_drawn(deviation, geometry.result))}</p>',
        "<h2>How much of the surface</h2>",
        histogram_svg(facts.histogram, facts.range_mm),
        "<h2>Where it is worst</h2>",
        worst_table(facts.worst, facts.signed),
        "<h2>Measures</h2>",
        engineering_table(comparison.engineering) if comparison.engineering else "",
        paper_table(comparison),
        deepcad_table(comparison.deepcad) if comparison.deepcad else "",
        "<h2>Models</h2>",
        facts_table(comparison.result, comparison.reference),
        _overlay(parts.overlay),
        _made(comparison),
    ]
    body = "\n".join(section for section in sections if section)
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>\n{_asset('page.css')}</style>\n</head>\n<body>\n"
        f'<main>\n{body}\n</main>\n<script type="application/json" id="geometry">{data}</script>\n'
        f"<script>\n{_asset('viewer.js')}</script>\n</body>\n</html>\n"
    ).encode()


def overlay_beside(result: Path) -> tuple[str, bytes] | None:
    """``overlay.png`` in a result's folder, small enough for a page; None where there is none."""
    path = result.parent / "overlay.png"
    try:
        content = plain_bytes(path)
    except OSError:
        return None
    import cv2
    import numpy as np

    image = cv2.imdecode(np.frombuffer(content, dtype=np.uint8), cv2.IMREAD_COLOR)
    if image is None or image.shape[0] * image.shape[1] > _MOST_PIXELS:
        return None
    height, width = image.shape[:2]
    if width > _WIDEST_OVERLAY:
        size = (_WIDEST_OVERLAY, max(1, round(height * _WIDEST_OVERLAY / width)))
        image = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    _, packed = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, _OVERLAY_QUALITY])
    small = packed.tobytes()
    if width <= _WIDEST_OVERLAY and len(content) <= len(small):
        return "image/png", content
    return "image/jpeg", small


def _asset(name: str) -> str:
    return (files(__package__) / "assets" / name).read_text(encoding="utf-8")


def _summary(comparison: Comparison) -> str:
    facts, found = comparison.deviation, comparison.engineering
    scaled = "" if facts.scale == 1.0 else f", scaled by {facts.scale:.6g} to lie over it,"
    if facts.signed:
        inside, outside = min(facts.least_mm, 0.0), max(facts.greatest_mm, 0.0)
        words = (
            f"The result{scaled} lies up to {millimetres(abs(inside), False)} inside the "
            f"reference and up to {millimetres(outside, False)} outside."
        )
    else:
        far = millimetres(facts.greatest_mm, False)
        words = f"The result{scaled} lies up to {far} from the reference."
    if found is not None:
        start = "" if facts.scale == 1.0 else "As it is, "
        words += (
            f" {start}{100.0 * found.agreement:.2f} % of the surface agrees within "
            f"{found.tolerance_mm:.4g} mm."
        )
    return words


def _warnings(comparison: Comparison) -> str:
    items = "".join(
        f"<li>{escape(remark.message)} <code>{escape(remark.code)}</code></li>"
        for remark in comparison.warnings
    )
    return f'<ul class="warnings" role="note">{items}</ul>' if items else ""


def _stage(comparison: Comparison, picture: bytes) -> str:
    image = base64.b64encode(picture).decode("ascii")
    label = (
        "3D view of the deviation. Drag or use the arrow keys to turn, the wheel or + and - to "
        "zoom, Shift and drag to move; press Home for the first view."
    )
    return (
        '<div id="stage"><figure>'
        f'<img id="still" alt="The result in the colours of its deviation" '
        f'src="data:image/png;base64,{image}">'
        f'<canvas id="view" tabindex="0" role="img" aria-label="{label}" hidden></canvas>'
        f'<figcaption id="told" role="status"></figcaption></figure>'
        f"<div>{legend_html(comparison.deviation)}</div></div>"
    )


def _controls() -> str:
    buttons = " ".join(
        f'<button type="button" data-view="{name}">{name.capitalize()}</button>' for name in _VIEWS
    )
    axes = "".join(f'<option value="{axis}">across {axis.upper()}</option>' for axis in "xyz")
    return (
        f'<div id="controls" hidden><fieldset><legend>View</legend>{buttons}</fieldset>'
        '<fieldset><legend>Colours to</legend><label>± <input id="range" type="number" min="0" '
        'step="any"> mm</label> <input id="range-slider" type="range" min="-2000" max="1000" '
        'aria-label="Range of the colours"></fieldset>'
        '<fieldset><legend>Show</legend><label><input id="show-result" type="checkbox" checked> '
        'result</label> <label><input id="show-reference" type="checkbox"> reference</label>'
        '</fieldset><fieldset><legend>Section</legend><select id="axis" aria-label="Axis">'
        f'<option value="">none</option>{axes}</select> <input id="cut" type="range" min="0" '
        'max="1000" value="500" aria-label="Place of the section"> black: result, green: '
        "reference</fieldset></div>"
    )


def _drawn(deviation: Deviation, drawn: TriangleMesh) -> str:
    whole, part = len(deviation.mesh.triangles), len(drawn.triangles)
    if part >= whole:
        return "Click the part to read a deviation."
    return (
        f"Click the part to read a deviation. Drawn with {part:,} of {whole:,} triangles; all "
        "numbers are from all of them."
    )


def _overlay(overlay: tuple[str, bytes] | None) -> str:
    if overlay is None:
        return ""
    kind, content = overlay
    text = base64.b64encode(content).decode("ascii")
    return (
        "<h2>Sheet</h2>\n<figure>"
        '<img alt="The sheet with the lines of the result over it" '
        f'src="data:{kind};base64,{text}">'
        "<figcaption>The sheet that the result was made from, with its redrawn lines over it: "
        "blue agrees.</figcaption></figure>"
    )


def _made(comparison: Comparison) -> str:
    rows = "\n".join(
        " ".join(f"{value:12.6f}" for value in row) for row in comparison.matrix.tolist()
    )
    return (
        "<details><summary>How this was made</summary>"
        f"<p>GaussianCAD {escape(__version__)}, Python {platform.python_version()}, "
        f"seed {comparison.seed}. Result file to reference file, mm (gaussiancad):</p>"
        f"<pre>{rows}</pre></details>"
    )
