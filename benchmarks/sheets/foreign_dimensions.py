"""Dimensions, centre marks and their looks on sheets as other programs draw them.

What is dimensioned is simple: extents, a few edges and a few circles of each view.  How it looks
is what programs differ in: arrowheads, widths, greys, gaps, the place of the numbers.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.drawn_view import DrawnView
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.views import Arc, Linetype, Segment

_ARROWS = ("filled", "wide", "open", "slash", "dot")
_FONTS = ("DejaVu Sans", "DejaVu Sans Mono", "DejaVu Serif")

_APART = 1.2
"""Heights of the letters that two dimensioned edges are at least apart."""

_EDGES, _CIRCLES = 2, 2
"""Most of them that a view and direction, or a view, has."""

_CLEAR = 0.2
"""Distance of a number from other ink at least, in heights of the letters."""

_LETTER = 0.88
"""Width of a digit per height of the letters."""

_STEP = 2.0
"""px between the points that tell where ink is."""

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Piece:
    """SVG of a line, an arrowhead or a number, and points (n, 2) px about where its ink is."""

    svg: str
    points: Floats


@dataclass(frozen=True)
class DimensionLook:
    """How a program draws dimensions; lengths in px.

    Attributes:
        arrow: "filled", "wide", "open", "slash" or "dot".
        size: length of an arrowhead.
        width: of all lines of dimensions.
        level: grey of them, 0 for black.
        text: height of capitals.
        font: of the numbers.
        inline: whether the line is broken for its number, which else stands above it.
        level_text: whether the numbers of upright dimensions are level too.
        first, pitch: from the view to the nearest dimension line, and from line to line.
        off: from the middle of an edge to its extension line.
        over: from a dimension line to the ends of its extension lines.
        marks: "none", "cross" or "lines": what the centre of a circle has.
    """

    arrow: str
    size: float
    width: float
    level: int
    text: float
    font: str
    inline: bool
    level_text: bool
    first: float
    pitch: float
    off: float
    over: float
    marks: str

    @classmethod
    def drawn_by_lot(cls, seed: int, visible: float, width: int) -> "DimensionLook":
        """That of some program, for sheets with visible lines and a width of so many px."""
        lot = np.random.default_rng((seed, 1))
        text = float(round(width * lot.uniform(0.009, 0.013)))
        look = cls(
            arrow=str(lot.choice(_ARROWS, p=[0.4, 0.15, 0.2, 0.15, 0.1])),
            size=text * float(lot.uniform(0.6, 1.0)),
            width=float(lot.choice([visible, max(1.0, 0.5 * visible), max(1.0, visible - 1.0)])),
            level=int(lot.choice([0, 0, 0, 80])),
            text=text,
            font=str(lot.choice(_FONTS)),
            inline=bool(lot.random() < 0.35),
            level_text=bool(lot.random() < 0.35),
            first=text * float(lot.uniform(1.8, 2.6)),
            pitch=text * float(lot.uniform(1.9, 2.6)),
            off=float(lot.choice([0.0, 0.15, 0.3])) * text,
            over=float(lot.uniform(0.2, 0.5)) * text,
            marks=str(lot.choice(["none", "cross", "lines"])),
        )
        # Where all lines are of one width, an extension line without a gap would be its edge.
        least = 0.15 * text if look.width == visible else 0.0
        return replace(look, off=max(look.off, least) + 0.5 * visible)

    def reach(self, rows: int) -> float:
        """px beside a view that so many rows of dimensions take."""
        return self.first + (rows - 1) * self.pitch + self.over + self.text

    @property
    def pen(self) -> str:
        """SVG attributes of a line."""
        grey = f"rgb({self.level},{self.level},{self.level})"
        return f'fill="none" stroke="{grey}" stroke-width="{self.width:.2f}"'


def view_dimensions(
    view: DrawnView, look: DimensionLook, mm_per_pixel: float, sides: tuple[int, int], rows: int
) -> Iterator[str]:
    """SVG of a view's dimensions and centre marks.

    Args:
        view: on its sheet.
        look: of all of them.
        mm_per_pixel: scale of the sheet.
        sides: 1 or -1: level dimensions below or above, upright ones right or left of the view.
        rows: of dimension lines that have room on a side.
    """
    pieces = [
        piece
        for direction, side in enumerate(sides)
        for piece in _along(view, (direction, side), look, mm_per_pixel, rows)
    ]
    whole = [stroke for stroke in _arcs(view) if abs(stroke.sweep) > 6.28]
    ink = np.concatenate([piece.points for piece in pieces] + [_points(s) for s in view.strokes])
    pieces += _diameters(whole, ink, look, mm_per_pixel)
    pieces += [piece for circle in whole for piece in _centre(circle, look)]
    yield from (piece.svg for piece in pieces)


def _along(
    view: DrawnView, adjacent: tuple[int, int], look: DimensionLook, scale: float, rows: int
) -> Iterator[_Piece]:
    """Dimensions in a direction (0 level, 1 upright) on a side, the shorter ones nearer to it."""
    direction, side = adjacent
    low, high = view.box[direction], view.box[direction + 2]
    border = view.box[3 - direction] if side > 0 else view.box[1 - direction]
    ends = {low: border, high: border}
    for at, across in sorted(_edges(view, direction, side), key=lambda edge: -side * edge[1]):
        apart = min(abs(at - other) for other in ends)
        if apart > _APART * look.text and len(ends) < _EDGES + 2:
            ends[at] = across
    first, *others = sorted(ends)
    # From outside in: no number stands on an extension line that leads past it.
    ink = [_points(stroke) for stroke in view.strokes]
    rows_of = list(enumerate(others[max(0, len(others) - rows) :]))
    for row, at in reversed(rows_of):
        line = border + side * (look.first + row * look.pitch)
        pieces = []
        for place, across in ((first, ends[first]), (at, ends[at])):
            start = across + side * look.off
            pieces.append(
                _chain([(place, start), (place, line + side * look.over)], direction, look)
            )
        stated = f"{(at - first) * scale:.4g}"
        *lines, number = _dimension((first, at), line, direction, look, stated)
        if at == others[-1] or _is_clear(number, ink, look):
            yield from (*pieces, *lines, number)
            ink += [piece.points for piece in (*pieces, *lines, number)]


def _is_clear(number: _Piece, ink: Sequence[Floats], look: DimensionLook) -> bool:
    """Whether a number is where no ink is."""
    low, high = number.points.min(axis=0), number.points.max(axis=0)
    near = np.concatenate(ink)
    apart = np.maximum(np.maximum(low - near, near - high), 0.0)
    return bool(np.hypot(*apart.T).min() > _CLEAR * look.text)


def _edges(view: DrawnView, direction: int, side: int) -> Iterator[tuple[float, float]]:
    """Places of visible edges across a direction, and of their ends nearer to a side."""
    for stroke in view.strokes:
        if isinstance(stroke, Segment) and stroke.linetype is Linetype.VISIBLE:
            start, end = np.array(stroke.start), np.array(stroke.end)
            if abs(start[direction] - end[direction]) < 1e-6:
                across = sorted((start[1 - direction], end[1 - direction]))
                yield float(start[direction]), float(across[1] if side > 0 else across[0])


def _dimension(
    ends: tuple[float, float], line: float, direction: int, look: DimensionLook, text: str
) -> Iterator[_Piece]:
    """A dimension line with its arrowheads and number."""
    first, last = ends
    middle, wide = 0.5 * (first + last), (len(text) * _LETTER + 0.6) * look.text
    level = look.level_text and direction == 1
    taken = (1.6 * look.text if level else wide) if look.inline or level else 0.0
    inside = last - first > wide + 4.0 * look.size
    away = 0.0 if inside else 2.0 * look.size
    if not inside:
        # Too narrow: arrowheads from outside, the number on the second one's line or behind it.
        shoulder = 0.5 * look.text if taken else wide
        yield _chain([(first - away, line), (first, line)], direction, look)
        yield _chain([(last, line), (last + away + shoulder, line)], direction, look)
        middle = last + away + 0.5 * wide + (shoulder if taken else 0.0)
    elif taken:
        yield _chain([(first, line), (middle - 0.5 * taken, line)], direction, look)
        yield _chain([(middle + 0.5 * taken, line), (last, line)], direction, look)
    else:
        yield _chain([(first, line), (last, line)], direction, look)
    for tip, towards in ((first, 1.0 if inside else -1.0), (last, -1.0 if inside else 1.0)):
        yield _head((tip, line), (tip + towards, line), direction, look)
    across = line if taken else line - 0.35 * look.text - 0.5 * look.width
    centre = (middle, across + (0.36 * look.text if taken and not level else 0.0))
    yield _number(text, centre, direction, look, level)


def _number(
    text: str, place: tuple[float, float], direction: int, look: DimensionLook, level: bool
) -> _Piece:
    along, across = place
    x, y = (along, across) if direction == 0 else (across, along)
    upright = direction == 1 and not level
    turn = f' transform="rotate(-90 {x:.2f} {y:.2f})"' if upright else ""
    if level:
        y += 0.36 * look.text
    size = look.text / 0.73
    svg = (
        f'<text x="{x:.2f}" y="{y:.2f}" font-size="{size:.1f}" text-anchor="middle" '
        f'fill="rgb({look.level},{look.level},{look.level})" '
        f'font-family="{look.font}, sans-serif"{turn}>{text}</text>'
    )
    half, up = 0.5 * _LETTER * len(text) * look.text, np.linspace(0.0, look.text, 4)
    box = np.stack(np.meshgrid(np.linspace(-half, half, 8), -up), axis=2).reshape(-1, 2)
    return _Piece(svg, np.array([x, y]) + (box[:, ::-1] * (1.0, -1.0) if upright else box))


def _chain(
    points: Sequence[tuple[float, float]], direction: int, look: DimensionLook, rhythm: str = ""
) -> _Piece:
    placed = np.array(points if direction == 0 else [(y, x) for x, y in points])
    chain = " ".join(f"{x:.2f},{y:.2f}" for x, y in placed)
    ink = [np.linspace(a, b, 2 + int(np.hypot(*(b - a)) / _STEP)) for a, b in pairwise(placed)]
    return _Piece(f'<polyline {look.pen}{rhythm} points="{chain}"/>', np.concatenate(ink))


def _head(
    tip: tuple[float, float], inwards: tuple[float, float], direction: int, look: DimensionLook
) -> _Piece:
    """An arrowhead at a tip, for a line that goes on to another point."""
    end, on = np.array(tip), np.array(inwards)
    along = (on - end) / np.hypot(*(on - end))
    aside = np.array([-along[1], along[0]])
    if look.arrow == "slash":
        reach = 0.5 * look.size * (along + aside)
        return _chain([tuple(end - reach), tuple(end + reach)], direction, look)
    grey = f"rgb({look.level},{look.level},{look.level})"
    if look.arrow == "dot":
        x, y = end if direction == 0 else end[::-1]
        dot = f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{0.25 * look.size:.2f}" fill="{grey}"/>'
        return _Piece(dot, np.array([[x, y]]))
    half = 0.3 if look.arrow == "wide" else 0.17
    wings = [end + look.size * (along + way * half * aside) for way in (1.0, -1.0)]
    if look.arrow == "open":
        return _chain([tuple(wings[0]), tip, tuple(wings[1])], direction, look)
    corners = [end, *wings] if direction == 0 else [point[::-1] for point in (end, *wings)]
    chain = " ".join(f"{x:.2f},{y:.2f}" for x, y in corners)
    return _Piece(f'<polygon fill="{grey}" points="{chain}"/>', np.array(corners))


def _arcs(view: DrawnView) -> list[Arc]:
    visible = [stroke for stroke in view.strokes if stroke.linetype is Linetype.VISIBLE]
    return [stroke for stroke in visible if isinstance(stroke, Arc)]


def _centre(circle: Arc, look: DimensionLook) -> Iterator[_Piece]:
    """A circle's centre mark."""
    x, y = circle.centre
    if look.marks == "none":
        return
    reach = circle.radius + 0.6 * look.text if look.marks == "lines" else 0.35 * look.text
    long = 1.6 * look.text
    rhythm = f' stroke-dasharray="{long:.1f},{0.2 * long:.1f},{0.2 * long:.1f},{0.2 * long:.1f}"'
    for one, other in (((x - reach, y), (x + reach, y)), ((x, y - reach), (x, y + reach))):
        yield _chain([one, other], 0, look, rhythm if look.marks == "lines" else "")


