"""Where the views of a sheet stand in space."""

import unittest

from fake_part import BOXES, MM_PER_PIXEL, SIZE

from freecad.gaussiancad.engine.report import ViewReport
from freecad.gaussiancad.objects.placing import GAP_SHARE, PlanePlacement, place_view

VIEWS = tuple(ViewReport(role, box, {}) for role, box in BOXES.items())


def corner(plane: PlanePlacement, right: float, up: float) -> tuple[float, ...]:
    """A corner of the plane; -1 and 1 are its edges."""
    return tuple(
        plane.centre[i]
        + right * plane.width / 2 * plane.right[i]
        + up * plane.height / 2 * plane.up[i]
        for i in range(3)
    )


class Planes(unittest.TestCase):
    def test_a_views_own_box_covers_the_parts_own_extent(self) -> None:
        gap = GAP_SHARE * 60.0
        expected = {
            "front": ((0, 40 + gap, 0), (60, 40 + gap, 30)),
            "top": ((0, 0, -gap), (60, 40, -gap)),
            "right": ((-gap, 0, 0), (-gap, 40, 30)),
            "left": ((60 + gap, 40, 0), (60 + gap, 0, 30)),
            "bottom": ((0, 40, 30 + gap), (60, 0, 30 + gap)),
            "rear": ((60, -gap, 0), (0, -gap, 30)),
        }
        like = {"left": "right", "bottom": "top", "rear": "front"}
        for role, (low, high) in expected.items():
            view = ViewReport(role, BOXES[like.get(role, role)], {})
            plane = place_view(view, view.box, SIZE, MM_PER_PIXEL)
            self.assertEqual(corner(plane, -1, -1), low, role)
            self.assertEqual(corner(plane, 1, 1), high, role)

    def test_paper_around_a_view_does_not_move_it(self) -> None:
        view = VIEWS[0]
        x0, y0, x1, y1 = view.box
        plane = place_view(view, (x0 - 10, y0 - 20, x1 + 30, y1 + 4), SIZE, MM_PER_PIXEL)
        self.assertEqual(corner(plane, -1, -1)[::2], (-2.5, -1.0))
        self.assertEqual(corner(plane, 1, 1)[::2], (67.5, 35.0))

    def test_views_without_a_box_or_a_known_role_have_no_place(self) -> None:
        box = BOXES["front"]
        self.assertIsNone(place_view(ViewReport("front", None, {}), box, SIZE, 1.0))
        self.assertIsNone(place_view(ViewReport("isometric", box, {}), box, SIZE, 1.0))
