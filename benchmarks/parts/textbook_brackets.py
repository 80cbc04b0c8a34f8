"""Brackets, blocks that carry a shaft, covers: parts of textbooks that are screwed on."""

from itertools import product

from OCP.TopoDS import TopoDS_Shape

from benchmarks.parts.textbook_modelling import (
    FAR,
    Lot,
    counterbored,
    edges_along,
    families,
    hole,
    milled_slot,
    rounded_plate,
    upright_edges,
)
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.samples.modelling import (
    box,
    chamfered,
    cone,
    cut,
    cylinder,
    filleted,
    fuse,
    prism,
)


def bearing_block(lot: Lot) -> TopoDS_Shape:
    """A shaft's seat on a foot with two screw holes, some counterbored, some with an oil hole."""
    length, width, foot = lot.size(90, 130, 5), lot.size(30, 46, 2), lot.size(10, 16)
    outer = lot.size(20, 26)
    inner, height = lot.size(10, outer - 7), foot + lot.size(18, 26)
    middle, screw = length / 2, lot.size(4, 6)
    part = fuse(
        box((0, 0, 0), (length, width, foot)),
        box((middle - outer, 0, foot - 1), (middle + outer, width, height)),
        cylinder(Axis.Y, (middle, height), outer, 0, width),
    )
    part = cut(part, hole(Axis.Y, (middle, height), inner))
    sunk, depth = lot.chance(), lot.size(3, 4)
    aside = (middle - outer) / 2
    for x in (aside, length - aside):
        part = cut(part, hole(Axis.Z, (x, width / 2), screw))
        if sunk:
            part = cut(part, hole(Axis.Z, (x, width / 2), screw + 3, foot - depth, foot + 20))
    oiled = lot.chance()
    return cut(part, hole(Axis.Z, (middle, width / 2), 3, height)) if oiled else part


def pillow(lot: Lot) -> TopoDS_Shape:
    """A block with round corners and a bored boss; of its holes two are sunk, two countersunk."""
    length, width, height = lot.size(70, 100, 5), lot.size(50, 70, 5), lot.size(16, 24, 2)
    boss, rise, bore = lot.size(16, 20), lot.size(8, 14, 2), lot.size(9, 12)
    inset = lot.size(10, 13)
    middle = (length / 2, width / 2)
    part = fuse(
        rounded_plate(length, width, inset - 2, height),
        cylinder(Axis.Z, middle, boss, height - 1, height + rise),
    )
    part = cut(part, hole(Axis.Z, middle, bore))
    far_x, far_y = length - inset, width - inset
    for centre in ((inset, inset), (far_x, far_y)):
        part = counterbored(part, centre, (3, 5.5), height - 5)
    for centre in ((far_x, inset), (inset, far_y)):
        sink = cone(Axis.Z, centre, (3, 6), height - 3, height)
        part = cut(part, hole(Axis.Z, centre, 3), sink)
    return part


def angle_bracket(lot: Lot) -> TopoDS_Shape:
    """Two legs with a web between them; slots in the lower one, holes in the upright one."""
    length, width, height = lot.size(60, 90, 5), lot.size(40, 60, 5), lot.size(50, 80, 5)
    wall, web, reach = lot.size(6, 10, 2), lot.size(6, 8), lot.size(20, 30, 5)
    inset, radius, half = lot.size(9, 11), lot.size(3, 4), lot.size(5, 8)
    middle = width / 2
    part = fuse(
        box((0, 0, 0), (length, width, wall)),
        box((0, 0, 0), (wall, width, height)),
        prism(
            Axis.Y,
            [(wall, wall), (wall + reach, wall), (wall, wall + reach)],
            middle - web / 2,
            middle + web / 2,
        ),
    )
    for y in (inset, width - inset):
        part = cut(
            part,
            milled_slot(Axis.Z, (length - 18, y), half, radius),
            hole(Axis.X, (y, height - inset), radius),
        )
    if lot.chance():
        upper = edges_along(part, Axis.X, [(0, height), (width, height)])
        part = filleted(part, upper, lot.size(6, 10, 2))
    if lot.chance():
        outer = edges_along(part, Axis.Z, [(length, 0), (length, width)])
        part = chamfered(part, outer, lot.size(6, 10, 2))
    return part


def u_bracket(lot: Lot) -> TopoDS_Shape:
    """Two walls on a floor, for a pin; walls with round corners, or bent from one sheet."""
    length, width, height = lot.size(50, 70, 5), lot.size(40, 60, 5), lot.size(40, 60, 5)
    wall, pin, screw = lot.size(6, 10, 2), lot.size(5, 8), lot.size(5, 8)
    above = height - lot.size(14, 18, 2)
    part = cut(
        box((0, 0, 0), (length, width, height)),
        box((wall, -1, wall), (length - wall, width + 1, height + 1)),
        hole(Axis.X, (width / 2, above), pin),
        hole(Axis.Z, (length / 2, width / 2), screw),
    )
    variant = lot.one_of(0, 1, 2)
    if variant == 1:
        upper = edges_along(part, Axis.X, [(0, height), (width, height)])
        return filleted(part, upper, lot.size(8, 12, 2))
    if variant == 2:
        part = filleted(part, edges_along(part, Axis.Y, [(0, 0), (length, 0)]), wall + 2)
        inner = edges_along(part, Axis.Y, [(wall, wall), (length - wall, wall)])
        return filleted(part, inner, 2)
    return part


