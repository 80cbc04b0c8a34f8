"""Levers, rods and links: parts of textbooks that turn other parts, or hold on to them."""

from OCP.TopoDS import TopoDS_Shape

from benchmarks.parts.textbook_modelling import (
    FAR,
    Lot,
    belt,
    edges_at,
    families,
    hole,
    milled_slot,
    rims,
)
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.samples.modelling import (
    box,
    chamfered,
    cone,
    cut,
    cylinder,
    fuse,
    slot,
)


def clevis(lot: Lot) -> TopoDS_Shape:
    """A fork with round ends and a pin's hole, on a shank that may be chamfered."""
    width, height, gap = lot.size(30, 44, 2), lot.size(30, 40, 2), lot.size(12, 18, 2)
    length, pin, shank = lot.size(40, 60, 5), lot.size(6, 10), lot.size(8, 12)
    reach, throat = lot.size(20, 35, 5), lot.size(18, 26, 2)
    half = height / 2
    part = fuse(
        box((0, 0, 0), (length - half, width, height)),
        cylinder(Axis.Y, (length - half, half), half, 0, width),
    )
    between = box((throat, (width - gap) / 2, -1), (FAR, (width + gap) / 2, FAR))
    part = cut(part, between, hole(Axis.Y, (length - half, half), pin))
    part = fuse(part, cylinder(Axis.X, (width / 2, half), shank, -reach, 1))
    return chamfered(part, edges_at(part, Axis.X, -reach), 2) if lot.chance() else part


def rod_end(lot: Lot) -> TopoDS_Shape:
    """A flat rod between two eyes of different sizes."""
    large, bore, width = lot.size(18, 24), lot.size(8, 12), lot.size(20, 28, 2)
    height, thickness, length = lot.size(16, 24, 2), lot.size(8, 12, 2), lot.size(60, 90, 5)
    small, pin = lot.size(12, 16), lot.size(4, 7)
    side = (width - thickness) / 2
    part = fuse(
        cylinder(Axis.Y, (0, 0), large, 0, width),
        box((0, side, -height / 2), (length, side + thickness, height / 2)),
        cylinder(Axis.Y, (length, 0), small, side - 3, side + thickness + 3),
    )
    return cut(part, hole(Axis.Y, (0, 0), bore), hole(Axis.Y, (length, 0), pin))


def crank_arm(lot: Lot) -> TopoDS_Shape:
    """A web between two bosses, whose outline is their tangents; the larger one may have a key."""
    large, small, length = lot.size(18, 24), lot.size(11, 15), lot.size(60, 90, 5)
    web, rise, other_rise = lot.size(10, 14, 2), lot.size(8, 14, 2), lot.size(4, 8, 2)
    bore, pin = lot.size(8, 11), lot.size(5, 7)
    part = fuse(
        belt(((0, 0), large), ((length, 0), small), 0, web),
        cylinder(Axis.Z, (0, 0), large, 0, web + rise),
        cylinder(Axis.Z, (length, 0), small, 0, web + other_rise),
    )
    part = cut(part, hole(Axis.Z, (0, 0), bore), hole(Axis.Z, (length, 0), pin))
    return cut(part, box((0, -2.5, -1), (bore + 3, 2.5, FAR))) if lot.chance() else part


def cam(lot: Lot) -> TopoDS_Shape:
    """A pear-shaped disc with a hub and a keyway."""
    base, nose, lift = lot.size(22, 30, 2), lot.size(8, 12), lot.size(24, 34, 2)
    thickness, bore = lot.size(10, 16, 2), lot.size(8, 11)
    hub, rise = bore + lot.size(4, 7), lot.size(8, 14, 2)
    tip = (lift, 0.0) if lot.chance() else (0.0, lift)
    part = fuse(
        belt(((0, 0), base), (tip, nose), 0, thickness),
        cylinder(Axis.Z, (0, 0), hub, thickness - 1, thickness + rise),
    )
    return cut(part, hole(Axis.Z, (0, 0), bore), box((-2, 0, -1), (2, bore + 2.5, FAR)))


