"""The ``gaussiancad`` command.

Each subcommand has a module of its own that adds its parser and runs it; heavy libraries are only
imported once a command runs.
"""

import errno
import select
import sys
from collections.abc import Sequence
from pathlib import Path

from gaussiancad_core.cli.parser import build_parser
from gaussiancad_core.cli.streams import drop, say
from gaussiancad_core.cli.terminal import terminal
from gaussiancad_core.errors import (
    CancelledError,
    EngineError,
    GaussianCadError,
    LimitError,
    UsageError,
    is_out_of_memory,
    out_of_files,
)
from gaussiancad_core.messages import event_fields, on_one_line
from gaussiancad_core.processes.events import (
    Both,
    Cancellation,
    Listener,
    Silence,
    cancel_on_stdin,
    open_event_stream,
)
from gaussiancad_core.processes.library_behaviour import prepare_environment
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.exit_codes import ExitCode

_REFUSED = {
    errno.ENAMETOOLONG,
    errno.EACCES,
    errno.EPERM,
    errno.EROFS,
    errno.ENOTDIR,
    errno.EISDIR,
    errno.ELOOP,
}
"""What the system says of a file or folder that a person named as it cannot be."""


def main(arguments: Sequence[str] | None = None, heard: Listener | None = None) -> int:
    """Run the command line and return its exit code.

    Args:
        arguments: of the command; those of the process where none are given.
        heard: told what whoever reads the events is told.
    """
    options = build_parser().parse_args(arguments)
    options.arguments = list(sys.argv[1:] if arguments is None else arguments)
    prepare_environment()
    listener: Listener = Silence()
    cancellation = Cancellation()
    try:
        cancellation.begin()
        if options.events:
            listener = open_event_stream()
            if not options.serves:
                cancel_on_stdin(cancellation)
        elif (shown := terminal(verbose=options.verbose)) is not None:
            listener = shown
        if heard is not None:
            # What is told of a process that dies is never behind what it said itself.
            listener = Both(heard, listener)
        code = int(options.run(options, listener))
        # What is still to be printed may find no reader, or no room.
        sys.stdout.flush()
    except (Exception, KeyboardInterrupt) as error:
        if isinstance(error, BrokenPipeError) and not _is_read():
            # Who reads has read enough, as `head` does.
            drop(sys.stdout)
            return int(ExitCode.DONE)
        found = _meaning(error, cancellation, options.arguments)
        line = on_one_line(found.message)
        # A line of progress ends first.
        listener.send("error", **event_fields(found.code, line), exit_code=int(found.exit_code))
        say(f"gaussiancad: {line} [{found.code}]")
        return int(found.exit_code)
    finally:
        cancellation.end()
    return code


def _meaning(
    error: BaseException, cancellation: Cancellation, arguments: Sequence[str]
) -> GaussianCadError:
    """What a person is told of an error that ended a command."""
    # Whatever was made of the system's refusal says less.
    known = out_of_files(error) or (error if isinstance(error, GaussianCadError) else None)
    if known is None and isinstance(error, SystemError | ImportError):
        # A compiled function or a module that is interrupted says only that it failed.
        known = cancellation.raised
    if known is not None:
        return known
    if isinstance(error, KeyboardInterrupt):
        return CancelledError(Code.CANCELLED, "stopped by SIGINT")
    if is_out_of_memory(error):
        return LimitError(
            Code.OUT_OF_MEMORY, "the memory does not suffice: use --preset draft or a smaller file"
        )
    if isinstance(error, ImportError):
        return EngineError(
            Code.ENGINE_INCOMPLETE,
            "the engine is incomplete ({reason}): run `gaussiancad doctor`",
            reason=error,
        )
    if isinstance(error, OSError) and (known := _of_system(error)) is not None:
        return known
    from gaussiancad_core.storage.crash_reports import unforeseen

    return unforeseen(error, [Path(argument) for argument in arguments if _is_file(argument)])


def _of_system(error: OSError) -> GaussianCadError | None:
    """What is told where the system refused a file; nothing where it named none."""
    if error.errno in (errno.ENOSPC, errno.EDQUOT):
        drop(sys.stdout)
        return LimitError(
            Code.DISK_FULL, "no space is left where the output is written: free some, then retry"
        )
    if error.filename is None or error.errno not in _REFUSED:
        return None
    return UsageError(
        Code.PATH_NOT_USABLE,
        "{path} cannot be used ({reason}): choose another name or folder",
        path=error.filename,
        reason=error.strerror,
    )


def _is_read() -> bool:
    """Whether what is printed has a reader, as far as the system tells."""
    if not hasattr(select, "poll"):
        return False
    output = select.poll()
    try:
        output.register(sys.stdout.fileno(), 0)
    except ValueError:
        # It is no file of the system.
        return True
    return not any(what & select.POLLERR for _, what in output.poll(0))


def _is_file(name: str) -> bool:
    try:
        return Path(name).is_file()
    except (OSError, ValueError):
        return False
