"""The vertices of a binary PLY file, in plain Python.

The engine's Gaussians carry properties that FreeCAD's own importers do not know (opacity, scales,
rotations), so that their files are read here.
"""

import struct
from dataclasses import dataclass
from pathlib import Path

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate

_LETTERS = {
    **dict.fromkeys(("char", "int8"), "b"),
    **dict.fromkeys(("uchar", "uint8"), "B"),
    **dict.fromkeys(("short", "int16"), "h"),
    **dict.fromkeys(("ushort", "uint16"), "H"),
    **dict.fromkeys(("int", "int32"), "i"),
    **dict.fromkeys(("uint", "uint32"), "I"),
    **dict.fromkeys(("float", "float32"), "f"),
    **dict.fromkeys(("double", "float64"), "d"),
}

_LONGEST_HEADER = 1 << 16


@dataclass(frozen=True)
class PlyVertices:
    """The vertex table of a PLY file.

    Attributes:
        names: of the properties.
        rows: one tuple a vertex, in the order of the names.
        comments: the header's comments.
    """

    names: tuple[str, ...]
    rows: list[tuple[float, ...]]
    comments: tuple[str, ...]

    def columns(self, *names: str) -> list[tuple[float, ...]]:
        """One tuple a vertex with just the named properties.

        Raises:
            KeyError: there is no such property.
        """
        if missing := [name for name in names if name not in self.names]:
            raise KeyError(missing[0])
        first, *others = (self.names.index(name) for name in names)
        if others == list(range(first + 1, first + len(names))):
            return [row[first : first + len(names)] for row in self.rows]
        places = (first, *others)
        return [tuple(row[place] for place in places) for row in self.rows]


def read_vertices(path: Path) -> PlyVertices:
    """Read the vertices of a binary little-endian PLY file whose first element they are.

    Raises:
        WorkbenchError: the file is missing, cut off, or of another kind.
    """
    try:
        data = path.read_bytes()
        return _parse(data)
    except (OSError, ValueError, KeyError, struct.error) as error:
        message = translate(
            "GaussianCAD", "The engine's file {path} cannot be read ({reason}). Run it again."
        ).format(path=path, reason=error)
        raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, message) from error


def _parse(data: bytes) -> PlyVertices:
    end = data.find(b"end_header\n", 0, _LONGEST_HEADER)
    if not data.startswith(b"ply\n") or end < 0:
        raise ValueError("no PLY header")
    lines = [line.split() for line in data[:end].decode("ascii").splitlines()]
    if ["format", "binary_little_endian", "1.0"] not in lines:
        raise ValueError("not binary_little_endian 1.0")
    elements = [(place, line) for place, line in enumerate(lines) if line[:1] == ["element"]]
    if not elements or elements[0][1][1] != "vertex":
        raise ValueError("vertices do not come first")
    start = elements[0][0]
    stop = elements[1][0] if len(elements) > 1 else len(lines)
    properties = [line for line in lines[start + 1 : stop] if line[:1] == ["property"]]
    row = struct.Struct("<" + "".join(_LETTERS[line[1]] for line in properties))
    count = int(elements[0][1][2])
    body = memoryview(data)[end + len(b"end_header\n") :]
    if len(body) < count * row.size:
        raise ValueError("cut off")
    return PlyVertices(
        tuple(line[2] for line in properties),
        list(row.iter_unpack(body[: count * row.size])),
        tuple(" ".join(line[1:]) for line in lines if line[:1] == ["comment"]),
    )
