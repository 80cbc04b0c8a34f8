"""Sketches and far ends follow what they stand on when a number is another."""

from math import pi
from typing import Any

import FreeCAD
import Part
from body_cases import XY, XZ, ChangedCase, box_of, cylinder, hole, lines, number, pad, prism
from FreeCAD import Vector

TOP = {**XY, "offset": 20.0}
ON_TOP = {"feature": "Pad1", "side": "end"}
ON_BOTTOM = {"feature": "Pad1", "side": "start"}
MEASURED = {"length": "measured"}


def pocket(plane: dict[str, Any], geometry: list, length: float, **more: object) -> dict[str, Any]:
    return {**pad(plane, geometry, length, **more), "kind": "pocket", "name": "Pocket1"}


def square(x: float, y: float, size: float) -> list[dict[str, Any]]:
    return lines((x, y), (x + size, y), (x + size, y + size), (x, y + size))


class OnPads(ChangedCase):
    def test_a_blind_hole_begins_at_the_face_of_a_longer_pad(self) -> None:
        exact = Part.makeBox(40, 30, 20).cut(cylinder(3, 8, (10, 10, 12)))
        drilled = hole(TOP, (10, 10), depth=8.0, stands_on=ON_TOP, sources={"depth": "sheet"})
        made = self.made(exact, *box_of(40, 30, 20), drilled)
        self.assert_is(made, exact)
        self.assertEqual(made.from_sheet, ("Hole1.Depth = 8 mm",))
        for length in (24.0, 16.0, 20.0):
            self.change("Pad1", "Length", length)
            self.assertAlmostEqual(self.offset("Hole1Sketch"), length, places=9)
            self.assert_volume(made, 40 * 30 * length - 9 * pi * 8)
        self.assert_is(made, exact)

    def test_a_boss_and_what_is_in_it_rise_with_the_plate(self) -> None:
        exact = Part.makeBox(40, 30, 20).fuse(Part.makeBox(10, 10, 15, Vector(5, 5, 20)))
        exact = exact.removeSplitter().cut(cylinder(3, 8, (10, 10, 27)))
        boss = pad(TOP, square(5, 5, 10), 15.0, stands_on=ON_TOP)
        drilled = hole(
            {**XY, "offset": 35.0},
            (10, 10),
            depth=8.0,
            stands_on={"feature": "Pad2", "side": "end"},
        )
        made = self.made(exact, *box_of(40, 30, 20), {**boss, "name": "Pad2"}, drilled)
        self.change("Pad1", "Length", 16.0)
        self.assert_volume(made, 40 * 30 * 16 + 1500 - 9 * pi * 8)
        self.change("Pad2", "Length", 18.0)
        self.assertAlmostEqual(self.offset("Hole1Sketch"), 34.0, places=9)
        self.assert_volume(made, 40 * 30 * 16 + 1800 - 9 * pi * 8)
        sketch = self.document.getObject("Pad1Sketch")
        sketch.AttachmentOffset = FreeCAD.Placement(Vector(0, 0, 5), FreeCAD.Rotation())
        self.document.recompute()
        self.assert_volume(made, 40 * 30 * 16 + 1800 - 9 * pi * 8)
        self.assertAlmostEqual(made.body.Shape.BoundBox.ZMin, 5.0, places=6)

    def test_pads_against_the_normal_and_what_stands_on_their_start(self) -> None:
        block = Part.makeBox(40, 20, 30)
        along = (0, 1, 0)
        exact = block.cut(cylinder(3, 8, (10, 12, 10), along)).cut(
            cylinder(3, 8, (30, 0, 10), along)
        )
        first = pad(XZ, lines((0, 0), (40, 0), (40, 30), (0, 30)), -20.0)
        far = {**XZ, "offset": -20.0}
        behind = hole(far, (10, 10), depth=8.0, downward=False, stands_on=ON_TOP)
        before = hole(XZ, (30, 10), depth=8.0, stands_on=ON_BOTTOM, name="Hole2")
        made = self.made(exact, first, behind, before)
        self.assert_is(made, exact)
        self.change("Pad1", "Length", 24.0)
        self.assertAlmostEqual(self.offset("Hole1Sketch"), -24.0, places=9)
        self.assert_volume(made, 40 * 30 * 24 - 2 * 9 * pi * 8)

    def test_oblique_planes(self) -> None:
        turn = FreeCAD.Rotation(Vector(0, 1, 0), 36.87)
        right, up, normal = (
            list(turn.multVec(Vector(*axis))) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        )
        plane = {"name": None, "right": right, "up": up, "normal": normal, "offset": 7.0}
        exact = Part.makeBox(40, 30, 20, Vector(0, 0, 7)).cut(cylinder(3, 8, (10, 10, 19)))
        exact = exact.transformed(FreeCAD.Placement(Vector(), turn).toMatrix(), True)
        outline = lines((0, 0), (40, 0), (40, 30), (0, 30))
        drilled = hole({**plane, "offset": 27.0}, (10, 10), depth=8.0, stands_on=ON_TOP)
        made = self.made(exact, pad(plane, outline, 20.0), drilled)
        self.assert_is(made, exact)
        self.change("Pad1", "Length", 24.0)
        self.assert_volume(made, 40 * 30 * 24 - 9 * pi * 8)

    def test_names_of_a_second_body_are_its_own(self) -> None:
        exact = Part.makeBox(40, 30, 20).cut(cylinder(3, 8, (10, 10, 12)))
        drilled = hole(TOP, (10, 10), depth=8.0, stands_on=ON_TOP)
        features = (*box_of(40, 30, 20), drilled)
        first, second = self.made(exact, *features), self.made(exact, *features)
        group = second.body.Group
        longer = next(each for each in group if each.TypeId == "PartDesign::Pad")
        self.assertNotEqual(longer.Name, "Pad1")
        self.change(longer.Name, "Length", 24.0)
        self.assert_volume(second, 40 * 30 * 24 - 9 * pi * 8)
        self.assert_is(first, exact)


