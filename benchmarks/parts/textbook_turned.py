"""Shafts, wheels, fittings: parts of textbooks that come from the lathe."""

from math import pi

from OCP.TopoDS import TopoDS_Shape

from benchmarks.parts.textbook_modelling import (
    FAR,
    Lot,
    edges_at,
    families,
    hexagon,
    hole,
    milled_slot,
    rims,
    ring_of_points,
)
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.samples.modelling import (
    box,
    chamfered,
    cut,
    cylinder,
    filleted,
    fuse,
    prism,
    revolved,
)


def flange(lot: Lot) -> TopoDS_Shape:
    """A disc with a hub and a ring of bolt holes; the hub may be chamfered, the bore recessed."""
    radius, thickness = lot.size(45, 60, 5), lot.size(10, 16, 2)
    hub, rise, bore = lot.size(20, 26, 2), lot.size(20, 35, 5), lot.size(10, 15)
    count, bolt = int(lot.one_of(4, 6, 8)), lot.size(3, 5)
    first = pi / count if lot.chance() else 0.0
    top = thickness + rise
    part = fuse(
        cylinder(Axis.Z, (0, 0), radius, 0, thickness),
        cylinder(Axis.Z, (0, 0), hub, thickness - 1, top),
    )
    bolts = ring_of_points(count, (radius + hub) / 2, first=first)
    part = cut(part, hole(Axis.Z, (0, 0), bore), *(hole(Axis.Z, at, bolt) for at in bolts))
    if lot.chance():
        part = chamfered(part, edges_at(part, Axis.Z, top), 1.5)
    if lot.chance():
        part = cut(part, hole(Axis.Z, (0, 0), bore + 4, -1, lot.size(3, 5)))
    return part


def stepped_shaft(lot: Lot) -> TopoDS_Shape:
    """Three steps, chamfered at both ends, and a keyway with round ends in the middle one."""
    first, second, third = lot.size(8, 11), lot.size(14, 17), lot.size(10, 13)
    one, two = lot.size(20, 30, 5), lot.size(40, 60, 5)
    three, slant = lot.size(25, 40, 5), lot.one_of(1, 1.5, 2)
    end = one + two + three
    profile = [
        (0, 0), (0, first - slant), (slant, first), (one, first), (one, second),
        (one + two, second), (one + two, third), (end - slant, third), (end, third - slant),
        (end, 0),
    ]  # fmt: skip
    width, depth, length = lot.size(5, 8), lot.size(3, 4, 0.5), lot.size(18, 26, 2)
    key = milled_slot(
        Axis.Z, (one + two / 2, 0), (length - width) / 2, width / 2, start=second - depth
    )
    return cut(revolved(profile, Axis.X, (0, 0)), key)


def hex_bolt(lot: Lot) -> TopoDS_Shape:
    """A hexagonal head, chamfered or not, on a shank without a thread."""
    across, head = lot.size(18, 30, 2), lot.size(8, 12)
    radius, length = lot.size(6, 8), lot.size(30, 50, 5)
    part = prism(Axis.Z, hexagon(across, lot.chance()), 0, head)
    if lot.chance():
        # Beyond a cone of 45 degrees that touches the flats.
        inner, outer = across / 2, 0.6 * across * 1.05
        beyond = [(0, inner), (0, outer), (outer - inner, outer)]
        part = cut(part, revolved(beyond, Axis.Z, (0, 0)))
    part = fuse(part, cylinder(Axis.Z, (0, 0), radius, head - 1, head + length))
    return chamfered(part, edges_at(part, Axis.Z, head + length), 1.5)


def hex_nut(lot: Lot) -> TopoDS_Shape:
    """A hexagonal nut without a thread, its hole chamfered; some have a washer."""
    across, thickness, bore = lot.size(24, 36, 2), lot.size(10, 16), lot.size(6, 9)
    part = prism(Axis.Z, hexagon(across, lot.chance()), 0, thickness)
    part = cut(part, hole(Axis.Z, (0, 0), bore))
    part = chamfered(part, rims(part, Axis.Z, ((0, 0), bore), thickness), 1)
    if lot.chance():
        washer = cylinder(Axis.Z, (0, 0), across / 2 + 4, -3, 0)
        part = fuse(part, cut(washer, hole(Axis.Z, (0, 0), 6)))
    return part


def pulley(lot: Lot) -> TopoDS_Shape:
    """A disc with a groove for a belt and a hub with a keyway, or a hole for a set screw."""
    radius, width, groove = lot.size(35, 50, 5), lot.size(18, 26, 2), lot.size(8, 12)
    hub_length, bore = lot.size(6, 12, 2), lot.size(6, 9)
    hub, floor = bore + lot.size(6, 9), lot.size(2, 4)
    middle = width / 2
    wide = floor + groove / 2
    profile = [
        (0, bore), (0, radius), (middle - wide, radius), (middle - floor, radius - groove),
        (middle + floor, radius - groove), (middle + wide, radius), (width, radius), (width, hub),
        (width + hub_length, hub), (width + hub_length, bore),
    ]  # fmt: skip
    part = revolved(profile, Axis.X, (0, 0))
    if lot.chance():
        return cut(part, hole(Axis.Z, (width + hub_length / 2, 0), 2, 0))
    return cut(part, box((-1, -2.5, 0), (FAR, 2.5, bore + 3)))


