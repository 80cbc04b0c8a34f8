"""Many sheets without a window: each becomes an FCStd, a STEP and an STL file, with one report.

Started through ``resources/scripts/gaussiancad_batch.py``::

    python3 gaussiancad_batch.py SHEETS... --output DIR

A sheet that fails does not stop the others.  The exit status is 0 if all sheets were converted,
1 if some failed, 2 for wrong usage, 6 without a working engine, 130 if it was interrupted.
"""

import os
import shutil
import signal
import time
from collections.abc import Sequence
from dataclasses import replace
from enum import IntEnum
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.batch_options import BatchOptions, parse_options
from freecad.gaussiancad.batch_report import SheetRow, write_report
from freecad.gaussiancad.engine.job import ReconstructJob
from freecad.gaussiancad.engine.locate import Engine, SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.objects.exporting import write_step, write_stl
from freecad.gaussiancad.objects.loading import LoadedRun, load_run
from freecad.gaussiancad.objects.reconstruction import add_reconstruction
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.sheet_names import folder_names
from freecad.gaussiancad.staging import staging

_SUFFIXES = (".FCStd", ".step", ".stl")

_LINK = (
    "output-is-link",
    "the sheet's folder is a link to elsewhere: remove it, or choose another --output",
)


class ExitCode(IntEnum):
    """Exit status of a batch."""

    DONE = 0
    SOME_FAILED = 1
    USAGE = 2
    NO_ENGINE = 6
    CANCELLED = 130


def main(arguments: Sequence[str]) -> int:
    """Convert sheets.

    Args:
        arguments: sheets, folders of sheets and options; see ``--help``.

    Returns:
        The exit status.
    """
    try:
        options = parse_options(arguments)
    except SystemExit as end:
        return int(end.code or 0)
    try:
        preference = read_preferences().engine_python
        engine = find_engine(SearchPlaces.of_this_machine(preference, os.environ))
    except WorkbenchError as error:
        _say(error.message)
        return ExitCode.NO_ENGINE
    _interrupt_on_signals()
    return _convert_all(engine, options)


def _convert_all(engine: Engine, options: BatchOptions) -> int:
    rows: list[SheetRow] = []
    code = ExitCode.DONE
    names = folder_names(options.sheets)
    for number, (sheet, name) in enumerate(zip(options.sheets, names, strict=True), 1):
        folder = options.output if options.flat else options.output / name
        job = replace(options.job, sheet=str(sheet), output=str(folder))
        if folder.is_symlink() and not options.flat:
            row = SheetRow(name, job.sheet, job.output, "failed", "", 2, *_LINK, 0.0)
            state = RunState.FAILED
        else:
            row, state = convert_sheet(engine, job, options.output / name)
        rows.append(row)
        _say(f"{number}/{len(names)} {name}: {row.message or row.status}")
        if state is RunState.BROKEN:
            code = ExitCode.NO_ENGINE
            break
        if state is RunState.CANCELLED:
            code = ExitCode.CANCELLED
            break
        if state is not RunState.DONE:
            code = ExitCode.SOME_FAILED
    if not options.flat:
        write_report(rows, options.output)
    return code


def convert_sheet(engine: Engine, job: ReconstructJob, target: Path) -> tuple[SheetRow, RunState]:
    """Convert one sheet.

    Args:
        engine: what does the work.
        job: the sheet and what is asked.
        target: path of the results without suffix: ``.FCStd``, ``.step`` and ``.stl`` are written.

    Returns:
        What became of it; whatever went wrong is in there.
    """
    started = time.monotonic()
    for suffix in _SUFFIXES:
        _with_suffix(target, suffix).unlink(missing_ok=True)
    run = EngineRun(engine, job.arguments())
    run.start()
    result = run.wait()
    state, message = result.state, result.message
    status, measures = "failed", ""
    if state is RunState.DONE:
        try:
            status, measures = _store(job, target)
            message = ""
        except WorkbenchError as error:
            state, message = RunState.FAILED, error.message
        except Exception as error:  # FreeCAD raises its own types; the next sheet goes on
            state, message = RunState.FAILED, f"the result of {job.sheet} is unusable: {error}"
    row = SheetRow(
        name=target.name,
        sheet=job.sheet,
        folder=job.output,
        status=status,
        measures_mm=measures,
        exit_code=result.exit_code,
        code=result.code,
        message=message,
        seconds=round(time.monotonic() - started, 2),
    )
    return row, state


def _store(job: ReconstructJob, target: Path) -> tuple[str, str]:
    """Write the document and the exchange files.

    Returns:
        The status, and the bound of the measures in mm; empty where it is not known.
    """
    with staging(target.parent) as scratch:
        run = load_run(job, scratch)
        staged = scratch / target.name
        document = FreeCAD.newDocument(hidden=True)
        try:
            add_reconstruction(document, run)
            document.saveAs(str(_with_suffix(staged, ".FCStd")))
        finally:
            FreeCAD.closeDocument(document.Name)
        _export(run, Path(job.output), staged)
        for suffix in _SUFFIXES:
            _with_suffix(staged, suffix).replace(_with_suffix(target, suffix))
    bound = run.report.group("measures").get("uncertainty_mm")
    return run.report.status.value, f"{bound:g}" if isinstance(bound, int | float) else ""


def _export(run: LoadedRun, output: Path, target: Path) -> None:
    step, stl = _with_suffix(target, ".step"), _with_suffix(target, ".stl")
    if run.part is not None:
        shutil.copyfile(output / run.part.source.value, step)
    else:
        write_step(run.mesh, step)
    if (output / "surface.stl").is_file():
        shutil.copyfile(output / "surface.stl", stl)
    else:
        write_stl(run.part.shape, stl)


def _with_suffix(target: Path, suffix: str) -> Path:
    """The suffix is added: names of sheets may hold dots of their own."""
    return target.with_name(target.name + suffix)


def _interrupt_on_signals() -> None:
    """FreeCAD leaves SIGINT alone; let it and SIGTERM stop the run in progress."""

    def interrupt(*_arguments: object) -> None:
        raise KeyboardInterrupt

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, interrupt)


def _say(line: str) -> None:
    print(line, flush=True)
