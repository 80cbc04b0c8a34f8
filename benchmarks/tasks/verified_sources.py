"""Parts of ``verified`` as exact lines under some policy, solved and judged.

Of the parts of a family it is known which have one drawing: where another one has, none may be
called verified.
"""

import time
from collections.abc import Iterator
from dataclasses import asdict
from random import Random

from OCP.TopoDS import TopoDS_Shape

from benchmarks.judge.verified_judging import verdict
from benchmarks.parts.twin_parts import twins
from benchmarks.run.workers import Row
from benchmarks.sheets.sheet_policies import (
    IN_FIRST,
    POLICIES,
    Drawing,
    Policy,
    Size,
    as_drawn,
    in_first,
    readings,
    same_drawing,
)
from gaussiancad_core.evidence.projected_reading import drawn_views
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.lines.hlr import LineDrawing, LineOptions
from gaussiancad_core.model.axes import Role
from gaussiancad_core.run.exact_stage import ExactModel, find_exact
from sample_parts.classed import PartClass, classed_part
from sample_parts.random_parts import random_part

_ASKED = 2
"""Policies beside the first one under which one of a family's parts is drawn."""

_OTHERS = 0.4
"""Share of the classes' parts that are drawn under another policy as well."""

_SMALL = 2
"""Levels of the classes of parts that are small."""

RANDOM = "random"
"""What is asked for instead of a class."""

_STEPS = 3
"""Features of the smallest parts by chance."""


def solved(drawn: Drawing, size: Size, policy: Policy) -> tuple[ExactModel, Row]:
    """The solid of exact lines, and what is said of it."""
    item, other = readings(drawn, size, policy)
    started = time.perf_counter()
    model = find_exact(item, other)
    return model, {
        "policy": policy.name,
        "status": model.result.status.value,
        "reasons": [code for code, _ in model.result.reasons],
        "seconds": time.perf_counter() - started,
    }


def judged(drawn: Drawing, size: Size, policy: Policy, truth: TopoDS_Shape, *, unique: bool) -> Row:
    """One drawing: solved, and judged where it is called verified."""
    model, row = solved(drawn, size, policy)
    row["unique"] = unique
    found = verdict(model.result, truth, drawn_views(model.reading.registered, ()), unique=unique)
    return row | (asdict(found) if found is not None else {})


def twin_cases(family: str, seed: int) -> Iterator[Row]:
    """The variants of a family under the plain policy, and some under others."""
    variants = twins(family, seed)
    pages = [Page(shape) for shape in variants]
    lot = Random(f"{family} {seed}")
    plain, *others = POLICIES
    asked = [(plain, number) for number in range(len(pages))]
    asked += [(item, lot.randrange(len(pages))) for item in lot.sample(others, _ASKED)]
    for policy, number in asked:
        page = pages[number]
        alike = [
            index
            for index, other in enumerate(pages)
            if index != number and page.looks_like(other, policy)
        ]
        row = judged(page.drawn(policy), page.size, policy, page.shape, unique=not alike)
        yield {"member": number, "alike": alike, **row}


class Page:
    """A part and its lines, drawn as they are asked for."""

    def __init__(self, shape: TopoDS_Shape) -> None:
        self.shape = shape
        x, y, z = bounding_box(shape)[1].tolist()
        self.size: Size = (x, y, z)
        self._drawings = {
            tangent: LineDrawing(shape, LineOptions(tangent_edges=tangent))
            for tangent in (False, True)
        }
        self._views: dict[tuple[Role, bool], tuple] = {}

    def drawn(self, policy: Policy) -> Drawing:
        """Its views under a policy."""
        return as_drawn({role: self._view(role, policy.tangent) for role in policy.roles}, policy)

    def looks_like(self, other: "Page", policy: Policy) -> bool:
        """Whether another part has the same drawing, in first angle where that is not told."""
        item, extent = self.drawn(policy), max(self.size)
        if same_drawing(item, other.drawn(policy), extent):
            return True
        if policy.stated:
            return False
        swapped = {IN_FIRST[role]: self._moved(other, IN_FIRST[role], policy) for role in item}
        return same_drawing(in_first(item, self.size), swapped, extent)

    def _moved(self, other: "Page", role: Role, policy: Policy) -> tuple:
        return as_drawn({role: other._view(role, policy.tangent)}, _only(role, policy))[role]

    def _view(self, role: Role, tangent: bool) -> tuple:
        if (role, tangent) not in self._views:
            self._views[role, tangent] = self._drawings[tangent].view(role)
        return self._views[role, tangent]


def _only(role: Role, policy: Policy) -> Policy:
    """The policy for a view that is read as another one."""
    shown = IN_FIRST[role] in policy.hidden
    return Policy(policy.name, (role,), frozenset({role} if shown else ()), policy.tangent)


def part_shape(kind: str, seed: int) -> TopoDS_Shape:
    """A small part of a class, or by chance if ``kind`` is :data:`RANDOM`."""
    if kind == RANDOM:
        return random_part(seed, 1 + seed % _STEPS)
    return classed_part(PartClass(kind), seed, seed % _SMALL)


def part_cases(kind: str, seed: int) -> Iterator[Row]:
    """A part of a class, or by chance, under the plain policy and perhaps another one.

    No other part with its drawing is known.
    """
    shape = part_shape(kind, seed)
    page = Page(shape)
    lot = Random(f"{kind} {seed}")
    others = [lot.choice(POLICIES[1:])] if lot.random() < _OTHERS else []
    for policy in (POLICIES[0], *others):
        yield judged(page.drawn(policy), page.size, policy, shape, unique=True)