def set_collar(lot: Lot) -> TopoDS_Shape:
    """A chamfered ring about any axis with a hole for a screw; some are slit."""
    radius, bore, width = lot.size(22, 32, 2), lot.size(10, 15), lot.size(14, 20, 2)
    axis = Axis(int(lot.one_of(0, 1, 2)))
    screw, slit = lot.size(2, 4), lot.chance()
    profile = [
        (0, bore), (0, radius - 1.5), (1.5, radius), (width - 1.5, radius), (width, radius - 1.5),
        (width, bore),
    ]  # fmt: skip
    part = revolved(profile, axis, (0, 0))
    # The screw comes from the end of the last other axis; the slit is on its far side.
    across = Axis.Y if axis is Axis.Z else Axis.Z
    along = (width / 2, 0) if axis.value < 3 - axis.value - across.value else (0, width / 2)
    part = cut(part, hole(across, along, screw, 0))
    if slit:
        low, high = [-FAR] * 3, [FAR] * 3
        high[across.value] = 0
        third = 3 - axis.value - across.value
        low[third], high[third] = -1.5, 1.5
        part = cut(part, box((low[0], low[1], low[2]), (high[0], high[1], high[2])))
    return part


def spoked_wheel(lot: Lot) -> TopoDS_Shape:
    """A rim and a hub with four flat spokes between them."""
    radius, width, rim = lot.size(40, 55, 5), lot.size(12, 18, 2), lot.size(8, 10)
    hub, bore, more = lot.size(14, 18), lot.size(7, 9), lot.size(4, 8, 2)
    spoke, thickness = lot.size(8, 12, 2), lot.size(5, 8)
    ring = cut(cylinder(Axis.Z, (0, 0), radius, 0, width), hole(Axis.Z, (0, 0), radius - rim))
    reach, half, low = radius - rim / 2, spoke / 2, (width - thickness) / 2
    part = fuse(
        ring,
        cylinder(Axis.Z, (0, 0), hub, -more / 2, width + more / 2),
        box((-reach, -half, low), (reach, half, low + thickness)),
        box((-half, -reach, low), (half, reach, low + thickness)),
    )
    return cut(part, hole(Axis.Z, (0, 0), bore))


def knob(lot: Lot) -> TopoDS_Shape:
    """A turning knob with a rounded rim and hollows for fingers, on a bored foot."""
    radius, height = lot.size(20, 28, 2), lot.size(12, 18, 2)
    foot, foot_height = lot.size(9, 12), lot.size(10, 16, 2)
    bore, rounding, hollows = lot.size(4, 6), lot.size(3, 5), int(lot.one_of(0, 4, 6))
    top = foot_height + height
    part = fuse(
        cylinder(Axis.Z, (0, 0), foot, 0, foot_height),
        cylinder(Axis.Z, (0, 0), radius, foot_height, top),
    )
    part = filleted(part, edges_at(part, Axis.Z, top), rounding)
    part = cut(part, hole(Axis.Z, (0, 0), bore, -1, foot_height + 4))
    around = ring_of_points(hollows, 1.1 * radius) if hollows else ()
    for centre in around:
        part = cut(part, hole(Axis.Z, centre, 0.3 * radius))
    return part


def flat_spacer(lot: Lot) -> TopoDS_Shape:
    """A bored cylinder with two flats for a wrench; some are bored wider, or have a pin."""
    radius, length, flat = lot.size(16, 24, 2), lot.size(30, 50, 5), lot.size(10, 14, 2)
    bore, half = lot.size(6, 8), radius - lot.size(2, 4)
    part = cylinder(Axis.X, (0, 0), radius, 0, length)
    part = cut(part, hole(Axis.X, (0, 0), bore))
    for low, high in ((half, FAR), (-FAR, -half)):
        part = cut(part, box((8, -FAR, low), (8 + flat, FAR, high)))
    if lot.chance():
        part = cut(part, hole(Axis.X, (0, 0), bore + 3, length - 8))
    return cut(part, hole(Axis.Y, (length - 12, 0), 2.5)) if lot.chance() else part


def tee_fitting(lot: Lot) -> TopoDS_Shape:
    """Two pipes that meet at a right angle, the one not wider than the other."""
    outer, inner = lot.size(14, 18), lot.size(8, 11)
    length, height = lot.size(60, 80, 5), lot.size(30, 40, 5)
    branch = lot.size(10, outer - 1)
    part = fuse(
        cylinder(Axis.X, (0, 0), outer, 0, length),
        cylinder(Axis.Z, (length / 2, 0), branch, 0, height),
    )
    way = min(branch - 4, inner - 1)
    return cut(part, hole(Axis.X, (0, 0), inner), hole(Axis.Z, (length / 2, 0), way, 0))


TURNED = families(
    "turned",
    flange,
    stepped_shaft,
    hex_bolt,
    hex_nut,
    pulley,
    set_collar,
    spoked_wheel,
    knob,
    flat_spacer,
    tee_fitting,
)
