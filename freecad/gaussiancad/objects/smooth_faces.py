"""How many faces a shape has, whatever seams it was written with.

FreeCAD's own ``removeSplitter`` leaves halves of cones, spheres and tori apart.
"""

from collections import defaultdict
from itertools import combinations

import Part

_SAME_MM = 1e-5
"""Distance of surfaces that are one."""

_INNER = (0.25, 0.5, 0.75)
"""Where a face is compared with a surface, as shares of its ranges of parameters."""


def count_faces(shape: Part.Shape) -> int:
    """Number of faces; those that share an edge and lie on one surface count once."""
    faces = shape.Faces
    leader = list(range(len(faces)))

    def first(number: int) -> int:
        while leader[number] != number:
            number = leader[number]
        return number

    for numbers in _sharing_edges(faces):
        for one, other in combinations(numbers, 2):
            if first(one) != first(other) and _on_one_surface(faces[one], faces[other]):
                leader[first(other)] = first(one)
    return len({first(number) for number in leader})


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
