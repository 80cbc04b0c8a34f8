"""What FreeCAD makes of a sheet's result: a document, a STEP and an STL file beside its folder.

For ``DIR/NAME`` these are ``DIR/NAME.FCStd``, ``.step`` and ``.stl``.  They are made in a folder
of their own, looked at, and put in place, the document last: once it is there, the others are.
"""

import shutil
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.batch_bodies import NO_SOLID, NOT_ADDED, BodyMaker
from freecad.gaussiancad.batch_report import BodyOutcome, SheetRow
from freecad.gaussiancad.batch_stop import BatchStopped
from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.protocol import Status
from freecad.gaussiancad.engine.report import read_report
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.exporting import write_step, write_stl
from freecad.gaussiancad.objects.loading import LoadedRun, PartSource, load_run
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.objects.shown_objects import save_shown
from freecad.gaussiancad.staging import put_in_place, staging
from freecad.gaussiancad.whole_files import has_body, is_whole_document, is_whole_step, is_whole_stl

_DOCUMENT, _STEP, _STL = ".FCStd", ".step", ".stl"

_ALL = (_STEP, _STL, _DOCUMENT)
"""In the order in which they are put in place."""


@dataclass(frozen=True)
class MadeDocuments:
    """What was made of a result.

    Attributes:
        status: of the result.
        body: what became of the body, where one was asked for.
    """

    status: Status
    body: BodyOutcome

    @property
    def outcome(self) -> str:
        """The same for people."""
        words = self.body.words
        return f"{self.status.value}. {words}" if words else self.status.value


def complete_sheet(row: SheetRow, kept: bool, bodies: BodyMaker | None = None) -> SheetRow:
    """Make what lacks for a sheet that the engine has finished.

    Of a sheet that failed, nothing of an earlier time is left.

    Args:
        row: what became of the sheet.
        kept: whether the engine found it done: then what is whole stays.
        bodies: makes the body of a document that is made; None where none is asked for.

    Returns:
        The row; it has failed if a file could not be made.
    """
    folder = Path(row.folder)
    try:
        if row.failed or not kept:
            remove_documents(folder)
        if row.failed:
            return row
        _refuse_links(folder)
        report = read_report(folder / "report.json")
        lacking = _lacking(folder, report.text)
        if lacking:
            job = ReconstructJob.from_report(row.sheet, row.folder, report.group("settings"))
            row = row.with_body(make_documents(job, folder, lacking, bodies).body)
        if bodies is not None and _DOCUMENT not in lacking:
            row = row.with_body(_kept_body(folder))
    except BatchStopped:
        return row.stopped()
    except WorkbenchError as error:
        return row.without_document(error.code.value, error.message)
    except OSError as error:
        reason = f"cannot write the document of {row.name}: {error.strerror or error}"
        return row.without_document(ErrorCode.DOCUMENT_NOT_WRITTEN.value, reason)
    return row


def make_documents(
    job: ReconstructJob,
    target: Path,
    suffixes: Iterable[str] = _ALL,
    bodies: BodyMaker | None = None,
) -> MadeDocuments:
    """Write the document and the exchange files.

    Args:
        job: the finished job.
        target: path of the files without suffix.
        suffixes: which of them.
        bodies: makes the document's body; None where none is asked for.

    Returns:
        What is known of them.

    Raises:
        BatchStopped: somebody stopped the batch before the body was made; nothing is written.
        WorkbenchError: the engine's files are not usable, or a file could not be written whole.
        OSError: the folder cannot be written.
    """
    body = BodyOutcome()
    _refuse_what_is_no_text(job.sheet)
    _refuse_what_is_no_text(str(target))
    try:
        with staging(target.parent) as scratch:
            run = load_run(job, scratch)
            staged = scratch / target.name
            for suffix in suffixes:
                path = _with_suffix(staged, suffix)
                if suffix == _DOCUMENT:
                    body = _write_document(run, path, bodies)
                else:
                    _write_exchange(run, suffix, path)
                _check(path, run.report.text)
            for suffix in suffixes:
                put_in_place(_with_suffix(staged, suffix), _with_suffix(target, suffix))
    except (BatchStopped, WorkbenchError, OSError):
        raise
    except Exception as error:  # FreeCAD raises its own types; the next sheet goes on
        message = f"the result of {job.sheet} is unusable: {error}"
        raise WorkbenchError(ErrorCode.RESULT_UNREADABLE, message) from error
    return MadeDocuments(run.report.status, body)


