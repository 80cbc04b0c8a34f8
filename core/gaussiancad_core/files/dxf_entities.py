"""The entities of a DXF page taken apart: blocks, dimensions, polylines, hatches."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Protocol, cast

from ezdxf.document import Drawing
from ezdxf.entities import Hatch
from ezdxf.entities.dxfgfx import DXFGraphic
from ezdxf.entities.insert import Insert
from ezdxf.entities.lwpolyline import LWPolyline
from ezdxf.entities.mtext import MText
from ezdxf.entities.text import Text
from ezdxf.math import Matrix44

from gaussiancad_core.errors import LimitError
from gaussiancad_core.files.content import DEEPEST, MAX_ELEMENTS, too_many_elements
from gaussiancad_core.files.dxf_curves import (
    entity_curves,
    fill_outline,
    hatch_lines,
    hatch_outlines,
)
from gaussiancad_core.files.dxf_faults import BROKEN
from gaussiancad_core.files.dxf_look import Look, Looks, inside_block
from gaussiancad_core.files.dxf_text import PlacedText, placed_paragraph, placed_text
from gaussiancad_core.files.vectors import StrokeKind
from gaussiancad_core.geometry.curves import Curve

_UNDRAWN = frozenset(
    {
        "3DSOLID",
        "BODY",
        "DGNUNDERLAY",
        "DWFUNDERLAY",
        "EXTRUDEDSURFACE",
        "IMAGE",
        "LOFTEDSURFACE",
        "MESH",
        "OLE2FRAME",
        "OLEFRAME",
        "PDFUNDERLAY",
        "PLANESURFACE",
        "REGION",
        "REVOLVEDSURFACE",
        "SURFACE",
        "SWEPTSURFACE",
        "WIPEOUT",
    }
)
"""Pictures and bodies, which have no lines of their own."""

_BLANK = frozenset({"ATTDEF", "LIGHT", "POINT", "SEQEND", "VIEWPORT"})
"""Kinds that put no line and no text on the sheet; an ATTDEF is only the pattern of a text."""

_POLYLINES = frozenset({"POLYLINE", "LWPOLYLINE"})

_COMPOSED = frozenset({"ACAD_PROXY_ENTITY", "MLINE"})
"""Kinds that are drawn as entities of any kind, each with a look of its own."""

_ANNOTATIONS = {
    "DIMENSION": StrokeKind.DIMENSION,
    "ARC_DIMENSION": StrokeKind.DIMENSION,
    "LARGE_RADIAL_DIMENSION": StrokeKind.DIMENSION,
    "LEADER": StrokeKind.LEADER,
    "MULTILEADER": StrokeKind.LEADER,
    "MLEADER": StrokeKind.LEADER,
}


@dataclass(frozen=True)
class DrawnCurve:
    """A curve in units of the drawing, y up.

    Attributes:
        curve: a chain follows a smooth curve, except in fills.
        look: how it is drawn.
        width: units of the drawing, of polylines that have one; else None.
    """

    curve: Curve
    look: Look
    width: float | None = None


@dataclass
class Explosion:
    """What a page's entities come down to, as it grows.

    Attributes:
        curves, texts: found so far.
        complete: whether nothing was met that cannot be drawn.
        count: entities met, blocks' parts as often as they are shown.
        unread: how many of each kind were left out, as they cannot be read.
    """

    curves: list[DrawnCurve] = field(default_factory=list)
    texts: list[PlacedText] = field(default_factory=list)
    complete: bool = True
    count: int = 0
    unread: Counter[str] = field(default_factory=Counter)


class Exploder:
    """Takes the entities of one document apart."""

    def __init__(self, doc: Drawing, path: Path) -> None:
        self._looks = Looks(doc)
        self._path = path
        self._found = Explosion()

    def explode(self, entities: Iterable[DXFGraphic], matrix: Matrix44 | None = None) -> Explosion:
        """Curves and texts of entities, each mapped by ``matrix`` where there is one.

        Raises:
            LimitError: ``too-many-elements``.
        """
        self._found = Explosion()
        for entity in entities:
            shown = entity if matrix is None else _mapped(entity, matrix)
            if shown is not None:
                self._take(shown, Look(), 0)
            else:
                self._found.unread[entity.dxftype()] += 1
        return self._found

    def _take(self, entity: DXFGraphic, parent: Look, depth: int) -> None:
        """Take an entity as far as it can be read."""
        self._count()
        try:
            self._take_known(entity, parent, depth)
        except LimitError:
            raise
        except BROKEN:
            self._found.unread[entity.dxftype()] += 1

    def _take_known(self, entity: DXFGraphic, parent: Look, depth: int) -> None:
        look = self._looks.of(entity, parent)
        if isinstance(entity, Insert):
            if depth < DEEPEST and not self._looks.is_frozen(look):
                self._take_block(entity, look, depth)
        elif not self._looks.is_shown(entity, look):
            return
        elif entity.dxftype() in _ANNOTATIONS:
            if depth < DEEPEST:
                inner = replace(look, kind=_ANNOTATIONS[entity.dxftype()])
                self._take_all(_parts(entity), inner, depth)
        elif entity.dxftype() in _COMPOSED:
            self._take_composed(entity, look, depth)
        else:
            self._take_simple(entity, look)

    def _take_simple(self, entity: DXFGraphic, look: Look) -> None:
        """Take an entity that holds no others but lines and arcs."""
        kind = entity.dxftype()
        if kind in _BLANK:
            return
        if kind in _POLYLINES:
            self._take_polyline(entity, look)
        elif isinstance(entity, Hatch):
            self._take_hatch(entity, look)
        elif isinstance(entity, MText):
            self._found.texts += placed_paragraph(entity)
        elif isinstance(entity, Text):
            self._found.texts += placed_text(entity)
        elif kind in ("SOLID", "TRACE"):
            self._add(fill_outline(entity), replace(look, kind=StrokeKind.FILL, dashes=()))
        elif kind in _UNDRAWN:
            self._found.complete = False
        else:
            self._add(entity_curves(entity), look)

    def _count(self) -> None:
        self._found.count += 1
        if self._found.count > MAX_ELEMENTS:
            raise too_many_elements(self._path)

    def _take_block(self, insert: Insert, look: Look, depth: int) -> None:
        if insert.dxf.get("invisible", 0):
            return
        if insert.mcount > MAX_ELEMENTS:
            raise too_many_elements(self._path)
        inner = inside_block(look, insert.dxf.name)
        copies = insert.multi_insert() if insert.mcount > 1 else (insert,)
        for copy in copies:
            self._take_all(copy.virtual_entities(), inner, depth)
        self._take_all(insert.attribs, inner, depth)

    def _take_all(self, entities: Iterable[DXFGraphic], look: Look, depth: int) -> None:
        for entity in entities:
            self._take(entity, look, depth + 1)

    def _take_composed(self, entity: DXFGraphic, look: Look, depth: int) -> None:
        """Take an entity's parts; one that has none, as its program left no picture of it, is
        unread."""
        parts = list(_parts(entity))
        if not parts:
            self._found.unread[entity.dxftype()] += 1
        self._take_all(parts, look, depth)

    def _take_polyline(self, entity: DXFGraphic, look: Look) -> None:
        width = float(entity.dxf.get("const_width", 0.0)) if isinstance(entity, LWPolyline) else 0.0
        curves: list[Curve] = []
        for part in _parts(entity):
            self._count()
            curves += entity_curves(part)
        self._add(curves, look, width or None)

    def _take_hatch(self, hatch: Hatch, look: Look) -> None:
        if hatch.dxf.solid_fill:
            self._add(hatch_outlines(hatch), replace(look, kind=StrokeKind.FILL, dashes=()))
            return
        inner = replace(look, kind=StrokeKind.HATCH, dashes=())
        for line in hatch_lines(hatch):
            if line is None:
                self._found.complete = False
                return
            self._count()
            self._add([line], inner)

    def _add(self, curves: list[Curve], look: Look, width: float | None = None) -> None:
        self._found.curves += [DrawnCurve(curve, look, width) for curve in curves]


def _mapped(entity: DXFGraphic, matrix: Matrix44) -> DXFGraphic | None:
    """A mapped copy, or None for an entity that cannot be mapped."""
    try:
        copy = entity.copy()
        copy.transform(matrix)
    except BROKEN:
        return None
    return copy


class _Composed(Protocol):
    def virtual_entities(self) -> Iterable[DXFGraphic]:
        """What an entity consists of."""


def _parts(entity: DXFGraphic) -> Iterable[DXFGraphic]:
    """What an entity consists of, of a type that consists of others."""
    return cast(_Composed, entity).virtual_entities()
