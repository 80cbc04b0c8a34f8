"""The material of ``benchmark``: parts, and the sheets that are made of them."""

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path

from OCP.TopoDS import TopoDS_Shape

from benchmarks.parts.exact_cases import Case, classed_cases
from benchmarks.sheets.exact_inputs import kept_lines
from benchmarks.sheets.exact_perturbations import of_wrong_length
from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import PartLines, compose_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.evidence.drawn_views import exact_views
from gaussiancad_core.kernel.brep_files import write_step
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.samples import sample
from gaussiancad_core.samples.classed import PartClass

SAMPLE_NAMES = ("l-bracket", "boss-plate", "wedge-block")
"""The samples whose sheets ship with the product."""

USUAL_CLASSES = (PartClass.FILLETS, PartClass.REVOLVED, PartClass.OBLIQUE)
"""Those that the samples are none of."""

_STEPS = (".step", ".stp")
_SHEETS = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".webp", ".pdf", ".svg", ".dxf")


class SheetKind(Enum):
    """How a part is drawn; ``GIVEN`` is somebody else's sheet."""

    CLEAN = "clean"
    SCAN = "scan"
    ENDS_1 = "ends 1 px"
    ENDS_2 = "ends 2 px"
    ENDS_3 = "ends 3 px"
    ENDS_5 = "ends 5 px"
    ENDS_8 = "ends 8 px"
    GIVEN = "given"

    @property
    def wrong_px(self) -> float | None:
        """By how much ends are off at most, in 1/600 of the longest extent; None where not."""
        return float(self.value.split()[1]) if self.value.startswith("ends") else None


DRAWN_KINDS = tuple(kind for kind in SheetKind if kind is not SheetKind.GIVEN)

STRENGTHS = tuple(kind for kind in SheetKind if kind.wrong_px is not None)


@dataclass(frozen=True)
class Part:
    """A part, and its sheet where it is not drawn here.

    Attributes:
        case: the solid.
        sheet: somebody else's drawing of it.
        projection: of that drawing.
        digest: of the files' content, where they are not this project's.
    """

    case: Case
    sheet: Path | None = None
    projection: Projection = Projection.THIRD
    digest: str = ""

    @property
    def kinds(self) -> tuple[SheetKind, ...]:
        """The sheets that there can be."""
        return DRAWN_KINDS if self.sheet is None else (SheetKind.GIVEN,)


def shipped_parts(
    names: tuple[str, ...], classes: list[PartClass], parts: int, seed: int, folder: Path
) -> Iterator[Part]:
    """Samples, whose STEP files are written into a folder, and some parts of each class."""
    for number, name in enumerate(names):
        path = folder / "parts" / f"{name}.step"
        if not path.exists():
            path.parent.mkdir(parents=True, exist_ok=True)
            write_step(sample(name).build(), path)
        yield Part(Case(name, "samples", number, step=path))
    for case in classed_cases(classes, parts, seed, 0):
        yield Part(case)


def given_parts(folder: Path, projection: Projection) -> Iterator[Part]:
    """The STEP files of a folder, each with the sheet of the same stem if there is one."""
    entries = sorted(folder.iterdir()) if folder.is_dir() else []
    steps = [path for path in entries if path.suffix.lower() in _STEPS]
    sheets = {path.stem: path for path in entries if path.suffix.lower() in _SHEETS}
    for number, step in enumerate(steps):
        case = Case(step.stem, folder.name, number, step=step)
        sheet = sheets.get(step.stem)
        content = step.read_bytes() + (sheet.read_bytes() if sheet else b"")
        digest = hashlib.sha256(content).hexdigest()[:12]
        yield Part(case, sheet, projection, digest)


def make_sheet(part: Part, truth: TopoDS_Shape, kind: SheetKind, folder: Path, kept: Path) -> Path:
    """The file of a part's sheet: drawn into a folder, third angle, or given.

    Args:
        part: what is drawn.
        truth: its solid.
        kind: how.
        folder: for the picture.
        kept: folder for lines, which sheets of the same part share.
    """
    if part.sheet is not None:
        return part.sheet
    lines = kept_lines(part.case, truth, kept)
    style = parse_style("scan" if kind is SheetKind.SCAN else "clean")
    drawn = _with_wrong_ends(lines, kind.wrong_px, part.case.seed)
    sheet = compose_sheet(drawn, Projection.THIRD, style, part.case.seed)
    path = folder / ("sheet.png" if style.jpeg_quality >= 95 else "sheet.jpg")
    write_image(sheet.image, path, style.jpeg_quality, sheet.dpi)
    return path


def _with_wrong_ends(lines: PartLines, pixels: float | None, seed: int) -> PartLines:
    if pixels is None:
        return lines
    x, y, z = (float(extent) for extent in lines.size)
    wrong = of_wrong_length(exact_views(lines.views, (x, y, z)), seed, pixels)
    return replace(lines, views=wrong.strokes)
