"""A reconstruction in a document: a group with the report, the part, the surface and the views.

The group's proxy computes nothing, and everything worth keeping is in plain properties and plain
features: a document opens without the engine, and without this addon.
"""

from pathlib import Path

import FreeCAD
import Part

from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import Report
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.known_sheets import group_of
from freecad.gaussiancad.objects.loading import LoadedPart, LoadedRun
from freecad.gaussiancad.objects.properties import add_properties
from freecad.gaussiancad.objects.proxies import GroupProxy, GroupViewProxy
from freecad.gaussiancad.objects.reconstruction_features import (
    change_part,
    find_part,
    put_features,
    put_part_alone,
)
from freecad.gaussiancad.objects.reconstruction_properties import (
    clear_report,
    drawing_properties,
    engine_properties,
    hidden_property,
    report_properties,
    run_properties,
    status_properties,
)
from freecad.gaussiancad.objects.transaction import transaction


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
        group = _new_group(document, run.job)
        _fill(group, run)
    return group


def update_reconstruction(group: FreeCAD.DocumentObject, run: LoadedRun) -> None:
    """Put a run's result in place of what a group has, in one undo step.

    Args:
        group: of the same drawing; its features stay the objects that they are.
        run: what the run left.
    """
    with transaction(group.Document, undo_step()):
        _fill(group, run)


def put_reconstruction(document: FreeCAD.Document, run: LoadedRun) -> FreeCAD.DocumentObject:
    """Put a run's result where the document has that drawing already, else into a new group.

    Returns:
        The group.
    """
    known = group_of(document, Path(run.job.sheet), run.job.page)
    if known is None:
        return add_reconstruction(document, run)
    update_reconstruction(known, run)
    return known


def put_part_of_run(
    document: FreeCAD.Document, job: ReconstructJob, part: LoadedPart, status: Status
) -> FreeCAD.DocumentObject:
    """Show the part of a run that goes on, in one undo step; nothing of an earlier run stays.

    Args:
        document: has a group of that drawing, or receives one.
        job: what was asked.
        part: the exact solid.
        status: how far it can be trusted.

    Returns:
        The group.
    """
    with transaction(document, undo_step()):
        group = group_of(document, Path(job.sheet), job.page)
        if group is None:
            group = _new_group(document, job)
        clear_report(group)
        stated = [*drawing_properties(job, group), *status_properties(status, [])]
        add_properties(group, stated)
        put_part_alone(group, part, status)
        document.recompute()
        group.Proxy.show(group)
    return group


def new_reconstruction(document: FreeCAD.Document, job: ReconstructJob) -> FreeCAD.DocumentObject:
    """Add a group for a drawing that no run has ended on, within the caller's undo step."""
    group = _new_group(document, job)
    add_properties(group, drawing_properties(job, group))
    return group


def show_solution(group: FreeCAD.DocumentObject, shape: Part.Shape, report: Report) -> None:
    """Give the part of a group another shape, and the group what is known of it, in place."""
    change_part(find_part(group), shape, report)
    add_properties(group, [*report_properties(report), *engine_properties(report)])


def _new_group(document: FreeCAD.Document, job: ReconstructJob) -> FreeCAD.DocumentObject:
    group = document.addObject("App::DocumentObjectGroupPython", "Reconstruction")
    Reconstruction(group)
    label = translate("GaussianCAD", "Reconstruction of {name}")
    group.Label = label.format(name=Path(job.sheet).stem)
    return group


def _fill(group: FreeCAD.DocumentObject, run: LoadedRun) -> None:
    """Give a group the properties and features of a run that has ended."""
    clear_report(group)
    add_properties(group, run_properties(run, group))
    put_features(group, run)
    hidden = [child.Name for child in group.Group if not child.Visibility]
    add_properties(group, [hidden_property(hidden)])
    group.Document.recompute()
    group.Proxy.show(group)
