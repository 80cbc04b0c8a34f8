"""A batch from its sheets to its report."""

import json
import os
import re
import signal
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from filelock import FileLock, Timeout

from gaussiancad_core import __version__
from gaussiancad_core.batches.batch_folder_names import folder_names
from gaussiancad_core.batches.batch_inputs import BatchSheet
from gaussiancad_core.batches.batch_page import PAGE_FILE, page_bytes
from gaussiancad_core.batches.batch_table import REPORT_FILE, BatchRow, table_bytes
from gaussiancad_core.batches.job_arguments import job_arguments
from gaussiancad_core.batches.manifest import MANIFEST_FILE, Key, Manifest
from gaussiancad_core.errors import CancelledError, LimitError, UsageError
from gaussiancad_core.processes.supervisor import Ended, ProcessLimits, Supervisor
from gaussiancad_core.storage.outputs import REPORT_FILE as SHEET_REPORT
from gaussiancad_core.storage.outputs import os_error
from gaussiancad_core.storage.resume_check import finished_report, sha256
from gaussiancad_core.storage.single_file import write_whole
from gaussiancad_core.storage.versions import ENGINE_PACKAGES, installed_versions
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode
from gaussiancad_protocol.modes import Status

if TYPE_CHECKING:
    from gaussiancad_core.batches.cluster import Cluster

_LOCK_FILE = ".gaussiancad-batch.lock"

_MODULES = tuple(
    f"gaussiancad_core.{name}"
    for name in (
        "run.pipeline",
        "recognition.views_and_lines",
        "recognition.picture_views",
        "sheet.tracing.traced_views",
        "run.exact_stage",
        "run.ink_stage",
        "run.solid_report",
        "run.check_stage",
        "run.run_models",
    )
)
"""What every sheet needs: most of its start-up."""

_FULL_DISKS = 3
"""Sheets in a row that end for want of space after which no more is begun."""

_LINK = (
    "the sheet's folder is a link to elsewhere: remove it, or choose another --output "
    "[output-is-link]"
)

_NOT_DONE = "the batch was stopped before this sheet was done: go on with --resume [cancelled]"

_TOLD = re.compile(r"^(?:gaussiancad: )?(?P<message>.*) \[(?P<code>[a-z0-9-]+)\]$")
"""How a process tells its error, and a supervisor why it ended one."""


@dataclass(frozen=True)
class SheetDone:
    """A sheet that is done, however it ended.

    Attributes:
        row: what became of it.
        kept: whether an earlier batch did it.
        done: how many sheets are done.
        count: of how many.
        rate: sheets per minute of this batch so far, without those that were kept.
        left_s: s until the last one is done at that rate; None where none was done yet.
    """

    row: BatchRow
    kept: bool
    done: int
    count: int
    rate: float
    left_s: float | None


Tell = Callable[[SheetDone], None]
"""Called for each sheet, once what became of it is kept."""


@dataclass(frozen=True)
class BatchSettings:
    """How sheets are worked off.

    Attributes:
        output: folder of the batch.
        workers: processes at a time.
        limits: of each.
        resume: whether what an earlier batch finished is kept.
        scheduler: address of a Dask scheduler whose workers do the work instead; None for this
            machine.
    """

    output: Path
    workers: int
    limits: ProcessLimits
    resume: bool = False
    scheduler: str | None = None

    def processes(self) -> "Supervisor[_Place] | Cluster[_Place]":
        """What runs the sheets' processes; errors as of either."""
        if self.scheduler is None:
            return Supervisor(self.workers, self.limits, _MODULES)
        from gaussiancad_core.batches.cluster import Cluster

        return Cluster(self.scheduler, self.limits, self.output)


@dataclass(frozen=True)
class _Place:
    """A sheet and where its results go."""

    sheet: BatchSheet
    name: str
    folder: Path
    key: Key

    def row(self, status: str, bound: str, ended: Ended) -> BatchRow:
        match = _TOLD.match(ended.message)
        code, message = (match["code"], match["message"]) if match else ("", ended.message)
        return BatchRow(
            self.name,
            str(self.key.path),
            str(self.folder),
            status,
            bound,
            ended.exit_code,
            code,
            message,
            round(ended.seconds, 2),
        )


def run_batch(sheets: Sequence[BatchSheet], settings: BatchSettings, tell: Tell) -> list[BatchRow]:
    """Reconstruct sheets into ``output/NAME``; write ``report.csv`` and ``index.html`` there.

    Args:
        sheets: different ones, in the order of the report.
        settings: of the batch.
        tell: hears of each sheet that is done.

    Returns:
        The rows of the report.

    Raises:
        UsageError: ``batch-running``, ``output-not-writable``, ``output-is-link``; as of
            :class:`.cluster.Cluster`.
        LimitError: ``disk-full``.
        CancelledError: the report is written, and names the sheets that are not done.
    """
    output = settings.output
    try:
        output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise os_error(output, error) from error
    for name in (_LOCK_FILE, MANIFEST_FILE, f"{MANIFEST_FILE}-journal"):
        if (output / name).is_symlink():
            raise UsageError(
                Code.OUTPUT_IS_LINK,
                f"{output / name} is a link to elsewhere: remove it, or choose another --output",
            )
    with _alone(output):
        manifest = Manifest(output)
        try:
            return _Batch(settings, manifest, tell).run(_places(sheets, output))
        finally:
            manifest.close()


