"""Parts as lines: solids by chance, each drawn once, of which many sheets are composed."""

from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from functools import partial
from multiprocessing import get_context
from typing import TYPE_CHECKING

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.section_planes import SectionKind
from gaussiancad_core.model.views import Arc, Linetype, Segment

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Shape

    from gaussiancad_core.lines.cut_solids import SectionView

Chain = npt.NDArray[np.float32]
"""(n, 2) points of a line, two or more; a closed one ends where it begins."""


_CLASSED = 0.45
"""Share of the solids that keep to a class of surfaces; the others have all kinds."""

_LEVELS = 3
"""Levels of those, the simplest ones: sheets show few parts of a hundred faces."""

_MORE_VIEWS = (Role.RIGHT, Role.LEFT, Role.BOTTOM, Role.REAR)
"""Views beside front and top."""

_MORE_VIEWS_ODDS = (0.6, 0.2, 0.12, 0.08)
"""How often each of them is."""

_SECTIONED, _PICTURED = 0.6, 0.5
"""Shares of the solids of which sections, and the isometric picture, are drawn, too."""

_ANGLE_STEP = np.radians(5.0)
"""Of the chain along a circle."""

_FINE = 2e-4
"""Largest distance between a curve and its chain, as a share of the part's longest extent."""

_CHORD = 5e-5
"""The same of what is drawn, before points are left out."""

_MOST_TRIES = 50
"""Solids, one after the other, that cannot be drawn, from which something is wrong."""


@dataclass(frozen=True)
class Circle:
    """A circle of a view, or a piece of one.

    Attributes:
        centre: (2,) in the unit of the view.
        radius: the same.
        start, sweep: radians, from the first axis towards the second.
        hidden: whether it is.
    """

    centre: tuple[float, float]
    radius: float
    start: float
    sweep: float
    hidden: bool

    def moved(self, matrix: npt.NDArray[np.floating], offset: npt.ArrayLike) -> "Circle":
        """After a turn, a mirroring and a change of size: (2, 2), and then a way (2,)."""
        x, y = np.asarray(matrix) @ self.centre + np.asarray(offset)
        size = float(np.sqrt(abs(np.linalg.det(matrix))))
        first = self.start if np.linalg.det(matrix) > 0.0 else self.start + self.sweep
        way = np.asarray(matrix) @ (np.cos(first), np.sin(first))
        start = float(np.arctan2(way[1], way[0]))
        return Circle((float(x), float(y)), size * self.radius, start, self.sweep, self.hidden)


