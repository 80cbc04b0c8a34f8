"""Sections by name: a title at the one view, arrows with its letter in another (ISO 128-3).

Two arrows with one letter point the way that a section is looked at.  The part is cut along the
line that they start from, or that they rest on with their tips, as GOST 2.305 has it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.picture_noise import LEVEL, OVERRUN
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.structure.arrowheads import Head
from gaussiancad_core.writing.cutting_line_steps import stepped_path
from gaussiancad_core.writing.dimension_layout import ALONG
from gaussiancad_core.writing.leaders import Leader, pointed_lines
from gaussiancad_core.writing.sheet_texts import SheetText
from gaussiancad_core.writing.titles import Title, TitleKind, looks_of, parse_title

_SHAFT = 5.0
"""Length of an arrow with its shaft at most, in that of its head."""

_TITLE = 0.3
"""Distance from a view to its title at most, in the sheet's shorter side."""

Point = npt.NDArray[np.float64]
Ends = npt.NDArray[np.float64]
"""(n, 2, 2) ends of lines, px."""


@dataclass(frozen=True)
class Trace:
    """Where a part is cut.

    Attributes:
        label: the letters.
        ends: px of the upright sheet, of the cutting line.
        way: (2,) of length 1, px, the direction in which the arrows point.
        path: px, corners of the cutting line from one end to the other; empty where it is in steps
            that were not found.
    """

    label: str
    ends: tuple[tuple[float, float], tuple[float, float]]
    way: tuple[float, float]
    path: tuple[tuple[float, float], ...] = ()

    @property
    def straight(self) -> bool:
        """Whether the cut is one plane."""
        return len(self.path) == 2


@dataclass(frozen=True)
class NamedSection:
    """A section that the sheet names.

    Attributes:
        title: of the section.
        box: around the view that it names, px of the upright sheet.
        trace: where it is cut; None where no arrows with its letter were found.
        cut_in: role of the view that has the trace.
        looks: the role that its arrows tell; None where they point along no axis.
        axis: of the part, that the plane is square to.
    """

    title: Title
    box: Box
    trace: Trace | None = None
    cut_in: Role | None = None
    looks: Role | None = None
    axis: Axis | None = None


def named_sections(
    texts: Sequence[SheetText],
    heads: Sequence[Head],
    lines: Sequence[Leader],
    views: tuple[dict[Role, Box], Sequence[Box], Sequence[Box]],
    turn: Turn,
) -> tuple[NamedSection, ...]:
    """Sections by their titles, with their cutting planes.

    Args:
        texts: of the sheet, px of the upright sheet.
        heads: px of the sheet as stored.
        lines: straight lines, px of the upright sheet.
        views: boxes of principal views by role, of all other drawings, and of those of both that
            are cut: titles between two drawings belong to these.
        turn: of the sheet.
    """
    named, others, hatched = views
    boxes = [*named.values(), *others]
    found = []
    taken: set[str] = set()
    ends = np.array(lines, dtype=float).reshape(-1, 2, 2)
    titled = [(text, title) for text in texts if (title := parse_title(text.text)) is not None]
    sections = [pair for pair in titled if pair[1].kind is TitleKind.SECTION]
    labels = {title.label for _, title in sections}
    for text, title in sections:
        if title.label in taken:
            continue
        box = _nearest(text.box, hatched) or _nearest(text.box, boxes)
        if box is None:
            continue
        taken.add(title.label)
        trace = _trace(title.label, _letters(title.label, labels, texts), heads, ends, turn)
        found.append(_placed(NamedSection(title, box, trace), named))
    return tuple(found)


def _nearest(title: Box, boxes: Sequence[Box]) -> Box | None:
    """The drawing above or below which a title stands."""
    middle = (title[0] + title[2]) / 2.0
    above = [
        (max(box[1] - title[3], title[1] - box[3], 0.0), box)
        for box in boxes
        if box[0] <= middle <= box[2]
    ]
    near = min(above, key=lambda pair: pair[0], default=None)
    if near is None:
        return None
    sides = [max(box[2] - box[0], box[3] - box[1]) for box in boxes]
    return near[1] if near[0] <= _TITLE * max(sides) + 4.0 * (title[3] - title[1]) else None


