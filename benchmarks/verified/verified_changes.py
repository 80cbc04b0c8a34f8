"""Changes of a drawing that must not change what is said of it, nor the solid.

Strokes in another order, split or turned around; the part turned so that other views show the same
sides, or mirrored with its views; a machine that is busy.  Views that are added may make certain
what was not, but what was verified stays so.
"""

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from math import pi
from random import Random

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.exact_measures import Floats, placed
from benchmarks.judge.verified_judging import verdict
from benchmarks.run.workers import Row
from benchmarks.sheets.sheet_policies import POLICIES, Drawing, Policy
from benchmarks.verified.verified_sources import Page, part_shape, solved
from gaussiancad_core.evidence.projected_reading import drawn_views
from gaussiancad_core.kernel.brep import area, volume
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Segment
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_protocol.modes import Status

_ELSEWHERE = 1e-5
"""Share by which volume and area of a solid may differ where it was computed elsewhere in space:
lines are exact to 2e-6 of the longest extent."""

_CORNER = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
"""Turns the part around the diagonal through the corner that the front, top and right view see:
each view shows what another one showed before."""

_MIRROR = np.diag([-1.0, 1.0, 1.0])

_LEFT = Policy("mirrored", (Role.FRONT, Role.TOP, Role.LEFT))
_MORE = (Role.LEFT, Role.BOTTOM, Role.REAR)

_CHANGES = 3
"""Changes of a part for one seed."""


@dataclass(frozen=True)
class _Told:
    """What must stay the same."""

    status: str
    reasons: tuple[str, ...]
    volume: float
    area: float

    @classmethod
    def of(cls, model: ExactModel) -> "_Told":
        result = model.result
        shape = result.shape
        return cls(
            result.status.value,
            tuple(sorted(code for code, _ in result.reasons)),
            volume(shape) if shape is not None else 0.0,
            area(shape) if shape is not None else 0.0,
        )

    def differs(self, other: "_Told", share: float) -> str:
        """In what another one differs; empty if in nothing."""
        if (self.status, self.reasons) != (other.status, other.reasons):
            return f"{self.status} {self.reasons} became {other.status} {other.reasons}"
        for name in ("volume", "area"):
            # Faces are not counted: a bore that another one crosses may be one, or two halves.
            item, changed = getattr(self, name), getattr(other, name)
            if abs(item - changed) > share * abs(item):
                return f"{name} {item!r} became {changed!r}"
        return ""


def change_cases(kind: str, seed: int) -> Iterator[Row]:
    """A part, and some changes of its drawing by lot."""
    lot = Random(f"{kind} {seed} changes")
    page = Page(part_shape(kind, seed))
    plain = POLICIES[0]
    drawn = page.drawn(plain)
    model, row = solved(drawn, page.size, plain)
    yield _judged(model, page.shape, row)
    stated = _Told.of(model)
    changes = ["permuted", "split", "turned", "turned back", "mirrored", "view added", "busy"]
    for name in lot.sample(changes, _CHANGES):
        if name == "view added" and model.result.status is not Status.VERIFIED:
            continue
        shape, share = page.shape, _ELSEWHERE
        if name in ("permuted", "split"):
            other, row = solved(_CHANGED[name](drawn, lot), page.size, plain)
        elif name == "busy":
            share = 0.0
            with _busy():
                other, row = solved(drawn, page.size, plain)
        else:
            policy, turned = _placing(name, lot)
            changed = page if turned is None else Page(placed(page.shape, turned))
            shape = changed.shape
            other, row = solved(changed.drawn(policy), changed.size, policy)
        row = _judged(other, shape, {**row, "policy": name})
        yield {**row, "changed": stated.differs(_Told.of(other), share)}


def _judged(model: ExactModel, truth: TopoDS_Shape, row: Row) -> Row:
    found = verdict(model.result, truth, drawn_views(model.reading.registered, ()))
    return row | {"unique": True} | (asdict(found) if found is not None else {})


def _placing(name: str, lot: Random) -> tuple[Policy, Floats | None]:
    """The views, and how the part is turned."""
    plain = POLICIES[0]
    if name == "mirrored":
        return _LEFT, _MIRROR
    if name == "view added":
        return replace(plain, roles=(*plain.roles, lot.choice(_MORE))), None
    return plain, _CORNER if name == "turned" else _CORNER.T


def permuted(drawn: Drawing, lot: Random) -> Drawing:
    """Strokes in another order, some drawn from their other end."""
    return {
        role: tuple(_turned_around(item, lot) for item in lot.sample(strokes, len(strokes)))
        for role, strokes in drawn.items()
    }


def _turned_around(stroke: DrawnStroke, lot: Random) -> DrawnStroke:
    if isinstance(stroke, Segment) and lot.random() < 0.5:
        return replace(stroke, start=stroke.end, end=stroke.start)
    return stroke


def split(drawn: Drawing, lot: Random) -> Drawing:
    """Segments and arcs in two pieces each."""
    return {
        role: tuple(piece for stroke in strokes for piece in _pieces(stroke, lot.uniform(0.3, 0.7)))
        for role, strokes in drawn.items()
    }


def _pieces(stroke: DrawnStroke, share: float) -> tuple[DrawnStroke, ...]:
    if isinstance(stroke, Segment):
        (x0, y0), (x1, y1) = stroke.start, stroke.end
        middle = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
        return replace(stroke, end=middle), replace(stroke, start=middle)
    if isinstance(stroke, Arc):
        first = share * stroke.sweep
        rest = (stroke.start_angle + first) % (2.0 * pi)
        return (
            replace(stroke, sweep=first),
            replace(stroke, start_angle=rest, sweep=stroke.sweep - first),
        )
    return (stroke,)


_CHANGED = {"permuted": permuted, "split": split}


@contextmanager
def _busy() -> Iterator[None]:
    """Another process keeps a core busy meanwhile."""
    process = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        yield
    finally:
        process.kill()
        process.wait()
