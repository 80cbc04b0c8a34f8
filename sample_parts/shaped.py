"""Parts with slanted, rounded and revolved surfaces."""

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import (
    box,
    chamfered,
    cone,
    cut,
    cylinder,
    edges_along,
    edges_where,
    filleted,
    fuse,
    leaning_cylinder,
    prism,
    revolved,
    sphere,
)
from sample_parts.part import SamplePart


def _wedge_block() -> TopoDS_Shape:
    wedge = prism(Axis.Y, [(0, 0), (90, 0), (90, 14), (40, 48), (0, 48)], 0, 44)
    return cut(wedge, box((10, 14, 20), (30, 30, 49)))


def _dovetail_block() -> TopoDS_Shape:
    outline = [
        (0, 0),
        (80, 0),
        (80, 40),
        (54, 40),
        (62, 20),
        (18, 20),
        (26, 40),
        (0, 40),
    ]
    return prism(Axis.Y, outline, 0, 50)


def _vee_block() -> TopoDS_Shape:
    outline = [(0, 0), (70, 0), (70, 45), (60, 45), (35, 20), (10, 45), (0, 45)]
    return cut(prism(Axis.Y, outline, 0, 60), box((32, -1, 10), (38, 61, 24)))


def _filleted_block() -> TopoDS_Shape:
    block = box((0, 0, 0), (80, 60, 30))
    rounded = filleted(block, edges_along(block, Axis.Z, [(0, 0), (80, 0), (80, 60), (0, 60)]), 12)
    return cut(rounded, cylinder(Axis.Z, (40, 30), 15, -1, 31))


def _stepped_shaft() -> TopoDS_Shape:
    profile = [
        (0, 0), (0, 12), (25, 12), (25, 20), (60, 20), (60, 15), (95, 15), (95, 9), (120, 9),
        (120, 0),
    ]  # fmt: skip
    return revolved(profile, Axis.X, (20, 20))


def _pulley() -> TopoDS_Shape:
    profile = [
        (0, 8), (0, 16), (6, 16), (6, 38), (12, 38), (18, 28), (24, 28), (30, 38), (36, 38),
        (36, 16), (42, 16), (42, 8),
    ]  # fmt: skip
    return revolved(profile, Axis.Y, (38, 38))


def _cross_bored_pin() -> TopoDS_Shape:
    pin = cylinder(Axis.X, (22, 22), 22, 0, 90)
    return cut(pin, cylinder(Axis.Z, (30, 22), 12, -1, 45), cylinder(Axis.Y, (66, 22), 8, -1, 45))


def _angled_bore_block() -> TopoDS_Shape:
    block = box((0, 0, 0), (80, 50, 45))
    return cut(block, leaning_cylinder((40, 25, 22), (3, 0, 4), 9, 80))


def _countersunk_plate() -> TopoDS_Shape:
    plate = box((0, 0, 0), (90, 50, 16))
    tools = []
    for x in (24, 66):
        tools += [cylinder(Axis.Z, (x, 25), 6, -1, 17), cone(Axis.Z, (x, 25), (6, 13), 9, 16)]
    return cut(plate, *tools)


def _ball_knob() -> TopoDS_Shape:
    shank = cylinder(Axis.Z, (24, 24), 10, 0, 50)
    knob = fuse(shank, sphere((24, 24, 56), 24))
    return cut(knob, cylinder(Axis.Z, (24, 24), 5, -1, 30))


def _rounded_cover() -> TopoDS_Shape:
    block = box((0, 0, 0), (80, 56, 26))
    edges = edges_along(block, Axis.Z, [(0, 0), (80, 0), (80, 56), (0, 56)])
    rounded = filleted(block, edges, 14)
    dome = filleted(rounded, edges_where(rounded, lambda one, other: one[2] == other[2] == 26), 6)
    return cut(dome, cylinder(Axis.Z, (40, 28), 12, -1, 27))


def _rib_bracket() -> TopoDS_Shape:
    base = box((0, 0, 0), (80, 50, 10))
    wall = box((0, 0, 0), (12, 50, 60))
    rib = prism(Axis.Y, [(10, 9), (62, 9), (62, 10), (12, 50), (10, 50)], 20, 30)
    body = fuse(base, wall, rib)
    return cut(
        body,
        cylinder(Axis.Z, (68, 12), 5, -1, 11),
        cylinder(Axis.Z, (68, 38), 5, -1, 11),
    )


def _chamfered_block() -> TopoDS_Shape:
    block = box((0, 0, 0), (70, 50, 36))
    beveled = chamfered(block, edges_along(block, Axis.Y, [(0, 36), (70, 36)]), 10)
    return cut(beveled, cylinder(Axis.Y, (35, 16), 9, -1, 51))


SHAPED = (
    SamplePart("wedge-block", "slanted top with a pocket", _wedge_block),
    SamplePart("dovetail-block", "dovetail groove with slanted, hidden flanks", _dovetail_block),
    SamplePart("vee-block", "V groove with a relief slot", _vee_block),
    SamplePart("filleted-block", "rounded vertical edges and a bore", _filleted_block),
    SamplePart("stepped-shaft", "shaft of four diameters", _stepped_shaft),
    SamplePart("pulley", "revolved wheel with conical flanks and a bore", _pulley),
    SamplePart("cross-bored-pin", "cylinder crossed by two bores", _cross_bored_pin),
    SamplePart("angled-bore-block", "bore that leans: its rims are ellipses", _angled_bore_block),
    SamplePart("countersunk-plate", "plate with two conical countersinks", _countersunk_plate),
    SamplePart("ball-knob", "ball on a bored shank", _ball_knob),
    SamplePart("rounded-cover", "rounded edges all around the top and a bore", _rounded_cover),
    SamplePart("rib-bracket", "angle stiffened by a slanted rib", _rib_bracket),
    SamplePart("chamfered-block", "two chamfers and a cross hole", _chamfered_block),
)