def _letters(label: str, labels: set[str], texts: Sequence[SheetText]) -> list[Box]:
    """The texts that are a section's letters; those that only look like them where there are none,
    unless another section has these."""
    written = [(text.text.strip().upper(), text.box) for text in texts]
    boxes = [box for name, box in written if name == label]
    if boxes:
        return boxes
    look = looks_of(label)
    return [box for name, box in written if name not in labels and looks_of(name) == look]


def _trace(
    label: str,
    letters: Sequence[Box],
    heads: Sequence[Head],
    lines: Ends,
    turn: Turn,
) -> Trace | None:
    arrows = []
    for head in heads:
        tip, back = turn.to_upright(
            np.array([head.tip, np.subtract(head.tip, np.multiply(head.length, head.way))])
        )
        led = [start for start, _ in pointed_lines([head], lines, turn)]
        short = [start for start in led if np.hypot(*(start - tip)) <= _SHAFT * head.length]
        tail = min(short, key=lambda p: np.hypot(*(p - back)), default=back)
        near = [_apart(box, place) / (box[3] - box[1]) for box in letters for place in (tip, tail)]
        if near and min(near) <= ALONG:
            way = (tip - back) / np.hypot(*(tip - back))
            rests = None if _square_at(tail, way, lines) else _square_at(tip, way, lines)
            arrows.append((tail if rests is None else tip + rests * way, way))
    pairs = [
        (one, two)
        for one, two in combinations(arrows, 2)
        if one[1] @ two[1] > 0.0 and abs(_cross(one[1], two[1])) <= LEVEL
    ]
    if not pairs:
        return None
    # Straight ones before others, and those that are farthest apart across: the letters stand at
    # the ends of the line.
    one, two = min(
        pairs,
        key=lambda pair: (
            _steps(pair) > 2.0 * OVERRUN,
            -abs(_cross(pair[0][1], pair[1][0] - pair[0][0])),
        ),
    )
    ends = (_plain(one[0]), _plain(two[0]))
    way = _plain(one[1])
    if _steps((one, two)) <= 2.0 * OVERRUN:
        return Trace(label, ends, way, ends)
    return Trace(label, ends, way, stepped_path(ends, way, lines))


def _square_at(point: Point, way: Point, lines: Ends) -> float | None:
    """Px along a direction from a point to the line square to it that the point stands on; None
    where there is none. A tip may end at the edge of a wide line."""
    ahead = (lines - point) @ way
    adjacent = np.sort((lines - point) @ np.array([-way[1], way[0]]), axis=1)
    level = (np.abs(ahead).max(axis=1) <= OVERRUN) & (np.ptp(adjacent, axis=1) > 2.0 * OVERRUN)
    found = ahead[level & (adjacent[:, 0] <= OVERRUN) & (adjacent[:, 1] >= -OVERRUN)].mean(axis=1)
    return min(found.tolist(), key=abs, default=None)


def _steps(pair: tuple[tuple[Point, Point], tuple[Point, Point]]) -> float:
    """px by which the far ends of two arrows are out of line."""
    return abs(float((pair[1][0] - pair[0][0]) @ pair[0][1]))


def _placed(section: NamedSection, named: dict[Role, Box]) -> NamedSection:
    """The section with the view that has its trace, and what that says of its direction."""
    trace = section.trace
    if trace is None:
        return section
    middle = np.mean(trace.ends, axis=0)
    role = next(
        (
            role
            for role, box in named.items()
            if box != section.box
            and box[0] - 1.0 <= middle[0] <= box[2] + 1.0
            and box[1] - 1.0 <= middle[1] <= box[3] + 1.0
        ),
        None,
    )
    if role is None:
        return section
    frame = role.frame
    x, y = trace.way
    level = abs(x) >= abs(y)
    vector = np.array(frame.right if level else frame.up) * int(np.sign(x if level else -y))
    looks = next(
        (this_role for this_role in Role if this_role.frame.look == tuple(vector.tolist())), None
    )
    axis = (frame.right_axis if level else frame.up_axis)[0]
    return NamedSection(section.title, section.box, trace, role, looks, axis)


def _apart(box: Box, point: Point) -> float:
    dx = max(box[0] - point[0], point[0] - box[2], 0.0)
    dy = max(box[1] - point[1], point[1] - box[3], 0.0)
    return float(np.hypot(dx, dy))


def _cross(one: Point, two: Point) -> float:
    return float(one[0] * two[1] - one[1] * two[0])


def _plain(point: Point) -> tuple[float, float]:
    return float(point[0]), float(point[1])