def _diameters(
    circles: Sequence[Arc], ink: Floats, look: DimensionLook, scale: float
) -> Iterator[_Piece]:
    """Leaders to circles, their numbers where no ink is, given as points (n, 2) px."""
    said: list[float] = []
    for circle in sorted(circles, key=lambda circle: circle.radius):
        text = f"\u00d8{2.0 * circle.radius * scale:.4g}"
        if any(abs(circle.radius - other) < 0.5 for other in said) or len(said) == _CIRCLES:
            continue
        half = 0.5 * (len(text) * _LETTER + 0.8) * look.text
        for angle, away in [(a, d) for d in (2.0, 3.5, 6.0) for a in (0.9, 2.2, 4.0, 5.4)]:
            way = np.array([np.cos(angle), -np.sin(angle)])
            tip = np.array(circle.centre) + circle.radius * way
            knee = tip + away * look.text * way
            right = 1.0 if way[0] > 0.0 else -1.0
            middle = knee + np.array([right * half, -0.85 * look.text - 0.5 * look.width])
            free = np.abs(ink - middle) > (half + 3.0, look.text + 3.0)
            if not free.any(axis=1).all():
                continue
            end = knee + np.array([2.0 * right * half, 0.0])
            yield _chain([tuple(tip), tuple(knee), tuple(end)], 0, look)
            yield _head((tip[0], tip[1]), (knee[0], knee[1]), 0, look)
            number = _number(text, (middle[0], middle[1]), 0, look, True)
            yield number
            ink = np.concatenate([ink, number.points])
            said.append(circle.radius)
            break


def _points(stroke: DrawnStroke) -> Floats:
    return np.asarray(stroke.sample(_STEP))
