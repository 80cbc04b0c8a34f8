"""The features of a reconstruction: the part, its alternatives, the surface, Gaussians and views.

A run that follows another one changes the features that are there and keeps them the objects that
they are, with their place, so that whatever was built on them lives.
"""

import FreeCAD
import Part

from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import Report
from freecad.gaussiancad.engine.wording import role_name
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.bodies_of_parts import set_shape
from freecad.gaussiancad.objects.gaussians import fill_points
from freecad.gaussiancad.objects.loading import LoadedPart, LoadedRun, PartSource
from freecad.gaussiancad.objects.properties import add_properties
from freecad.gaussiancad.objects.reconstruction_properties import (
    agreement_property,
    alternative_properties,
    part_properties,
)
from freecad.gaussiancad.objects.sheet_views import fill_image_plane

CHOICE = "Choice"
"""The property that says which of several solutions a person kept; empty where none."""

ALTERNATIVE = "Alternative"
"""How the names of the alternatives begin."""

_PART, _SURFACE, _GAUSSIANS, _VIEW = "Part", "Surface", "Gaussians", "View_"

_TYPES = {
    _PART: "Part::Feature",
    ALTERNATIVE: "Part::Feature",
    _SURFACE: "Mesh::Feature",
    _GAUSSIANS: "Points::Feature",
    _VIEW: "Image::ImagePlane",
}
"""Types of the features, by how their names begin."""


def find_part(group: FreeCAD.DocumentObject) -> FreeCAD.DocumentObject | None:
    """The part of a reconstruction, or None."""
    return next((child for child in group.Group if child.Name.startswith(_PART)), None)


def part_length(group: FreeCAD.DocumentObject) -> float:
    """Diagonal of the box around a reconstruction's part, in mm; 0 without a part."""
    part = find_part(group)
    return 0.0 if part is None or part.Shape.isNull() else part.Shape.BoundBox.DiagonalLength


def put_features(group: FreeCAD.DocumentObject, run: LoadedRun) -> None:
    """Give a group the features of a run; of an earlier run's, those that fit are changed in place.

    What is left of an earlier run goes; what something else in the document uses stays, hidden.
    """
    place = _Place(group)
    if run.part is not None:
        _put_run_part(place, run)
    for number, shape in enumerate(run.alternatives, start=1):
        _put_alternative(place, number, shape, run.report)
    if run.mesh is not None:
        surface, new = place.take(_SURFACE)
        _set_in_place(surface, "Mesh", run.mesh)
        if new:
            surface.Label = translate("GaussianCAD", "Surface")
            # A faceted part is coarser than the surface and slow to show.
            exact = run.part is not None and run.part.source is PartSource.SOLID
            surface.Visibility = not exact
    if run.cloud is not None:
        points, new = place.take(_GAUSSIANS)
        fill_points(points, run.cloud)
        if new:
            points.Label = translate("GaussianCAD", "Gaussians")
            points.Visibility = False
    for view in run.views:
        plane, new = place.take(f"{_VIEW}{view.role}", _TYPES[_VIEW])
        fill_image_plane(plane, view.path, view.plane)
        if new:
            label = translate("GaussianCAD", "View {role}")
            plane.Label = label.format(role=role_name(view.role))
    place.finish()


def put_alternatives(
    group: FreeCAD.DocumentObject, shapes: tuple[Part.Shape, ...], report: Report | None = None
) -> None:
    """Give a group the other solids that have the drawing's lines, in place of those before."""
    place = _Place(group, ALTERNATIVE)
    for number, shape in enumerate(shapes, start=1):
        _put_alternative(place, number, shape, report)
    place.finish()


def put_part_alone(group: FreeCAD.DocumentObject, part: LoadedPart, status: Status) -> None:
    """Give a group the part of a run that goes on, and take away what an earlier run left."""
    place = _Place(group)
    _put_part(place, part, _solid_label(status, sketched=False), status)
    place.finish()


def add_empty_part(group: FreeCAD.DocumentObject) -> None:
    """Add a part without a shape to a group, within the caller's undo step."""
    feature = group.Document.addObject(_TYPES[_PART], _PART)
    feature.Label = translate("GaussianCAD", "Part (not there yet)")
    group.addObject(feature)