class FarEnds(ChangedCase):
    def test_a_through_pocket_stays_through_and_has_no_length_of_its_own(self) -> None:
        exact = Part.makeBox(40, 30, 20).cut(Part.makeBox(6, 6, 20, Vector(5, 5, 0)))
        for start, length, at, ends in (
            (0.0, 20.0, ON_BOTTOM, ON_TOP),
            (20.0, -20.0, ON_TOP, ON_BOTTOM),
            (0.0, 20.0, None, ON_TOP),
        ):
            with self.subTest(start=start, at=at):
                cut = pocket(
                    {**XY, "offset": start},
                    square(5, 5, 6),
                    length,
                    sources=MEASURED,
                    stands_on=at,
                    ends_at=ends,
                )
                sides = pad(XY, lines((0, 0), (40, 0), (40, 30), (0, 30)), 20.0, sources=MEASURED)
                made = self.made(exact, sides, cut)
                self.assert_is(made, exact)
                self.assertEqual(made.measured, ("Pad1.Length = 20 mm",))
                self.change("Pad1", "Length", 24.0)
                self.assert_volume(made, (40 * 30 - 36) * 24)
                self.close()
                self.document = FreeCAD.newDocument("Bodies")

    def test_a_hole_that_ends_in_a_pocket(self) -> None:
        exact = Part.makeBox(40, 30, 20).cut(Part.makeBox(12, 12, 6, Vector(4, 4, 0)))
        exact = exact.cut(cylinder(3, 14, (10, 10, 6)))
        sources = {"depth": "measured"}
        hollow = pocket(XY, square(4, 4, 12), 6.0, stands_on=ON_BOTTOM, sources=MEASURED)
        ends = {"feature": "Pocket1", "side": "end"}
        drilled = hole(TOP, (10, 10), depth=14.0, sources=sources, stands_on=ON_TOP, ends_at=ends)
        made = self.made(exact, *box_of(40, 30, 20), hollow, drilled)
        self.assert_is(made, exact)
        self.assertEqual(made.measured, ("Pocket1.Length = 6 mm",))
        self.change("Pad1", "Length", 24.0)
        self.change("Pocket1", "Length", 8.0)
        self.assert_volume(made, 40 * 30 * 24 - 144 * 8 - 9 * pi * 16)


