"""Ends of lines that meet, for coincident constraints."""

from collections.abc import Iterator, Sequence

from freecad.gaussiancad.objects.plane_shapes import Point, Shape, ends_of

START, END = 1, 2
"""How a sketch numbers the ends of a line or an arc."""

Meeting = tuple[int, int, int, int]
"""A line and its end, and another line and its end."""


def meeting_ends(shapes: Sequence[Shape], reach: float) -> Iterator[Meeting]:
    """Each end that lies where an end of an earlier line does, with that one.

    Args:
        shapes: in the order of the sketch.
        reach: up to which distance ends are the same, far less than any line is long.
    """
    known: dict[tuple[int, int], tuple[int, int, Point]] = {}
    for number, shape in enumerate(shapes):
        for end, point in zip((START, END), ends_of(shape) or (), strict=False):
            cell = round(point[0] / reach), round(point[1] / reach)
            other = _near(known, cell, point, reach)
            if other is None:
                known[cell] = number, end, point
            elif other[0] != number:
                yield other[0], other[1], number, end


def _near(
    known: dict[tuple[int, int], tuple[int, int, Point]],
    cell: tuple[int, int],
    point: Point,
    reach: float,
) -> tuple[int, int] | None:
    for across in (0, -1, 1):
        for up in (0, -1, 1):
            found = known.get((cell[0] + across, cell[1] + up))
            if found is None:
                continue
            number, end, (x, y) = found
            if abs(x - point[0]) <= reach and abs(y - point[1]) <= reach:
                return number, end
    return None
