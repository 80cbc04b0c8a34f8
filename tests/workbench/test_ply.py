"""PLY files in plain Python."""

import struct

from fake_part import SIZE, deviation_bytes, gaussians_bytes
from support import FolderCase

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.gaussians import read_gaussians
from freecad.gaussiancad.objects.ply import read_vertices


class Files(FolderCase):
    def write(self, data: bytes) -> None:
        (self.folder / "a.ply").write_bytes(data)

    def test_mixed_types_and_comments(self) -> None:
        self.write(deviation_bytes())
        vertices = read_vertices(self.folder / "a.ply")
        self.assertEqual(vertices.names, ("x", "y", "z", "red", "green", "blue", "deviation"))
        self.assertEqual(len(vertices.rows), 12)
        self.assertEqual(vertices.comments, ("unit mm", "signed 1", "range 1"))
        for x, deviation in vertices.columns("x", "deviation"):
            self.assertAlmostEqual(deviation, 2 * x / SIZE[0] - 1, places=6)
        self.assertEqual(vertices.columns("z", "y", "x")[0], vertices.rows[0][2::-1])

    def test_gaussians_have_centres_in_millimetres_and_colours(self) -> None:
        self.write(gaussians_bytes(50))
        cloud = read_gaussians(self.folder / "a.ply")
        self.assertEqual((len(cloud.centres), len(cloud.colours)), (50, 50))
        for centre, colour in zip(cloud.centres, cloud.colours, strict=True):
            for axis in range(3):
                coefficient = 1 - 2 * centre[axis] / SIZE[axis]
                self.assertAlmostEqual(colour[axis], 0.5 + 0.2820948 * coefficient, places=5)

    def test_gaussians_without_colours(self) -> None:
        header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
        header += "property double y\nproperty float z\nend_header\n"
        self.write(header.encode() + struct.pack("<fdf", 1, 2, 3))
        cloud = read_gaussians(self.folder / "a.ply")
        self.assertEqual((cloud.centres, cloud.colours), ([(1.0, 2.0, 3.0)], []))

    def test_colours_stay_in_their_range(self) -> None:
        data = bytearray(gaussians_bytes(1))
        data[-44:-32] = struct.pack("<3f", 10.0, -10.0, 0.0)
        self.write(bytes(data))
        self.assertEqual(read_gaussians(self.folder / "a.ply").colours, [(1.0, 0.0, 0.5)])

    def test_what_cannot_be_read_is_told(self) -> None:
        good = gaussians_bytes(3)
        wrong = [b"", b"ply\n", good[:-1], b"solid x", good.replace(b"float x", b"quaternion x")]
        wrong += [good.replace(b"binary_little_endian", b"ascii"), good.replace(b"vertex", b"face")]
        for data in wrong:
            self.write(data)
            with self.assertRaises(WorkbenchError) as caught:
                read_gaussians(self.folder / "a.ply")
            self.assertIs(caught.exception.code, ErrorCode.RESULT_UNREADABLE)