@dataclass(frozen=True, eq=False)
class PartView:
    """The lines of a view.

    Attributes:
        visible: edges in mm of the view's plane (right, up).
        hidden: edges behind others.
        tangent: smooth edges, which are drawn thin or not at all.
        circles: which of the edges are round.
        areas: pieces of cut material, each as rings, the outer one first.
    """

    visible: tuple[Chain, ...]
    hidden: tuple[Chain, ...] = ()
    tangent: tuple[Chain, ...] = ()
    circles: tuple[Circle, ...] = ()
    areas: tuple[tuple[Chain, ...], ...] = ()

    def box(self) -> npt.NDArray[np.float32]:
        """(2, 2) least and largest coordinates."""
        points = np.concatenate([*self.visible, *self.hidden])
        return np.stack([points.min(axis=0), points.max(axis=0)])

    def moved(self, matrix: npt.NDArray[np.floating], offset: npt.ArrayLike) -> "PartView":
        """After a turn, a mirroring and a change of size: (2, 2), and then a way (2,)."""
        moved = self.each(lambda chain: [(chain @ matrix.T + offset).astype(np.float32)])
        areas = tuple(
            tuple((ring @ matrix.T + offset).astype(np.float32) for ring in area)
            for area in self.areas
        )
        circles = tuple(circle.moved(matrix, offset) for circle in self.circles)
        return replace(moved, circles=circles, areas=areas)

    def each(self, change: Callable[[Chain], Iterable[Chain]]) -> "PartView":
        """With the pieces that a change makes of each line; circles and areas stay."""

        def changed(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
            return tuple(piece for chain in chains for piece in change(chain))

        return replace(
            self,
            visible=changed(self.visible),
            hidden=changed(self.hidden),
            tangent=changed(self.tangent),
        )


@dataclass(frozen=True, eq=False)
class PartSection:
    """A view of the part, cut open.

    Attributes:
        role: the view.
        kind: how much of it is cut.
        view: its lines.
    """

    role: Role
    kind: SectionKind
    view: PartView


@dataclass(frozen=True, eq=False)
class DrawnPart:
    """The lines of a part.

    Attributes:
        views: by their roles; each has visible lines.
        sections: views cut open.
        picture: visible lines of the isometric picture, (right, up).
    """

    views: Mapping[Role, PartView]
    sections: tuple[PartSection, ...] = ()
    picture: tuple[Chain, ...] = field(default=())


def drawn_parts(seed: int, count: int, workers: int = 1) -> list[DrawnPart]:
    """Solids by chance, drawn; the same seed gives the same ones.

    Args:
        seed: of all.
        count: how many; each takes some seconds.
        workers: processes that draw; with 1 it is this one.
    """
    draw = partial(_drawn_part, seed)
    if workers == 1:
        return [draw(number) for number in range(count)]
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
        return list(pool.map(draw, range(count)))


def _drawn_part(seed: int, number: int) -> DrawnPart:
    # Machines that only train have no need of the kernel.
    from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

    failures: tuple[type[Exception], ...] = (*KERNEL_FAILURES, ValueError)
    for attempt in range(_MOST_TRIES):
        rng = np.random.default_rng([seed, number, attempt])
        try:
            part = _drawn(_solid(rng), rng)
        except failures:
            continue
        if all(view.visible for view in part.views.values()):
            return part
    raise RuntimeError(f"{_MOST_TRIES} solids one after the other could not be drawn")


def _solid(rng: np.random.Generator) -> "TopoDS_Shape":
    from sample_parts.classed import PartClass, classed_part
    from sample_parts.random_parts import random_part

    seed = int(rng.integers(2**31))
    if rng.random() >= _CLASSED:
        return random_part(seed)
    kind = tuple(PartClass)[rng.integers(len(PartClass))]
    return classed_part(kind, seed, int(rng.integers(_LEVELS)))


def _drawn(shape: "TopoDS_Shape", rng: np.random.Generator) -> DrawnPart:
    from gaussiancad_core.drawing.isometric_picture import ISOMETRIC
    from gaussiancad_core.kernel.brep import bounding_box, moved_to_origin
    from gaussiancad_core.lines.cut_solids import openings_of, section_view
    from gaussiancad_core.lines.hlr import LineDrawing, LineOptions

    shape = moved_to_origin(shape)
    low, high = bounding_box(shape)
    fine = _FINE * float((high - low).max())
    roles = [Role.FRONT, Role.TOP, _MORE_VIEWS[rng.choice(len(_MORE_VIEWS), p=_MORE_VIEWS_ODDS)]]
    options = LineOptions(chord=_CHORD)
    drawing = LineDrawing(shape, options)
    views = {role: _view(drawing.view(role), fine) for role in roles}
    views = _with_tangents(shape, views, fine)
    sections = []
    if rng.random() < _SECTIONED:
        for role in roles[: rng.integers(1, 3)]:
            kind = tuple(SectionKind)[rng.integers(len(SectionKind))]
            cut = section_view(shape, role, openings_of(shape, role, kind), options)
            cut_view = _cut_view(cut, fine)
            if cut_view.visible and cut_view.areas:
                sections.append(PartSection(role, kind, cut_view))
    strokes = drawing.seen(ISOMETRIC) if rng.random() < _PICTURED else ()
    return DrawnPart(views, tuple(sections), _view(strokes, fine).visible)


def _with_tangents(
    shape: "TopoDS_Shape", views: Mapping[Role, PartView], fine: float
) -> dict[Role, PartView]:
    """Views with the smooth edges that are seen in them."""
    from gaussiancad_core.kernel.solid_edges import edge_facts
    from gaussiancad_core.lines.hlr import LineDrawing, LineOptions

    if not any(edge_fact.smooth and not edge_fact.seam for edge_fact in edge_facts(shape)):
        return dict(views)
    drawing = LineDrawing(shape, LineOptions(tangent_edges=True, chord=_CHORD))
    found = {}
    for role, view in views.items():
        sharp = [*view.visible, *view.hidden]
        smooth = [
            values
            for values in _view(drawing.view(role), fine).visible
            if _away(values, sharp) > 4.0 * fine
        ]
        found[role] = replace(view, tangent=tuple(smooth))
    return found


def _away(chain: Chain, others: Iterable[Chain]) -> float:
    """Distance of a line's middle from other lines."""
    place = len(chain) // 2
    middle = 0.55 * chain[place - 1] + 0.45 * chain[place]
    nearest = np.inf
    for other in others:
        starts, steps = other[:-1], np.diff(other, axis=0)
        lengths = np.maximum((steps**2).sum(axis=1), 1e-12)
        along = np.clip(((middle - starts) * steps).sum(axis=1) / lengths, 0.0, 1.0)
        feet = starts + along[:, None] * steps
        nearest = min(nearest, float(np.hypot(*(middle - feet).T).min()))
    return nearest


def _cut_view(cut: "SectionView", fine: float) -> PartView:
    import shapely

    areas = []
    for polygon in shapely.get_parts(shapely.simplify(cut.areas, fine)):
        if polygon.geom_type == "Polygon" and polygon.area > fine * fine:
            rings = [polygon.exterior, *polygon.interiors]
            areas.append(tuple(np.array(ring.coords, np.float32) for ring in rings))
    return replace(_view(cut.strokes, fine), areas=tuple(areas))


def _view(strokes: Iterable[DrawnStroke], fine: float) -> PartView:
    """Strokes as chains, and what is round of them."""
    visible: list[Chain] = []
    hidden: list[Chain] = []
    circles: list[Circle] = []
    for stroke in strokes:
        behind = stroke.linetype is Linetype.HIDDEN
        (hidden if behind else visible).append(_chain(stroke, fine))
        if isinstance(stroke, Arc):
            pair = stroke.centre, stroke.radius, stroke.start_angle, stroke.sweep
            circles.append(Circle(*pair, hidden=behind))
    return PartView(tuple(visible), tuple(hidden), (), tuple(circles))


def _chain(stroke: DrawnStroke, fine: float) -> Chain:
    if isinstance(stroke, Segment):
        return np.array([stroke.start, stroke.end], np.float32)
    if isinstance(stroke, Arc):
        return stroke.sample(_ANGLE_STEP * stroke.radius).astype(np.float32)
    points = stroke.sample(2.0 * fine).astype(np.float32)
    fewer = cv2.approxPolyDP(points[:, None], fine, closed=False)[:, 0]
    return np.asarray(fewer, dtype=np.float32)
