"""A comparison in a document: a group with the distances, the coloured mesh and its legend."""

from dataclasses import dataclass
from pathlib import Path

import FreeCAD
import Mesh

from freecad.gaussiancad.engine.report import COMPARED, Comparison, read_comparison
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate
from freecad.gaussiancad.objects.appearance import show_vertex_colours
from freecad.gaussiancad.objects.legend import HEIGHT, WIDTH, DeviationRange, legend_image
from freecad.gaussiancad.objects.placing import PlanePlacement
from freecad.gaussiancad.objects.ply import read_vertices
from freecad.gaussiancad.objects.properties import Access, PropertySpec, add_properties, text_map
from freecad.gaussiancad.objects.proxies import GroupProxy, GroupViewProxy
from freecad.gaussiancad.objects.sheet_views import add_image_plane
from freecad.gaussiancad.objects.transaction import transaction
from freecad.gaussiancad.qt import QtCore

SCHEMA_VERSION = 1


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


@dataclass(frozen=True)
class LoadedComparison:
    """What a comparison left.

    Attributes:
        report: the numbers.
        mesh: the result in the reference's coordinates.
        colours: (red, green, blue), 0 to 1, of the mesh's points.
        scale: what the colours mean.
        legend: path of the legend's picture.
    """

    report: Comparison
    mesh: Mesh.Mesh
    colours: list[tuple[float, float, float]]
    scale: DeviationRange
    legend: Path


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
        scale = _range_of(vertices.comments, vertices.columns("deviation"))
    except Exception as error:  # FreeCAD raises its own types, which differ between versions
        raise _unreadable(path, error) from error
    if mesh.CountPoints != len(colours):
        raise _unreadable(path, f"{mesh.CountPoints} points, {len(colours)} colours")
    legend = scratch / "legend.png"
    legend_image(scale, with_text=bool(FreeCAD.GuiUp)).save(str(legend))
    return LoadedComparison(report, mesh, colours, scale, legend)


def add_comparison(
    document: FreeCAD.Document,
    loaded: LoadedComparison,
    compared: tuple[FreeCAD.DocumentObject, FreeCAD.DocumentObject],
) -> FreeCAD.DocumentObject:
    """Add a comparison to a document, in one undo step.

    Args:
        document: receives a group with everything in it.
        loaded: what the comparison left.
        compared: the result and the reference; hidden, since the coloured mesh lies on them.

    Returns:
        The group.
    """
    names = (compared[0].Label, compared[1].Label)
    with transaction(document, translate("GaussianCAD", "Compare with Reference")):
        group = document.addObject("App::DocumentObjectGroupPython", "Comparison")
        ComparisonGroup(group)
        label = translate("GaussianCAD", "Comparison of {result} with {reference}")
        group.Label = label.format(result=names[0], reference=names[1])
        add_properties(group, _properties(loaded, names))
        deviation = document.addObject("Mesh::Feature", "Deviation")
        deviation.Mesh = loaded.mesh
        deviation.Label = translate("GaussianCAD", "Deviation")
        deviation.addProperty(
            "App::PropertyColorList",
            "VertexColors",
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "Colour of the deviation at each point"),
        )
        deviation.VertexColors = loaded.colours
        legend = add_image_plane(document, "Legend", loaded.legend, _beside(loaded.mesh))
        legend.Label = translate("GaussianCAD", "Legend")
        group.addObjects([deviation, legend])
        for source in compared:
            source.Visibility = False
        document.recompute()
        group.Proxy.show(group)
    return group


def _range_of(comments: tuple[str, ...], deviations: list[tuple[float, ...]]) -> DeviationRange:
    words = {line.split()[0]: line.split()[-1] for line in comments if line}
    extreme = max((abs(value) for (value,) in deviations), default=0.0)
    return DeviationRange(float(words.get("range", extreme)), words.get("signed", "1") != "0")


def _beside(mesh: Mesh.Mesh) -> PlanePlacement:
    """A place to the right of the mesh and behind it, upright, read from the front."""
    box = mesh.BoundBox
    height = max(box.XLength, box.YLength, box.ZLength)
    width = height * WIDTH / HEIGHT
    centre = (box.XMax + 0.1 * height + width / 2.0, box.YMax, box.ZMin + height / 2.0)
    return PlanePlacement(centre, (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0), width, height)


def _properties(loaded: LoadedComparison, names: tuple[str, str]) -> list[PropertySpec]:
    report = loaded.report
    tips = {
        "chamfer": QT_TRANSLATE_NOOP(
            "App::Property", "Sum of the mean distances to the nearest point, both ways"
        ),
        "hausdorff": QT_TRANSLATE_NOOP("App::Property", "Largest distance to the nearest point"),
        "emd": QT_TRANSLATE_NOOP("App::Property", "Mean distance of points matched one to one"),
        "point_to_surface": QT_TRANSLATE_NOOP("App::Property", "Mean distance to the surface"),
        "volume_iou": QT_TRANSLATE_NOOP("App::Property", "Common volume over united volume"),
    }
    specs = [
        PropertySpec(
            "Integer",
            "SchemaVersion",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "Version of these properties"),
            SCHEMA_VERSION,
            Access.HIDDEN,
        ),
        PropertySpec(
            "String",
            "Result",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "What was measured"),
            names[0],
        ),
        PropertySpec(
            "String",
            "Reference",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "What it was measured against"),
            names[1],
        ),
        PropertySpec(
            "Float",
            "RangeMillimetres",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "Deviation at the ends of the colour scale"),
            loaded.scale.limit,
        ),
        PropertySpec(
            "Map",
            "Floor",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "What two samples of the reference give"),
            text_map(report.floor),
        ),
        PropertySpec(
            "String",
            "ReportJson",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "The engine's report as it wrote it"),
            report.text,
            Access.HIDDEN,
        ),
    ]
    for key in COMPARED:
        if key in report.distances:
            name = "".join(part.capitalize() for part in key.split("_"))
            specs.append(PropertySpec("Float", name, "Distances", tips[key], report.distances[key]))
    return specs


def _unreadable(path: Path, reason: object) -> WorkbenchError:
    text = translate(
        "GaussianCAD", "The engine's file {path} cannot be read ({reason}). Run it again."
    )
    return WorkbenchError(ErrorCode.RESULT_UNREADABLE, text.format(path=path, reason=reason))
