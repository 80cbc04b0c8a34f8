"""The faces of a shape, whatever seams it was written with.

FreeCAD's own ``removeSplitter`` leaves halves of cones, spheres and tori apart.
"""

from collections import defaultdict
from dataclasses import dataclass
from itertools import combinations

import FreeCAD
import Part

_SAME_MM = 1e-5
"""Distance of surfaces that are one."""

_SAME_SHARE = 1e-5
"""Of an area, or of its root, by which faces that are one differ: FreeCAD's areas are not exact."""

_INNER = (0.25, 0.5, 0.75)
"""Where a face is compared with a surface, as shares of its ranges of parameters."""


@dataclass(frozen=True)
class _Face:
    """A face of a shape, or several that lie on one surface and touch.

    Attributes:
        kind: of its surface.
        area: mm2.
        centre: of its area, mm.
    """

    kind: str
    area: float
    centre: FreeCAD.Vector

    def is_like(self, other: "_Face") -> bool:
        """Whether two faces are as good as the same."""
        return (
            self.kind == other.kind
            and abs(self.area - other.area) <= _SAME_SHARE * self.area
            and self.centre.distanceToPoint(other.centre) <= _SAME_SHARE * self.area**0.5
        )


def count_faces(shape: Part.Shape) -> int:
    """Number of faces; those that share an edge and lie on one surface count once."""
    return len(_groups(shape.Faces))


def have_same_faces(first: Part.Shape, second: Part.Shape) -> bool:
    """Whether each face of a shape is one of another shape, and no face is left over there."""
    left = _faces(second)
    for face in _faces(first):
        like = next((each for each in left if face.is_like(each)), None)
        if like is None:
            return False
        left.remove(like)
    return not left


def _faces(shape: Part.Shape) -> list[_Face]:
    found = []
    for group in _groups(shape.Faces):
        area = sum(face.Area for face in group)
        centre = sum((face.CenterOfMass * face.Area for face in group), FreeCAD.Vector())
        found.append(_Face(group[0].Surface.TypeId, area, centre / area))
    return found


def _groups(faces: list[Part.Face]) -> list[list[Part.Face]]:
    """Faces that share an edge and lie on one surface, together."""
    leader = list(range(len(faces)))

    def first(number: int) -> int:
        while leader[number] != number:
            number = leader[number]
        return number

    for numbers in _sharing_edges(faces):
        for one, other in combinations(numbers, 2):
            if first(one) != first(other) and _on_one_surface(faces[one], faces[other]):
                leader[first(other)] = first(one)
    groups: dict[int, list[Part.Face]] = defaultdict(list)
    for number, face in enumerate(faces):
        groups[first(number)].append(face)
    return list(groups.values())


def _sharing_edges(faces: list[Part.Face]) -> list[list[int]]:
    """Numbers of the faces at each edge."""
    at_edge: dict[int, list[int]] = defaultdict(list)
    for number, face in enumerate(faces):
        for edge in face.Edges:
            at_edge[edge.hashCode()].append(number)
    return [sorted(set(numbers)) for numbers in at_edge.values()]


def _on_one_surface(face: Part.Face, other: Part.Face) -> bool:
    surface = face.Surface
    if surface.TypeId != other.Surface.TypeId:
        return False
    low_u, high_u, low_v, high_v = other.ParameterRange
    for share in _INNER:
        for across in _INNER:
            point = other.Surface.value(
                low_u + share * (high_u - low_u), low_v + across * (high_v - low_v)
            )
            if point.distanceToPoint(surface.value(*surface.parameter(point))) > _SAME_MM:
                return False
    return True
