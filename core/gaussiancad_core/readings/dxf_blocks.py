"""DXF files (R2000) of blocks, written as text.

They are written into ``assets/lines.dxf``, a drawing in mm in which nothing is drawn yet, with the
layers and linetypes of lines: a library that writes any DXF takes longer to load than a sheet
to read.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from importlib.resources import files
from itertools import count

_UNITS = "$INSUNITS\n 70\n{}\n"
_MM, _UNITLESS = 4, 0
"""DXF's numbers of units."""

_SEED = "$HANDSEED\n  5\n{:X}\n"
_FREE = 0x49
"""The first number that nothing in the empty drawing has."""

_MODEL, _RECORDS = "17", "9"
"""Numbers of the space that is drawn in, and of the table of blocks."""

_END_OF_RECORDS = "  0\nENDTAB\n  0\nENDSEC\n  0\nSECTION\n  2\nBLOCKS\n"
_END_OF_BLOCKS = "  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n"

Tag = tuple[int, str | float]
"""A group code and its value."""


@dataclass(frozen=True)
class DxfEntity:
    """What is drawn.

    Attributes:
        kind: its name.
        layer: that it is on.
        tags: those of its own.
    """

    kind: str
    layer: str
    tags: tuple[Tag, ...]


@dataclass(frozen=True)
class DxfBlock:
    """Entities, and where they stand.

    Attributes:
        name: of the block.
        place: (x, y) of its origin.
        entities: in it.
    """

    name: str
    place: tuple[float, float]
    entities: tuple[DxfEntity, ...]


def place_tags(x: float, y: float, number: int = 0) -> tuple[Tag, ...]:
    """The group codes of a point: the first of an entity, or a further one."""
    return (10 + number, float(x)), (20 + number, float(y)), (30 + number, 0.0)


def dxf_file(blocks: Sequence[DxfBlock], besides: Iterable[DxfEntity], *, is_mm: bool) -> bytes:
    """A file with each block where it stands, the same bytes for the same.

    Args:
        blocks: of names that differ.
        besides: entities that are in none.
        is_mm: whether lengths are mm; else they have no unit.
    """
    handles = count(_FREE)
    records, written, placed = [], [], []
    for block in blocks:
        record = f"{next(handles):X}"
        records.append(_record(block.name, record))
        written.append(_text(_block(block, record, handles)))
        insert = DxfEntity(
            "INSERT", "0", (*_kind("BlockReference", block), *place_tags(*block.place))
        )
        placed.append(_text(_entity(insert, _MODEL, handles)))
    placed += [_text(_entity(entity, _MODEL, handles)) for entity in besides]
    content = files(__package__).joinpath("assets", "lines.dxf").read_text(encoding="ascii")
    for stated, wanted in (
        (_UNITS.format(_MM), _UNITS.format(_MM if is_mm else _UNITLESS)),
        (_SEED.format(_FREE), _SEED.format(next(handles))),
        (_END_OF_RECORDS, "".join(records) + _END_OF_RECORDS),
        (_END_OF_BLOCKS, "".join(written) + _END_OF_BLOCKS + "".join(placed)),
    ):
        content = content.replace(stated, wanted, 1)
    return content.encode("ascii")


def _text(tags: Iterable[Tag]) -> str:
    return "".join(f"{code:3}\n{value}\n" for code, value in tags)


def _kind(kind: str, block: DxfBlock) -> tuple[Tag, ...]:
    return (100, f"AcDb{kind}"), (2, block.name)


def _record(name: str, handle: str) -> str:
    kinds = (100, "AcDbSymbolTableRecord"), (100, "AcDbBlockTableRecord")
    return _text([(0, "BLOCK_RECORD"), (5, handle), (330, _RECORDS), *kinds, (2, name), (340, "0")])


def _block(block: DxfBlock, record: str, handles: Iterator[int]) -> Iterator[Tag]:
    """A block with what is in it, from its begin to its end."""
    head = (*_kind("BlockBegin", block), (70, "0"), *place_tags(0.0, 0.0), (3, block.name), (1, ""))
    yield from _entity(DxfEntity("BLOCK", "0", head), record, handles)
    for entity in block.entities:
        yield from _entity(entity, record, handles)
    yield from _entity(DxfEntity("ENDBLK", "0", ((100, "AcDbBlockEnd"),)), record, handles)


def _entity(entity: DxfEntity, owner: str, handles: Iterator[int]) -> Iterator[Tag]:
    yield 0, entity.kind
    yield 5, f"{next(handles):X}"
    yield 330, owner
    yield 100, "AcDbEntity"
    yield 8, entity.layer
    yield from entity.tags
