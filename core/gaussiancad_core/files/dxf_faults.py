"""Entities of a DXF file that cannot be read: left out, one by one, and said."""

import struct
from collections.abc import Mapping
from pathlib import Path

from ezdxf.lldxf.const import DXFError

from gaussiancad_core.files.content import Note
from gaussiancad_core.messages import Message
from gaussiancad_protocol.codes import Code

BROKEN = (
    DXFError,
    struct.error,
    ArithmeticError,
    AssertionError,
    AttributeError,
    EOFError,
    LookupError,
    NotImplementedError,
    OSError,
    RuntimeError,
    TypeError,
    ValueError,
)
"""What ezdxf raises over broken files and what it does not know: its own errors, and whatever
broken values lead to; neither lack of memory nor an interrupt."""

_FURNITURE = frozenset(
    {
        "ACAD_TABLE",
        "ARC_DIMENSION",
        "ATTDEF",
        "ATTRIB",
        "DIMENSION",
        "IMAGE",
        "LARGE_RADIAL_DIMENSION",
        "LEADER",
        "MLEADER",
        "MTEXT",
        "MULTILEADER",
        "POINT",
        "RAY",
        "TEXT",
        "TOLERANCE",
        "VIEWPORT",
        "WIPEOUT",
        "XLINE",
    }
)
"""Kinds of entities (DXF reference) that show no line of a part: endless lines construct, edges
end."""


def left_out(path: Path, unread: Mapping[str, int]) -> tuple[Note, ...]:
    """That entities were left out, if any were: a doubt where they may show the part.

    Args:
        path: of the file.
        unread: how many of each kind.
    """
    if not unread:
        return ()
    is_doubt = not _FURNITURE.issuperset(unread)
    message = Message(
        "{name} has entities that cannot be read and were left out: {kinds}",
        name=path.name,
        kinds=", ".join(f"{count} {kind}" for kind, count in sorted(unread.items())),
        case="part" if is_doubt else "furniture",
    )
    return (Note(Code.ENTITIES_LEFT_OUT, message, is_doubt),)
