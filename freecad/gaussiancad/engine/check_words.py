"""What a check found, in the words of the window."""

from freecad.gaussiancad.engine.check_file import (
    CheckDifference,
    CheckEdit,
    CheckVerdict,
    DifferenceKind,
    Place,
)
from freecad.gaussiancad.engine.wording import role_name
from freecad.gaussiancad.language import translate


def verdict_words(verdict: CheckVerdict) -> str:
    """Whether the model agrees with the drawing, in a sentence."""
    return {
        CheckVerdict.AGREES: translate("GaussianCAD", "The model agrees with the drawing."),
        CheckVerdict.DIFFERS: translate("GaussianCAD", "The model differs from the drawing."),
        CheckVerdict.CANNOT_TELL: translate(
            "GaussianCAD", "It cannot be told whether the model agrees with the drawing."
        ),
    }[verdict]


def difference_words(difference: CheckDifference) -> tuple[str, str]:
    """In what a model and a drawing differ at a place: in a word, and in a sentence."""
    kind, is_hidden = difference.kind, difference.is_hidden
    if kind is DifferenceKind.MISSING:
        return (
            translate("GaussianCAD", "Missing, hidden")
            if is_hidden
            else translate("GaussianCAD", "Missing"),
            translate("GaussianCAD", "The drawing has a line here that the model does not show."),
        )
    if kind is DifferenceKind.EXTRA:
        return (
            translate("GaussianCAD", "Extra, hidden")
            if is_hidden
            else translate("GaussianCAD", "Extra"),
            translate("GaussianCAD", "The model has an edge here that the drawing does not show."),
        )
    if kind is DifferenceKind.LINETYPE:
        return (
            translate("GaussianCAD", "Linetype"),
            translate("GaussianCAD", "The line is visible in one of both and hidden in the other."),
        )
    if kind is DifferenceKind.PLACE:
        return (
            translate("GaussianCAD", "Hatching"),
            translate("GaussianCAD", "The hatched area is not where the model is cut."),
        )
    if kind in (DifferenceKind.NUMBER, DifferenceKind.NOTE):
        return _stated_words(difference)
    other = translate("GaussianCAD", "Different")
    return other, other


def _stated_words(difference: CheckDifference) -> tuple[str, str]:
    """What the drawing states and what the model has, of a number or a note."""
    stated, found = (f"{value or 0.0:.6g}" for value in (difference.stated, difference.measured))
    if difference.kind is DifferenceKind.NUMBER:
        text = translate("GaussianCAD", "The drawing states {stated} mm, the model has {found} mm.")
        return translate("GaussianCAD", "Number"), text.format(stated=stated, found=found)
    text = translate(
        "GaussianCAD", "Note “{text}”: the drawing says {stated}, the model has {found}."
    )
    sentence = text.format(text=difference.text, stated=stated, found=found)
    return translate("GaussianCAD", "Note"), sentence


def view_words(difference: CheckDifference) -> str:
    """The name of the view, for a section with its letters."""
    role, _, letters = difference.view.partition(" ")
    return f"{role_name(role)} {letters}".rstrip()


def edit_words(edit: CheckEdit) -> str:
    """What to change, in a sentence; the engine's own where that is not known here."""
    sentence = {
        "fill": translate("GaussianCAD", "Fill the hole of {diameter} mm at {start}"),
        "drill": translate("GaussianCAD", "Drill a hole of {diameter} mm at {end}"),
        "move": translate("GaussianCAD", "Move the hole of {diameter} mm from {start} to {end}"),
        "shift": translate("GaussianCAD", "Move the flat face at {start} to {end}"),
        "mirror": translate("GaussianCAD", "Take the mirror image of the model"),
    }.get(edit.what, "")
    values = {
        "diameter": None if edit.diameter is None else f"{edit.diameter:.4g}",
        "start": _place(edit.start),
        "end": _place(edit.end),
    }
    known = {name: value for name, value in values.items() if value is not None}
    try:
        return sentence.format_map(known) or edit.message
    except KeyError:
        return edit.message


def size_words() -> str:
    """That the size is none of the questions."""
    return translate(
        "GaussianCAD", "The drawing does not say how large the part is: the size was not checked."
    )


def _place(place: Place | None) -> str | None:
    return None if place is None else "({:.4g}, {:.4g}, {:.4g})".format(*place)
