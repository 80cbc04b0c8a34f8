"""The classes of parts, and how a part of a class and a size grows from its seed."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum
from itertools import count

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.brep import faces_of, moved_to_origin, soundness
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from sample_parts.classed.drilled import DRILLED, drilled_body
from sample_parts.classed.filleted import FILLETED, filleted_body
from sample_parts.classed.flat import FLAT, flat_body
from sample_parts.classed.oblique import OBLIQUE, oblique_body
from sample_parts.classed.placing import Feature, Work
from sample_parts.classed.slanted import SLANTED, slanted_body
from sample_parts.classed.stock import CELL, Stock
from sample_parts.classed.surfaces import SurfaceKind, surface_kinds
from sample_parts.classed.turning import TURNED, turned_body

LEVEL_FACES = (
    (8, 12), (13, 20), (21, 32), (33, 48), (49, 70), (71, 95), (96, 120), (121, 150), (151, 220),
    (221, 320),
)  # fmt: skip
"""Fewest and most faces of a part of each level."""

_FAILURES: tuple[type[Exception], ...] = (*KERNEL_FAILURES, RuntimeError)

_EXTENTS = (60.0, 70.0, 80.0, 100.0, 120.0, 150.0, 180.0, 200.0, 240.0, 280.0)
"""mm of the longest edge of a body of each level, about."""

_FEATURE = (20.0, 20.0, 20.0, 20.0, 20.0, 18.0, 18.0, 16.0, 14.0, 14.0)
"""mm of a usual feature of each level."""

_TRIES = 60
"""Features that are tried before a body counts as full."""


class PartClass(Enum):
    """What surfaces a part has."""

    PLANES = "planes"
    HOLES = "holes"
    SLANTS = "slants"
    FILLETS = "fillets"
    REVOLVED = "revolved"
    OBLIQUE = "oblique"

    @property
    def allowed(self) -> frozenset[SurfaceKind]:
        """The kinds of surfaces that parts of the class may have."""
        return _RECIPES[self].allowed

    @property
    def asked(self) -> frozenset[SurfaceKind]:
        """The kinds of surfaces of which parts of the class have one at least."""
        return _RECIPES[self].asked


@dataclass(frozen=True)
class _Recipe:
    """How parts of a class are made."""

    body: Callable[[Work], int]
    features: tuple[Feature, ...]
    asked: frozenset[SurfaceKind]
    allowed: frozenset[SurfaceKind]


def _recipe(
    body: Callable[[Work], int], features: tuple[Feature, ...], *kinds: SurfaceKind, drilled: bool
) -> _Recipe:
    others = (SurfaceKind.PLANE, SurfaceKind.CYLINDER) if drilled else (SurfaceKind.PLANE,)
    if kinds == (SurfaceKind.OBLIQUE,):
        others = (*others, SurfaceKind.SLANT)
    return _Recipe(body, features, frozenset(kinds), frozenset((*kinds, *others)))


_RECIPES = {
    PartClass.PLANES: _recipe(flat_body, FLAT, SurfaceKind.PLANE, drilled=False),
    PartClass.HOLES: _recipe(drilled_body, DRILLED, SurfaceKind.CYLINDER, drilled=True),
    PartClass.SLANTS: _recipe(slanted_body, SLANTED, SurfaceKind.SLANT, drilled=True),
    PartClass.FILLETS: _recipe(filleted_body, FILLETED, SurfaceKind.CYLINDER, drilled=True),
    PartClass.REVOLVED: _recipe(
        turned_body, TURNED, SurfaceKind.CONE, SurfaceKind.SPHERE, SurfaceKind.TORUS, drilled=True
    ),
    PartClass.OBLIQUE: _recipe(oblique_body, OBLIQUE, SurfaceKind.OBLIQUE, drilled=True),
}


def classed_part(kind: PartClass, seed: int, level: int) -> TopoDS_Shape:
    """One valid closed solid of a class, its bounding box starting at the origin.

    Args:
        kind: which surfaces it may have.
        seed: the same seed gives the same part.
        level: index of :data:`LEVEL_FACES`, which says how many faces the part has.

    Raises:
        IndexError: there is no such level.
    """
    fewest, most = LEVEL_FACES[level]
    number = list(PartClass).index(kind)
    # Some attempts come out too small, or in two pieces; the next one is as random as the first.
    attempts = (
        _grown(_RECIPES[kind], np.random.default_rng([seed, level, number, attempt]), level)
        for attempt in count()
    )
    return next(
        part for part in attempts if part is not None and fewest <= len(faces_of(part)) <= most
    )


def _grown(recipe: _Recipe, random: np.random.Generator, level: int) -> TopoDS_Shape | None:
    """A part of about the right number of faces, if it came out as one sound solid."""
    fewest, most = LEVEL_FACES[level]
    wanted = int(random.integers(fewest, most + 1))
    sides = random.dirichlet(np.array([0.5, 0.5, 0.5, 0.5, 0.5, 2.0]))
    work = Work(
        Stock(_body_size(random, level)), random, tuple(sides.tolist()), _FEATURE[level], wanted
    )
    try:
        _grow(recipe, work)
        part = work.stock.solid()
        sound = soundness(part)
    except _FAILURES:
        return None
    kinds = surface_kinds(part)
    whole = sound.valid and sound.closed and sound.solids == 1
    return moved_to_origin(part) if whole and _fits(recipe, kinds) else None


def _fits(recipe: _Recipe, kinds: frozenset[SurfaceKind]) -> bool:
    return kinds <= recipe.allowed and bool(kinds & recipe.asked)


def _body_size(random: np.random.Generator, level: int) -> tuple[float, float, float]:
    """Edges of a body's box: long, medium and mostly thin, in any order, mostly lying flat."""
    longest = _EXTENTS[level] * random.uniform(0.8, 1.2)
    shares = np.array([1.0, random.uniform(0.5, 0.95), random.uniform(0.2, 0.8)])
    if random.random() < 0.4:
        random.shuffle(shares)
    x, y, z = (np.maximum(24.0, CELL * np.rint(longest * shares / CELL))).tolist()
    return x, y, z


def _grow(recipe: _Recipe, work: Work) -> None:
    """The body, then features until the part has about as many faces as wanted."""
    left = work.wanted - recipe.body(work)
    for _ in range(_TRIES):
        if left <= 0:
            return
        feature = recipe.features[int(work.random.integers(len(recipe.features)))]
        left -= feature(replace(work, wanted=left))
