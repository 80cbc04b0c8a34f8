"""A comparison in a document: a group with the distances, the coloured mesh and its legend."""

import json
import shutil
from dataclasses import dataclass, field
from pathlib import Path

import FreeCAD
import Mesh

from freecad.gaussiancad.engine.job import CompareJob
from freecad.gaussiancad.engine.report import Comparison, parse_comparison, read_comparison
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate
from freecad.gaussiancad.objects.appearance import show_vertex_colours
from freecad.gaussiancad.objects.comparison_colours import recolour
from freecad.gaussiancad.objects.comparison_properties import (
    RANGE,
    add_links,
    fixed_properties,
    range_mm,
    tell_report,
)
from freecad.gaussiancad.objects.legend import HEIGHT, WIDTH, DeviationRange, legend_image
from freecad.gaussiancad.objects.placing import PlanePlacement
from freecad.gaussiancad.objects.ply import read_vertices
from freecad.gaussiancad.objects.properties import Access, add_properties
from freecad.gaussiancad.objects.proxies import GroupProxy, GroupViewProxy
from freecad.gaussiancad.objects.sheet_views import add_image_plane
from freecad.gaussiancad.objects.sources import Source
from freecad.gaussiancad.objects.transaction import transaction
from freecad.gaussiancad.qt import QtCore


class ComparisonView(GroupViewProxy):
    """View provider of the group.  Documents name this class: it keeps its name and place."""

    icon_name = "GaussianCAD_Compare"

    def attach(self, view: object) -> None:
        """Once the document is whole, colour the mesh again where FreeCAD does not (0.20)."""
        super().attach(view)
        if FreeCAD.Version()[0] == "0":
            QtCore.QTimer.singleShot(0, self._colour_again)

    def _colour_again(self) -> None:
        try:
            for child in self.Object.Group:
                show_vertex_colours(child)
        except ReferenceError:
            return  # the group was removed in the meantime


class ComparisonGroup(GroupProxy):
    """Proxy of the group.  Documents name this class: it keeps its name and place."""

    view_proxy = ComparisonView

    def execute(self, target: FreeCAD.DocumentObject) -> None:
        """See whether what was compared has changed; the engine never runs within a recompute."""
        request = request_of(target)
        if request is None:
            return
        stale = request.states != (target.ResultState, target.ReferenceState)
        if target.Stale != stale:
            target.Stale = stale
        if stale and target.CompareAgain and FreeCAD.GuiUp:
            from freecad.gaussiancad.objects.refreshing import refresh_soon

            refresh_soon(target)

    def onChanged(self, target: FreeCAD.DocumentObject, name: str) -> None:
        """Colour the mesh anew when the user changes the range."""
        if name == RANGE and "Restore" not in target.State:
            recolour(target, range_mm(target))


@dataclass(frozen=True)
class CompareRequest:
    """What is compared.

    Attributes:
        result, reference: the two sides.
        states: of both when their geometry was taken.
    """

    result: Source
    reference: Source
    states: tuple[str, str] = field(default=("", ""))

    def __post_init__(self) -> None:
        if self.states == ("", ""):
            states = (self.result.state(), self.reference.state())
            object.__setattr__(self, "states", states)


@dataclass(frozen=True)
class LoadedComparison:
    """What a comparison left.

    Attributes:
        report: the numbers.
        mesh: the result in the reference's coordinates.
        colours: (red, green, blue), 0 to 1, of the mesh's points.
        scale: what the colours mean.
        legend: path of the legend's picture.
        deviations: mm at the mesh's points.
        page: path of the page for a browser, or None where the engine wrote none.
        picture: path of a picture of the coloured mesh, or None.
    """

    report: Comparison
    mesh: Mesh.Mesh
    colours: list[tuple[float, float, float]]
    scale: DeviationRange
    legend: Path
    deviations: list[float]
    page: Path | None = None
    picture: Path | None = None


def load_comparison(output: Path, scratch: Path) -> LoadedComparison:
    """Read what ``gaussiancad compare`` wrote.

    Args:
        output: its output folder.
        scratch: a folder for the legend; needed until it is in a document.

    Raises:
        WorkbenchError: a file cannot be read.
    """
    report = read_comparison(output / "comparison.json")
    path = output / "deviation.ply"
    vertices = read_vertices(path)
    try:
        mesh = Mesh.Mesh(str(path))
        colours = [
            (red / 255.0, green / 255.0, blue / 255.0)
            for red, green, blue in vertices.columns("red", "green", "blue")
        ]
        deviations = [value for (value,) in vertices.columns("deviation")]
        scale = _range_of(vertices.comments, deviations)
    except Exception as error:  # FreeCAD raises its own types, which differ between versions
        raise _unreadable(path, error) from error
    if mesh.CountPoints != len(colours):
        raise _unreadable(path, f"{mesh.CountPoints} points, {len(colours)} colours")
    legend = scratch / "legend.png"
    legend_image(scale, with_text=bool(FreeCAD.GuiUp)).save(str(legend))
    files = [output / name for name in ("comparison.html", "deviation.png")]
    page, picture = (path if path.is_file() else None for path in files)
    return LoadedComparison(report, mesh, colours, scale, legend, deviations, page, picture)


def prepare_comparison(request: CompareRequest, scratch: Path) -> CompareJob:
    """Write what is compared to files, with the sheet beside the result for the engine's page.

    Raises:
        WorkbenchError: there is no geometry.
    """
    item = scratch / "result"
    result = request.result.file(item)
    sheet = request.result.sheet()
    if sheet is not None and result.parent == item:
        shutil.copyfile(sheet, item / "overlay.png")
    reference = request.reference.file(scratch / "reference")
    return CompareJob(str(result), str(reference), str(scratch / "comparison"))


