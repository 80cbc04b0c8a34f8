"""``manifest.sqlite``: what is known of each sheet of a batch, kept whatever happens to it.

One process writes.  The journal is rolled back after a crash, and what is noted of a sheet is on
the disk before the next one begins (``synchronous = FULL``).  Write-ahead logs fail on network file
systems.
"""

import json
import os
import sqlite3
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from gaussiancad_core.batches.batch_inputs import BatchSheet
from gaussiancad_core.batches.batch_table import BatchRow
from gaussiancad_core.errors import LimitError, UsageError
from gaussiancad_core.processes.supervisor import Ended
from gaussiancad_core.storage.resume_check import sha256
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

MANIFEST_FILE = "manifest.sqlite"

_SCHEMA = 1

_TABLES = """
create table if not exists sheet (
    name text primary key, path blob not null, settings text not null, engine text not null,
    size integer, mtime integer, sha256 text, files text not null, done text not null);
create table if not exists attempt (
    name text not null, ended text not null default current_timestamp, exit_code integer not null,
    message text not null, seconds real not null, peak integer not null);
"""

_FINAL = (ExitCode.DONE, ExitCode.UNREADABLE, ExitCode.NO_MODEL)
"""How sheets end that would end the same way again."""

Files = Mapping[str, tuple[int, int]]
"""Size in bytes and time of change in ns of files, by path."""


@dataclass(frozen=True)
class Key:
    """What decides the result of a sheet beside its content.

    Attributes:
        path: of the sheet.
        settings: of its job.
        engine: version and packages.
    """

    path: Path
    settings: Mapping[str, Any]
    engine: str

    @classmethod
    def of(cls, sheet: BatchSheet, engine: str) -> "Key":
        """That of a sheet of a batch."""
        return cls(Path(os.path.abspath(sheet.path)), sheet.job.settings(), engine)


class Manifest:
    """The manifest of an output folder.

    Args:
        folder: of the batch.

    Raises:
        UsageError, LimitError: it cannot be written.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / MANIFEST_FILE
        try:
            self._base = _opened(self._path)
        except sqlite3.DatabaseError:
            # Damaged: it is kept for who wants to know, and all sheets are looked at anew.
            _put_aside(self._path)
            self._base = _opened(self._path)

    def close(self) -> None:
        """Write nothing more."""
        self._base.close()

    def kept(self, name: str, key: Key, folder: Path) -> BatchRow | None:
        """What became of a sheet, if it would become the same again, and all of that is there.

        Args:
            name: of its folder.
            key: of the sheet.
            folder: of its results.
        """
        row = self._base.execute(
            "select path, settings, engine, size, mtime, sha256, files, done from sheet "
            "where name = ?",
            (name,),
        ).fetchone()
        if row is None or row[:3] != _columns(key):
            return None
        size, mtime, digest, files, done = row[3:]
        try:
            entry = {"sheet": str(key.path), "folder": str(folder)}
            found = BatchRow(**{**json.loads(done), **entry})
        except TypeError:  # another version noted other things
            return None
        if found.exit_code not in _FINAL or not _is_same(key.path, (size, mtime), digest):
            return None
        known = {path: tuple(facts) for path, facts in json.loads(files).items()}
        return found if known == files_under(folder) else None

    def note(self, key: Key, row: BatchRow, ended: Ended) -> None:
        """Keep what became of a sheet.

        Raises:
            UsageError, LimitError: the manifest cannot be written.
        """
        facts = _facts(key.path)
        done = json.dumps({**asdict(row), "sheet": "", "folder": ""})
        files = json.dumps(files_under(Path(row.folder)))
        values = (row.name, *_columns(key), *facts, files, done)
        message = ended.message.encode("utf-8", "backslashreplace").decode()
        attempt = (row.name, row.exit_code, message, ended.seconds, ended.peak)
        try:
            with self._base:
                self._base.execute(
                    f"insert or replace into sheet values ({', '.join('?' * len(values))})", values
                )
                self._base.execute(
                    "insert into attempt (name, exit_code, message, seconds, peak) "
                    "values (?, ?, ?, ?, ?)",
                    attempt,
                )
        except sqlite3.Error as error:
            raise _unusable(self._path, error) from error


def files_under(folder: Path) -> Files:
    """Size and time of change of all files under a folder, but of hidden ones in it."""
    found: dict[str, tuple[int, int]] = {}
    for root, folders, files in os.walk(folder):
        folders[:] = [this_folder for this_folder in folders if not this_folder.startswith(".")]
        for name in files:
            if not name.startswith("."):
                path = Path(root) / name
                state = path.stat()
                found[path.relative_to(folder).as_posix()] = state.st_size, state.st_mtime_ns
    return found


def _opened(path: Path) -> sqlite3.Connection:
    base = None
    try:
        base = sqlite3.connect(path, isolation_level="IMMEDIATE")
        base.execute("pragma synchronous = full")
        base.executescript(_TABLES)
        (schema,) = base.execute("pragma user_version").fetchone()
        if schema not in (0, _SCHEMA):
            raise sqlite3.DatabaseError(f"schema {schema}")
        base.execute(f"pragma user_version = {_SCHEMA}")
        base.execute("select * from sheet limit 1").fetchall()
        base.commit()
    except sqlite3.OperationalError as error:
        raise _unusable(path, error) from error
    except sqlite3.DatabaseError:
        if base is not None:
            base.close()
        raise
    return base


def _put_aside(path: Path) -> None:
    number = 1
    while (aside := path.with_name(f"{path.name}.damaged-{number}")).exists():
        number += 1
    path.replace(aside)


def _unusable(path: Path, error: sqlite3.Error) -> UsageError | LimitError:
    if "full" in str(error):
        return LimitError(
            Code.DISK_FULL, f"no space left on the disk of {path}: free some, then --resume"
        )
    return UsageError(
        Code.OUTPUT_NOT_WRITABLE, f"cannot write {path} ({error}): choose another output folder"
    )


def _columns(key: Key) -> tuple[bytes, str, str]:
    return os.fsencode(key.path), json.dumps(key.settings, sort_keys=True), key.engine


def _facts(path: Path) -> tuple[int | None, int | None, str | None]:
    try:
        state = path.stat()
        return state.st_size, state.st_mtime_ns, sha256(path)
    except OSError:
        return None, None, None


def _is_same(path: Path, known: tuple[int | None, int | None], digest: str | None) -> bool:
    """Whether a sheet is as it was; one that was missing, if it is still."""
    try:
        state = path.stat()
    except OSError:
        return digest is None
    if known == (state.st_size, state.st_mtime_ns):
        return True
    try:
        return digest == sha256(path)
    except OSError:
        return False
