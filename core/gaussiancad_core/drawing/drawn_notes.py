"""Diameters and radii on leaders (ISO 128-22, ISO 129-1)."""

from collections import defaultdict
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import Annotation, AnnotationKind, Box, Point
from gaussiancad_core.drawing.annotation_pen import Board, Pen
from gaussiancad_core.drawing.centre_lines import rounds
from gaussiancad_core.drawing.drawn_dimensions import value_text
from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.drawing.lettering import DIAMETER, label, text_width
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.model.views import Arc, Linetype, Segment

Array = npt.NDArray[np.float64]

_ANGLES = (45, 135, -45, -135, 60, 120, -60, -120, 30, 150, -30, -150, 75, 105, -75, -105)
"""Degrees in which leaders leave a circle, the usual ones first; -90 is up the sheet."""

_MOST = 4
"""Most leaders of one view."""


@dataclass(frozen=True)
class Feature:
    """Circles or arcs of one size in a view.

    Attributes:
        text: what is said of them.
        value_mm: diameter or radius.
        arcs: any of them may be pointed at.
    """

    text: str
    value_mm: float
    arcs: tuple[Arc, ...]


@dataclass(frozen=True)
class _Leader:
    """Where a leader runs: tip on the circle, elbow, end of the shelf under the text."""

    tip: Point
    elbow: Point
    end: Point
    text: Box


def draw_notes(board: Board, group: int) -> list[Annotation]:
    """Leaders to the visible circles and fillets, one for each size, as far as there is room.

    Args:
        board: the views; the notes are added to its room.
        group: number of the first note; each counts one up.
    """
    said: set[tuple[Axis, str]] = set()
    drawn: list[Annotation] = []
    for view in board.views:
        count = 0
        for feature in features(view, board.mm_per_pixel):
            key = view.role.frame.look_axis[0], feature.text.split()[-1]
            if key in said or count == _MOST:
                continue
            leader = _find(view, feature, board)
            if leader is None:
                continue
            said.add(key)
            count += 1
            drawn += [
                replace(annotation, group=group) for annotation in _drawn(leader, feature, board)
            ]
            group += 1
    return drawn


def features(view: DrawnView, mm_per_pixel: float) -> list[Feature]:
    """The sizes of the visible circles and arcs of a view, large ones first."""
    whole = {
        (round(circle.centre[0], 1), round(circle.centre[1], 1), round(circle.radius, 1))
        for circle in rounds(view)
        if circle.whole
    }
    sizes: dict[tuple[bool, float], list[Arc]] = defaultdict(list)
    for stroke in view.strokes:
        if isinstance(stroke, Arc) and stroke.linetype is Linetype.VISIBLE:
            key = (round(stroke.centre[0], 1), round(stroke.centre[1], 1), round(stroke.radius, 1))
            sizes[key in whole, round(stroke.radius * mm_per_pixel, 3)].append(stroke)
    found = []
    for (full, radius), arcs in sorted(sizes.items(), key=lambda item: (-item[0][0], -item[0][1])):
        centres = {(round(arc.centre[0], 1), round(arc.centre[1], 1)) for arc in arcs}
        times = f"{len(centres)}x " if len(centres) > 1 else ""
        value = 2.0 * radius if full else radius
        sign = DIAMETER if full else "R"
        found.append(Feature(f"{times}{sign}{value_text(value)}", value, tuple(arcs)))
    return found


def _find(view: DrawnView, feature: Feature, board: Board) -> _Leader | None:
    """The shortest leader whose text is free and whose line crosses no other note or view."""
    best: tuple[float, _Leader] | None = None
    pen = board.pen
    others = [other.box for other in board.views if other is not view]
    width = text_width(feature.text, pen.height)
    for arc in feature.arcs:
        for rank, degrees in enumerate(_ANGLES):
            angle = float(np.radians(degrees))
            if np.mod(angle - arc.start_angle, 2.0 * np.pi) > arc.sweep:
                continue
            way = np.array([np.cos(angle), np.sin(angle)])
            ray = np.array(arc.centre) + arc.radius * way, way
            for clearance in (1.0, 2.2, 3.4, 4.6):
                leader = _leader(view.box, ray, clearance * pen.height, width, pen)
                length = float(np.hypot(*(np.array(leader.tip) - leader.elbow)))
                cost = length + 2.0 * rank
                if best is not None and cost >= best[0]:
                    continue
                if _is_free(leader, view.box, others, board):
                    best = cost, leader
    return None if best is None else best[1]


def _leader(
    view: Box, ray: tuple[Array, Array], clearance: float, width: float, pen: Pen
) -> _Leader:
    """A leader along a ray, from its start out of the view's box to a text of a width."""
    tip, way = ray
    borders = np.where(way > 0.0, view[2:], view[:2])
    with np.errstate(divide="ignore"):
        exits = (borders - tip) / way
    elbow = tip + (float(exits.min()) + clearance / float(np.abs(way).max())) * way
    sign = 1.0 if way[0] >= 0.0 else -1.0
    end = elbow + np.array([sign * (width + pen.gap), 0.0])
    left = min(elbow[0] + sign * pen.gap, end[0])
    top = elbow[1] - pen.gap - pen.height
    box = (float(left), float(top), float(left + width), float(elbow[1]))
    return _Leader(tuple(tip.tolist()), tuple(elbow.tolist()), tuple(end.tolist()), box)


def _is_free(leader: _Leader, pair: Box, others: list[Box], board: Board) -> bool:
    pen, room = board.pen, board.room
    x0, y0, x1, y1 = leader.text
    shelf = (min(x0, leader.elbow[0]), y0, max(x1, leader.elbow[0]), y1)
    if not room.free(shelf, 0.5 * pen.height):
        return False
    way = np.array(leader.elbow) - leader.tip
    steps = max(2, int(np.hypot(*way) / 3.0))
    for share in np.linspace(0.0, 1.0, steps):
        x, y = np.array(leader.tip) + share * way
        # The view itself is taken too: the leader is free to cross it, and to leave it.
        neighbour = max(pair[0] - x, x - pair[2], pair[1] - y, y - pair[3])
        near = 0.2 * pen.height
        if neighbour > near and room.touched((x, y, x, y), near):
            return False
        if any(b[0] <= x <= b[2] and b[1] <= y <= b[3] for b in others):
            return False
    return True


def _drawn(leader: _Leader, feature: Feature, board: Board) -> list[Annotation]:
    pen, room = board.pen, board.room
    room.take(leader.text)
    for share in np.linspace(0.0, 1.0, 12):
        x, y = (np.array(leader.tip) * (1.0 - share) + np.array(leader.elbow) * share).tolist()
        room.take((x - 2.0, y - 2.0, x + 2.0, y + 2.0))
    strokes = (
        Segment(leader.tip, leader.elbow, Linetype.VISIBLE),
        Segment(leader.elbow, leader.end, Linetype.VISIBLE),
    )
    x0, y0, x1, _ = leader.text
    centre = (0.5 * (x0 + x1), y0 + 0.5 * pen.height)
    arrow = pen.arrowhead(leader.tip, leader.elbow)
    return [
        Annotation(
            AnnotationKind.LEADER,
            0,
            strokes,
            pen.width,
            arrows=(arrow,),
            value_mm=feature.value_mm,
        ),
        Annotation(AnnotationKind.TEXT, 0, label=label(feature.text, centre, pen.height)),
    ]
