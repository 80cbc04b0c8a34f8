"""What strokes stand for and views show, in ``reading.json`` and on the canvas."""

from enum import Enum


class ViewRole(Enum):
    """What a view shows: a principal view, or something that is none."""

    FRONT = "front"
    TOP = "top"
    RIGHT = "right"
    LEFT = "left"
    BOTTOM = "bottom"
    REAR = "rear"
    SECTION = "section"
    DETAIL = "detail"
    AUXILIARY = "auxiliary"
    PICTORIAL = "pictorial"
    IGNORE = "ignore"


class StrokeKind(Enum):
    """What a stroke stands for (ISO 128-2, ISO 129-1)."""

    VISIBLE = "visible"
    HIDDEN = "hidden"
    CENTRE = "centre"
    TANGENT = "tangent"
    CUT = "cut"
    HATCH = "hatch"
    DIMENSION = "dimension"
    EXTENSION = "extension"
    LEADER = "leader"
    FRAME = "frame"
    TEXT = "text"
    THREAD = "thread"
    SYMBOL = "symbol"
    PICTURE = "picture"
    IGNORE = "ignore"


DRAWN = (StrokeKind.VISIBLE, StrokeKind.HIDDEN)
"""Kinds that the part is made of."""

KIND_COLOURS = {
    StrokeKind.VISIBLE: "#145ac8",
    StrokeKind.HIDDEN: "#d63c8c",
    StrokeKind.CENTRE: "#c88200",
    StrokeKind.TANGENT: "#5a96dc",
    StrokeKind.CUT: "#aa3c00",
    StrokeKind.HATCH: "#96aa3c",
    StrokeKind.DIMENSION: "#3c963c",
    StrokeKind.EXTENSION: "#6eb46e",
    StrokeKind.LEADER: "#3caa8c",
    StrokeKind.THREAD: "#785ac8",
}
"""Colours of ``reading.png`` and of the canvas, told apart by people with any eyes."""

OTHER_COLOUR = "#969696"
"""Of all other kinds."""

DOUBT = 0.62
"""Confidence below which a stroke may be of either kind: log-odds of half."""


def rgb(colour: str) -> tuple[int, int, int]:
    """``#rrggbb`` as numbers from 0 to 255."""
    return int(colour[1:3], 16), int(colour[3:5], 16), int(colour[5:7], 16)
