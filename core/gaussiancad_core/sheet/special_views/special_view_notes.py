"""What the report says of drawings that are no plain principal views."""

from collections.abc import Sequence
from dataclasses import dataclass

from gaussiancad_core.messages import Message
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.view_kinds import SECTIONS, SpecialKind, SpecialView
from gaussiancad_protocol.codes import Code

_MOST_PLACES = 5
"""Boxes that one message names at most."""

UNUSED = Code.UNUSED_VIEW
"""Code of whatever shows the part and was not used."""


@dataclass(frozen=True)
class Telling:
    """A message about special views.

    Attributes:
        code: kebab-case.
        message: one sentence that names the boxes, with its values.
        doubt: whether it is a reason why the model is not verified; otherwise it is a warning.
    """

    code: str
    message: str
    doubt: bool


def special_view_messages(special: Sequence[SpecialView]) -> list[Telling]:
    """One message for each kind, in the order of the kinds; sections beside plain views, which take
    the place of none, leave nothing in doubt.

    Args:
        special: with boxes in px of the sheet as stored.
    """
    found = []
    for kind in SpecialKind:
        for used in (False, True):
            boxes = [
                view.box
                for view in special
                if view.kind is kind and view.used is used and not view.adjacent
            ]
            if boxes:
                found.append(_note_on(kind, used, boxes))
    return found


def _note_on(kind: SpecialKind, used: bool, boxes: list[Box]) -> Telling:
    places, doubt = _places(boxes), True
    if not used:
        doubt = kind not in _ILLUSTRATIONS
        code = UNUSED if doubt else _ILLUSTRATIONS[kind][0]
        template, why = "{what} at {places} px was not used: {why}", why_unused(kind)
    elif kind in SECTIONS:
        code, template, why = (
            Code.SECTION_USED,
            "{what} at {places} px stands for a view: {why}",
            _CUT,
        )
    else:
        code, template, why = _USED[kind], "{what} at {places} px: {why}", _DOUBTS[kind]
    values = {"kind": kind, "count": len(boxes), "places": places, "why": why}
    return Telling(code, Message(template, boxes=boxes, what=_NAMES[kind], **values), doubt)


def why_unused(kind: SpecialKind) -> str:
    """What leaving out a drawing of a kind means, in a clause."""
    if kind in _ILLUSTRATIONS:
        return _ILLUSTRATIONS[kind][1]
    return "it shows the part as well: what it shows may be missing"


def _places(boxes: list[Box]) -> str:
    places = ["({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in boxes[:_MOST_PLACES]]
    return "; ".join(places)


_NAMES = {
    SpecialKind.SECTION: "a section",
    SpecialKind.HALF_SECTION: "a half section",
    SpecialKind.PARTIAL_SECTION: "a view with a broken-out section",
    SpecialKind.PICTORIAL: "a pictorial view",
    SpecialKind.DETAIL: "an enlarged detail",
    SpecialKind.AUXILIARY: "an auxiliary view",
    SpecialKind.OTHER_PART: "views of another part",
    SpecialKind.BROKEN: "a broken view",
    SpecialKind.HALF: "a half view",
    SpecialKind.THREAD: "a thread symbol",
}

_ILLUSTRATIONS = {
    SpecialKind.PICTORIAL: (Code.PICTORIAL_LEFT_OUT, "it illustrates what the views show"),
    SpecialKind.THREAD: (
        Code.THREAD_LEFT_OUT,
        "the model has the plain cylinder that the wide lines show",
    ),
}
"""Code, and why nothing is missing without it, of what shows no more than the views do."""

_CUT = "what was cut away before it no line shows"

_USED = {
    SpecialKind.BROKEN: Code.BROKEN_VIEW,
    SpecialKind.HALF: Code.HALF_VIEW,
}

_DOUBTS = {
    SpecialKind.BROKEN: "its length is not as drawn, as a piece of the part is left out",
    SpecialKind.HALF: "what lies beyond its centre line was taken as its mirror image",
}
