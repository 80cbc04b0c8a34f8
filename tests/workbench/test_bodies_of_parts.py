"""Whether a part or its body is seen, when the part changes."""

import FreeCAD
import Part
from body_cases import DATA, BodyCase, bracket

from freecad.gaussiancad.objects.bodies import add_bodies
from freecad.gaussiancad.objects.bodies_of_parts import bodies_of, is_seen_as_body, set_shape
from freecad.gaussiancad.objects.feature_file import read_features


def chamfered() -> Part.Shape:
    shape = bracket()
    return shape.makeChamfer(1.0, shape.Edges[:1])


class BodiesOfParts(BodyCase):
    def setUp(self) -> None:
        super().setUp()
        self.whole = self.part(bracket())
        self.add()

    def add(self) -> None:
        add_bodies(self.whole, read_features(DATA / "bracket.json"))

    def test_the_same_shape_leaves_the_body_in_place_of_its_part(self) -> None:
        set_shape(self.whole, bracket())
        self.assertTrue(is_seen_as_body(self.whole))
        self.assertFalse(self.whole.Visibility)

    def test_another_shape_is_shown_in_place_of_the_body(self) -> None:
        other = bracket()
        other.translate(FreeCAD.Vector(0, 0, 5))
        for shape in (other, chamfered()):
            self.add()
            set_shape(self.whole, shape)
            (*_, body) = bodies_of(self.whole)
            self.assertEqual((body.Visibility, self.whole.Visibility), (False, True))
            set_shape(self.whole, bracket())

    def test_a_part_that_somebody_hid_stays_hidden(self) -> None:
        (body,) = bodies_of(self.whole)
        body.Visibility = False
        set_shape(self.whole, chamfered())
        self.assertFalse(self.whole.Visibility)

    def test_a_body_that_is_made_again_stands_in_place_of_the_one_before(self) -> None:
        self.add()
        first, second = bodies_of(self.whole)
        self.assertEqual((first.Visibility, second.Visibility), (False, True))
