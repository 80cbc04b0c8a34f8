"""A reconstruction in a document: a group with the report, the part, the surface and the views.

The group's proxy computes nothing, and everything worth keeping is in plain properties and plain
features: a document opens without the engine, and without this addon.
"""

from pathlib import Path

import FreeCAD
import Part

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.report import AlternativeReport, Report, Status
from freecad.gaussiancad.engine.wording import role_name
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate
from freecad.gaussiancad.objects.gaussians import add_points
from freecad.gaussiancad.objects.loading import LoadedPart, LoadedRun, PartSource
from freecad.gaussiancad.objects.properties import Access, PropertySpec, add_properties, text_map
from freecad.gaussiancad.objects.proxies import GroupProxy, GroupViewProxy
from freecad.gaussiancad.objects.sheet_views import add_image_plane
from freecad.gaussiancad.objects.transaction import transaction

SCHEMA_VERSION = 1

ALTERNATIVE = "Alternative"
"""How the names of the alternatives begin."""


class ReconstructionView(GroupViewProxy):
    """View provider of the group.  Documents name this class: it keeps its name and place."""

    icon_name = "GaussianCAD_Reconstruct"

    def doubleClicked(self, view: object) -> bool:
        """Show the report."""
        from freecad.gaussiancad.panels.report import ReportDialog

        ReportDialog.open_for(view.Object)
        return True


class Reconstruction(GroupProxy):
    """Proxy of the group.  Documents name this class: it keeps its name and place."""

    view_proxy = ReconstructionView


def undo_step() -> str:
    """Name of the undo step, as the user reads it."""
    return translate("GaussianCAD", "Reconstruct from Drawing")


def add_reconstruction(document: FreeCAD.Document, run: LoadedRun) -> FreeCAD.DocumentObject:
    """Add a run's result to a document, in one undo step.

    Args:
        document: receives a group with everything in it.
        run: what the run left.

    Returns:
        The group.
    """
    with transaction(document, undo_step()):
        return _added(document, run)


def replace_reconstruction(
    document: FreeCAD.Document, name: str, run: LoadedRun
) -> FreeCAD.DocumentObject:
    """Put a run's result in place of an earlier one, in one undo step.

    Args:
        document: that has the earlier group, or has it no longer.
        name: of the earlier group; empty where there was none.
        run: what the run left.

    Returns:
        The new group.
    """
    earlier = document.getObject(name) if name else None
    with transaction(document, undo_step()):
        if earlier is not None:
            for own in [member.Name for member in earlier.Group]:
                document.removeObject(own)
            document.removeObject(earlier.Name)
        return _added(document, run)


def _added(document: FreeCAD.Document, run: LoadedRun) -> FreeCAD.DocumentObject:
    group = _new_group(document, run.job)
    _fill(group, run, _features(document, run))
    return group


def add_part_alone(
    document: FreeCAD.Document, job: ReconstructJob, part: LoadedPart, status: Status
) -> FreeCAD.DocumentObject:
    """Add the part of a run that goes on, in one undo step.

    Args:
        document: receives a group with the part in it.
        job: what was asked.
        part: the exact solid.
        status: how far it can be trusted.

    Returns:
        The group.
    """
    with transaction(document, undo_step()):
        group = _new_group(document, job)
        add_properties(group, [*_drawing_properties(job), *_status_properties(status, [])])
        group.addObject(_add_part(document, part, _solid_label(status, swept=False), status))
        document.recompute()
        group.Proxy.show(group)
    return group


def new_reconstruction(document: FreeCAD.Document, job: ReconstructJob) -> FreeCAD.DocumentObject:
    """Add a group for a drawing that no run has ended on, within the caller's undo step."""
    group = _new_group(document, job)
    add_properties(group, _drawing_properties(job))
    return group


def add_empty_part(group: FreeCAD.DocumentObject) -> None:
    """Add a part without a shape to a group, within the caller's undo step."""
    feature = group.Document.addObject("Part::Feature", "Part")
    feature.Label = translate("GaussianCAD", "Part (not there yet)")
    group.addObject(feature)


def show_solution(group: FreeCAD.DocumentObject, shape: Part.Shape, report: Report) -> None:
    """Give the part of a group another shape, and the group what is known of it, in place."""
    feature = find_part(group)
    feature.Shape = shape
    feature.Label = _solid_label(report.status, report.swept)
    add_properties(feature, _part_properties(report.status, exact=True))
    if report.agreement is not None:
        add_properties(feature, [_agreement_property(report.agreement)])
    engine = text_map(report.group("engine"))
    add_properties(group, [*_report_properties(report), *_engine_properties(report, engine)])


