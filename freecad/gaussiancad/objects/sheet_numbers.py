"""The drawing's numbers in a body that somebody has changed since, and the way back to them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.bodies_of_parts import bodies_of
from freecad.gaussiancad.objects.body_numbers import set_value, value_of
from freecad.gaussiancad.objects.body_properties import FROM_SHEET, SHEET_VALUES
from freecad.gaussiancad.objects.known_sheets import reconstruction_among
from freecad.gaussiancad.objects.reconstruction_features import find_part
from freecad.gaussiancad.objects.transaction import transaction

_SAME = 1e-6
"""mm by which a number that nobody changed may differ."""


@dataclass(frozen=True)
class ChangedNumber:
    """A number of the drawing that is another in the body.

    Attributes:
        path: by which a person finds it, such as ``Pad1.Length``.
        on_sheet, now: mm, as the drawing has it and as the body has it.
    """

    path: str
    on_sheet: float
    now: float


def changed_numbers(body: FreeCAD.DocumentObject) -> tuple[ChangedNumber, ...]:
    """The drawing's numbers that are others in a body now; those that are gone are left out."""
    found = []
    for path, on_sheet in _numbers_of(body):
        feature, name = _place(body, path)
        now = None if feature is None else value_of(feature, name)
        if now is not None and abs(now - on_sheet) > _SAME:
            found.append(ChangedNumber(path, on_sheet, now))
    return tuple(found)


def back_step() -> str:
    """Name of the undo step, as the user reads it."""
    return translate("GaussianCAD", "Back to the Sheet's Numbers")


def set_back(bodies: Iterable[FreeCAD.DocumentObject]) -> int:
    """Give bodies of one document the drawing's numbers again, in one undo step.

    Returns:
        How many numbers were others.

    Raises:
        ValueError: a sketch has no solution with them any more; the document is left as it was.
    """
    changed = [(body, number) for body in bodies for number in changed_numbers(body)]
    if not changed:
        return 0
    document = changed[0][0].Document
    with transaction(document, back_step()):
        left = changed
        while left:
            late = [each for each in left if not _is_set_back(*each)]
            if len(late) == len(left):
                names = ", ".join(number.path for _, number in late)
                text = translate("GaussianCAD", "These numbers cannot be set back: {names}")
                raise ValueError(text.format(names=names))
            # Another number may have stood in the way.
            left = late
        document.recompute()
    return len(changed)


def bodies_meant(
    document: FreeCAD.Document, selected: Sequence[FreeCAD.DocumentObject]
) -> tuple[FreeCAD.DocumentObject, ...]:
    """The bodies with numbers of a drawing that are selected, or whose reconstruction is; all of
    the document where none of these is."""
    chosen = [each for each in selected if hasattr(each, SHEET_VALUES)]
    group = reconstruction_among(selected)
    if not chosen and group is not None and find_part(group) is not None:
        chosen = list(bodies_of(find_part(group)))
    return tuple(chosen or (each for each in document.Objects if hasattr(each, SHEET_VALUES)))


def _is_set_back(body: FreeCAD.DocumentObject, number: ChangedNumber) -> bool:
    feature, name = _place(body, number.path)
    try:
        set_value(feature, name, number.on_sheet)
    except Exception:  # FreeCAD raises its own types, which differ between versions
        return False
    return True


def _numbers_of(body: FreeCAD.DocumentObject) -> list[tuple[str, float]]:
    listed = [line.partition(" = ")[0] for line in getattr(body, FROM_SHEET, ())]
    return list(zip(listed, getattr(body, SHEET_VALUES, ()), strict=False))


def _place(body: FreeCAD.DocumentObject, path: str) -> tuple[FreeCAD.DocumentObject | None, str]:
    """The feature and the name that a path names."""
    feature, _, name = path.partition(".")
    return body.Document.getObject(feature), name
