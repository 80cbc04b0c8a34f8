"""Fillets and chamfers of a solid: which faces they are, and what edges they break."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import isclose, pi, sqrt

import numpy as np
import numpy.typing as npt
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.GeomAbs import GeomAbs_CurveType
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.features.solid_faces import Kind, SolidFace, cone_of, v_range
from gaussiancad_core.kernel.brep import ShapeTable
from gaussiancad_core.kernel.solid_edges import EdgeFacts, edge_facts

Vector = npt.NDArray[np.float64]

_SAME = 1e-4
"""Units within which radii and legs are one."""

_PARALLEL = 1e-5
"""Sine of the angle between parallel directions."""

_WIDEST = 12.0
"""Units of a chamfer's legs at most: what is wider is a slanted face of the part."""


@dataclass(frozen=True, eq=False)
class Blend:
    """A face that breaks an edge.

    Attributes:
        face: of the solid.
        size: units; the radius of a fillet, the legs of a chamfer.
        is_round: whether it is a fillet.
        place: (3,) a point of the face.
        is_corner: whether it lies where broken edges meet, and breaks none itself.
    """

    face: SolidFace
    size: float
    is_round: bool
    place: Vector
    is_corner: bool


@dataclass(frozen=True, eq=False)
class _Neighbour:
    """The other side of one of a face's edges."""

    number: int
    edge: EdgeFacts


class _Neighbours:
    """Faces of a solid, and what lies beside them."""

    def __init__(self, shape: TopoDS_Shape, faces: Sequence[SolidFace]) -> None:
        self.faces = faces
        self._table = ShapeTable()
        for face in faces:
            self._table.number(face.face)
        self.neighbours: list[list[_Neighbour]] = [[] for _ in faces]
        for edge in edge_facts(shape):
            if len(edge.faces) != 2 or edge.seam:
                continue
            one, other = (self._number(face) for face in edge.faces)
            self.neighbours[one].append(_Neighbour(other, edge))
            self.neighbours[other].append(_Neighbour(one, edge))

    def _number(self, face: TopoDS_Face) -> int:
        return self._table.number(face)

    def smooth(self, number: int) -> list[_Neighbour]:
        """Neighbours that a face goes on in smoothly."""
        return [near for near in self.neighbours[number] if near.edge.smooth]

    def sharp(self, number: int) -> list[_Neighbour]:
        """The other neighbours."""
        return [near for near in self.neighbours[number] if not near.edge.smooth]


def blends_of(shape: TopoDS_Shape, faces: Sequence[SolidFace]) -> tuple[tuple[Blend, ...], ...]:
    """The fillets and chamfers of a solid, in groups that hang together.

    Roundings that a sketch has as arcs, between faces across their axis, are none of them.

    Args:
        shape: one solid; units.
        faces: its faces.
    """
    around = _Neighbours(shape, faces)
    found = {number: blend for number, blend in enumerate(_seeds(around)) if blend is not None}
    found = _without_sides(found, around)
    _grow(found, around)
    groups: list[tuple[Blend, ...]] = []
    left = set(found)
    while left:
        group, reached = [], [min(left)]
        left.discard(reached[0])
        while reached:
            number = reached.pop()
            group.append(found[number])
            near = {neighbour.number for neighbour in around.neighbours[number]} & left
            left -= near
            reached.extend(sorted(near))
        groups.append(tuple(group))
    return tuple(groups)


def _seeds(around: _Neighbours) -> Iterator[Blend | None]:
    tests: dict[Kind, Callable[[_Neighbours, int], Blend | None]] = {
        Kind.CYLINDER: _round_edge,
        Kind.TORUS: _round_rim,
        Kind.SPHERE: _round_corner,
        Kind.PLANE: _flat_chamfer,
        Kind.CONE: _rim_chamfer,
    }
    for number, face in enumerate(around.faces):
        test = tests.get(face.kind)
        yield test(around, number) if test is not None else None


def _round_edge(around: _Neighbours, number: int) -> Blend | None:
    """A cylinder beside two faces that it goes on in, and that does not end at planes across."""
    face = around.faces[number]
    if len(around.smooth(number)) < 2 or face.turn > pi - _PARALLEL:
        return None
    if _ends_flat(around, number):
        return None
    return Blend(face, face.radius, True, face.place, False)


def _ends_flat(around: _Neighbours, number: int) -> bool:
    """Whether a cylinder ends at planes across its axis, or at what blends into such."""
    face = around.faces[number]
    ends = 0
    for near in around.neighbours[number]:
        curve = BRepAdaptor_Curve(near.edge.edge)
        if curve.GetType() == GeomAbs_CurveType.GeomAbs_Line:
            continue
        other = around.faces[near.number]
        across = float(np.linalg.norm(np.cross(other.direction, face.direction)))
        if (
            (other.kind is Kind.PLANE and across < _PARALLEL)
            or (other.kind is Kind.TORUS and across < _PARALLEL and other.minor < face.radius)
            or (other.kind is Kind.CONE and across < _PARALLEL)
        ):
            ends += 1
        else:
            return False
    return ends >= 2


