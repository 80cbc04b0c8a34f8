"""Blocks, slides and plates: parts of textbooks that come from the mill."""

from itertools import product
from math import pi, radians, tan

from OCP.TopoDS import TopoDS_Shape

from benchmarks.parts.textbook_modelling import (
    FAR,
    Lot,
    corners,
    counterbored,
    edges_along,
    edges_at,
    families,
    hole,
    milled_slot,
    ring_of_points,
    upright_edges,
)
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.samples.modelling import box, chamfered, cut, fuse, prism


def v_block(lot: Lot) -> TopoDS_Shape:
    """A block with a V and a relief below it, grooves at its sides; some have a second V."""
    length, width, height = lot.size(60, 100, 5), lot.size(40, 70, 5), lot.size(40, 60, 5)
    wide, relief = lot.size(14, 20, 2), lot.size(2, 4)
    groove, depth, above = lot.size(6, 10, 2), lot.size(5, 9), lot.size(12, 16)
    middle = width / 2
    vee = [
        (middle - wide, height), (middle, height - wide), (middle + wide, height),
        (middle + wide, height + 5), (middle - wide, height + 5),
    ]  # fmt: skip
    bottom = height - wide - 4
    part = cut(
        box((0, 0, 0), (length, width, height)),
        prism(Axis.X, vee, -1, FAR),
        box((-1, middle - relief / 2, bottom), (FAR, middle + relief / 2, bottom + 20)),
        box((-1, -1, above), (FAR, depth, above + groove)),
        box((-1, width - depth, above), (FAR, width + 1, above + groove)),
    )
    if not lot.chance():
        return part
    half = wide / 2
    small = [
        (middle - half, -1), (middle + half, -1), (middle + half, 0), (middle, half),
        (middle - half, 0),
    ]  # fmt: skip
    return cut(part, prism(Axis.X, small, -1, FAR))


def dovetail_slide(lot: Lot) -> TopoDS_Shape:
    """A plate with a dovetail on it and a hole in each corner; some have a groove below."""
    length, width, plate = lot.size(60, 90, 5), lot.size(50, 80, 5), lot.size(16, 24, 2)
    angle, neck, rise = lot.one_of(45, 55, 60), lot.size(20, 30, 2), lot.size(8, 12)
    inset = lot.size(10, 14, 2)
    over, middle = rise / tan(radians(angle)), width / 2
    tail = [
        (middle - neck / 2, plate), (middle + neck / 2, plate),
        (middle + neck / 2 + over, plate + rise), (middle - neck / 2 - over, plate + rise),
    ]  # fmt: skip
    part = fuse(box((0, 0, 0), (length, width, plate)), prism(Axis.X, tail, 0, length))
    aside = inset / 2 + 2
    for centre in product((inset, length - inset), (aside, width - aside)):
        part = cut(part, hole(Axis.Z, centre, 2.5, -1, plate + 1))
    if lot.chance():
        part = cut(part, box((-1, middle - 6, -1), (FAR, middle + 6, 5)))
    return part


def dovetail_socket(lot: Lot) -> TopoDS_Shape:
    """A block with the groove of a dovetail, chamfered corners and a hole for a clamping screw."""
    length, width, height = lot.size(50, 80, 5), lot.size(60, 80, 5), lot.size(26, 34, 2)
    neck, depth, slant = lot.size(24, 32, 2), lot.size(10, 14), lot.size(3, 5)
    over, middle, floor = depth / tan(radians(60)), width / 2, height - depth
    near, far = middle - neck / 2, middle + neck / 2
    groove = [
        (near, height + 1), (near, height), (near - over, floor), (far + over, floor),
        (far, height), (far, height + 1),
    ]  # fmt: skip
    part = cut(
        box((0, 0, 0), (length, width, height)),
        prism(Axis.X, groove, -1, FAR),
        hole(Axis.Y, (length / 2, height - depth / 2), 3, -1, middle - 1),
    )
    return chamfered(part, upright_edges(part, length, width), slant)


