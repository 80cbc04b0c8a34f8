"""Everything a run left, read into memory before a document is touched."""

from dataclasses import dataclass
from enum import Enum
from pathlib import Path

import FreeCAD
import Mesh
import Part

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import Report, read_report
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.gaussians import GaussianCloud, read_gaussians
from freecad.gaussiancad.objects.sheet_views import ViewImage, cut_views, read_sheet_image


class PartSource(Enum):
    """Which of the engine's files a part came from."""

    SOLID = "solid.step"
    SURFACE = "surface.step"


@dataclass(frozen=True)
class LoadedPart:
    """A part.

    Attributes:
        shape: the B-Rep.
        source: an exact solid, or a faceted copy of the surface.
    """

    shape: Part.Shape
    source: PartSource


@dataclass(frozen=True)
class LoadedRun:
    """What a run left.

    Attributes:
        job: what was asked.
        report: what the engine says.
        part: the exact solid if there is one, else the faceted one, else None.
        alternatives: other solids that fit the sheet, best first.
        mesh: the surface of the Gaussians, or None.
        cloud: the Gaussians, or None.
        views: pieces of the sheet.
        overlay: the sheet with the result's lines over it, or None.
    """

    job: ReconstructJob
    report: Report
    part: LoadedPart | None
    alternatives: tuple[Part.Shape, ...]
    mesh: Mesh.Mesh | None
    cloud: GaussianCloud | None
    views: tuple[ViewImage, ...]
    overlay: Path | None


def load_run(job: ReconstructJob, scratch: Path, with_views: bool = True) -> LoadedRun:
    """Read the files in the job's output folder.

    Args:
        job: the finished job.
        scratch: a folder for the pieces of the sheet; needed until they are in a document.
        with_views: whether the views are cut out of the sheet.

    Raises:
        WorkbenchError: the report or a file that it promises cannot be read, or nothing was made.
    """
    folder = Path(job.output)
    report = read_report(folder / "report.json")
    part = _load_part(folder)
    mesh = _load_mesh(folder)
    if report.status is Status.FAILED or (part is None and mesh is None):
        message = translate("GaussianCAD", "The engine made no model of {sheet}: {reason}").format(
            sheet=job.sheet, reason=" ".join(reason.words for reason in report.reasons) or "?"
        )
        raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, message)
    gaussians = folder / "gaussians.ply"
    overlay = folder / "overlay.png"
    return LoadedRun(
        job,
        report,
        part,
        load_alternatives(folder / "alternatives"),
        mesh,
        read_gaussians(gaussians) if gaussians.is_file() else None,
        tuple(_cut_views(job, report, scratch)) if with_views else (),
        overlay if overlay.is_file() else None,
    )


def _load_part(folder: Path) -> LoadedPart | None:
    for source in PartSource:
        path = folder / source.value
        if path.is_file():
            return LoadedPart(read_shape(path), source)
    return None


def load_alternatives(folder: Path) -> tuple[Part.Shape, ...]:
    """The other solids that a run left in a folder, best first."""
    numbered = [path for path in folder.glob("*.step") if path.stem.isdigit()]
    return tuple(read_shape(path) for path in sorted(numbered, key=lambda path: int(path.stem)))


def _load_mesh(folder: Path) -> Mesh.Mesh | None:
    path = next((p for p in (folder / "surface.ply", folder / "surface.stl") if p.is_file()), None)
    if path is None:
        return None
    try:
        mesh = Mesh.Mesh(str(path))
    except Exception as error:  # FreeCAD raises its own types, which differ between versions
        raise _unreadable(path, error) from error
    if mesh.CountFacets == 0:
        raise _unreadable(path, "no triangles")
    return mesh


def read_shape(path: Path) -> Part.Shape:
    """The shape in a STEP file of the engine.

    Raises:
        WorkbenchError: it cannot be read, or has no faces.
    """
    shape = Part.Shape()
    try:
        shape.read(str(path))
    except Exception as error:  # as above
        raise _unreadable(path, error) from error
    if shape.isNull() or not shape.Faces:
        raise _unreadable(path, "no faces")
    return shape


def _cut_views(job: ReconstructJob, report: Report, scratch: Path) -> list[ViewImage]:
    """From the sheet, or from the engine's overlay of it where Qt cannot read that page of it."""
    overlay = Path(job.output) / "overlay.png"
    for path in (Path(job.sheet), overlay) if job.page == 1 else (overlay,):
        image = read_sheet_image(path) if path.is_file() else None
        if image is not None:
            return cut_views(image, report, scratch)
    FreeCAD.Console.PrintLog(f"GaussianCAD: no picture of {job.sheet} can be read\n")
    return []


def _unreadable(path: Path, reason: object) -> WorkbenchError:
    message = translate(
        "GaussianCAD", "The engine's file {path} cannot be read ({reason}). Run it again."
    ).format(path=path, reason=reason)
    return WorkbenchError(ErrorCode.RESULT_UNREADABLE, message)