def add_surface(group: FreeCAD.DocumentObject, run: LoadedRun) -> None:
    """Put mesh, Gaussians, views and alternatives of a run into a group, in place of those before,
    in one undo step; the part stays the object that it is."""
    document, part = group.Document, find_part(group)
    with transaction(document, undo_step()):
        for own in [member.Name for member in group.Group if member is not part]:
            document.removeObject(own)
        features = _features(document, run, with_part=part is None)
        if part is not None and run.part is not None:
            part.Shape = run.part.shape
            part.Label = _part_label(run.part, run.report)
        _fill(group, run, features)


def extend_reconstruction(group: FreeCAD.DocumentObject, run: LoadedRun) -> FreeCAD.DocumentObject:
    """Add to a part that stands alone what else its run left, in an undo step of its own."""
    with transaction(group.Document, undo_step()):
        part = find_part(group)
        features = _features(group.Document, run, with_part=part is None)
        if part is not None and run.report.agreement is not None:
            add_properties(part, [_agreement_property(run.report.agreement)])
        if part is not None:
            part.Label = _part_label(run.part, run.report)
        _fill(group, run, features)
    return group


def _new_group(document: FreeCAD.Document, job: ReconstructJob) -> FreeCAD.DocumentObject:
    group = document.addObject("App::DocumentObjectGroupPython", "Reconstruction")
    Reconstruction(group)
    label = translate("GaussianCAD", "Reconstruction of {name}")
    group.Label = label.format(name=Path(job.sheet).stem)
    return group


def _fill(
    group: FreeCAD.DocumentObject, run: LoadedRun, features: list[FreeCAD.DocumentObject]
) -> None:
    """Give a group the properties and features of a run that has ended."""
    add_properties(group, _properties(run))
    group.addObjects(features)
    hidden = [child.Name for child in group.Group if not child.Visibility]
    add_properties(group, [_hidden_property(hidden)])
    group.Document.recompute()
    group.Proxy.show(group)


def _hidden_property(names: list[str]) -> PropertySpec:
    """Documents made without a window cannot store what is visible: this does."""
    return PropertySpec(
        "StringList",
        "HiddenAtFirst",
        "Drawing",
        QT_TRANSLATE_NOOP("App::Property", "What is hidden when a window first shows the group"),
        names,
        Access.HIDDEN,
    )


def find_part(group: FreeCAD.DocumentObject) -> FreeCAD.DocumentObject | None:
    """The part of a reconstruction, or None."""
    return next((child for child in group.Group if child.Name.startswith("Part")), None)


def _features(
    document: FreeCAD.Document, run: LoadedRun, with_part: bool = True
) -> list[FreeCAD.DocumentObject]:
    features = []
    exact = run.part is not None and run.part.source is PartSource.SOLID
    if run.part is not None and with_part:
        features.append(_add_run_part(document, run))
    for number, shape in enumerate(run.alternatives, start=1):
        features.append(_add_alternative(document, number, shape, run.report))
    if run.mesh is not None:
        surface = document.addObject("Mesh::Feature", "Surface")
        surface.Mesh = run.mesh
        surface.Label = translate("GaussianCAD", "Surface")
        # A faceted part is coarser than the surface and slow to show.
        surface.Visibility = not exact
        features.append(surface)
    if run.cloud is not None:
        points = add_points(document, run.cloud)
        points.Label = translate("GaussianCAD", "Gaussians")
        features.append(points)
    for view in run.views:
        plane = add_image_plane(document, f"View_{view.role}", view.path, view.plane)
        plane.Label = translate("GaussianCAD", "View {role}").format(role=role_name(view.role))
        features.append(plane)
    return features


def _add_run_part(document: FreeCAD.Document, run: LoadedRun) -> FreeCAD.DocumentObject:
    label = _part_label(run.part, run.report)
    feature = _add_part(document, run.part, label, run.report.status)
    if run.part.source is PartSource.SURFACE and run.mesh is not None:
        feature.Visibility = False
    if run.part.source is PartSource.SOLID and run.report.agreement is not None:
        add_properties(feature, [_agreement_property(run.report.agreement)])
    return feature


def _add_part(
    document: FreeCAD.Document, part: LoadedPart, label: str, status: Status
) -> FreeCAD.DocumentObject:
    feature = document.addObject("Part::Feature", "Part")
    feature.Shape = part.shape
    feature.Label = label
    add_properties(feature, _part_properties(status, part.source is PartSource.SOLID))
    return feature


