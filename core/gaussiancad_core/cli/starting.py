"""How the ``gaussiancad`` command starts: what uses the geometry kernel runs in a child that may
die.

Where it dies while it looks for the solid, or is ended there as it takes too long, the run begins
again without the way in which it did; what is left where no way remains is told.
"""

import os
import sys
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from gaussiancad_core.cli import main
from gaussiancad_core.cli.parser import build_parser
from gaussiancad_core.cli.reconstruct import SOLID_WAY
from gaussiancad_core.cli.streams import drop, keep_streams, say
from gaussiancad_core.errors import (
    CancelledError,
    EngineError,
    GaussianCadError,
    LimitError,
    UnreadableError,
)
from gaussiancad_core.messages import event_fields, on_one_line
from gaussiancad_core.processes.events import Listener, Silence, open_event_stream
from gaussiancad_core.processes.watched import Watched, watch
from gaussiancad_core.report.job import Job
from gaussiancad_core.storage.extras import result_kind
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import ResultKind, SolidWay

_OF_THE_KERNEL = frozenset({"reconstruct", "check", "compare", "draw", "features"})
"""Commands that use it."""

_BREAKDOWNS = frozenset({"SIGSEGV", "SIGABRT", "SIGBUS", "SIGFPE", "SIGILL"})
"""Signals by which a library ends its process."""

_TOO_LONG = "SIGXCPU"
"""The signal by which the system ends a process that took its seconds of the processor."""


def start() -> int:
    """Run the command line of this process and return its exit code."""
    keep_streams()
    try:
        return _started(sys.argv[1:])
    finally:
        # Python flushes it at its end, and takes a failure for one of the command.
        with suppress(ValueError):
            try:
                sys.stderr.flush()
            except OSError:
                drop(sys.stderr)


def _started(arguments: list[str]) -> int:
    if os.name != "posix" or not arguments or arguments[0] not in _OF_THE_KERNEL:
        return main(arguments)
    if {"-h", "--help"} & set(arguments):
        return main(arguments)
    try:
        ended = watch(arguments)
        while (further := _without_way(ended, arguments)) is not None:
            arguments = further
            ended = watch(arguments)
    except OSError:
        return main(arguments)
    return _report_death(ended, arguments) if ended.exit_code < 0 else ended.exit_code


def _without_way(ended: Watched, arguments: list[str]) -> list[str] | None:
    """The arguments of the same run without the way of looking for the solid in which a library
    ended it, or in which none came to an end; None where it ended otherwise, or no way is left."""
    if ended.signal not in {*_BREAKDOWNS, _TOO_LONG} or ended.stage != "solid":
        return None
    options = build_parser().parse_args(arguments)
    if arguments[0] != "reconstruct" or options.page == "all":
        return None
    way, result = options.solid_way.less, result_kind(options.result)
    if result is ResultKind.SURFACE:
        way = SolidWay.NONE
    nothing_else = way is SolidWay.NONE and result is ResultKind.SOLID
    if options.solid_way is SolidWay.NONE or nothing_else:
        return None
    return [*arguments, SOLID_WAY, way.value]


def _report_death(ended: Watched, arguments: list[str]) -> int:
    """Tell that a signal ended the engine, and leave a report where a run was to."""
    options = build_parser().parse_args(arguments)
    listener: Listener = open_event_stream() if options.events else Silence()
    error = _failure(ended, options.solid if arguments[0] == "draw" else None)
    if arguments[0] == "reconstruct":
        from gaussiancad_core.cli.reconstruct import job_of

        if options.page != "all":
            _report(job_of(options, options.sheet, options.output), error, ended.stage)
    line = on_one_line(error.message)
    say(f"gaussiancad: {line} [{error.code}]")
    listener.send("error", **event_fields(error.code, line), exit_code=int(error.exit_code))
    return int(error.exit_code)


def _failure(ended: Watched, solid: Path | None = None) -> GaussianCadError:
    """The error that a signal stands for.

    Args:
        ended: how the command ended.
        solid: the file of a solid that anybody may have made, where the command is of one.
    """
    stage = ended.stage or "start"
    if solid is not None and ended.signal in _BREAKDOWNS:
        return UnreadableError(
            Code.DAMAGED_MODEL,
            "{path} cannot be drawn (its process was ended by {signal}): it is damaged; export it "
            "again",
            case="draw",
            path=solid,
            signal=ended.signal,
        )
    if ended.signal in ("SIGTERM", "SIGINT", "SIGHUP"):
        # It came before the child could tell how far it was.
        return CancelledError(Code.CANCELLED, "cancelled by {signal}", signal=ended.signal)
    if ended.signal == "SIGKILL":
        return LimitError(
            Code.KILLED,
            "the system ended the engine in the stage {stage}, as it does where the memory does "
            "not suffice: use --preset draft or a smaller sheet",
            stage=stage,
        )
    if ended.signal == _TOO_LONG:
        return LimitError(
            Code.TAKES_TOO_LONG,
            "the stage {stage} took more seconds of the processor than any sheet needs, and was "
            "ended: save only the views of one part, or report it with the sheet",
            stage=stage,
        )
    return EngineError(
        Code.ENGINE_DIED,
        "a library ended the engine in the stage {stage} ({signal}): this is a fault of ours, "
        "please report it with the sheet; what was finished before lies in the output folder",
        stage=stage,
        signal=ended.signal,
    )


def _report(job: Job, error: GaussianCadError, stage: str) -> None:
    """The report of a run whose process died; what it had put in place stays."""
    from gaussiancad_core.report.run_report import Report
    from gaussiancad_core.storage.outputs import REPORT_FILE, RUN_FILES, OutputFolder
    from gaussiancad_protocol.modes import Status

    if not Path(job.output).is_dir():
        return
    try:
        folder = OutputFolder(job.output, RUN_FILES, REPORT_FILE)
    except GaussianCadError:
        return
    try:
        folder.adopt_published()
        report = Report("", job.settings(), status=Status.FAILED, stage=stage)
        report = report.doubted(error.code, error.message)
        report = replace(report, files=folder.facts())
        report.write(folder.staging / REPORT_FILE)
        folder.commit()
    finally:
        folder.discard(keep_checkpoint=job.resume)