def hinge_leaf(lot: Lot) -> TopoDS_Shape:
    """A leaf with countersunk holes and knuckles in every other part of its length."""
    length, width = lot.size(60, 90, 6), lot.size(30, 45, 5)
    thickness, pin = lot.size(4, 6), lot.size(3, 4)
    outer = pin + thickness
    knuckles = 3 if lot.chance() else 5
    each = length / knuckles
    part = fuse(
        box((0, 0, 0), (length, width, thickness)),
        cylinder(Axis.X, (0, outer), outer, 0, length),
        box((0, 0, 0), (length, outer, thickness)),
    )
    part = cut(part, hole(Axis.X, (0, outer), pin))
    for number in range(1, knuckles, 2):
        start = number * each
        part = cut(part, box((start, -outer - 1, -1), (start + each, outer + 1, FAR)))
    for x in (10, length / 2, length - 10):
        sink = cone(Axis.Z, (x, width - 9), (2.5, 4.5), thickness - 2, thickness)
        part = cut(part, hole(Axis.Z, (x, width - 9), 2.5), sink)
    return part


def saddle_clamp(lot: Lot) -> TopoDS_Shape:
    """Half a ring between two feet, over a pipe."""
    length, width, wall = lot.size(80, 110, 5), lot.size(20, 30, 2), lot.size(6, 9)
    pipe = lot.size(12, 18, 2)
    middle, outer = length / 2, pipe + wall
    part = fuse(
        box((0, 0, 0), (length, width, wall)), cylinder(Axis.Y, (middle, 0), outer, 0, width)
    )
    part = cut(part, box((-1, -1, -FAR), (FAR, FAR, 0)), hole(Axis.Y, (middle, 0), pipe))
    aside = (middle - outer) / 2
    for x in (aside, length - aside):
        part = cut(part, hole(Axis.Z, (x, width / 2), 3.5))
    if lot.chance():
        part = filleted(part, upright_edges(part, length, width), lot.size(4, 8, 2))
    return part


def ribbed_box(lot: Lot) -> TopoDS_Shape:
    """An open box with ribs, posts for screws, and a hole for a cable."""
    length, width, height = lot.size(70, 100, 5), lot.size(50, 70, 5), lot.size(26, 36, 2)
    wall, cable = lot.size(3, 5), lot.size(3, 5)
    part = cut(
        box((0, 0, 0), (length, width, height)),
        box((wall, wall, wall), (length - wall, width - wall, height + 1)),
    )
    ribs = int(lot.one_of(1, 2))
    for number in range(ribs):
        x = length * (number + 1) / 3
        half = wall / 2
        part = fuse(part, box((x, half, half), (x + 3, width - half, half + height / 2)))
    part = cut(part, hole(Axis.Y, (length * 0.85, height * 0.6), cable, -1, 29))
    for x in (wall + 3, length - wall - 3):
        part = fuse(part, cylinder(Axis.Z, (x, width / 2), 4, 1, height - 5))
        part = cut(part, hole(Axis.Z, (x, width / 2), 1.5, wall + 4))
    if lot.chance():
        part = filleted(part, upright_edges(part, length, width), lot.size(4, 6))
    return part


def oring_cover(lot: Lot) -> TopoDS_Shape:
    """A square cover with raised corners and a groove for a seal around its bore."""
    side, thickness, bore = lot.size(60, 90, 5), lot.size(10, 14), lot.size(8, 14, 2)
    inset, inner, groove = lot.size(8, 10), bore + lot.size(4, 6), lot.size(3, 4)
    middle = (side / 2, side / 2)
    part = rounded_plate(side, side, inset, thickness)
    for centre in product((inset, side - inset), repeat=2):
        part = fuse(part, cylinder(Axis.Z, centre, inset - 2, thickness - 1, thickness + 3))
        part = cut(part, hole(Axis.Z, centre, 3))
    floor = thickness - 2.5
    ring = cut(cylinder(Axis.Z, middle, inner + groove, floor, FAR), hole(Axis.Z, middle, inner))
    return cut(part, hole(Axis.Z, middle, bore), ring)


BRACKETS = families(
    "brackets",
    bearing_block,
    pillow,
    angle_bracket,
    u_bracket,
    hinge_leaf,
    saddle_clamp,
    ribbed_box,
    oring_cover,
)
