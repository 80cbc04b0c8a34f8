"""The part that the fake engine always finds: an L-shaped bracket of 60 x 40 x 30 mm."""

import struct
import zlib
from pathlib import Path

SIZE = (60.0, 40.0, 30.0)
VOLUME = 60.0 * 40.0 * 10.0 + 15.0 * 40.0 * 20.0

MM_PER_PIXEL = 0.25
BOXES = {
    "front": (100.0, 360.0, 340.0, 480.0),
    "top": (100.0, 100.0, 340.0, 260.0),
    "right": (440.0, 360.0, 600.0, 480.0),
}
SHEET_SIZE = (720, 580)

STEP_FILE = Path(__file__).parent / "data" / "bracket.step"

ALTERNATIVES = tuple(STEP_FILE.with_name(f"alternative-{number}.step") for number in (1, 2))
"""The bracket without a block of 5 x 20 x 10 mm, and with one of 10 x 10 x 5 mm on its foot."""

ALTERNATIVE_VOLUMES = (VOLUME - 1000.0, VOLUME + 500.0)

_PROFILE = ((0, 0), (60, 0), (60, 10), (15, 10), (15, 30), (0, 30))


def triangles() -> list[tuple[tuple[float, float, float], ...]]:
    """The bracket's closed surface, outward."""
    front = [(float(x), 0.0, float(z)) for x, z in _PROFILE]
    rear = [(x, 40.0, z) for x, _, z in front]
    cap = ((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5))
    faces = [tuple(front[i] for i in corners) for corners in cap]
    faces += [tuple(rear[i] for i in reversed(corners)) for corners in cap]
    for i in range(6):
        j = (i + 1) % 6
        faces += [(front[i], rear[j], front[j]), (front[i], rear[i], rear[j])]
    return faces


def stl_text() -> str:
    """The surface as ASCII STL."""
    lines = ["solid bracket"]
    for corners in triangles():
        lines.append("facet normal 0 0 0\nouter loop")
        lines += [f"vertex {x} {y} {z}" for x, y, z in corners]
        lines.append("endloop\nendfacet")
    return "\n".join([*lines, "endsolid bracket", ""])


def gaussians_bytes(count: int = 600) -> bytes:
    """Gaussians on the surface, in the layout that 3DGS viewers read."""
    names = ["x", "y", "z", "f_dc_0", "f_dc_1", "f_dc_2", "opacity"]
    names += ["scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"]
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {count}"]
    header += [f"property float {name}" for name in names] + ["end_header", ""]
    faces = triangles()
    rows = []
    for number in range(count):
        a, b, c = faces[number % len(faces)]
        u = ((number * 0.754877666) % 1.0) ** 0.5
        v = (number * 0.569840291) % 1.0
        weights = (1.0 - u, u * (1.0 - v), u * v)
        centre = [sum(w * p[i] for w, p in zip(weights, (a, b, c), strict=True)) for i in range(3)]
        colour = [1.0 - 2.0 * centre[i] / SIZE[i] for i in range(3)]
        rows.append(struct.pack("<14f", *centre, *colour, 2.0, -1, -1, -1, 1, 0, 0, 0))
    return "\n".join(header).encode("ascii") + b"".join(rows)


def deviation_bytes() -> bytes:
    """The surface with a deviation at every vertex: blue at -1 mm, red at +1 mm, along x."""
    faces = triangles()
    vertices = sorted({corner for face in faces for corner in face})
    header = ["ply", "format binary_little_endian 1.0", "comment unit mm", "comment signed 1"]
    header += ["comment range 1", f"element vertex {len(vertices)}"]
    header += [f"property float {name}" for name in "xyz"]
    header += [f"property uchar {name}" for name in ("red", "green", "blue")]
    header += ["property float deviation", f"element face {len(faces)}"]
    header += ["property list uchar int vertex_indices", "end_header", ""]
    body = b""
    for x, y, z in vertices:
        share = x / SIZE[0]
        colour = (round(255 * share), 0, round(255 * (1 - share)))
        body += struct.pack("<3f3Bf", x, y, z, *colour, 2 * share - 1)
    for face in faces:
        body += struct.pack("<B3i", 3, *(vertices.index(corner) for corner in face))
    return "\n".join(header).encode("ascii") + body


def picture_bytes(width: int = 126, height: int = 90) -> bytes:
    """A grey picture as PNG, as wide and high as the engine's in a tenth of the size."""
    rows = b"".join(b"\0" + b"\xb0" * (3 * width) for _ in range(height))
    chunks = (
        (b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)),
        (b"IDAT", zlib.compress(rows)),
        (b"IEND", b""),
    )
    content = b"\x89PNG\r\n\x1a\n"
    for name, body in chunks:
        check = zlib.crc32(name + body)
        content += struct.pack(">I", len(body)) + name + body + struct.pack(">I", check)
    return content