def remove_documents(target: Path) -> None:
    """Remove the files of an earlier time.

    Raises:
        OSError: one cannot be removed.
    """
    for suffix in reversed(_ALL):
        _with_suffix(target, suffix).unlink(missing_ok=True)


def _lacking(target: Path, report: str) -> tuple[str, ...]:
    """Which files are to be made; all of them where the document is not of this result."""
    if not is_whole_document(_with_suffix(target, _DOCUMENT), report):
        return _ALL
    exchange = {_STEP: is_whole_step, _STL: is_whole_stl}
    return tuple(
        suffix
        for suffix, is_whole in exchange.items()
        if not is_whole(_with_suffix(target, suffix))
    )


def _kept_body(target: Path) -> BodyOutcome:
    """What is known of the body of a document that was there already."""
    if has_body(_with_suffix(target, _DOCUMENT)):
        return BodyOutcome()
    is_solid = (target / PartSource.SOLID.value).is_file()
    return BodyOutcome(NOT_ADDED if is_solid else NO_SOLID)


def _refuse_links(folder: Path) -> None:
    """No link leads from the engine's files to those of others."""
    for path in (folder, *folder.rglob("*")):
        if path.is_symlink():
            message = f"{path} is a link to elsewhere: remove it, or choose another --output"
            raise WorkbenchError(ErrorCode.OUTPUT_IS_LINK, message)


def _refuse_what_is_no_text(path: str) -> None:
    try:
        path.encode("utf-8")
    except UnicodeEncodeError as error:
        shown = path.encode("utf-8", "backslashreplace").decode()
        message = f"{shown} is no text in UTF-8, and a document takes no other name: rename it"
        raise WorkbenchError(ErrorCode.NAME_NO_TEXT, message) from error


def _write_document(run: LoadedRun, path: Path, bodies: BodyMaker | None) -> BodyOutcome:
    """Write the document; what became of its body, where one was asked for."""
    document = FreeCAD.newDocument(hidden=True)
    try:
        group = add_reconstruction(document, run)
        body = bodies.add(group, run) if bodies is not None else BodyOutcome()
        save_shown(document, path)
    finally:
        FreeCAD.closeDocument(document.Name)
    return body


def _write_exchange(run: LoadedRun, suffix: str, path: Path) -> None:
    output = Path(run.job.output)
    if suffix == _STEP and run.part is not None:
        shutil.copyfile(output / run.part.source.value, path)
    elif suffix == _STEP:
        write_step(run.mesh, path)
    elif (output / "surface.stl").is_file():
        shutil.copyfile(output / "surface.stl", path)
    else:
        write_stl(run.part.shape, path)


def _check(path: Path, report: str) -> None:
    """FreeCAD does not tell of a disk that is full."""
    is_whole = {
        _DOCUMENT: lambda: is_whole_document(path, report),
        _STEP: lambda: is_whole_step(path),
        _STL: lambda: is_whole_stl(path),
    }
    if not is_whole[path.suffix]():
        message = f"{path.name} could not be written whole: look whether the disk is full"
        raise WorkbenchError(ErrorCode.DOCUMENT_NOT_WRITTEN, message)


def _with_suffix(target: Path, suffix: str) -> Path:
    """The suffix is added: names of sheets may hold dots of their own."""
    return target.with_name(target.name + suffix)
