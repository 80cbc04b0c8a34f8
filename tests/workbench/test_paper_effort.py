"""What the paper's cameras cost, before they are chosen."""

import unittest

from freecad.gaussiancad.engine.paper_effort import (
    LARGEST_SCALE_DOWN,
    paper_effort,
    usual_scale_down,
)
from freecad.gaussiancad.engine.protocol import Preset


class Effort(unittest.TestCase):
    def test_the_size_in_the_paper_takes_more_than_an_hour(self) -> None:
        effort = paper_effort(Preset.STANDARD, 1)
        self.assertEqual((effort.width, effort.height), (1920, 1080))
        self.assertGreater(effort.minutes, 60.0)

    def test_what_is_offered_takes_minutes_and_has_images_to_look_at(self) -> None:
        for preset in Preset:
            effort = paper_effort(preset, usual_scale_down(preset))
            self.assertLess(effort.minutes, 10.0)
            self.assertGreaterEqual(effort.width, 240)

    def test_smaller_images_take_less_time(self) -> None:
        for preset in Preset:
            minutes = [
                paper_effort(preset, factor).minutes for factor in range(1, LARGEST_SCALE_DOWN + 1)
            ]
            self.assertEqual(minutes, sorted(minutes, reverse=True))
            self.assertEqual(len(set(minutes)), len(minutes))