def offset_lever(lot: Lot) -> TopoDS_Shape:
    """A flat lever with a round end on a hub that goes on to both sides; some have a set screw."""
    length, width, thickness = lot.size(70, 100, 5), lot.size(16, 22, 2), lot.size(8, 12)
    hub, bore, rise = lot.size(14, 18), lot.size(6, 9), lot.size(24, 34, 2)
    below, pin = lot.size(6, 10), lot.size(3, 5)
    part = fuse(
        box((0, -width / 2, 0), (length, width / 2, thickness)),
        cylinder(Axis.Z, (0, 0), hub, -below, rise),
        cylinder(Axis.Z, (length, 0), width / 2, 0, thickness),
    )
    part = cut(part, hole(Axis.Z, (0, 0), bore), hole(Axis.Z, (length, 0), pin))
    return cut(part, hole(Axis.X, (0, rise - 7), 2, -FAR, 0)) if lot.chance() else part


def slotted_link(lot: Lot) -> TopoDS_Shape:
    """A link with a slot and a hole, which may stand on a boss; one end may be thinner."""
    length, radius = lot.size(80, 120, 10), lot.size(14, 20, 2)
    thickness, bore, half = lot.size(8, 12, 2), lot.size(6, 9), lot.size(14, 20, 2)
    ends = ((-length / 2, 0.0), (length / 2, 0.0))
    part = slot(Axis.Z, ends, radius, 0, thickness)
    if lot.chance():
        part = fuse(part, cylinder(Axis.Z, ends[0], radius, 0, thickness + 6))
    part = cut(part, milled_slot(Axis.Z, (half - 6, 0), half, bore), hole(Axis.Z, ends[0], bore))
    if lot.chance():
        part = cut(part, box((length / 2 - 2, -FAR, thickness / 2), (FAR, FAR, FAR)))
    return part


def square_eye(lot: Lot) -> TopoDS_Shape:
    """A square bar, chamfered at its end, on an eye whose bore may be chamfered."""
    side, length, eye = lot.size(14, 20, 2), lot.size(40, 60, 5), lot.size(14, 18)
    bore, width = lot.size(6, 8), side + lot.size(2, 6, 2)
    half = side / 2
    part = fuse(
        box((0, -half, -half), (length, half, half)),
        cylinder(Axis.Y, (length, 0), eye, -width / 2, width / 2),
    )
    part = cut(part, hole(Axis.Y, (length, 0), bore))
    part = chamfered(part, edges_at(part, Axis.X, 0), 1.5)
    if lot.chance():
        ends = rims(part, Axis.Y, ((length, 0), bore), -width / 2, width / 2)
        part = chamfered(part, ends, 1.5)
    return part


def gland(lot: Lot) -> TopoDS_Shape:
    """An oval flange with two bolt holes around a sleeve, whose bore may be countersunk."""
    thickness, apart, sleeve = lot.size(8, 12), lot.size(30, 40, 2), lot.size(14, 18)
    rise, bore, ear = lot.size(16, 24, 2), lot.size(8, 10), lot.size(9, 12)
    top = thickness + rise
    part = fuse(
        belt(((0, 0), sleeve + 6), ((apart, 0), ear), 0, thickness),
        belt(((0, 0), sleeve + 6), ((-apart, 0), ear), 0, thickness),
        cylinder(Axis.Z, (0, 0), sleeve, thickness - 1, top),
    )
    part = cut(
        part,
        hole(Axis.Z, (0, 0), bore),
        hole(Axis.Z, (apart, 0), 4),
        hole(Axis.Z, (-apart, 0), 4),
    )
    return cut(part, cone(Axis.Z, (0, 0), (bore, bore + 3), top - 3, top)) if lot.chance() else part


LEVERS = families(
    "levers", clevis, rod_end, crank_arm, cam, offset_lever, slotted_link, square_eye, gland
)
