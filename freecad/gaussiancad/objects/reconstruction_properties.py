"""The properties of a reconstruction in a document: of its group, its part, its alternatives."""

from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import AlternativeReport, Report
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP
from freecad.gaussiancad.objects.loading import LoadedRun
from freecad.gaussiancad.objects.properties import Access, PropertySpec, text_lines, text_map

SCHEMA_VERSION = 2


def part_properties(status: Status, exact: bool) -> list[PropertySpec]:
    """Of a part."""
    return [
        PropertySpec(
            "String",
            "Status",
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "Whether the part was checked on the drawing"),
            status.value,
        ),
        PropertySpec(
            "Bool",
            "Exact",
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "Whether the faces are exact, not triangles"),
            exact,
        ),
    ]


def agreement_property(share: float) -> PropertySpec:
    """Of a solid whose lines were compared with the drawing's."""
    tip = QT_TRANSLATE_NOOP(
        "App::Property", "Share of the lines that agree with the drawing's, 0 to 1"
    )
    return PropertySpec("Float", "Agreement", "GaussianCAD", tip, share)


def alternative_properties(report: AlternativeReport) -> list[PropertySpec]:
    """Of another solid that has the drawing's lines."""
    return [
        agreement_property(report.agreement),
        PropertySpec(
            "String",
            "Projection",
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "The projection under which the drawing was read"),
            report.projection,
        ),
    ]


def hidden_property(names: list[str]) -> PropertySpec:
    """Documents made without a window cannot store what is visible: this does."""
    return PropertySpec(
        "StringList",
        "HiddenAtFirst",
        "Drawing",
        QT_TRANSLATE_NOOP("App::Property", "What is hidden when a window first shows the group"),
        names,
        Access.HIDDEN,
    )


def run_properties(run: LoadedRun, group: FreeCAD.DocumentObject) -> list[PropertySpec]:
    """Of the group of a run that has ended."""
    report = run.report
    drawing = drawing_properties(run.job, group)
    if run.overlay is not None or hasattr(group, "Overlay"):
        tip = QT_TRANSLATE_NOOP("App::Property", "The drawing with the part's own lines over it")
        overlay = "" if run.overlay is None else str(run.overlay)
        drawing.append(PropertySpec("FileIncluded", "Overlay", "Drawing", tip, overlay))
    return [*drawing, *report_properties(report), *engine_properties(report)]


def drawing_properties(job: ReconstructJob, group: FreeCAD.DocumentObject) -> list[PropertySpec]:
    """Of the drawing, and of what was asked.

    Args:
        job: what was asked.
        group: where the properties go; a drawing that is this group's own copy stays as it is.
    """
    asked = [
        PropertySpec(
            "Integer",
            "SchemaVersion",
            "Drawing",
            QT_TRANSLATE_NOOP("App::Property", "Version of these properties"),
            SCHEMA_VERSION,
            Access.HIDDEN,
        ),
        PropertySpec(
            "StringList",
            "Settings",
            "Drawing",
            QT_TRANSLATE_NOOP("App::Property", "What the engine was asked to do"),
            text_lines(job.settings()),
        ),
    ]
    if getattr(group, "Sheet", "") == job.sheet:
        return asked
    return [
        *asked,
        PropertySpec(
            "String",
            "SheetPath",
            "Drawing",
            QT_TRANSLATE_NOOP("App::Property", "Where the drawing was when it was read"),
            str(Path(job.sheet).absolute()),
        ),
        PropertySpec(
            "FileIncluded",
            "Sheet",
            "Drawing",
            QT_TRANSLATE_NOOP("App::Property", "The drawing, stored in this document"),
            job.sheet,
        ),
    ]


def clear_report(group: FreeCAD.DocumentObject) -> None:
    """Forget what an earlier run told; a run that goes on tells it anew."""
    for name in group.PropertiesList:
        if group.getGroupOfProperty(name) in ("Report", "Engine") or name == "Overlay":
            empty = {list: [], str: ""}.get(type(getattr(group, name)), 0.0)
            setattr(group, name, empty)


def status_properties(status: Status, reasons: list[str]) -> list[PropertySpec]:
    """How far a result can be trusted, and why not further."""
    return [
        PropertySpec(
            "String",
            "Status",
            "Report",
            QT_TRANSLATE_NOOP("App::Property", "Verified, approximate or failed"),
            status.value,
        ),
        PropertySpec(
            "StringList",
            "Reasons",
            "Report",
            QT_TRANSLATE_NOOP("App::Property", "Why the part is not verified"),
            reasons,
        ),
    ]


def report_properties(report: Report) -> list[PropertySpec]:
    """What the engine tells of its result."""
    group = "Report"
    agreement = {view.role: view.agreement for view in report.views}
    boxes = {
        view.role: ", ".join(f"{value:g}" for value in view.box)
        for view in report.views
        if view.box is not None
    }
    return [
        *status_properties(report.status, [str(reason) for reason in report.reasons]),
        PropertySpec(
            "Length",
            "MeasuresWithin",
            group,
            QT_TRANSLATE_NOOP(
                "App::Property", "Bound that 95 % of the faces' places keep; 0 if it is not known"
            ),
            float(report.group("measures").get("uncertainty_mm") or 0.0),
        ),
        PropertySpec(
            "StringList",
            "Warnings",
            group,
            QT_TRANSLATE_NOOP("App::Property", "What the engine warns of"),
            [str(warning) for warning in report.warnings],
        ),
        PropertySpec(
            "String",
            "Projection",
            group,
            QT_TRANSLATE_NOOP("App::Property", "First or third angle, and how that is known"),
            " ".join(w for w in (report.word("projection"), _source(report)) if w),
        ),
        PropertySpec(
            "Float",
            "MillimetresPerPixel",
            group,
            QT_TRANSLATE_NOOP("App::Property", "Scale of the drawing"),
            report.mm_per_pixel or 0.0,
        ),
        PropertySpec(
            "String",
            "ScaleSource",
            group,
            QT_TRANSLATE_NOOP("App::Property", "How the scale is known"),
            report.word("scale_source"),
        ),
        PropertySpec(
            "StringList",
            "ViewBoxes",
            group,
            QT_TRANSLATE_NOOP("App::Property", "Where each view is on the drawing, in pixels"),
            text_lines(boxes),
        ),
        PropertySpec(
            "StringList",
            "ViewAgreement",
            group,
            QT_TRANSLATE_NOOP(
                "App::Property", "Share of the drawing's lines found, and of the part's lines right"
            ),
            text_lines(text_map(agreement)),
        ),
        PropertySpec(
            "String",
            "ReportJson",
            group,
            QT_TRANSLATE_NOOP("App::Property", "The engine's report as it wrote it"),
            report.text,
            Access.HIDDEN,
        ),
    ]


def engine_properties(report: Report) -> list[PropertySpec]:
    """What the engine tells of itself."""
    return [
        PropertySpec(
            "Float",
            "TotalSeconds",
            "Engine",
            QT_TRANSLATE_NOOP("App::Property", "Duration of the run"),
            sum(report.seconds.values()),
        ),
        PropertySpec(
            "StringList",
            "Seconds",
            "Engine",
            QT_TRANSLATE_NOOP("App::Property", "Duration of each stage"),
            text_lines(text_map(report.seconds)),
        ),
        PropertySpec(
            "StringList",
            "EngineVersions",
            "Engine",
            QT_TRANSLATE_NOOP("App::Property", "Versions, device, seed and hash of the drawing"),
            text_lines(text_map(report.group("engine"))),
        ),
    ]


def _source(report: Report) -> str:
    source = report.word("projection_source")
    return f"({source})" if source else ""