def add_comparison(
    document: FreeCAD.Document, loaded: LoadedComparison, request: CompareRequest
) -> FreeCAD.DocumentObject:
    """Add a comparison to a document, in one undo step.

    Args:
        document: receives a group with everything in it.
        loaded: what the comparison left.
        request: what was compared; its objects are hidden, since the coloured mesh lies on them.

    Returns:
        The group.
    """
    names = (request.result.label, request.reference.label)
    with transaction(document, translate("GaussianCAD", "Compare with Reference")):
        group = document.addObject("App::DocumentObjectGroupPython", "Comparison")
        ComparisonGroup(group)
        label = translate("GaussianCAD", "Comparison of {result} with {reference}")
        group.Label = label.format(result=names[0], reference=names[1])
        add_links(group)
        add_properties(group, fixed_properties(loaded.scale.limit))
        deviation = document.addObject("Mesh::Feature", "Deviation")
        deviation.Label = translate("GaussianCAD", "Deviation")
        for kind, name, tip in (
            (
                "ColorList",
                "VertexColors",
                QT_TRANSLATE_NOOP("App::Property", "Colour of the deviation at each point"),
            ),
            (
                "FloatList",
                "Deviations",
                QT_TRANSLATE_NOOP("App::Property", "Deviation at each point in mm"),
            ),
        ):
            deviation.addProperty(f"App::Property{kind}", name, "GaussianCAD", tip)
        deviation.setEditorMode("Deviations", int(Access.HIDDEN))
        legend = add_image_plane(document, "Legend", loaded.legend, _beside(loaded.mesh))
        legend.Label = translate("GaussianCAD", "Legend")
        group.addObjects([deviation, legend])
        _fill(group, loaded, request)
        for source in (request.result, request.reference):
            if source.feature is not None:
                source.feature.Visibility = False
        document.recompute()
        group.Proxy.show(group)
    return group


def update_comparison(
    group: FreeCAD.DocumentObject, loaded: LoadedComparison, request: CompareRequest
) -> None:
    """Put new numbers and colours into a comparison, in one undo step."""
    with transaction(group.Document, translate("GaussianCAD", "Compare Again")):
        _fill(group, loaded, request)
        legend = next((each for each in group.Group if each.TypeId == "Image::ImagePlane"), None)
        if legend is not None:
            legend.ImageFile = str(loaded.legend)
        group.ColourRange = loaded.scale.limit
        group.Document.recompute()
        group.Proxy.show(group)


def comparison_report(group: FreeCAD.DocumentObject) -> Comparison | None:
    """The report that a group stores, or None where it cannot be read."""
    try:
        return parse_comparison(group.ReportJson, json.loads(group.ReportJson))
    except (AttributeError, ValueError):
        return None


def request_of(group: FreeCAD.DocumentObject) -> CompareRequest | None:
    """What a group compares, or None where an older version made it or an object is gone."""
    if not hasattr(group, "ResultObject"):
        return None
    result = Source(group.ResultObject, group.ResultFile)
    reference = Source(group.ReferenceObject, group.ReferenceFile)
    if any(each.feature is None and not each.path for each in (result, reference)):
        return None
    return CompareRequest(result, reference)


def is_comparison(candidate: FreeCAD.DocumentObject) -> bool:
    """Whether an object is a comparison's group."""
    return isinstance(getattr(candidate, "Proxy", None), ComparisonGroup)


def _fill(group: FreeCAD.DocumentObject, loaded: LoadedComparison, request: CompareRequest) -> None:
    deviation = next(each for each in group.Group if hasattr(each, "VertexColors"))
    deviation.Mesh = loaded.mesh
    deviation.Deviations = loaded.deviations
    deviation.VertexColors = loaded.colours
    group.Result, group.Reference = request.result.label, request.reference.label
    group.ResultObject, group.ReferenceObject = request.result.feature, request.reference.feature
    group.ResultFile, group.ReferenceFile = request.result.path, request.reference.path
    group.ResultState, group.ReferenceState = request.states
    group.Stale = False
    for name, path in (("Page", loaded.page), ("Picture", loaded.picture)):
        # Groups of an older version have no picture.
        if path is not None and hasattr(group, name):
            setattr(group, name, str(path))
    tell_report(group, loaded.report)


def _range_of(comments: tuple[str, ...], deviations: list[float]) -> DeviationRange:
    words = {line.split()[0]: line.split()[-1] for line in comments if line}
    extreme = max(map(abs, deviations), default=0.0)
    return DeviationRange(float(words.get("range", extreme)), words.get("signed", "1") != "0")


def _beside(mesh: Mesh.Mesh) -> PlanePlacement:
    """A place to the right of the mesh and behind it, upright, read from the front."""
    box = mesh.BoundBox
    height = max(box.XLength, box.YLength, box.ZLength)
    width = height * WIDTH / HEIGHT
    centre = (box.XMax + 0.1 * height + width / 2.0, box.YMax, box.ZMin + height / 2.0)
    return PlanePlacement(centre, (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0), width, height)


def _unreadable(path: Path, reason: object) -> WorkbenchError:
    text = translate(
        "GaussianCAD", "The engine's file {path} cannot be read ({reason}). Run it again."
    )
    return WorkbenchError(ErrorCode.RESULT_UNREADABLE, text.format(path=path, reason=reason))
