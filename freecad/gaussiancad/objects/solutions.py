"""The solids of a reconstruction that all have the drawing's lines, and the choice among them.

Each is a feature of the group: the part, and its alternatives.  Looking at one changes nothing but
what is shown; keeping one gives its shape to the part, so that whatever was built on the part
follows, and removes the alternatives, in one undo step.
"""

from dataclasses import dataclass

import FreeCAD
import Part

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate
from freecad.gaussiancad.objects.properties import PropertySpec, add_properties
from freecad.gaussiancad.objects.reconstruction_features import ALTERNATIVE, CHOICE, find_part
from freecad.gaussiancad.objects.transaction import transaction

_SAME = 1e-7
"""Share of a solid's volume below which a difference is rounding."""


@dataclass(frozen=True)
class Region:
    """Material that one solid has and another has not.

    Attributes:
        volume: mm³; 0 where there is none.
        shape: the material; None where there is none.
    """

    volume: float
    shape: Part.Shape | None


@dataclass(frozen=True)
class Difference:
    """How a solid differs from another one: what it adds, and what it lacks."""

    more: Region
    less: Region


class SolutionSet:
    """The solutions of a reconstruction, by rank; the first is the part.

    Args:
        group: the reconstruction.
    """

    def __init__(self, group: FreeCAD.DocumentObject) -> None:
        self._document = group.Document.Name
        self._group = group.Name
        features = _features(group)
        self.names = tuple(feature.Name for feature in features)
        self._visible = {feature.Name: feature.Visibility for feature in features}
        self._differences: dict[int, Difference] = {}

    def __len__(self) -> int:
        return len(self.names)

    @property
    def alive(self) -> bool:
        """Whether the document still has all of them."""
        if self._document not in FreeCAD.listDocuments():
            return False
        document = FreeCAD.getDocument(self._document)
        return all(document.getObject(name) is not None for name in (self._group, *self.names))

    @property
    def group(self) -> FreeCAD.DocumentObject:
        """The reconstruction."""
        return FreeCAD.getDocument(self._document).getObject(self._group)

    def feature(self, place: int) -> FreeCAD.DocumentObject:
        """The solution at a place, counted from 0."""
        return FreeCAD.getDocument(self._document).getObject(self.names[place])

    def show(self, place: int) -> None:
        """Show one solution, and hide the others."""
        for other in range(len(self)):
            self.feature(other).Visibility = other == place

    def restore(self) -> None:
        """Show and hide as it was when the set was made."""
        if self.alive:
            for place, name in enumerate(self.names):
                self.feature(place).Visibility = self._visible[name]

    def difference(self, place: int) -> Difference:
        """How a solution differs from the first; computed once, in seconds for large parts."""
        if place not in self._differences:
            item, first = self.feature(place).Shape, self.feature(0).Shape
            self._differences[place] = Difference(_beyond(item, first), _beyond(first, item))
        return self._differences[place]

    def keep(self, place: int) -> None:
        """Make a solution the part and remove the alternatives, in one undo step.

        An alternative that something else in the document uses stays, hidden.

        Raises:
            WorkbenchError: the document was closed, or a solution was removed from it.
        """
        if not self.alive:
            text = translate("GaussianCAD", "The solutions are not in the document any more.")
            raise WorkbenchError(ErrorCode.SOLUTIONS_GONE, text)
        # What undoing brings back is hidden as it was.
        self.restore()
        group, chosen = self.group, self.feature(place)
        document = group.Document
        with transaction(document, translate("GaussianCAD", "Keep Solution")):
            part = self.feature(0)
            if place:
                part.Shape = chosen.Shape.copy()
            _note_choice(group, f"{place + 1} / {len(self)}")
            for other in range(1, len(self)):
                alternative = self.feature(other)
                if all(user.Name == self._group for user in alternative.InList):
                    document.removeObject(alternative.Name)
            document.recompute()
        part.Visibility = True


def has_choice(group: FreeCAD.DocumentObject) -> bool:
    """Whether an object is a reconstruction with more than one solution, none of them kept."""
    known = hasattr(group, "ReportJson") and not getattr(group, CHOICE, "")
    return known and len(_features(group)) > 1


def group_with_choice(document: FreeCAD.Document | None) -> FreeCAD.DocumentObject | None:
    """The last reconstruction of a document that has more than one solution, or None."""
    objects = document.Objects if document is not None else []
    return next((one for one in reversed(objects) if has_choice(one)), None)


def _features(group: FreeCAD.DocumentObject) -> list[FreeCAD.DocumentObject]:
    """The exact part and its alternatives; nothing where the part is not exact."""
    part = find_part(group)
    if part is None or not getattr(part, "Exact", False):
        return []
    return [part, *(child for child in group.Group if child.Name.startswith(ALTERNATIVE))]


def _note_choice(group: FreeCAD.DocumentObject, choice: str) -> None:
    tip = QT_TRANSLATE_NOOP("App::Property", "Which of the solutions was kept by hand")
    if hasattr(group, CHOICE):
        setattr(group, CHOICE, choice)
    else:
        add_properties(group, [PropertySpec("String", CHOICE, "Report", tip, choice)])


def _beyond(one: Part.Shape, other: Part.Shape) -> Region:
    """What of one solid lies outside of another."""
    rest = one.cut(other)
    volume = rest.Volume if rest.Solids else 0.0
    return Region(volume, rest) if volume > _SAME * one.Volume else Region(0.0, None)
