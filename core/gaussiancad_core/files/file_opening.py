"""What can be told of a sheet's file before any library is loaded to read it."""

from pathlib import Path

from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.files.file_kinds import HEAD_BYTES, is_freecad_document, unsupported
from gaussiancad_protocol.codes import Code


def head_of(path: Path) -> bytes:
    """The first bytes of a file that may be a sheet.

    Raises:
        UnreadableError: ``file-missing``, ``not-a-file``, ``file-unreadable``, ``empty-file``,
            ``freecad-document``, ``format-not-supported``.
    """
    if path.is_dir():
        raise UnreadableError(Code.NOT_A_FILE, "{path} is a folder: name a drawing file", path=path)
    if not path.exists():
        raise UnreadableError(
            Code.FILE_MISSING, "{path} does not exist: check the name of the sheet", path=path
        )
    if not path.is_file():
        raise UnreadableError(
            Code.NOT_A_FILE, "{path} is a device or pipe: name a drawing file", path=path
        )
    try:
        with path.open("rb") as file:
            head = file.read(HEAD_BYTES)
    except OSError as error:
        raise cannot_open(path, error) from error
    if not head:
        raise UnreadableError(
            Code.EMPTY_FILE, "{path} is empty: export the drawing again", path=path
        )
    if is_freecad_document(head):
        raise UnreadableError(
            Code.FREECAD_DOCUMENT,
            "{path} is a FreeCAD document, not a drawing: open it in FreeCAD and export its "
            "TechDraw page as PDF or SVG, or reconstruct the page there",
            path=path,
        )
    known = unsupported(head)
    if known is not None:
        name, advice = known
        raise UnreadableError(
            Code.FORMAT_NOT_SUPPORTED,
            "{path} is a {format} file, which is not read: {advice}",
            path=path,
            format=name,
            advice=advice,
        )
    return head


def cannot_open(path: Path, error: OSError) -> UnreadableError:
    """The error for a file that the system does not let one read."""
    return UnreadableError(
        Code.FILE_UNREADABLE,
        "{path} cannot be opened ({reason}): check its permissions",
        path=path,
        reason=error.strerror,
    )
