"""What each build123d script begins with: how planes, arcs and holes are made."""

HEAD = '''"""A part by its features; written by GaussianCAD.

It needs build123d (pip install build123d).  Run it to write {stem}.step; change a number first to
have another part.  Lengths are mm.
"""

from math import cos, hypot, radians, sin, tan

from build123d import *


def plane(offset, right, normal):
    return Plane(origin=tuple(offset * part for part in normal), x_dir=right, z_dir=normal)


def arc(start, end, centre, is_counterclockwise):
    """The arc around a centre; the radius is that of its start."""
    from math import atan2, pi

    radius = hypot(start[0] - centre[0], start[1] - centre[1])
    first = atan2(start[1] - centre[1], start[0] - centre[0])
    last = atan2(end[1] - centre[1], end[0] - centre[0])
    turn = (last - first) % (2 * pi) if is_counterclockwise else -((first - last) % (2 * pi))
    middle = first + turn / 2
    return ThreePointArc(
        start,
        (centre[0] + radius * cos(middle), centre[1] + radius * sin(middle)),
        end,
    )


def region(outlines):
    """The face between outlines: the first one is around the others."""
    outer, *holes = (make_face(Wire(edges)) for edges in outlines)
    for hole in holes:
        outer -= hole
    return outer


def nearest(part, place):
    return min(part.edges(), key=lambda edge: edge.distance_to(Vector(place)))


def drilled(where, centre, diameter, depth, tip, sink):
    """What a drill takes away that enters a plane against its normal."""
    at = where.location * Location((*centre, 0))
    radius = diameter / 2
    body = at * Location((0, 0, -depth / 2)) * Cylinder(radius, depth)
    if tip:
        length = radius / tan(radians(tip) / 2)
        body += at * Location((0, 0, -depth - length / 2)) * Cone(0, radius, length)
    if sink:
        wide, deep, angle = sink
        if angle:
            length = (wide / 2 - radius) / tan(radians(angle) / 2)
            body += at * Location((0, 0, -length / 2)) * Cone(radius, wide / 2, length)
        else:
            body += at * Location((0, 0, -deep / 2)) * Cylinder(wide / 2, deep)
    return body


{repeating}
THROUGH = {through!r}  # mm, longer than the part

'''
"""To be formatted with the stem of the file, what repeats bodies, and the length of a hole through
the part."""
