"""What a comparison comes to."""

import unittest

from freecad.gaussiancad.engine.comparison_verdict import comparison_verdict


def _values(shared: object, ratio: float = 1.0) -> dict:
    return {
        "volume_iou": shared,
        "result": {"volume_mm3": 1000.0 * ratio**3, "extent_mm": [80.0 * ratio, 5.0, 5.0]},
        "reference": {"volume_mm3": 1000.0, "extent_mm": [80.0, 5.0, 5.0]},
    }


class Verdict(unittest.TestCase):
    def test_the_same_part(self) -> None:
        self.assertIn("The same part", comparison_verdict(_values(0.9999)))
        self.assertIn("The same part", comparison_verdict(_values(0.9999, 1.001)))

    def test_another_size_says_what_to_set(self) -> None:
        large = comparison_verdict(_values(0.999, 1.25))
        self.assertIn("1.25 times too large", large)
        self.assertIn("80 mm", large)
        small = comparison_verdict(_values(0.999, 1.0 / 25.4))
        self.assertIn("25.4 times too small", small)
        self.assertIn("80 mm", small)

    def test_another_shape_is_no_question_of_size(self) -> None:
        stated = comparison_verdict(_values(0.8, 1.25))
        self.assertIn("80.0 %", stated)
        self.assertNotIn("mm", stated)

    def test_models_without_a_volume_have_no_verdict(self) -> None:
        for values in ({}, _values(None), {**_values(1.0), "reference": None}):
            self.assertEqual(comparison_verdict(values), "Finished")
