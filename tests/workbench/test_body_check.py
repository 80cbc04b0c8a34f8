"""Whether two solids are one, whatever seams they have."""

import Part
from FreeCAD import Vector
from support import FolderCase

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
