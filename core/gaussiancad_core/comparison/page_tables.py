"""The tables and plots of a comparison's page, as plain HTML and SVG that need no script."""

from collections.abc import Sequence
from html import escape

import numpy as np
import numpy.typing as npt

from gaussiancad_core.comparison.comparison_report import Comparison, DeviationFacts, ModelFacts
from gaussiancad_core.comparison.deepcad import DeepCadResult
from gaussiancad_core.comparison.deviation import diverging_colours
from gaussiancad_core.comparison.distances import VolumeIou
from gaussiancad_core.comparison.engineering import NORMAL_ANGLE, EngineeringResult
from gaussiancad_core.comparison.findings import Histogram, WorstPoint
from gaussiancad_core.comparison.model_files import Content

_PLOT = (720, 190)
_MARGINS = (54, 12, 30)
"""Left, top and bottom of the histogram's axes, px."""

_DECIMALS = 9
"""Of lengths in mm."""


def millimetres(value: float, signed: bool = True) -> str:
    """A length with its sign and unit; what is rounding is nothing."""
    value = round(value, _DECIMALS)
    # Adding zero turns a negative zero into a positive one.
    return f"{value + 0.0:+.4g} mm" if signed and value else f"{abs(value):.4g} mm"


def table(caption: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table whose first column holds the rows' headings; the cells are HTML already."""
    top = "".join(
        f'<th scope="col"{_number(column)}>{escape(name)}</th>' for column, name in enumerate(head)
    )
    body = "\n".join(
        f'<tr><th scope="row">{row[0]}</th>'
        + "".join(f'<td class="number">{cell}</td>' for cell in row[1:])
        + "</tr>"
        for row in rows
    )
    return (
        f'<div class="wide"><table><caption>{escape(caption)}</caption>\n'
        f"<thead><tr>{top}</tr></thead>\n<tbody>\n{body}\n</tbody></table></div>"
    )


def paper_table(comparison: Comparison) -> str:
    """The numbers of the protocol ``gaussiancad``."""
    distances, floor, unit = comparison.distances, comparison.floor, comparison.unit_mm
    rows = [
        ("Chamfer distance", distances.chamfer, floor.chamfer),
        ("Hausdorff distance", distances.hausdorff, floor.hausdorff),
        (f"EMD ({escape(comparison.emd_method)})", distances.emd, floor.emd),
        ("Point to surface", comparison.point_to_surface, 0.0),
    ]
    cells = [
        (name, f"{value:.5f}", f"{least:.5f}", f"{value * unit:.5g}") for name, value, least in rows
    ]
    cells.append(("Volume IoU", _iou(comparison.volume_iou), "1", ""))
    caption = f"{comparison.name}; {comparison.points:,} points, seed {comparison.seed}"
    return table(caption, ("gaussiancad", "Units", "Floor", "Millimetres"), cells)


def deepcad_table(found: DeepCadResult) -> str:
    """The numbers of the protocol ``deepcad``."""
    rows = [
        (
            "Chamfer distance × 1000",
            f"{found.chamfer_x1000:.5f}",
            f"{found.floor_x1000:.5f}",
        ),
        ("Volume IoU", _iou(found.volume_iou), "1"),
        ("Valid", "yes" if found.invalid is None else f"no: {escape(found.invalid)}", ""),
    ]
    caption = f"unit cube, {found.points:,} points, squared distances, no registration"
    return table(f"{caption}; seed {found.seed}", ("deepcad", "Value", "Floor"), rows)


def engineering_table(found: EngineeringResult) -> str:
    """The numbers of the protocol ``engineering``."""
    both = (found.result_to_reference, found.reference_to_result)
    rows: list[tuple[str, ...]] = [
        ("Mean", *(millimetres(each.mean, each.signed) for each in both)),
        ("Mean size", *(millimetres(each.mean_absolute, False) for each in both)),
        ("Root mean square", *(millimetres(each.rms, False) for each in both)),
        ("Farthest inside", *(millimetres(min(each.least, 0.0)) for each in both)),
        ("Farthest outside", *(millimetres(max(each.greatest, 0.0), each.signed) for each in both)),
    ]
    rows += [
        (f"{share} % lie below", *(millimetres(each.percentiles[share], False) for each in both))
        for share in both[0].percentiles
    ]
    rows.append(("Surface that agrees", *(f"{100.0 * each.within:.2f} %" for each in both)))
    rows.append(("Volume difference", _difference(found.volume_mm3, found.volume_share, 3), ""))
    rows.append(("Area difference", _difference(found.area_mm2, found.area_share, 2), ""))
    rows.append(("Volume IoU", _iou(found.volume_iou), ""))
    caption = (
        f"millimetres, {found.points:,} points, seed {found.seed}; agrees: within "
        f"{found.tolerance_mm:.4g} mm, normals within {NORMAL_ANGLE:g} degrees; curved exact "
        f"surfaces are drawn within {found.floor_mm:.2g} mm"
    )
    return table(caption, ("engineering", "Of the result", "Of the reference"), rows)


def facts_table(result: ModelFacts, reference: ModelFacts) -> str:
    """What both files hold."""
    both = (result, reference)
    rows = [
        ("Size", *(" × ".join(f"{edge:.6g}" for edge in each.extent_mm) + " mm" for each in both)),
        ("Volume", *(_quantity(each.volume_mm3, "mm³") for each in both)),
        ("Area", *(_quantity(each.area_mm2, "mm²") for each in both)),
        ("Bodies, through holes, cavities", *(_betti(each) for each in both)),
        ("Faces", *("–" if each.faces is None else str(each.faces) for each in both)),
        ("Triangles", *(f"{each.triangles:,}" for each in both)),
        ("Solid", *(_soundness(each) for each in both)),
    ]
    return table("What the files hold", ("Models", "Result", "Reference"), rows)


def worst_table(worst: Sequence[WorstPoint], signed: bool) -> str:
    """The worst points, each a button that the viewer listens to."""
    if not worst:
        return '<p class="note">No point of either surface lies beside the other.</p>'
    rows = []
    for number, each in enumerate(worst, 1):
        place = ", ".join(f"{value:.4g}" for value in each.point_mm)
        exact = ",".join(f"{value:.9g}" for value in each.point_mm)
        amount = millimetres(each.deviation_mm, signed)
        button = (
            f'<button type="button" data-point="{exact}" data-value="{each.deviation_mm:.9g}">'
            f"Point {number}</button>"
        )
        rows.append((button, amount, f"({place}) mm", _meaning(each)))
    head = ("Worst points", "Deviation", "Place", "What lies there")
    return table("The farthest points that lie apart; press one to see it", head, rows)


def histogram_svg(histogram: Histogram, limit: float) -> str:
    """Share of the surface over the deviation, in the colours of the scale."""
    width, height = _PLOT
    left, top, bottom = _MARGINS
    high = height - top - bottom
    step = (width - left - 10) / len(histogram.shares)
    most = max(*histogram.shares, 1e-9)
    bars = []
    for index, share in enumerate(histogram.shares):
        low, end = histogram.edges_mm[index], histogram.edges_mm[index + 1]
        middle = (low + end) / 2.0
        red, green, blue = diverging_colours(_as_array(middle / limit))[0]
        tall = high * share / most
        bars.append(
            f'<rect x="{left + index * step:.2f}" y="{top + high - tall:.2f}" '
            f'width="{step:.2f}" height="{tall:.2f}" fill="rgb({red},{green},{blue})" '
            f'stroke="#444" stroke-width="0.4" data-middle="{middle:.9g}">'
            f"<title>{low:.4g} to {end:.4g} mm: {100.0 * share:.2f} %</title></rect>"
        )
    first, last = histogram.edges_mm[0], histogram.edges_mm[-1]
    marks = []
    for part in range(5):
        value = first + (last - first) * part / 4.0
        x = left + (width - left - 10) * part / 4.0
        anchor = ("start", "middle", "middle", "middle", "end")[part]
        marks.append(
            f'<text x="{x:.1f}" y="{height - 10}" text-anchor="{anchor}">'
            f"{millimetres(value, first < 0.0)}</text>"
        )
    marks += [
        f'<text x="{left - 6}" y="{top + 10}" text-anchor="end">{100.0 * most:.3g} %</text>',
        f'<text x="{left - 6}" y="{top + high}" text-anchor="end">0</text>',
        f'<line x1="{left}" y1="{top + high}" x2="{width - 10}" y2="{top + high}" stroke="#444"/>',
    ]
    beyond = histogram.below + histogram.above
    note = f"; {100.0 * beyond:.2g} % lie beyond the scale" if beyond > 0.0 else ""
    return (
        f'<svg viewBox="0 0 {width} {height}" width="{width}" style="max-width:100%" role="img" '
        f'aria-label="Share of the surface by its deviation{note}">'
        + "".join(bars + marks)
        + f'</svg>\n<p class="note">Share of the result\'s surface by its deviation{note}.</p>'
    )


def legend_html(deviation: DeviationFacts) -> str:
    """The colour scale; the viewer rewrites its numbers when the range changes."""
    low = -1.0 if deviation.signed else 0.0
    stops = [low + (1.0 - low) * part / 8.0 for part in range(9)]
    colours = ", ".join("rgb({},{},{})".format(*diverging_colours(_as_array(s))[0]) for s in stops)
    shares = [1.0 - (1.0 - low) * part / 4.0 for part in range(5)]
    ticks = "".join(
        f'<li data-share="{share:g}">'
        f"{millimetres(share * deviation.range_mm, deviation.signed)}</li>"
        for share in shares
    )
    words = "Red lies outside the reference, blue inside." if deviation.signed else "Red is far."
    return (
        '<div class="legend"><div class="bar" '
        f'style="background:linear-gradient(to top, {colours})"></div>'
        f'<ol>{ticks}</ol></div>\n<p class="note">{words}</p>'
    )


def _as_array(value: float) -> npt.NDArray[np.float64]:
    return np.array([value])


def _number(column: int) -> str:
    return ' class="number"' if column else ""


def _iou(iou: VolumeIou) -> str:
    return "–" if iou.value is None else f"{iou.value:.6f} ({iou.method.value})"


def _quantity(value: float | None, unit: str) -> str:
    return "–" if value is None else f"{value:,.6g} {unit}"


def _difference(value: float | None, share: float | None, power: int) -> str:
    if value is None or share is None:
        return "–"
    return f"{value:+.6g} mm{'²³'[power - 2]} ({100.0 * share:+.4f} %)"


def _betti(facts: ModelFacts) -> str:
    return "–" if facts.betti is None else ", ".join(map(str, facts.betti))


def _soundness(facts: ModelFacts) -> str:
    closed = "closed" if facts.watertight else "not closed"
    if facts.valid is None:
        return f"mesh, {closed}"
    if facts.content == Content.SURFACES.value:
        return f"exact surfaces, {closed}"
    return f"exact, {'valid' if facts.valid else 'not valid'}, {closed}"


def _meaning(each: WorstPoint) -> str:
    if each.of == "result":
        return "the result has too much" if each.deviation_mm > 0.0 else "the result has too little"
    return "material is missing" if each.deviation_mm > 0.0 else "the result has too much"