def _round_rim(around: _Neighbours, number: int) -> Blend | None:
    """A torus between two faces that it goes on in."""
    face = around.faces[number]
    if len(around.smooth(number)) < 2:
        return None
    return Blend(face, face.minor, True, face.place, False)


def _round_corner(around: _Neighbours, number: int) -> Blend | None:
    """A sphere among faces that it goes on in."""
    face = around.faces[number]
    if len(around.smooth(number)) < 3:
        return None
    return Blend(face, face.radius, True, face.place, True)


def _flat_chamfer(around: _Neighbours, number: int) -> Blend | None:
    """A narrow plane at 45 degrees between two planes at right angles."""
    face = around.faces[number]
    near = [
        (neighbour, around.faces[neighbour.number])
        for neighbour in around.sharp(number)
        if around.faces[neighbour.number].kind is Kind.PLANE
    ]
    for k, (one, first) in enumerate(near):
        for other, second in near[:k]:
            if abs(float(first.direction @ second.direction)) > _PARALLEL:
                continue
            middle = (first.direction + second.direction) / sqrt(2.0)
            if float(np.linalg.norm(np.cross(middle, face.direction))) > _PARALLEL:
                continue
            leg = _apart(one.edge, other.edge) / sqrt(2.0)
            if _SAME < leg <= _WIDEST and leg < _length(one.edge):
                is_blend = float(middle @ face.direction) > 0.0
                return Blend(face, leg, False, face.place, False) if is_blend else None
    return None


def _rim_chamfer(around: _Neighbours, number: int) -> Blend | None:
    """A cone at 45 degrees between a plane across its axis and a cylinder about it."""
    face = around.faces[number]
    (_, one), (_, other) = cone_of(face, v_range(face))
    low, high = v_range(face)
    leg = abs(one - other)
    if not isclose(leg, (high - low) / sqrt(2.0), abs_tol=_SAME) or leg > _WIDEST:
        return None
    kinds = set()
    for neighbour in around.sharp(number):
        near = around.faces[neighbour.number]
        across = float(np.linalg.norm(np.cross(near.direction, face.direction)))
        if across < _PARALLEL and near.kind in (Kind.PLANE, Kind.CYLINDER):
            kinds.add(near.kind)
    if kinds != {Kind.PLANE, Kind.CYLINDER}:
        return None
    return Blend(face, leg, False, face.place, False)


def _without_sides(found: dict[int, Blend], around: _Neighbours) -> dict[int, Blend]:
    """Without faces that lie between two chamfers, which look like a chamfer between them."""
    return {
        number: blend
        for number, blend in found.items()
        if blend.is_round
        or not any(
            near.number in found and blend.size - found[near.number].size > _SAME
            for near in around.sharp(number)
        )
    }


def _grow(found: dict[int, Blend], around: _Neighbours) -> None:
    """Cylinders of the same radius that a fillet goes on in are fillets, too."""
    reached = [number for number, blend in found.items() if blend.is_round]
    while reached:
        number = reached.pop()
        for near in around.smooth(number):
            face = around.faces[near.number]
            is_like = face.kind is Kind.CYLINDER and abs(face.radius - found[number].size) < _SAME
            if near.number in found or not is_like or len(around.smooth(near.number)) < 2:
                continue
            origin = around.faces[number]
            across = float(np.linalg.norm(np.cross(origin.direction, face.direction)))
            if origin.kind is Kind.TORUS and across < _PARALLEL:
                continue
            found[near.number] = Blend(face, face.radius, True, face.place, False)
            reached.append(near.number)


def _apart(one: EdgeFacts, other: EdgeFacts) -> float:
    """Distance between the lines of two parallel straight edges; 0 of others."""
    (a, along), (b, way) = (_line(edge) for edge in (one, other))
    if float(np.linalg.norm(np.cross(along, way))) > _PARALLEL:
        return 0.0
    off = b - a
    return float(np.linalg.norm(off - along * float(off @ along)))


def _length(edge: EdgeFacts) -> float:
    curve = BRepAdaptor_Curve(edge.edge)
    return curve.LastParameter() - curve.FirstParameter()


def _line(edge: EdgeFacts) -> tuple[Vector, Vector]:
    curve = BRepAdaptor_Curve(edge.edge)
    start, end = (curve.Value(at) for at in (curve.FirstParameter(), curve.LastParameter()))
    a, b = (np.array([point.X(), point.Y(), point.Z()]) for point in (start, end))
    return a, (b - a) / np.linalg.norm(b - a)
