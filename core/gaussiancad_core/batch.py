"""Many sheets: each is reconstructed in a process of its own, one report over all.

A sheet that fails, or whose process is killed, does not touch the others.
"""

import csv
import io
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import astuple, dataclass, fields
from pathlib import Path

from gaussiancad_core.drawing.files import write_whole
from gaussiancad_core.job import Job
from gaussiancad_core.modes import Status
from gaussiancad_core.sheet_names import folder_names

REPORT_FILE = "report.csv"

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
"""What formulas begin with."""

_LINK = "the sheet's folder is a link to elsewhere: remove it, or choose another --output"


@dataclass(frozen=True)
class BatchRow:
    """What became of one sheet.

    Attributes:
        name: of its folder.
        sheet: its path.
        folder: of the results.
        status: as in its report, or ``failed``; it speaks of the shape.
        measures_mm: bound that 95 % of the faces' places keep; empty where it is not known.
        exit_code: of its process.
        message: of its error, or empty.
        seconds: of the run.
    """

    name: str
    sheet: str
    folder: str
    status: str
    measures_mm: str
    exit_code: int
    message: str
    seconds: float


def run_batch(sheets: list[Path], job: Job, workers: int) -> list[BatchRow]:
    """Reconstruct sheets into ``job.output/NAME`` and write ``report.csv`` there.

    Args:
        sheets: in the order of the report; one that is named twice counts once.
        job: settings for all; its sheet is not used.
        workers: processes at a time.

    Raises:
        UsageError, LimitError: the report cannot be written.
    """
    sheets = list({os.path.abspath(sheet): sheet for sheet in sheets}.values())
    names = folder_names(sheets)
    with ThreadPoolExecutor(workers) as pool:
        rows = list(pool.map(lambda pair: _run_one(*pair, job), zip(sheets, names, strict=True)))
    write_whole(job.output / REPORT_FILE, _csv(rows))
    return rows


def _run_one(sheet: Path, name: str, job: Job) -> BatchRow:
    folder = job.output / name
    if folder.is_symlink():
        failed = BatchRow(name, str(sheet), str(folder), Status.FAILED.value, "", 2, _LINK, 0.0)
        return failed
    command = [
        sys.executable,
        "-I",
        "-m",
        "gaussiancad_core",
        "reconstruct",
        "--output",
        os.path.abspath(folder),
        *job_arguments(job),
        # A name may begin like an option.
        os.path.abspath(sheet),
    ]
    finished = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    lines = finished.stderr.decode("utf-8", "replace").strip().splitlines()
    message = "" if finished.returncode == 0 else (lines[-1] if lines else "no message")
    status, seconds, bound = Status.FAILED.value, 0.0, ""
    if finished.returncode == 0:
        report = json.loads((folder / "report.json").read_text(encoding="utf-8"))
        status, seconds = report["status"], sum(report["seconds"].values())
        bound = f"{report['measures']['uncertainty_mm']:g}" if report["measures"] else ""
    return BatchRow(
        name,
        str(sheet),
        str(folder),
        status,
        bound,
        finished.returncode,
        message,
        round(seconds, 2),
    )


def job_arguments(job: Job) -> list[str]:
    """Options of ``gaussiancad reconstruct`` that give the same job on another sheet."""
    settings = job.settings()
    arguments: list[str] = []
    for name in ("projection", "page", "result", "recipe", "preset", "seed", "colour", "finder"):
        arguments += [f"--{name}", str(settings[name])]
    for role, box in settings["views"].items():
        arguments += ["--view", f"{role}={','.join(str(value) for value in box)}"]
    if settings["length"]:
        arguments += ["--length", f"{settings['length']['axis']}={settings['length']['mm']}"]
    if settings["mm_per_pixel"]:
        arguments += ["--mm-per-pixel", str(settings["mm_per_pixel"])]
    arguments += ["--median", str(settings["median_kernel"])]
    arguments += ["--device", job.device.value, "--scale-down", str(job.scale_down)]
    switches = {"--resume": job.resume, "--transforms": job.transforms}
    return [*arguments, *(name for name, wanted in switches.items() if wanted)]


def _csv(rows: list[BatchRow]) -> bytes:
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow([field.name for field in fields(BatchRow)])
    writer.writerows([_cell(value) for value in astuple(row)] for row in rows)
    return text.getvalue().encode("utf-8", "backslashreplace")


def _cell(value: object) -> object:
    """A cell that no spreadsheet takes for a formula."""
    return f"'{value}" if isinstance(value, str) and value.startswith(_FORMULA) else value
