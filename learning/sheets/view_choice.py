"""Which views of a part a sheet shows, how they are turned, and where they stand."""

import random
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum, auto

import numpy as np

from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.section_planes import SectionKind
from learning.sheets.view_variants import SheetView, shortened
from learning.training_parts import DrawnPart

Place = tuple[int, int]
"""Column and row, which count to the right and down."""

_TURNS = tuple(
    np.array(items, np.float32)
    for items in ([[1, 0], [0, 1]], [[0, -1], [1, 0]], [[-1, 0], [0, -1]], [[0, 1], [-1, 0]])
)
"""By right angles."""

_DOWN = np.diag([1.0, -1.0]).astype(np.float32)
"""From a view's plane, whose second axis runs up, to the sheet, where it runs down."""

_LOOSE_PLACES: tuple[Place, ...] = ((0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (2, 1))
"""Where views stand that do not stand in projection."""

_ASPECTS, _WIDEST_UPRIGHT_PX = (0.6, 0.68, 0.707, 0.75, 1.0, 1.414), 1700
"""Heights of sheets in their widths, and the widest sheet that is higher than wide."""


class Arrangement(Enum):
    """How views stand to each other."""

    THIRD = auto()
    FIRST = auto()
    LOOSE = auto()


@dataclass(frozen=True)
class Paper:
    """A sheet.

    Attributes:
        width, height: px.
        foot: px at its lower border that views leave free.
    """

    width: int
    height: int
    foot: float


def random_paper(chance: random.Random) -> Paper:
    """Of some size."""
    spans = (900, 1500), (1300, 2200), (1800, 2800)
    width = chance.randint(*chance.choice(spans))
    aspect = chance.choice(_ASPECTS)
    if aspect > 1.0 and width > _WIDEST_UPRIGHT_PX:
        aspect = 0.7
    height = int(width * aspect)
    return Paper(width, height, chance.choice([0.0, 0.0, height * chance.uniform(0.12, 0.25)]))


def laid_out(
    part: DrawnPart, paper: Paper, text_height: float, chance: random.Random
) -> list[SheetView]:
    """The views of a part on a sheet; none where they have no room.

    Args:
        part: to show.
        paper: to stand on.
        text_height: px, by which the gaps between views go.
        chance: decides.
    """
    arrangement = chance.choice(tuple(Arrangement))
    places = _chosen(part, arrangement, chance)
    if chance.random() < 0.75:
        places = _with_sections(places, part, chance)
    each_turned = arrangement is Arrangement.LOOSE and chance.random() < 0.4
    turn = chance.choice(_TURNS) if chance.random() < 0.3 else _TURNS[0]
    turned = {}
    for place, view in places.items():
        matrix = _DOWN @ (chance.choice(_TURNS) if each_turned else turn)
        moved = view.moved(matrix, (0.0, 0.0))
        turned[place] = moved if moved.section else shortened(moved, chance)
    aligned = arrangement is not Arrangement.LOOSE or chance.random() < 0.3
    return _placed(turned, paper, text_height * chance.uniform(3.0, 9.0), aligned, chance)


def _chosen(
    part: DrawnPart, arrangement: Arrangement, chance: random.Random
) -> dict[Place, SheetView]:
    """One to four of the part's views."""
    roles = sorted(part.views, key=lambda role: role.value)
    count = min(len(roles), chance.choices([1, 2, 3, 4], [0.08, 0.35, 0.42, 0.15])[0])
    if arrangement is Arrangement.LOOSE:
        chosen = chance.sample(roles, count)
    else:
        others = [role for role in roles if role is not Role.FRONT]
        chosen = [Role.FRONT, *chance.sample(others, count - 1)]
    places: dict[Place, SheetView] = {}
    for role in chosen:
        if arrangement is Arrangement.LOOSE:
            place = chance.choice(_LOOSE_PLACES)
        else:
            third = arrangement is Arrangement.THIRD
            column, up = role.slot(Projection.THIRD if third else Projection.FIRST)
            place = (column, -up)
        places[_free(place, places)] = SheetView(role, part.views[role])
    return places


def _with_sections(
    places: Mapping[Place, SheetView], part: DrawnPart, chance: random.Random
) -> dict[Place, SheetView]:
    """With one or two sections, in the place of the view that they cut or beside some view."""
    places = dict(places)
    for section in part.sections[: chance.choice([1, 1, 2])]:
        view = SheetView(section.role, section.view, section.kind)
        this_places = [
            place
            for place, other in places.items()
            if other.role is section.role and other.section is None
        ]
        if this_places and (section.kind is not SectionKind.FULL or chance.random() < 0.5):
            places[this_places[0]] = view
        else:
            column, row = chance.choice(list(places))
            places[_free((column + 1, row), places)] = view
    return places


def _free(place: Place, places: Mapping[Place, SheetView]) -> Place:
    """The place, or the next one to the right that is free."""
    while place in places:
        place = (place[0] + 1, place[1])
    return place


def _placed(
    places: Mapping[Place, SheetView],
    paper: Paper,
    gap: float,
    aligned: bool,
    chance: random.Random,
) -> list[SheetView]:
    """Views in columns and rows, as large as fits or smaller."""
    extents = [_extents(places, axis) for axis in (0, 1)]
    room = np.array([paper.width, paper.height - paper.foot], dtype=np.float64)
    border = room * [chance.uniform(0.05, 0.14), chance.uniform(0.06, 0.14)]
    totals = np.array([sum(extent.values()) for extent in extents])
    gaps = gap * np.array([len(extent) - 1 for extent in extents])
    most = float(((room - 2.0 * border - gaps) / np.maximum(totals, 1e-3)).min())
    spans = (1.0, 1.0), (0.45, 0.95), (0.7, 1.0), (0.25, 0.7)
    scale = most * chance.uniform(*chance.choice(spans))
    if not scale > 0.0:
        return []
    spare = np.maximum(0.0, room - 2.0 * border - scale * totals - gaps)
    first = border + spare * [chance.random(), chance.random()]
    starts = [
        _starts(extent, float(first[axis]), scale, gap) for axis, extent in enumerate(extents)
    ]
    views = []
    for (column, row), view in places.items():
        corner = np.array([starts[0][column], starts[1][row]])
        if not aligned:
            cell = np.array([extents[0][column], extents[1][row]])
            corner += scale * (cell - view.size) * [chance.random(), chance.random()]
        matrix = scale * np.eye(2, dtype=np.float32)
        views.append(view.moved(matrix, corner - scale * view.lines.box()[0]))
    return views


def _extents(places: Mapping[Place, SheetView], axis: int) -> dict[int, float]:
    """Width of each column, or height of each row, in order."""
    found: dict[int, float] = {}
    for place, view in places.items():
        found[place[axis]] = max(found.get(place[axis], 0.0), float(view.size[axis]))
    return dict(sorted(found.items()))


def _starts(
    extents: Mapping[int, float], first: float, scale: float, gap: float
) -> dict[int, float]:
    """px at which each column, or row, begins."""
    starts = {}
    for key, extent in extents.items():
        starts[key] = first
        first += scale * extent + gap
    return starts
