"""The engine's messages and stages in the words of the window, in the user's language."""

import re
from collections.abc import Mapping
from enum import Enum

from freecad.gaussiancad.engine.sentences import ALTERNATIVES, SENTENCES
from freecad.gaussiancad.language import translate

_BETWEEN = re.compile(r", | and ")


class Place(Enum):
    """Where a sentence is said."""

    CANVAS = "canvas"
    """In *Correct Sheet*: nobody need be sent there."""
    ELSEWHERE = "elsewhere"


def worded(
    code: str,
    message: str,
    args: Mapping[str, object] | None = None,
    place: Place = Place.ELSEWHERE,
) -> str:
    """What a message of the engine says to who uses the window.

    Args:
        code: of the message.
        message: the engine's own sentence, English; what stays where nothing better is known.
        args: the values in it, as the engine sends them; None where it sent none.
        place: where it is said.
    """
    values = args if isinstance(args, Mapping) else {}
    for key in (f"{code}:{values.get('case')}", code):
        sentence = _filled(SENTENCES.get(key, ""), values, place)
        if sentence:
            return sentence
    return message or code


def alternative(code: str, message: str) -> str:
    """What else there may be than what was assumed.

    Args:
        code: of the assumption.
        message: the engine's own words, English.
    """
    return _filled(ALTERNATIVES.get(code, ""), {}) or message


def stage_name(name: str) -> str:
    """What the engine does in a stage; an unknown one keeps its name."""
    return {
        "read": translate("GaussianCAD", "reading the sheet"),
        "views": translate("GaussianCAD", "finding the views"),
        "lines": translate("GaussianCAD", "reading the lines"),
        "masks": translate("GaussianCAD", "bringing the views together"),
        "solid": translate("GaussianCAD", "finding the solid"),
        "hull": translate("GaussianCAD", "carving the outlines"),
        "gaussians": translate("GaussianCAD", "training the Gaussians"),
        "surface": translate("GaussianCAD", "making the surface"),
        "judge": translate("GaussianCAD", "holding the model against the views"),
        "check": translate("GaussianCAD", "checking against the sheet"),
        "write": translate("GaussianCAD", "writing the files"),
    }.get(name, name.replace("-", " ").replace("_", " "))


def role_name(role: str) -> str:
    """The name of a view, for people; an unknown one stays as it is."""
    return {
        "front": translate("GaussianCAD", "front"),
        "top": translate("GaussianCAD", "top"),
        "right": translate("GaussianCAD", "right"),
        "left": translate("GaussianCAD", "left"),
        "bottom": translate("GaussianCAD", "bottom"),
        "rear": translate("GaussianCAD", "rear"),
    }.get(role, role)


def drawing_name(kind: str) -> str:
    """What a drawing is that is no plain view; an unknown one stays as it is."""
    return {
        "section": translate("GaussianCAD", "section"),
        "half-section": translate("GaussianCAD", "half section"),
        "partial-section": translate("GaussianCAD", "broken-out section"),
        "pictorial": translate("GaussianCAD", "pictorial view"),
        "detail": translate("GaussianCAD", "enlarged detail"),
        "auxiliary-view": translate("GaussianCAD", "auxiliary view"),
        "other-part": translate("GaussianCAD", "views of another part"),
        "broken-view": translate("GaussianCAD", "broken view"),
        "half-view": translate("GaussianCAD", "half view"),
        "thread": translate("GaussianCAD", "thread symbol"),
        "lines": translate("GaussianCAD", "group of lines"),
    }.get(kind, kind)


def _filled(sentence: str, values: Mapping[str, object], place: Place = Place.ELSEWHERE) -> str:
    """A sentence in the user's language with its values; empty where one is missing."""
    if not sentence:
        return ""
    words = {name: _word(name, value) for name, value in values.items()}
    words["canvas"] = _way_to_canvas(place)
    try:
        return translate("GaussianCAD", sentence).format_map(words)
    except LookupError:
        return ""


def _way_to_canvas(place: Place) -> str:
    """The words for where lines are corrected, as they stand in a sentence."""
    if place is Place.CANVAS:
        return translate("GaussianCAD", "here")
    return translate("GaussianCAD", "in Correct Sheet")


def _word(name: str, value: object) -> str:
    """A value for its place in a sentence: words of the engine in the user's language."""
    if isinstance(value, float):
        # Of what is less than one, such as a distance in mm, two digits say enough.
        return f"{value:.4g}" if abs(value) >= 1.0 else f"{value:.2g}"
    text = str(value)
    if name in ("view", "views"):
        return ", ".join(role_name(item) for item in _BETWEEN.split(text))
    if name == "kind":
        return drawing_name(text)
    return _words(name).get(text, text)


def _words(name: str) -> dict[str, str]:
    """What the engine may send as a value of a name."""
    if name in ("taken", "other", "symbol"):
        return {
            "first": translate("GaussianCAD", "first angle"),
            "third": translate("GaussianCAD", "third angle"),
        }
    return {
        "linetype": {
            "visible": translate("GaussianCAD", "visible line"),
            "hidden": translate("GaussianCAD", "hidden line"),
        },
        "model": {
            "result": translate("GaussianCAD", "the result"),
            "reference": translate("GaussianCAD", "the reference"),
        },
    }.get(name, {})
