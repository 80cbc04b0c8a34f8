"""Files appear under their name only when whole.

A run writes into a staging folder inside its output folder and moves the finished files to their
names at the end, ``report.json`` last.  What is final before may go ahead: all that an earlier run
left is removed first, so that files of two runs never lie side by side.  A failed or cancelled run
removes the staging folder and leaves what was there before, or what went ahead; what a killed one
left behind is swept by the next run.  Only the checkpoint of a long training stays, for a run that
is to go on from it.
"""

import errno
import json
import os
import shutil
import tempfile
from contextlib import suppress
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout

from gaussiancad_core.errors import GaussianCadError, LimitError, UsageError
from gaussiancad_core.storage.plain_files import plain_bytes
from gaussiancad_core.storage.resume_check import file_facts
from gaussiancad_protocol.codes import Code

STAGING_PREFIX = ".gaussiancad-"

_LOCK = "lock"
"""File in a staging folder that is locked as long as its process lives."""

PUBLISHED_FILE = f"{STAGING_PREFIX}published.json"
"""Names of what went ahead of a report that is not there yet."""

CHECKPOINT_FILE = f"{STAGING_PREFIX}checkpoint.npz"
"""State of a training that was not finished."""

REPORT_FILE = "report.json"
"""Of a run; it is put in place last."""

READ_FILES = ("reading.json", "reading.png", "sheet.png", "lines.dxf", "lines.svg")
"""What a ``read`` run writes."""

CHECK_FILES = ("check.json", "check.png")
"""What a ``check`` run writes; the first is put in place last."""

RUN_FILES = (
    "reading.json",
    "solid.step",
    "construction.json",
    "alternatives",
    "surface.stl",
    "surface.ply",
    "surface.step",
    "hull.stl",
    "gaussians.ply",
    "cameras",
    "overlay.png",
    "preview.png",
)
"""What a ``reconstruct`` run owns in its folder beside the report; replaced as a whole."""


class OutputFolder:
    """A folder that receives the files of one run together.

    Args:
        path: the folder; made if it does not exist.
        owned: names that belong to the run: those that it did not write anew are removed.
        report: name of the file that is put in place last.

    Raises:
        UsageError: the folder cannot be made or written.
    """

    def __init__(self, path: Path, owned: tuple[str, ...], report: str) -> None:
        self.path = path
        self._owned = owned
        self._report = report
        self._made = not path.exists()
        self._ahead: set[str] = set()
        try:
            path.mkdir(parents=True, exist_ok=True)
            _sweep(path)
            # A new folder that nobody can have put there, nor a link in its place.
            self.staging = Path(tempfile.mkdtemp(prefix=STAGING_PREFIX, dir=path))
            self._lock = _lock_of(self.staging)
            self._lock.acquire(blocking=False)
        except (OSError, Timeout) as error:
            raise _folder_error(path, error) from error

    @property
    def checkpoint(self) -> Path:
        """Where the state of an unfinished training is kept."""
        return self.path / CHECKPOINT_FILE

    @property
    def ahead(self) -> bool:
        """Whether files of this run lie under their names already."""
        return bool(self._ahead)

    def publish(self) -> None:
        """Move what is in the staging folder to its names ahead of the rest.

        What an earlier run left is removed, its report first.

        Raises:
            UsageError, LimitError: the folder can no longer be written, or the disk is full.
        """
        try:
            self._put_in_place()
        except OSError as error:
            raise _folder_error(self.path, error) from error

    def commit(self) -> None:
        """Move what is in the staging folder to its names, the report last.

        Raises:
            UsageError, LimitError: the folder can no longer be written, or the disk is full.
        """
        try:
            self.checkpoint.unlink(missing_ok=True)
            self._put_in_place()
            (self.path / PUBLISHED_FILE).unlink(missing_ok=True)
            self._remove_staging()
        except OSError as error:
            raise _folder_error(self.path, error) from error

    def adopt_published(self) -> None:
        """Take what a run that died had put in place ahead for what this one did: it stays."""
        try:
            note = json.loads(plain_bytes(self.path / PUBLISHED_FILE))
            names = {str(name) for name in note["names"]}
        except (OSError, ValueError, LookupError, TypeError, RecursionError):
            return
        self._ahead |= {name for name in names & set(self._owned) if (self.path / name).exists()}

    def _put_in_place(self) -> None:
        # First, so that whenever the run is killed a later one knows whose files are here.
        self._tell_published()
        (self.path / self._report).unlink(missing_ok=True)
        for name in self._owned:
            if name not in self._ahead and not (self.staging / name).exists():
                _remove(self.path / name)
        staged = sorted(self._staged(), key=lambda entry: entry.name == self._report)
        for entry in staged:
            # On the disk before it has its name, so that no name stands for half a file.
            for path in (entry, *(entry.rglob("*") if entry.is_dir() else ())):
                sync(path)
        for entry in staged:
            target = self.path / entry.name
            if target.is_dir():
                _remove(target)
            entry.replace(target)
            self._ahead.add(entry.name)
        sync(self.path)

    def _tell_published(self) -> None:
        """Note what lies here of this run and an earlier one, for a later one that finds no
        report."""
        left = (name for name in self._owned if (self.path / name).exists())
        names = {*self._ahead, *left, *(entry.name for entry in self._staged())}
        note = json.dumps({"names": sorted(names)})
        path = self.staging / PUBLISHED_FILE
        path.write_text(note, encoding="utf-8")
        path.replace(self.path / PUBLISHED_FILE)

    def clear(self) -> None:
        """Remove what is in the staging folder."""
        for entry in self._staged():
            _remove(entry)

    def _staged(self) -> list[Path]:
        return [entry for entry in self.staging.iterdir() if entry.name != _LOCK]

    def facts(self) -> dict[str, dict[str, Any]]:
        """Sizes and hashes of all files of this run, by their path in the folder."""
        whole = [self.path / name for name in self._ahead] + self._staged()
        return file_facts(whole)

    def discard(self, *, keep_checkpoint: bool = False) -> None:
        """Remove the staging folder and what is in it, and the folder if it was made in vain."""
        self._remove_staging()
        if not keep_checkpoint:
            self.checkpoint.unlink(missing_ok=True)
        if self._made:
            with suppress(OSError):
                self.path.rmdir()

    def _remove_staging(self) -> None:
        self._lock.release()
        shutil.rmtree(self.staging, ignore_errors=True)


