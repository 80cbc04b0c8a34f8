"""Plates, blocks and brackets made of planes and holes along the axes."""

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.model.axes import Axis
from sample_parts.modelling import box, cut, cylinder, fuse, prism, slot
from sample_parts.part import SamplePart


def _l_bracket() -> TopoDS_Shape:
    angle = prism(Axis.Y, [(0, 0), (80, 0), (80, 12), (14, 12), (14, 60), (0, 60)], 0, 50)
    return cut(
        angle,
        cylinder(Axis.Z, (52, 25), 10, -1, 13),
        cylinder(Axis.X, (25, 40), 7, -1, 15),
    )


def _bored_plate() -> TopoDS_Shape:
    plate = box((0, 0, 0), (100, 70, 15))
    corners = [(12, 12), (88, 12), (88, 58), (12, 58)]
    holes = [cylinder(Axis.Z, corner, 5, -1, 16) for corner in corners]
    return cut(plate, *holes, cylinder(Axis.Z, (50, 35), 18, -1, 16))


def _stepped_block() -> TopoDS_Shape:
    stair = prism(
        Axis.Y,
        [(0, 0), (90, 0), (90, 15), (60, 15), (60, 32), (30, 32), (30, 50), (0, 50)],
        0,
        40,
    )
    return cut(stair, box((60, 12, -1), (91, 28, 16)))


def _pocket_block() -> TopoDS_Shape:
    return cut(box((0, 0, 0), (70, 50, 30)), box((15, 10, 12), (50, 40, 31)))


def _three_axis_block() -> TopoDS_Shape:
    block = box((0, 0, 0), (60, 50, 40))
    return cut(
        block,
        cylinder(Axis.X, (14, 10), 5, -1, 61),
        cylinder(Axis.Y, (44, 28), 7, -1, 51),
        cylinder(Axis.Z, (18, 34), 8, -1, 41),
    )


def _u_bracket() -> TopoDS_Shape:
    channel = prism(
        Axis.Y,
        [(0, 0), (72, 0), (72, 55), (58, 55), (58, 12), (14, 12), (14, 55), (0, 55)],
        0,
        40,
    )
    return cut(
        channel,
        cylinder(Axis.X, (20, 38), 8, -1, 73),
        cylinder(Axis.Z, (36, 20), 6, -1, 13),
    )


def _t_slot_block() -> TopoDS_Shape:
    outline = [
        (0, 0), (80, 0), (80, 45), (48, 45), (48, 30), (58, 30),
        (58, 16), (22, 16), (22, 30), (32, 30), (32, 45), (0, 45),
    ]  # fmt: skip
    return prism(Axis.Y, outline, 0, 60)


def _counterbored_block() -> TopoDS_Shape:
    block = box((0, 0, 0), (80, 44, 28))
    tools = [cylinder(Axis.Z, (x, 22), 6, -1, 29) for x in (20, 60)]
    tools += [cylinder(Axis.Z, (x, 22), 11, 18, 29) for x in (20, 60)]
    return cut(block, *tools)


def _slotted_link() -> TopoDS_Shape:
    bar = slot(Axis.Z, ((20, 20), (100, 20)), 20, 0, 14)
    return cut(
        bar,
        cylinder(Axis.Z, (20, 20), 9, -1, 15),
        slot(Axis.Z, ((62, 20), (100, 20)), 8, -1, 15),
    )


def _boss_plate() -> TopoDS_Shape:
    plate = box((0, 0, 0), (80, 60, 12))
    boss = cylinder(Axis.Z, (34, 30), 18, 11, 40)
    body = fuse(plate, boss)
    return cut(
        body,
        cylinder(Axis.Z, (34, 30), 9, -1, 41),
        cylinder(Axis.Z, (68, 12), 5, -1, 13),
        cylinder(Axis.Z, (68, 48), 5, -1, 13),
    )


PLATES = (
    SamplePart("l-bracket", "angle with a hole in each leg", _l_bracket),
    SamplePart("bored-plate", "plate with four holes and a bore", _bored_plate),
    SamplePart("stepped-block", "three steps and a notch in the lowest", _stepped_block),
    SamplePart("pocket-block", "block with a blind rectangular pocket", _pocket_block),
    SamplePart(
        "three-axis-block",
        "holes along all three axes that do not meet",
        _three_axis_block,
    ),
    SamplePart("u-bracket", "channel with a cross hole through both cheeks", _u_bracket),
    SamplePart("t-slot-block", "undercut slot, seen whole in one view only", _t_slot_block),
    SamplePart("counterbored-block", "two counterbored holes", _counterbored_block),
    SamplePart("slotted-link", "round-ended bar with a hole and a slot", _slotted_link),
    SamplePart("boss-plate", "plate with a bored boss and two holes", _boss_plate),
)
