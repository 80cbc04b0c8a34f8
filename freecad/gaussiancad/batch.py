"""Many sheets without a window: each becomes an FCStd, a STEP and an STL file, with one report.

Started through ``resources/scripts/gaussiancad_batch.py``::

    python3 gaussiancad_batch.py SHEETS... --output DIR

The engine's ``batch`` does the work and tells of each sheet that is done; what FreeCAD can make of
it is made then.  A sheet that fails does not stop the others.  The exit status is 0 if all sheets
were converted, 1 if some failed, 2 for wrong usage, 5 if the disk is full, 6 without a working
engine, 130 if it was interrupted.
"""

import os
from collections import deque
from collections.abc import Sequence
from pathlib import Path

from freecad.gaussiancad.batch_bodies import BodyMaker
from freecad.gaussiancad.batch_documents import complete_sheet, make_documents, remove_documents
from freecad.gaussiancad.batch_options import BatchOptions, parse_options
from freecad.gaussiancad.batch_report import SheetRow, write_report
from freecad.gaussiancad.batch_stop import BatchStopped, StopOnSignals
from freecad.gaussiancad.engine.locate import Engine, SearchPlaces, find_engine
from freecad.gaussiancad.engine.process import EngineRun, RunResult, Watcher
from freecad.gaussiancad.engine.protocol import Event, EventKind, ExitCode
from freecad.gaussiancad.engine.verdict import RunState
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.preferences import read_preferences
from freecad.gaussiancad.staging import sweep

_GRACE_S = 4.5
"""s between the steps of stopping the engine, which takes 4 itself to stop its workers."""

_NO_NAME = (
    "the engine is older than this addon and tells no name for the files: choose GaussianCAD > "
    "Install Engine"
)


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
        return ExitCode.ENGINE
    return _convert_one(engine, options) if options.flat else _convert_all(engine, options)


def _convert_all(engine: Engine, options: BatchOptions) -> int:
    events: deque[Event] = deque()
    run = EngineRun(engine, options.job.arguments(), Watcher(events.append), _GRACE_S)
    stop = StopOnSignals(run)
    bodies = BodyMaker(engine, stop, _GRACE_S) if options.body else None
    rows: list[SheetRow] = []
    is_whole = False
    stop.start()
    # Events wait here, so that documents are made between looks at the process, not within one.
    while run.result is None or events:
        run.advance(at_once=bool(events))
        event = events.popleft() if events else None
        if event is None:
            continue
        if event.kind is EventKind.SHEET:
            if not rows:
                # The engine has the folder for itself by now.
                sweep(options.output)
            row = SheetRow.of(event)
            kept = event.is_set("kept")
            rows.append(row.stopped() if stop.asked else complete_sheet(row, kept, bodies))
            _say(f"{event.text('done')}/{event.text('count')} {row.name}: {rows[-1].outcome}")
        is_whole = is_whole or event.kind is EventKind.RESULT
    code = _exit_code(run.result, rows, stop.asked, is_whole)
    if rows:
        try:
            write_report(rows, options.output)
        except OSError as error:
            _say(f"the report cannot be written to {options.output}: {error.strerror}")
            return max(code, ExitCode.LIMIT)
    return code


def _exit_code(result: RunResult, rows: Sequence[SheetRow], stopped: bool, is_whole: bool) -> int:
    """The exit status of a batch.

    Args:
        result: of the engine.
        rows: of the sheets.
        stopped: whether somebody stopped it.
        is_whole: whether the engine came to its end.
    """
    if stopped or result.state is RunState.CANCELLED:
        return ExitCode.CANCELLED
    if is_whole and result.exit_code in (ExitCode.DONE, ExitCode.SOME_SHEETS_FAILED):
        return ExitCode.SOME_SHEETS_FAILED if any(row.failed for row in rows) else ExitCode.DONE
    _say(result.message)
    stated = result.exit_code in (ExitCode.USAGE, ExitCode.LIMIT)
    return result.exit_code if stated else ExitCode.ENGINE


def _convert_one(engine: Engine, options: BatchOptions) -> int:
    """One sheet, all of its files in one folder."""
    events: list[Event] = []
    job = options.one
    run = EngineRun(engine, job.arguments(), Watcher(events.append), _GRACE_S)
    stop = StopOnSignals(run)
    bodies = BodyMaker(engine, stop, _GRACE_S) if options.body else None
    stop.start()
    result = run.wait()
    state, message = result.state, result.message
    name = next((event.text("name") for event in events if event.kind is EventKind.HELLO), "")
    if state is RunState.DONE and not name:
        state, message = RunState.BROKEN, _NO_NAME
    try:
        if name:
            remove_documents(options.output / name)
        if state is RunState.DONE and not stop.asked:
            message = make_documents(job, options.output / name, bodies=bodies).outcome
    except BatchStopped:
        pass
    except (WorkbenchError, OSError) as error:
        state, message = RunState.FAILED, str(error)
    _say(f"1/1 {name or Path(job.sheet).name}: {message}")
    if stop.asked:
        return ExitCode.CANCELLED
    codes = {
        RunState.DONE: ExitCode.DONE,
        RunState.BROKEN: ExitCode.ENGINE,
        RunState.CANCELLED: ExitCode.CANCELLED,
    }
    return codes.get(state, ExitCode.SOME_SHEETS_FAILED)


def _say(line: str) -> None:
    print(line.encode("utf-8", "backslashreplace").decode(), flush=True)