def tslot_nut(lot: Lot) -> TopoDS_Shape:
    """A nut that slides in a T-slot, chamfered below or at its corners, some at their neck."""
    length, width, base = lot.size(30, 50, 5), lot.size(28, 36, 2), lot.size(8, 12)
    neck, rise, bore = lot.size(16, 20, 2), lot.size(8, 14, 2), lot.size(3, 5)
    slant, below = lot.size(1, 3), lot.chance()
    side, top = (width - neck) / 2, base + rise
    part = fuse(
        box((0, 0, 0), (length, width, base)),
        box((0, side, base - 1), (length, side + neck, top)),
    )
    part = cut(part, hole(Axis.Z, (length / 2, width / 2), bore))
    lower = edges_along(part, Axis.X, [(0, 0), (width, 0)])
    part = chamfered(part, lower if below else upright_edges(part, length, width), slant)
    return chamfered(part, edges_at(part, Axis.Z, top), 1) if lot.chance() else part


def step_block(lot: Lot) -> TopoDS_Shape:
    """A staircase with a groove below it, two chamfered corners, and a hole."""
    length, width, height = lot.size(60, 100, 5), lot.size(30, 50, 5), lot.size(40, 60, 5)
    steps, slant, groove = int(lot.one_of(3, 4)), lot.size(3, 5), lot.size(6, 9)
    part = box((0, 0, 0), (length, width, height))
    run, rise = length / steps, height / steps
    for number in range(1, steps):
        part = cut(part, box((number * run, -1, height - number * rise), (FAR, FAR, FAR)))
    part = chamfered(part, edges_along(part, Axis.Z, [(0, 0), (0, width)]), slant)
    part = cut(part, box((-1, width / 2 - 5, -1), (FAR, width / 2 + 5, groove)))
    if lot.chance():
        return cut(part, hole(Axis.Z, (length - run / 2, width / 2), 4))
    return cut(part, hole(Axis.Y, (run / 2, height / 2), lot.size(6, 8)))


def wedge(lot: Lot) -> TopoDS_Shape:
    """A wedge with a slot through its slant, and a hole or a notch at its thick end."""
    length, width = lot.size(60, 90, 5), lot.size(30, 44, 2)
    high, low = lot.size(24, 36, 2), lot.size(8, 14, 2)
    radius, half = lot.size(5, 7), lot.size(8, 14, 2)
    outline = [(0, 0), (length, 0), (length, low), (12, high), (0, high)]
    part = cut(
        prism(Axis.Y, outline, 0, width),
        milled_slot(Axis.Z, (length * 0.6, width / 2), half, radius),
    )
    if lot.chance():
        return cut(part, hole(Axis.X, (width / 2, high / 2), 4, -1, 19))
    return cut(part, box((-1, width / 2 - 4, high - 6), (13, width / 2 + 4, FAR)))


def guide_rail(lot: Lot) -> TopoDS_Shape:
    """A rail with notched sides and a row of counterbored holes."""
    length, width, height = lot.size(90, 140, 10), lot.size(24, 36, 2), lot.size(24, 34, 2)
    notch, holes = lot.size(4, 6), int(lot.one_of(3, 4))
    low, high = 0.4 * height, height - notch - 2
    right = [(width, low), (width - notch, low + notch), (width - notch, high)]
    right += [(width, height - 2), (width, height)]
    left = [(width - u, v) for u, v in reversed(right)]
    part = prism(Axis.X, [(0, 0), (width, 0), *right, *left], 0, length)
    for number in range(holes):
        x = length * (number + 0.5) / holes
        part = counterbored(part, (x, width / 2), (3, 5.5), height - 6)
    return part