def change_part(feature: FreeCAD.DocumentObject, shape: Part.Shape, report: Report) -> None:
    """Give a part another exact shape, and what is known of it."""
    _set_shape(feature, shape)
    _name(feature, _solid_label(report.status, report.sketched))
    add_properties(feature, part_properties(report.status, exact=True))
    if report.agreement is not None:
        add_properties(feature, [agreement_property(report.agreement)])


class _Place:
    """Hands out the features of a group: those that are there, then new ones.

    Args:
        group: the reconstruction.
        names: how the names of the features begin; all of them where none are given.
    """

    def __init__(self, group: FreeCAD.DocumentObject, *names: str) -> None:
        self._group = group
        self._left = [item for item in group.Group if _is_own(item, names or tuple(_TYPES))]
        self._new: list[FreeCAD.DocumentObject] = []

    def take(self, name: str, kind: str = "") -> tuple[FreeCAD.DocumentObject, bool]:
        """A feature whose name begins so, and whether it is new."""
        kind = kind or _TYPES[name]
        for item in self._left:
            if item.Name.startswith(name) and item.TypeId == kind:
                self._left.remove(item)
                return item, False
        made = self._group.Document.addObject(kind, name)
        self._new.append(made)
        return made, True

    def finish(self) -> None:
        """Put what is new into the group, and take away what nobody asked for."""
        self._group.addObjects(self._new)
        for item in self._left:
            if all(user.Name == self._group.Name for user in item.InList):
                self._group.Document.removeObject(item.Name)
            else:
                item.Visibility = False


def _is_own(child: FreeCAD.DocumentObject, names: tuple[str, ...]) -> bool:
    return any(child.Name.startswith(name) and child.TypeId == _TYPES[name] for name in names)


def _set_in_place(feature: FreeCAD.DocumentObject, name: str, geometry: object) -> None:
    """Set the geometry of a feature that stays where the user put it."""
    placement = feature.Placement
    setattr(feature, name, geometry)
    feature.Placement = placement


def _set_shape(part: FreeCAD.DocumentObject, shape: Part.Shape) -> None:
    placement = part.Placement
    set_shape(part, shape)
    part.Placement = placement


def _put_run_part(place: _Place, run: LoadedRun) -> None:
    label = _part_label(run.part, run.report)
    feature, new = _put_part(place, run.part, label, run.report.status)
    if new and run.part.source is PartSource.SURFACE and run.mesh is not None:
        feature.Visibility = False
    if run.part.source is PartSource.SOLID and run.report.agreement is not None:
        add_properties(feature, [agreement_property(run.report.agreement)])


def _put_part(
    place: _Place, part: LoadedPart, label: str, status: Status
) -> tuple[FreeCAD.DocumentObject, bool]:
    feature, new = place.take(_PART)
    _set_shape(feature, part.shape)
    _name(feature, label)
    add_properties(feature, part_properties(status, part.source is PartSource.SOLID))
    return feature, new


def _put_alternative(place: _Place, number: int, shape: Part.Shape, report: Report | None) -> None:
    alternative, new = place.take(ALTERNATIVE)
    _set_in_place(alternative, "Shape", shape)
    if new:
        label = translate("GaussianCAD", "Alternative {number}")
        alternative.Label = label.format(number=number)
        alternative.Visibility = False
    known = report.alternatives if report is not None else ()
    stated = known[number - 1] if number <= len(known) else None
    if stated is not None:
        add_properties(alternative, alternative_properties(stated))


def _name(part: FreeCAD.DocumentObject, label: str) -> None:
    """Label a part, unless the user gave it a name of their own."""
    given = part.Label.rstrip("0123456789")
    if given in _own_labels() or part.Label == part.Name:
        part.Label = label


def _own_labels() -> tuple[str, ...]:
    return (
        translate("GaussianCAD", "Part (not there yet)"),
        translate("GaussianCAD", "Part (faceted, approximate)"),
        *(_solid_label(status, sketched) for status in Status for sketched in (False, True)),
    )


def _part_label(part: LoadedPart, report: Report) -> str:
    if part.source is PartSource.SURFACE:
        return translate("GaussianCAD", "Part (faceted, approximate)")
    return _solid_label(report.status, report.sketched)


def _solid_label(status: Status, sketched: bool) -> str:
    if sketched:
        return translate("GaussianCAD", "Part (slabs, approximate)")
    if status is Status.VERIFIED:
        return translate("GaussianCAD", "Part")
    return translate("GaussianCAD", "Part (approximate)")