def sync(path: Path) -> None:
    """Have what was written to a file or folder on the disk, where the system can.

    Raises:
        OSError: it cannot be written.
    """
    if path.is_dir() and os.name == "nt":
        return
    handle = os.open(path, os.O_RDONLY | getattr(os, "O_CLOEXEC", 0))
    try:
        os.fsync(handle)
    except OSError as error:
        # Some file systems have no such thing for folders.
        if error.errno not in (errno.EINVAL, errno.ENOTSUP, errno.EBADF):
            raise
    finally:
        os.close(handle)


def check_writable(path: Path) -> None:
    """Tell early that a folder cannot be made or written; nothing is made for it.

    Raises:
        UsageError: ``output-not-writable``.
    """
    try:
        there = next(
            this_path for this_path in (path, *path.absolute().parents) if this_path.exists()
        )
    except OSError as error:
        raise _folder_error(path, error) from error
    if not there.is_dir():
        raise _folder_error(path, NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR)))
    if not os.access(there, os.W_OK):
        raise _folder_error(path, PermissionError(errno.EACCES, os.strerror(errno.EACCES)))


def os_error(path: Path, error: OSError) -> GaussianCadError:
    """The engine's error for a file operation that failed under ``path``."""
    return _folder_error(path, error)


def _folder_error(path: Path, error: OSError) -> GaussianCadError:
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        return LimitError(
            Code.DISK_FULL, "no space left on the disk of {path}: free some, then retry", path=path
        )
    reason = error.strerror or str(error)
    return UsageError(
        Code.OUTPUT_NOT_WRITABLE,
        "cannot write to {path} ({reason}): choose another output folder",
        path=path,
        reason=reason,
    )


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _sweep(path: Path) -> None:
    """Remove staging folders whose process is gone: nobody holds their locks.

    That of a run on another machine is told where the file system shares locks.
    """
    for entry in path.glob(f"{STAGING_PREFIX}*"):
        held = entry / _LOCK
        if entry.is_symlink() or held.is_symlink() or not held.is_file():
            continue
        lock = _lock_of(entry)
        try:
            lock.acquire(blocking=False)
        except Timeout:
            continue
        lock.release()
        shutil.rmtree(entry, ignore_errors=True)


def _lock_of(staging: Path) -> FileLock:
    return FileLock(staging / _LOCK)