def manifold(lot: Lot) -> TopoDS_Shape:
    """A block with a long blind bore that three ports from above and one from the front meet."""
    length, width, height = lot.size(70, 100, 5), lot.size(36, 50, 2), lot.size(36, 50, 2)
    main, port = lot.size(6, 8), lot.size(3, 5)
    middle, centre = width / 2, height / 2
    part = box((0, 0, 0), (length, width, height))
    part = cut(part, hole(Axis.X, (middle, centre), main, -1, length - 11))
    for x in (18, length / 2, length - 18):
        part = cut(
            part,
            hole(Axis.Z, (x, middle), port, centre),
            hole(Axis.Z, (x, middle), port + 3, height - 5),
        )
    part = cut(part, hole(Axis.Y, (length / 2, centre), port, -1, middle))
    return cut(part, *(hole(Axis.Z, at, 2) for at in corners(length, width, 7)))


def tool_post(lot: Lot) -> TopoDS_Shape:
    """A square post with two grooves for tools, and screws above them."""
    side, height, groove = lot.size(50, 70, 5), lot.size(50, 70, 5), lot.size(14, 20, 2)
    depth, bore, above = lot.size(10, 14), lot.size(6, 9), lot.size(14, 18)
    near, far, slant = lot.size(8, 10), lot.size(8, 10), lot.size(2, 4)
    part = cut(
        box((0, 0, 0), (side, side, height)),
        box((-1, -1, above), (FAR, depth, above + groove)),
        box((-1, side - depth, above), (FAR, FAR, above + groove)),
        hole(Axis.Z, (side / 2, side / 2), bore),
    )
    for centre in product((near, side / 2, side - far), (depth / 2, side - depth / 2)):
        part = cut(part, hole(Axis.Z, centre, 2, above + 1))
    return chamfered(part, upright_edges(part, side, side), slant) if lot.chance() else part


def cross_slide(lot: Lot) -> TopoDS_Shape:
    """Two crossed bars, each with a groove, and a hole where they meet."""
    length, width, thickness = lot.size(70, 100, 5), lot.size(60, 80, 5), lot.size(12, 16, 2)
    lower, upper, groove = lot.size(24, 32, 2), lot.size(20, 28, 2), lot.size(5, 8)
    x, y = length / 2, width / 2
    top = 2 * thickness
    part = fuse(
        box((0, y - lower / 2, 0), (length, y + lower / 2, thickness)),
        box((x - upper / 2, 0, thickness), (x + upper / 2, width, top)),
        box((x - upper / 2, y - lower / 2, 0), (x + upper / 2, y + lower / 2, top)),
    )
    part = cut(
        part,
        box((-1, y - groove, -1), (FAR, y + groove, 4)),
        box((x - groove, -1, top - 5), (x + groove, FAR, FAR)),
        hole(Axis.Z, (x, y), groove - 1.5),
    )
    aside = y - lower / 2 + 6
    return cut(part, *(hole(Axis.Z, (at, aside), 2.5) for at in (8, length - 8)))


def motor_plate(lot: Lot) -> TopoDS_Shape:
    """A plate with two cut corners, a recess and four holes for a motor, on an upright edge."""
    length, width, thickness = lot.size(70, 100, 5), lot.size(60, 80, 5), lot.size(8, 12)
    recess, edge = lot.size(14, 20), lot.size(14, 20, 2)
    outline = [
        (0, 0), (length, 0), (length, width - 15), (length - 15, width), (15, width),
        (0, width - 15),
    ]  # fmt: skip
    middle = (length / 2, width / 2)
    part = prism(Axis.Z, outline, 0, thickness)
    part = counterbored(part, middle, (recess - 4, recess), thickness - 3)
    screws = ring_of_points(4, recess + 6, middle, pi / 4)
    part = cut(part, *(hole(Axis.Z, at, 2.5) for at in screws))
    part = fuse(part, box((0, 0, thickness - 0.5), (length, 8, thickness - 0.5 + edge)))
    return cut(part, *(hole(Axis.Y, (x, thickness + 7), 3, -1, 19) for x in (15, length - 15)))


BLOCKS = families(
    "blocks",
    v_block,
    dovetail_slide,
    dovetail_socket,
    tslot_nut,
    step_block,
    wedge,
    guide_rail,
    manifold,
    tool_post,
    cross_slide,
    motor_plate,
)