def _part_properties(status: Status, exact: bool) -> list[PropertySpec]:
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


def _add_alternative(
    document: FreeCAD.Document, number: int, shape: Part.Shape, report: Report
) -> FreeCAD.DocumentObject:
    alternative = document.addObject("Part::Feature", ALTERNATIVE)
    alternative.Shape = shape
    label = translate("GaussianCAD", "Alternative {number}")
    alternative.Label = label.format(number=number)
    alternative.Visibility = False
    told = report.alternatives[number - 1] if number <= len(report.alternatives) else None
    if told is not None:
        add_properties(alternative, _alternative_properties(told))
    return alternative


def _agreement_property(share: float) -> PropertySpec:
    tip = QT_TRANSLATE_NOOP(
        "App::Property", "Share of the lines that agree with the drawing's, 0 to 1"
    )
    return PropertySpec("Float", "Agreement", "GaussianCAD", tip, share)


def _alternative_properties(told: AlternativeReport) -> list[PropertySpec]:
    return [
        _agreement_property(told.agreement),
        PropertySpec(
            "String",
            "Projection",
            "GaussianCAD",
            QT_TRANSLATE_NOOP("App::Property", "The projection under which the drawing was read"),
            told.projection,
        ),
    ]


def _part_label(part: LoadedPart, report: Report) -> str:
    if part.source is PartSource.SURFACE:
        return translate("GaussianCAD", "Part (faceted, approximate)")
    return _solid_label(report.status, report.swept)


def _solid_label(status: Status, swept: bool) -> str:
    if swept:
        return translate("GaussianCAD", "Part (outlines only, approximate)")
    if status is Status.VERIFIED:
        return translate("GaussianCAD", "Part")
    return translate("GaussianCAD", "Part (approximate)")


def _properties(run: LoadedRun) -> list[PropertySpec]:
    report, engine = run.report, text_map(run.report.group("engine"))
    drawing = _drawing_properties(run.job)
    if run.overlay is not None:
        tip = QT_TRANSLATE_NOOP("App::Property", "The drawing with the part's own lines over it")
        drawing.append(PropertySpec("FileIncluded", "Overlay", "Drawing", tip, str(run.overlay)))
    return [*drawing, *_report_properties(report), *_engine_properties(report, engine)]


def _drawing_properties(job: ReconstructJob) -> list[PropertySpec]:
    return [
        PropertySpec(
            "Integer",
            "SchemaVersion",
            "Drawing",
            QT_TRANSLATE_NOOP("App::Property", "Version of these properties"),
            SCHEMA_VERSION,
            Access.HIDDEN,
        ),
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
        PropertySpec(
            "Map",
            "Settings",
            "Drawing",
            QT_TRANSLATE_NOOP("App::Property", "What the engine was asked to do"),
            job.settings(),
        ),
    ]


def _status_properties(status: Status, reasons: list[str]) -> list[PropertySpec]:
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


def _report_properties(report: Report) -> list[PropertySpec]:
    group = "Report"
    agreement = {view.role: view.agreement for view in report.views}
    boxes = {
        view.role: ", ".join(f"{value:g}" for value in view.box)
        for view in report.views
        if view.box is not None
    }
    return [
        *_status_properties(report.status, [str(reason) for reason in report.reasons]),
        PropertySpec(
            "Float",
            "MeasuresToMillimetres",
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
            "Map",
            "ViewBoxes",
            group,
            QT_TRANSLATE_NOOP("App::Property", "Where each view is on the drawing, in pixels"),
            boxes,
        ),
        PropertySpec(
            "Map",
            "ViewAgreement",
            group,
            QT_TRANSLATE_NOOP(
                "App::Property", "Share of the drawing's lines found, and of the part's lines right"
            ),
            text_map(agreement),
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


def _engine_properties(report: Report, engine: dict[str, str]) -> list[PropertySpec]:
    return [
        PropertySpec(
            "Float",
            "TotalSeconds",
            "Engine",
            QT_TRANSLATE_NOOP("App::Property", "Duration of the run"),
            sum(report.seconds.values()),
        ),
        PropertySpec(
            "Map",
            "Seconds",
            "Engine",
            QT_TRANSLATE_NOOP("App::Property", "Duration of each stage"),
            text_map(report.seconds),
        ),
        PropertySpec(
            "Map",
            "EngineVersions",
            "Engine",
            QT_TRANSLATE_NOOP("App::Property", "Versions, device, seed and hash of the drawing"),
            engine,
        ),
    ]


def _source(report: Report) -> str:
    source = report.word("projection_source")
    return f"({source})" if source else ""