@contextmanager
def _alone(output: Path) -> Iterator[None]:
    lock = FileLock(output / _LOCK_FILE)
    try:
        lock.acquire(blocking=False)
    except Timeout:
        raise UsageError(
            Code.BATCH_RUNNING,
            f"another batch writes to {output}: wait for it, or choose another --output",
        ) from None
    except OSError as error:
        raise os_error(output, error) from error
    try:
        yield
    finally:
        lock.release()


def _places(sheets: Sequence[BatchSheet], output: Path) -> list[_Place]:
    engine = json.dumps([__version__, installed_versions(ENGINE_PACKAGES)])
    names = folder_names([sheet.path for sheet in sheets])
    root = Path(os.path.abspath(output))
    return [
        _Place(sheet, name, root / name, Key.of(sheet, engine))
        for sheet, name in zip(sheets, names, strict=True)
    ]


class _Batch:
    """A batch in progress."""

    def __init__(self, settings: BatchSettings, manifest: Manifest, tell: Tell) -> None:
        self._settings, self._manifest, self._tell = settings, manifest, tell
        self._rows: dict[str, BatchRow] = {}
        self._full_disks = 0
        self._worked = 0
        self._started = time.monotonic()

    def run(self, places: list[_Place]) -> list[BatchRow]:
        processes = self._settings.processes()
        try:
            for place, ended in processes.run(self._begun(places)):
                self._take(place, ended, len(places))
            processes.close()
            return self._write(places)
        except (CancelledError, KeyboardInterrupt):
            # From here on there is an end to come to: no second signal breaks it off.
            for number in (signal.SIGINT, signal.SIGTERM):
                with suppress(ValueError):
                    signal.signal(number, signal.SIG_IGN)
            processes.close()
            self._write(places)
            raise
        except BaseException:
            processes.close()
            raise

    def _begun(self, places: list[_Place]) -> Iterator[tuple[_Place, list[str]]]:
        """Sheets that have to be done, with the arguments of their processes."""
        for place in places:
            if self._settings.resume and not place.folder.is_symlink():
                row = self._finished(place)
                if row is not None:
                    self._done(row, len(places), kept=True)
                    continue
            if place.folder.is_symlink():
                row = place.row(Status.FAILED.value, "", Ended(int(ExitCode.USAGE), _LINK, 0, 0))
                self._done(row, len(places))
                continue
            job = replace(place.sheet.job, resume=self._settings.resume)
            yield (
                place,
                [
                    "reconstruct",
                    "--events",
                    "--output",
                    str(place.folder),
                    *job_arguments(job),
                    # A name may begin like an option.
                    "--",
                    str(place.key.path),
                ],
            )

    def _finished(self, place: _Place) -> BatchRow | None:
        """What an earlier batch made of a sheet: by the manifest, or else by the sheet's report."""
        row = self._manifest.kept(place.name, place.key, place.folder)
        if row is not None:
            return row
        try:
            digest = sha256(place.key.path)
        except OSError:
            return None
        report = finished_report(place.folder / SHEET_REPORT, place.key.settings, digest)
        if report is None:
            return None
        ended = Ended(int(ExitCode.DONE), "", float(sum(report["seconds"].values())), 0)
        row = place.row(*_status_and_bound(report), ended)
        self._manifest.note(place.key, row, ended)
        return row

    def _take(self, place: _Place, ended: Ended, count: int) -> None:
        status, bound = _result(place.folder) if ended.exit_code == 0 else (Status.FAILED.value, "")
        row = place.row(status, bound, ended)
        self._manifest.note(place.key, row, ended)
        self._done(row, count)
        self._full_disks = self._full_disks + 1 if row.code == Code.DISK_FULL else 0
        if self._full_disks == _FULL_DISKS:
            raise LimitError(Code.DISK_FULL, f"{row.message}; the batch goes on with --resume")

    def _done(self, row: BatchRow, count: int, *, kept: bool = False) -> None:
        self._rows[row.name] = row
        self._worked += not kept
        rate = self._worked / max(time.monotonic() - self._started, 1e-3)
        left = (count - len(self._rows)) / rate if rate else None
        self._tell(SheetDone(row, kept, len(self._rows), count, 60.0 * rate, left))

    def _write(self, places: list[_Place]) -> list[BatchRow]:
        """The report, with a row for every sheet."""
        stopped = Ended(int(ExitCode.CANCELLED), _NOT_DONE, 0.0, 0)
        rows = [
            self._rows.get(place.name) or place.row(Status.FAILED.value, "", stopped)
            for place in places
        ]
        output = self._settings.output
        write_whole(output / REPORT_FILE, table_bytes(rows))
        write_whole(output / PAGE_FILE, page_bytes(rows))
        return rows


def _result(folder: Path) -> tuple[str, str]:
    """Status and bound of the measures as the sheet's report has them."""
    return _status_and_bound(json.loads((folder / SHEET_REPORT).read_text(encoding="utf-8")))


def _status_and_bound(report: Mapping[str, Any]) -> tuple[str, str]:
    measures = report["measures"]
    return report["status"], f"{measures['uncertainty_mm']:g}" if measures else ""
