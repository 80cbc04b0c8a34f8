"""Strokes whose kind is in doubt: why each is what it is, what else it may be, how to say so."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import hypot

from freecad.gaussiancad.canvas import corrections
from freecad.gaussiancad.canvas.kinds import DRAWN, name_of
from freecad.gaussiancad.canvas.rows import Line
from freecad.gaussiancad.canvas.sheet import Box, Sheet, Stroke
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate

MOST = 20
"""Strokes that are listed, the most doubtful ones."""

_WHY = {
    "network": QT_TRANSLATE_NOOP("GaussianCAD", "Its ink looks like that."),
    "pen": QT_TRANSLATE_NOOP("GaussianCAD", "Its width, color or rhythm tells it."),
    "line": QT_TRANSLATE_NOOP("GaussianCAD", "The rest of its line tells it, against its look."),
    "figure": QT_TRANSLATE_NOOP("GaussianCAD", "The figure that it is a part of tells it."),
    "loose-end": QT_TRANSLATE_NOOP("GaussianCAD", "As an edge it would end at no other edge."),
    "loose-end:part": QT_TRANSLATE_NOOP(
        "GaussianCAD", "Without it other edges would end at nothing."
    ),
    "linetype": QT_TRANSLATE_NOOP("GaussianCAD", "Its dashes, or its pen, tell it."),
}
"""What decided, by the engine's name of it."""


def doubts_of(sheet: Sheet) -> list[Stroke]:
    """The strokes in doubt that are of the part, or lie at its views: the most doubtful first, of
    two equal ones the longer."""
    frames = [view.frame for view in sheet.views if view.shown]
    found = [
        stroke
        for stroke in sheet.strokes
        if stroke.doubtful and (stroke.kind in DRAWN or _at(stroke, frames))
    ]
    return sorted(found, key=lambda item: (item.confidence, -_long(item)))


def doubt_in_words(stroke: Stroke) -> str:
    """What a stroke is, how sure that is, why, and what else it may be."""
    stated = translate("GaussianCAD", "In doubt: {kind}, {share} sure.").format(
        kind=name_of(stroke.kind), share=f"{stroke.confidence:.0%}"
    )
    part = stroke.why == "loose-end" and stroke.kind in DRAWN
    why = _WHY.get(f"{stroke.why}:part" if part else stroke.why, "")
    words = [stated, translate("GaussianCAD", why)] if why else [stated]
    if stroke.otherwise:
        other = translate("GaussianCAD", "Otherwise: {0}")
        words.append(other.format(name_of(stroke.otherwise)))
    return " ".join(words)


def doubt_lines(sheet: Sheet, correct: Callable[[list[dict]], None]) -> list[Line]:
    """Rows of the strokes in doubt, the most doubtful first, each with a yes and a no.

    Args:
        sheet: that is shown.
        correct: takes what a button says.
    """
    doubts = doubts_of(sheet)
    lines = [_line(doubt, correct) for doubt in doubts[:MOST]]
    if len(doubts) > MOST:
        more = translate("GaussianCAD", "More lines in doubt: {0}")
        lines.append(Line(more.format(len(doubts) - MOST)))
    return lines


def _line(stroke: Stroke, correct: Callable[[list[dict]], None]) -> Line:
    def saying_that(kind: str) -> Callable[[], None]:
        return lambda: correct(corrections.set_kind([stroke], kind))

    yes = translate("GaussianCAD", "Yes: {0}").format(name_of(stroke.kind))
    buttons = [(yes, saying_that(stroke.kind))]
    if stroke.otherwise:
        no = translate("GaussianCAD", "No: {0}").format(name_of(stroke.otherwise))
        buttons.append((no, saying_that(stroke.otherwise)))
    return Line(f"\u26a0 {doubt_in_words(stroke)}", _box(stroke), tuple(buttons))


def _box(stroke: Stroke) -> Box:
    xs, ys = zip(*stroke.points(), strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _at(stroke: Stroke, frames: list[Box]) -> bool:
    """Whether a stroke meets any of some boxes."""
    x0, y0, x1, y1 = _box(stroke)
    return any(
        x0 <= frame[2] and frame[0] <= x1 and y0 <= frame[3] and frame[1] <= y1 for frame in frames
    )


def _long(stroke: Stroke) -> float:
    return sum(hypot(x1 - x0, y1 - y0) for (x0, y0), (x1, y1) in pairwise(stroke.points()))
