"""``comparison.html``: one page that opens offline and needs nothing beside itself.

Its tables, histogram and picture are plain HTML and SVG; a script of its own turns the picture into
a view that can be turned.  A content security policy forbids it to load anything.  What it says
stands in the template ``assets/comparison.html``.
"""

import base64
import json
import platform
from dataclasses import dataclass
from pathlib import Path

from gaussiancad_core import __version__
from gaussiancad_core.comparison.comparison_report import Comparison
from gaussiancad_core.comparison.deviation import Deviation
from gaussiancad_core.comparison.page_geometry import page_geometry
from gaussiancad_core.comparison.page_plots import colour_scale, histogram_plot
from gaussiancad_core.comparison.page_tables import (
    deepcad_table,
    engineering_table,
    facts_table,
    millimetres,
    paper_table,
    worst_points,
)
from gaussiancad_core.files.content import MAX_PIXELS
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.report.html_pages import html_page
from gaussiancad_core.storage.plain_files import plain_bytes

_WIDEST_OVERLAY = 1800
_OVERLAY_QUALITY = 88


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
    facts = comparison.deviation
    measures = (
        engineering_table(comparison.engineering) if comparison.engineering else None,
        paper_table(comparison),
        deepcad_table(comparison.deepcad) if comparison.deepcad else None,
    )
    return html_page(
        __package__,
        "comparison.html",
        title=f"{parts.names[0]} against {parts.names[1]}",
        summary=_summary(comparison),
        warnings=comparison.warnings,
        picture=_data_url("image/png", parts.picture),
        legend=colour_scale(facts),
        drawn=len(geometry.result.triangles),
        triangles=len(deviation.mesh.triangles),
        plot=histogram_plot(facts.histogram, facts.range_mm),
        worst=worst_points(facts.worst, facts.signed),
        measures=[table for table in measures if table],
        models=facts_table(comparison.result, comparison.reference),
        overlay=_data_url(*parts.overlay) if parts.overlay else "",
        version=__version__,
        python=platform.python_version(),
        seed=comparison.seed,
        matrix="\n".join(
            " ".join(f"{value:12.6f}" for value in row) for row in comparison.matrix.tolist()
        ),
        # In JSON "<" can only stand in a string, of which there is none.
        geometry=json.dumps(geometry.as_json(deviation), separators=(",", ":"), allow_nan=False),
    )


def overlay_of_result(result: Path) -> tuple[str, bytes] | None:
    """``overlay.png`` in a result's folder, small enough for a page; None where there is none."""
    path = result.parent / "overlay.png"
    try:
        content = plain_bytes(path)
    except OSError:
        return None
    import cv2
    import numpy as np

    image = cv2.imdecode(np.frombuffer(content, dtype=np.uint8), cv2.IMREAD_COLOR)
    if image is None or image.shape[0] * image.shape[1] > MAX_PIXELS:
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


def _data_url(kind: str, content: bytes) -> str:
    return f"data:{kind};base64,{base64.b64encode(content).decode('ascii')}"


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