class OnWalls(ChangedCase):
    def profile(self, *without: str) -> dict[str, Any]:
        """An angle of 60 x 30, 10 and 15 thick, whose walls are told by numbers."""
        geometry = lines((0, 0), (60, 0), (60, 10), (15, 10), (15, 30), (0, 30))
        conditions = [
            *({"kind": "coincident", "of": [[n, "end"], [(n + 1) % 6, "start"]]} for n in range(6)),
            *({"kind": "horizontal", "of": [[n, None]]} for n in (0, 2, 4)),
            *({"kind": "vertical", "of": [[n, None]]} for n in (1, 3, 5)),
            {"kind": "coincident", "of": [[-1, "start"], [0, "start"]]},
            number("distance-x", [[0, "start"], [0, "end"]], 60.0, "Width"),
            number("distance-y", [[0, "start"], [2, "start"]], 10.0, "Base"),
            number("distance-x", [[0, "start"], [3, "start"]], 15.0, "Wall"),
            number("distance-y", [[2, "start"], [4, "start"]], 20.0, "Above"),
        ]
        kept = [each for each in conditions if each.get("name") not in without]
        return pad(XZ, geometry, -40.0, constraints=kept)

    def exact(self) -> Part.Shape:
        angle = prism(
            [(0, 0, 0), (60, 0, 0), (60, 0, 10), (15, 0, 10), (15, 0, 30), (0, 0, 30)], (0, 40, 0)
        )
        return angle.cut(cylinder(3, 6, (40, 20, 4))).cut(cylinder(3, 12, (8, 20, 18)))

    def holes(self) -> list[dict[str, Any]]:
        on_base = {"feature": "Pad1", "side": "wall", "edge": 2, "dimensions": {"Base": 1}}
        on_wall = {**on_base, "edge": 4, "dimensions": {"Base": 1, "Above": 1}}
        base = {**XY, "offset": 10.0}
        return [
            hole(base, (40, 20), depth=6.0, stands_on=on_base),
            hole({**XY, "offset": 30.0}, (8, 20), depth=12.0, stands_on=on_wall, name="Hole2"),
        ]

    def test_holes_go_with_the_walls_that_numbers_move(self) -> None:
        made = self.made(self.exact(), self.profile(), *self.holes())
        self.assert_is(made, self.exact())
        drilled = 9 * pi * 18
        self.change("Pad1", "Base", 14.0)
        self.assert_volume(made, (60 * 14 + 15 * 20) * 40 - drilled)
        self.change("Pad1", "Above", 25.0)
        self.assert_volume(made, (60 * 14 + 15 * 25) * 40 - drilled)
        self.assertAlmostEqual(self.offset("Hole2Sketch"), 39.0, places=6)

    def test_a_wall_that_no_number_tells_leaves_the_offset(self) -> None:
        made = self.made(self.exact(), self.profile("Base"), *self.holes())
        for name in ("Hole1Sketch", "Hole2Sketch"):
            self.assertEqual(self.document.getObject(name).ExpressionEngine, [])
        self.assert_is(made, self.exact())
        first, _ = self.holes()
        first["stands_on"]["dimensions"] = None
        self.assertEqual(self.offset("Hole1Sketch"), 10.0)
        alone = self.made(
            self.exact().fuse(cylinder(3, 12, (8, 20, 18))).removeSplitter(), self.profile(), first
        )
        self.assertEqual(alone.body.Tip.Profile[0].ExpressionEngine, [])
