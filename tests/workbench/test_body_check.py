"""Whether two solids are one, whatever seams they have."""

import Part
from FreeCAD import Vector
from support import FolderCase

from freecad.gaussiancad.objects.body_check import _difference
from freecad.gaussiancad.objects.smooth_faces import count_faces, have_same_faces


class Faces(FolderCase):
    def test_halves_of_one_surface_count_once(self) -> None:
        for shape, count in (
            (Part.makeCone(5, 2, 8), 3),
            (Part.makeCylinder(5, 8), 3),
            (Part.makeSphere(5), 1),
            (Part.makeTorus(9, 2), 1),
            (Part.makeBox(2, 3, 4, Vector(-1, -1, -1)), 6),
        ):
            halved = [shape.common(Part.makeBox(40, 40, 40, Vector(-20, y, -20))) for y in (-40, 0)]
            both = halved[0].fuse(halved[1])
            self.assertGreater(len(both.Faces), count)
            self.assertEqual(count_faces(shape), count)
            self.assertEqual(count_faces(both), count)
            self.assertTrue(have_same_faces(both, shape))
            moved = shape.copy()
            moved.translate(Vector(0, 0, 0.01))
            self.assertFalse(have_same_faces(both, moved))


class Check(FolderCase):
    def test_solids_that_cannot_be_cut_are_one_where_all_faces_are(self) -> None:
        class Uncut:
            """A solid that the kernel makes nothing of."""

            def __init__(self, shape: Part.Shape) -> None:
                self.Volume, self.Faces = shape.Volume, shape.Faces

            def cut(self, other: object) -> Part.Shape:
                return other

        box, other = Part.makeBox(2, 3, 4), Part.makeBox(2, 4, 3)
        self.assertEqual(_difference(Uncut(box), Uncut(box)), 0.0)
        self.assertGreater(_difference(Uncut(box), Uncut(other)), 0.0)
        self.assertAlmostEqual(_difference(box, other), 12.0)
