"""Is the wrong line of a drawing among those that are said to contradict each other?

Parts by chance are drawn exactly in three views; then a stroke is left out, a line is drawn through
a whole view, a stroke has the wrong linetype, a view is mirrored or two views change places.  Parts
whose right drawing is contradictory already, since they have surfaces that cells do not express,
are left out and counted.
"""

import argparse
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from benchmarks.run.outcome import Outcome, share
from benchmarks.sheets.clean_sheets import ROLES
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.labelling.conflict_lines import Conflict, ConflictLine
from gaussiancad_core.labelling.minimal_conflicts import find_conflict
from gaussiancad_core.labelling.part_model import model_part
from gaussiancad_core.lines.hlr import LineDrawing
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.samples.random_parts import random_part

MINUTES = 10


EFFORT = 4.0

NEAR = 0.004
"""Share of the longest extent within which a marked line is the wrong one."""


@dataclass(frozen=True)
class Spoilt:
    """A drawing with something wrong in it.

    Attributes:
        views: the drawing.
        role, stroke: where the wrong or missing line is; None where a whole view is wrong.
    """

    views: DrawnViews
    role: Role | None = None
    stroke: DrawnStroke | None = None


Spoil = Callable[[DrawnViews, np.random.Generator], Spoilt]


def drawn(seed: int) -> DrawnViews:
    """A part by chance in three exact views."""
    solid = random_part(seed)
    low, high = bounding_box(solid)
    drawing = LineDrawing(solid)
    return exact_views({role: drawing.view(role) for role in ROLES}, tuple((high - low).tolist()))


def missing(views: DrawnViews, random: np.random.Generator) -> Spoilt:
    """Without one stroke of any view."""
    role, index = _place(views, random)
    strokes = list(views.strokes[role])
    lost = strokes.pop(index)
    return Spoilt(_with(views, role, strokes), role, lost)


def spurious(views: DrawnViews, random: np.random.Generator) -> Spoilt:
    """With a visible line from one side of a view to the other."""
    role = ROLES[int(random.integers(len(ROLES)))]
    frame = role.frame
    sides = []
    for axis, sign in (frame.right_axis, frame.up_axis):
        extent = views.size[axis.value]
        sides.append((0.0, extent) if sign > 0 else (-extent, 0.0))
    (left, right), (bottom, top) = sides
    one, other = random.uniform(bottom, top, 2)
    across = random.uniform(left, right)
    start, end = (
        ((left, one), (right, one)),
        ((across, bottom), (across, top)),
        ((left, one), (right, other)),
    )[int(random.integers(3))]
    line = Segment(_pair(start), _pair(end), Linetype.VISIBLE)
    return Spoilt(_with(views, role, [*views.strokes[role], line]), role, line)


def wrong_linetype(views: DrawnViews, random: np.random.Generator) -> Spoilt:
    """With a stroke visible that is hidden, or the other way round."""
    role, index = _place(views, random)
    strokes = list(views.strokes[role])
    visible = strokes[index].linetype is Linetype.VISIBLE
    strokes[index] = replace(
        strokes[index], linetype=Linetype.HIDDEN if visible else Linetype.VISIBLE
    )
    return Spoilt(_with(views, role, strokes), role, strokes[index])


def mirrored(views: DrawnViews, random: np.random.Generator) -> Spoilt:
    """With a view upside down in its own box."""
    role = ROLES[int(random.integers(len(ROLES)))]
    axis, sign = role.frame.up_axis
    shift = (0.0, sign * views.size[axis.value])
    turned = [stroke.mapped(Similarity(offset=shift, flip=True)) for stroke in views.strokes[role]]
    return Spoilt(_with(views, role, turned))


def swapped(views: DrawnViews, random: np.random.Generator) -> Spoilt:
    """With two views in each other's place."""
    one, other = random.permutation(len(ROLES))[:2]
    strokes = dict(views.strokes)
    first, second = ROLES[int(one)], ROLES[int(other)]
    strokes[first], strokes[second] = strokes[second], strokes[first]
    return Spoilt(replace(views, strokes=strokes))


def _place(views: DrawnViews, random: np.random.Generator) -> tuple[Role, int]:
    places = [(role, index) for role in ROLES for index in range(len(views.strokes[role]))]
    return places[int(random.integers(len(places)))]


def _with(views: DrawnViews, role: Role, strokes: list[DrawnStroke]) -> DrawnViews:
    return replace(views, strokes={**views.strokes, role: tuple(strokes)})


def _pair(point: tuple[float, float]) -> tuple[float, float]:
    return float(point[0]), float(point[1])


def marks(line: ConflictLine, spoilt: Spoilt) -> bool:
    """Whether a line lies on the wrong stroke, or covers half of it."""
    if line.role is not spoilt.role:
        return False
    near = NEAR * max(spoilt.views.size)
    shares = np.linspace(0.0, len(line.points) - 1.0, 400)
    marked = np.stack(
        [np.interp(shares, np.arange(len(line.points)), column) for column in line.points.T], 1
    )
    wrong = spoilt.stroke.sample(spoilt.stroke.length / 400.0)
    on_wrong = cKDTree(wrong).query(marked)[0] < near
    covered = cKDTree(marked).query(wrong)[0] < near
    return bool(on_wrong.mean() > 0.9 or (covered.mean() > 0.5 and on_wrong.mean() > 0.3))


def consistent(count: int, seed: int) -> Iterator[tuple[int, DrawnViews]]:
    """Parts whose right drawings have no contradiction, with their seeds."""
    found = 0
    while found < count:
        views = drawn(seed)
        if find_conflict(model_part(views), views, EFFORT) is None:
            found += 1
            yield seed, views
        seed += 1


def row(spoil: Spoil, parts: list[tuple[int, DrawnViews]]) -> tuple[str, int]:
    """One line of the table, and in how many parts the fault is noticed."""
    conflicts: list[tuple[Spoilt, Conflict | None]] = []
    seconds = []
    for seed, views in parts:
        spoilt = spoil(views, np.random.default_rng(1000 + seed))
        model = model_part(spoilt.views)
        start = time.perf_counter()
        conflicts.append((spoilt, find_conflict(model, spoilt.views, EFFORT)))
        seconds.append(time.perf_counter() - start)
    stated = [(spoilt, conflict) for spoilt, conflict in conflicts if conflict is not None]
    lines = statistics.median(len(conflict.lines) for _, conflict in stated) if stated else 0
    marked = suspected = "–"
    if conflicts[0][0].stroke is not None:
        marked = str(sum(any(marks(one, s) for one in c.lines) for s, c in stated))
        suspected = str(sum(any(marks(one, s) for one in c.suspects) for s, c in stated))
    name = spoil.__name__.replace("_", " ")
    line = f"{name:15} {len(stated):5} {marked:>7} {suspected:>10} {lines:6g} "
    line += f"{statistics.median(seconds):8.2f} {max(seconds):8.2f}"
    return line, len(stated)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("--parts", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)


def run(options: argparse.Namespace) -> Outcome:
    """Print the table."""
    parts = list(consistent(options.parts, options.seed))
    tried = parts[-1][0] - options.seed + 1
    print(f"{len(parts)} parts; {tried - len(parts)} others contradict themselves when right")
    print("wrong            told  marked  suspected  lines  s median   s most")
    figures = []
    for spoil in (missing, spurious, wrong_linetype, mirrored, swapped):
        line, noticed = row(spoil, parts)
        print(line, flush=True)
        figures.append(share(f"{spoil.__name__.replace('_', ' ')} noticed", noticed, len(parts)))
    return Outcome(tuple(figures))
