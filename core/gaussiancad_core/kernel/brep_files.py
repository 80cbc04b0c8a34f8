"""Exact shapes as files, STEP and BREP: read with care, written from the origin on.

Files go through Python's own file functions, so that any path the file system allows works on
every platform.  OpenCASCADE prints to file descriptor 1 while it reads and writes; who needs a
clean stdout redirects it.
"""

import io
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from OCP.APIHeaderSection import APIHeaderSection_MakeHeader
from OCP.BRep import BRep_Builder
from OCP.BRepTools import BRepTools
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.StepBasic import StepBasic_Product
from OCP.STEPControl import (
    STEPControl_Reader,
    STEPControl_StepModelType,
    STEPControl_Writer,
)
from OCP.StepData import StepData_StepModel
from OCP.TCollection import TCollection_HAsciiString
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.errors import EngineError, UnreadableError
from gaussiancad_core.kernel.brep import bounding_box, compound_of, subshapes
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.storage.plain_files import model_bytes
from gaussiancad_core.storage.single_file import write_whole
from gaussiancad_protocol.codes import Code

_STEP_MAGIC = b"ISO-10303-21"


_BREP_MAGIC = (b"DBRep_DrawableShape", b"CASCADE Topology")


_HEAD = 512


_DEEPEST = 256
"""Parentheses in parentheses of a STEP file: values hardly ever lie in a list of lists."""


_PLAIN_NAME = re.compile(r"[A-Za-z0-9 ._-]+")


def read_solid(path: Path) -> TopoDS_Shape:
    """Read a STEP or BREP file as one shape in millimetres; the content decides which it is.

    Returns:
        The solid, or a compound where the file holds several.

    Raises:
        UnreadableError: as :func:`read_shape`; ``not-a-solid``, too, if there is no solid inside;
            ``file-damaged`` if that has no extent.
    """
    solids = subshapes(read_shape(path), TopAbs_ShapeEnum.TopAbs_SOLID)
    if not solids:
        raise UnreadableError(
            Code.NOT_A_SOLID,
            "{path} holds no solid, only surfaces or curves: export a closed solid",
            path=path,
        )
    whole = solids[0] if len(solids) == 1 else compound_of(solids)
    with readable(path):
        # What has no extent cannot be drawn.
        bounding_box(whole)
    return whole


def read_shape(path: Path) -> TopoDS_Shape:
    """Read all that a STEP or BREP file holds, in millimetres; the content decides which it is.

    Raises:
        UnreadableError: ``file-missing``, ``file-not-readable``, ``empty-file``, ``not-a-solid``
            (another format), ``file-damaged``.
    """
    content = model_bytes(path)
    # Editors put a byte order mark before the text, which the STEP reader takes for damage.
    text = content.lstrip(b"\xef\xbb\xbf \t\r\n")
    if text.startswith(_STEP_MAGIC):
        return _parse_step(path, text)
    if any(magic in content[:_HEAD] for magic in _BREP_MAGIC):
        return _parse_brep(path, content)
    raise UnreadableError(
        Code.NOT_A_SOLID, "{path} is neither STEP nor BREP: export the solid as STEP", path=path
    )


@contextmanager
def readable(path: Path) -> Iterator[None]:
    """What the kernel does not do with the shape of a file is told as damage of the file.

    Raises:
        UnreadableError: ``file-damaged``.
    """
    try:
        yield
    except KERNEL_FAILURES as error:
        raise _damaged(path) from error


def _damaged(path: Path) -> UnreadableError:
    return UnreadableError(
        Code.FILE_DAMAGED, "{path} is cut off or damaged: export the solid again", path=path
    )


def _parse_step(path: Path, content: bytes) -> TopoDS_Shape:
    # The reader crashes on files that end early, lack entities, or have lists in lists without end,
    # so that is looked for first.
    text = re.sub(rb"'[^']*'", b"", content)
    ends = b"END-ISO-10303-21" in content
    if not ends or _lacks_entities(text) or _depth(text) > _DEEPEST:
        raise _damaged(path)
    reader = STEPControl_Reader()
    try:
        status = reader.ReadStream(path.name, io.BytesIO(content))
        # A transfer after a failed read crashes.
        if status != IFSelect_ReturnStatus.IFSelect_RetDone or reader.TransferRoots() < 1:
            raise _damaged(path)
        shape = reader.OneShape()
    except KERNEL_FAILURES as error:
        raise _damaged(path) from error
    if shape is None or shape.IsNull():
        raise _damaged(path)
    return shape


def _depth(text: bytes) -> int:
    """Parentheses in parentheses at most, of a text without strings."""
    signs = np.frombuffer(text, dtype=np.uint8)
    signs = signs[(signs == ord("(")) | (signs == ord(")"))]
    depth = np.cumsum(np.concatenate([[0], np.where(signs == ord("("), 1, -1)]))
    return int((depth - np.minimum.accumulate(depth)).max())


def _lacks_entities(text: bytes) -> bool:
    """Whether a STEP file, without its strings, refers to an entity that it does not define."""
    return not set(re.findall(rb"#\d+", text)) <= set(re.findall(rb"(#\d+)\s*=", text))


def _parse_brep(path: Path, content: bytes) -> TopoDS_Shape:
    shape = TopoDS_Shape()
    try:
        BRepTools.Read_s(shape, io.BytesIO(content), BRep_Builder())
    except KERNEL_FAILURES as error:
        raise _damaged(path) from error
    if shape.IsNull():
        raise _damaged(path)
    return shape


def write_step(shape: TopoDS_Shape, path: Path) -> None:
    """Write a shape as STEP (AP214) in millimetres; the file appears only when whole.

    The same shape gives the same bytes: the time stamp is fixed, and the product is called after
    the file.

    Raises:
        EngineError: OpenCASCADE cannot express the shape.
        UsageError, LimitError: the folder cannot be written, or the disk is full.
    """
    writer = STEPControl_Writer()
    stream = io.BytesIO()
    done = IFSelect_ReturnStatus.IFSelect_RetDone
    if writer.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs) != done:
        raise EngineError(
            Code.STEP_NOT_WRITTEN, "the solid for {path} cannot be expressed as STEP", path=path
        )
    _name_product(writer.Model(), path.stem if _PLAIN_NAME.fullmatch(path.stem) else "part")
    if writer.WriteStream(stream) != done:
        raise EngineError(
            Code.STEP_NOT_WRITTEN, "the STEP text for {path} cannot be made", path=path
        )
    write_whole(path, stream.getvalue())


def _name_product(model: StepData_StepModel, name: str) -> None:
    header = APIHeaderSection_MakeHeader(model)
    header.SetName(TCollection_HAsciiString(name))
    header.SetTimeStamp(TCollection_HAsciiString("1970-01-01T00:00:00"))
    header.SetAuthorValue(1, TCollection_HAsciiString(""))
    header.SetOrganizationValue(1, TCollection_HAsciiString(""))
    header.SetOriginatingSystem(TCollection_HAsciiString("GaussianCAD"))
    header.SetAuthorisation(TCollection_HAsciiString(""))
    for number in range(1, model.NbEntities() + 1):
        entity = model.Value(number)
        if isinstance(entity, StepBasic_Product):
            # By default it carries a number that counts the writes of the process.
            entity.SetId(TCollection_HAsciiString(name))
            entity.SetName(TCollection_HAsciiString(name))


def write_brep(shape: TopoDS_Shape, path: Path) -> None:
    """Write a shape in OpenCASCADE's own text format; the file appears only when whole."""
    stream = io.BytesIO()
    BRepTools.Write_s(shape, stream)
    write_whole(path, stream.getvalue())
