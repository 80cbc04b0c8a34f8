"""The properties of a comparison in a document."""

import FreeCAD

from freecad.gaussiancad.engine.report import COMPARED, Comparison
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP
from freecad.gaussiancad.objects.properties import Access, PropertySpec, text_lines, text_map

SCHEMA_VERSION = 3

RANGE = "ColourRange"
"""The property that says which deviation the ends of the colour scale stand for."""

_LINKS = (
    ("ResultObject", QT_TRANSLATE_NOOP("App::Property", "The object that was measured")),
    (
        "ReferenceObject",
        QT_TRANSLATE_NOOP("App::Property", "The object that it was measured against"),
    ),
)

_FILES = (
    ("Page", QT_TRANSLATE_NOOP("App::Property", "The comparison as a page for a browser")),
    ("Picture", QT_TRANSLATE_NOOP("App::Property", "The result, coloured by its deviation")),
)


def add_links(group: FreeCAD.DocumentObject) -> None:
    """Add the links to the compared objects, after which the group is recomputed, and its files."""
    for name, tip in _LINKS:
        group.addProperty("App::PropertyLinkGlobal", name, "Comparison", tip)
        group.setEditorMode(name, int(Access.READ_ONLY))
    for name, tip in _FILES:
        group.addProperty("App::PropertyFileIncluded", name, "Comparison", tip)
        group.setEditorMode(name, int(Access.HIDDEN))


def fixed_properties(limit: float) -> list[PropertySpec]:
    """What is added once."""
    texts = {
        "Result": QT_TRANSLATE_NOOP("App::Property", "What was measured"),
        "Reference": QT_TRANSLATE_NOOP("App::Property", "What it was measured against"),
        "ResultFile": QT_TRANSLATE_NOOP("App::Property", "The file that was measured"),
        "ReferenceFile": QT_TRANSLATE_NOOP("App::Property", "The file it was measured against"),
        "ResultState": QT_TRANSLATE_NOOP("App::Property", "The result when it was compared"),
        "ReferenceState": QT_TRANSLATE_NOOP("App::Property", "The reference when it was compared"),
        "ReportJson": QT_TRANSLATE_NOOP("App::Property", "The engine's report as it wrote it"),
    }
    access = (Access.READ_ONLY, Access.HIDDEN)
    hidden = ("ResultState", "ReferenceState", "ReportJson")
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
            "Bool",
            "Stale",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "Whether an object changed since it was compared"),
            False,
        ),
        PropertySpec(
            "Bool",
            "CompareAgain",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "Whether to compare again when an object changes"),
            True,
            Access.OPEN,
        ),
        PropertySpec(
            "Length",
            RANGE,
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "Deviation at the ends of the colour scale"),
            limit,
            Access.OPEN,
        ),
        PropertySpec(
            "StringList",
            "Floor",
            "Comparison",
            QT_TRANSLATE_NOOP("App::Property", "What two samples of the reference give"),
            [],
        ),
    ]
    specs += [
        PropertySpec("String", name, "Comparison", tip, "", access[name in hidden])
        for name, tip in texts.items()
    ]
    return specs


def range_mm(group: FreeCAD.DocumentObject) -> float:
    """The deviation at the ends of the colour scale, in mm."""
    return group.ColourRange.Value


def distance_properties(report: Comparison) -> list[PropertySpec]:
    """The paper's numbers, as far as they were told."""
    tips = {
        "chamfer": QT_TRANSLATE_NOOP(
            "App::Property", "Sum of the mean distances to the nearest point, both ways"
        ),
        "hausdorff": QT_TRANSLATE_NOOP("App::Property", "Largest distance to the nearest point"),
        "emd": QT_TRANSLATE_NOOP("App::Property", "Mean distance of points matched one to one"),
        "point_to_surface": QT_TRANSLATE_NOOP("App::Property", "Mean distance to the surface"),
        "volume_iou": QT_TRANSLATE_NOOP("App::Property", "Common volume over united volume"),
    }
    return [
        PropertySpec(
            "Float",
            "".join(part.capitalize() for part in key.split("_")),
            "Distances",
            tips[key],
            report.distances[key],
        )
        for key in COMPARED
        if key in report.distances
    ]


def tell_report(group: FreeCAD.DocumentObject, report: Comparison) -> None:
    """Store the numbers of a report in a group that has all other properties."""
    group.Floor = text_lines(text_map(report.floor))
    group.ReportJson = report.text
    for spec in distance_properties(report):
        if spec.name not in group.PropertiesList:
            group.addProperty(f"App::Property{spec.type_name}", spec.name, spec.group, spec.tip)
            group.setEditorMode(spec.name, int(spec.access))
        setattr(group, spec.name, spec.value)
