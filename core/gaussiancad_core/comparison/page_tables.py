"""The tables of a comparison's page, as text."""

from collections.abc import Sequence
from dataclasses import dataclass

from gaussiancad_core.comparison.comparison_report import Comparison, ModelFacts
from gaussiancad_core.comparison.deepcad import DeepCadResult
from gaussiancad_core.comparison.distances import VolumeIou
from gaussiancad_core.comparison.engineering import NORMAL_ANGLE, EngineeringResult
from gaussiancad_core.comparison.findings import WorstPoint
from gaussiancad_core.comparison.model_files import Content

_DECIMALS = 9
"""Of lengths in mm."""


def millimetres(value: float, signed: bool = True) -> str:
    """A length with its sign and unit; what is rounding is nothing."""
    value = round(value, _DECIMALS)
    # Adding zero turns a negative zero into a positive one.
    return f"{value + 0.0:+.4g} mm" if signed and value else f"{abs(value):.4g} mm"


@dataclass(frozen=True)
class Table:
    """A table whose first column holds the rows' headings.

    Attributes:
        caption: above it.
        head: of the columns.
        rows: of its cells.
    """

    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def paper_table(comparison: Comparison) -> Table:
    """The numbers of the protocol ``gaussiancad``."""
    distances, floor, unit = comparison.distances, comparison.floor, comparison.unit_mm
    rows = [
        ("Chamfer distance", distances.chamfer, floor.chamfer),
        ("Hausdorff distance", distances.hausdorff, floor.hausdorff),
        (f"EMD ({comparison.emd_method})", distances.emd, floor.emd),
        ("Point to surface", comparison.point_to_surface, 0.0),
    ]
    cells = [
        (name, f"{value:.5f}", f"{least:.5f}", f"{value * unit:.5g}") for name, value, least in rows
    ]
    cells.append(("Volume IoU", _iou(comparison.volume_iou), "1", ""))
    caption = f"{comparison.name}; {comparison.points:,} points, seed {comparison.seed}"
    return Table(caption, ("gaussiancad", "Units", "Floor", "Millimetres"), tuple(cells))


def deepcad_table(found: DeepCadResult) -> Table:
    """The numbers of the protocol ``deepcad``."""
    rows = [
        (
            "Chamfer distance × 1000",
            f"{found.chamfer_x1000:.5f}",
            f"{found.floor_x1000:.5f}",
        ),
        ("Volume IoU", _iou(found.volume_iou), "1"),
        ("Valid", "yes" if found.invalid is None else f"no: {found.invalid}", ""),
    ]
    caption = f"unit cube, {found.points:,} points, squared distances, no registration"
    return Table(f"{caption}; seed {found.seed}", ("deepcad", "Value", "Floor"), tuple(rows))


def engineering_table(found: EngineeringResult) -> Table:
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
    return Table(caption, ("engineering", "Of the result", "Of the reference"), tuple(rows))


def facts_table(result: ModelFacts, reference: ModelFacts) -> Table:
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
    return Table("What the files hold", ("Models", "Result", "Reference"), tuple(rows))


def worst_points(worst: Sequence[WorstPoint], signed: bool) -> list[dict[str, str]]:
    """The worst points in words: how far they are off, where, and what lies there."""
    return [
        {
            "exact": ",".join(f"{value:.9g}" for value in point.point_mm),
            "value": f"{point.deviation_mm:.9g}",
            "amount": millimetres(point.deviation_mm, signed),
            "place": ", ".join(f"{value:.4g}" for value in point.point_mm),
            "meaning": _meaning(point),
        }
        for point in worst
    ]


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
